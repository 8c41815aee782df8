"""bench --scale: hollow parts that grow: CPU time of every stage, its exponent in what is written, its peak memory.

Two walls, four skins, 15 %.  An exponent is log2 of the ratio of CPU times by log2 of the ratio of what is written
(bytes of the toolpath) between one size and the next: 1 is a cost that grows with what is written.  A peak above what the
help of a stage states (memory.py) is an error.
"""
import math
import os
import re
import shutil
import subprocess

import memory
import shapes
from programs import BIN, PEERS, Failed, cura_command, cura_resources, measure

HOLLOW = ["--perimeters", "2", "--fill-density", "15%", "--top-solid-layers", "4", "--bottom-solid-layers", "4"]
LEAST = 0.05  # CPU s; exponents of less are noise
PEER_PATTERN = {"rows": "rectilinear", "wave": "gyroid"}
FAMILIES = ("benchy", "box-rows", "box-wave", "plates", "islands", "layers", "twisted", "vertices")


def prusa(part, pattern, target):
    middle = "500,500"
    return ["prusa-slicer", "--load", os.path.join(PEERS, "prusa.ini"), *HOLLOW, "--fill-pattern", pattern, "--center",
            middle, "--bed-shape", "0x0,1000x0,1000x1000,0x1000", "--max-print-height", "1100", "--export-gcode", "-o",
            target, part]


def large_machine(out):
    """A profile like marlin's, with a metre along each axis: the largest parts are wider than an ordinary printer."""
    path = os.path.join(out, "large.toml")
    if os.path.exists(path):
        os.remove(path)
    subprocess.run([os.path.join(BIN, "filum"), "machines", "--new", path, "--from", "marlin"], check=True,
                   capture_output=True)
    with open(path, encoding="utf-8") as f:
        text = f.read()
    with open(path, "w", encoding="utf-8") as f:
        f.write(re.sub(r"(?m)^([xyz]) = \[0, \d+\]", r"\1 = [0, 1100]", text, count=3))
    return path


def chain(part, pattern, work, machine, more=()):
    """The commands of all stages; each reads the first file that it names, and writes the last."""
    def at(kind):
        return os.path.join(work, "part." + kind)

    return [["slice", "--machine", machine, *more, part, "-o", at("layers")], ["regions", at("layers"), "-o", at("regions")],
            ["skins", "--infill", "15%", "--infill-pattern", pattern, at("regions"), "-o", at("skins")],
            ["sequence", at("skins"), "-o", at("sequence")], ["fill", at("sequence"), "-o", at("paths")],
            ["link3d", at("paths"), "-o", at("toolpath")],
            ["postproc", "--machine", machine, at("toolpath"), "-o", at("gcode")],
            ["metrics", "--regions", at("sequence"), at("toolpath"), "-o", at("metrics")]]


def family(name, given, sizes, make, pattern="rows", more=None, peer_make=None):
    """One part at all sizes: a table of stages by sizes.  `more`: options of slice by size.  `peer_make`: makes the part
    for other slicers.  `given` holds what bench was asked for.  Returns a sentence for each peak that is too high."""
    machine = large_machine(given.out)
    resources = cura_resources(given.out) if given.peers and shutil.which("CuraEngine") else None
    rows, laid, programs, high = {}, [], [], []
    for size in sizes:
        work = os.path.join(given.out, f"{name}-{size}")
        os.makedirs(work, exist_ok=True)
        part, log = os.path.join(work, "part.stl"), os.path.join(work, "log.txt")
        make(size, part)
        total, peaks, taken = 0.0, [], []
        for command in chain(part, pattern, work, machine, more(size) if more else ()):
            cpu, _, peak = measure([os.path.join(BIN, command[0]), "--quiet", *command[1:]], given.repeat, log)
            rows.setdefault(command[0], []).append((cpu, peak))
            peaks.append(peak)
            total += cpu if command[0] != "metrics" else 0
            taken.append((command[0], command[-3], command[-1], peak))
        for stage, read, wrote, peak in taken:  # when all files are there
            most = memory.allowed(stage, read, wrote)
            if peak > most:
                high.append(f"{stage} took {peak:.0f} MB on {name} {size}, its help states {most:.0f}")
        rows.setdefault("the print", []).append((total, max(peaks)))
        laid.append(os.path.getsize(os.path.join(work, "part.toolpath")))
        written = [os.path.getsize(os.path.join(work, "part.gcode"))]
        other = part
        if given.peers and peer_make:
            other = os.path.join(work, "peer.stl")
            peer_make(size, other)
        if given.peers and shutil.which("prusa-slicer"):
            target = os.path.join(work, "prusa.gcode")
            cpu, _, peak = measure(prusa(other, PEER_PATTERN[pattern], target), given.repeat, log)
            rows.setdefault("PrusaSlicer", []).append((cpu, peak))
            written.append(os.path.getsize(target))
        if resources and pattern == "rows":
            target = os.path.join(work, "cura.gcode")
            command, environment = cura_command(other, target, resources, "cura-hollow.txt")
            cpu, _, peak = measure(command, given.repeat, log, environment)
            rows.setdefault("CuraEngine", []).append((cpu, peak))
            written.append(os.path.getsize(target))
        programs.append(written)
        for kind in ("layers", "regions", "skins", "paths", "toolpath"):  # gigabytes otherwise
            os.remove(os.path.join(work, "part." + kind))
    show(name, pattern, sizes, rows, laid, programs, given.table)
    return high


def show(name, pattern, sizes, rows, laid, programs, table):
    print(f"\n{name}, {pattern}: CPU s, (exponent in what is written), peak MB")
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
          ("   (Filum | others as above)" if len(programs[0]) > 1 else ""), flush=True)


def run(benchy, given):
    """Measures the families that `given` names.  Raises Failed if a stage took more memory than its help states."""
    factors = [s for s in (1, 2, 4, 8) if s <= given.most]
    high = memory.check_texts()
    cylinder = lambda size, path: shapes.cylinders(1, path)  # noqa: E731
    by_name = {
        "benchy": lambda n: family(n, given, factors, lambda s, path: shapes.scaled(benchy, s, path)),
        "box-rows": lambda n: family(n, given, [100 * s for s in factors], lambda s, path: shapes.box(s, 10, path)),
        "box-wave": lambda n: family(n, given, [100 * s for s in factors], lambda s, path: shapes.box(s, 10, path), "wave"),
        "plates": lambda n: family(n, given, [1, *(25 * s for s in factors)], cylinder,
                                   more=lambda s: ("--copies", str(s)), peer_make=shapes.cylinders),
        "islands": lambda n: family(n, given, [1250 * s for s in factors], shapes.pillars),
        "layers": lambda n: family(n, given, [625 * s for s in factors], shapes.tower),
        "twisted": lambda n: family(n, given, [625 * s for s in factors], shapes.twisted),
        "vertices": lambda n: family(n, given, [12500 * s for s in factors], shapes.gear),
    }
    for name in given.families or FAMILIES:
        high += by_name[name](name)
    if high:
        raise Failed("memory: " + "; ".join(high))
    print("\nno stage took more memory than its help states")
