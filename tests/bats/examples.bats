# The demo parts and the programs beside them.

setup() {
    top="$BATS_TEST_DIRNAME/../.."
    cd "$BATS_TEST_TMPDIR"
}

# Every directed edge of a binary STL occurs once, and once the other way.
closed_manifold() {
    python3 - "$1" <<'END'
import struct, sys
data = open(sys.argv[1], "rb").read()
count = struct.unpack_from("<I", data, 80)[0]
assert count > 0 and len(data) == 84 + 50 * count
edges = {}
for i in range(count):
    corner = [data[96 + 50 * i + 12 * k:108 + 50 * i + 12 * k] for k in range(3)]
    for k in range(3):
        edge = corner[k], corner[(k + 1) % 3]
        edges[edge] = edges.get(edge, 0) + 1
assert all(n == 1 and edges.get((b, a)) == 1 for (a, b), n in edges.items())
END
}

@test "make-gyroid: closed, manifold, the same bytes again" {
    for arguments in "--size 6 6 4" "--size 5 7 3 --step 0.7" "--size 4 4 4 --cell 3 --wall 1.5 --step 0.4"; do
        $top/examples/gyroid/make-gyroid $arguments a.stl
        closed_manifold a.stl
        $top/examples/gyroid/make-gyroid $arguments b.stl
        cmp a.stl b.stl
    done
}

@test "make-gyroid: wrong arguments, a folder that is not there" {
    run $top/examples/gyroid/make-gyroid
    [ "$status" -eq 2 ]
    run $top/examples/gyroid/make-gyroid --cell 0 a.stl
    [ "$status" -eq 2 ]
    run $top/examples/gyroid/make-gyroid --size 1 1 nowhere/a.stl
    [ "$status" -eq 2 ]
    run $top/examples/gyroid/make-gyroid --size 3 3 3 nowhere/a.stl
    [ "$status" -eq 5 ]
    [[ "$output" == *"cannot write to 'nowhere/a.stl'"* ]]
}

