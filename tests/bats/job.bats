#!/usr/bin/env bats
# A printed core and fibre on its side in one program: tools, ways between, checks.  The whole bracket: examples/bracket-job.
# shellcheck disable=SC2154

load common

top=$BATS_TEST_DIRNAME/../..

# box X0 X1 Y0 Y1 Z0 Z1
box() {
    printf 'OFF\n8 12 0\n'
    for z in "$5" "$6"; do printf "%s %s $z\n" "$1" "$3" "$2" "$3" "$2" "$4" "$1" "$4"; done
    printf '3 %s\n' '0 2 1' '0 3 2' '4 5 6' '4 6 7' '0 1 5' '0 5 4' '1 2 6' '1 6 5' '2 3 7' '2 7 6' '3 0 4' '3 4 7'
}

# A block of 20 x 12 x 10 mm on z = 0, and its side at x = 10.
setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    box -10 10 -6 6 0 10 > block.off
    printf 'OFF\n4 2 0\n10 -6 0\n10 6 0\n10 6 10\n10 -6 10\n3 0 1 2\n3 0 2 3\n' > side.off
    cp "$top/examples/bracket-job/machine.toml" .
    slice --layer-height 0.4 block.off | regions | sequence --head ./machine.toml | fill --bead-width 0.8 |
        link3d --head ./machine.toml -o core
    geodesic side.off --remesh 1 --source plane:0,0,1,0 | surfpath fina --spacing 1 --offset 0.2 -o fibre
    assemble --tools 0,1 core fibre | route --machine ./machine.toml --margin 0.5 | collide --machine ./machine.toml -o job
    postproc --machine ./machine.toml --place as-is job -o job.ngc
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

# The line where PATTERN stands last.
at() { grep -n "$1" job.ngc | tail -n 1 | cut -d: -f1; }

@test "tools change once, and the fibre is cut once, behind that" {
    [[ $(grep -c '^T1 M6' job.ngc) == 1 && $(grep -c '^T2 M6' job.ngc) == 1 && $(grep -c '^M64 P0' job.ngc) == 1 ]]
    (($(at '^T1 M6') < $(at '^T2 M6') && $(at '^T2 M6') < $(at '^M64 P1') && $(at '^M64 P1') < $(at '^M64 P0')))
    (($(at '^M64 P0') < $(at '^M65 P1')))
}

@test "the head stays clear in the finished program, of the beads and of the part" {
    # beads have round ends: the edges of the part stand out beyond them, so route keeps a margin
    collide --machine ./machine.toml --program job.ngc --format tsv > whole.tsv
    sed -n '/^T2 M6/,$p' job.ngc > half.ngc
    collide --machine ./machine.toml --part block.off --program half.ngc --format tsv > half.tsv
    for file in whole.tsv half.tsv; do awk -F '\t' '$1 == "collisions" {exit $2 != 0}' $file; done
    awk -F '\t' '$1 ~ /^clearance_(beads|part)_mm$/ {++n; if ($2 <= 0) exit 1} END {exit n == 0}' whole.tsv half.tsv
}

# The tool is level at the side: its cone reaches below the part's foot.
@test "without a riser the bed is in the way, and the place is said" {
    expect 1 collide --machine ./machine.toml --bed --program job.ngc
    [[ $err == *'meets the bed'*'the tip at x '* ]]
}

# Beside the way of the head stands a wall.
@test "a head that is too fat is refused, with the place" {
    box 11 40 12 14 0 10 > wall.off
    sed -n '/^T2 M6/,$p' job.ngc > half.ngc
    collide --machine ./machine.toml --part block.off --fixture wall.off --program half.ngc > /dev/null
    expect 1 collide --machine ./machine.toml --fixture wall.off --program half.ngc --cone-angle 40
    [[ $err == *'the nozzle meets the fixture'*'the tip at x 10.2'* ]]
}
