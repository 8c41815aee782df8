#!/usr/bin/env python3
"""Every numeric option has finite limits, and no value of any option makes a command crash, hang or speak of itself.
Run in a folder with the inputs of common.bash, the commands on the PATH.  Prints what fails; ends with 1 if anything."""
import math
import resource
import signal
import subprocess
import sys

from contract import commands, numbers_of, settings_for
from effect import input_of

ODD = ["", "x", "nan", "inf", "-inf", "1e308", "-1e308", "1e999", "1e-320", "0x10", "1,2,3,4,5,6,7", ",", "1;2", "\u2212 3"]
SECONDS, PATIENCE, BYTES = 20, 0.15, 4 << 30  # of CPU; PATIENCE: where only it may end what is asked for


def patient():
    signal.setitimer(signal.ITIMER_PROF, PATIENCE)  # ends the command with SIGPROF


def run(words, before):
    """The code it ends with, and what it says.  before: called in the new process, which makes its start twice as long."""
    with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=before) as process:
        resource.prlimit(process.pid, resource.RLIMIT_CPU, (SECONDS, SECONDS))
        resource.prlimit(process.pid, resource.RLIMIT_AS, (BYTES, BYTES))
        try:
            said = process.communicate(timeout=10 * SECONDS)[1]
        except subprocess.TimeoutExpired:
            process.kill()
            raise
    return process.returncode, said.decode(errors="replace")


def wrong(command, words, may_take_long):
    """may_take_long: what is asked for is within the limits, so that only the patience of this test ends it."""
    try:
        code, text = run([command.name, *words, input_of(command), "--output", "/dev/null"], patient if may_take_long else None)
    except subprocess.TimeoutExpired:
        return "it hangs"
    if may_take_long and code == -signal.SIGPROF:
        return ""
    if code not in range(6):
        return f"it ends with {code}"
    if "internal error" in text or "out of memory" in text:
        return text
    if code == 2 and len(text.splitlines()) != 1:
        return f"no one line: {text}"
    return ""


def edges(option):
    least, most, is_open, _ = option.range
    step = max(abs(least), 1) * 1e-3
    ends = [least - step, least + step if is_open else least or -0.0, most, most * 2 if most > 0 else most + 1]
    return [",".join([repr(v)] * numbers_of(option)) for v in ends]


# All numbers are read by the same code, and all names of files, so each gets every seventh of the odd values, in turn.
FAILED, turn = [], 0
for one in commands():
    for o in one.options.values():
        turn += 1
        name = f"{one.name} --{o.name}"
        if o.is_number() and not all(map(math.isfinite, o.range[:2])):
            FAILED.append(f"{name} has no limits: {o.range}")
            continue
        if input_of(one) is None or o.unit == "":
            continue
        needed = settings_for(one, o) or []
        some = o.is_number() or o.unit == "FILE"
        tries = [(v, False) for v in (ODD[turn % 7 :: 7] if some else ODD)] + [(v, True) for v in (edges(o) if o.is_number() else [])]
        for value, within in tries:
            if why := wrong(one, [*needed, f"--{o.name}={value}"], within):
                FAILED.append(f"{name}={value!r}: {why}")
print("\n".join(FAILED))
sys.exit(1 if FAILED else 0)
