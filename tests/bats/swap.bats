#!/usr/bin/env bats
# A stage in another language: examples/swap-a-stage.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    source_tree=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    # The interpreter that knows protobuf: Debian's, even where another one comes first.
    for python in python3 /usr/bin/python3; do
        "$python" -c 'import google.protobuf, numpy' 2> /dev/null && break
        python=
    done
    [[ -n $python ]] || skip "no python3-protobuf, python3-numpy"
    printf '#!/bin/sh\nPYTHONDONTWRITEBYTECODE=1 PYTHONPATH="%s/python" exec "%s" "%s/examples/swap-a-stage/walls" "$@"\n' \
        "$FILUM_BUILD" "$python" "$source_tree" > stage
    chmod +x stage
    ask_all
    make_inputs
    ./stage < sequenced > walls.paths
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "its stream is whole, and tells who made it from what" {
    expect 0 peek --check walls.paths
    expect 0 peek walls.paths
    [[ $out =~ payload\ +Paths && $out =~ run\ 3\ +walls\ 1\ after\ 2 ]]
    [[ $out =~ curve\ +5 && $out == *'walls: look: inside left empty: 5 cases'* ]]
}

@test "the chain prints with it" {
    slice part.stl | regions | sequence | ./stage | link3d | postproc > part.gcode
    [[ $(grep -c '^G1 ' part.gcode) -ge 20 ]]
    link3d walls.paths | peek --check
}

@test "the beads lie half a width inside the box" {
    peek walls.paths > got
    grep -qE '^x +0\.2 to 8\.8 mm$' got
    grep -qE '^y +0\.2 to 8\.8 mm$' got
}

@test "it refuses what the others refuse, with the same codes" {
    expect 3 ./stage < Layers
    expect 3 ./stage < part.stl
    expect 4 ./stage < /dev/null
    size=$(stat -c %s sequenced)
    for at in 10 100 $((size / 2)) $((size - 1)); do
        head -c "$at" sequenced > short
        expect 4 ./stage < short
        complaint walls
        cp "$BATS_TEST_TMPDIR/out" left
        expect 4 peek --check left
        cp sequenced flipped
        flip flipped "$at"
        expect '3|4' ./stage < flipped
    done
}

@test "equal work gives equal bytes" {
    ./stage < sequenced | cmp - walls.paths
}
