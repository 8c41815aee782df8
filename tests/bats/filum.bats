#!/usr/bin/env bats
# The front command.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    ask_all
    box_stl > part.stl
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "filum STAGE is the stage" {
    filum slice part.stl > a
    slice part.stl > b
    cmp a b
    expect 2 filum slice --no-such-option
    complaint slice
}

@test "filum list names every stage with what it reads and writes" {
    expect 0 filum list
    [[ $out =~ slice\ +file\ -\>\ Layers && $out =~ fill\ +Regions\ -\>\ Paths ]]
}

@test "unknown commands, and none at all, end with 2" {
    expect 2 filum
    complaint filum
    expect 2 filum no-such-stage
    complaint filum
    expect 2 filum ../bin/slice
    expect 2 filum list extra
    expect 2 filum help no-such-stage
}

@test "filum help explains stages and itself" {
    expect 0 filum help slice
    [[ $out == 'slice - '* ]]
    expect 0 filum help
    [[ $out == 'filum - '* ]]
    expect 0 filum help print
    [[ $out == 'usage: filum print'* ]]
}

@test "filum print is the pipeline by hand" {
    filum print part.stl -o a.gcode
    slice part.stl | regions | sequence | fill | link3d | postproc > b.gcode
    cmp a.gcode b.gcode
    filum print < part.stl > c.gcode
    cmp a.gcode c.gcode
}

@test "options go to every stage that has them, --STAGE.OPTION to one" {
    expect 0 filum print part.stl --layer-height 0.25 --bead-width=0.5 --fill.bead-width 0.6 --dry-run
    [[ $out =~ slice\ --layer-height=0.25 ]]
    [[ $out =~ regions\ --bead-width=0.5\  ]]
    [[ $out =~ fill\ --bead-width=0.5\ --bead-width=0.6 ]]
    filum print part.stl --layer-height 0.25 --bead-width=0.5 > a.gcode
    filum print part.stl --layer-height 0.25 --bead-width=0.5 --dry-run | bash > b.gcode
    cmp a.gcode b.gcode
}

@test "filum print refuses what no stage knows" {
    expect 2 filum print part.stl --no-such-option 3
    complaint filum
    expect 2 filum print part.stl --slice.pattern spiral
    expect 2 filum print part.stl other.stl
    expect 2 filum print part.stl --layer-height
    expect 2 filum print part.stl -o
    expect 2 filum print part.stl --layer-height=-1
    complaint slice
}

@test "filum print: files with odd names" {
    cp part.stl "a part's name.stl"
    filum print "a part's name.stl" -o 'out put.gcode'
    [[ -s 'out put.gcode' ]]
    filum print "a part's name.stl" --dry-run | bash | cmp - 'out put.gcode'
}

@test "filum env puts the stages on the PATH" {
    front=$(command -v filum)
    # shellcheck disable=SC2016
    out=$(env -i HOME=/ PATH=/usr/bin:/bin bash -c 'eval "$("$1" env)" && slice part.stl | peek --check && echo fine' - "$front")
    [[ $out == fine ]]
}
