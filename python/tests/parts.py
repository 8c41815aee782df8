"""Parts for the tests, as STL and OFF text."""
import os
import tempfile

import filum

CUBE = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6),
        (1, 3, 5), (3, 7, 5))


def box(path, size=(9, 9, 1)):
    """A box with a corner at the origin, as OFF."""
    corners = [[size[k] * (i >> k & 1) for k in range(3)] for i in range(8)]
    with open(path, "w", encoding="ascii") as f:
        f.write(f"OFF\n8 {len(CUBE)} 0\n")
        f.writelines("{} {} {}\n".format(*c) for c in corners)
        f.writelines("3 {} {} {}\n".format(*t) for t in CUBE)
    return path


class Folder:
    """A folder for the time of a test class, with what it needs."""

    def __enter__(self):
        self._room = tempfile.TemporaryDirectory(prefix="filum-test-")
        return self._room.name

    def __exit__(self, *_):
        self._room.cleanup()


def streams(folder):
    """One Stream of every payload, made by the stages."""
    layers = filum.slice(box(os.path.join(folder, "box.off"))).run()
    regions = layers.regions().sequence().run()
    paths = regions.fill().run()
    surface = filum.geodesic(os.path.join(folder, "box.off"), cut="0,0,1,0.5", source="plane:1,0,0,4.5", remesh=1, spacing=2).run()
    return {"layers": layers, "regions": regions, "paths": paths, "toolpath": paths.link3d().run(), "surface": surface}
