"""A stage of one's own: a function from an item to what it becomes, as a program like the others.

    @filum.stage(reads="regions", writes="paths")
    def walls(region, width: filum.MM = 0.4):
        "one bead along the outline"
        return region.filled([filum.Curve.of(region.loops[0], width)])

    if __name__ == "__main__":
        walls.main()

The keyword arguments are its options, their annotations the units (any text; filum.MM, DEG, SECONDS, SHARE, COUNT).  The program has --output, --quiet, --threads,
--help and --version, the exit codes of the others, hands on notes and facts, and writes its end frame only when its
input's was read.  In Python it is `stream.apply(walls, width=0.5)`.
"""
import inspect
import os
import signal
import sys
import traceback

from . import framing
from .data import CLASSES, FRAME_OF, PAYLOAD_OF, Note, Payload, Run, from_message, to_message
from .errors import Error, FileError, InputError, Truncated, UsageError, WorkError
from .streams import Stream, whole_file

# Units of options, for annotations.
MM, DEG, SECONDS, SHARE, COUNT = "MM", "DEG", "S", "SHARE", "N"

_COMMON = (("output", "FILE", "-", "where to write; a named file appears only when it is complete"),
           ("threads", "N", 0, "taken and not needed: one thread does it all"),
           ("quiet", "", False, "no warnings on standard error"),
           ("help", "", False, "this text"),
           ("version", "", False, "the version"))
_NAMES = {Payload.LAYERS: "Layers", Payload.REGIONS: "Regions", Payload.PATHS: "Paths", Payload.TOOLPATH: "Toolpath",
          Payload.SURFACE: "Surface"}


def stage(function=None, *, reads="regions", writes="paths", version="1", name=None):
    """Makes a Stage of a function: `@filum.stage(reads="layers", writes="layers")`, or bare, in place of `fill`."""
    def make(f):
        return Stage(f, reads=reads, writes=writes, version=version, name=name)
    return make if function is None else make(function)


