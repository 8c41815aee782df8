#!/usr/bin/python3
"""compare.py A B: the most that joints of one sampled run leave the way of the other, while a bead is laid.

Prints mm of the linear joints, degrees of the rotary ones, and how many samples there were."""
import sys


def read(name):
    rows = [[float(v) for v in line.split()] for line in open(name)]
    return [r[:5] for r in rows if len(r) == 6 and r[5] > 0.5]


def off(p, a, b):
    """How far p is from the straight way a to b, per joint, and its square in all."""
    d = [y - x for x, y in zip(a, b)]
    l = sum(v * v for v in d)
    t = min(1, max(0, sum((z - x) * v for x, z, v in zip(a, p, d)) / l)) if l > 0 else 0
    e = [abs(x + t * v - z) for x, v, z in zip(a, d, p)]
    return sum(v * v for v in e), e


def most(one, other):
    linear = rotary = 0
    at = 0
    for p in one[::10]:
        window = range(max(0, at - 100), min(len(other) - 1, at + 400))
        _, e, at = min((*off(p, other[i], other[i + 1]), i) for i in window)
        linear, rotary = max(linear, *e[:3]), max(rotary, *e[3:])
    return linear, rotary


a, b = read(sys.argv[1]), read(sys.argv[2])
if len(a) < 1000 or len(b) < 1000:
    sys.exit("too few samples of beads: %d and %d" % (len(a), len(b)))
both = [most(a, b), most(b, a)]
print("%.4f mm %.4f deg %d %d" % (max(m[0] for m in both), max(m[1] for m in both), len(a), len(b)))
