#!/usr/bin/env bats
# The real controller, simulated: LinuxCNC runs a path on a dome on a trunnion machine, in both forms of program.

load common

machine=$BATS_TEST_DIRNAME/../linuxcnc

# A piece of a sphere of radius 60 beside its pole, 20 mm wide.
dome() {
    awk 'BEGIN {
        n = 24; s = 20
        printf "OFF\n%d %d 0\n", (n + 1) * (n + 1), 2 * n * n
        for (j = 0; j <= n; j++) for (i = 0; i <= n; i++) {
            x = s * (i / n - 0.5); y = s * (j / n - 0.5) + 8
            printf "%.6f %.6f %.6f\n", x, y, sqrt(3600 - x * x - y * y) - 40
        }
        for (j = 0; j < n; j++) for (i = 0; i < n; i++) {
            a = j * (n + 1) + i
            printf "3 %d %d %d\n3 %d %d %d\n", a, a + 1, a + n + 2, a, a + n + 2, a + n + 1
        }
    }'
}

# simulate FORM: runs FORM.ngc in a folder of that name, as a user that LinuxCNC accepts.
simulate() {
    mkdir -p "$1/home"
    cp "$machine"/{machine.ini,sampler.hal,drive.py} "$1"
    cp -r "$subs" "$1/subs"
    cp "$1.ngc" "$1/program.ngc"
    printf 'T1 P1 Z0 D0.4 ;nozzle\nT2 P2 Z0 D1 ;fibre\n' > "$1/tool.tbl"
    local as=()
    if [ "$(id -u)" -eq 0 ]; then
        chmod -R a+rwX .
        as=(setpriv --reuid=65534 --regid=65534 --clear-groups)
    fi
    (cd "$1" && HOME=$PWD/home RTAPI_FIFO_PATH=$PWD/home/.rtapi_fifo timeout 150 "${as[@]}" linuxcnc -r machine.ini) \
        > "$1.log" 2>&1 || true
    [ -s "$1/done" ] || { cat "$1.log"; false; }
}

teardown() { [ -z "${room:-}" ] || rm -rf "$room"; }

# A room for the controller's user to work in, whatever TMPDIR is; skips where there is no controller.
enter_room() {
    command -v linuxcnc > /dev/null || skip "LinuxCNC is not installed (Debian: linuxcnc-uspace)"
    [ -z "${FILUM_SANITIZED:-}" ] || skip "the same programs as without sanitizers"
    subs=$(find /usr/share/doc/linuxcnc -type d -path '*table-rotary-tilting/remap_subs' 2> /dev/null | head -n 1)
    [ -n "$subs" ] || skip "LinuxCNC came without its examples, which hold M428 and M429"
    room=$(mktemp -d --tmpdir=/tmp)
    cd "$room"
    dome > dome.off
}

@test "a surface path runs alike as tip numbers and as joints" {
    enter_room
    geodesic dome.off --source plane:0,1,0,8 | surfpath fina --spacing 5 --layer-height 0.1 --min-radius 5 > dome.toolpath
    for form in tip joints; do # half a degree of the axis, 20 mm from the joint, would be 0.17 mm of that one
        postproc --path-tolerance 0.001 --axis-tolerance 0.01 --machine linuxcnc-xyzac --set "kinematics.numbers=$form,tolerance=0.005,extrusion.kind=valve,\
extrusion.on=M62 P0,extrusion.off=M63 P0,feeds.bead=15,feeds.first_layer=15,kinematics.tilt_point_y=20,\
kinematics.tilt_point_z=10,kinematics.turn_speed_deg=60,kinematics.tilt_speed_deg=40" dome.toolpath > $form.ngc
        simulate $form
    done
    "$machine/compare.py" tip/samples.txt joints/samples.txt | tee result
    awk '{ exit !($1 <= 0.02 && $3 <= 0.05) }' result
}

# Its samples are the controller's own milliseconds, however fast this machine is.
@test "the print time said is the controller's, on a machine as fast as the profile says" {
    enter_room
    as_the_ini="motion.acceleration=2000,motion.travel_acceleration=2000,kinematics.tilt_speed_deg=40,\
kinematics.turn_speed_deg=60,kinematics.tilt_acceleration_deg=600,kinematics.turn_acceleration_deg=900"
    geodesic dome.off --source plane:0,1,0,8 | surfpath --quiet fina --spacing 5 --layer-height 0.1 --min-radius 5 > rows.toolpath
    geodesic dome.off --source boundary | surfpath --quiet geo-contour --spacing 3 --layer-height 0.1 > rings.toolpath
    for path in rows rings; do
        for form in tip joints; do
            postproc --machine linuxcnc-xyzac --job job.tsv --set "kinematics.numbers=$form,extrusion.kind=valve,\
extrusion.on=M62 P0,extrusion.off=M63 P0,feeds.bead=15,feeds.first_layer=15,kinematics.tilt_point_y=20,\
kinematics.tilt_point_z=10,$as_the_ini" $path.toolpath > $path-$form.ngc
            simulate $path-$form
            said=$(awk -F '\t' '$1 == "job.print_time_s" { print $2 }' job.tsv)
            "$machine/bead-time.py" $path-$form/samples.txt | awk -v said="$said" -v of=$path-$form \
                '{ print of ": said " said " s, bead on " $1 " s"; exit !(said > 0.9 * $1 && said < 1.1 * $1) }'
        done
    done
}

# The output of the cutter is sampled with the joints: it comes on where the program says, and the machine stands still.
@test "the fibre is cut where the program says, by a machine that stands still" {
    enter_room
    geodesic dome.off --source plane:0,1,0,8 | surfpath --quiet fina --spacing 6 --layer-height 0.1 --min-radius 5 |
        assemble --tools 1 > dome.toolpath
    postproc --machine fibre-xyzac --set "kinematics.numbers=joints,tolerance=0.05,extrusion.kind=valve,\
extrusion.on=M62 P2,extrusion.off=M63 P2,fibre.cut_to_nozzle=8,fibre.anchor=1,fibre.anchor_feed=5,fibre.feed=15,\
fibre.tail_feed=15,kinematics.tilt_point_y=20,kinematics.tilt_point_z=10,kinematics.turn_speed_deg=60,\
kinematics.tilt_speed_deg=40" dome.toolpath > joints.ngc
    simulate joints
    "$machine/cutter.py" joints.ngc joints/samples.txt | tee result
    awk '{ exit !($1 <= 0.001 && $2 <= 0.001) }' result
}
