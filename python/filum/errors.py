"""What goes wrong, with the stage's own words.  One class for each exit code of the programs."""


class Error(Exception):
    """Anything of Filum that failed.  `stage`: who says it; `code`: its exit code; the text is its own message."""

    code = 1

    def __init__(self, text, stage=None, code=None):
        super().__init__(text if stage is None else f"{stage}: {text}")
        self.text, self.stage = text, stage
        if code is not None:
            self.code = code


class WorkError(Error):
    """The work could not be done (exit code 1)."""


class UsageError(Error):
    """An option or argument is wrong (exit code 2)."""

    code = 2


class InputError(Error):
    """The input is not what it should be (exit code 3)."""

    code = 3


class Truncated(Error):
    """The input ends too early (exit code 4)."""

    code = 4


class FileError(Error):
    """Reading or writing failed (exit code 5)."""

    code = 5


BY_CODE = {c.code: c for c in (WorkError, UsageError, InputError, Truncated, FileError)}
