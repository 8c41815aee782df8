#!/usr/bin/env bats
# No option of any command does nothing in silence, and none takes what it cannot use.  Both go by --print-contract, so that
# a new option is covered by being there, or fails for want of a case in tests/options/witness.tsv.

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    make_inputs
    make_more_inputs
}

setup() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    tools=$BATS_TEST_DIRNAME/../options
}

# What the cases of witness.tsv need besides.
make_more_inputs() {
    "$FILUM_SOURCE/tests/threemf/two-plates" plates.3mf
    "$FILUM_SOURCE/tests/threemf/painted-seam" painted.3mf
    boxes two.stl 0,0,0,5,5,4 7,0,0,12,5,4   # columns beside each other
    boxes apart.stl 0,0,0,5,5,1 5.01,0,0,9,5,1 # a hairline apart
    boxes frame.stl 0,0,0,9,2,1 0,7,0,9,9,1 0,2,0,2,7,1 7,2,0,9,7,1 # round a hole
    boxes thin.stl 0,0,0,12,0.3,1            # a wall thinner than a bead
    boxes neck.stl 0,0,0,4,4,1 4,1.8,0,8,2.2,1 8,0,0,12,4,1 0,0,1,4,4,2 3.9,0,1,4.1,0.3,2 # a narrow way between
    boxes ledge.stl 0,0,0,20,12,0.6 0,0,0,4,12,4 0,0,3,14,12,4 # overhangs its own foot
    boxes cutter.stl -20,-3,-5,3,20,5
    half_ball 6 > round.off
    without_triangles 3 < round.off > holed.off
    slice two.stl | regions --output two.regions
    boxes nested.stl 0,0,0,20,2,1 0,18,0,20,20,1 0,0,0,2,20,1 18,0,0,20,20,1 9,9,0,11,11,1
    slice nested.stl | regions --output nested.regions
    boxes ink-a.stl 0,0,0,4,4,0.4 6,0,0,10,4,0.2 3,0,0.4,10,4,0.6 # and the other ink's: few strokes or few tool changes
    boxes ink-b.stl 6,0,0.2,10,4,0.4 0,0,0.4,2.5,4,0.6
    slice --body ink-a.stl --body ink-b.stl:tool=1 | regions --output inks.regions
    sequence two.regions | fill | link3d --output two.toolpath
    sequence --head none two.regions | fill | link3d --head none --output needle.toolpath
    collide --strict=false --places places.tsv needle.toolpath --output hit.toolpath 2> /dev/null
    geodesic part.stl --output box.surface
    geodesic part.stl | partition --output box.patches
    geodesic part.stl --cut 0,0,1,0.9 --source plane:1,0,0,4.5 --output rows.surface
    surfpath fina rows.surface --output rows.toolpath
    printf '0 0 1 5 0 0\n9 0 1 5 0 0\n9 9 1 5 2 0\n0 9 1 1 0 0\n' > stress.csv
    printf '0 0 1.5 5 0 0\n9 0 1.5 5 0 0\n9 9 1.5 5 2 0\n0 9 1.5 1 1 0\n' > high.csv
    printf '0 0 1 5 0 0\n9 0 1 5 0 0\n9 9 1 "5,125" 2 0\n0 9 1 1 0 0\n' > group.csv
    cp "$FILUM_SOURCE/tests/fuzz/seeds/stress_read/1.vtu" box.vtu
    stressfield --stress stress.csv --case X --reach 1 box.surface --output box.stress 2> /dev/null
    printf '0 0 1 0 9 0\n9 0 1 0 9 0\n9 9 1 0 9 0\n0 9 1 0 9 0\n' > across.csv
    stressfield --stress across.csv --case Y --reach 1 box.stress --output both.stress 2> /dev/null
    collide --strict=false --gantry-height 0.5 --places gantry.tsv needle.toolpath --output hit.toolpath 2> /dev/null
    filum print part.stl --output part.gcode
    filum print two.stl --output two.gcode
    boxes small.stl 0,0,0,2,2,1.2 3,0,0,5,2,1.2
    slice --layer-height 0.4 small.stl | regions | sequence --head none | fill | link3d --head none -o small.toolpath
    boxes one.stl 0,0,0,1.6,1.6,0.6 # and a wall beside it, which a tool leans away from
    boxes wall.stl -1.5,-5,0,-1,7,6
    slice one.stl --quiet | regions | sequence --head none | fill | link3d --head none --output one.toolpath
    boxes towers.stl 0,0,0,12,5,1 0,0,1,4,5,3 8,0,1,12,5,3
    slice towers.stl | regions --output towers.regions
    half_ball 6 | without_triangles 60 > open.off
    geodesic part.stl --remesh 1 --output fine.surface
    stressfield --stress stress.csv --case X --tangent --reach 9 fine.surface --output fine.stress 2> /dev/null
    geodesic round.off --output round.surface
    geodesic round.off --remesh 0.25 --output needless.surface
    printf '1 1 0\n14 1 0\n' > lines.txt
    printf 'angle side\n30 over\n30 under\n' > plies.txt
    printf '9 0 0\n0 9 0\n-9 0 0\n0 -9 0\n' > diamond.txt
    printf 'angle within\n0 diamond.txt\n0 diamond.txt\n' > steps.txt
    sed 's/^\[limits\].*/[limits]\nturn_outside = 1/' "$FILUM_SOURCE/lib/motion/machine/profiles/linuxcnc-xyzac.toml" > tight.toml
}

# without_triangles N: an OFF file without its last ones.
without_triangles() { awk -v n="$1" 'NR == 2 { $2 -= n; most = 2 + $1 + $2 } NR < 3 || NR <= most'; }

# half_ball RADIUS: the upper half, closed by a disc.
half_ball() {
    python3 - "$1" << 'END'
import math
import sys

radius, around, up = float(sys.argv[1]), 48, 12
points, faces = [(0, 0, 0), (0, 0, radius)], []
for j in range(up):
    for i in range(around):
        a, b = 2 * math.pi * i / around, math.pi / 2 * j / up
        points.append((radius * math.cos(a) * math.cos(b), radius * math.sin(a) * math.cos(b), radius * math.sin(b)))
at = lambda j, i: 2 + j * around + i % around
for i in range(around):
    faces.append((0, at(0, i + 1), at(0, i)))
    faces.append((1, at(up - 1, i), at(up - 1, i + 1)))
    for j in range(up - 1):
        faces += [(at(j, i), at(j, i + 1), at(j + 1, i + 1)), (at(j, i), at(j + 1, i + 1), at(j + 1, i))]
print("OFF", f"{len(points)} {len(faces)} 0", sep="\n")
for p in points:
    print(*p)
for f in faces:
    print(3, *f)
END
}

@test "an option changes the result or says why not" { python3 "$tools/effect.py" try; }

@test "what acts only on some parts has a part on which it acts" { python3 "$tools/effect.py" witness; }

@test "every number has its limits, and no value ends in more than a message" { python3 "$tools/limits.py"; }
