"""What every stream carries besides (notes, facts, runs), and messages to objects and back.

Lengths in mm, angles in rad, times in s, stresses in MPa.
"""
import dataclasses
import enum
import math

import numpy as np

from . import stream_pb2
from .planar import (Area, AreaKind, Curve, Feature, Join, Layer, Line, Loops, Overlap, Paths, Pattern, Region, RegionClass,
                     Retraction, Role, Span, floats, ints, listed)
from .surface import Field, Isolines, Sources, Surface

Payload = enum.IntEnum("Payload", stream_pb2.Payload.items())
Payload.__doc__ = "What a stream carries: LAYERS, REGIONS, PATHS, TOOLPATH or SURFACE."
Grade = enum.IntEnum("Grade", stream_pb2.Grade.items())
Grade.__doc__ = "How much a note matters: HARMLESS, LOOK, WILL_FAIL; GRADE_UNKNOWN counts as LOOK."
_ENUMS = {e.__name__: e for e in (AreaKind, Feature, Grade, Join, Pattern, Payload, RegionClass, Retraction, Role)}


@dataclasses.dataclass(eq=False)
class Note:
    """Something a stage dropped, repaired, merged or could not place.

    stage, what: who says it, and its sentence; of a note of your own a short fixed phrase
    code, grade: what it is about, as docs/notes.md has it ("" for a note of your own, or a code of your own); a Grade
    detail, patch: what the sentence names, and the patch that it is about
    amount, unit, count: how much in all, over how many cases
    layer: -1 if it is no layer's
    x, y, z: mm, the worst case; nan if nowhere, z None if the layer says how high
    bead: mm, width w of the job's beads: notes of one kind are harmless together if their amounts add up to less than
        pi/4 w^2 (in mm2) or w (in mm); 0: never
    """

    message = stream_pb2.Note
    stage: str = ""
    what: str = ""
    amount: float = 0.0
    unit: str = ""
    count: int = 1
    layer: int = -1
    x: float = math.nan
    y: float = math.nan
    z: float = None
    code: str = ""
    grade: Grade = Grade.GRADE_UNKNOWN
    detail: str = ""
    patch: str = ""
    bead: float = 0.0


@dataclasses.dataclass(eq=False)
class Fact:
    """Something a stage found out about the whole job: stage, name, value, unit."""

    message = stream_pb2.Fact
    stage: str = ""
    name: str = ""
    value: float = 0.0
    unit: str = ""


@dataclasses.dataclass(eq=False)
class Setting:
    """An option of a run: name and value, as text; changed: it differs from the default."""

    message = stream_pb2.Setting
    name: str = ""
    value: str = ""
    changed: bool = False


@dataclasses.dataclass(eq=False)
class Object:
    """One of several things that stand on the bed together: name, x and y of its convex outline, height of its top."""

    message = stream_pb2.Object
    name: str = ""
    x: np.ndarray = floats()
    y: np.ndarray = floats()
    height: float = 0.0


@dataclasses.dataclass(eq=False)
class Run:
    """One program's part in making a stream: program and its version, settings (list of Setting), and parents: numbers of
    earlier runs, what it read; objects: those that it put on the bed, if they are several."""

    message = stream_pb2.Run
    program: str = ""
    version: str = ""
    settings: list = listed()
    parents: np.ndarray = ints()
    objects: list = listed()


CLASSES = {c.message.DESCRIPTOR.full_name: c for c in (
    Loops, Layer, Overlap, Area, Region, Curve, Line, Paths, Span, Field, Sources, Isolines, Surface, Note, Fact, Setting, Object,
    Run)}
FRAME_OF = {Layer: "layer", Region: "region", Paths: "paths", Span: "span", Surface: "surface", Note: "note", Fact: "fact"}
PAYLOAD_OF = {Layer: Payload.LAYERS, Region: Payload.REGIONS, Paths: Payload.PATHS, Span: Payload.TOOLPATH,
              Surface: Payload.SURFACE}


def _dtype(field):
    kinds = {field.CPPTYPE_DOUBLE: float, field.CPPTYPE_BOOL: bool}
    return kinds.get(field.cpp_type, np.int64)


def from_message(message):
    """A protobuf message as the class of this module that belongs to it."""
    values = {}
    for f in message.DESCRIPTOR.fields:
        value = getattr(message, f.name)
        if f.label == f.LABEL_REPEATED:
            value = [from_message(m) for m in value] if f.message_type else np.array(value, _dtype(f))
        elif f.message_type:
            value = from_message(value) if message.HasField(f.name) or f.message_type.name == "Loops" else None
        elif f.enum_type:
            value = _ENUMS[f.enum_type.name](value)
        elif f.has_presence and not message.HasField(f.name):
            value = None
        values[f.name] = value
    return CLASSES[message.DESCRIPTOR.full_name](**values)


def to_message(item):
    """The protobuf message of an object of this module."""
    out = type(item).message()
    for f in out.DESCRIPTOR.fields:
        value = getattr(item, f.name)
        if f.label == f.LABEL_REPEATED:
            if f.message_type:
                getattr(out, f.name).extend(to_message(v) for v in value)
            else:
                getattr(out, f.name).extend(np.asarray(value, _dtype(f)).tolist())
        elif value is None:
            continue
        elif f.message_type:
            getattr(out, f.name).CopyFrom(to_message(value))
        else:
            setattr(out, f.name, int(value) if f.enum_type else value)
    return out
