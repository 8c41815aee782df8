#!/usr/bin/env bats
# What geodesic takes: meshes and streams, other meshes to cut and to measure from, and surfaces that are not as they
# should be.
# shellcheck disable=SC2154

load common

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    grid 20 10 0 > plate.off
    solid 5 -5 -5 8.5 4 5 > block.off
}

# grid N M Z: unit cells in the plane z = Z
grid() {
    awk -v n="$1" -v m="$2" -v z="$3" 'BEGIN {
        print "OFF"; print (n + 1) * (m + 1), 2 * n * m, 0
        for (j = 0; j <= m; ++j) for (i = 0; i <= n; ++i) print i, j, z
        for (j = 0; j < m; ++j) for (i = 0; i < n; ++i) {
            a = j * (n + 1) + i
            print 3, a, a + 1, a + n + 2; print 3, a, a + n + 2, a + n + 1
        }
    }'
}

# solid X0 Y0 Z0 X1 Y1 Z1: a closed box
solid() {
    echo OFF
    echo 8 12 0
    for i in 0 1 2 3 4 5 6 7; do
        echo "$((i & 1))" "$((i >> 1 & 1))" "$((i >> 2))"
    done | awk -v x0="$1" -v y0="$2" -v z0="$3" -v x1="$4" -v y1="$5" -v z1="$6" \
        '{ print $1 ? x1 : x0, $2 ? y1 : y0, $3 ? z1 : z0 }'
    printf '3 %s\n' '0 2 1' '1 2 3' '4 5 6' '5 7 6' '0 1 4' '1 5 4' '2 6 3' '3 6 7' '0 4 2' '2 4 6' '1 3 5' '3 7 5'
}

# joined A B: both OFF files as one, vertices of the same place shared by reading
joined() {
    awk 'FNR == 2 { v[++files] = $1; f += $2; all += $1; next } FNR == 1 { next }
         NF == 3 { point[++p] = $0 } NF == 4 { o = files == 1 ? 0 : v[1]; face[++q] = "3 " $2 + o " " $3 + o " " $4 + o }
         END { print "OFF"; print all, f, 0; for (i = 1; i <= p; ++i) print point[i]; for (i = 1; i <= q; ++i) print face[i] }' "$1" "$2"
}

facts() { peek "$1" | sed -n 's/^fact *geodesic: //p'; }
points() { # FILE CODE: runs CODE with p, the columns of the surface's points
    peek --json "$1" | python3 -c '
import json, math, sys
s = [f for f in json.load(sys.stdin)["frames"] if f["kind"] == "surface"][0]
p = s["points"]
exec(sys.argv[1])
' "$2"
}

@test "a stream goes on where it was: history, notes and fields stay, distances are new" {
    sed -i '2s/400/401/; $a 3 0 1 22' plate.off
    geodesic plate.off --quiet --source vertex:0 > a
    geodesic a --source plane:1,0,0,4.5 > b
    geodesic plate.off --quiet --source plane:1,0,0,4.5 > c
    cmp <(peek --text b | grep -A 300 '^surface') <(peek --text c | grep -A 300 '^surface')
    peek b | grep -q '^run 1 *geodesic .* after 0'
    peek b | grep -q '^note *geodesic: harmless: 1 triangle present more than once'
    [[ $(facts b | grep -c '^farthest-vertex') == 1 ]]
    geodesic < a > d # nothing asked: all stays
    cmp <(peek --text a | grep -A 300 '^surface') <(peek --text d | grep -A 300 '^surface')
    expect 2 geodesic a --unit cm
    complaint geodesic
    head -c 900 a > cut
    expect 4 geodesic cut
    complaint geodesic
    slice block.off > layers
    expect 3 geodesic layers
    complaint geodesic
}

@test "fields go along when a stream is cut and remeshed, lines do not" {
    geodesic plate.off --source plane:1,0,0,0 --spacing 1 > a
    expect 0 geodesic --notes all a --cut 0,1,0,7.3 --remesh 0.6 --output b
    [[ $err == *'19 isolines of the previous surface were dropped'* && $err == *'source-dropped'* ]]
    points b 'assert s["isolines"] == [], s["isolines"]
assert len(p["x"]) > 500 and max(p["y"]) < 7.3 + 1e-9
for x, d in zip(p["x"], p["distance"]): assert abs(x - d) < 1e-9, (x, d)'
}

