#!/usr/bin/env bats
# Several toolpaths as one job, and plies of one surface.
# shellcheck disable=SC2154

load common

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    cat > square.off << 'EOF'
OFF
4 2 0
0 0 0  20 0 0  20 20 0  0 20 0
3 0 1 2
3 0 2 3
EOF
    geodesic square.off --source plane:1,0,0,5 > square.surface
    surfpath ortheo square.surface --spacing 2 > a
    surfpath ortheo square.surface --spacing 4 --ply 1 --offset 0.2 > b
}

strokes() { peek --text "$1" | grep -c '^span.*bead'; }

@test "a job has the strokes of all, and one travel between each two" {
    assemble a b > job
    [[ $(strokes job) == 15 ]]
    [[ $(peek --text job | grep -c '^span.*travel') == 14 ]]
    peek job | grep -q 'assemble'
    peek job | grep -q 'toolpaths 2'
    [[ $(peek job | grep -c 'fact *surfpath: births ') == 2 ]]
    cmp <(assemble a b) job
}

@test "a ply lies above the surface by its offset, as a layer of its own" {
    metrics b --surface square.surface > text
    grep -Eq 'max +0\.2000 mm' text
    peek --text b | grep -q 'layer 1'
}

@test "what is no toolpath is refused" {
    expect 3 assemble a square.surface
    [[ -z $out && $err == *square.surface* ]]
}

@test "a job is turned and moved as slice does it" {
    assemble --rotate 90,0,0 --translate 1,2,3 a > turned
    peek --text a | grep -A1 -m1 '^span.*bead' | grep -q '^  20 1 0 0 0 1$'
    peek --text turned | grep -A1 -m1 '^span.*bead' | grep -q '^  21 2 4 0 -1 0$'
    expect 2 assemble --rotate 90 a
    [[ $err == *rotate* ]]
}
