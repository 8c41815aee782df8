#!/usr/bin/python3
"""plan.py PROGRAM [KEY=VALUE...]: lets real Klipper plan a program, without hardware; says how long it takes.

FILUM_KLIPPER names a checkout of Klipper.  KEY is one of [printer] (max_accel=5000), `resolution` of [gcode_arcs], or
`rotary=a,c`: manual steppers, `tools=2`: nozzles.  Prints, tab-separated: the seconds from above the first stroke to the end of the
last one, without what the profile's templates do before and after, then each motor and how many steps it makes in all.
Exit 1 and Klipper's own words if it refuses a line or does not end within five minutes, 77 if it cannot be run here.
"""
import os
import re
import subprocess
import sys
import tempfile

PRINTER = {"kinematics": "cartesian", "max_velocity": 300, "max_accel": 3000, "max_z_velocity": 15,
           "max_z_accel": 100, "square_corner_velocity": 5}
LONGEST = 300  # s that Klipper may take
MARK = "FILUM_MARK"  # a command of our own; the machine stands where it is put


def stepper(name, pin, way, **more):
    return {name: {"step_pin": f"gpio{pin}", "dir_pin": f"gpio{pin + 1}", "enable_pin": f"!gpio{pin + 2}",
                   "microsteps": 16, "rotation_distance": way, **more}}


def heater(name, pin, sensor, **more):
    return {name: {"heater_pin": f"gpio{pin}", "sensor_type": "EPCOS 100K B57560G104F", "sensor_pin": f"analog{sensor}",
                   "min_temp": 0, "max_temp": 300, **more}}


def config(keys):
    """A made-up printer: sections, and what stands in each."""
    rotary = [name for name in keys.pop("rotary", "").split(",") if name]
    nozzles = int(keys.pop("tools", 1))
    out = {"mcu": {"serial": "/dev/null"}, "gcode_arcs": {"resolution": keys.pop("resolution", 1)}}
    out["printer"] = {**PRINTER, **keys}
    for k, axis in enumerate("xyz"):
        out.update(stepper(f"stepper_{axis}", 10 * k, 8 if axis == "z" else 40, endstop_pin=f"^gpio{10 * k + 3}",
                           position_endstop=0, position_min=-300, position_max=400, homing_speed=50,
                           homing_positive_dir="false"))
    drive = stepper("extruder", 30, 33.5)["extruder"]
    out.update(heater("extruder", 33, 0, control="pid", pid_kp=22, pid_ki=1, pid_kd=114, nozzle_diameter=0.4,
                      filament_diameter=1.75, max_extrude_only_distance=500, max_extrude_cross_section=50, **drive))
    for k in range(1, nozzles):
        out.update(heater(f"extruder{k}", 60 + k, 1 + k, control="pid", pid_kp=22, pid_ki=1, pid_kd=114, nozzle_diameter=0.4,
                          filament_diameter=1.75, max_extrude_only_distance=500, max_extrude_cross_section=50,
                          **stepper("extruder", 63 + 3 * k, 33.5)["extruder"]))
    out.update(heater("heater_bed", 34, 1, control="watermark"))
    out["fan"] = {"pin": "gpio35"}
    out["display_status"] = {}  # M73, as any printer with a screen has it
    for k, name in enumerate(rotary):
        out.update(stepper(f"manual_stepper {name}", 40 + 10 * k, 36, velocity=60, accel=600))
    return "\n".join(f"[{s}]\n" + "".join(f"{k}: {v}\n" for k, v in keys.items()) for s, keys in out.items())


def marked(text):
    """The program with marks: behind the moves to above its start (after G90 and M83), before its end, behind all."""
    lines = text.split("\n")
    layer = next(i for i, line in enumerate(lines) if "LAYER_CHANGE" in line)
    begin = max(i for i in range(layer) if lines[i] == "M83")
    over = next(i for i in range(begin, len(lines)) if re.match(r"G[01] .*X", lines[i]))
    # Machines with rotary axes come down from far above first.
    first = max([over] + [i for i in range(begin, layer) if i > over and re.match(r"G1 Z\S+ F", lines[i])])
    last = max(i for i, line in enumerate(lines) if re.match(r"G[123] .*[XYAC].* E0*\.?0*[1-9]", line))
    end = next(i for i in range(last, len(lines)) if lines[i].startswith("G1 E-"))
    return "\n".join(lines[:first + 1] + [MARK] + lines[first + 1:end] + [MARK] + lines[end:] + [MARK, ""])


