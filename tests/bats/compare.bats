#!/usr/bin/env bats
# scripts/compare: Filum beside itself only, so that it needs no other slicer.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    [[ -x /usr/bin/time ]] || skip "no /usr/bin/time"
    box_stl > part.stl
    "$FILUM_SOURCE/scripts/compare" --only filum --out out part.stl > table 2> said
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

column() { awk -F'\t' -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } NR == 2 { print $at[name] }' out/compare.tsv; }

@test "a part is printed and counted" {
    [ "$(column part)" = part ]
    [ "$(column slicer)" = filum ]
    [ "$(column strokes)" = 1 ]
    [ "$(column stops)" = 0 ]
    awk -v l="$(column extruded_m)" 'BEGIN { exit !(l > 0.9 && l < 1.1) }' # 81 mm2, 5 layers, beads of 0.4 mm
    [ "$(column moves)" -gt 100 ]
    awk -v c="$(column cpu_s)" -v m="$(column peak_mb)" 'BEGIN { exit !(c > 0 && m > 1) }'
    grep -q '^filum ' table
    grep -q '<title>part: filum' out/part.html
}

@test "what cannot be had is said, what can is right" {
    if filum list | grep -q '^ingest ' && /usr/bin/python3 -c 'import numpy, google.protobuf' 2> /dev/null; then
        awk -v c="$(column coverage)" 'BEGIN { exit !(c > 0.97 && c <= 1) }'
    else
        [ "$(column coverage)" = - ]
        grep -q '^not known: coverage' table
    fi
    [ -n "$FILUM_KLIPPER" ] || { [ "$(column planned_s)" = - ] && grep -q '^not known: planned s' table; }
}

@test "wrong words are refused" {
    expect 2 "$FILUM_SOURCE/scripts/compare" --nonesuch part.stl
    expect 2 "$FILUM_SOURCE/scripts/compare"
    expect 5 "$FILUM_SOURCE/scripts/compare" none.stl
}
