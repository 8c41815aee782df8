#!/usr/bin/env bats
# Tools with layers of their own height: order, supports, volumes, and what is refused.
# shellcheck disable=SC2154

load common

setup() { cd "$BATS_TEST_TMPDIR" || exit 1; }

@test "random stacks of bodies: beads of each height lie on material, none is struck, volumes and bounds hold" {
    local height=(0.4 0.6)
    for seed in $(seq 1 "${FILUM_BODIES:-3}"); do
        local h=${height[seed % 2]}
        echo "seed $seed height $h"
        "$FILUM_SOURCE/tests/bodies/make-bodies" stacks stacks "$seed"
        rm -rf kept
        filum print -q --body stacks/a.stl --body "stacks/b.stl:tool=1,width=0.7,height=$h" --set 'tools.change=T{tool_no},limits.section=2' --keep kept -o stacks.gcode
        collide kept/*.toolpath > /dev/null
        peek --json kept/*.toolpath > stacks.json
        "$FILUM_SOURCE/tests/bodies/read-heights" stacks.json > stacks.tsv
        cat stacks.tsv
        [[ $(awk '$1 != "heights" { sum += $2 } END { print sum }' stacks.tsv) == 0 ]]
        awk -v h="$h" '$1 == "heights" && $2 == 0 && $NF > 0.201 { exit 1 } $1 == "heights" && $2 == 1 && $NF > h + 0.001 { exit 1 }' stacks.tsv
        "$FILUM_SOURCE/tests/bodies/check-volumes" stacks stacks.gcode
        peek --text kept/*-sequence.* | awk '/^fact stage sequence/ { value[$5] = $7 }
            END { exit value["planned-strokes"] < value["lower-bound"] || value["tool-changes"] < value["tool-changes-bound"] }'
    done
}

@test "slanted borders: the finer body follows the steps of the coarser one, and both keep their volumes" {
    export LAYERS=20
    "$FILUM_SOURCE/tests/bodies/make-bodies" twisted twisted
    for bodies in "--body twisted/a.stl --body twisted/b.stl:tool=1,width=0.6,height=0.4" \
        "--body twisted/a.stl:tool=0,width=0.6,height=0.4 --body twisted/b.stl:tool=1"; do
        # shellcheck disable=SC2086
        filum print -q $bodies --set 'tools.change=T{tool_no}' -o twisted.gcode
        "$FILUM_SOURCE/tests/bodies/check-volumes" twisted twisted.gcode
    done
}

@test "the core in every second layer: half of its layers, and strokes at the bound" {
    LAYERS=20 "$FILUM_SOURCE/tests/bodies/make-bodies" core-ring cr
    slice -q --body cr/a.stl --body cr/b.stl:tool=1,width=0.6,height=0.4 | regions -q -o cr.regions
    sequence --report cr.regions -o cr.sequence 2> report
    cat report
    [[ $(awk '/planned-strokes/ { print $NF }' report) == $(awk '/lower-bound/ { print $NF }' report) ]]
    # as many layers of the core as half of the others, each with its own height
    peek --text cr.regions | awk '/^region/ { for (i = 1; i < NF; i++) if ($i == "tool") t = $(i + 1); else if ($i == "height") h = $(i + 1)
        n[t]++; if (t == 1 && h != 0.4) exit 1 } END { exit n[0] != 20 || n[1] != 10 }'
    [[ $(peek --text cr.regions | grep -c ' layers 2 ') == 10 ]]
}

@test "what is left at the top of a body is one lower layer, and a first layer of its own height stays" {
    boxes a.stl 0,0,0,10,10,1
    boxes b.stl 10,0,0,20,10,1
    slice -q --body a.stl --body b.stl:tool=1,width=0.8,height=0.4 | regions -q -o ab.regions
    [[ $(peek --text ab.regions | grep ' tool 1 ' | grep -o ' height [0-9.]*' | xargs) == "height 0.4 height 0.4 height 0.2" ]]
    slice -q --first-layer-height 0.3 --body a.stl --body b.stl:tool=1,width=0.8,height=0.4 | regions -q -o ab.regions
    [[ $(peek --text ab.regions | grep ' tool 1 ' | grep -o ' height [0-9.]*' | xargs) == "height 0.3 height 0.4 height 0.2" ]]
    # the strands of a scaffold still turn from layer to layer of their body
    slice -q --body a.stl --body b.stl:tool=1,width=0.8,height=0.4 | regions -q | sequence -q | fill -q --pattern scaffold --spacing 2 -o ab.paths
    peek --json ab.paths > ab.json
    python3 - << 'END'
import json
turns = []
for frame in json.load(open("ab.json"))["frames"]:
    if frame.get("tool") == 1 and "curves" in frame:
        p = frame["curves"][0]["points"]
        along = [sum(abs(c[i + 1] - c[i]) for i in range(len(c) - 1)) for c in (p["x"], p["y"])]
        turns.append(along[0] > along[1])
assert turns == [True, False, True], turns
END
}

@test "heights that are no whole number of layers are refused, and so are stages that cannot use them" {
    boxes a.stl 0,0,0,10,10,1
    boxes b.stl 10,0,0,20,10,1
    run slice --body a.stl --body b.stl:tool=1,height=0.5 -o bad.layers
    [[ $status -eq 2 && $output == *"0.4 or 0.6 mm"* ]]
    run slice --body a.stl --body b.stl:tool=1,height=0.1 -o bad.layers
    [[ $status -eq 2 && $output == *"is 0.2 mm"* && $output == *--layer-height* ]]
    run slice --adaptive --body a.stl --body b.stl:tool=1,height=0.4 -o bad.layers
    [[ $status -eq 2 && $output == *--adaptive* ]]
    run slice --body a.stl:tool=1,height=0.4 --body b.stl:tool=1,height=0.6 -o bad.layers
    [[ $status -eq 2 && $output == *"layers of 0.4 mm already"* ]]
    slice -q --body a.stl --body b.stl:tool=1,width=0.8,height=0.4 | regions -q -o ab.regions
    run supports --support ab.regions -o bad.regions
    [[ $status -eq 3 && $output == *"several heights"* ]]
    run vase ab.regions -o bad.regions
    [[ $status -eq 3 && $output == *"several heights"* ]]
    supports -q --brim 2 ab.regions | skins -q --infill 30% | sequence -q | fill -q | link3d -q | collide > /dev/null
    run slice --body b.stl:tool=1,width=0.3,height=0.4 -o b.layers
    run regions b.layers
    [[ $status -eq 2 && $output == *"bead is no higher than it is wide"* ]]
}
