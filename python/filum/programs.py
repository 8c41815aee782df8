"""Where Filum's programs are, and what they say about themselves."""
import functools
import os
import shutil
import subprocess

from .errors import FileError


def front():
    """The command `filum`: $FILUM if set, else the one on the PATH, else that of the build tree beside this package."""
    named_so = os.environ.get("FILUM")
    if named_so:
        return named_so
    here = os.path.dirname(os.path.abspath(__file__))
    for place in (shutil.which("filum"), os.path.join(here, "../../bin/filum"), os.path.join(here, "../../build/bin/filum")):
        if place and os.access(place, os.X_OK):
            return place
    raise FileError("cannot find the program 'filum'; install it, or put its folder on the PATH")


@functools.lru_cache(maxsize=None)
def _listed(program):
    out = subprocess.run([program, "list"], capture_output=True, text=True, check=True)
    return tuple(line.split()[0] for line in out.stdout.splitlines() if line.strip())


def stages():
    """Names of all stages, as `filum list` has them."""
    try:
        return _listed(front())
    except FileError:
        return ()


def is_stage(name):
    return name in _listed(front()) or shutil.which(f"filum-{name}") is not None


@functools.lru_cache(maxsize=None)
def contract(name):
    """{"in": "stream Regions", "out": ...} and so on, as `STAGE --print-contract` says."""
    out = subprocess.run([front(), name, "--print-contract"], capture_output=True, text=True, check=False)
    return dict(line.split(" ", 1) for line in out.stdout.splitlines() if line.startswith(("in ", "out ", "synopsis ")))


@functools.lru_cache(maxsize=None)
def manual(name):
    """The text of `STAGE --help`."""
    return subprocess.run([front(), name, "--help"], capture_output=True, text=True, check=False).stdout


class named:
    """A stage as something to call, whose help is the program's."""

    def __init__(self, call, name):
        self._call, self.__name__ = call, name

    def __call__(self, *words, **options):
        return self._call(*words, **options)

    @property
    def __doc__(self):
        return manual(self.__name__)

    def __repr__(self):
        return f"<stage {self.__name__}: {contract(self.__name__).get('synopsis', '')}>"
