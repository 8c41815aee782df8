#!/usr/bin/env bats
# Faces of kinds that nobody looked at, from a seed (tests/surfaces/make-kind): what must hold of every plan.

load common

SEED=6

setup() {
    cd "$BATS_TEST_TMPDIR"
    made="$BATS_TEST_DIRNAME/../surfaces/make-kind"
}

# lies KIND PLAN...: it covers most of the face, says what it does not as an independent sampler finds it, has no number that is none, and no more cuts than those it tells.
lies() {
    local kind=$1
    shift
    "$made" "$kind" $SEED | geodesic --quiet -o face.surface
    surfpath "$@" face.surface -o face.toolpath 2> said || { cat said; return 1; }
    peek --text face.toolpath | run -1 grep -qiw -e nan -e inf
    peek face.toolpath | sed -n 's/^fact *surfpath: \(uncovered\|cuts\) \([0-9.e+-]*\).*/told_\1\t\2/p' > figures
    metrics --format tsv --surface face.surface face.toolpath >> figures
    awk -F '\t' -v kind="$kind" -v plan="$*" '{ is[$1] = $2 }
        END {
            bare = 1 - is["coverage"]; told = is["told_uncovered"] / is["surface_mm2"]
            good = is["coverage"] > 0.9 && (bare - told) ^ 2 < 0.015 ^ 2 &&
                is["cuts"] == is["told_cuts"]
            if (!good) print kind, plan ": covered", is["coverage"], "told bare", told, "cuts", is["cuts"], is["told_cuts"]
            exit !good
        }' figures
}

@test "hybrid lays every kind of face, and tells what it leaves" {
    for kind in small wedge-tip crescent coil gear three-slots; do lies $kind hybrid; done
}

@test "lines that turn outside do, beyond rims that are rough, narrow or notched" {
    for kind in crescent gear; do lies $kind field --angle 30 --turn-outside 8; done
}

# sampled KIND PLAN...: what it says of itself is what 4,000 places at random say, within four standard deviations and
# what the planner's own samples, a third of a spacing apart, may be off; writes what was found to `found`.
sampled() {
    local kind=$1
    shift
    "$made" "$kind" $SEED | geodesic --quiet --source plane:1,0,0,0 -o face.surface
    surfpath --quiet "$@" face.surface -o face.toolpath
    "$BATS_TEST_DIRNAME/../surfaces/sample-path" face.surface face.toolpath > found
    peek face.toolpath | sed -n 's/^fact *surfpath: \([a-z-]*\) \([0-9.e+-]*\).*/\1\t\2/p' >> found
    peek face.surface | sed -n 's/^fact *geodesic: area \([0-9.]*\).*/area\t\1/p' >> found
    awk -F '\t' -v kind="$kind" -v plan="$*" '{ is[$1] = $2 }
        END {
            told = 1 - is["uncovered"] / is["area"]; p = is["covered"]
            good = is["numbers"] == 0 && is["area"] > 0 && (p - told) ^ 2 < (4 * sqrt(p * (1 - p) / 4000) + 0.005) ^ 2
            if (!good) print kind, plan ": covered", p, "told", told, "no numbers", is["numbers"]
            exit !good
        }' found
}

@test "plans leave bare what they say, by places at random; lines of hybrid cross nowhere but where they say" {
    sampled small fina
    sampled small field --angle 30
    for kind in small coil; do
        sampled $kind hybrid
        awk -F '\t' '$1 == "crossings" { c = $2 } $1 == "transits" { t = $2 } END { exit !(c == 0 || t > 0) }' found
    done
}

@test "what has no room for a line is refused, or nothing is laid, with the reason" {
    "$made" small $SEED | geodesic --quiet -o face.surface
    expect 3 surfpath geo-contour --spacing 90 face.surface -o face.toolpath
    complaint surfpath
    [ ! -e face.toolpath ]
    for plan in hybrid "field --angle 30"; do
        # shellcheck disable=SC2086
        surfpath $plan --spacing 90 face.surface -o face.toolpath 2> said
        grep -q surface-too-narrow said
        grep -q area-bare said
    done
}

@test "kinds are the same from the same seed, and others from another" {
    "$made" --list | cut -f1 > kinds
    [ "$(wc -l < kinds)" -ge 36 ]
    for kind in blade gear; do
        "$made" $kind 3 > a
        "$made" $kind 3 > b
        "$made" $kind 4 > c
        cmp a b
        run -1 cmp -s a c
    done
}

@test "the same for any number of threads" {
    "$made" two $SEED | geodesic --quiet -o face.surface
    for n in 1 2 8; do surfpath --quiet hybrid --threads $n face.surface > $n.toolpath; done
    cmp 1.toolpath 2.toolpath
    cmp 1.toolpath 8.toolpath
}
