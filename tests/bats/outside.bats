#!/usr/bin/env bats
# Turns outside the part: what is trimmed, and that the part itself is as it should be.

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR"
    gzip -dc "$BATS_TEST_DIRNAME/../../examples/surfaces/saddle.off.gz" | geodesic --source plane:1,0,0,0.1 > face.surface
}

setup() { cd "$BATS_FILE_TMPDIR"; }

fact() { peek "$1" | sed -n "s/^fact *surfpath: $2 \([0-9.e+-]*\).*/\1/p"; }

@test "rows turn outside: the part is covered, nothing is laid twice on it, the list has every trim" {
    for a in fina field; do
        surfpath --quiet $a --turn-outside 5 --trim-list $a.tsv face.surface > $a.toolpath
        [ "$(fact $a.toolpath trims)" -eq $(($(wc -l < $a.tsv) - 1)) ]
        [ "$(head -1 $a.tsv)" = "$(printf 'stroke\talong\tx\ty\tz')" ]
        metrics --surface face.surface --format tsv $a.toolpath > figures
        awk -F '\t' '$1 == "coverage" { c = $2 } $1 == "overlap" { o = $2 } $1 == "beside_mm" { b = $2 }
            END { exit !(c > 0.985 && o < 0.02 && b > 500) }' figures
    done
}

@test "where it has no effect, it says so; what cannot be is refused" {
    surfpath --turn-outside 5 face.surface > out 2> said
    grep -q "turn-outside.*rows: fina, fexa, ortheo or field" said
    box_stl > box.stl
    geodesic box.stl > closed.surface
    surfpath field --angle 0 --turn-outside 5 closed.surface > out 2> said
    grep -q "turn-outside.*no surface has a rim" said
    expect 2 surfpath geo-contour --turn-outside 5 face.surface
    complaint surfpath
    expect 2 surfpath fina --turn-outside 0.4 face.surface
    complaint surfpath
    expect 2 surfpath fina --trim-list x.tsv face.surface
    complaint surfpath
}

@test "the same for any number of threads" {
    for n in 1 2 8; do surfpath --quiet field --turn-outside 4 --threads $n face.surface > $n.toolpath; done
    cmp 1.toolpath 2.toolpath
    cmp 1.toolpath 8.toolpath
}
