#!/usr/bin/env bats
# Continuous fibre from the outside: finished programs, read by a script that knows nothing of the planner.

load common

report=$BATS_TEST_DIRNAME/../../scripts/fibre-report

# A core of plastic, and fibre on a dome over a wedge: rows in one stroke, and ten lines of 22 to 60 mm.
setup_file() {
    cd "$BATS_FILE_TMPDIR"
    flat_box_stl > part.stl
    slice part.stl | regions | sequence | fill | link3d > core.toolpath
    awk 'BEGIN {
        n = 20; s = 40
        printf "OFF\n%d %d 0\n", (n + 1) * (n + 1), 2 * n * n
        for (j = 0; j <= n; j++) for (i = 0; i <= n; i++) {
            y = s * (j / n - 0.5); x = (s + y) * (i / n - 0.5)
            printf "%.6f %.6f %.6f\n", x, y, sqrt(3600 - x * x - y * y) - 40
        }
        for (j = 0; j < n; j++) for (i = 0; i < n; i++) {
            a = j * (n + 1) + i
            printf "3 %d %d %d\n3 %d %d %d\n", a, a + 1, a + n + 2, a, a + n + 2, a + n + 1
        }
    }' > dome.off
    geodesic dome.off --source plane:0,1,0,0 | surfpath fina --spacing 5 --layer-height 0.1 --min-radius 5 > patch.toolpath
    geodesic dome.off --source plane:1,0,0,0 | surfpath --quiet ortheo --spacing 4 --layer-height 0.1 > lines.toolpath
    assemble --tools 0,1 core.toolpath patch.toolpath lines.toolpath > job.toolpath
    assemble --tools 1 lines.toolpath > lines.fibre
}

setup() {
    cd "$BATS_FILE_TMPDIR"
    export FILUM_PROFILES=$BATS_TEST_DIRNAME/../../lib/motion/machine/profiles
}

@test "every cut of a job of plastic and fibre comes where the tail needs it, on every kind of machine" {
    for with in fibre-marlin fibre-xyzac "fibre-xyzac --set kinematics.numbers=joints,kinematics.tilt_point_y=20" \
        "fibre-xyzac --set fibre.mode=push,fibre.ratio=1.05,fibre.tension_every=50" \
        "fibre-xyzac --set fibre.cut_to_nozzle=12.5"; do
        [ "$with" != fibre-marlin ] || flat=--flatten # its nozzle stays upright on the dome
        postproc --short drop --machine $with $flat job.toolpath > job.nc 2> said
        flat=
        "$report" --machine $with job.nc > table
        cat table
        [ "$(grep -c '^tail  ' table)" -eq 1 ]
    done
    [ ! -s said ] # 12.5 mm: every line can be laid
    grep -q '^strokes 11, cuts 11, ' table
}

@test "robots cut there, too" {
    local with="fibre.cut_to_nozzle=45,fibre.tool=1,fibre.on=LAY,fibre.off=LAID,fibre.cut=CUT,tools.change=T{tool_no}"
    for m in kuka-krl abb-rapid ur; do
        postproc --short drop --machine $m --set "$with" job.toolpath > job.$m
        FILUM_PROFILES=$FILUM_PROFILES "$report" --machine $m --set "$with" job.$m
    done
}

@test "the script finds a cut that comes too late, and a stroke that nothing cuts" {
    postproc --flatten --machine fibre-marlin --set fibre.cut_to_nozzle=30 --short drop job.toolpath > job.nc
    run "$report" --machine fibre-marlin job.nc
    [ "$status" -eq 1 ]
    [[ "$output" =~ "the cut comes "(29\.99|30)[0-9.]*" mm before the end, not 45" ]] # the words of a program are rounded
    grep -v '^M42' job.nc > uncut.nc
    run "$report" --machine fibre-marlin --set fibre.cut_to_nozzle=30 uncut.nc
    [ "$status" -eq 1 ]
    [[ "$output" == *"0 cuts"* ]]
}

@test "a stroke that is too short is an error with its place, or left out and told" {
    run postproc --machine fibre-xyzac --set fibre.cut_to_nozzle=40 lines.fibre -o lines.ngc
    [ "$status" -eq 1 ]
    [ ! -e lines.ngc ]
    [[ "$output" == "postproc: cannot lay 5 fibre strokes below the 40 mm of fibre.least_path: the shortest, 22.2"*" mm, begins on layer 0 at x "*"leave them out by --short drop" ]]
    postproc --machine fibre-xyzac --set fibre.cut_to_nozzle=40 --short drop lines.fibre > lines.ngc 2> said
    grep -q '^postproc: look: 5 strokes of fibre too short for the cutter were dropped (153 mm)' said
    grep -q 'note: look: postproc: 5 strokes of fibre too short for the cutter were dropped' lines.ngc
    "$report" --machine fibre-xyzac --set fibre.cut_to_nozzle=40 lines.ngc | grep -q '^strokes 5, cuts 5'
}

