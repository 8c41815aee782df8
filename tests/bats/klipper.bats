#!/usr/bin/env bats
# The real controller, without hardware: Klipper plans finished programs.  FILUM_KLIPPER names a checkout of it.

load common

plan() { "$BATS_TEST_DIRNAME/../klipper/plan.py" "$@"; }

setup() {
    [ -n "${FILUM_KLIPPER:-}" ] || skip "FILUM_KLIPPER names no checkout of Klipper"
    [ -z "${FILUM_SANITIZED:-}" ] || skip "the same programs as without sanitizers"
    export FILUM_PROFILES=$BATS_TEST_DIRNAME/../../lib/motion/machine/profiles
    cd "$BATS_TEST_TMPDIR"
}

# said SET [KEY=VALUE...]: the print time that postproc says is Klipper's within 5 %.
said() {
    local set_to=$1
    shift
    postproc --machine klipper ${set_to:+--set "$set_to"} --job job.tsv part.toolpath > part.gcode
    plan part.gcode "$@" > real
    awk -F'\t' 'NR == FNR { real = $1; next } $1 == "job.print_time_s" { d = $2 / real - 1; print $2, real; n = 1
        ok = real > 10 && d ^ 2 <= 0.05 ^ 2 } END { exit !(n && ok) }' real job.tsv
}

@test "print times of planar programs are Klipper's" {
    flat_box_stl > part.stl
    slice part.stl | regions | sequence | fill | link3d > part.toolpath
    said ""
    said motion.minimum_cruise_ratio=0,motion.acceleration=8000,motion.travel_acceleration=8000,motion.corner_speed=9 \
        minimum_cruise_ratio=0 max_accel=8000 square_corner_velocity=9
    said feeds.bead=200,limits.flow=40,motion.acceleration=1500,motion.travel_acceleration=1500 max_accel=1500
    said format.arcs=true
    said format.arcs=true,motion.arc_resolution=0.1 resolution=0.1
}

@test "Klipper plans a program for two nozzles, and both extrude" {
    "$BATS_TEST_DIRNAME/../bodies/make-bodies" core-ring inks
    filum print -q --body inks/a.stl --body inks/b.stl:tool=1 --machine klipper-dual -o inks.gcode
    plan inks.gcode tools=2 | tr '\t' '\n' > real
    awk '{ n[$1] = $2 } END { print n["e"], n["e1"]; exit !(n["e"] > 1000 && n["e1"] > 1000) }' real
}

@test "both rotary axes of klipper-xyzac move, by as much as the program says" {
    awk 'BEGIN { n = 12; print "OFF"; printf "%d %d 0\n", (n + 1) ^ 2, 2 * n * n
        for (j = 0; j <= n; j++) for (i = 0; i <= n; i++) {
            x = 20 * (i / n - 0.5); y = 20 * (j / n - 0.5) + 8
            printf "%.6f %.6f %.6f\n", x, y, sqrt(3600 - x * x - y * y) - 40 }
        for (j = 0; j < n; j++) for (i = 0; i < n; i++) { a = j * (n + 1) + i
            printf "3 %d %d %d\n3 %d %d %d\n", a, a + 1, a + n + 2, a, a + n + 2, a + n + 1 } }' > dome.off
    geodesic dome.off --source boundary | surfpath geo-contour --spacing 0.8 --layer-height 0.2 > rings.toolpath
    postproc --machine klipper-xyzac --job job.tsv rings.toolpath > rings.gcode
    plan rings.gcode rotary=a,c > real
    # 16 microsteps of 200 steps for 36 degrees, from 0 to the first place and back to 0
    for axis in A:tilt C:turn; do
        awk -v letter="${axis%:*}" '/^G[01] / { for (k = 2; k <= NF; k++) if (substr($k, 1, 1) == letter) {
                v = substr($k, 2) + 0; d = v - at; sum += d < 0 ? -d : d; at = v } } END { print sum * 3200 / 36 }' \
            rings.gcode > want
        tr '\t' '\n' < real | awk -v name="${axis#*:}" -v want="$(cat want)" '$1 == name { n = $2 }
            END { print n, want; exit !(want > 1000 && n / want < 1.01 && n / want > 0.99) }'
    done
    # nothing crawls, the first travel neither
    awk -F'\t' 'NR == FNR { real = $1; next } $1 == "job.print_time_s" { d = $2 / real - 1; print $2, real
        ok = real > 10 && d ^ 2 <= 0.05 ^ 2 } END { exit !ok }' real job.tsv
}
