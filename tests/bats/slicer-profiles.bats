#!/usr/bin/env bats
# The printer and the G-code of a slicer's profile in the program.

bats_require_minimum_version 1.5.0

setup() {
    PATH="$(cd "$(dirname "$(command -v slice)")" && pwd):$PATH" # a relative entry must outlive the cd
    presets="$(cd "${FILUM_SOURCE:-$BATS_TEST_DIRNAME/../..}" && pwd)/tests/presets"
    cd "$BATS_TEST_TMPDIR" || return 1
    awk 'BEGIN { for (i = 0; i < 8; i++) print "v", 20 * (i % 2), 20 * (int(i / 2) % 2), 2 * int(i / 4)
        print "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6" }' > box.obj
}

# parts FILE: what the profile wrote into a program: its start, what stands between layers, its end; without comments,
# fan and progress.
parts() {
    awk '/^; prusaslicer_config = begin/ { exit } { line[++n] = $0 }
        /^;LAYER_CHANGE/ { if (!first) first = n } /^;TYPE:Custom/ { last = n }
        END { for (i = 1; i <= n; i++) {
            if (i == first) print "; layers"
            if (i == last && last > first) print "; end"
            text = line[i]; sub(/;.*/, "", text); gsub(/[ \t]+/, " ", text); sub(/^ /, "", text); sub(/ $/, "", text)
            split(text, word, " ")
            if (text == "" || word[1] ~ /^(M73|M106|M107|M486|M204)$/ || text ~ /^G1 [EF]/) continue
            if (i >= first && i < last && word[1] !~ /^(M104|M109|M140|M190|M117|M900|G10)$/) continue
            print text } }' "$1"
}

@test "fourteen profiles, every construct of the macro language: the program that PrusaSlicer makes" {
    local ini name failed=0
    for ini in "$presets"/*.ini; do
        name=$(basename "$ini" .ini)
        filum print box.obj --load "$ini" -q -o "$name.gcode"
        grep -v '^; z' "$presets/$name.program" | grep -Ev '^(M204|G1 [EF])' > wanted
        parts "$name.gcode" > got
        diff wanted got || { echo "$name differs"; failed=1; }
    done
    [ "$failed" -eq 0 ]
}

# start FILE: all commands before the first layer. end FILE: those behind the last bead, up to Filum's own lines.
start() { awk '/^;LAYER_CHANGE/ { exit } { sub(/;.*/, ""); gsub(/[ \t]+$/, ""); sub(/^[ \t]+/, "") } $0 != ""' "$1"; }
end() { awk '/^;/ && !/^;TYPE:Custom/ { if ($0 ~ /^; made by/) exit; next } { sub(/;.*/, ""); gsub(/[ \t]+$/, ""); sub(/^[ \t]+/, "") }
    /^G1 .*X.*E[0-9.]/ { n = 0; next } $0 != "" { line[n++] = $0 } END { for (i = 0; i < n; i++) print line[i] }' "$1"; }

@test "twelve presets of OrcaSlicer and Bambu Studio, every construct: start and end as their sources say, by hand" {
    local machine filament failed=0
    for machine in heats-by-macro marlin-two bambu-like conditions arithmetic texts lists variables reprapfirmware \
        klipper-plain no-limits bambu-plates; do
        filament=base
        case $machine in heats-by-macro | marlin-two | bambu-like) filament=warm ;; esac # chamber, pressure advance, fans
        filum print box.obj --load "$presets/orca/machine/$machine.json" --load "$presets/orca/process/fast.json" \
            --load "$presets/orca/filament/$filament.json" -q -o "$machine.gcode"
        { start "$machine.gcode"; echo ...; end "$machine.gcode" | grep -vE '^(G1 E-|G1 X.* E-|M73)'; } > got
        diff "$presets/orca/$machine.program" got || { echo "$machine differs"; failed=1; }
    done
    [ "$failed" -eq 0 ]
    [ "$(grep -c '^TAKE_FRAME' heats-by-macro.gcode)" -eq 10 ] # a picture of each layer
    grep -q '^G1 E-0.4 F1800' marlin-two.gcode                 # half of the retraction, then the wipe
    grep -qE '^G1 X[-0-9.]+ E-0.4 F6750' marlin-two.gcode
}

