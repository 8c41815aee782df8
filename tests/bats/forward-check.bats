#!/usr/bin/env bats
# Finished programs, driven by kinematics that share no code with postproc, follow the toolpath.

load common

check() { "$BATS_TEST_DIRNAME/../../scripts/forward-check" --out "$BATS_TEST_TMPDIR/out" "$@"; }

@test "joints of trunnions, heads and a polar machine: over the pole, and round a cone with unwinds" {
    run check --paths pole --machines linuxcnc-xyzac,polar-xzbc
    echo "$output"
    [ "$status" -eq 0 ]
    [ "$(grep -c ' ok$' <<< "$output")" -eq 3 ]
    run check --paths cone --machines linuxcnc-head-head,linuxcnc-head-table
    echo "$output"
    [ "$status" -eq 0 ]
    [ "$(grep -c ' ok$' <<< "$output")" -eq 4 ]
    grep -q stroke-unwound "$BATS_TEST_TMPDIR/out/linuxcnc-head-head-joints-cone.txt"
}

@test "tool frames of robots" {
    run check --paths cone --machines kuka-krl,abb-rapid,ur
    echo "$output"
    [ "$status" -eq 0 ]
    [ "$(grep -c ' ok$' <<< "$output")" -eq 3 ]
}

@test "a program that is a little off is seen" {
    check --paths cone --machines klipper-xyzac > /dev/null
    cd "$BATS_TEST_TMPDIR/out"
    run "$BATS_TEST_DIRNAME/../../scripts/forward-check" klipper-xyzac-joints-cone.txt cone.toolpath klipper-xyzac
    [ "$status" -eq 0 ]
    awk '/^G1 .*E/ && ++n == 60 { sub(/ E/, " Z1 E") } { print }' klipper-xyzac-joints-cone.txt > off.txt
    run "$BATS_TEST_DIRNAME/../../scripts/forward-check" off.txt cone.toolpath klipper-xyzac
    [ "$status" -eq 1 ]
    run "$BATS_TEST_DIRNAME/../../scripts/forward-check" --nonsense
    [ "$status" -eq 2 ]
}
