"""Memory that each stage states in its help, in numbers: what bench --scale compares peaks with.

A peak is at most the program itself (BASE) and what its line `memory:` in --help says of the streams it reads and writes.
check_texts() shows that these lines still say what is computed here.
"""
import os
import re
import subprocess
from statistics import median_high

from programs import BIN

BASE = 20e6  # bytes: the program, its libraries, buffers of streams
FIRST_PAYLOAD = 8  # fields of a frame from this one on are payload: layer, region, paths, span


def frames(path):
    """The sizes of the payload frames of a stream, in bytes."""
    out = []
    with open(path, "rb") as f:
        f.seek(15)  # the preamble
        while head := f.read(1):
            size, shift = head[0] & 127, 7
            while head[0] & 128:
                head = f.read(1)
                size |= (head[0] & 127) << shift
                shift += 7
            if f.read(1)[0] >> 3 >= FIRST_PAYLOAD:
                out.append(size)
            f.seek(size - 1, 1)
    return out


def most_of(sizes, count):
    """The largest sum of `count` sizes that follow each other."""
    now = best = sum(sizes[:count])
    for k in range(count, len(sizes)):
        now += sizes[k] - sizes[k - count]
        best = max(best, now)
    return best


def filled(skins):
    """What 'fill' wrote for the regions of that file."""
    return os.path.splitext(skins)[0] + ".paths"


def triangles(stl):
    return (os.path.getsize(stl) - 84) // 50


# stage: what its help must say, and the bytes that this allows for files read and written
STATED = {
    "slice": (r"the model at 400 bytes per triangle, 32 layers per thread at twice",
              lambda read, wrote: 400 * triangles(read) + 2 * most_of(frames(wrote), 32 * os.cpu_count())),
    "regions": (r"33 layers at 9 times", lambda read, wrote: 9 * most_of(frames(read), 33)),
    "skins": (r"the whole part at 8 times.*the infill of one layer at 30 times",
              lambda read, wrote: 8 * sum(frames(read)) + 30 * os.cpu_count() * median_high(frames(filled(wrote)) or [0])),
    "sequence": (r"the whole graph at 8 times", lambda read, wrote: 8 * sum(frames(read))),
    "fill": (r"one region per thread at 40 times the bytes that it writes.*64 MB",
             lambda read, wrote: 64e6 + 40 * os.cpu_count() * max(frames(wrote), default=0)),
    "link3d": (r"the regions it looks ahead at 11 times", lambda read, wrote: 11 * most_of(frames(read), 17)),
    # a move that is no arc takes 4 bytes, and at least 12 in the stream
    "postproc": (r"half a million moves \(100 MB\), further ones at 4 to 28 bytes, some spans at 32 times.*48 MiB",
                 lambda read, wrote: 100e6 + 48 * 2**20 + sum(frames(read)) / 3 + 32 * max(frames(read), default=0)),
    "metrics": (r"the toolpath at 10 times", lambda read, wrote: 10 * sum(frames(read))),
}


def allowed(stage, read, wrote):
    """MB that a stage may take at most."""
    return (BASE + STATED[stage][1](read, wrote)) / 2**20


def check_texts():
    """Returns a sentence for each stage whose help does not say what STATED computes."""
    out = []
    for stage, (text, _) in STATED.items():
        told = subprocess.run([os.path.join(BIN, stage), "--help"], check=True, capture_output=True, text=True).stdout
        line = re.search(r"(?m)^memory: (.*(?:\n.+)*)", told)
        if line is None or re.search(text, line[1].replace("\n", " ")) is None:
            out.append(f"the help of '{stage}' does not say '{text}'")
    return out
