#!/usr/bin/env bats
# metrics --surface from the outside: a plate with lines on it, published paths, faults.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    source_tree=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    for python in python3 /usr/bin/python3; do
        "$python" -c 'import google.protobuf, numpy' 2> /dev/null && break
        python=
    done
    [[ -n $python ]] || skip "no python3-protobuf, python3-numpy"
    printf '#!/bin/sh\nPYTHONDONTWRITEBYTECODE=1 PYTHONPATH="%s/python" exec "%s" "%s" "$@"\n' \
        "$FILUM_BUILD" "$python" "$source_tree/examples/zhang2025/lines-to-toolpath" > lines
    chmod +x lines
    # a plate of 10 x 10 mm, and five lines on it 2 mm apart, in pieces that are in no order
    printf 'v %s\n' '0 0 0' '10 0 0' '10 10 0' '0 10 0' > plate.obj
    printf 'f 1 2 3\nf 1 3 4\n' >> plate.obj
    for y in 1 3 5 7 9; do printf 'v %s\n' "0 $y 0" "6 $y 0" "10 $y 0"; done > lines.obj
    for i in 0 3 6 9 12; do printf 'l %d %d\nl %d %d\n' $((i + 3)) $((i + 2)) $((i + 1)) $((i + 2)); done >> lines.obj
    geodesic --unit mm plate.obj > plate.surface
    ./lines --width 1 < lines.obj > lines.toolpath
    flat_box_stl > part.stl
    slice part.stl | regions > part.regions
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

value() { # of the figure named $1 in the TSV on standard input
    awk -F'\t' -v name="$1" '$1 == name { print $2 }'
}

@test "lines twice as far apart as they are wide cover half, whatever the paper's figure says" {
    metrics --surface plate.surface --format tsv lines.toolpath > m.tsv
    [ "$(value chains < m.tsv)" -eq 5 ]
    [ "$(value cuts_per_1000_mm2 < m.tsv)" = 40.00 ]
    [ "$(value fibre_mm < m.tsv)" = 50.0 ]
    awk -v c="$(value coverage < m.tsv)" 'BEGIN { exit !((c - 0.5) ^ 2 < 0.001 ^ 2) }'
    awk -v c="$(value paper_coverage < m.tsv)" 'BEGIN { exit !(c > 0.98) }'
    awk -v c="$(value void_mm < m.tsv)" 'BEGIN { exit !((c - 0.5) ^ 2 < 0.01 ^ 2) }'
}

@test "what tells of layers is left out, and the three formats agree" {
    metrics --surface plate.surface lines.toolpath > m.txt
    metrics --surface plate.surface --format tsv lines.toolpath > m.tsv
    metrics --surface plate.surface --format json lines.toolpath > m.json
    run grep -i -E 'layer|crossings' m.tsv
    [ "$status" -eq 1 ]
    local lines
    lines=$(($(wc -l < m.tsv) - 1))
    [ "$(grep -c '^  ' m.txt)" -eq $((lines - 2)) ] # report and version are for programs
    [ "$(grep -c '^  "' m.json)" -eq "$lines" ]
    python3 -c 'import json; json.load(open("m.json"))'
}

@test "threads change nothing" {
    for n in 1 2 8; do
        metrics --threads $n --surface plate.surface --voids v$n lines.toolpath > m$n
    done
    cmp m1 m2
    cmp m1 m8
    cmp v1 v2
    cmp v1 v8
}

@test "voids are written as distances from the path" {
    metrics --surface plate.surface --voids plate.voids lines.toolpath > m.txt
    peek --check plate.voids
    peek plate.voids > p.txt
    grep -q 'payload *Surface' p.txt
    grep -q 'metrics 0.1.0 after 0 1' p.txt
    peek --json plate.voids | grep -q path-distance
}

@test "stresses on the surface tell how well the path follows them" {
    { echo x,y,z,s1x,s1y,s1z
      for y in 0 5 10; do for x in 0 5 10; do echo "$x,$y,0,4,3,0"; done; done; } > stress.csv
    stressfield --stress stress.csv --case pull --reach 1 plate.surface > loaded.surface
    metrics --surface loaded.surface --format tsv lines.toolpath > m.tsv
    [ "$(value load_cases < m.tsv)" -eq 1 ]
    [ "$(value load.pull.mean < m.tsv)" = 0.8000 ]
    [ "$(value load.pull.along_random < m.tsv)" = 0.6366 ]
    [ "$(value load.pull.within_15_deg < m.tsv)" = 0.0000 ]
}

@test "it measures from a pipe" {
    metrics --surface plate.surface < lines.toolpath > a
    metrics --surface plate.surface lines.toolpath > b
    cmp a b
}

@test "what does not go together is refused" {
    expect 2 metrics --surface plate.surface --regions part.regions lines.toolpath
    [[ $err == *"--regions"*"--surface"* ]]
    expect 2 metrics --surface plate.surface --pores lines.toolpath
    expect 2 metrics --voids v lines.toolpath
    [[ $err == *"--surface"* && ! -e v ]]
    expect 2 metrics --step 0.1 lines.toolpath
    expect 2 metrics --surface plate.surface --step 2 lines.toolpath
    [[ $err == *"smaller --step"* ]]
    expect 2 metrics --surface plate.surface --step 1e-9 lines.toolpath
    [[ $err == *"at least 0.001"* ]]
    expect 2 metrics --surface plate.surface --spacing 1000 lines.toolpath
    expect 2 metrics --surface plate.surface --spacing -1 lines.toolpath
    expect 2 metrics --surface plate.surface --spacing nan lines.toolpath
    expect 2 metrics --surface plate.surface --max-curvature 0 lines.toolpath
    expect 3 metrics --surface part.regions lines.toolpath
    expect 3 metrics --surface plate.surface part.regions
    expect 5 metrics --surface nowhere lines.toolpath
    head -c 300 plate.surface > cut.surface
    expect 4 metrics --surface cut.surface lines.toolpath
}

@test "a path of travels only has no figures but its count" {
    printf 'v 0 0 0\n' > none.obj
    ./lines --width 1 < none.obj > none.toolpath
    metrics --surface plate.surface --format tsv none.toolpath > m.tsv
    [ "$(value chains < m.tsv)" -eq 0 ]
    [ -z "$(value coverage < m.tsv)" ]
    expect 1 metrics --surface plate.surface --voids v none.toolpath
}

@test "lines of an OBJ file: closed ones, forks, faults" {
    # a square, a fork of three
    printf 'v %s\n' '1 1 0' '2 1 0' '2 2 0' '1 2 0' '5 5 0' '6 5 0' '7 5 0' '6 6 0' > forks.obj
    printf 'l 1 2 3\nl 4 3\nl 4 1\nl 5 6\nl 7 6\nl 6 8\n' >> forks.obj
    ./lines --width 1 < forks.obj > forks.toolpath
    metrics --surface plate.surface --format tsv forks.toolpath > m.tsv
    [ "$(value chains < m.tsv)" -eq 3 ] # the fork's first two go on from one to the other
    [ "$(value fibre_mm < m.tsv)" = 7.0 ]
    expect 3 ./lines --width 1 <<< 'l 1 2'
    expect 3 ./lines --width 1 <<< 'v 1 2'
    expect 2 ./lines --width 0 <<< ''
}
