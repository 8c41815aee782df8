"""Filum in Python: read and write its streams as arrays, run its stages, draw, write stages of one's own.

    import filum
    text = filum.slice("part.stl").regions().sequence().fill(pattern="zigzag").link3d().gcode("marlin")
    path = filum.read("part.toolpath")      # a Stream; path[0].points is an array, n x 3, in mm
    path.write("copy.toolpath")
    filum.plot.layer(path, 3)

Lengths are mm, angles rad, times s, stresses MPa; options in degrees are named so by the stages.  Every program of
`filum list` is a function here and a method of streams: help(filum.fill).  Whatever a stage refuses is an exception
with its own message: UsageError, InputError, Truncated, FileError, WorkError, all of them filum.Error.
"""
from . import errors, plot, programs
from .data import (Area, AreaKind, Curve, Fact, Feature, Field, Grade, Isolines, Join, Layer, Line, Loops, Note, Overlap, Paths,
                   Pattern, Payload, Region, RegionClass, Retraction, Role, Run, Setting, Sources, Span, Surface)
from .errors import Error, FileError, InputError, Truncated, UsageError, WorkError
from .pipeline import Pipeline, begin
from .stages import COUNT, DEG, MM, SECONDS, SHARE, Stage, stage
from .streams import Stream, read, write

__version__ = "0.1.0"
__all__ = [
    "Area", "AreaKind", "begin", "COUNT", "Curve", "DEG", "Error", "errors", "Fact", "Feature", "Field", "FileError", "InputError", "Isolines",
    "Join", "Layer", "Line", "Loops", "MM", "Note", "Overlap", "Paths", "Pattern", "Payload", "Pipeline", "plot", "programs",
    "read", "Region", "RegionClass", "Retraction", "Role", "Run", "SECONDS", "Setting", "SHARE", "Sources", "Span", "Stage", "stage", "Stream",
    "Surface", "Truncated", "UsageError", "WorkError", "write",
]


def __getattr__(name):
    """Every stage as a function: filum.slice("part.stl"), filum.geodesic("part.stl", remesh=0.5)."""
    if name.startswith("_") or not programs.is_stage(name):
        raise AttributeError(f"module 'filum' has no attribute or stage '{name}'")
    return programs.named(lambda *words, **options: begin(name, *words, **options), name)


def __dir__():
    return sorted(set(__all__) | set(programs.stages()))
