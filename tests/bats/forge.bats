#!/usr/bin/env bats
# Streams with right checksums and forged contents, through every stage that reads a stream: an end within limits of time
# and memory, an exit code, no internal error.  tests/forge/forge-streams BUILD runs 1,000 for each stage.

setup_file() {
    # The interpreter that knows protobuf and numpy: Debian's, even where another one comes first.
    for python in python3 /usr/bin/python3; do
        "$python" -c 'import google.protobuf, numpy' 2> /dev/null && break
        python=
    done
    [[ -n $python ]] || skip "no python3-protobuf, python3-numpy"
    export python
}

@test "one forged stream of each kind of stage" {
    "$python" "$BATS_TEST_DIRNAME/../forge/forge-streams" "$FILUM_BUILD" --count 1 --seed "${FORGE_SEED-7}"
}

@test "forged streams that were too much once" {
    forge() { "$python" "$BATS_TEST_DIRNAME/../forge/forge-streams" "$FILUM_BUILD" --count 1 "$@"; }
    forge --seed 2 --first 67 --stage metrics          # a bead of 100 km
    forge --seed 5 --first 98 --stage link3d           # lines of 12 m where the region has 10 mm
    forge --seed 5 --first 26 --stage metrics-surface  # a surface of a square mile
}
