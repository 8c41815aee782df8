"""Parts of any size for bench --scale: boxes, towers, pillars, stars, cylinders on a plate."""
import math
import struct


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


def prism(ring, at, height):
    """The triangles of an upright prism over a ring that is a star round its middle."""
    out = []
    for a, b in zip(ring, ring[1:] + ring[:1]):
        a, b = (a[0] + at[0], a[1] + at[1]), (b[0] + at[0], b[1] + at[1])
        out += [[*at, 0, *b, 0, *a, 0], [*at, height, *a, height, *b, height], [*a, 0, *b, 0, *b, height],
                [*a, 0, *b, height, *a, height]]
    return out


def rectangle(width, depth):
    return [(-width / 2, -depth / 2), (width / 2, -depth / 2), (width / 2, depth / 2), (-width / 2, depth / 2)]


def circle(points, radius):
    return [(radius * math.cos(2 * math.pi * k / points), radius * math.sin(2 * math.pi * k / points))
            for k in range(points)]


def star(points, radius, depth):
    """A round outline with waves of 40 points each, `depth` mm high."""
    def place(k):
        r, t = radius + depth * math.sin(2 * math.pi * k / 40), 2 * math.pi * k / points
        return r * math.cos(t), r * math.sin(t)
    return [place(k) for k in range(points)]


def grid(count, pitch):
    side = math.ceil(math.sqrt(count))
    return [(pitch * (k % side - (side - 1) / 2), pitch * (k // side - (side - 1) / 2)) for k in range(count)]


def box(side, height, path):
    write_stl(path, prism(rectangle(side, side), (0, 0), height))


def tower(layers, path):
    """10 x 10 mm, this many layers of 0.2 mm high."""
    write_stl(path, prism(rectangle(10, 10), (0, 0), 0.2 * layers))


def twisted(layers, path):
    """A column 60 mm wide with six ridges, this many layers of 0.2 mm high; it turns once in 200 mm, so layers differ."""
    count, rings = 120, max(2, round(0.2 * layers)) + 1

    def place(k, z):
        r, t = 26 + 4 * math.cos(6 * 2 * math.pi * k / count), 2 * math.pi * (k / count + z / 200)
        return r * math.cos(t), r * math.sin(t), z
    sides = [[place(k, 0.2 * layers * ring / (rings - 1)) for k in range(count)] for ring in range(rings)]
    out = []
    for low, high in zip(sides, sides[1:]):
        for k in range(count):
            j = (k + 1) % count
            out += [[*low[k], *low[j], *high[j]], [*low[k], *high[j], *high[k]]]
    for k in range(count):
        j = (k + 1) % count
        out += [[0, 0, 0, *sides[0][j], *sides[0][k]], [0, 0, 0.2 * layers, *sides[-1][k], *sides[-1][j]]]
    write_stl(path, out)


def pillars(count, path):
    """Square pillars of 3 x 3 x 2 mm, apart from each other: islands on each of ten layers."""
    write_stl(path, [t for at in grid(count, 5) for t in prism(rectangle(3, 3), at, 2)])


def cylinders(count, path):
    """Cylinders 10 mm wide and high."""
    write_stl(path, [t for at in grid(count, 15) for t in prism(circle(64, 5), at, 10)])


def gear(points, path):
    """A disc of ten layers whose outline has this many vertices, 0.025 mm apart."""
    write_stl(path, prism(star(points, points * 0.025 / (2 * math.pi) / 1.6, 0.3), (0, 0), 2))
