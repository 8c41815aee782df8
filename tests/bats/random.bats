#!/usr/bin/env bats
# Parts at random, by every pattern and bead: what crosses is told, and the default crosses nothing.

load common

setup() { cd "$BATS_TEST_TMPDIR" || exit 1; }

# crossings PATTERN WIDTH: of the toolpath of part.regions, and what was told of them
crossings() {
    sequence part.regions | fill --pattern "$1" --bead-width "$2" 2> told | link3d --output part.toolpath 2>> told
    metrics --format tsv part.toolpath | sed -n 's/^crossings\t\([0-9]*\).*/\1/p'
}

@test "toolpaths of parts at random cross nothing that is not told" {
    for seed in $(seq 12); do
        "$BATS_TEST_DIRNAME"/../parts/random-part "$seed" > part.stl
        for width in 0.35 0.8; do
            slice --layer-height 0.2 part.stl | regions --bead-width $width --output part.regions
            [ "$(crossings spiral $width)" = 0 ] || { echo "spiral $seed $width"; false; }
            for pattern in contour spiral+zigzag scaffold; do
                [ "$(crossings $pattern $width)" = 0 ] || grep -q cross told || { echo "$pattern $seed $width"; false; }
            done
        done
    done
}

@test "seeds whose jogs crossed a piece of 8 nm behind a corner" {
    for seed in 19 23 44; do
        "$BATS_TEST_DIRNAME"/../parts/random-part "$seed" > part.stl
        slice --layer-height 0.2 part.stl | regions --output part.regions
        for width in 0.4 0.8; do [ "$(crossings contour $width)" = 0 ]; done
    done
}

@test "prints of parts at random, with options at random" {
    "$BATS_TEST_DIRNAME"/../parts/random-print 1 40
}