@test "to-layers: a stream that passes peek --check, a layer per slice" {
    $top/examples/slices/to-layers -o s.layers "$top"/examples/slices/*.txt
    peek --check s.layers
    regions s.layers -o s.regions
    layers=$(peek --json s.layers | python3 -c 'import json, sys; print(len(json.load(sys.stdin)["frames"]))')
    [ "$layers" -eq "$(ls "$top"/examples/slices/*.txt | wc -l)" ]
}

@test "to-layers: bad slices" {
    printf '0.3\n0.7\n3\n0 0\n1 0\n' >short.txt
    run $top/examples/slices/to-layers -o s.layers short.txt
    [ "$status" -eq 3 ]
    [[ "$output" == *"'short.txt': ends within a contour"* ]]
    printf '0.3 0.7 3 0 0 1 0 nan 1\n' >nan.txt
    run $top/examples/slices/to-layers -o s.layers nan.txt
    [ "$status" -eq 3 ]
    printf '0.3 0.7 3 0 0 1 x 0 1\n' >word.txt
    run $top/examples/slices/to-layers -o s.layers word.txt
    [ "$status" -eq 3 ]
    printf '0.3 0.7\n' >empty.txt
    run $top/examples/slices/to-layers -o s.layers empty.txt
    [ "$status" -eq 3 ]
    run $top/examples/slices/to-layers -o s.layers missing.txt
    [ "$status" -eq 5 ]
    [ ! -e s.layers ]
}

@test "gcode-strokes: hand-counted programs" {
    check() {
        [ "$("$top"/scripts/gcode-strokes "$1" | tail -n 1 | cut -f 2-5)" = "$(printf '%s\t%s\t%s\t%s' $2)" ]
    }
    # one stroke over two layers
    printf 'G90\nM83\nG0 X0 Y0 Z.2\nG1 X10 E1\nG1 Y10 E1\nG1 Z.4\nG1 X0 E1\n' >one.g
    check one.g "1 0 0 0"
    # a step of 0.4 mm is a stop, but neither travel nor end of a stroke
    printf 'G90\nM82\nG1 X10 E1\nG0 Y.4\nG1 X0 E2 ; back\n' >step.g
    check step.g "1 1 0 0"
    # a travel; then a retraction in place, G92 between; then a lift of three layers
    printf 'G90\nM82\nG1 X10 E1\nG0 X20\nG1 X30 E2\nG1 E0\nG92 E0\nG1 E2\nG1 X40 E3\nG0 Z.6\nG1 X50 E4\n' >three.g
    check three.g "4 2 1 1"
    # relative moves, firmware retraction, G10 that sets an offset
    printf 'G91\nM83\nG1 X10 E1\nG10\nG11\nG1 X10 E1\nG10 L2 P1\nG1 X5 E1\n' >relative.g
    check relative.g "2 1 0 1"
}

@test "subdivide: four times the triangles, the same volume" {
    $top/scripts/peers/subdivide "$top/examples/bar/bar.stl" fine.stl
    closed_manifold fine.stl
    [ "$(stat -c %s fine.stl)" -eq $((84 + 50 * 48)) ]
    run $top/scripts/peers/subdivide "$top/examples/bracket/bracket.ply" fine.stl
    [ "$status" -ne 0 ]
}

@test "plate: parts at their places, closed, the same bytes again" {
    plate=$top/examples/sun2019/plate
    $plate two.stl "$top/examples/bar/bar.stl" 3,4 "$top/examples/bracket/bracket.ply" 0,40
    closed_manifold two.stl
    $plate again.stl "$top/examples/bar/bar.stl" 3,4 "$top/examples/bracket/bracket.ply" 0,40
    cmp two.stl again.stl
    python3 - two.stl <<'END'
import struct, sys
data = open(sys.argv[1], "rb").read()
t = [struct.unpack_from("<12x9f", data, 84 + 50 * i) for i in range(12)]  # the bar
assert [min(min(v[k::3]) for v in t) for k in range(3)] == [3, 4, 0]
assert [max(max(v[k::3]) for v in t) for k in range(3)] == [103, 29, 3]
END
    run $plate two.stl
    [ "$status" -eq 2 ]
    run $plate two.stl "$top/examples/bar/bar.stl" here
    [ "$status" -eq 2 ]
    printf 'solid nothing\n' >text.stl
    run $plate new.stl text.stl 0,0
    [ "$status" -eq 3 ]
    run $plate new.stl missing.stl 0,0
    [ "$status" -eq 5 ]
    [ ! -e new.stl ]
}

@test "sun2019: a sample by both methods, as expected, and a line of the table" {
    mkdir sun
    cd sun
    for method in sun2019 default; do
        "$top/examples/sun2019/sample" 3 $method "$top/examples/bar/bar.stl" 3-$method
        metrics --format tsv --regions 3-$method.sequence 3-$method.toolpath -o 3-$method.tsv
    done
    awk -F '\t' 'NR == 1 || $1 ~ /^3-/' "$top/examples/sun2019/expected.tsv" >expected.tsv
    [ "$(wc -l <expected.tsv)" -gt 8 ]
    "$top/scripts/check-examples" . expected.tsv
    # every other sample has the same figures here: the table needs them all
    for name in $(awk -F '\t' '!/^#/ && $1 != "sample" {print $1}' "$top/examples/sun2019/samples.tsv"); do
        for method in sun2019 default; do [ "$name" = 3 ] || cp 3-$method.tsv "$name-$method.tsv"; done
    done
    "$top/examples/sun2019/table" . table.tsv >table.txt
    grep -q '^3  *Cs  *0.30  *0.4  *Y  60.487  sun2019  *1  *0 ' table.txt
    [ "$(awk -F '\t' '$1 == 3 && $7 == "default" {print $8, $9, $13}' table.tsv)" = "1 0 0" ]
    run "$top/examples/sun2019/sample" 8 default "$top/examples/bar/bar.stl" 8
    [ "$status" -eq 2 ]
    run "$top/examples/sun2019/sample" 3 other "$top/examples/bar/bar.stl" 3
    [ "$status" -eq 2 ]
}

@test "make-part: closed blanks, the same bytes again; wrong arguments" {
    for arguments in "block 3 4 5" "disc 6 2" "ring 8 4 2" "ell 9 7 2 3"; do
        $top/examples/scaffold/make-part $arguments a.stl
        closed_manifold a.stl
        $top/examples/scaffold/make-part $arguments b.stl
        cmp a.stl b.stl
    done
    for wrong in "" "ball 3 a.stl" "block 1 2 a.stl" "disc 0 2 a.stl" "disc nan 2 a.stl"; do
        run $top/examples/scaffold/make-part $wrong
        [ "$status" -ne 0 ]
    done
}
