#!/usr/bin/env python3
"""No option does nothing in silence.  Run in a folder with the inputs of common.bash, the commands on the PATH.

   effect.py try        every option of every command, alone and with what it needs: the payload changes, or there is
                        a message.  Those that the command calls a limit may leave all as it is ...
   effect.py witness [COMMAND.OPTION...]
                        ... but each of them, and each that takes a text or a file, has a case in witness.tsv where it
                        changes something; or only these.
Prints what fails; ends with 1 if anything does."""
import functools
import json
import subprocess
import sys
from pathlib import Path

from contract import commands, settings_for, values, word

INPUTS = {"file": "part.stl", "stream Layers": "Layers", "stream Regions": "Regions", "stream Paths": "Paths",
          "stream Toolpath": "Toolpath", "stream Surface": "Surface", "stream unknown": "Paths"}


def shell(text):
    return subprocess.run(["bash", "-c", "set -o pipefail; " + text], capture_output=True, timeout=120)


def payload(data, option):
    """What a run made, without what only repeats the command line."""
    if data[:4] == b"\x89PNG":
        return data
    peeked = subprocess.run(["peek", "--json"], input=data, capture_output=True) if b"\0" in data[:64] else None
    if peeked is not None and peeked.returncode == 0:
        frames = json.loads(peeked.stdout)["frames"]
        return json.dumps([f for f in frames if f.get("name") != option])
    return b"\n".join(line for line in data.split(b"\n") if b"postproc" not in line)


@functools.lru_cache(maxsize=4)  # without the option a command does the same for each option
def made_by(line):
    """What was said to be wrong, if anything, what was printed, and the files that were made."""
    for file in Path(".").glob("made.*"):
        file.unlink()
    done = shell(line)
    files = {p.name: p.read_bytes() for p in sorted(Path(".").glob("made.*"))}
    said = done.stderr.decode(errors="replace").strip() or (f"exit {done.returncode}" if done.returncode != 0 else "")
    return said, done.stdout, files


def run(line, option):
    """What was said to be wrong, if anything, and what came out."""
    said, printed, files = made_by(line)
    return said, (payload(printed, option), {name: payload(data, option) for name, data in files.items()})


def input_of(command):
    special = {"fill": "sequenced", "ingest": "part.gcode", "metrics": "Toolpath"}
    return special.get(command.name, INPUTS.get(command.into))


def silent(command, option, words, value):
    """Whether the value changes nothing and nothing is said."""
    base = f"{command.name} {' '.join(words)} {input_of(command)}"
    said, before = run(base, option.name)
    if said:
        return False
    said, after = run(f"{base} '{word(option, value)}'", option.name)
    return not said and before == after


def try_all():
    failed = []
    for command in commands():
        if input_of(command) is None:
            continue
        for option in command.options.values():
            if option.limit:
                continue
            needed = settings_for(command, option)
            for words in ([], needed) if option.needs else ([],):
                tries = values(option) if words is not None else []
                if tries and all(silent(command, option, words, value) for value in tries):
                    failed.append(f"{command.name} {' '.join(words)} --{option.name}: none of {tries}")
    return failed


def witnesses():
    out = {}
    for line in (Path(__file__).parent / "witness.tsv").read_text().splitlines():
        if line and not line.startswith("#"):
            command, option, without, more = line.split("\t")
            out[command, option] = (without, more)
    return out


def witness_all():
    known, failed, only = witnesses(), [], sys.argv[2:]
    for command in commands():
        for option in command.options.values():
            if only and command.name + "." + option.name not in only:
                known.pop((command.name, option.name), None)
                continue
            case = known.pop((command.name, option.name), None)
            if case is None:
                if option.limit or not values(option):
                    failed.append(f"{command.name} --{option.name}: there is no case for it in witness.tsv")
                continue
            without, more = case
            base = without.replace("@", "")
            (before_said, before), (said, after) = run(base, option.name), run(without.replace("@", more), option.name)
            if before == after:
                failed.append(f"{command.name} --{option.name} changes nothing: {without.replace('@', more)}")
            if not before[0] and not before[1] and before_said:
                failed.append(f"{command.name} --{option.name}: the case fails without it: {base}: {before_said}")
    return failed + [f"{c} --{o}: there is no such option" for c, o in known]


if __name__ == "__main__":
    FAILED = {"try": try_all, "witness": witness_all}[sys.argv[1]]()
    print("\n".join(FAILED))
    sys.exit(1 if FAILED else 0)
