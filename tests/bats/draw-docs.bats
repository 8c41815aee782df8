#!/usr/bin/env bats
# scripts/draw-docs draws what the pages of docs/algorithms show.

setup() { top=$BATS_TEST_DIRNAME/../..; }

@test "sketches are what the script draws" {
    "$top/scripts/draw-docs" --out "$BATS_TEST_TMPDIR" sequence-head sequence-again geodesic-window field-joins rows-turns link3d-moves
    for f in sequence-head sequence-again geodesic-window field-joins rows-turns link3d-moves; do
        cmp "$BATS_TEST_TMPDIR/$f.svg" "$top/docs/algorithms/pictures/$f.svg"
    done
}

@test "a picture of a stream: small, the same twice" {
    for k in 1 2; do "$top/scripts/draw-docs" --build "$FILUM_BUILD" --out "$BATS_TEST_TMPDIR/$k" link3d-lane; done
    cmp "$BATS_TEST_TMPDIR"/{1,2}/link3d-lane.png
    [ "$(head -c 4 "$BATS_TEST_TMPDIR/1/link3d-lane.png" | tail -c 3)" = PNG ]
    [ "$(wc -c <"$BATS_TEST_TMPDIR/1/link3d-lane.png")" -lt 60000 ]
}

@test "what the fill works with is drawn from its own functions; without the program for that: exit 1, told" {
    run "$top/scripts/draw-docs" --build "$BATS_TEST_TMPDIR" --out "$BATS_TEST_TMPDIR" fill-axis
    [ "$status" -eq 1 ]
    [[ "$output" == *"--target draw_axis"* ]]
    for f in fill-axis fill-levels; do grep -q '<path' "$top/docs/algorithms/pictures/$f.svg"; done
}

@test "all pictures of the script are in the tree, and none besides" {
    drawn=$("$top/scripts/draw-docs" --list | sort)
    [ "$(wc -l <<<"$drawn")" -gt 20 ]
    cd "$top"
    diff <(grep '^docs/algorithms/.*png' <<<"$drawn") <(ls docs/algorithms/pictures/*.png | sort)
    while read -r file; do [ -s "$file" ]; done <<<"$drawn"
}

@test "an unknown picture: exit 2; a program that fails: exit 1" {
    run "$top/scripts/draw-docs" --out "$BATS_TEST_TMPDIR" no-such-picture
    [ "$status" -eq 2 ]
    [[ "$output" == *no-such-picture* ]]
    mkdir -p "$BATS_TEST_TMPDIR/bin"
    printf '#!/bin/sh\nexit 1\n' >"$BATS_TEST_TMPDIR/bin/slice"
    chmod +x "$BATS_TEST_TMPDIR/bin/slice"
    run "$top/scripts/draw-docs" --build "$BATS_TEST_TMPDIR" --out "$BATS_TEST_TMPDIR" link3d-lane
    [ "$status" -eq 1 ]
    [[ "$output" == *"cannot draw 'link3d-lane'"* ]]
}

@test "captions of the README say what its pictures show" {
    says() { python3 - "$top/docs/pictures/$1.png" << 'END'
import struct, sys
data = open(sys.argv[1], "rb").read()
at = 8
while at < len(data):
    size, kind = struct.unpack(">I4s", data[at:at + 8])
    if kind == b"tEXt":
        print(data[at + 8:at + 8 + size].partition(b"\0")[2].decode("latin-1"))
    at += size + 12
END
    }
    strokes=$(sed -nE 's/^!\[3DBenchy in ([0-9]+) strokes.*/\1/p' "$top/README.md")
    stops=$(sed -nE 's/^\| \*\*Filum\*\*.* \*\*([0-9]+)\*\* \| \*\*([0-9]+)\*\* \| \*\*0.*/\2/p' "$top/README.md")
    [ "$(says benchy)" = "strokes $strokes, stops $stops" ]
    [ "$(says benchy-layer)" = "strokes $strokes, stops $stops" ]
    grep -q "^| \*\*Filum\*\*, default | \*\*$strokes\*\* |" "$top/README.md"
    proven=$(slice "$top/examples/benchy/benchy.stl" | regions | sequence | peek | sed -nE 's/.*lower-bound ([0-9]+) strokes/\1/p')
    grep -q "^$proven is proven to be the fewest" "$top/README.md"
    [ "$(says scaffold)" = "strokes 1, stops 0" ]
    # and it is still so
    "$top/scripts/draw-docs" --build "$FILUM_BUILD" --out "$BATS_TEST_TMPDIR" benchy-layer scaffold
    for k in benchy-layer scaffold; do "$top/tests/parts/same-picture" "$BATS_TEST_TMPDIR/$k.png" "$top/docs/pictures/$k.png"; done
}
