# The same part as other triangles or in another place gives the same regions and strokes.

setup() {
    load common
    top="$BATS_TEST_DIRNAME/../.."
    cd "$BATS_TEST_TMPDIR"
}

# regions_and_strokes MESH [HAIRLINE]: "REGIONS STROKES"
regions_and_strokes() {
    slice --hairline 0 "$1" --quiet | regions --hairline "${2:-0}" --quiet -o m.regions
    sequence m.regions --report 2>&1 >m.sequence | awk '$2 == "regions" { r = $3 } $2 == "planned-strokes" { s = $3 } END { print r, s }'
}

# same PART KIND...: each kind gives what the part itself does.
same() {
    local part=$1 kind want got
    shift
    "$BATS_TEST_DIRNAME"/vary-mesh as-is "$part" v.stl
    want=$(regions_and_strokes v.stl)
    for kind in "$@"; do
        "$BATS_TEST_DIRNAME"/vary-mesh "$kind" "$part" v.stl
        got=$(regions_and_strokes v.stl)
        echo "$part $kind: $got, as it is: $want"
        [ "$got" = "$want" ]
    done
}

@test "benchy: other triangles" { same "$top"/examples/benchy/benchy.stl permute split jitter; }

@test "benchy: other places" { same "$top"/examples/benchy/benchy.stl shift mirror turn90 turn; }

@test "bar and bracket" {
    for part in bar/bar.stl bracket/bracket.ply; do
        same "$top"/examples/$part permute split jitter shift mirror turn90 turn
    done
}

@test "a gyroid" {
    "$top"/examples/gyroid/make-gyroid g.stl --size 12 12 8
    same g.stl permute split jitter shift mirror turn90 turn
}

@test "scaffold blanks" {
    "$top"/examples/scaffold/make-part ring 12 6 3 ring.stl
    "$top"/examples/scaffold/make-part ell 12 9 4 3 ell.stl
    for part in ring ell; do same $part.stl permute split jitter shift mirror turn90 turn; done
}

# Boxes at random, some of them side by side with gaps of any width.
pins() {
    boxes "$1" $(python3 - "$2" << 'END'
import random, sys
chance = random.Random(int(sys.argv[1]))
for i in range(25):
    x, y, w, d = (chance.uniform(0, 16), chance.uniform(0, 16), chance.uniform(0.6, 3), chance.uniform(0.6, 3))
    h = 0.2 * chance.randrange(5, 40)
    print(",".join("%.4f" % v for v in (x, y, 0, x + w, y + d, h)))
    if i % 3 == 0:
        g = chance.choice((0, 0.004, 0.02, 0.03, 0.07, 0.1))
        print(",".join("%.4f" % v for v in (x + w + g, y + d / 3, 0, x + w + g + 1, y + d, h)))
END
)
}

@test "boxes at random" {
    for seed in 1 2 3 4 5 6; do
        pins p$seed.stl $seed
        same p$seed.stl permute split jitter shift mirror turn90 turn
    done
}

# The rule holds for any width; where a gap is as wide as a hairline within what a mesh is rounded to, either may come
# out on each layer, but nothing else.
@test "gaps of just a hairline: between what a little more and a little less give" {
    for gap in 0.0410 0.0425 0.0428 0.0429 0.0432 0.0445; do
        boxes g.stl 0,0,0,4,4,2 "$(python3 -c "print(4 + $gap)"),1,0,8,3,2"
        least=$(regions_and_strokes g.stl 0.0469) most=$(regions_and_strokes g.stl 0.0389)
        for kind in as-is split jitter mirror turn; do
            "$BATS_TEST_DIRNAME"/vary-mesh $kind g.stl v.stl
            got=$(regions_and_strokes v.stl)
            echo "$gap $kind: $got"
            [ "${got% *}" -ge 10 ]
    [ "${got% *}" -le 20 ]
        done
        [ "$least" = "10 1" ]
        [ "${most% *}" = 20 ]
    done
}