@test "the job is told tool by tool, in the head and in a table" {
    postproc --machine fibre-xyzac --set fibre.cut_to_nozzle=12.5 --job job.tsv job.toolpath > job.ngc
    grep -q '^( tool 0: ' job.ngc
    grep -q '^( tool 1 \[fibre\]: ' job.ngc
    grep -q '^( job: ' job.ngc
    of() { awk -F'\t' -v key="$1" '$1 == key { print $2 }' job.tsv; }
    [ "$(of tool.1.cuts)" = "$(grep -c '^M64 P0' job.ngc)" ]
    awk -v a="$(of tool.0.laid_mm)" -v b="$(of tool.1.laid_mm)" -v c="$(of job.laid_mm)" \
        'BEGIN { exit !(b > 100 && a + b - c < 0.11 && c - a - b < 0.11) }'
    awk -v m="$(of tool.1.material_mm3)" -v g="$(of tool.1.mass_g)" \
        'BEGIN { d = m * 1.4 / 1000 - g; exit !(g > 0 && d < 0.001 && d > -0.001) }'
}

@test "metrics counts the same from the toolpath alone" {
    set_to=fibre.cut_to_nozzle=12.5,fibre.feed=8
    postproc --flatten --machine fibre-marlin --set $set_to --job job.tsv job.toolpath > job.gcode
    metrics --machine fibre-marlin --set $set_to --format tsv job.toolpath > metrics.tsv
    for name in strokes cuts laid_mm print_time_s mass_g; do
        for group in tool.0 tool.1 job; do
            awk -F'\t' -v key="$group.$name" '$1 == key { v[++k] = $2 }
                END { exit !(k == 2 && v[1] > 0 + (key ~ /cuts/ ? -1 : 0) && (v[1] - v[2]) ^ 2 <= 1e-4 * (v[1] + 0.05) ^ 2) }' \
                job.tsv metrics.tsv || { echo "$group: $name"; cat job.tsv metrics.tsv; false; }
        done
    done
    # who has no fibre head is told of no cuts, and one tool alone needs no table
    metrics --format tsv job.toolpath | awk -F'\t' '$1 == "tool.1.cuts" { seen = $2 == 0 } END { exit !seen }'
    run metrics core.toolpath
    [[ "$output" != *"tool 0"* ]]
    metrics --machine fibre-marlin --set fibre.cut_to_nozzle=40 --format tsv lines.fibre |
        awk -F'\t' '$1 == "job.too_short" { n = $2 } END { exit !(n == 5) }'
}

@test "a toolpath of two tools needs a machine that has them" {
    run postproc --machine marlin job.toolpath
    [ "$status" -eq 3 ]
    [[ "$output" == *"cannot take tool 1"*"'marlin' has no codes to change tools"* ]]
    run assemble --tools 0.5 core.toolpath
    [ "$status" -eq 2 ]
    run assemble --tools -1 core.toolpath
    [ "$status" -eq 2 ]
}

@test "LinuxCNC's own interpreter accepts programs of fibre, in both forms" {
    command -v rs274 > /dev/null || skip "rs274 is not installed (Debian: linuxcnc-uspace)"
    rs274_files
    for form in tip joints; do
        postproc --machine fibre-xyzac --set kinematics.numbers=$form --short drop job.toolpath > job.ngc
        rs274 -g -i axes.ini -t t.tbl -v p.var job.ngc canon.txt
        [ "$(grep -c STRAIGHT_FEED canon.txt)" -eq "$(grep -c '^G1 ' job.ngc)" ]
        [ "$(grep -c 'SELECT_TOOL(2)\|CHANGE_TOOL(2)\|CHANGE_TOOL' canon.txt)" -ge 2 ]
    done
}

