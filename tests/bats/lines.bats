#!/usr/bin/env bats
# Lines on a terminal, and words of the summary.

bats_require_minimum_version 1.5.0

setup() {
    PATH="$(cd "$(dirname "$(command -v slice)")" && pwd):$PATH"
    cd "$BATS_TEST_TMPDIR" || return 1
    awk 'BEGIN { for (i = 0; i < 8; i++) print "v", 20 * (i % 2), 20 * (int(i / 2) % 2), 20 * int(i / 4)
        print "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6" }' > cube.obj
}

@test "long lines break at the width of a terminal, and stay whole elsewhere" {
    command -v script > /dev/null || skip "no 'script' to make a terminal"
    { printf 'layer_height = 0.2\n'; for k in $(seq 30); do echo "unknown_key_$k = 3"; done; } > x.ini
    filum print cube.obj --load x.ini -o x.gcode 2> plain
    awk 'length > 200 { long = 1 } END { exit !long }' plain
    script -qec "stty cols 80; filum print cube.obj --load x.ini -o x.gcode" out > /dev/null < /dev/null
    tr '\r' '\n' < out | sed 's/\x1b\[[0-9;]*K//g' | awk 'length > 80 && !/^Script/ { print; bad = 1 } END { exit bad }'
    grep -q 'unknown_key_30' out
}

@test "material that costs nothing worth a coin has no price" {
    filum print cube.obj --set extrusion.density=1.24,extrusion.cost=0.1 -q -o x.gcode # 0.001
    run ! grep -q 'material for' x.gcode
    filum print cube.obj --set extrusion.density=1.24,extrusion.cost=20 -q -o x.gcode
    grep -q 'material for 0.2$' x.gcode
}
