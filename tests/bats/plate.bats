#!/usr/bin/env bats
# Several parts on one bed.

load common.bash

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    box_stl > flat.stl
    # parts of other shapes: the same box, scaled by its placement, as meshes of their own
    python3 - <<'END'
import math, struct
def prism(name, ring, h):
    n, t = len(ring), []
    cx, cy = sum(p[0] for p in ring) / n, sum(p[1] for p in ring) / n
    for i in range(n):
        a, b = ring[i], ring[(i + 1) % n]
        t += [((cx, cy, 0), (*b, 0), (*a, 0)), ((cx, cy, h), (*a, h), (*b, h)),
              ((*a, 0), (*b, 0), (*b, h)), ((*a, 0), (*b, h), (*a, h))]
    with open(name, "wb") as f:
        f.write(b"\0" * 80 + struct.pack("<I", len(t)))
        for tri in t: f.write(struct.pack("<12fH", 0, 0, 0, *[c for p in tri for c in p], 0))
def regular(n, r): return [(r * math.cos(2 * math.pi * k / n), r * math.sin(2 * math.pi * k / n)) for k in range(n)]
for n in range(3, 14): prism(f"prism{n}.stl", regular(n, 4 + n % 5), 2 + n)
END
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

strokes() { grep -o -m 1 'strokes = [0-9]*' "$1" | tail -c +11; }

@test "twelve unlike parts: as many strokes as each by itself, all on the bed" {
    sum=0
    for part in flat.stl prism*.stl; do
        filum print "$part" -q -o one.gcode
        sum=$((sum + $(strokes one.gcode)))
    done
    filum print flat.stl prism*.stl -q -o plate.gcode
    [ "$(strokes plate.gcode)" -le "$sum" ]
    slice flat.stl prism*.stl -q | peek --text > told
    [ "$(grep -c ' object ' told)" -eq 12 ]
    grep -q ' object prism7 ' told
}

@test "a part on a plate is the part alone, moved" {
    area() { slice "$@" -q | regions -q | peek | awk '$1 == "area" { print $2 }'; }
    one=$(area prism5.stl)
    four=$(area prism5.stl --copies 4)
    python3 -c "assert abs(4 * $one - $four) < 1e-3 * $four, ($one, $four)"
}

@test "outlines give way to what the machine lays too wide" {
    lowest() { slice prism5.stl -q "$@" | regions -q | peek --text | sed -n 's/^region .* area \([0-9.]*\) parent.*/\1/p' | head -n 1; }
    plain=$(lowest)
    foot=$(lowest --elephant-foot 0.2)
    wide=$(lowest --xy-compensation 0.1)
    python3 -c "assert $foot < $plain < $wide, ($foot, $plain, $wide)"
    grown=$(lowest --shrinkage 2)
    python3 -c "assert abs($grown - $plain / 0.98 ** 2) < 1e-2 * $plain, ($grown, $plain)"
    run slice prism5.stl --hole-compensation 0.1 -o made.layers
    [[ $output == *"--hole-compensation has no effect: no layer has a hole"* ]]
}

@test "what finds no room is refused, with how much" {
    run slice flat.stl --scale 10 --copies 9
    [ "$status" -eq 3 ]
    [[ $output == *"parts find no room on the bed of 'marlin', 220 x 220 mm"* ]]
}

@test "parts nearer than the head is wide are told" {
    run slice prism9.stl prism12.stl --apart 3 -o near.layers
    [ "$status" -eq 0 ]
    [[ $output == *"nearer than the head is wide"* ]]
    run slice prism9.stl prism12.stl -o far.layers
    [ "$status" -eq 0 ]
    [ -z "$output" ]
    run slice prism9.stl --apart 3 -o one.layers
    [ "$status" -eq 0 ]
    [[ $output == *"--apart has no effect"* ]]
}

@test "a print may wait, change its temperature, stand higher, show itself, and name its parts" {
    box_stl > tall.stl
    filum print tall.stl prism12.stl --scale 1,1,4 --machine klipper -q --pause-at 10 --by-layer 15:nozzle_temp=195 \
        --z-offset 0.05 --thumbnails 32x24 -o told.gcode
    [ "$(grep -c '^PAUSE' told.gcode)" -eq 1 ]
    [ "$(grep -c '^M104 S195' told.gcode)" -ge 1 ]
    [ "$(grep -c '^EXCLUDE_OBJECT_DEFINE' told.gcode)" -eq 2 ]
    [ "$(grep -c '^EXCLUDE_OBJECT_START' told.gcode)" -eq "$(grep -c '^EXCLUDE_OBJECT_END' told.gcode)" ]
    grep -q '^M73 P100 R0' told.gcode
    grep -q 'Z0.25' told.gcode
    # nothing below the tenth layer comes behind the pause
    sed -n '/^PAUSE/,$ s/^;LAYER://p' told.gcode | sort -n | head -n 1 | grep -qx 10
    sed -n '/thumbnail begin/,/thumbnail end/ s/^; //p' told.gcode | sed '1d;$d' | base64 -d | head -c 8 | grep -q PNG
}

@test "a part is cut, or gone on with" {
    layers() { slice prism12.stl -q "$@" | peek | awk '$1 == "layers" { print $2 }'; }
    [ "$(layers)" -eq 70 ]
    [ "$(layers --cut-below 4)" -eq 50 ]
    [ "$(layers --cut-above 4)" -eq 20 ]
    [ "$(layers --from-layer 60)" -eq 10 ]
    slice prism12.stl -q --from-layer 60 | peek --text | grep -q '^layer index 0 z 12.2 '
    slice prism12.stl -q --cut-below 4 | peek --text | grep -q '^layer index 0 z 0.2 '
    run slice prism12.stl --from-layer 70
    [ "$status" -eq 3 ]
}

@test "a stroke begins where it is asked to" {
    begins() { slice flat.stl -q | regions | sequence | fill | link3d "$@" | peek --text | grep -A 3 -m 1 '^span' | sed -n 3p; }
    [ "$(begins --seam 0,0)" != "$(begins --seam 9,9)" ]
    [ -n "$(begins --seam back)" ]
    run link3d --seam left
    [ "$status" -eq 2 ]
}

@test "parts are turned only if they find no place as they are" {
    cd "$BATS_TEST_TMPDIR"
    part() { "$FILUM_SOURCE"/examples/scaffold/make-part block "$1" "$2" 1 "$3"; }
    part 210 70 bar.stl
    slice bar.stl --copies 2 --machine marlin --notes all -o two.layers 2> err
    run -1 grep -q turned err
    part 140 70 short.stl # on 220 x 220 mm four of them go with one upright beside three, five never
    slice short.stl --copies 4 --machine marlin --notes all -o four.layers 2> err
    grep -q "parts-turned" err
    whole() { regions -q "$1" | peek | awk '$1 == "area" { print $2 }'; }
    slice short.stl -o one.layers
    python3 -c "assert abs(4 * $(whole one.layers) - $(whole four.layers)) < 1, 'parts lie over each other'"
    expect 3 slice short.stl --copies 5 --machine marlin
}
