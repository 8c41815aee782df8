"""Stages one after the other: programs joined by pipes, functions between them."""
import os
import signal
import subprocess
import sys
import tempfile

from . import programs
from .chain import Chain
from .errors import BY_CODE, Error, FileError, UsageError, WorkError
from .streams import Stream, read


class Pipeline(Chain):
    """Stages to be run.  Nothing is done before run(), save(), gcode(), figures(), or iterating, which runs it once.

    `messages`, after a run: what stages said on standard error, as lines."""

    def __init__(self, source, steps):
        self._source, self._steps = source, tuple(steps)
        self.messages, self._result = [], None

    @classmethod
    def after(cls, before, what, words, options):
        step = (what, tuple(words), dict(options))
        if isinstance(before, Pipeline):
            return cls(before._source, before._steps + (step,))
        return cls(before, (step,))

    def __repr__(self):
        return "<Pipeline " + " | ".join(s[0] if isinstance(s[0], str) else s[0].__name__ for s in self._steps) + ">"

    def run(self):
        """Runs all stages.  A Stream, where the last one writes one; else text, or bytes of a picture.

        A stage that fails raises WorkError, UsageError, InputError, Truncated or FileError with its own message."""
        with tempfile.TemporaryDirectory(prefix="filum-") as room:
            out = self._run(room, None)
            if isinstance(out, Stream):
                return out
            if self._writes_stream():
                return read(out)
            with open(out, "rb") as file:
                data = file.read()
        try:
            return data.decode()
        except UnicodeDecodeError:
            return data

    def save(self, path):
        """Runs all stages into a file, which appears only when all went well.  Returns the path."""
        with tempfile.TemporaryDirectory(prefix="filum-") as room:
            out = self._run(room, os.fspath(path))
            if isinstance(out, Stream):
                out.write(path)
        return path

    def result(self):
        """run(), the first time it is asked for; then the same again."""
        if self._result is None:
            self._result = self.run()
        return self._result

    def __iter__(self):
        return iter(self.result())

    def __len__(self):
        return len(self.result())

    def __getitem__(self, k):
        return self.result()[k]

    def _writes_stream(self):
        return programs.contract(self._steps[-1][0]).get("out", "").startswith("stream")

    def _run(self, room, path):
        """The path of the last program's output, or the Stream of a last function."""
        at, now, self.messages = 0, self._source, []
        while at < len(self._steps):
            end = at
            while end < len(self._steps) and isinstance(self._steps[end][0], str):
                end += 1
            if end > at:
                last = end == len(self._steps)
                now = self._programs(self._steps[at:end], now, room, path if last else None)
                at = end
            else:
                own, words, options = self._steps[at]
                now = _own(own)(read(now) if isinstance(now, str) else now, *words, **options)
                at += 1
        return now

    def _programs(self, steps, source, room, path):
        target = path or _new(room, "out")
        commands = [[programs.front(), name] + _words(words, room) + _options(options, room) for name, words, options in steps]
        commands[-1] += ["--output", target]
        given = _as_file(source, room) if source is not None else os.devnull
        failures, said = _joined(commands, given, room)
        for (name, _, _), text, code in zip(steps, said, failures):
            if code not in (0, -signal.SIGPIPE):
                lines = text.strip().splitlines() or [f"{name}: ended by {code} without a word"]
                own = lines[-1].partition(": ")
                kind = BY_CODE.get(code, WorkError)
                raise kind(own[2] if own[0] == name else lines[-1], stage=name, code=code)
        self.messages += [line for text in said for line in text.splitlines()]
        for line in self.messages:
            print(line, file=sys.stderr)
        return target


def _joined(commands, given, room):
    """Runs commands joined by pipes: exit codes, and what each said."""
    running, said = [], []
    try:
        last = open(given, "rb")
    except OSError as why:
        raise FileError(f"cannot read '{given}': {why.strerror}") from why
    try:
        for k, command in enumerate(commands):
            said.append(open(_new(room, "said"), "w+b"))
            tail = k + 1 == len(commands)
            try:
                process = subprocess.Popen(command, stdin=last, stdout=subprocess.DEVNULL if tail else subprocess.PIPE,
                                           stderr=said[-1])
            except OSError as why:
                raise FileError(f"cannot run '{command[0]}': {why.strerror}") from why
            running.append(process)
            last.close()
            last = process.stdout or last
        codes = [p.wait() for p in running]
        texts = []
        for file in said:
            file.seek(0)
            texts.append(file.read().decode(errors="replace"))
        return codes, texts
    finally:
        last.close()
        for file in said:
            file.close()
        for process in running:
            if process.poll() is None:
                process.kill()
                process.wait()


def _own(what):
    """What takes a Stream to a Stream."""
    from .stages import Stage
    return what.on if isinstance(what, Stage) else Stage(what).on


def _new(room, name):
    handle, path = tempfile.mkstemp(prefix=name + "-", dir=room)
    os.close(handle)
    return path


def _as_file(value, room):
    """The path of a file with it: of a Stream or Pipeline a new one."""
    if isinstance(value, (Stream, Pipeline)):
        path = _new(room, "in")
        value.write(path) if isinstance(value, Stream) else value.save(path)
        return path
    return os.fspath(value)


def _word(value, room):
    if isinstance(value, (Stream, Pipeline)):
        return _as_file(value, room)
    if isinstance(value, (list, tuple)):
        return ",".join(_word(v, room) for v in value)
    if isinstance(value, dict):
        return ",".join(f"{k}={_word(v, room)}" for k, v in value.items())
    if hasattr(value, "item"):
        value = value.item()  # of a number of numpy
    return os.fspath(value) if isinstance(value, os.PathLike) else str(value)


def _words(words, room):
    return [_word(w, room) for w in words]


def _options(options, room):
    out = []
    for name, value in options.items():
        if name == "output":
            raise UsageError("cannot take the option 'output' here; use save(PATH)")
        flag = "--" + name.rstrip("_").replace("_", "-")
        if value is True:
            out.append(flag)
        elif value is not False and value is not None:
            out.append(f"{flag}={_word(value, room)}")
    return out


def begin(name, *words, **options):
    """A pipeline that begins with the program `name`."""
    if not isinstance(name, str):
        raise Error("a pipeline begins with the name of a stage")
    return Pipeline(None, ((name, words, options),))


