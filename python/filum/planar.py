"""What the streams of the planar chain carry, as arrays: Layer, Region, Paths and Span.  Lengths in mm, areas in mm2.

Each class holds exactly the fields of the message of its name in proto/filum/planar.proto; what is repeated there is a
numpy array here (a list, if of messages).  Properties put them together in the shape that one computes with.
"""
import dataclasses
import enum

import numpy as np

from . import planar_pb2

Join = enum.IntEnum("Join", planar_pb2.Join.items())
Join.__doc__ = "How a region continues the one printed before: START (a new stroke), VERTICAL (above it), BESIDE (its brim)."
Retraction = enum.IntEnum("Retraction", planar_pb2.Retraction.items())
Retraction.__doc__ = "What happens to the material on a travel: BY_MACHINE (as the profile says), NOT_TAKEN, TAKEN_BACK."
Feature = enum.IntEnum("Feature", planar_pb2.Feature.items())
Feature.__doc__ = "What a bead is for, as the program of a slicer says it: OUTER_WALL, WALL, INFILL and so on; UNTOLD."
AreaKind = enum.IntEnum("AreaKind", planar_pb2.AreaKind.items())
AreaKind.__doc__ = "What a part of a region is: SKIN_TOP, SKIN_BOTTOM, BRIDGED are solid; SPARSE is filled in " \
    "part; a ZONE has walls and beads of its own."
Pattern = enum.IntEnum("Pattern", planar_pb2.Pattern.items())
Pattern.__doc__ = "How a sparse area is filled: ROWS, WAVE, CONCENTRIC."
RegionClass = enum.IntEnum("RegionClass", planar_pb2.RegionClass.items())
RegionClass.__doc__ = "What a region is there for: PART, CARRIER (a support), RIM (brim or skirt)."
Role = enum.IntEnum("Role", planar_pb2.Role.items())
Role.__doc__ = "What a span is: BEAD, LIFT, JOG, CONNECTOR, HAIRPIN extrude; TRAVEL does not."


def floats():
    return dataclasses.field(default_factory=lambda: np.zeros(0))


def ints():
    return dataclasses.field(default_factory=lambda: np.zeros(0, np.int64))


def listed():
    return dataclasses.field(default_factory=list)


def length_of(points, closed=False):
    steps = np.diff(np.vstack((points, points[:1])) if closed and len(points) else points, axis=0)
    return float(np.sqrt((steps * steps).sum(axis=1)).sum()) if len(points) else 0.0


def for_all(values, count):
    """One value for each of `count` points, where one may stand for all."""
    values = np.asarray(values, float)
    return np.full(count, values[0]) if len(values) == 1 else values


def _signed_area(points):
    x, y = points[:, 0], points[:, 1]
    return float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


@dataclasses.dataclass(eq=False)
class Loops:
    """Closed polygons; the material is to the left: outlines counter-clockwise, holes clockwise.

    x, y: mm, the points of all loops, the first of a loop not repeated at its end
    start: loop k has the points start[k] to start[k + 1] - 1
    """

    message = planar_pb2.Loops
    x: np.ndarray = floats()
    y: np.ndarray = floats()
    start: np.ndarray = ints()

    @classmethod
    def of(cls, loops):
        """From a list of arrays of points (n x 2)."""
        loops = [np.asarray(loop, float).reshape(-1, 2) for loop in loops]
        points = np.vstack(loops) if loops else np.zeros((0, 2))
        return cls(points[:, 0], points[:, 1], np.concatenate(([0], np.cumsum([len(loop) for loop in loops]))).astype(int))

    def __len__(self):
        return max(0, len(self.start) - 1)

    def __getitem__(self, k):
        """The points of loop k: n x 2, mm."""
        k = range(len(self))[k]
        a, b = int(self.start[k]), int(self.start[k + 1])
        return np.column_stack((self.x[a:b], self.y[a:b]))

    def __iter__(self):
        return (self[k] for k in range(len(self)))

    @property
    def area(self):
        """mm2: outlines less holes."""
        return sum(_signed_area(loop) for loop in self)


@dataclasses.dataclass(eq=False)
class Layer:
    """One slice of the part.

    index: from 0, lowest first
    z: mm, height of the nozzle: top of the layer
    height: mm, thickness
    plane: mm, where the model was cut
    contours: Loops
    body, tool: numbers of the body and of its tool; with several bodies a layer comes once for each
    width: mm, of its beads; 0: as the options of the stages say
    layers: number of layers of the job that it is high, 0 for one; `index` is the uppermost of these
    skipped: number of lower layers without a layer of its body for this reason
    """

    message = planar_pb2.Layer
    index: int = 0
    z: float = 0.0
    height: float = 0.0
    plane: float = 0.0
    contours: Loops = dataclasses.field(default_factory=Loops)
    body: int = 0
    tool: int = 0
    width: float = 0.0
    layers: int = 0
    skipped: int = 0


