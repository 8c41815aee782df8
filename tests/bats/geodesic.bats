#!/usr/bin/env bats
# Distances on surfaces, from the outside.
# shellcheck disable=SC2154

load common

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    # two triangles that make a square of 10 mm, and a third one far away
    cat > square.off << 'END'
OFF
7 3 0
0 0 0  10 0 0  10 10 0  0 10 0  50 0 0  60 0 0  50 10 0
3 0 1 2
3 0 2 3
3 4 5 6
END
}

facts() { peek "$1" | sed -n 's/^fact *geodesic: //p'; }

@test "distances of the corners of a square" {
    geodesic square.off --source vertex:0 > s
    [[ $(peek --text s | grep -A 7 '^surface' | tail -n 7 | cut -d ' ' -f 6 | tr '\n' ' ') == "0 10 14.142136 10 inf inf inf " ]]
    facts s | grep -qx 'reached 4 vertices'
    facts s | grep -qx 'unreached 3 vertices'
    facts s | grep -qx 'components 2'
    facts s | grep -qx 'rims 2'
}

@test "isolines of a rim are squares within it" {
    geodesic square.off --source boundary:0 --spacing 2 > s
    peek --json s | python3 -c '
import json, sys
s = [f for f in json.load(sys.stdin)["frames"] if f["kind"] == "surface"][0]
levels = [l["level"] for l in s["isolines"]]
assert levels == [2, 4], levels
for l in s["isolines"]:
    p = l["points"]
    assert len(p["x"]) == 4 and l["closed"] == "yes", l
    for x, y in zip(p["x"], p["y"]):
        assert abs(min(x, 10 - x, y, 10 - y) - l["level"]) < 1e-3, (x, y)
'
}

@test "without a source it only makes the surface" {
    geodesic square.off > s
    [[ $(peek --text s) != *isoline\ level* && $(peek --text s | grep '^surface') == *'points x,y,z 7'* ]]
    expect 2 geodesic square.off --levels 3
    complaint geodesic
}

@test "what was repaired is noted and said" {
    sed -i '/^7 3 0/s/3/4/; $a 3 0 1 2' square.off
    expect 0 geodesic square.off --output s
    [[ -z $err ]]
    expect 0 geodesic --notes all square.off --output s
    [[ $err == 'geodesic: harmless: 1 triangle present more than once was used once [triangle-copied]' ]]
    peek s | grep -q '^note *geodesic: harmless: 1 triangle present more than once'
}

@test "units and scale apply" {
    geodesic square.off --unit cm --scale 2 --source 'plane:1,0,0,200' > s
    facts s | grep -qx 'farthest-vertex 200 mm'
}

@test "sources that are none are usage errors" {
    for source in vertex:7 vertex:-1 edge:3 boundary:2 plane:0,0,1,5 point:1,2 'plane:0,0,0,0' vertex:nan; do
        expect 2 geodesic square.off --source "$source"
        complaint geodesic
        [[ $err == *"$source"* || $err == *number* ]] || { echo "$err"; false; }
    done
    box_stl > box.stl
    expect 2 geodesic box.stl --source boundary
    [[ $err == *closed* ]]
    expect 2 geodesic square.off --source vertex:0 --spacing -1
    expect 2 geodesic square.off --source vertex:0 --spacing 1e-9
    expect 2 geodesic square.off --source vertex:0 --levels 0
    expect 2 geodesic square.off --source vertex:0 --levels nan
}

@test "heat comes near the exact distance, and is the paper's if asked" {
    python3 - > grid.off << 'END'
n = 40
print("OFF"), print((n + 1) ** 2, 2 * n * n, 0)
for j in range(n + 1):
    for i in range(n + 1):
        print(i, j, 0)
for j in range(n):
    for i in range(n):
        a = j * (n + 1) + i
        print(3, a, a + 1, a + n + 2), print(3, a, a + n + 2, a + n + 1)
END
    for how in "--method exact" "--method heat" "--method heat --paper"; do
        # shellcheck disable=SC2086
        geodesic grid.off --source plane:1,0,0,3.4 $how > s
        [[ $(facts s | grep '^exact') == "exact $([[ $how == *exact ]] && echo 1 || echo 0)" ]]
        peek --json s | python3 -c '
import json, sys
p = [f for f in json.load(sys.stdin)["frames"] if f["kind"] == "surface"][0]["points"]
print(max(abs(d - abs(x - 3.4)) for x, d in zip(p["x"], p["distance"])))
' >> worst
    done
    paste -s -d ' ' worst | awk '{ print; exit !($1 < 1e-9 && $2 > 1e-9 && $2 < 0.5 && $3 > $2 && $3 < 2) }'
    expect 2 geodesic grid.off --source vertex:0 --paper
    expect 2 geodesic grid.off --source vertex:0 --method guess
}

@test "several planes cut one after the other" {
    geodesic square.off --cut 1,0,0,8 --cut 0,1,0,5 > two
    facts two | grep -qx 'area 40 mm2'
    geodesic square.off --cut 1,0,0,8 | geodesic --cut 0,1,0,5 > chain
    [ "$(facts two | grep area)" = "$(facts chain | grep area)" ]
    expect 2 geodesic square.off --cut 1,0,0 --cut 0,1,0,5
}

