#!/usr/bin/env bats
# STEP files through the commands, where the build has OpenCASCADE; and what is said where it has not.

load common

setup() {
    bracket=$BATS_TEST_DIRNAME/../../examples/bracket/bracket.step
    loose=$BATS_TEST_DIRNAME/../lib/shapes/mesh/step/loose.step
    cd "$BATS_TEST_TMPDIR"
}

needs_step() {
    [ -x "$(commands_folder)/../lib/filum/read-step" ] || [ -x "$(commands_folder)/../../lib/filum/read-step" ] ||
        skip "this build has no OpenCASCADE (scripts/setup --step)"
}

# How many triangles each CAD face has: "FACE COUNT" a line.
faces() { peek --json "$1" | grep -o '"face":\[[^]]*' | tr -cd '0-9,' | tr ',' '\n' | sort -n | uniq -c | awk '{print $2, $1}'; }

@test "step: a part is sliced and filled, from a file and from a pipe" {
    needs_step
    slice --layer-height 0.4 "$bracket" > part.layers 2> said
    [ ! -s said ]
    peek --check part.layers
    slice --layer-height 0.4 < "$bracket" | cmp - part.layers
    regions part.layers | sequence > part.sequence
    fill part.sequence 2> /dev/null | link3d | metrics --regions part.sequence --format tsv > part.tsv
    awk -F '\t' '$1 == "coverage" { seen = $2 > 0.98 } END { exit !seen }' part.tsv
}

@test "step: CAD faces stay with the surface through a cut, a remesh and later stages" {
    needs_step
    geodesic "$bracket" > whole.surface
    [ "$(faces whole.surface | cut -d ' ' -f 1 | tr '\n' ' ')" = "1 2 3 4 5 6 7 8 9 10 11 12 13 " ]
    geodesic "$bracket" --deflection 0.2 | cmp -s - whole.surface && false
    geodesic "$loose" --cut 0,0,1,3 --remesh 1 --source boundary > half.surface
    [ "$(faces half.surface | wc -l)" -eq 5 ]
    geodesic half.surface --source vertex:0 > again.surface
    diff <(faces half.surface) <(faces again.surface)
}

@test "step: damaged files are errors, and nothing reaches standard output" {
    needs_step
    head -c 100000 "$bracket" > cut.step
    sed '300,400s/CARTESIAN_POINT/DIRECTION/' "$bracket" > wrong.step
    { head -c 100000 "$bracket"; printf '\nENDSEC;\nEND-ISO-10303-21;\n'; } > ended.step
    for command in slice geodesic; do
        expect 4 "$command" cut.step
        complaint "$command"
        [ -z "$out" ]
        for file in wrong ended; do
            expect '0|3' "$command" "$file.step" -o "$file.out"
            [ -z "$out" ]
            if [ -e "$file.out" ]; then peek --check "$file.out"; else complaint "$command"; fi
        done
    done
    expect 2 slice --deflection 0 "$bracket"
    expect 2 slice --deflection nan "$bracket"
    expect 2 geodesic --unit in "$bracket"
    [[ $err == *unit* ]]
}

@test "step: without OpenCASCADE the error says how to get it" {
    cp "$(command -v slice)" . # away from the program that reads STEP
    expect 1 ./slice "$bracket"
    complaint slice
    [[ $err == *"scripts/setup --step"* ]]
}
