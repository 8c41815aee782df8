#!/usr/bin/env bats
# Settings of slicers' files as those slicers read them, and endings of names.

bats_require_minimum_version 1.5.0

setup() {
    PATH="$(cd "$(dirname "$(command -v slice)")" && pwd):$PATH" # a relative entry must outlive the cd
    cd "$BATS_TEST_TMPDIR" || return 1
    awk 'BEGIN { for (i = 0; i < 8; i++) print "v", 20 * (i % 2), 20 * (int(i / 2) % 2), 20 * int(i / 4)
        print "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6" }' > cube.obj
}

# cm3 FILE: the material of a program.
cm3() { sed -n 's/^; filament used \[cm3\] = //p' "$1"; }

@test "a hollow part without a top is hollow, and an old share is a density" {
    printf 'layer_height = 0.2\nfill_density = 0%%\nperimeters = 2\ntop_solid_layers = 0\nbottom_solid_layers = 3\n' > hollow.ini
    filum print cube.obj --load hollow.ini -q -o hollow.gcode
    awk -v v="$(cm3 hollow.gcode)" 'BEGIN { exit !(v > 1.4 && v < 1.6) }' # PrusaSlicer: 1.53
    printf 'layer_height = 0.2\nfill_density = 0.25\nperimeters = 2\n' > old.ini
    filum print cube.obj --load old.ini -q -o old.gcode
    awk -v v="$(cm3 old.gcode)" 'BEGIN { exit !(v > 3.2 && v < 3.5) }' # PrusaSlicer: 3.44
}

@test "a speed beyond the machine is limited and reported" {
    echo '{"type": "process", "travel_speed": "480", "brim_width": "5"}' > stock.json
    run filum print cube.obj --load stock.json --dry-run
    [ "$status" -eq 0 ]
    [[ "$output" == *"feeds.travel=300"* && "$output" == *"travel_speed = 480 is above the machine's limit"* ]]
    [[ "$output" != *"--brim="* ]]
}

@test "settings are shown in their groups, each key of PrusaSlicer in one" {
    printf 'perimeters = 3\nstart_gcode = G28\\nG1 Z5\npost_process = mine\nbrim_separation = 1\nnotes = mine\nnew_key = 1\n' > x.ini
    run filum settings x.ini
    [ "$status" -eq 0 ]
    [[ "$output" == *"used (2)"*"--walls=3"*"go wrong (1)"*"post_process"*"not used yet (1)"*"not known (1)"*"meaning here (1)"* ]]
    command -v prusa-slicer > /dev/null || skip "PrusaSlicer is not installed"
    prusa-slicer --save full.ini > /dev/null 2>&1
    filum settings full.ini > groups
    run ! grep -q '^not known' groups
}

@test "presets of a bundle are named, and what they inherit is found or named" {
    printf '%s\n' '[printer:*common*]' 'nozzle_diameter = 0.4' 'retract_length = 3' \
        '[printer:Test 0.6 & Co, large]' 'inherits = *common*' 'nozzle_diameter = 0.6' \
        'default_print_profile = usual' '[print:usual]' 'perimeters = 2' '[print:own one]' 'perimeters = 5' > bundle.ini
    run filum print cube.obj --load 'bundle.ini:printer=Test 0.6 & Co, large' --dry-run
    [[ "$status" -eq 0 && "$output" == *"--walls=2"*"travel.retract=3"* && "$output" == *"--bead-width=0.6"* ]]
    run filum print cube.obj --load 'bundle.ini:printer=Test 0.6 & Co, large,print=own one' --dry-run
    [[ "$output" == *"--walls=5"* ]]
    run filum print cube.obj --load 'bundle.ini:printer=Test 0.8' --dry-run
    [[ "$status" -eq 2 && "$output" == *"it has no printer 'Test 0.8'"* ]]
    printf 'perimeters = 2\n' > plain.ini
    run filum print cube.obj --load plain.ini:printer=X --dry-run
    [ "$status" -eq 2 ]
    mkdir process
    echo '{"type": "process", "name": "mine", "inherits": "0.2 Standard", "wall_loops": "3"}' > mine.json
    run filum print cube.obj --load mine.json --dry-run
    [[ "$status" -eq 0 && "$output" == *"'0.2 Standard', which 'mine' inherits from, was not found"* ]]
    echo '{"type": "process", "name": "0.2 Standard", "layer_height": "0.25"}' > 'process/0.2 Standard.json'
    FILUM_PRESETS=$PWD run filum print cube.obj --load mine.json --dry-run
    [[ "$output" != *"not found"* && "$output" == *"--layer-height=0.25"*"--walls=3"* ]]
}

