"""bench --scale: hollow parts at 1, 2, 4, 8 times their size: CPU time of every stage, and its exponent in what is laid.

Two walls, four skins, 15 %.  An exponent is log2 of the ratio of CPU times by log2 of the ratio of what is laid (bytes
of the toolpath) between one size and the next: 1 is a cost that grows with what is laid.
"""
import math
import os
import re
import shutil
import struct
import subprocess

from programs import BIN, PEERS, measure

HOLLOW = ["--perimeters", "2", "--fill-density", "15%", "--top-solid-layers", "4", "--bottom-solid-layers", "4"]
LEAST = 0.05  # CPU s; exponents of less are noise


def write_stl(path, triangles):
    # the normals are not used, but PrusaSlicer takes a file for text that has no byte above 127 at its begin
    with open(path, "wb") as f:
        f.write(bytes(80) + struct.pack("<I", len(triangles)))
        for corners in triangles:
            f.write(struct.pack("<12fH", 0, 0, -1, *corners, 0))


def scaled(source, factor, path):
    with open(source, "rb") as f:
        data = f.read()
    count = struct.unpack_from("<I", data, 80)[0]
    write_stl(path, [[factor * c for c in struct.unpack_from("<9f", data, 84 + 50 * k + 12)] for k in range(count)])


def box(side, height, path):
    corner = [(x, y, z) for z in (0, height) for y in (0, side) for x in (0, side)]
    faces = ((0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
             (1, 3, 7), (1, 7, 5))
    write_stl(path, [[c for k in face for c in corner[k]] for face in faces])


def prusa(part, pattern, target):
    middle = "500,500"
    return ["prusa-slicer", "--load", os.path.join(PEERS, "prusa.ini"), *HOLLOW, "--fill-pattern", pattern, "--center",
            middle, "--bed-shape", "0x0,1000x0,1000x1000,0x1000", "--export-gcode", "-o", target, part]


def large_machine(out):
    """A profile like marlin's, with a bed of a metre: the largest parts are wider than an ordinary printer."""
    path = os.path.join(out, "large.toml")
    if os.path.exists(path):
        os.remove(path)
    subprocess.run([os.path.join(BIN, "filum"), "machines", "--new", path, "--from", "marlin"], check=True,
                   capture_output=True)
    with open(path, encoding="utf-8") as f:
        text = f.read()
    with open(path, "w", encoding="utf-8") as f:
        f.write(re.sub(r"(?m)^([xyz]) = \[0, \d+\]", r"\1 = [0, 1000]", text, count=3))
    return path


def chain(part, pattern, work, machine):
    def at(kind):
        return os.path.join(work, "part." + kind)

    return [["slice", part, "-o", at("layers")], ["regions", at("layers"), "-o", at("regions")],
            ["skins", "--infill", "15%", "--infill-pattern", pattern, at("regions"), "-o", at("skins")],
            ["sequence", at("skins"), "-o", at("sequence")], ["fill", at("sequence"), "-o", at("paths")],
            ["link3d", at("paths"), "-o", at("toolpath")],
            ["postproc", "--machine", machine, at("toolpath"), "-o", at("gcode")],
            ["metrics", "--regions", at("sequence"), at("toolpath"), "-o", at("metrics")]]


def family(name, sizes, make, pattern, peer_pattern, out, repeat, peers, table):
    """One part at all sizes: a table of stages by sizes."""
    machine = large_machine(out)
    rows, laid, programs = {}, [], []
    for size in sizes:
        work = os.path.join(out, f"{name}-{size}")
        os.makedirs(work, exist_ok=True)
        part, log = os.path.join(work, "part.stl"), os.path.join(work, "log.txt")
        make(size, part)
        total = 0.0
        for command in chain(part, pattern, work, machine):
            cpu, _, peak = measure([os.path.join(BIN, command[0]), "--quiet", *command[1:]], repeat, log)
            rows.setdefault(command[0], []).append((cpu, peak))
            total += cpu if command[0] != "metrics" else 0
        rows.setdefault("the print", []).append((total, max(rows[c[0]][-1][1] for c in chain(part, pattern, work, machine))))
        laid.append(os.path.getsize(os.path.join(work, "part.toolpath")))
        written = [os.path.getsize(os.path.join(work, "part.gcode"))]
        if peers and shutil.which("prusa-slicer"):
            target = os.path.join(work, "prusa.gcode")
            cpu, _, peak = measure(prusa(part, peer_pattern, target), repeat, log)
            rows.setdefault("PrusaSlicer", []).append((cpu, peak))
            written.append(os.path.getsize(target))
        programs.append(written)
    print(f"\n{name}, {pattern}: CPU s, (exponent in what is laid), peak MB")
    print(f"{'':14}" + "".join(f"{size:>22}" for size in sizes))
    for label, figures in rows.items():
        cells = []
        for k, (cpu, peak) in enumerate(figures):
            grown = k > 0 and figures[k - 1][0] >= LEAST and laid[k] > laid[k - 1]
            exponent = math.log(cpu / figures[k - 1][0]) / math.log(laid[k] / laid[k - 1]) if grown else None
            cells.append(f"{cpu:10.2f}" + (f" ({exponent:4.2f})" if grown else " " * 7) + f"{peak:5.0f}")
            table.append((f"{name}-{sizes[k]}", label, f"{cpu:.3f}", "" if exponent is None else f"{exponent:.2f}",
                          f"{peak:.1f}"))
        print(f"{label:14}" + "".join(f"{cell:>22}" for cell in cells))
    print(f"{'toolpath MB':14}" + "".join(f"{n / 1e6:22.2f}" for n in laid))
    print(f"{'program MB':14}" + "".join(f"{' | '.join(f'{n / 1e6:.2f}' for n in w):>22}" for w in programs) +
          ("   (Filum | PrusaSlicer)" if len(programs[0]) > 1 else ""), flush=True)


def run(benchy, most, repeat, out, peers, table):
    sizes = [s for s in (1, 2, 4, 8) if s <= most]
    family("benchy", sizes, lambda size, path: scaled(benchy, size, path), "rows", "rectilinear", out, repeat, peers,
           table)
    for pattern, peer in (("rows", "rectilinear"), ("wave", "gyroid")):
        family(f"box-{pattern}", [100 * s for s in sizes], lambda side, path: box(side, 10, path), pattern, peer, out,
               repeat, peers, table)
