#!/usr/bin/env bats
# postproc from the outside: whole chains, every machine, faults, and an independent interpreter where there is one.

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR"
    flat_box_stl > part.stl
    slice part.stl | regions | sequence | fill | link3d > part.toolpath
}

setup() { cd "$BATS_FILE_TMPDIR"; }

# Fails if the pattern is found: "! grep" alone would not fail a test.
absent() {
    if grep "$@"; then return 1; fi
}

machines="marlin klipper reprapfirmware linuxcnc cellink-inkredible bio-x syringe clay concrete pellet linuxcnc-xyzac linuxcnc-xyzbc linuxcnc-head-table linuxcnc-head-head polar-xzbc open5x-duet klipper-xyzac fibre-marlin fibre-xyzac"

@test "every machine gives a whole program, silently" {
    for m in $machines; do
        postproc --machine $m part.toolpath -o $m.nc 2> $m.err
        [ ! -s $m.err ]
        tail -n 1 $m.nc | grep -q 'end of program, [1-9][0-9]* moves'
        head -n 1 $m.nc | grep -q "filum program for '$m'"
    done
}

@test "robots get programs in their own languages" {
    for m in kuka-krl abb-rapid ur; do
        postproc --machine $m part.toolpath -o $m.txt 2> $m.err
        [ ! -s $m.err ]
        grep -q "filum program for '$m'" $m.txt
        tail -n 6 $m.txt | grep -q 'end of program, [1-9][0-9]* moves'
        absent -E '[0-9]e[-+]?[0-9]' <(grep -E '^(LIN|MoveL|movel)' $m.txt)
    done
    [ "$(grep -c '^LIN' kuka-krl.txt)" -eq "$(grep -c '^movel' ur.txt)" ]
}

@test "no number has an exponent and no line is longer than LinuxCNC takes" {
    for m in $machines; do
        postproc --machine $m part.toolpath > $m.nc
        sed -e 's/;.*//' -e 's/(.*)//' $m.nc | absent -E '[0-9][eE][-+]?[0-9]'
        [ "$(awk '{ if (length > n) n = length } END { print n }' $m.nc)" -lt 255 ]
    done
}

@test "equal work gives equal bytes, and the end says how it was made but not where" {
    slice part.stl | regions | sequence | fill | link3d | postproc > a.gcode
    mkdir -p elsewhere
    cp part.stl elsewhere/other.stl
    (cd elsewhere && slice other.stl | regions | sequence | fill | link3d | postproc --machine marlin -o ../b.gcode)
    cmp a.gcode b.gcode
    grep -q '^; - slice --layer-height=0.2' a.gcode
    grep -q '^; - postproc --machine=marlin (profile [0-9a-f]\{16\}) --place=center' a.gcode
    absent "$BATS_FILE_TMPDIR\|other.stl" b.gcode
}

@test "the head tells time and material" {
    postproc part.toolpath > a.gcode
    grep -q '^;TIME:[1-9]' a.gcode
    used=$(sed -n 's/^; filament used \[mm\] = //p' a.gcode)
    laid=$(sed -e 's/;.*//' a.gcode | awk '/^M83/ && ++n == 2 { on = 1 } on && match($0, /E-?[0-9.]+/) { s += substr($0, RSTART + 1, RLENGTH - 1) } END { print s }')
    # all but the last retraction of 2 mm
    awk -v a="$used" -v b="$laid" 'BEGIN { d = a - (b + 2); exit !(d < 0.006 && d > -0.006) }'
}

@test "a toolpath cut short gives no program and no file" {
    size=$(stat -c %s part.toolpath)
    for n in 0 7 15 60 $((size / 2)) $((size - 1)); do
        head -c $n part.toolpath > cut.toolpath
        run postproc cut.toolpath -o cut.gcode
        [ "$status" -eq 4 ]
        [ ! -e cut.gcode ]
        postproc cut.toolpath > out.txt 2> err.txt || true
        [ ! -s out.txt ]
        grep -q '^postproc: ' err.txt
    done
    [ -z "$(ls | grep '\.part' || true)" ]
}

@test "a full disk is an I/O error" {
    [ -w /dev/full ] || skip "no /dev/full"
    run bash -c 'postproc part.toolpath > /dev/full'
    [ "$status" -eq 5 ]
}

@test "another payload is bad input" {
    slice part.stl > part.layers
    run postproc part.layers
    [ "$status" -eq 3 ]
}

