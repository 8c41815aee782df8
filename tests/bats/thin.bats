#!/usr/bin/env bats
# Walls thinner than a bead through the whole chain.

load common

setup() {
    cd "$BATS_TEST_TMPDIR"
    export FILUM_SOURCE=${FILUM_SOURCE:-$(cd "$BATS_TEST_DIRNAME/../.." && pwd)}
    make_part=$FILUM_SOURCE/examples/scaffold/make-part
}

@test "walls of one bead are laid in a single pass, back and forth from layer to layer" {
    $make_part ell 12 9 0.36 2 ell.stl
    $make_part block 12 0.36 2 block.stl
    $make_part ring 10 9.28 2 ring.stl
    for part in ell block ring; do
        filum print $part.stl --thin single --machine marlin -o $part.gcode
        slice $part.stl | regions > $part.regions
        sequence $part.regions | fill --thin single | link3d | metrics --regions $part.regions --format tsv > m.tsv
        value() { awk -F'\t' -v name="$1" '$1 == name { print $2; exit }' m.tsv; }
        [ "$("$FILUM_SOURCE/scripts/gcode-strokes" $part.gcode | awk -F'\t' 'NR == 2 { print $2, $3 }')" = "1 0" ]
        [ "$(value crossings)" -eq 0 ]
        awk -v c="$(value coverage)" -v w="$(value width_median_mm)" -v o="$(value overfill)" \
            'BEGIN { exit !(c > 0.99 && w > 0.35 && w < 0.37 && o < 0.001) }'
    done
}

@test "--thin takes what it knows" {
    run --separate-stderr fill --thin double /dev/null
    [ "$status" -eq 2 ]
    [[ "$stderr" == *"one of lanes, half-height, single"* ]]
}

@test "a hair wall is laid at half height and back on top, in one stroke and the right amount" {
    $make_part block 12 0.15 2 hair.stl
    filum print hair.stl --thin half-height -q --machine marlin -o hair.gcode
    [ "$("$FILUM_SOURCE/scripts/gcode-strokes" hair.gcode | awk -F'\t' 'NR == 2 { print $2, $3 }')" = "1 0" ]
    for z in 0.1 0.2 1.9 2; do grep -qE "^G1 .*Z$z( |\$)" hair.gcode; done
    slice hair.stl | regions > hair.regions
    sequence hair.regions | fill -q --thin half-height > hair.paths
    peek --check hair.paths
    peek --json hair.paths | grep -q '"stacked"'
    link3d hair.paths | metrics --regions hair.regions --format tsv > m.tsv
    awk -F'\t' '$1 == "material" { exit !($2 > 0.95 && $2 < 1.02) }' m.tsv
}
