#!/usr/bin/env bats
# Plans of patches, from the outside.
# shellcheck disable=SC2154

load common

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    # two rectangles of 16 x 10 mm, the first pulled along x, the second along y
    for at in 0 30; do
        awk -v x=$at 'BEGIN {
            print "OFF\n187 320 0"
            for (j = 0; j <= 10; j++) for (i = 0; i <= 16; i++) print x + i, j, 0
            for (j = 0; j < 10; j++) for (i = 0; i < 16; i++) {
                p = 17 * j + i
                print 3, p, p + 1, p + 18; print 3, p, p + 18, p + 17 } }' > "$at.off"
        geodesic --unit mm "$at.off" > "$at.surface"
    done
    awk 'BEGIN {
        print "x,y,z,s1x,s1y,s1z,s1,s2,s3"
        for (y = 0; y <= 10; y++) for (x = 0; x <= 16; x++) print x ",", y ",0,1,0,0,5,0,0"
        for (y = 0; y <= 10; y++) for (x = 30; x <= 46; x++) print x ",", y ",0,0,1,0,5,0,0" }' > stress.csv
    partition --as-is --names left,right 0.surface 30.surface | stressfield --stress stress.csv --case X > both
}

facts() { peek "$1" | sed -n "s/^fact *$2: //p"; }

@test "every patch gets a plan that follows its own pull, and surfpath lays all of them" {
    choose --spacing 2 --min-radius 1 --finals 1 --report report.tsv both > chosen
    for p in left right; do
        facts chosen choose | awk -v p="patch.$p.load" '$1 == p {n++; if ($2 < 0.8) exit 1} END {exit n != 1}'
        [[ $(awk -F '\t' -v p=$p '$1 == p && $15 == "*"' report.tsv | wc -l) == 1 ]]
    done
    facts chosen choose | grep -q '^score '
    surfpath --quiet --spacing 2 --min-radius 1 chosen > path
    facts path surfpath | grep -q '^patch.left.'
    facts path surfpath | grep -q '^patch.right.'
    # by the plan of each, not by the default
    surfpath --quiet geo-fiso --spacing 2 --min-radius 1 chosen > rings
    if cmp -s path rings; then false; fi
    surfpath --quiet --spacing 2 --min-radius 1 --threads 2 chosen | cmp - path
}

@test "a plan by hand is kept when nothing else is tried, and followed" {
    geodesic 0.surface --source plane:0,1,0,5 > rows
    choose --algorithm fina --spacing 2 --min-radius 1 rows > byhand
    [[ $(facts byhand choose | awk '$1 == "laid" {print $2}') == 1 ]]
    surfpath --quiet --spacing 2 --min-radius 1 byhand > a
    surfpath --quiet fina --spacing 2 --min-radius 1 rows > b
    diff <(metrics --format tsv a | grep -v choose) <(metrics --format tsv b)
    expect 1 choose --algorithm fina --spacing 2 0.surface --output none
    [[ $err == *'needs a seed curve'* ]]
}

@test "weights that mean nothing are refused" {
    expect 2 choose --weights beauty=1 0.surface
    complaint choose
    [[ $err == *"'beauty'"* ]]
    expect 2 choose --weights load=-1 0.surface
    expect 2 choose --finals 0 0.surface
    expect 2 choose --spacing 0 0.surface
}

@test "a patch that nothing fills is noted, the others are planned, and the exit says so" {
    disc 0.3 > small.off
    geodesic --unit mm small.off > small.surface
    partition --as-is --names left,small 0.surface small.surface > mixed
    expect 1 choose --spacing 2 --min-radius 1 --finals 1 mixed --output chosen
    [[ $err == *"'small'"* && $err != *"'left'"* ]]
    peek --check chosen
    peek chosen | grep -q 'note .*no algorithm found a path for .*on patch small'
    expect 0 surfpath --spacing 2 --min-radius 1 chosen --output path
    [[ $err == *'patch without an algorithm and stay empty, on patch small'* ]]
}

@test "what works on one surface refuses several" {
    expect 3 metrics --surface both <(surfpath --quiet 0.surface)
    [[ $err == *'2 surfaces'* ]]
    expect 3 geodesic both
}

@test "all algorithms on one surface: a table, pictures, and why one found nothing" {
    rm -rf paths
    filum compare "$FILUM_SOURCE/examples/bracket/patch_A.ply" --spacing 4 --among geo-fiso,field,hybrid -o paths > said 2> err
    [[ $(wc -l < said) == 4 ]]
    head -n 1 said | grep -q 'coverage  *cuts  *overlap  *tight mm  *kinks mm  *length mm'
    awk -F'\t' 'NR > 1 && !($2 > 0.5 && $2 <= 1 && $7 > 100) { exit 1 }' paths/table.tsv
    for name in geo-fiso field hybrid; do [[ -s paths/$name.png && -s paths/$name.toolpath ]]; done
    grep -q hybrid.png paths/index.html
    [[ $(filum compare face.ply --dry-run -o paths --among fina | wc -l) == 5 ]]
    expect 2 filum compare face.ply
    expect 2 filum compare face.ply --among nosuch -o paths
    expect 5 filum compare nosuch.ply -o paths
}