@test "an unknown machine is a usage error that lists the known" {
    run postproc --machine nosuch part.toolpath
    [ "$status" -eq 2 ]
    [[ "$output" == *"unknown machine 'nosuch'; known are "* ]]
    for name in "$(dirname "$(command -v postproc)")"/../share/filum/profiles/*.toml; do
        [[ "$output" == *[\ ,]"$(basename "$name" .toml)"[,\ ]* ]]
    done
}

@test "profiles are found by path and in FILUM_PROFILES" {
    mkdir -p mine
    postproc --machine marlin part.toolpath > a.gcode
    cat > mine/own.toml <<'TOML'
name = "own"
[bed]
x = [0, 50]
y = [0, 50]
z = [0, 50]
[extrusion]
kind = "filament"
diameter = 1.75
[templates]
start = "M104 S{temp}"
[values]
temp = 199
TOML
    postproc --machine ./mine/own.toml part.toolpath > b.gcode
    FILUM_PROFILES=nosuchfolder:mine postproc --machine own part.toolpath > c.gcode
    cmp b.gcode c.gcode
    grep -q '^M104 S199$' b.gcode
    grep -q '^; - postproc --machine=own (profile ' b.gcode
    absent 'mine' b.gcode
    postproc --machine ./mine/own.toml --set temp=222 part.toolpath | grep -q '^M104 S222$'
    run postproc --machine ./mine/none.toml part.toolpath
    [ "$status" -eq 5 ]
    [[ "$output" == *"'./mine/none.toml'"* ]]
    echo '[beds]' >> mine/own.toml
    run postproc --machine ./mine/own.toml part.toolpath
    [ "$status" -eq 3 ]
    [ "$output" = "postproc: cannot use profile './mine/own.toml', line 13, key 'beds': there is no such key" ]
}

@test "a wrong --set is a usage error that names it" {
    for s in feeds.baed=3 feeds.bead=fast feeds.bead=900 nonsense bed.x=3; do
        run postproc --set $s part.toolpath
        [ "$status" -eq 2 ]
        [[ "$output" == "postproc: cannot set '"* ]]
    done
}

@test "a part beyond the bed is an error with the place, and nothing is written" {
    cat > small.toml <<'TOML'
name = "small"
[bed]
x = [0, 15]
y = [0, 15]
z = [0, 15]
[extrusion]
kind = "volume"
TOML
    run postproc --machine small.toml part.toolpath -o big.gcode
    [ "$status" -eq 1 ]
    [[ "$output" == "postproc: cannot print on layer "*" at x "*"'small' reaches x 0 to 15, and the toolpath is "*" mm in x"* ]]
    [ ! -e big.gcode ]
}

@test "a bead above the limit is an error with the place" {
    run postproc --set limits.section=0.05 part.toolpath
    [ "$status" -eq 1 ]
    [[ "$output" == "postproc: cannot print on layer "*" at x "*"a bead of "*"is above the 0.05 mm2"* ]]
}

@test "absolute and relative programs lay the same" {
    total() { sed -n 's/^; filament used \[mm\] = //p' "$1"; }
    postproc part.toolpath > rel.gcode
    postproc --set extrusion.mode=absolute part.toolpath > abs.gcode
    [ "$(total rel.gcode)" = "$(total abs.gcode)" ]
    [ "$(sed 's/ E.*//' rel.gcode | grep -c '^G1 [XY]')" -eq "$(sed 's/ E.*//' abs.gcode | grep -c '^G1 [XY]')" ]
    grep -q '^M82$' abs.gcode
    absent '^M82$' rel.gcode
}

@test "LinuxCNC's own interpreter accepts the linuxcnc program" {
    command -v rs274 > /dev/null || skip "rs274 is not installed (Debian: linuxcnc-uspace)"
    cat > machine.ini <<'INI'
[EMC]
VERSION = 1.1
[RS274NGC]
PARAMETER_FILE = p.var
[KINS]
KINEMATICS = trivkins coordinates=XYZA
JOINTS = 4
[TRAJ]
COORDINATES = XYZA
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
[EMCIO]
TOOL_TABLE = t.tbl
INI
    echo 'T1 P1 Z0 D0.4' > t.tbl
    : > p.var
    postproc --machine linuxcnc part.toolpath > part.ngc
    rs274 -g -i machine.ini -t t.tbl -v p.var part.ngc canon.txt
    grep -q 'PROGRAM_END' canon.txt
    # every straight move arrives: a G1 with a coordinate is one STRAIGHT_FEED
    [ "$(grep -c STRAIGHT_FEED canon.txt)" -eq "$(grep -c '^G1 ' part.ngc)" ]
}

@test "LinuxCNC's own interpreter accepts programs of machines with rotary axes, in both forms" {
    command -v rs274 > /dev/null || skip "rs274 is not installed (Debian: linuxcnc-uspace)"
    rs274_files
    for machine in linuxcnc-xyzac linuxcnc-xyzbc; do
        for numbers in tip joints; do
            postproc --machine $machine --set kinematics.numbers=$numbers part.toolpath > part.ngc
            rs274 -g -i axes.ini -t t.tbl -v p.var part.ngc canon.txt
            [ "$(grep -c STRAIGHT_FEED canon.txt)" -eq "$(grep -c '^G1 ' part.ngc)" ]
        done
    done
}
