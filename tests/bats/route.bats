#!/usr/bin/env bats
# route: travels go past what stands there, the tool leans where that frees the head; collide agrees.
# shellcheck disable=SC2154

load common

# Towers of 12 mm and a low slab beyond; a thin wall and an arch as meshes.
setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    boxes towers.stl 0,0,0,4,4,12 15,0,0,19,4,12 30,0,0,34,4,12
    boxes clamp.stl 6,-10,0,13,14,25
    boxes beside.stl -3,-30,0,-2,34,20
    boxes arch.stl 2.6,-12,0,9,-10,20 2.6,14,0,9,16,20 2.6,-12,20,9,16,22
    boxes above.stl -30,-30,9,60,60,10
    # finished one after the other, as a slim head may
    slice towers.stl | regions | sequence --head none | fill | link3d --head none > towers.toolpath
    # fewer layers, where every bead's lean is looked for
    slice --layer-height 0.4 towers.stl | regions | sequence --head none | fill | link3d --head none > coarse.toolpath
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

slim=(--cone-height 40 --cone-angle 20 --carriage 6,6)
said() { peek "$1" | sed -n "s/^fact  *$2: $3 \([^ ]*\).*/\1/p"; }
beads() { peek --text "$1" | awk '/^[a-z]/ {on = /^span/ && !/travel/} on'; }

@test "travels between towers go over or around, shorter than they were, and collide finds nothing" {
    expect 0 route towers.toolpath "${slim[@]}" --bed --output routed
    [[ -z $err ]]
    collide routed "${slim[@]}" --bed --output checked
    [[ $(said checked collide colliding-moves) == 0 ]]
    [[ $(said routed route travels) == 2 && $(said routed route colliding-moves) == 0 ]]
    awk -v a="$(said routed route travel-length-before)" -v b="$(said routed route travel-length)" 'BEGIN { exit !(b < a) }'
    cmp <(beads towers.toolpath) <(beads routed)
    [[ $(said routed route clearance-beads) == "$(said checked collide clearance-beads)" ]]
}

@test "a clamp between two towers is passed, which the travels as they were would meet" {
    # the towers themselves are free of it for a needle only
    needle=(--cone-height 60 --cone-angle 2 --carriage 0,0 --fixture clamp.stl)
    expect 1 collide towers.toolpath "${needle[@]}"
    [[ $err == *' meets the fixture on a travel'* ]]
    expect 0 route towers.toolpath "${needle[@]}" --output routed
    collide routed "${needle[@]}" > checked
    [[ $(said checked collide colliding-moves) == 0 ]]
    (($(said routed route travels-over) + $(said routed route travels-around) > 0))
}

@test "postproc follows them as they are: the program is as free, and as short" {
    head=("${slim[@]}" --bed)
    route towers.toolpath "${head[@]}" > routed
    postproc --machine marlin --place as-is routed > routed.gcode
    collide --program routed.gcode --machine marlin "${head[@]}" --format tsv > figures.tsv
    [[ $(awk -F '\t' '$1 == "collisions" {print $2}' figures.tsv) == 0 ]]
    # each place of each travel, one after the other, with nothing between but what stays where it is
    peek --text routed > text
    python3 - << 'END'
import re

travels, on = [], False
for line in open("text"):
    if line[0] != " ":
        on = line.startswith("span role travel")
        if on:
            travels.append([])
    elif on:
        travels[-1].append(tuple(float(v) for v in line.split()[:3]))
at, places = {"X": 0, "Y": 0, "Z": 0}, []
for line in open("routed.gcode"):
    if re.match("G[01] ", line):
        at.update((w[0], float(w[1:])) for w in line.split(";")[0].split()[1:] if w[0] in at)
        if not places or places[-1] != tuple(at.values()):
            places.append(tuple(at.values()))
assert len(travels) == 2 and all(len(t) > 3 for t in travels), travels
for t in travels:
    same = lambda a, b: max(abs(u - v) for u, v in zip(a, b)) < 1e-3
    assert any(all(map(same, places[i:i + len(t)], t)) for i in range(len(places) - len(t) + 1)), t
END
}

@test "the tool leans away from a wall, as much as it has to, on machines that can" {
    head=(--cone-height 60 --cone-angle 30 --carriage 0,0 --part beside.stl)
    expect 1 route coarse.toolpath "${head[@]}" --output leaning
    complaint route
    [[ $err == *' nozzle meets the part'*' x '*', y '*', z '* && ! -e leaning ]]
    expect 0 route coarse.toolpath "${head[@]}" --tilt 30 --leaning leaning.tsv --output leaning
    [[ -z $err ]]
    collide leaning "${head[@]}" > /dev/null
    [[ $(head -n 1 leaning.tsv) == "stroke	layer	length	leaning	most	mean" && $(wc -l < leaning.tsv) -ge 2 ]]
    awk -v most="$(said leaning route tilt-max)" 'BEGIN { exit !(most > 1 && most < 30) }'
    postproc --machine linuxcnc-xyzac leaning > leaning.ngc
    expect 2 route coarse.toolpath --machine marlin --tilt 10
    [[ $err == *'three axes'* ]]
}

@test "from below the rim of an arch over it to the other side" {
    head=(--cone-height 60 --cone-angle 2 --carriage 0,0 --part arch.stl)
    expect 1 route coarse.toolpath "${head[@]}"
    expect 0 route coarse.toolpath "${head[@]}" --tilt 25 --output arch
    [[ $(said arch route travels-over) -ge 1 && $(said arch route leaning-strokes) == 1 ]]
    collide arch "${head[@]}" | peek | grep -q 'colliding-moves 0'
    # the nozzle's flat beside the rim, the tower's farthest bead 0.2 mm inside it: no less, and no more than 2 degrees above
    awk -v most="$(said arch route tilt-max)" 'BEGIN {
        least = atan2(4 - 0.2 + 0.2 - 2.6, 20 - 12) * 57.29578
        exit !(most > least - 1 && most < least + 3)
    }'
}

@test "what cannot be freed is an error with the place, or a note" {
    head=(--cone-height 40 --cone-angle 20 --carriage 20,20)
    expect 1 route towers.toolpath "${head[@]}" --part above.stl --output result
    complaint route
    [[ $err == *' meets the part'*'(layer '* && ! -e result ]]
    expect 0 route towers.toolpath "${head[@]}" --part above.stl --strict=false --places places.tsv --output result
    [[ $err == 'route: will fail: the head meets the part '* ]]
    [[ $(said result route colliding-moves) == "$(tail -n +2 places.tsv | cut -f 1 | sort -un | wc -l)" ]]
    cmp <(beads towers.toolpath) <(beads result)
}

@test "the same bytes for any number of threads" {
    for t in 1 2 8; do
        route coarse.toolpath "${slim[@]}" --part beside.stl --tilt 20 --strict=false --quiet --threads $t > threads.$t
    done
    cmp threads.1 threads.2
    cmp threads.1 threads.8
}

@test "options that make no sense are usage errors" {
    for bad in '--lift -1' '--lift nan' '--tilt -1' '--tilt 81' '--tilt-rate 0' '--step 0' '--margin -1' '--part a,,b' \
        '--machine no-such' '--set travel.lift=1'; do
        # shellcheck disable=SC2086
        expect 2 route $bad towers.toolpath
        complaint route
    done
    expect 5 route --part no-such-file towers.toolpath
    expect 3 route --part towers.toolpath towers.toolpath
}