@test "cut, then remeshed, then measured" {
    geodesic square.off --cut 1,0,0,8 --remesh 0.5 --source boundary > s
    facts s | grep -qx 'area 80 mm2'
    facts s | grep -qx 'components 1'
    [[ $(facts s | sed -n 's/^triangles //p') -gt 500 ]]
    facts s | sed -n 's/^farthest-vertex \(.*\) mm/\1/p' | awk '{ exit !($1 > 3.6 && $1 < 4.0001) }'
    for bad in '--cut 0,0,0,1' '--cut 1,0,0,-1' '--cut 1,2' '--remesh -1' '--remesh 1e-6' '--remesh nan' '--cut 1,0,nan,0'; do
        # shellcheck disable=SC2086
        expect 2 geodesic square.off $bad
        complaint geodesic
    done
}

@test "remeshed by itself: large triangles where it is flat, small ones where it bends, and how far off is told" {
    python3 -c '
import math
n, m = 90, 40 # flat, then bent by a quarter of a turn, its radius 4 mm
print("OFF\n%d %d 0" % ((n + 1) * (m + 1), 2 * n * m))
for j in range(m + 1):
    for i in range(n + 1):
        s = 0.2 * i
        a = max(0, s - 12) / 4
        print(min(s, 12) + 4 * math.sin(a), 0.25 * j, 4 - 4 * math.cos(a))
for j in range(m):
    for i in range(n):
        p = j * (n + 1) + i
        print(3, p, p + 1, p + n + 2)
        print(3, p, p + n + 2, p + n + 1)' > bent.off
    expect 0 geodesic bent.off --remesh auto --longest 2 --output s
    [[ -z $err ]]
    facts s | grep -qx 'rims 1'
    facts s | sed -n 's/^remesh-off \(.*\) mm/\1/p' | awk '{ exit !($1 > 0.002 && $1 <= 0.02) }'
    facts s | sed -n 's/^triangles //p' | awk '{ exit !($1 > 100 && $1 < 1200) }'
    peek --json s | python3 -c '
import json, math, sys
p = [f for f in json.load(sys.stdin)["frames"] if f["kind"] == "surface"][0]["points"]
off = [abs(z) if x < 12 else abs(math.hypot(x - 12, z - 4) - 4) for x, z in zip(p["x"], p["z"])]
assert max(off) < 2e-3, max(off) # they lie on the surface, whose own chords are 1.3 um off the round
flat = sum(x < 10 for x in p["x"]) / 10
bent = sum(x > 13 for x in p["x"]) / (4 * (math.pi / 2 - math.asin(1 / 4)))
assert bent > 2 * flat, (bent, flat)'
    geodesic bent.off --remesh auto --longest 2 --tolerance 0.2 --output coarse
    [[ $(facts coarse | sed -n 's/^triangles //p') -lt $(facts s | sed -n 's/^triangles //p') ]]
    for threads in 1 2 8; do
        geodesic --threads $threads bent.off --remesh auto | peek --text > "$threads"
    done
    cmp 1 2
    cmp 1 8
    expect 2 geodesic bent.off --remesh fine
    complaint geodesic
    expect 2 geodesic bent.off --remesh auto --longest 0
    complaint geodesic
    expect 2 geodesic bent.off --remesh auto --longest 0.001 --tolerance 0.0001
    complaint geodesic
    # few triangles bend in steps that no chord follows: told
    python3 -c '
import math
print("OFF\n14 12 0")
for y in (0, 10):
    for i in range(7): print(3 * math.cos(i * math.pi / 8), y, 3 * math.sin(i * math.pi / 8))
for i in range(6):
    print(3, i, i + 1, i + 8)
    print(3, i, i + 8, i + 7)' > steps.off
    expect 0 geodesic steps.off --remesh auto --output s
    [[ $err == "geodesic: look: the remeshed surface deviates from the original by "* ]]
}

@test "lines of points are sources" {
    printf '# a bent line\n1 5 0\n5 5 0\n5, 9, 0\n\n55 5 3\n' > lines.txt
    expect 0 geodesic square.off --remesh 1 --source-lines lines.txt --output s
    [[ $err == 'geodesic: look: 1 source line was moved to the surface, by up to 3 mm;'* ]]
    facts s | grep -qx 'unreached 0 vertices'
    peek --json s | python3 -c '
import json, math, sys
p = [f for f in json.load(sys.stdin)["frames"] if f["kind"] == "surface"][0]["points"]
def far(x, y, a, b, c, d):
    t = max(0, min(1, ((x - a) * (c - a) + (y - b) * (d - b)) / ((c - a) ** 2 + (d - b) ** 2)))
    return math.hypot(x - a - t * (c - a), y - b - t * (d - b))
for x, y, d in zip(p["x"], p["y"], p["distance"]):
    truth = min(far(x, y, 1, 5, 5, 5), far(x, y, 5, 5, 5, 9)) if x < 20 else math.hypot(x - 55, y - 5)
    assert abs(d - truth) < 1e-6, (x, y, d, truth)
'
    printf '1 2\n' > lines.txt
    expect 3 geodesic square.off --source-lines lines.txt
    complaint geodesic
    [[ $err == *"line 1"* ]]
    printf '1 1 0\n55 1 0\n' > lines.txt
    expect 3 geodesic square.off --source-lines lines.txt
    complaint geodesic
    expect 5 geodesic square.off --source-lines no-such-file
    : > empty.txt
    expect 3 geodesic square.off --source-lines empty.txt
}

@test "a surface without an area is refused" {
    printf 'OFF\n3 1 0\n0 0 0 1 0 0 2 0 0\n3 0 1 2\n' > line.off
    expect 3 geodesic line.off
    complaint geodesic
}

@test "a picture, but no metrics" {
    geodesic square.off > s
    expect 0 render --size 32,32 s
    expect 3 metrics s
    complaint metrics
}
