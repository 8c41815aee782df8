"""What bench and compare share: how commands are measured, and the other slicers with the same layer, bead and retraction.

  cura-continuous   CuraEngine's most continuous setting: concentric, no walls, no gap fill, polygons connected
  prusa-concentric  PrusaSlicer, one wall and a full concentric fill
  prusa-zigzag      PrusaSlicer, one wall and a full rectilinear fill
"""
import os
import shutil
import statistics
import subprocess
import sys
import time

PEERS = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(PEERS))
BIN = os.path.join(TOP, "build", "bin")


class Failed(Exception):
    """A command that did not work; its text says which and why."""


def once(command, log, env):
    """CPU s, wall s, peak MB of one run; the peak is that of the largest process in it."""
    # Linux hands a parent's peak on to what it starts; GNU time between keeps Python's 15 MB out of the figure.
    peak, begin = log + ".peak", time.monotonic()
    with open(log, "ab") as f:
        process = subprocess.Popen(["/usr/bin/time", "-q", "-f", "%M", "-o", peak, *command], stdin=subprocess.DEVNULL,
                                   stdout=f, stderr=f, env=env)
        _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    wall = time.monotonic() - begin
    if process.returncode != 0:
        raise Failed(f"'{' '.join(command)[:200]}' ended with exit {process.returncode}; see {os.path.relpath(log)}")
    with open(peak, encoding="ascii") as f:
        return usage.ru_utime + usage.ru_stime, wall, int(f.read()) / 1024


def measure(command, repeat, log, env=None):
    runs = [once(command, log, env) for _ in range(repeat)]
    return tuple(statistics.median(column) for column in zip(*runs))


def cura_resources(out):
    """The folder with CuraEngine's definitions, unpacked if need be; None without."""
    unpacked = os.path.join(out, "cura")
    for folder in (os.environ.get("FILUM_CURA_RESOURCES", ""), "/usr/share/cura/resources",
                   os.path.join(unpacked, "usr/share/cura/resources")):
        if folder and os.path.exists(os.path.join(folder, "definitions", "fdmprinter.def.json")):
            return folder
    if shutil.which("apt-get") is None:
        return None
    os.makedirs(unpacked, exist_ok=True)
    print("fetching CuraEngine's definitions (apt-get download cura)", file=sys.stderr)
    if subprocess.run(["apt-get", "download", "cura"], cwd=unpacked, capture_output=True, check=False).returncode != 0:
        return None
    packages = [p for p in os.listdir(unpacked) if p.startswith("cura_") and p.endswith(".deb")]
    for package in packages:
        subprocess.run(["dpkg-deb", "-x", package, "."], cwd=unpacked, check=False)
    return os.path.join(unpacked, "usr/share/cura/resources") if packages else None


def cura_command(part, target, resources, settings):
    """(command, environment) of CuraEngine with the settings of a file in scripts/peers."""
    with open(os.path.join(PEERS, settings), encoding="utf-8") as f:
        given = f.read().splitlines()
    lines = subprocess.run([os.path.join(PEERS, "cura-settings"), resources, *given], check=True, text=True,
                           capture_output=True).stdout.splitlines()
    words = [word for line in lines for word in ("-s", line)]
    search = ":".join(os.path.join(resources, n) for n in ("definitions", "extruders"))
    return (["CuraEngine", "slice", "-m2", "-j", os.path.join(resources, "definitions/fdmprinter.def.json"), *words,
             "-e0", *words, "-l", part, "-o", target], {**os.environ, "CURA_ENGINE_SEARCH_PATH": search})


def peer_commands(part, work, out):
    """Pairs of name and (command, environment, program written) for the slicers that are installed."""
    found = []
    resources = cura_resources(out) if shutil.which("CuraEngine") else None
    if resources:
        target = os.path.join(work, "cura-continuous.gcode")
        found.append(("cura-continuous", (*cura_command(part, target, resources, "cura-continuous.txt"), target)))
    if shutil.which("prusa-slicer"):
        for name, pattern in (("prusa-concentric", "concentric"), ("prusa-zigzag", "rectilinear")):
            target = os.path.join(work, name + ".gcode")
            found.append((name, (["prusa-slicer", "--load", os.path.join(PEERS, "prusa.ini"), "--fill-pattern", pattern,
                                  "--export-gcode", "--center", "125,125", "-o", target, part], None, target)))
    return found


def strokes(program):
    """Strokes, stops, extruded m, volume cm3 of a G-code file."""
    out = subprocess.run([os.path.join(TOP, "scripts", "gcode-strokes"), program], check=True, text=True,
                         capture_output=True).stdout.splitlines()
    row = dict(zip(out[0].split("\t"), out[1].split("\t")))
    return row["strokes"], row["stops"], row["extruded_m"], row["volume_cm3"]
