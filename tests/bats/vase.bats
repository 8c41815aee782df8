#!/usr/bin/env bats
# Vases: a floor and one bead in a helix, from solid and hollow parts; where they end, and what is said then.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    export FILUM_SOURCE=${FILUM_SOURCE:-$(cd "$BATS_TEST_DIRNAME/../.." && pwd)}
    "$FILUM_SOURCE/tests/parts/make-vase" solid 1 solid.stl
    "$FILUM_SOURCE/tests/parts/make-vase" cup 1 cup.stl
    boxes fork.stl 0,0,0,20,10,4 0,0,4,6,10,8 14,0,4,20,10,8           # two towers on a base
    boxes pot.stl 0,0,0,20,2,4 0,18,0,20,20,4 0,2,0,2,18,4 18,2,0,20,18,4 # a tube: a hole from the bed on
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

value() { awk -v name="$1" '$1 == "fact" && $3 == name { print $4 }'; }
area_of_layer() { peek --text "$1" | sed -n "s/^region .* layer $2 .* area \([0-9.]*\) .*/\1/p"; }

@test "vases of many shapes, solid and hollow, are one stroke with a bead as wide as asked and a level edge" {
    run "$FILUM_SOURCE/tests/parts/random-vase" 1 "${FILUM_VASES:-8}"
    echo "$output"
    [[ $status == 0 ]]
}

@test "a solid vase and a cup of the same shape give the same program but for their floors" {
    for part in solid cup; do
        filum print $part.stl --vase -q -o $part.gcode
        "$FILUM_SOURCE/scripts/gcode-strokes" $part.gcode | awk -F'\t' 'NR == 2 { exit !($2 == 1 && $3 == 0) }'
    done
    [[ $(slice -q cup.stl | regions -q | vase -q | value vase-turns) == "$(slice -q solid.stl | regions -q | vase -q | value vase-turns)" ]]
}

@test "a floor is solid where the cup is hollow, and keeps a hole that begins on the bed" {
    slice -q cup.stl | regions -q -o cup.regions
    vase -q --bottom 12 cup.regions -o cup.vase # deeper than the cup's own floor
    slice -q solid.stl | regions -q -o solid.regions
    python3 -c "assert abs($(area_of_layer cup.vase 11) - $(area_of_layer solid.regions 11)) < 0.5"
    slice -q pot.stl | regions -q | vase -q --bottom 3 -o pot.vase
    python3 -c "assert abs($(area_of_layer pot.vase 2) - (400 - 256)) < 1"
    [[ $(peek --text pot.vase | grep -c 'area kind sparse') == 17 ]]
}

@test "where a part branches the vase ends, and what is left out is told" {
    filum print fork.stl --vase -o fork.gcode 2> said
    [[ $(< said) == *"[vase-ends]"* && $(< said) == *"480 mm3"* ]]
    [[ $(tail -n 1 fork.gcode) == *"end of program"* ]]
    run filum print fork.stl --vase --bottom 20 -o no.gcode
    [[ $status == 3 && $output == *"cannot make a vase of the part"* && ! -e no.gcode ]]
}

@test "what has no effect in a vase is told; --walls 2 goes there and back" {
    filum print solid.stl --vase --infill 20% --dry-run > line 2> said
    [[ $(< line) == *"| vase | sequence"*"--lift=helical"* && $(< line) != *skins* ]]
    [[ $(< said) == *"no effect of --infill"* ]]
    filum print solid.stl --vase --walls 2 --dry-run > line
    [[ $(< line) == *"| vase --walls=2 |"*"--lift=ramp"* ]]
    [[ $(filum print solid.stl --dry-run --walls 3 --infill 20%) != *"vase"* ]]
    [[ $(filum print solid.stl --dry-run --walls 3) == *"| skins --walls=3 |"* ]]
    slice -q solid.stl | regions -q | vase --walls 2 -q | sequence | fill | link3d --lift ramp -q -o two.toolpath
    [[ $(peek two.toolpath | value strokes) == *1* ]]
}

