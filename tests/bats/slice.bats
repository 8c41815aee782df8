#!/usr/bin/env bats
# slice as a user meets it: what it says to bad input, and that what it writes does not depend on how it is run.

bats_require_minimum_version 1.5.0

setup() {
    PATH="$(cd "$(dirname "$(command -v slice)")" && pwd):$PATH" # a relative entry must outlive the cd
    cd "$BATS_TEST_TMPDIR" || return 1
    cube 10 > cube.obj
}

# An OBJ cube of size $1, moved by $2 (x), as quads.
cube() {
    awk -v s="$1" -v d="${2:-0}" 'BEGIN {
        for (i = 0; i < 8; i++) print "v", d + s * (i % 2), s * (int(i / 2) % 2), s * int(i / 4)
        print "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6" }'
}

# ASCII STL of a tetrahedron.
tetrahedron() {
    echo "solid t"
    for f in "0 0 0 0 9 0 9 0 0" "0 0 0 9 0 0 0 0 9" "0 0 0 0 0 9 0 9 0" "9 0 0 0 9 0 0 0 9"; do
        # shellcheck disable=SC2086
        set -- $f
        printf 'facet normal 0 0 0\nouter loop\nvertex %s %s %s\nvertex %s %s %s\nvertex %s %s %s\nendloop\nendfacet\n' "$@"
    done
    echo "endsolid t"
}

# Runs slice with the rest of the arguments; wants exit code $1, nothing on standard output that is a whole stream, and
# the text $2 on standard error.
refuses() {
    local code=$1 text=$2
    shift 2
    run --separate-stderr -"$code" slice "$@" -o out.layers
    [ ! -e out.layers ]
    # shellcheck disable=SC2154
    case "$stderr" in *"$text"*) ;; *) echo "said: $stderr"; return 1 ;; esac
    case "$stderr" in "slice: "*) ;; *) return 1 ;; esac
}

@test "a clean part: exit 0, nothing on standard error, a stream that checks" {
    run --separate-stderr -0 slice cube.obj -o cube.layers
    [ -z "$stderr" ]
    peek --check cube.layers
}

@test "the same bytes from a file, from a pipe, and with 1, 2 and 8 threads" {
    slice cube.obj > a
    slice < cube.obj > b
    cat cube.obj | slice - > c
    cmp a b
    cmp a c
    for n in 1 2 8; do
        slice --threads $n --rotate 20,30,40 cube.obj > t$n
        cmp t1 t$n
    done
}

@test "the name of a file does not matter, its content does" {
    cp cube.obj wrong.stl
    slice wrong.stl > a
    slice cube.obj > b
    cmp a b
}

@test "the input is known again by its checksum" {
    slice cube.obj > a
    cube 10 1e-9 > other.obj
    slice other.obj > b
    run -1 cmp -s a b
}

@test "files that are no mesh" {
    refuses 5 "cannot open 'none.stl'" none.stl
    : > empty.stl
    refuses 4 "'empty.stl': it is empty" empty.stl
    echo "hello, world" > words.stl
    refuses 3 "it is no STL, OBJ, PLY, OFF, 3MF, AMF or STEP file" words.stl
    head -c 300 /dev/zero > zeros.stl
    refuses 3 "it is no STL" zeros.stl
    slice cube.obj > part.layers
    refuses 3 "it is a Filum stream, not a mesh" part.layers
    refuses 5 "cannot read '.'" .
}

@test "files that are cut short" {
    tetrahedron > t.stl
    slice t.stl > t.layers
    head -c 300 t.stl > cut.stl
    refuses 4 "ends inside a facet" cut.stl
    { head -c 80 /dev/zero; printf '\050\000\000\000'; head -c 500 /dev/zero; } > cut2.stl
    refuses 4 "it announces 40 triangles and ends after 10" cut2.stl
    printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n' > cut.off
    refuses 4 "it ends before its last face" cut.off
    printf 'ply\nformat ascii 1.0\nelement vertex 99999999\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n' > cut.ply
    refuses 4 "ends before the last element" cut.ply
    printf 'ply\nformat ascii 1.0\nelement ver' > head.ply
    refuses 3 "" head.ply
}

@test "files that are malformed" {
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' > index.obj
    refuses 3 "a face has vertex 9 of 3" index.obj
    printf 'v 0 zero 0\n' > number.obj
    refuses 3 "line 1: a vertex takes three numbers" number.obj
    printf 'PK\003\004nothing that a zip archive would hold, though it begins as one does\n' > no.3mf
    refuses 3 "it is no whole zip archive" no.3mf
    printf 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 1 2\n' > flat.obj
    refuses 3 "it holds no triangle with an area" flat.obj
    printf 'v nan 0 0\nv 1 0 0\nv 0 1 5\nf 1 2 3\n' > nan.obj
    refuses 3 "it holds no triangle with an area" nan.obj
}