@test "printers are chosen by name, and listed" {
    printf '%s\n' '[printer:Maker One]' 'nozzle_diameter = 0.6' 'default_print_profile = usual' '[print:usual]' \
        'perimeters = 4' '[printer:Maker One XL]' 'nozzle_diameter = 0.8' > maker.ini
    export FILUM_PRESETS=$PWD
    run filum printers maker one
    [[ "$status" -eq 0 && "${#lines[@]}" -eq 2 && "${lines[0]}" == "Maker One "*"maker.ini" ]]
    run filum printers ender
    [[ "$output" == *"ender3"*"Creality Ender 3"* ]]
    run filum print cube.obj --printer 'maker one' --filament petg --dry-run
    [[ "$status" -eq 0 && "$output" == *"--bead-width=0.6"*"--walls=4"*"nozzle_temp=240"* ]]
    run filum print cube.obj --printer mk3s --filament abs --dry-run
    [[ "$status" -eq 0 && "$output" == *"--machine=mk3s"* && "$output" == *"first_bed_temp=100"* ]]
    run filum print cube.obj --printer 'no such' --dry-run
    [ "$status" -eq 2 ]
    for machine in ender3 mk3s mk4 mini voron-2.4 bambu-a1 bambu-p1 bambu-x1 ultimaker-original; do
        filum print cube.obj --printer "$machine" --infill 20 -q -o "$machine.gcode"
        ingest --machine "$machine" "$machine.gcode" | peek --json > /dev/null
    done
}

@test "a vase, and the least time of a layer" {
    printf 'perimeters = 1\nbottom_solid_layers = 3\nspiral_vase = 1\n' > vase.ini
    run filum print cube.obj --load vase.ini --dry-run
    [ "$status" -eq 0 ]
    [[ "$output" == *" vase "*"--bottom=3"*"--lift=helical"* ]]
    printf 'perimeters = 1\nspiral_vase = 0\n' > plain.ini
    run filum print cube.obj --load plain.ini --dry-run
    [[ "$output" != *" vase "* ]]
    printf 'min_fan_speed = 35\nmax_fan_speed = 100\nslowdown_below_layer_time = 40\ncooling = 1\n' > slow.ini
    run filum print cube.obj --load slow.ini --dry-run
    [[ "$output" == *"limits.layer_time=40"* ]]
    sed -i 's/cooling = 1/cooling = 0/' slow.ini
    run filum print cube.obj --load slow.ini --dry-run
    [[ "$output" == *"limits.layer_time=0"* ]]
}

@test "endings mean what they say" {
    for name in x.pdf x.jpg x.3mf x.png x.toolpath x.regions; do
        run filum print cube.obj -o "$name"
        [ "$status" -eq 2 ]
        [ ! -e "$name" ]
    done
    run slice cube.obj -o x.gcode
    [ "$status" -eq 2 ]
    run filum print cube.obj -o x.gcode --picture x.jpg
    [ "$status" -eq 2 ]
    [ ! -e x.gcode ]
}

@test "files of Cura: a profile, a program, and a printer with its start" {
    printf '%s\n' '[general]' 'version = 4' 'name = mine' 'definition = custom' '' '[metadata]' 'type = quality_changes' '' \
        '[values]' 'infill_sparse_density = 15' 'wall_line_count = 3' 'wall_line_width_0 = =line_width + 0.05' \
        'xy_offset = =magic(3)' 'speed_print = 50' > mine.inst.cfg
    run filum settings mine.inst.cfg
    [[ "$status" -eq 0 && "$output" == *"written by Cura"*"used ("*"--walls=3"*"--bead-width=0.45"*"not used yet (1)"*"it calls magic()"* ]]
    zip -q mine.curaprofile mine.inst.cfg 2> /dev/null || python3 -c "
import zipfile
zipfile.ZipFile('mine.curaprofile', 'w').write('mine.inst.cfg')"
    filum print cube.obj --load mine.curaprofile --dry-run 2> said | grep -q -- '--infill=15%.*--walls=3'
    grep -q 'speed_wall_0 = 25' said
    { printf 'G28\n;End of Gcode\n'; sed ':a;N;$!ba;s/\n/\\\\n/g;s/.*/{"global_quality": "&"}/' mine.inst.cfg | fold -w 60 | sed 's/^/;SETTING_3 /'; } > old.gcode
    filum print cube.obj --load old.gcode --dry-run 2> /dev/null | grep -q -- '--infill=15%.*--walls=3'
    mkdir definitions
    cat > definitions/own.def.json <<'EOF'
{"version": 2, "name": "Own", "metadata": {"type": "machine"}, "overrides": {
 "machine_name": {"default_value": "Own"}, "machine_width": {"default_value": 180}, "machine_depth": {"value": "190"},
 "machine_heated_bed": {"default_value": true}, "machine_center_is_zero": {"default_value": true},
 "machine_start_gcode": {"default_value": "G28\nG1 X{machine_width} Y{machine_depth}\n;{unknown}"},
 "machine_end_gcode": {"default_value": "M84 ; [off]"}}}
EOF
    filum print cube.obj --load definitions/own.def.json --load mine.inst.cfg --temperature 222 --first-layer-temperature 231 -q -o own.gcode
    grep -v '^;' own.gcode | sed -n '1,/^G1 X180/p' > start
    diff - start <<'EOF'
M107
M140 S60
M190 S60
M104 S231
M109 S231
G28
G1 X180 Y190
EOF
    grep -q '^;{unknown}$' own.gcode
    grep -q '^M84 ; \[off\]$' own.gcode
    grep -q '^M104 S222' own.gcode
    sed -i 's/;{unknown}/M1 {unknown}/' definitions/own.def.json
    run filum print cube.obj --load definitions/own.def.json -o none.gcode
    [[ "$status" -eq 3 && "$output" == *"'unknown' is no known name"* ]]
}