@dataclasses.dataclass(eq=False)
class Overlap:
    """How a region lies on one of the layer below.

    below: id of the lower region
    area: mm2 that both share
    inradius: mm, a circle of it fits into that (a lower bound)
    link: the curves of both pass within about a bead width of each other here
    """

    message = planar_pb2.Overlap
    below: int = 0
    area: float = 0.0
    inradius: float = 0.0
    link: bool = False


@dataclasses.dataclass(eq=False)
class Area:
    """A part of a region that is not filled like the rest.

    kind: AreaKind
    loops: Loops
    direction: rad, of bridges and of rows, from the x axis
    spacing: mm, sparse: from line to line
    pattern: Pattern, sparse
    gap: mm, sparse: no gap is wider, by more lines between those; 0: as the spacing says
    walls: zone: rings along its outline, within those of the region
    width: mm, of its beads (zone) or lines (sparse; 0: as around)
    solid: mm, zone: of the beads of solid parts; 0: as its other beads
    """

    message = planar_pb2.Area
    kind: int = AreaKind.SKIN_TOP
    loops: Loops = dataclasses.field(default_factory=Loops)
    direction: float = 0.0
    spacing: float = 0.0
    pattern: int = Pattern.ROWS
    gap: float = 0.0
    walls: int = 0
    width: float = 0.0
    solid: float = 0.0


@dataclasses.dataclass(eq=False)
class Region:
    """One connected region of one layer.

    id: of the part, from 0
    layer: its number
    z, height: mm, top and thickness of the layer
    loops: Loops; loop 0 is the outline, the others its holes
    area: mm2
    parent: id of the region whose hole holds this one, -1 if none
    below: list of Overlap
    unsupported: mm2 with nothing below
    stroke, join: set by `sequence`: number of the stroke, and how it comes here
    inradius: mm, a circle of it fits into the region (a lower bound)
    areas: list of Area, set by `skins`: what is in none is solid
    walls: rings along the whole outline; 0: none are told apart, and it is solid all through
    purpose: RegionClass
    body, tool: numbers of the body (the lowest of several that became one region) and of its tool
    width: mm, of its beads; 0: as the options of the stages say
    layers, skipped: as in Layer
    brim: id of the brim about it that its stroke may begin with, -1 if there is none; set by `supports`
    """

    message = planar_pb2.Region
    id: int = 0
    layer: int = 0
    z: float = 0.0
    height: float = 0.0
    loops: Loops = dataclasses.field(default_factory=Loops)
    area: float = 0.0
    parent: int = 0
    below: list = listed()
    unsupported: float = 0.0
    stroke: int = 0
    join: int = Join.START
    inradius: float = 0.0
    areas: list = listed()
    walls: int = 0
    purpose: int = RegionClass.PART
    brim: int = -1
    body: int = 0
    tool: int = 0
    width: float = 0.0
    layers: int = 0
    skipped: int = 0

    def filled(self, curves):
        """The Paths that fill this region by `curves` (list of Curve).  What no bead reaches is taken for the area
        less length times width: right if beads neither overlap nor lie outside."""
        laid = sum(c.area for c in curves)
        return Paths(self.id, self.layer, self.z, self.height, self.area, self.stroke, self.join, list(curves),
                     max(0.0, self.area - laid))


@dataclasses.dataclass(eq=False)
class Curve:
    """The middle line of a bead.

    closed: it ends where it begins; the first point is not repeated
    x, y: mm
    width: mm, per point, or one for all
    feature: Feature, per segment, or one for all; none: not told
    over_air: per segment, share of the bead's width over air, in percent; none: not measured
    """

    message = planar_pb2.Curve
    closed: bool = False
    x: np.ndarray = floats()
    y: np.ndarray = floats()
    width: np.ndarray = floats()
    feature: np.ndarray = ints()
    over_air: np.ndarray = ints()

    @classmethod
    def of(cls, points, width, closed=True):
        """From points (n x 2, mm) and a width (mm) or one for each."""
        points = np.asarray(points, float).reshape(-1, 2)
        return cls(bool(closed), points[:, 0], points[:, 1], np.atleast_1d(np.asarray(width, float)))

    @property
    def points(self):
        """n x 2, mm."""
        return np.column_stack((self.x, self.y))

    @property
    def widths(self):
        """mm, one for each point."""
        return for_all(self.width, len(self.x))

    @property
    def length(self):
        """mm."""
        return length_of(self.points, self.closed)

    @property
    def area(self):
        """mm2: length times width, piece by piece."""
        if len(self.x) < 2:
            return 0.0
        p, w = self.points, self.widths
        if self.closed:
            p, w = np.vstack((p, p[:1])), np.append(w, w[0])
        return float((np.hypot(*np.diff(p, axis=0).T) * (w[1:] + w[:-1]) / 2).sum())