@test "parts that cannot be sliced" {
    refuses 3 "lower than half a layer" --scale 1,1,0.009 cube.obj
    refuses 3 "more than 1000000 layers" --scale 1,1,100000 cube.obj
    refuses 3 "beyond 10000 m" --scale 1e6,1e6,0.01 --translate 1e7,0,0 cube.obj
    refuses 2 "scale" --scale 1e9 cube.obj
    refuses 2 "translate" --translate 1e300,0,0 cube.obj
}

@test "a part lower than a layer gets one, and is told" {
    run --separate-stderr -0 slice --scale 1,1,0.015 cube.obj -o a
    case "$stderr" in *"the part is only 0.15 mm high, lower than its one layer"*) ;; *) echo "$stderr"; false ;; esac
    case "$stderr" in *"the printed volume is 33.3 % above the mesh's (5 mm3)"*) ;; *) echo "$stderr"; false ;; esac
}

@test "options that cannot be obeyed" {
    refuses 2 "--layer-height" --layer-height 0 cube.obj
    refuses 2 "--layer-height" --layer-height=-1 cube.obj
    refuses 2 "--layer-height" --layer-height thick cube.obj
    refuses 2 "--unit" --unit furlong cube.obj
    refuses 2 "nothing would be left" --scale 0 cube.obj
    refuses 2 "one number or three" --scale 1,2 cube.obj
    refuses 2 "--rotate" --rotate 1,2 cube.obj
    refuses 2 "above --max-layer-height" --adaptive --min-layer-height 1 cube.obj
    refuses 2 "--thickness" --thickness cube.obj
}

@test "what is broken is repaired and told, and --quiet is quiet" {
    grep -v "f 2 4 8 6" cube.obj > open.obj
    run --separate-stderr -0 slice open.obj -o a
    case "$stderr" in *"contours lead across holes of the surface for 500 mm (50 places)"*) ;; *) echo "$stderr"; false ;; esac
    run --separate-stderr -0 slice -q open.obj -o b
    [ -z "$stderr" ]
    cmp a b
    sed 's/f 2 4 8 6/f 6 8 4 2/' cube.obj > flipped.obj
    run --separate-stderr -0 slice --notes all flipped.obj -o c
    case "$stderr" in *"2 triangles were turned to face like the neighbours"*) ;; *) echo "$stderr"; false ;; esac
}

@test "what holds nothing is refused" {
    printf 'v 0 0 0\nv 5 0 0\nv 5 0 2\nv 0 0 2\nf 1 2 3 4\n' > sheet.obj
    refuses 3 "its surface is open, and nothing lies within it" sheet.obj
}

@test "a corner that is no number is left out and told" {
    { cat cube.obj; printf 'v nan 0 0\nf 1 2 9\n'; } > nan.obj
    run --separate-stderr -0 slice nan.obj -o a
    case "$stderr" in *"1 triangle with a corner that is not a finite number was dropped"*) ;; *) echo "$stderr"; false ;; esac
}

@test "a full disk and a reader that leaves" {
    [ -w /dev/full ] || skip "no /dev/full"
    run --separate-stderr -5 slice cube.obj -o /dev/full
    slice cube.obj | head -c 10 > part
    [ "$(wc -c < part)" -eq 10 ]
}

@test "parts of unlikely size are told before any work, impossible ones refused" {
    run --separate-stderr -0 slice --scale 0.09 --unit in --layer-height 0.01 cube.obj -o a
    [ -z "$stderr" ] # 23 mm
    run --separate-stderr -0 slice --scale 0.2,0.2,0.2 --layer-height 0.1 cube.obj -o a
    [ -z "$stderr" ] # 2 mm, by the caller's own factor
    sed 's/10/2.54/g' cube.obj > inches.obj
    run --separate-stderr -0 slice inches.obj -o a
    case "$stderr" in *"only 2.54 mm long; its file may be in inches or metres; give --unit"*) ;; *) echo "$stderr"; false ;; esac
    run --separate-stderr -0 slice --unit m --layer-height 100 cube.obj -o a
    case "$stderr" in *"10000 mm long, more than most machines can print; give --unit"*) ;; *) echo "$stderr"; false ;; esac
    refuses 3 "it is 254 x 254 x 254 mm, and the machine reaches 220 x 220 x 250 mm" --unit in --machine marlin cube.obj
    sed 's/^x = \[0, 220\]/x = [0, 300]/' "$BATS_TEST_DIRNAME/../../lib/motion/machine/profiles/marlin.toml" > ./wide.toml
    refuses 3 "turn it by --rotate 0,0,90" --scale 2,25,1 --machine ./wide.toml cube.obj
    run -0 slice --scale 25,2,1 --machine ./wide.toml cube.obj -o a
    refuses 2 "marlyn" --machine marlyn cube.obj
}

