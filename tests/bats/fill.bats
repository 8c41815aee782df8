#!/usr/bin/env bats
# fill in the chain.  Needs only the build's bin on the PATH.

bats_require_minimum_version 1.5.0

setup() {
    cd "$BATS_TEST_TMPDIR"
    # a box of 12 x 8 x 0.4 mm
    awk 'BEGIN {
        split("0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5", t, " ")
        print "solid box"
        for (i = 1; i <= 36; ++i) {
            if (i % 3 == 1) print "facet normal 0 0 0\nouter loop"
            k = t[i]
            print "vertex", (k % 2 ? 12 : 0), (int(k / 2) % 2 ? 8 : 0), (k > 3 ? 0.4 : 0)
            if (i % 3 == 0) print "endloop\nendfacet"
        }
        print "endsolid box"
    }' > part.stl
    slice part.stl | regions | sequence > part.regions
}


@test "a spiral has fewer than half the sharp turns of sun2019" {
    fill part.regions > ours.paths
    fill-sun2019 part.regions > theirs.paths 2> /dev/null
    metrics ours.paths | awk '/sharp-turn share/ { print $NF }' > ours
    metrics theirs.paths | awk '/sharp-turn share/ { print $NF }' > theirs
    awk 'NR == FNR { ours = $1; next } { exit !(ours < $1 / 2) }' ours theirs
}

@test "a least radius is kept or its exceptions are reported, and none changes nothing" {
    run --separate-stderr fill --min-radius 0.5 part.regions -o round.paths
    [ "$status" -eq 0 ]
    [[ "$stderr" == *area-left-for-radius* ]]
    [[ "$stderr" == *turn-too-tight* ]]
    fill part.regions -o usual.paths
    fill --min-radius 0 part.regions -o none.paths
    cmp usual.paths none.paths
    run -1 cmp -s usual.paths round.paths
}

@test "an impossible radius is refused" {
    for radius in -1 nan 1e9; do
        run --separate-stderr fill --min-radius "$radius" part.regions
        [ "$status" -eq 2 ]
        [[ "$stderr" == *"--min-radius"* ]]
    done
}

@test "hard outlines are filled alike however they are turned, and within their area" {
    "$FILUM_SOURCE/tests/parts/stress-outlines" --angles 5 --scales 0.25,1
}

@test "a large region is the same for 1, 2 and 8 threads" {
    python3 - "$FILUM_SOURCE/scripts/peers" <<'END'
import sys
sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import shapes
shapes.write_stl("gear.stl", shapes.prism(shapes.star(9000, 40, 0.3), (0, 0), 0.2))
END
    slice gear.stl | regions --quiet | sequence > gear.regions
    for n in 1 2 8; do fill --quiet --threads $n gear.regions > gear$n.paths; done
    cmp gear1.paths gear2.paths
    cmp gear1.paths gear8.paths
}