@test "field follows the angle to a reference without a source, as one stroke, and needs stress where that is asked for" {
    geodesic dome.off > dome.surface
    surfpath --quiet field --spacing 4 --min-radius 2 --angle 45 --reference Y dome.surface > ply.toolpath
    surfpath --quiet field --spacing 4 --min-radius 2 --angle 45 dome.surface > other.toolpath
    if cmp -s ply.toolpath other.toolpath; then false; fi
    for one in ply other; do
        [ "$(metrics --surface dome.surface --format tsv $one.toolpath | awk '$1 == "cuts" { print $2 }')" = 0 ]
    done
    run surfpath field --follow stress=1 dome.surface -o none
    [ "$status" -eq 3 ]
    [[ $output == *"the surface carries no tensile stress; run stressfield first"* ]]
    run surfpath field --follow wind=1 dome.surface -o none
    [ "$status" -eq 2 ]
    [[ $output == *"cannot follow 'wind'; --follow knows direction, stress, angle, rim and rings"* ]]
    run surfpath field --reference 0,0,0 dome.surface -o none
    [ "$status" -eq 2 ]
    [[ $output == *"cannot use --reference '0,0,0'"* ]]
}

@test "hybrid lays rings around holes and along rims as one stroke, covers more than whole rings, and opens closed ones" {
    gzip -dc "$FILUM_SOURCE/examples/surfaces/plate-nine-holes.off.gz" | geodesic --source boundary > plate.surface
    figure() { metrics --surface plate.surface --format tsv "$1.toolpath" | awk -v key="$2" '$1 == key { print $2 }'; }
    surfpath --quiet hybrid plate.surface > hybrid.toolpath
    surfpath --quiet geo-contour plate.surface > rings.toolpath
    awk -v a="$(figure hybrid coverage)" -v b="$(figure rings coverage)" 'BEGIN { exit !(a > b + 0.03) }'
    [ "$(figure hybrid cuts)" -le 1 ]
    # field along the same rings covers less, and turns tightly less
    surfpath --quiet field --follow rings=1 plate.surface > gentle.toolpath
    for key in coverage tight_mm; do
        awk -v a="$(figure hybrid $key)" -v b="$(figure gentle $key)" 'BEGIN { exit !(a > b) }'
    done
    gzip -dc "$FILUM_SOURCE/examples/surfaces/pipe-tee.off.gz" | geodesic > tee.surface
    run surfpath --notes all hybrid tee.surface -o tee.toolpath
    [ "$status" -eq 0 ]
    [[ $output == *"1 closed surface was opened along a slit ("*" mm); at "* ]]
    [ "$(metrics --surface tee.surface --format tsv tee.toolpath | awk '$1 == "cuts" { print $2 }')" = 0 ]
    run surfpath-kipping2022 hybrid plate.surface -o none
    [ "$status" -eq 2 ]
}

@test "--strict refuses a path of which too much turns tightly, with a place, and writes nothing" {
    gzip -dc "$FILUM_SOURCE/examples/surfaces/plate-nine-holes.off.gz" | geodesic --source boundary > holes.surface
    run surfpath --quiet hybrid --strict --max-tight 0.001 holes.surface -o strict.toolpath
    [ "$status" -eq 1 ]
    [[ $output == *"raise --max-tight"* && $output == *" at "* ]]
    [ ! -e strict.toolpath ]
    surfpath --quiet hybrid --strict --max-tight 0.5 holes.surface -o strict.toolpath
    [ -s strict.toolpath ]
}

# docs/metrics.md has a table of what surfpath says; the facts themselves carry no meaning.
@test "every fact of surfpath is in the table of docs/metrics.md, and every line of the table is a fact" {
    geodesic --quiet dome.off --remesh 1 --source plane:0,1,0,0 > rows.surface
    geodesic --quiet dome.off --remesh 1 --source point:0,0,20 > point.surface
    geodesic --quiet dome.off --remesh 1 --source boundary > rim.surface
    for with in "fina rows" "fexa rows" "ortheo rows" "geo-spiral point" "geo-fiso rim" "geo-contour rim" "field rim" \
        "hybrid rim" "fina rows --turn-outside 4"; do
        read -r algorithm from options <<< "$with"
        surfpath --quiet "$algorithm" --spacing 2 $options $from.surface > path
        peek path | sed -n 's/^fact *surfpath: \([a-z-]*\) .*/\1/p'
    done | tr - _ | sort -u > said
    awk '/^Facts of `surfpath`/ {on = 1} on && /^## / {exit} on && /^\| `/ {print $0}' \
        "$BATS_TEST_DIRNAME/../../docs/metrics.md" | cut -d'|' -f2 | tr -d ' `' | tr , '\n' | sort > told
    [ "$(wc -l < told)" -gt 20 ]
    diff told said
}