@test "a mesh across the surface is a source like the plane it lies in" {
    grid 40 40 0 | awk 'NR < 3 { print; next } NF == 3 { print 7.3, $1 - 15.2, $2 - 20.1; next } { print }' > wall.off
    geodesic plate.off --source-mesh wall.off --signed > a
    facts a | grep -qx 'source-mesh-crossing 10 mm'
    points a 'for x, d in zip(p["x"], p["distance"]): assert abs(x - 7.3 - d) < 1e-9, (x, d)'
    geodesic plate.off --source plane:1,0,0,7.3 --signed > b
    points b 'for x, d in zip(p["x"], p["distance"]): assert abs(x - 7.3 - d) < 1e-9, (x, d)'
    peek a | grep -q 'source_mesh_crc32c = '
    peek a | run -1 grep -q wall.off
}

@test "a patch that shares a border is a source along it" {
    grid 33 5 0 | awk 'NR < 3 { print; next } NF == 3 { print $1 * 20 / 33, 10 + $2, $2; next } { print }' > flange.off
    geodesic plate.off --source-mesh flange.off > a
    facts a | grep -qx 'source-mesh-touching 20 mm'
    points a 'for y, d in zip(p["y"], p["distance"]): assert abs(10 - y - d) < 1e-9, (y, d)'
}

@test "a source mesh that misses, and sides that are none" {
    solid 50 0 0 51 1 1 > far.off
    expect 2 geodesic plate.off --source-mesh far.off
    complaint geodesic
    [[ $err == *'does not touch the surface'* ]]
    expect 5 geodesic plate.off --source-mesh nowhere.off
    echo nonsense > text.off
    expect 3 geodesic plate.off --source-mesh text.off
    expect 2 geodesic plate.off --source point:3,3,0 --signed
    [[ $err == *'no sides'* ]]
    printf '3.2 0 0\n3.3 6.1 0\n' > line.txt
    expect 2 geodesic plate.off --source-lines line.txt --signed
    [[ $err == *'do not separate'* ]]
    expect 2 geodesic plate.off --signed
    complaint geodesic
}

@test "a closed mesh cuts the surface, its outside kept or its inside" {
    geodesic plate.off --cut-mesh block.off > a
    facts a | grep -qx 'area 186 mm2'
    geodesic plate.off --cut-mesh block.off --keep inside --source boundary > b
    facts b | grep -qx 'area 14 mm2'
    facts b | grep -qx 'farthest-vertex 1.5 mm'
    expect 3 geodesic plate.off --cut-mesh plate.off
    [[ $err == *open* ]]
    solid 50 0 0 51 1 1 > far.off
    expect 2 geodesic plate.off --cut-mesh far.off --keep inside
    complaint geodesic
    solid 6 -6 -6 9 3 4 > other.off
    joined block.off other.off > crossing.off
    expect 3 geodesic plate.off --cut-mesh crossing.off
    [[ $err == *'crosses itself'* ]]
    expect 2 geodesic plate.off --cut-mesh block.off --keep both
}

@test "bodies that touch in an edge or a corner are two" {
    solid 0 0 0 1 1 1 > one.off
    solid 1 1 0 2 2 1 > edge.off
    solid 1 1 1 2 2 2 > corner.off
    for other in edge corner; do
        joined one.off $other.off > two.off
        for how in exact heat; do
            geodesic two.off --quiet --source vertex:0 --method $how > s
            facts s | grep -qx 'components 2'
            facts s | grep -qx 'reached 8 vertices'
            facts s | grep -qx 'unreached 8 vertices'
            facts s | grep -qx 'farthest-vertex 2.2361 mm'
        done
        peek s | grep -q 'vertex-split'
    done
}

@test "three sheets on one edge: the flattest pair stays joined" {
    printf 'OFF\n5 3 0\n0 0 0\n10 0 0\n0 10 0\n0 -10 0\n0 0 10\n3 0 1 2\n3 1 0 3\n3 0 1 4\n' > three.off
    expect 0 geodesic three.off --source vertex:0 --output s
    [[ $err == *'edge-crowded'* ]]
    facts s | grep -qx 'components 2'
    facts s | grep -qx 'reached 4 vertices'
}

@test "a surface with one side is cut open" {
    python3 - > moebius.off << 'END'
from math import cos, pi, sin
n = 20
print("OFF"), print(2 * n, 2 * n, 0)
for k in range(n):
    t = 2 * pi * k / n
    for w in (-0.5, 0.5):
        r = 3 + w * cos(t / 2)
        print(r * cos(t), r * sin(t), w * sin(t / 2))
for k in range(n):
    a, b = 2 * k, 2 * k + 1
    c, d = (a + 2, b + 2) if k + 1 < n else (1, 0)
    print(3, a, b, c), print(3, b, d, c)
END
    expect 0 geodesic moebius.off --source vertex:0 --output s
    [[ $err == *'edge-one-sided'* ]]
    facts s | grep -qx 'unreached 0 vertices'
}