def dictionary(klipper, room):
    """Of the micro-controller's commands: built for a process of Linux, beside the checkout if it has none."""
    ready = os.path.join(klipper, "out", "klipper.dict")
    if os.path.exists(ready):
        return ready
    own = os.path.join(room, "config")
    with open(own, "w") as f:
        f.write("CONFIG_LOW_LEVEL_OPTIONS=y\nCONFIG_MACH_LINUX=y\n")
    for goal in (["olddefconfig"], []):
        done = subprocess.run(["make", "-C", klipper, f"OUT={room}/out/", f"KCONFIG_CONFIG={own}", *goal],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.stderr.write(done.stderr[-1000:])
            sys.exit(77)
    return os.path.join(room, "out", "klipper.dict")


def run_klippy(folder, arguments):
    """Klippy in this process, which says the print time at each mark."""
    sys.path.insert(0, folder)
    import klippy
    import toolhead
    made = toolhead.ToolHead.__init__

    def make(self, config):
        made(self, config)

        seen = []

        def mark(_):
            print("mark", self.get_last_move_time(), flush=True)
            seen.append(True)
            if len(seen) == 3:  # at the end: all steps are to be seen
                self.flush_step_generation()
        config.get_printer().lookup_object("gcode").register_command(MARK, mark)
    toolhead.ToolHead.__init__ = make
    sys.argv = ["klippy.py", *arguments]
    klippy.main()


def plan(program, keys):
    klipper = os.environ.get("FILUM_KLIPPER", "")
    if not os.path.isdir(os.path.join(klipper, "klippy")):
        print("FILUM_KLIPPER names no checkout of Klipper", file=sys.stderr)
        sys.exit(77)
    with tempfile.TemporaryDirectory() as room:
        at = {name: os.path.join(room, name) for name in ("printer.cfg", "program.gcode", "serial", "log")}
        with open(at["printer.cfg"], "w") as f:
            f.write(config(keys))
        with open(program) as f, open(at["program.gcode"], "w") as g:
            g.write(marked(f.read()))
        spoken = dictionary(klipper, room)
        try:
            done = subprocess.run([sys.executable, __file__, "--run", os.path.join(klipper, "klippy"),
                                   at["printer.cfg"], "-i", at["program.gcode"], "-o", at["serial"], "-l", at["log"],
                                   "-d", spoken], capture_output=True, text=True, timeout=LONGEST)
        except subprocess.TimeoutExpired:
            with open(at["log"]) as f:
                sys.stderr.write(f"Klipper does not end within {LONGEST} s; its log ends: {f.read()[-500:]}\n")
            sys.exit(1)
        with open(at["log"]) as f:
            log = f.read()
        wrong = re.findall(r"^(?:ERROR|Traceback|.*!! |.*Unknown command|.*Must home|.*Move out of range).*", log, re.M)
        marks = [float(line.split()[1]) for line in done.stdout.split("\n") if line.startswith("mark ")]
        if wrong or len(marks) != 3:
            sys.stderr.write("\n".join(wrong[:5] or [log[-300:], done.stderr[-1000:], f"{len(marks)} marks"]) + "\n")
            sys.exit(1)
        return marks[1] - marks[0], steps(klipper, spoken, at["serial"])


def steps(klipper, spoken, serial):
    """Per motor, by the pin that steps it."""
    said = subprocess.run([sys.executable, os.path.join(klipper, "klippy", "parsedump.py"), spoken, serial],
                          capture_output=True, text=True).stdout
    motor, count = {}, {}
    for line in said.split("\n"):
        words = dict(w.split("=", 1) for w in line.split()[1:] if "=" in w)
        if line.startswith("config_stepper "):
            motor[words["oid"]] = words["step_pin"].split("gpio")[-1].lstrip("c0hip/") or "0"
        if line.startswith("queue_step "):
            count[words["oid"]] = count.get(words["oid"], 0) + int(words["count"])
    names = {"0": "x", "10": "y", "20": "z", "30": "e", "40": "tilt", "50": "turn", "66": "e1"}
    return {names.get(pin, pin): count.get(oid, 0) for oid, pin in motor.items()}


if __name__ == "__main__":
    if sys.argv[1:2] == ["--run"]:
        run_klippy(sys.argv[2], sys.argv[3:])
        sys.exit(0)
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    took, motors = plan(sys.argv[1], dict(a.split("=", 1) for a in sys.argv[2:]))
    print("\t".join([f"{took:.3f}"] + [f"{name} {n}" for name, n in sorted(motors.items())]))