@test "start codes of several filaments stay apart, and a machine without a filament says so" {
    printf '{"type": "machine", "name": "two", "printable_area": ["0x0","90x0","90x90","0x90"], "machine_start_gcode": "G28"}' > m.json
    printf '{"type": "filament", "name": "f", "filament_start_gcode": ["M117 a, b\\nM900 K0.1", "M117 c"], "nozzle_temperature": ["200","210"]}' > f.json
    filum print box.obj --load m.json --load f.json -q -o two.gcode
    grep -qx 'M117 a, b' two.gcode
    run ! grep -q '^M117 c' two.gcode
    run --separate-stderr filum print box.obj --load m.json -o one.gcode
    [[ "$status" -eq 0 && "$stderr" == *"no filament in the files"* ]]
}

@test "a fault in a profile's G-code is an error with its line, before anything is computed" {
    printf 'start_gcode = G28\\nM104 S[nozzle_heat]\nbed_shape = 0x0,200x0,200x200,0x200\n' > x.ini
    run --separate-stderr filum print box.obj --load x.ini -o x.gcode
    [ "$status" -eq 3 ]
    [[ "$stderr" == *"cannot use start_gcode: line 2, column 7: 'nozzle_heat' is no known name"* ]]
    [ ! -e x.gcode ]
    printf 'start_gcode = G28\ngcode_flavor = sailfish\n' > x.ini
    run --separate-stderr filum print box.obj --load x.ini -o x.gcode
    [ "$status" -eq 3 ]
    [[ "$stderr" == *"gcode_flavor 'sailfish': Filum writes no programs for it"* ]]
}

@test "--machine and --temperature win over the profile; a dry run makes the same program" {
    filum print box.obj --load "$presets/heats-itself.ini" -q -o a.gcode
    filum print box.obj --load "$presets/heats-itself.ini" -q --dry-run > line
    [[ "$(head -n 1 line)" == "filum settings --machine "*" > ./slicer-machine.toml" ]]
    bash line > b.gcode
    cmp <(grep -v '^;' a.gcode) <(grep -v '^;' b.gcode)
    filum print box.obj --load "$presets/heats-itself.ini" -q --temperature 230 --first-layer-temperature 240 -o c.gcode
    grep -qx 'M109 S240' c.gcode
    run --separate-stderr filum print box.obj --load "$presets/heats-itself.ini" --machine klipper -o d.gcode
    [[ "$stderr" == *"the printer of --load (its G-code, bed and firmware) is not used: --machine is klipper"* ]]
    run ! grep -q 'G1 X60 E9 F900' d.gcode # the purge line of the profile
}

@test "the part stands in the middle of the profile's bed, and not off a round one" {
    filum print box.obj --load "$presets/klipper.ini" -q -o k.gcode # origin in the middle
    awk '/^;LAYER_CHANGE/ { on = 1 } on && /^G1 X/ { x = substr($2, 2) + 0; if (x < -11 || x > 11) exit 1 }' k.gcode
    printf 'start_gcode = G28\nbed_shape = ' > round.ini
    awk 'BEGIN { for (i = 0; i < 48; i++) printf "%s%.3fx%.3f", i ? "," : "", 13 * cos(i * 0.1308997), 13 * sin(i * 0.1308997); print "" }' >> round.ini
    run --separate-stderr filum print box.obj --load round.ini -o r.gcode # its corners are 14 mm from the middle
    [ "$status" -ne 0 ]
    [[ "$stderr" == *"off the bed"* ]]
}

@test "firmware retraction, and two parts apart" {
    { cat "$presets/plain-marlin.ini"; echo 'use_firmware_retraction = 1'; } > fw.ini
    filum print box.obj --copies 2 --load fw.ini -q -o fw.gcode
    grep -q '^G10 ; retract' fw.gcode
    grep -q '^G11 ; unretract' fw.gcode
    run ! grep -q '^G1 E-' fw.gcode
}

@test "printers of PrusaSlicer's bundles get its start and its end" {
    command -v prusa-slicer > /dev/null || skip "PrusaSlicer is not installed"
    [ -d /usr/share/PrusaSlicer/profiles ] || skip "PrusaSlicer's bundles are not installed"
    "$presets/judge" out --every 97
}
