#!/usr/bin/env bats
# collide: a toolpath goes on only if the head meets nothing; a finished program gives the same answer.
# shellcheck disable=SC2154

load common

# Towers of 6 mm, 7 mm apart in the gap, each one stroke; a block to stand in the way.
setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    boxes towers.stl 0,0,0,4,4,6 11,0,0,15,4,6
    boxes block.stl 30,-5,0,32,9,20
    slice towers.stl | regions | sequence --head none | fill | link3d --head none > towers.toolpath
    # A piece of a bowl of radius 40 beside its pole, for tilted tools.
    awk 'BEGIN {
        n = 16; s = 16
        printf "OFF\n%d %d 0\n", (n + 1) * (n + 1), 2 * n * n
        for (j = 0; j <= n; j++) for (i = 0; i <= n; i++) {
            x = s * (i / n - 0.5); y = s * (j / n - 0.5) + 14
            printf "%.6f %.6f %.6f\n", x, y, 45 - sqrt(1600 - x * x - y * y)
        }
        for (j = 0; j < n; j++) for (i = 0; i < n; i++) {
            a = j * (n + 1) + i
            printf "3 %d %d %d\n3 %d %d %d\n", a, a + 1, a + n + 2, a, a + n + 2, a + n + 1
        }
    }' > bowl.off
    geodesic bowl.off --source plane:0,1,0,14 | surfpath fina --spacing 2 --layer-height 0.2 --min-radius 2 > bowl.toolpath
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

# figure GROUP NAME < TSV
figure() { awk -F '\t' -v name="$1" '$1 == name {print $2}'; }
said() { peek "$1" | sed -n "s/^fact  *collide: $2 \([^ ]*\).*/\1/p"; }

@test "a toolpath that meets nothing goes on unchanged, with facts" {
    expect 0 collide bowl.toolpath --part bowl.off --output free.toolpath
    [[ -z $err ]]
    cmp <(peek --text bowl.toolpath | sed -n '/^span/,$p') <(peek --text free.toolpath | sed -n '/^span/,$p')
    [[ $(peek --text free.toolpath | grep -c '^span') -gt 0 ]]
    [[ $(said free.toolpath colliding-moves) == 0 && $(said free.toolpath moves) -gt 100 ]]
    awk -v c="$(said free.toolpath clearance-part)" 'BEGIN { exit !(c > 0) }'
    collide free.toolpath | postproc --machine linuxcnc-xyzac > bowl.ngc
    tail -n 1 bowl.ngc | grep -q 'end of program'
}

@test "a head too fat for the gap between towers is refused with the place" {
    expect 1 collide towers.toolpath --cone-height 3 --output fat.toolpath
    complaint collide
    [[ $err == *' carriage meets the beads '*' x '*', y '*', z '* && ! -e fat.toolpath ]]
    expect 1 collide towers.toolpath --cone-angle 120 --carriage 1,1
    [[ $err == *' nozzle meets the beads '* ]]
    collide towers.toolpath --cone-height 30 --cone-angle 20 --carriage 5,5 > /dev/null
    expect 0 collide towers.toolpath --cone-height 3 --strict=false --places places.tsv --output fat.toolpath
    [[ $err == 'collide: will fail: the head meets beads '* ]]
    peek fat.toolpath | grep -q 'note.*head-meets-beads'
    [[ $(said fat.toolpath colliding-moves) == "$(tail -n +2 places.tsv | cut -f 1 | sort -un | wc -l)" ]]
    head -n 1 places.tsv | grep -qx "point	layer	stroke	move	meets	with	clearance	x	y	z	i	j	k"
    awk -F '\t' 'NR > 1 && !($5 == "beads" && $6 == "carriage" && $7 < -0.05) { exit 1 }' places.tsv
    expect 0 render towers.toolpath --collisions places.tsv --cone-height 3 --size 320,160 --output places.png
    [[ -s places.png && -z $err ]]
    expect 2 render towers.toolpath --collisions places.tsv --layer 3
    expect 3 render towers.toolpath --collisions towers.stl
    expect 5 render towers.toolpath --collisions none.tsv
    expect 2 render towers.toolpath --part block.stl
    expect 2 collide towers.toolpath --flat-radius 1e300
}

