#!/usr/bin/env bats
# How the programs behave as processes: signals, closed descriptors, names, two runs at once.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    box_stl > part.stl
}

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    cp "$BATS_FILE_TMPDIR/part.stl" .
}

@test "a signal leaves neither a folder in TMPDIR nor part of a file" {
    mkdir tmp kept
    for signal in INT TERM HUP; do
        for wait in 0.02 0.1 0.3; do
            # timeout, not the shell, starts it: a shell ignores SIGINT in what it runs in the background
            TMPDIR=$PWD/tmp timeout --signal="$signal" "$wait" \
                filum print part.stl --scale 9 --quiet --keep kept --report page.html -o part.gcode 2> said || true
            sleep 0.3 # the stages end after the front
            left=$(ls tmp; find . -name '*.part*')
            [[ -z $left ]] || { echo "$signal after $wait s left: $left"; false; }
        done
    done
}

@test "no temporary folder where none is needed" {
    TMPDIR=$PWD/none filum print part.stl --quiet -o part.gcode
    [[ -s part.gcode ]]
}

@test "standard input may be closed, as by cron" {
    filum print part.stl --quiet -o part.gcode <&-
    [[ $(tail -n 1 part.gcode) == *"end of program"* ]]
    slice part.stl -o part.layers <&-
    peek --check part.layers
    expect 4 regions -o none <&-
}

@test "an output that is the input is refused" {
    cp part.stl before.stl
    ln part.stl other.stl
    expect 2 filum print part.stl -o other.stl
    [[ $err == *"it is the input"* ]]
    expect 2 slice part.stl -o other.stl
    cmp part.stl before.stl
    slice part.stl -o a.layers
    cp a.layers b.layers
    expect 2 regions a.layers -o ./a.layers
    cmp a.layers b.layers
}

@test "names may have 255 characters" {
    printf -v name 'n%.0s' {1..255}
    slice part.stl -o "$name"
    peek --check "$name"
    [[ -z $(find . -name '*.part*') ]]
}

@test "two prints keep their streams in one folder" {
    for k in 1 2; do filum print part.stl --quiet --keep kept -o $k.gcode & done
    wait
    cmp 1.gcode 2.gcode
    for file in kept/*; do peek --check "$file"; done
    [[ -z $(find kept -name '*.part*') ]]
}

@test "a pipe that does not block is waited for" {
    python3 - << 'END'
import os
import subprocess
import time

def unblocked(pair):
    for fd in pair:
        os.set_blocking(fd, False)
    return pair

subprocess.run(["slice", "part.stl", "--layer-height", "0.02", "-o", "part.layers"], check=True)
layers = open("part.layers", "rb").read()
inside, outside = unblocked(os.pipe()), unblocked(os.pipe())
stage = subprocess.Popen(["regions"], stdin=inside[0], stdout=outside[1], close_fds=True)
os.close(inside[0])
os.close(outside[1])
got = b""
ended = False
while not ended:
    if layers:
        try:
            layers = layers[os.write(inside[1], layers[:9000]):]
        except BlockingIOError:
            pass
        if not layers:
            os.close(inside[1])
    try:
        more = os.read(outside[0], 3000)
        ended = more == b"" and not layers
        got += more
    except BlockingIOError:
        time.sleep(0.001)
assert stage.wait() == 0
assert got == subprocess.run(["regions", "part.layers"], check=True, stdout=subprocess.PIPE).stdout
END
}

@test "a file beyond the limit of ulimit -f is an error like a full disk" {
    slice part.stl --layer-height 0.05 -o whole.layers
    [[ $(stat -c %s whole.layers) -gt 2048 ]]
    for command in 'slice part.stl --layer-height 0.05 -o out.layers' 'filum print part.stl --quiet -o out.gcode'; do
        run -5 bash -c "ulimit -f 1; $command"
        [[ $output == *'File too large'* ]]
        left=$(find . -name 'out.*')
        [[ -z $left ]]
    done
}

@test "a full disk under --keep leaves no program" {
    mkdir kept
    mkdir kept/1-slice.layers # no stream can take this name
    expect '1|5' filum print part.stl --quiet --keep kept -o part.gcode
    [[ ! -e part.gcode ]]
    echo mine > part.gcode
    rmdir kept/1-slice.layers
    expect 2 filum print part.stl --quiet --nonsense -o part.gcode
    [[ $(cat part.gcode) == mine ]]
}

@test "a disk that is really full under --keep, --report or -o leaves no program and no half of a file" {
    mkdir disk
    for option in --keep=disk/kept --report=disk/part.html; do
        for size in 4k 32k; do
            mount -t tmpfs -o "size=$size" tmpfs disk 2> /dev/null || skip "cannot mount a small file system"
            code=0
            filum print part.stl --quiet "$option" -o part.gcode 2> err || code=$?
            left=$(find disk -type f)
            umount disk
            echo "$option $size: $code, left: $left"
            [[ $code == 5 && ! -e part.gcode && -z $left ]]
            grep -qi 'disk\|no space' err
        done
    done
    mount -t tmpfs -o size=4k tmpfs disk
    code=0
    filum print part.stl --quiet --report part.html -o disk/part.gcode 2> err || code=$?
    left=$(find disk -type f)
    umount disk
    [[ $code == 5 && -z $left && ! -e part.html ]]
}

@test "an endless stream is refused at once" { # mesh files may have 4 GiB, which takes too long here
    expect '3|4' timeout 20 regions /dev/zero -o none
}

@test "no stage takes more memory than its help states" {
    python3 - "$FILUM_SOURCE/scripts/peers" "$FILUM_BUILD/bin" <<'END'
import os, sys, types
sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import programs
programs.BIN = sys.argv[2]
import memory, scale, shapes
given = types.SimpleNamespace(out=os.getcwd(), peers=False, repeat=1, table=[])
faults = memory.check_texts() + scale.family("islands", given, [200], shapes.pillars) + \
    scale.family("vertices", given, [4000], shapes.gear)
assert not faults, faults
shapes.cylinders(1, "one.stl")  # many copies: the layers in flight take more than the model
plate = ["slice", "--machine", "large.toml", "--copies", "400", "one.stl", "-o", "plate.layers"]
peak = programs.measure([os.path.join(programs.BIN, plate[0]), *plate[1:]], 1, "plate.log")[2]
assert 30 < peak <= memory.allowed("slice", "one.stl", "plate.layers"), peak
# a stage that takes more is found
memory.STATED["slice"] = (memory.STATED["slice"][0], lambda read, wrote: -20e6)
assert "slice took" in scale.family("layers", given, [50], shapes.tower)[0]
memory.STATED["slice"] = ("nothing at all", None)
assert memory.check_texts() == ["the help of 'slice' does not say 'nothing at all'"]
END
}