class Stage:
    """A function as a stage.  It is given an item (Layer, Region, Paths, Span or Surface) and its options, and returns
    or yields items and Notes, or returns None."""

    def __init__(self, function, reads=None, writes=None, version="1", name=None):
        self.function, self.version = function, version
        self.__name__ = name or function.__name__.strip("<>").replace("_", "-")
        self.__doc__ = function.__doc__
        self.reads = Payload[reads.upper()] if reads else None
        self.writes = Payload[writes.upper()] if writes else None
        parameters = list(inspect.signature(function).parameters.values())[1:]
        self.options = {p.name.replace("_", "-"): p for p in parameters if p.default is not p.empty}

    def __call__(self, item, **options):
        return self.function(item, **options)

    # What the item becomes: a list, the notes with this stage's name.
    def _made(self, item, options):
        try:
            out = self.function(item, **options)
            out = [] if out is None else [out] if type(out) in FRAME_OF else list(out)
        except Error:
            raise
        except Exception as why:
            if os.environ.get("FILUM_TRACEBACK"):
                traceback.print_exc()
            at = traceback.extract_tb(why.__traceback__)[-1]
            raise WorkError(f"cannot work on {type(item).__name__} {_number(item)}: {type(why).__name__} in line "
                            f"{at.lineno}: {why}; FILUM_TRACEBACK=1 shows all of it") from why
        for o in out:
            if type(o) not in FRAME_OF:
                raise WorkError(f"cannot write a {type(o).__name__}; return items of a stream, or Notes")
            if isinstance(o, Note):
                o.stage = o.stage or self.__name__
        return out

    def _run(self, history, options):
        settings = CLASSES["filum.proto.Setting"]
        run = Run(self.__name__, self.version, [], [len(history) - 1] if history else [])
        for name, p in self.options.items():
            value = options.get(p.name, p.default)
            run.settings.append(settings(name, str(value), value != p.default))
        return run

    def on(self, stream, **options):
        """The Stream that this makes of another."""
        for name in options:
            if name not in {p.name for p in self.options.values()}:
                raise UsageError(f"{self.__name__}: unknown option '{name}'")
        if self.reads is not None and stream.payload != self.reads:
            raise InputError(f"{self.__name__}: it carries {stream.payload.name}, not {self.reads.name}")
        frames, payload = [], self.writes
        for f in stream.frames:
            made = self._made(f, options) if PAYLOAD_OF.get(type(f)) else [f]
            frames += made
            for m in made:
                payload = payload or PAYLOAD_OF.get(type(m))
        return Stream(payload or stream.payload, frames, stream.history + [self._run(stream.history, options)])

    def main(self, words=None):
        """Runs it as a program and leaves with its exit code."""
        sys.exit(self.program(sys.argv[1:] if words is None else words))

    def program(self, words):
        """Runs it as a program: its exit code."""
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # a reader that leaves ends it quietly, as it does the others
        try:
            options, common, inputs = self._parsed(words)
            for asked, text in (("help", self._help), ("version", self._version), ("print-contract", self._contract)):
                if common.get(asked):
                    print(text(), end="")
                    return 0
            self._filter(options, common, inputs)
            return 0
        except Error as why:
            print(f"{self.__name__}: {why.text}", file=sys.stderr)
            return why.code

    def _parsed(self, words):
        options, common, inputs = {}, {}, []
        kinds = {n: p.default for n, p in self.options.items()}
        kinds.update({n: default for n, _, default, _ in _COMMON}, **{"print-contract": False})
        words = list(words)
        while words:
            word = words.pop(0)
            if word == "-o":
                word = "--output"
            if not word.startswith("-") or word == "-":
                inputs.append(word)
                continue
            name, equals, text = word[2:].partition("=")
            if not word.startswith("--") or name not in kinds:
                raise UsageError(f"unknown option '{word}'; see {self.__name__} --help")
            default = kinds[name]
            if default is False:
                if equals:
                    raise UsageError(f"the option '--{name}' takes no value; leave it out")
                value = True
            else:
                if not equals and not words:
                    raise UsageError(f"the option '--{name}' needs a value; see {self.__name__} --help")
                value = _value(name, text if equals else words.pop(0), default)
            if name in self.options:
                options[self.options[name].name] = value
            else:
                common[name] = value
        if len(inputs) > 1:
            raise UsageError(f"cannot take a second input '{inputs[1]}'; one stream comes in")
        return options, common, inputs

    def _filter(self, options, common, inputs):
        path = inputs[0] if inputs else "-"
        called = "standard input" if path == "-" else f"'{path}'"
        try:
            file = sys.stdin.buffer if path == "-" else open(path, "rb")
        except OSError as why:
            raise FileError(f"cannot read {called}: {why.strerror}") from why
        target = common.get("output", "-")
        try:
            if target == "-":
                self._through(file, sys.stdout.buffer, options)
            else:
                with whole_file(target) as out:
                    self._through(file, out, options)
        except (InputError, Truncated) as why:
            raise type(why)(f"cannot read {called}: {why.text}") from why
        except OSError as why:
            raise FileError(f"cannot read {called} or write: {why.strerror}") from why

    def _through(self, file, out, options):
        reader = framing.Reader(file, self.reads)
        history = [from_message(r) for r in reader.header.history]
        header = Stream(self.writes, [], history + [self._run(history, options)]).header()
        header.expected = reader.header.expected
        writer = framing.Writer(out, header)
        for kind, message in reader.frames():
            if kind in ("note", "fact"):
                writer.write(kind, message)
                continue
            for made in self._made(from_message(message), options):
                if not isinstance(made, Note) and PAYLOAD_OF.get(type(made), self.writes) != self.writes:
                    raise WorkError(f"cannot write a {type(made).__name__} in a stream of {_NAMES[self.writes]}")
                writer.write(FRAME_OF[type(made)], to_message(made))
        writer.close()  # only now, when the input's own end frame was read and found right

    def _synopsis(self):
        return (inspect.getdoc(self.function) or "a stage of one's own").splitlines()[0]

    def _shown(self):
        for name, p in self.options.items():
            unit = p.annotation if isinstance(p.annotation, str) else "TEXT"
            yield name, "" if p.default is False else unit, p.default, ""
        yield from _COMMON

    def _help(self):
        out = [f"{self.__name__} - {self._synopsis()}", "", f"usage: {self.__name__} [OPTIONS] [INPUT]",
               f"reads:  {_NAMES[self.reads]}", f"writes: {_NAMES[self.writes]}", "memory: one item", "",
               inspect.getdoc(self.function) or "", "", "options:"]
        for name, unit, default, text in self._shown():
            left = f"  --{name} {unit}".rstrip()
            out.append(f"{left:<30}{text} {'' if default in (False, '') else f'[{default}]'}".rstrip())
        return "\n".join(out) + "\n"

    def _version(self):
        return f"{self.__name__} {self.version}\n"

    def _contract(self):
        out = [f"synopsis {self._synopsis()}", f"in stream {_NAMES[self.reads]}", f"out stream {_NAMES[self.writes]}"]
        for name, unit, default, _ in self._shown():
            out.append(f"option {name} {unit}" if unit else f"flag {name}")
            out.append(f"default {name} {str(default).lower() if isinstance(default, bool) else default}")
            if isinstance(default, (int, float)) and not isinstance(default, bool):
                out.append(f"range {name} -inf inf")
        return "\n".join(out) + "\n"


def _value(name, text, default):
    kind = type(default)
    if kind not in (int, float):
        return text
    try:
        value = kind(text)
    except ValueError:
        value = None
    if value is None or value != value or value in (float("inf"), float("-inf")):
        raise UsageError(f"cannot take '{text}' for '--{name}': it is no number; the default is {default}")
    return value


def _number(item):
    for name in ("id", "region", "index", "layer", "name"):
        if hasattr(item, name):
            return getattr(item, name)
    return ""
