# Parts with islands that begin in the air: programs begin on the bed, and layers begin in their order.

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
}

# Each line of input: x0 x1 y0 y1 z0 z1, mm; a box as ASCII STL.
boxes() {
    awk 'function tri(a, b, c) {
             print "facet normal 0 0 0\nouter loop\nvertex " p[a] "\nvertex " p[b] "\nvertex " p[c] "\nendloop\nendfacet"
         }
         BEGIN { print "solid s" }
         {
             for (i = 0; i < 8; ++i) p[i] = $(1 + i % 2) " " $(3 + int(i / 2) % 2) " " $(5 + int(i / 4))
             n = split("0 2 3 0 3 1 4 5 7 4 7 6 0 1 5 0 5 4 2 6 7 2 7 3 0 4 6 0 6 2 1 3 7 1 7 5", c, " ")
             for (i = 1; i < n; i += 3) tri(c[i], c[i + 1], c[i + 2])
         }
         END { print "endsolid s" }'
}

# A table of three legs with stalactites, and a body that floats beside it: SEED.
part() {
    awk -v seed="$1" 'BEGIN {
        srand(seed)
        for (i = 0; i < 3; ++i) print 9 * i, 9 * i + 3, 0, 4, 0, 6 # legs
        print 0, 21, 0, 12, 6, 7.2                                  # the roof
        for (i = 0; i < 4; ++i) {
            x = 5 * i + rand(); y = 6 + 4 * rand(); z = 0.2 + 5.6 * rand()
            print x, x + 2, y, y + 1.5, z, 6
        }
        z = 0.5 + 4 * rand()
        print 24, 27, 2, 5, z, z + 1.2
    }' | boxes
}

# The program begins on the bed; no layer begins before the one below it, and the fan not before layer 1.
from_below() { # PROGRAM
    awk '/^;LAYER:/ {
             layer = substr($0, 8) + 0
             if (layer > most + 1 || (most == "" && layer > 0)) bad = bad " layer " layer " after " most
             if (layer > most || most == "") most = layer
         }
         /^M106 S[1-9]/ && most < 1 { bad = bad " fan on layer " most }
         END { if (bad != "" || most < 30) { print bad, most; exit 1 } }' "$1"
}

@test "what hangs waits for its part, whatever the order and the options" {
    for seed in 1 2; do
        part $seed > part.stl
        for options in '' '--head none' '--order layers' '--cone-height 2' '--infill 15%' '--support' '--copies 2' \
            '--pause-at 12' '--interlace golden' '--lift ramp'; do
            filum print part.stl --layer-height 0.2 $options -o out.gcode 2> err || { echo "$options"; cat err; false; }
            from_below out.gcode || { echo "seed $seed, $options"; false; }
        done
    done
}

@test "a second part on the bed is printed in as many strokes as alone" {
    part 3 > part.stl
    strokes() { filum print part.stl "$@" --head marlin -o - 2> err | sed -nE 's/^; ([0-9]+) strokes?.*stops?$/\1/p'; }
    one=$(strokes)
    two=$(strokes --copies 2)
    echo "$one $two"
    [ "$two" -le $((2 * one)) ]
}

@test "parts with hanging islands at random: first bead on the bed, nothing before what lies below it" {
    "$FILUM_SOURCE/tests/parts/random-hanging" 1 12
    "$FILUM_SOURCE/tests/parts/random-hanging" 50026 # a start set apart lies beyond a leg that is already printed
}

@test "connectors and strands keep clear of what is printed below them later, and of themselves" {
    "$FILUM_SOURCE/tests/parts/random-connect" 0 9
}
