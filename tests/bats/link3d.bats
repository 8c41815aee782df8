#!/usr/bin/env bats
# link3d in the chain: curves in, strokes out.  Needs only the build's bin on the PATH.

bats_require_minimum_version 1.5.0

setup() {
    cd "$BATS_TEST_TMPDIR"
    # a plate of 12 x 12 x 0.6 mm, and on it two towers of 3 x 3 mm: 15 layers in all
    box plate 0 0 0 12 12 0.6 > part.stl
    box near 1 1 0.6 4 4 3 >> part.stl
    box far 8 8 0.6 11 11 3 >> part.stl
}

# box NAME X Y Z X Y Z: an ASCII STL solid
box() {
    awk -v n="$1" -v a="$2 $3 $4" -v b="$5 $6 $7" 'BEGIN {
        split(a, lo, " "); split(b, hi, " ")
        split("0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5", t, " ")
        print "solid " n
        for (i = 1; i <= 36; ++i) {
            if (i % 3 == 1) print "facet normal 0 0 0\nouter loop"
            k = t[i]
            print "vertex", (k % 2 ? hi[1] : lo[1]), (int(k / 2) % 2 ? hi[2] : lo[2]), (k > 3 ? hi[3] : lo[3])
            if (i % 3 == 0) print "endloop\nendfacet"
        }
        print "endsolid " n
    }'
}

paths() { slice part.stl | regions | sequence "$@" | fill > part.paths; }

# program FILE: G-code of a toolpath
program() { postproc --machine marlin "$1" > part.gcode; }

# stops in part.gcode: travels or retractions between extrusions
stops() {
    awk '/^;LAYER/ { part = 1 } # before it: the purge line
         part && /^G[01] / { e = 0; xy = 0; for (i = 2; i <= NF; ++i) { if ($i ~ /^E/) e = substr($i, 2) + 0; if ($i ~ /^[XY]/) xy = 1 }
             if (xy && e > 0) { if (idle && printed) ++n; idle = 0; printed = 1 } else if (xy || e < 0) idle = 1 }
         END { print n + 0 }' part.gcode
}

@test "one tower on a plate is one stroke without a stop" {
    box plate 0 0 0 12 12 0.6 > part.stl
    box far 8 8 0.6 11 11 3 >> part.stl
    paths
    run --separate-stderr link3d part.paths -o part.toolpath
    [ "$status" -eq 0 ]
    [ -z "$stderr" ]
    program part.toolpath
    [ "$(stops)" -eq 0 ]
}

@test "a second tower costs one stop, or as many as layers if it must be so" {
    paths
    link3d part.paths -o part.toolpath
    program part.toolpath
    [ "$(stops)" -eq 1 ]
    paths --order layers
    link3d part.paths -o part.toolpath
    program part.toolpath
    [ "$(stops)" -ge 12 ]
}

@test "the first layer begins a stroke wherever the option says" {
    paths
    link3d --seam inside part.paths -o inside.toolpath
    link3d --seam nearest part.paths -o nearest.toolpath
    if cmp -s inside.toolpath nearest.toolpath; then return 1; fi
    program inside.toolpath
    [ "$(stops)" -eq 1 ]
}

@test "without reach only what touches is joined" {
    # pillars of one small ring each, which lies between two rings of the plate: at 3 and 3.4 mm from its side
    box plate 0 0 0 12 12 0.6 > part.stl
    box near 2.95 5.5 0.6 3.45 6.0 3 >> part.stl
    box far 8.55 5.5 0.6 9.05 6.0 3 >> part.stl
    slice part.stl | regions | sequence | fill --pattern contour > part.paths
    run --separate-stderr link3d --reach 0 part.paths -o part.toolpath
    [ "$status" -eq 0 ]
    [[ "$stderr" == *"[join-"* ]]
    program part.toolpath
    [ "$(stops)" -gt 1 ]
}

