"""Reading the results that CalculiX writes as text, for the scripts of this folder."""
import gzip

FACES = ((0, 1, 2, 4, 5, 6), (0, 1, 3, 4, 8, 7), (1, 2, 3, 5, 9, 8), (2, 0, 3, 6, 7, 9))  # of a C3D10


def numbers(line, count):
    return [float(line[13 + 12 * k:25 + 12 * k]) for k in range(count)]


def read(file, result="STRESS", count=6):
    """Points by number, elements as lists of numbers, and per step the numbers of the result by number."""
    points, elements, steps = {}, [], []
    block = None
    with (gzip.open if file.endswith(".gz") else open)(file, "rt") as f:
        for line in f:
            if line.startswith(("    2C", "    3C")):
                block = line[4]
            elif line.startswith(" -4"):
                block = line[5:13].strip()
                if block == result:
                    steps.append({})
            elif line.startswith(" -3"):
                block = None
            elif line.startswith(" -1") and block == "2":
                points[int(line[3:13])] = numbers(line, 3)
            elif line.startswith(" -1") and block == result:
                steps[-1][int(line[3:13])] = numbers(line, count)
            elif line.startswith(" -2") and block == "3":
                elements.append([int(line[3 + 10 * k:13 + 10 * k]) for k in range(10)])
    return points, elements, steps


def skin(elements):
    """The faces that one element only has, of six nodes each."""
    faces = {}
    for e in elements:
        for f in FACES:
            corners = tuple(sorted(e[k] for k in f[:3]))
            faces[corners] = None if corners in faces else [e[k] for k in f]
    return [f for f in faces.values() if f]