@test "a fixture beside the part: clearance is what it is" {
    collide towers.toolpath --head none --fixture block.stl | peek | grep -q 'colliding-moves 0'
    # the carriage is 20 mm to either side; the block stands from x = 30
    expect 1 collide towers.toolpath --cone-height 12 --cone-angle 10 --fixture block.stl
    [[ $err == *' carriage meets the fixture '* ]]
    expect 0 collide towers.toolpath --cone-height 12 --cone-angle 10 --carriage 10,10 --fixture block.stl --output free
    reach=$(peek towers.toolpath | sed -n 's/^x .* to \([0-9.]*\) mm/\1/p')
    # places looked at are up to 0.01 mm beside the path's outermost point
    awk -v c="$(said free clearance-fixture)" -v x="$reach" 'BEGIN { d = c - (30 - x - 5); exit !(d >= 0 && d < 0.01) }'
    expect 1 collide towers.toolpath --cone-height 12 --cone-angle 10 --carriage 10,10 --fixture block.stl --margin 12
}

@test "the program gives the answer of the toolpath" {
    head=(--cone-height 30 --cone-angle 30 --carriage 5,5)
    collide towers.toolpath "${head[@]}" --bed > free
    postproc --machine marlin --place as-is towers.toolpath > towers.gcode
    collide --program towers.gcode --machine marlin "${head[@]}" --bed --format tsv > figures.tsv
    [[ $(figure collisions < figures.tsv) == 0 ]]
    awk -v a="$(said free clearance-beads)" -v b="$(figure clearance_beads_mm < figures.tsv)" \
        'BEGIN { d = a - b; exit !(a > 0 && d * d < 0.01) }'
    expect 1 collide --program towers.gcode --machine marlin --cone-height 3
    complaint collide
    [[ $err == *' carriage meets the beads '*'(line '* ]]
}

@test "a tilted path: as toolpath, as tip numbers, as joints" {
    head=(--cone-angle 100 --cone-height 6 --carriage 5,5)
    collide bowl.toolpath --part bowl.off "${head[@]}" > free
    for form in tip joints; do
        postproc --machine linuxcnc-xyzac --place as-is --set "kinematics.numbers=$form,kinematics.tilt_point_z=-9,kinematics.orientation_deg=0.01" \
            bowl.toolpath > $form.ngc
        collide --program $form.ngc --machine linuxcnc-xyzac --set "kinematics.numbers=$form,kinematics.tilt_point_z=-9,kinematics.orientation_deg=0.01" \
            "${head[@]}" --part bowl.off --format tsv > $form.tsv
        [[ $(figure collisions < $form.tsv) == 0 ]]
        for against in part beads; do
            awk -v a="$(said free clearance-$against)" -v b="$(figure "clearance_${against}_mm" < $form.tsv)" \
                'BEGIN { exit !(b >= a - 0.25 && b <= a + 0.25) }' || { echo "$form $against"; said free clearance-$against; cat $form.tsv; false; }
        done
    done
    # the two forms are one way
    awk -v a="$(figure clearance_part_mm < tip.tsv)" -v b="$(figure clearance_part_mm < joints.tsv)" \
        'BEGIN { d = a - b; exit !(d * d < 0.07) }'
}

@test "options that make no sense are usage errors, bad files are told" {
    for bad in '--step 0' '--step nan' '--press -1' '--margin -1' '--program x' '--bead 1,1' '--shift 1,2,3' '--part a,,b' \
        '--machine no-such' '--set travel.lift=1'; do
        # shellcheck disable=SC2086
        expect 2 collide $bad towers.toolpath
        complaint collide
    done
    expect 2 collide --program x --machine marlin towers.toolpath
    expect 5 collide --part no-such-file towers.toolpath
    expect 3 collide --part towers.toolpath towers.toolpath
    printf 'G2 X1 Y1 I1\n' > arc.gcode
    expect 3 collide --program arc.gcode --machine marlin
    complaint collide
    [[ $err == *"'arc.gcode'"*'line 1 '* ]]
    : > empty.gcode
    expect 3 collide --program empty.gcode --machine marlin
    complaint collide
}