@test "slivers of aspect 1e6 are measured as they are" {
    awk 'BEGIN { print "OFF"; print 22, 20, 0
        for (j = 0; j < 2; ++j) for (i = 0; i < 11; ++i) print i * 1000, j * 0.001, 0
        for (i = 0; i < 10; ++i) { print 3, i, i + 1, i + 12; print 3, i, i + 12, i + 11 } }' > strip.off
    for how in exact heat; do
        geodesic strip.off --source plane:1,0,0,2500 --method $how > s
        points s 'for x, d in zip(p["x"], p["distance"]): assert abs(abs(x - 2500) - d) < 1e-6, (x, d)'
    done
}

@test "closed surfaces have no boundary, and other sources serve" {
    expect 2 geodesic block.off --source boundary
    [[ $err == *closed* ]]
    geodesic block.off --source plane:0,0,1,0 --signed > s
    points s 'for z, d in zip(p["z"], p["distance"]): assert abs(z - d) < 1e-9, (z, d)'
}

@test "heat tells how far off it is, and says so if it is far" {
    geodesic plate.off --source plane:1,0,0,3.3 --method heat > s
    facts s | grep -q '^heat-checked [0-9]* vertices'
    facts s | grep -q '^heat-error-p99 .* %'
    awk 'BEGIN { # a fine plate, and long slivers from one side of it to another
        n = 60; print "OFF"; print (n + 1) * (n + 1) + 1, 2 * n * n + n, 0
        for (j = 0; j <= n; ++j) for (i = 0; i <= n; ++i) print i * 0.1, j * 0.1, 0
        print 100, 40, 0
        for (j = 0; j < n; ++j) for (i = 0; i < n; ++i) {
            a = j * (n + 1) + i
            print 3, a, a + 1, a + n + 2; print 3, a, a + n + 2, a + n + 1
        }
        for (j = 0; j < n; ++j) print 3, j * (n + 1) + n, (n + 1) * (n + 1), (j + 1) * (n + 1) + n
    }' > fan.off
    expect 0 geodesic fan.off --source vertex:3721 --method heat --output s
    [[ $err == *'distances by the heat method are wrong by up to'* ]]
    geodesic fan.off --source vertex:3721 --method exact > s
    facts s | run -1 grep -q '^heat'
}

@test "vertices are named as in the file, with some that no triangle has and some that stand twice" {
    { # the first vertex is in no triangle, and the plate's last one stands twice
        printf '%s\n' OFF '233 400 0' '99 99 99'
        sed -n '3,233p' plate.off
        echo 20 10 0
        sed -n '234,$p' plate.off | awk '{ print 3, $2 + 1, $3 + 1, $4 + 1 }'
    } > more.off
    geodesic more.off --source vertex:1 > s
    points s 'assert min(zip(p["distance"], p["x"], p["y"])) == (0, 0, 0)'
    geodesic more.off --source vertex:232 > s
    points s 'assert min(zip(p["distance"], p["x"], p["y"])) == (0, 20, 10)'
    expect 2 geodesic more.off --source vertex:0
    [[ $err == *'no triangle of the surface has this vertex'* ]]
    expect 2 geodesic more.off --source vertex:233
}

@test "a surface that faces down is noted, and --flip turns it round" {
    sed -E 's/^3 ([0-9]+) ([0-9]+) ([0-9]+)$/3 \1 \3 \2/' plate.off > down.off
    expect 0 geodesic down.off -o s
    [[ $err == *--flip* ]]
    expect 0 geodesic down.off --flip -o s
    [[ -z $err ]]
    cmp <(geodesic plate.off --source vertex:0 | peek --text | grep '^point') \
        <(geodesic down.off --flip --source vertex:0 | peek --text | grep '^point')
}

@test "long thin triangles are remeshed about as fast as squarish ones" {
    awk 'BEGIN { # a tube of 128 long triangles
        n = 64; print "OFF"; print 2 * n, 2 * n, 0
        for (z = 0; z <= 100; z += 100) for (i = 0; i < n; ++i) print 10 * cos(i * 6.283185307 / n), 10 * sin(i * 6.283185307 / n), z
        for (i = 0; i < n; ++i) { j = (i + 1) % n; print 3, i, j, n + j; print 3, i, n + j, n + i }
    }' > tube.off
    ulimit -t 20
    expect 0 geodesic tube.off --remesh 2 --notes all -o s
    [[ $err == *'long thin triangle'* ]]
    [[ $(facts s | sed -n 's/^triangles //p') -lt 8000 ]]
    facts s | grep -q '^rims 2$'
}