@test "the same bytes from a pipe and a file, and as few strokes with the least look-ahead" {
    paths
    link3d --look-ahead 100 part.paths > a.toolpath
    cat part.paths | link3d --look-ahead 100 -o b.toolpath
    cmp a.toolpath b.toolpath
    link3d --look-ahead 1 part.paths > d.toolpath
    program d.toolpath
    [ "$(stops)" -eq 1 ]
}

@test "travels clear the head that is given, as the history says" {
    paths
    link3d part.paths -o ordinary.toolpath
    link3d --head ordinary part.paths -o same.toolpath
    cmp ordinary.toolpath same.toolpath
    link3d --head none part.paths -o none.toolpath
    link3d --head bio-x part.paths -o bio.toolpath
    peek --script none.toolpath | grep -q 'link3d .*--head=none'
    peek --script bio.toolpath | grep -q 'link3d .*--carriage=60,60'
    if peek --script ordinary.toolpath | grep -q 'carriage'; then return 1; fi
    run link3d --head nothing part.paths
    [ "$status" -eq 2 ]
}

@test "a cut stream and a wrong one are refused" {
    paths
    head -c -20 part.paths > cut.paths
    run link3d cut.paths -o part.toolpath
    [ "$status" -eq 4 ]
    [ ! -e part.toolpath ]
    slice part.stl > part.layers
    run link3d part.layers -o part.toolpath
    [ "$status" -eq 3 ]
    run link3d --reach -1 part.paths
    [ "$status" -eq 2 ]
}

# figure FILE NAME: the number that metrics gives for NAME
figure() { metrics "$1" | sed -n "s/^  $2  *\([0-9.]*\).*/\1/p" | head -1; }

@test "interlaced starts are three beads apart, without a stop" {
    box plate 0 0 0 12 12 3 > part.stl
    paths
    link3d part.paths -o none.toolpath
    [ "$(figure none.toolpath 'nearer than three beads')" -eq 14 ]
    for scheme in alternate golden; do
        run --separate-stderr link3d --interlace $scheme part.paths -o $scheme.toolpath
        [ "$status" -eq 0 ]
        [ -z "$stderr" ]
        [ "$(figure $scheme.toolpath 'nearer than three beads')" -eq 0 ]
        [ "$(figure $scheme.toolpath crossings)" -eq 0 ]
        program $scheme.toolpath
        [ "$(stops)" -eq 0 ]
    done
    run link3d --interlace often part.paths -o part.toolpath
    [ "$status" -eq 2 ]
}

@test "connectors join two towers in one stroke, and say what is to be trimmed" {
    box one 0 0 0 4 4 1 > part.stl
    box two 12 0 0 16 4 1 >> part.stl
    paths --order layers
    run --separate-stderr link3d --connect outside part.paths -o outside.toolpath
    [ "$status" -eq 0 ]
    [[ "$stderr" == *"5 connectors are to be trimmed off"* ]]
    program outside.toolpath
    [ "$(stops)" -eq 0 ]
    [ "$(figure outside.toolpath 'joins by connector')" -eq 5 ]
    link3d --connect inside part.paths -o inside.toolpath
    program inside.toolpath
    [ "$(stops)" -eq 0 ]
    [ "$(figure inside.toolpath 'joins by connector')" -eq 0 ]
    run link3d --connect around part.paths
    [ "$status" -eq 2 ]
}

@test "ramps lose no stroke and no material" {
    box plate 0 0 0 12 12 3 > part.stl
    paths
    link3d part.paths -o plain.toolpath
    link3d --lift ramp part.paths -o ramp.toolpath
    program ramp.toolpath
    [ "$(stops)" -eq 0 ]
    [ "$(figure ramp.toolpath crossings)" -eq 0 ]
    plain=$(figure plain.toolpath volume) ramp=$(figure ramp.toolpath volume)
    [ "$(echo "$ramp > 0.995 * $plain && $ramp < 1.005 * $plain" | bc)" -eq 1 ]
}
