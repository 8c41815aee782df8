#!/usr/bin/python3
"""Stands in for LinuxCNC's screen: homes the simulated machine, runs program.ngc, writes samples.txt."""
import subprocess
import sys
import time

import linuxcnc

command, status, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()


def wait(until, seconds):
    """Waits until the machine says so; what it complains of meanwhile ends the run."""
    end = time.time() + seconds
    while time.time() < end:
        status.poll()
        complaint = errors.poll()
        if complaint:
            sys.exit("machine: %s" % (complaint,))
        if until():
            return
        time.sleep(0.02)
    sys.exit("machine: not done after %d s" % seconds)


command.state(linuxcnc.STATE_ESTOP_RESET)
command.wait_complete()
command.state(linuxcnc.STATE_ON)
command.wait_complete()
time.sleep(0.3)
command.mode(linuxcnc.MODE_MANUAL)
command.wait_complete()
command.home(-1)
wait(lambda: all(status.homed[:5]), 10)
sampler = subprocess.Popen(["halsampler"], stdout=open("samples.txt", "w"))
command.mode(linuxcnc.MODE_AUTO)
command.wait_complete()
command.program_open("program.ngc")
command.auto(linuxcnc.AUTO_RUN, 0)
time.sleep(0.5)
wait(lambda: status.interp_state == linuxcnc.INTERP_IDLE and status.inpos, 110)
time.sleep(0.2)
sampler.terminate()
open("done", "w").write("%d\n" % status.motion_line)