@test "coordinates that single precision has rounded are told" {
    awk '$1 == "v" { $2 = 9000000 + $2; $3 -= 8000000 } { print }' cube.obj > far.obj
    run --separate-stderr -0 slice far.obj -o a
    case "$stderr" in *"far from the origin are rounded to 1 units of the file"*"300 mm3"*) ;; *) echo "$stderr"; false ;; esac
    awk '$1 == "v" { $2 = sprintf("%.2f", 9000000.01 + $2) } { print }' cube.obj > double.obj # more digits than that
    run --separate-stderr -0 slice double.obj -o a
    [ -z "$stderr" ]
}

@test "beads that cannot fit are refused by regions" {
    slice cube.obj -o a
    run --separate-stderr -2 regions --bead-width 11 a -o b
    case "$stderr" in *"wider than all of it"*) ;; *) echo "$stderr"; false ;; esac
    run --separate-stderr -2 regions --bead-width 0.1 a -o b
    case "$stderr" in *"a bead is no higher than it is wide"*) ;; *) echo "$stderr"; false ;; esac
    [ ! -e b ]
    slice --scale 0.05,1,1 cube.obj -o a
    run --separate-stderr -0 regions --bead-width 0.6 a -o b
    case "$stderr" in *"only 0.5 mm wide, narrower than a bead"*) ;; *) echo "$stderr"; false ;; esac
    slice --scale 250,250,0.1 cube.obj -o a 2> said
    run --separate-stderr -3 regions a -o b
    case "$stderr" in *"it takes 15.6 km of them and gigabytes of memory"*) ;; *) echo "$stderr"; false ;; esac
}

@test "what a file is that is no mesh" {
    cp cube.obj part.OBJ
    python3 - << 'EOF'
import zipfile
one, two, none, twice = (zipfile.ZipFile(name, "w") for name in ("one.zip", "two.zip", "none.zip", "twice.zip"))
one.write("part.OBJ"); one.writestr("readme.txt", "x")
two.write("part.OBJ"); two.write("cube.obj")
none.writestr("readme.txt", "x")
one.close(); two.close(); none.close()
twice.write("one.zip", "part.3mf"); twice.close()
EOF
    cmp <(slice cube.obj | peek --frames) <(slice one.zip | peek --frames)
    refuses 3 "it is a ZIP archive that holds 'part.OBJ', 'cube.obj'; unpack it and give the one you want" two.zip
    refuses 3 "it is a ZIP archive, but no 3MF, and holds no mesh" none.zip
    refuses 3 "it is a ZIP archive that holds another one, 'part.3mf'; unpack it first" twice.zip
    printf 'glTF\002\000\000\000%0200d' 0 > a.glb
    refuses 3 "it is a GLB file (binary glTF); export it as STL, 3MF or PLY" a.glb
    printf '; by hand\nsolid a\nfacet normal 0 0 1\n' > a.stl
    refuses 3 "it is an ASCII STL with 1 line before 'solid'; remove it" a.stl
}

# noisy FILE FROM: a disc of radius 30 with 32,000 vertices, each at a random radius from FROM
noisy() {
    python3 - "$@" << 'END'
import math
import random
import struct
import sys

chance = random.Random(5)
n = 32000
ring = [(r * math.cos(2 * math.pi * k / n), r * math.sin(2 * math.pi * k / n))
        for k in range(n) for r in [chance.uniform(float(sys.argv[2]), 30)]]
with open(sys.argv[1], "wb") as f:
    f.write(bytes(80) + struct.pack("<I", 4 * n))
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        for t in ((0, 0, 0, bx, by, 0, ax, ay, 0), (0, 0, 0.2, ax, ay, 0.2, bx, by, 0.2),
                  (ax, ay, 0, bx, by, 0, bx, by, 0.2), (ax, ay, 0, bx, by, 0.2, ax, ay, 0.2)):
            f.write(struct.pack("<12x9fH", *t, 0))
END
}

@test "an outline of 32,000 noisy vertices takes about a second a layer" {
    noisy noisy.stl 29.9
    slice noisy.stl --quiet -o noisy.layers
    bash -c 'ulimit -t 3; regions --quiet noisy.layers -o noisy.regions' # 4 s when patches were united at once
    [[ $(peek --text noisy.regions | grep -c '^region') -ge 1 ]]
}

@test "32,000 spikes as long as the part are refused within seconds, with a place" {
    for from in 15 3; do
        noisy spikes.stl "$from"
        slice spikes.stl --quiet -o spikes.layers
        run -3 bash -c 'ulimit -t 4; regions --quiet spikes.layers -o spikes.regions'
        [[ $output == *"cannot close the gaps of layer 0: along more than 85 m"*" as at "* ]]
    done
}
