"""What a Surface stream carries, as arrays.  Lengths in mm, stresses in MPa.

Each class holds exactly the fields of the message of its name in proto/filum/surface.proto.
"""
import dataclasses

import numpy as np

from . import surface_pb2
from .planar import floats, ints, listed


@dataclasses.dataclass(eq=False)
class Field:
    """Numbers or vectors at the vertices of a surface.

    name: "distance" (mm), "stress.CASE.s1" (MPa), "stress.CASE.d1" (unit) and the like
    value: infinite where nothing is known; the parts of a vector together
    components: 3 of a vector, 0 or 1 of a number
    """

    message = surface_pb2.Field
    name: str = ""
    value: np.ndarray = floats()
    components: int = 0

    @property
    def array(self):
        """Per vertex: n numbers, or n x 3."""
        return self.value.reshape(-1, self.components) if self.components > 1 else self.value


@dataclasses.dataclass(eq=False)
class Sources:
    """From where the field "distance" was measured: vertices, and straight lines within triangles.

    vertex: numbers of vertices
    triangle: per line
    ax, ay, az, bx, by, bz: mm, ends of each line
    """

    message = surface_pb2.Sources
    vertex: np.ndarray = ints()
    triangle: np.ndarray = ints()
    ax: np.ndarray = floats()
    ay: np.ndarray = floats()
    az: np.ndarray = floats()
    bx: np.ndarray = floats()
    by: np.ndarray = floats()
    bz: np.ndarray = floats()


@dataclasses.dataclass(eq=False)
class Isolines:
    """Lines of one value of "distance", what is less to their left.

    level: mm, per line
    closed: per line
    start: line k has the points start[k] to start[k + 1] - 1
    x, y, z: mm
    triangle: crossed behind each point
    """

    message = surface_pb2.Isolines
    level: np.ndarray = floats()
    closed: np.ndarray = dataclasses.field(default_factory=lambda: np.zeros(0, bool))
    start: np.ndarray = ints()
    x: np.ndarray = floats()
    y: np.ndarray = floats()
    z: np.ndarray = floats()
    triangle: np.ndarray = ints()

    def __len__(self):
        return max(0, len(self.start) - 1)

    def __getitem__(self, k):
        """The points of line k: n x 3, mm."""
        k = range(len(self))[k]
        part = slice(int(self.start[k]), int(self.start[k + 1]))
        return np.column_stack((self.x[part], self.y[part], self.z[part]))


@dataclasses.dataclass(eq=False)
class Surface:
    """A surface of triangles, counter-clockwise seen from the side that it faces.

    x, y, z: mm, vertices
    corner: triangle t has the vertices corner[3 t] to corner[3 t + 2]
    across: per side, 1 + the number of the side it is joined to; 0: a rim
    fields: list of Field
    isolines, sources: Isolines, Sources
    name: of a patch
    face: per triangle, the CAD face it lies on, from 1; none: not known
    algorithm: the path planned for it, in surfpath's words
    """

    message = surface_pb2.Surface
    x: np.ndarray = floats()
    y: np.ndarray = floats()
    z: np.ndarray = floats()
    corner: np.ndarray = ints()
    across: np.ndarray = ints()
    fields: list = listed()
    isolines: Isolines = None
    sources: Sources = None
    name: str = ""
    face: np.ndarray = ints()
    algorithm: str = ""

    @property
    def points(self):
        """Vertices: n x 3, mm."""
        return np.column_stack((self.x, self.y, self.z))

    @property
    def triangles(self):
        """m x 3, numbers of vertices."""
        return self.corner.reshape(-1, 3)

    @property
    def area(self):
        """mm2."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)

    def field(self, name):
        """Per vertex, the array of the field of that name; KeyError if there is none."""
        for f in self.fields:
            if f.name == name:
                return f.array
        raise KeyError(f"no field '{name}'; there are: {', '.join(f.name for f in self.fields) or 'none'}")
