#!/usr/bin/env python3
# bead-time.py SAMPLES: seconds with the bead on, of samples a millisecond apart: five joints and the output of the valve.
import sys

rows = [line.split() for line in open(sys.argv[1])]
print(sum(len(row) == 6 and float(row[5]) > 0.5 for row in rows) / 1000)
