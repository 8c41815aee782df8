#!/usr/bin/env bats
# What people ask of filum print in their own words: numbers, names, codes, beds and fans.
# shellcheck disable=SC2154

load common

setup_file() { make_part_and_contracts; }

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "numbers and names as people type them" {
    for typed in 15 15% 0.15; do
        filum print part.stl --infill $typed -q -o "$typed.gcode"
        grep -v '^;' "$typed.gcode" > "$typed.moves"
    done
    cmp 15.moves 15%.moves
    cmp 15.moves 0.15.moves
    filum print part.stl --infill 15 --infill-pattern gyroid --dry-run | grep -q -- '--infill-pattern=wave'
    for name in nozzle nozzle-size nozzle-width nozzle-diameter strand-width bead; do
        filum print part.stl --$name 0.6 --dry-run | grep -q -- '--bead-width=0.6'
    done
}

@test "start and end code of the printer's owner" {
    filum print part.stl -q --start-gcode 'PRINT_START\nG92 E0' --end-gcode PRINT_END -o own.gcode
    [[ $(grep -c -x -e PRINT_START -e PRINT_END own.gcode) == 2 ]]
    run -1 grep -q '^G28' own.gcode
    awk '/^PRINT_START$/ { start = NR } /^G92 E0$/ { zero = zero ? zero : NR } / E[0-9]/ { if (!first) first = NR } /^PRINT_END$/ { end = NR }
        END { exit !(start && start < zero && zero < end) }' own.gcode
    filum print part.stl -q --start-gcode 'M117 a, b\nM98 P"0:/sys/go.g"' --end-gcode 'M117 [bye], "you"' -o own.gcode
    [[ $(grep -c -x -F -e 'M117 a, b' -e 'M98 P"0:/sys/go.g"' -e 'M117 [bye], "you"' own.gcode) == 3 ]]
}

@test "a bed and a fan of one's own" {
    filum print part.stl -q --bed 60x60x40 -o small.gcode
    [[ $(filum print part.stl --bed 60x60x40 --dry-run) == *"bed.x=[0,60],bed.y=[0,60],bed.z=[0,40]"* ]]
    # the part stands in the middle of the bed
    read -r low high < <(awk '/^;LAYER:0/ { on = 1 } /^;LAYER:1/ { exit } on && /^G1 .*X.*E/ { x = $0; sub(/.* X/, "", x); sub(/ .*/, "", x)
        if (!n++ || x < lo) lo = x; if (n == 1 || x > hi) hi = x } END { print lo + 0, hi + 0 }' small.gcode)
    awk -v a="$low" -v b="$high" 'BEGIN { exit !((a + b) / 2 > 29.5 && (a + b) / 2 < 30.5) }'
    filum print part.stl -q --bed 100x100,160x100,160x160,100x160 -o corner.gcode
    expect 3 filum print part.stl -q --bed 4x4 -o none.gcode
    for bad in 60 60x 60x60x40x2 axb 60x0 0x0,60x60x40; do expect 2 filum print part.stl --bed "$bad" -o none.gcode; done
    filum print part.stl -q --fan 50% -o half.gcode
    grep -q '^M106 S128$' half.gcode
    run -1 grep -q '^M106 S255$' half.gcode
    expect 2 filum print part.stl --fan 150% -o none.gcode
}

@test "what stages dropped is said, too, if nothing is left to print" {
    printf 'v 0 0 0\nv 5 0 0\nv 0 0.02 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n' > hair.obj
    expect 3 filum print hair.obj -o none.gcode
    [[ $err == *"lays no bead"* && $err == *"[sliver-dropped]"* ]]
    [ ! -e none.gcode ]
}
