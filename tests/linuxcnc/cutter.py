#!/usr/bin/env python3
"""cutter.py PROGRAM SAMPLES - where the simulated machine stood while the cutter was on

For programs of joints: compares the samples whose sixth number is 1 with the axes that the line before the cut names.
Prints how far the axes stood from there when the cutter came on, and how far they went until it was off: mm or degrees.
"""
import re
import sys

words = {}
for line in open(sys.argv[1]):
    if line.startswith("M64 P0"):
        break
    if re.match("G[01] ", line):
        words.update({k: float(v) for k, v in re.findall(r"([XYZAC])(-?[\d.]+)", line)})
else:
    sys.exit("cutter.py: the program does not cut")
rows = [[float(v) for v in line.split()[:6]] for line in open(sys.argv[2]) if len(line.split()) >= 6]
on = [row[:5] for row in rows if row[5] == 1]
if not on:
    sys.exit("cutter.py: the cutter was never on")
off = max(abs(a - words[letter]) for a, letter in zip(on[0], "XYZAC"))
went = max(abs(a - b) for row in on for a, b in zip(row, on[0]))
print(f"{off:.5f} {went:.5f}")
