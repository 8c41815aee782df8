#!/usr/bin/env bats
# A stage in C++ outside of the tree: examples/swap-a-stage/cpp with the installed headers and libraries.

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    cmake --install "$FILUM_BUILD" --component development --prefix "$PWD/usr" >install.log
    cmake -S "$FILUM_SOURCE/examples/swap-a-stage/cpp" -B own -DCMAKE_PREFIX_PATH="$PWD/usr" -DCMAKE_CXX_FLAGS=-O0 >own.log
    cmake --build own >>own.log
    box_stl >part.stl
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "the check of stages finds no fault in it" {
    run filum check own/walls --as fill
    echo "$output"
    [ "$status" -eq 0 ]
}

@test "the chain prints with it, and its option goes to it" {
    filum print part.stl --stage fill=own/walls --bead-width 0.5 -o part.gcode
    grep -q '^;.*walls --bead-width=0.5' part.gcode
    [ "$(grep -c '^G1 ' part.gcode)" -ge 20 ]
}

@test "installed headers hide protobuf and CLI11" {
    [ -e usr/include/filum/cli/command.hpp ]
    run grep -rlE 'pb\.h|CLI/' usr/include
    [ "$status" -eq 1 ]
}