@dataclasses.dataclass(eq=False)
class Line:
    """An open line: x, y in mm."""

    message = planar_pb2.Line
    x: np.ndarray = floats()
    y: np.ndarray = floats()

    @property
    def points(self):
        """n x 2, mm."""
        return np.column_stack((self.x, self.y))


@dataclasses.dataclass(eq=False)
class Paths:
    """What fills one region (message RegionPaths).

    region, layer: numbers of the region and its layer
    z, height: mm, top and thickness of the layer
    area: mm2 of the region
    stroke, join: as `sequence` says
    curves: list of Curve
    unplaced: mm2 that no bead reaches
    stacked: list of Line, where a curve passes twice, to be laid in two halves of the height
    body, tool: numbers of the body and of the tool that prints it
    skipped: as in Layer
    """

    message = planar_pb2.RegionPaths
    region: int = 0
    layer: int = 0
    z: float = 0.0
    height: float = 0.0
    area: float = 0.0
    stroke: int = 0
    join: int = Join.START
    curves: list = listed()
    unplaced: float = 0.0
    stacked: list = listed()
    body: int = 0
    tool: int = 0
    skipped: int = 0


@dataclasses.dataclass(eq=False)
class Span:
    """A stretch of the toolpath; its first point is where the one before ended.

    role: Role
    stroke, layer, region, tool, body: numbers
    x, y: mm
    z, width, height: mm, per point, or one for all; a travel has no width and no height
    nx, ny, nz: unit, per point: where the tool comes from; none: from above
    retraction: Retraction, of a travel
    feature: Feature, of what extrudes
    over_air: share of a wall's width over air, in percent
    """

    message = planar_pb2.Span
    role: int = Role.BEAD
    stroke: int = 0
    layer: int = 0
    region: int = 0
    x: np.ndarray = floats()
    y: np.ndarray = floats()
    z: np.ndarray = floats()
    width: np.ndarray = floats()
    height: np.ndarray = floats()
    nx: np.ndarray = floats()
    ny: np.ndarray = floats()
    nz: np.ndarray = floats()
    tool: int = 0
    retraction: int = Retraction.BY_MACHINE
    feature: int = Feature.UNTOLD
    body: int = 0
    over_air: int = 0

    @property
    def points(self):
        """n x 3, mm."""
        return np.column_stack((self.x, self.y, for_all(self.z, len(self.x))))

    @property
    def widths(self):
        """mm, one for each point; 0 of a travel."""
        return for_all(self.width, len(self.x)) if len(self.width) else np.zeros(len(self.x))

    @property
    def heights(self):
        """mm, one for each point; 0 of a travel."""
        return for_all(self.height, len(self.x)) if len(self.height) else np.zeros(len(self.x))

    @property
    def normals(self):
        """n x 3, unit vectors towards the tool."""
        if len(self.nx):
            return np.column_stack((self.nx, self.ny, self.nz))
        return np.tile([0.0, 0.0, 1.0], (len(self.x), 1))

    @property
    def extrudes(self):
        return self.role != Role.TRAVEL

    @property
    def length(self):
        """mm."""
        return length_of(self.points)

    @property
    def volume(self):
        """mm3 laid: length times width times height, piece by piece.  Joins lay nothing where they go straight up or down,
        travels nothing at all."""
        if not self.extrudes or len(self.x) < 2:
            return 0.0
        section = self.widths * self.heights
        steps = np.diff(self.points, axis=0)
        upright = (steps[:, 0] == 0) & (steps[:, 1] == 0)
        steps = np.linalg.norm(steps, axis=1)
        if self.role not in (Role.BEAD, Role.HAIRPIN):
            steps[upright] = 0
        return float((steps * (section[1:] + section[:-1]) / 2).sum())