@test "several vases on a bed are a stroke each" {
    filum print solid.stl --copies 2 --vase -q -o two.gcode
    "$FILUM_SOURCE/scripts/gcode-strokes" two.gcode | awk -F'\t' 'NR == 2 { exit $2 != 2 }'
}

@test "beads are as wide as the nozzle of the machine, and layers half as high, unless something else is asked" {
    asked() { filum print solid.stl --dry-run -o x.gcode "$@"; }
    for vase in "" --vase; do
        [[ $(asked --machine clay $vase) == *"--layer-height=1.5"*"--bead-width=3 "* ]]
        [[ $(asked --machine pellet $vase --layer-height 0.8) == *"--layer-height=0.8"*"--bead-width=2 "* ]]
        run -0 asked --machine concrete $vase --bead-width 20
        [[ $output == *"--bead-width=20"* && $output != *layer-height* ]]
        run -0 asked --machine mk3s $vase
        [[ $output != *bead-width* && $output != *layer-height* ]]
    done
}

@test "infill and supports of wide beads have lengths in proportion" {
    asked() { filum print solid.stl --dry-run -o x.gcode "$@"; }
    run -0 asked --machine clay --infill 20%
    [[ $output == *"--bridge=15 "*"--solid-below=3937.5 "* ]]
    run -0 asked --machine concrete --support --bead-width 20
    [[ $output == *"--support-spacing=100 "*"--beside=50 "* ]]
    run -0 asked --machine clay --support --infill 20% --beside 4 --bridge 8
    [[ $output == *"--bridge=8 "*"--beside=4 "*"--support-spacing=18.75 "* ]]
    run -0 asked --machine clay --brim 9
    [[ $output != *support-spacing* && $output != *bridge* ]]
    for machine in clay pellet concrete; do
        scale=10
        if [[ $machine == concrete ]]; then scale=60; fi
        filum print solid.stl --scale $scale --machine "$machine" --infill 20% --support -q -o wide.gcode
        filum print solid.stl --scale $scale --machine "$machine" --infill 20% -q -o wide.gcode
    done
}

@test "clay in one stroke: cold, nothing taken back, each layer as long as asked" {
    filum print solid.stl --vase --scale 4 --machine clay --nozzle 3 --layer-height 1.5 -q -o clay.gcode
    [[ $(grep -cE '^(M104|M109|M140|M190|M106)' clay.gcode) == 0 ]]
    [[ $(grep -cE '^G1 .*E-' clay.gcode) == 0 ]]
    "$FILUM_SOURCE/scripts/gcode-strokes" --layer-height 1.5 clay.gcode | awk -F'\t' 'NR == 2 { exit !($2 == 1 && $3 == 0) }'
    for least in 0 60; do
        filum print solid.stl --vase --scale 4 --machine clay --nozzle 3 --layer-height 1.5 --least-layer-time $least -q -o $least.gcode
    done
    # the time that the moves of a layer take by their feeds
    slowest() {
        python3 - "$1" << 'END'
import math, sys
at, feed, layer, times = [0.0] * 3, 1.0, None, {}
for line in open(sys.argv[1]):
    if line.startswith(";LAYER:"): layer = int(line[7:])
    words = line.split(";")[0].split()
    if not words or words[0] not in ("G0", "G1"): continue
    to = list(at)
    for w in words[1:]:
        if w[0] in "XYZ": to["XYZ".index(w[0])] = float(w[1:])
        if w[0] == "F": feed = float(w[1:]) / 60
    if layer is not None and any(w[0] == "E" for w in words): times[layer] = times.get(layer, 0) + math.dist(at, to) / feed
    at = to
print(min(times.values()))
END
    }
    python3 -c "assert $(slowest 60.gcode) > 59 > $(slowest 0.gcode)"
}
