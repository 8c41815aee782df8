#!/usr/bin/env bats
# partition: a surface into patches, and the stream of them through what reads it.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    box_stl > part.stl
    geodesic part.stl --remesh 1 -o part.surface
    # A plate of 20 x 10, pulled along y on the left half and along x on the right.
    awk 'BEGIN {
        n = 40; m = 20
        printf "OFF\n%d %d 0\n", (n + 1) * (m + 1), 2 * n * m
        for (j = 0; j <= m; j++) for (i = 0; i <= n; i++) print i / 2, j / 2, 0
        for (j = 0; j < m; j++) for (i = 0; i < n; i++) {
            a = j * (n + 1) + i; b = a + n + 1
            print 3, a, a + 1, b + 1; print 3, a, b + 1, b
        }
    }' > plate.off
    awk 'BEGIN { for (j = 0; j <= 20; j++) for (i = 0; i <= 40; i++) print i / 2 "," j / 2 ",0," (i < 20 ? "0,5,0" : "5,0,0") }' > pull.csv
    geodesic plate.off | stressfield --stress pull.csv --columns x,y,z,s1x,s1y,s1z --case X -o plate.surface
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

# value NAME FILE: of a fact.
value() { peek "$2" | awk -v n="$1" '$1 == "fact" && $2 == "partition:" && $3 == n { print $4 }'; }

@test "a box falls into its faces, and what is too small is said" {
    expect 0 partition part.surface --min-area 20 --output box.patches
    [[ $err == "partition: look: 36 mm2 of faces too small for a patch of their own were dropped (4 faces); worst at "* ]]
    [ "$(value patches box.patches)" = 2 ]
    [ "$(value patch.A.area box.patches)" = 81 ]
    expect 0 partition part.surface --min-area 5 --output box.patches
    [ -z "$err" ]
    [ "$(value patches box.patches)" = 6 ]
}

@test "a plate pulled two ways is divided between them" {
    expect 0 partition plate.surface --output plate.patches
    [ -z "$err" ]
    [ "$(value patches plate.patches)" = 2 ]
    [ "$(value area plate.patches)" = 200 ]
    awk -v a="$(value patch.A.area plate.patches)" 'BEGIN { exit !(a >= 100 && a < 108) }'
    awk -v a="$(value patch.A.coherence plate.patches)" 'BEGIN { exit !(a > 0.98) }'
    [ "$(peek --text plate.patches | grep -c stress.X.d1)" -ge 2 ]
}

@test "named patches pass as they are, and single ones can be taken out" {
    partition plate.surface --output plate.patches
    partition plate.patches --output again.patches
    cmp <(peek --json plate.patches | grep '"x"') <(peek --json again.patches | grep '"x"')
    [ "$(value patch.B.angle plate.patches)" = "$(value patch.B.angle again.patches)" ]
    partition plate.patches --only B --output b.surface
    [ "$(value patches b.surface)" = 1 ]
    [ "$(value patch.B.area b.surface)" = "$(value patch.B.area plate.patches)" ]
    [ -z "$(value patch.A.area b.surface)" ]
    expect 2 partition plate.patches --only A,Q --output none
    complaint partition
    [[ $err == *"'Q'; there are A, B" ]]
    [ ! -e none ]
}

@test "patches made by hand come together with names" {
    expect 0 partition --as-is plate.surface part.surface plate.surface --names left,right --output all.patches
    [ -z "$err" ]
    [ "$(value patches all.patches)" = 3 ]
    [ "$(value patch.left.area all.patches)" = 200 ]
    [ "$(value patch.A.area all.patches)" = 200 ]
    expect 2 partition --as-is plate.surface --names a,b
    complaint partition
    partition plate.surface --output plate.patches
    expect 2 partition plate.patches plate.patches
    [[ $err == *"two have the name 'A'"* ]]
}

@test "a field of vectors and the shape divide, too" {
    expect 0 partition plate.surface --by shape --output shape.patches
    [ "$(value patches shape.patches)" = 1 ]
    expect 0 partition plate.surface --field stress.X.d1 --output field.patches
    [ "$(value patches field.patches)" = 2 ]
}

@test "what is not there is an error that says what to do" {
    for wrong in '--by stress' '--field wind' '--field distance' '--case Y' '--faces' '--mask 0.2'; do
        # shellcheck disable=SC2086
        expect 2 partition part.surface $wrong
        complaint partition
    done
    for wrong in '--angle 0' '--angle 91' '--angle nan' '--bend -1' '--crease 181' '--patches -1' '--patches 1.5' \
        '--min-area -1' '--mask 1.1' '--detail inf' '--only a/b' '--names ,'; do
        # shellcheck disable=SC2086
        expect 2 partition part.surface $wrong
        complaint partition
    done
    expect 2 partition part.surface --min-area 1000
    [[ $err == *"1000 mm2"* ]]
    expect 3 partition plate.surface --field stress.X.s1
}

@test "the bracket falls into four coherent faces" {
    bracket=$BATS_TEST_DIRNAME/../../examples/bracket
    geodesic "$bracket/bracket.ply" | stressfield --quiet --stress "$bracket/bracket.frd.gz" --case X,Y -o bracket.surface
    partition --quiet bracket.surface --bend 40 --min-area 1000 --output bracket.patches
    [ "$(value patches bracket.patches)" = 4 ] # inside and outside, of leg and wall
    awk -v a="$(value area bracket.patches)" 'BEGIN { exit !(a > 18800 && a < 19000) }'
    for p in B C D; do
        awk -v a="$(value patch.$p.coherence bracket.patches)" 'BEGIN { exit !(a > 0.995) }'
        awk -v a="$(value patch.$p.bend bracket.patches)" 'BEGIN { exit !(a < 40) }'
    done
}

@test "lines of a file are borders" {
    printf '4 -1 0\n6 11 0\n' > seam.txt
    expect 0 partition plate.surface --by shape --seam seam.txt --output seam.patches
    [[ $err == "partition: look: 1 seam was moved to the surface, by up to 1 mm;"* ]]
    [ "$(value patches seam.patches)" = 2 ]
    awk -v a="$(value patch.B.area seam.patches)" 'BEGIN { exit !(a > 49 && a < 51) }'
    expect 5 partition plate.surface --seam no-such-file
    echo 'one two three' > wrong.txt
    expect 3 partition plate.surface --seam wrong.txt
    complaint partition
}

@test "the same bytes for 1, 2 and 8 threads, and every time" {
    partition plate.surface --threads 1 --output one
    for threads in 2 8; do
        partition plate.surface --threads $threads --output other
        cmp one other
    done
}

@test "render draws all patches in their colours" {
    partition plate.surface | render --view top --size 400,200 --output two.png
    partition plate.surface --patches 1 | render --view top --size 400,200 --output one.png
    [ "$(head -c 4 two.png | tail -c 3)" = PNG ]
    run -1 cmp -s one.png two.png
}

@test "who works on one surface refuses several" {
    partition plate.surface --output plate.patches
    expect 3 geodesic plate.patches
    [[ $err == *"2 surfaces, not one; take one by 'partition --only'" ]]
}

@test "stresses come onto the patches as they are" {
    partition --as-is part.surface plate.surface --output two.patches
    expect 0 partition two.patches --only B
    stressfield --quiet --stress pull.csv --columns x,y,z,s1x,s1y,s1z --case Y --reach 1 two.patches --output y.patches
    [ "$(peek --json y.patches | grep -o 'stress.Y.d1' | wc -l)" -ge 2 ]
}
