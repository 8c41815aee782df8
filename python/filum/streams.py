"""A whole stream in memory: what it carries, what was said on the way, and who made it."""
import os
import tempfile

import numpy as np

from . import framing, stream_pb2
from .chain import Chain
from .data import CLASSES, FRAME_OF, PAYLOAD_OF, Fact, Note, Payload, Role, Run, from_message, to_message
from .errors import Error, FileError, InputError, Truncated


class Stream(Chain):
    """What `read` gives and `write` takes.  Lengths in mm, angles in rad, times in s.

    payload: Payload
    frames: what it carries, notes and facts between, in order (list)
    history: list of Run, oldest first: how it was made

    Iterating, len() and [k] go over the payload: Layer, Region, Paths, Span or Surface.  Every stage is a method:
    `stream.fill(pattern="zigzag").link3d()`.
    """

    def __init__(self, payload, frames=(), history=()):
        self.payload = Payload[payload.upper()] if isinstance(payload, str) else Payload(payload)
        self.frames, self.history = list(frames), list(history)

    @property
    def items(self):
        """The payload, in order: a tuple; change `frames` to change the stream."""
        return tuple(f for f in self.frames if not isinstance(f, (Note, Fact)))

    @property
    def notes(self):
        """What stages dropped, repaired or could not place: a tuple of Note."""
        return tuple(f for f in self.frames if isinstance(f, Note))

    @property
    def facts(self):
        """What stages found out about the job: {"stage: name": value}, the latest of each."""
        return {f"{f.stage}: {f.name}": f.value for f in self.frames if isinstance(f, Fact)}

    def __iter__(self):
        return iter(self.items)

    def __len__(self):
        return len(self.items)

    def __getitem__(self, k):
        return self.items[k]

    def __repr__(self):
        made = " | ".join(r.program for r in self.history)
        return f"<{self.payload.name.capitalize()}: {len(self)} frames, {len(self.notes)} notes, made by {made or 'hand'}>"

    def made_by(self, program, version="1", settings=None):
        """This stream with one Run more in its history: for whoever changed it.  settings: {name: value}."""
        run = Run(program, version, [], np.array([len(self.history) - 1] if self.history else [], int))
        run.settings = [CLASSES["filum.proto.Setting"](k, str(v), True) for k, v in (settings or {}).items()]
        return Stream(self.payload, self.frames, self.history + [run])

    def table(self):
        """Of a toolpath: all points as one array with the fields x y z width height (mm), role, stroke, layer, region,
        tool, span; and of the tool axis nx ny nz."""
        if self.payload != Payload.TOOLPATH:
            raise InputError(f"a table of points is of a toolpath, not of {self.payload.name}")
        numbers = ("role", "stroke", "layer", "region", "tool")
        kind = ([(n, float) for n in ("x", "y", "z", "width", "height", "nx", "ny", "nz")] +
                [(n, np.int64) for n in numbers + ("span",)])
        out = np.zeros(sum(len(s.x) for s in self), kind)
        at = 0
        for k, s in enumerate(self):
            part = out[at:at + len(s.x)]
            at += len(s.x)
            part["x"], part["y"], part["z"] = s.points.T
            part["nx"], part["ny"], part["nz"] = s.normals.T
            part["width"], part["height"], part["span"] = s.widths, s.heights, k
            for name in numbers:
                part[name] = getattr(s, name)
        return out

    def strokes(self):
        """Of a toolpath: a list of arrays (n x 3, mm), each laid without stopping, by the numbers of its spans."""
        parts = {}
        for s in self:
            if s.role != Role.TRAVEL:
                parts.setdefault((s.tool, s.stroke), []).append(s.points)
        return [np.vstack(p) for p in parts.values()]

    def header(self):
        """The message of its header."""
        out = stream_pb2.Header(payload=int(self.payload), units="mm", expected=len(self))
        out.history.extend(to_message(r) for r in self.history)
        return out

    def write(self, file):
        """To a path (whole, or not at all) or a binary file."""
        if hasattr(file, "write"):
            writer = framing.Writer(file, self.header())
            for f in self.frames:
                if not isinstance(f, (Note, Fact)) and PAYLOAD_OF.get(type(f)) != self.payload:
                    raise InputError(f"cannot write a {type(f).__name__} in a stream of {self.payload.name}")
                writer.write(FRAME_OF[type(f)], to_message(f))
            writer.close()
            return
        with whole_file(file) as out:
            self.write(out)

    def bytes(self):
        """The stream as bytes."""
        import io
        out = io.BytesIO()
        self.write(out)
        return out.getvalue()


class whole_file:
    """A context: a binary file that appears under its name only when all went well."""

    def __init__(self, path):
        self._path = os.fspath(path)

    def __enter__(self):
        folder = os.path.dirname(self._path) or "."
        try:
            handle, self._there = tempfile.mkstemp(prefix=".filum-", dir=folder)
        except OSError as why:
            raise FileError(f"cannot write '{self._path}': {why.strerror}") from why
        mask = os.umask(0)
        os.umask(mask)
        os.fchmod(handle, 0o666 & ~mask)
        self._file = os.fdopen(handle, "wb")
        return self._file

    def __exit__(self, kind, why, trace):
        try:
            self._file.close()
            if kind is None:
                os.replace(self._there, self._path)
                return
        except OSError as failed:
            os.unlink(self._there)
            raise FileError(f"cannot write '{self._path}': {failed.strerror}") from failed
        os.unlink(self._there)


def read(source):
    """The Stream in a file: a path, bytes, or an open binary file.  InputError if it is damaged, Truncated if it ends
    too early, FileError if it cannot be read; their texts name the file."""
    name = f"'{os.fspath(source)}'" if isinstance(source, (str, os.PathLike)) else "the stream"
    try:
        if isinstance(source, (str, os.PathLike)):
            with open(source, "rb") as file:
                return _read(file)
        return _read(framing.opened(source))
    except OSError as why:
        raise FileError(f"cannot read {name}: {why.strerror}") from why
    except (InputError, Truncated) as why:
        raise type(why)(f"cannot read {name}: {why.text}") from why


def _read(file):
    reader = framing.Reader(file)
    frames = [from_message(message) for _, message in reader.frames()]
    return Stream(reader.header.payload, frames, [from_message(r) for r in reader.header.history])


def write(stream, file):
    """Writes a Stream to a path (whole, or not at all) or a binary file."""
    if not isinstance(stream, Stream):
        raise Error(f"cannot write a {type(stream).__name__} as a stream")
    stream.write(file)
