#!/usr/bin/env bats
# Stresses onto surfaces, from the outside.
# shellcheck disable=SC2154

load common

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    export FILUM_SOURCE=${FILUM_SOURCE:-$(cd "$BATS_TEST_DIRNAME/../.." && pwd)}
    # a square of 10 mm, and 11 x 11 samples on it that pull along x, more and more towards y = 10
    printf 'OFF\n4 2 0\n0 0 0  10 0 0  10 10 0  0 10 0\n3 0 1 2\n3 0 2 3\n' > square.off
    python3 -c '
print("x,y,z,s1x,s1y,s1z,s1,s2,s3")
for y in range(11):
    for x in range(11):
        print(x, y, 0, -1, 0, 0, 1 + y, 0.5, -2, sep=",")' > stress.csv
    geodesic square.off --source vertex:0 > s
}

facts() { peek "$1" | sed -n "s/^fact *$2: //p"; }
# columns FILE FIELD...: their values per vertex
columns() {
    peek --json "$1" | python3 -c '
import json, sys
p = [f for f in json.load(sys.stdin)["frames"] if f["kind"] == "surface"][0]["points"]
for name in sys.argv[1:]:
    print(name, *("inf" if v is None else round(float(v), 6) for v in p[name]))' "${@:2}"
}

@test "fields of a load case join what the surface has" {
    stressfield --stress stress.csv --case X s > t
    [[ $(columns t distance stress.X.s1 stress.X.s2 stress.X.s3) == \
        $'distance 0.0 10.0 14.142136 10.0\nstress.X.s1 1.0 1.0 11.0 11.0\nstress.X.s2 0.5 0.5 0.5 0.5\nstress.X.s3 -2.0 -2.0 -2.0 -2.0' ]]
    peek --text t | grep -q 'stress.X.d1'
    facts t stressfield | grep -qx 'stress.X.greatest 11 MPa'
    facts t stressfield | grep -qx 'stress.X.unknown 0 vertices'
    facts t geodesic | grep -qx 'reached 4 vertices'
    geodesic square.off --source vertex:0 | stressfield --stress stress.csv --case X | cmp - t
    gzip -n stress.csv
    stressfield --stress stress.csv.gz --case X s > u
    [[ $(columns t stress.X.s1) == $(columns u stress.X.s1) ]]
}

@test "several load cases, one after the other" {
    stressfield --stress stress.csv --case X s | stressfield --stress stress.csv --stress-unit kPa --case Y > t
    [[ $(columns t stress.X.s1 stress.Y.s1) == $'stress.X.s1 1.0 1.0 11.0 11.0\nstress.Y.s1 0.001 0.001 0.011 0.011' ]]
    expect 2 stressfield --stress stress.csv --case X t
    complaint stressfield
    [[ $err == *"'X'"* ]]
}

@test "without stresses the surface goes on as it is" {
    stressfield s > t
    [[ $(peek --json s | grep -A 30 '"kind": "surface"') == $(peek --json t | grep -A 30 '"kind": "surface"') ]]
}

@test "where the greatest stress leans out of the surface is said" {
    python3 -c '
print("x,y,z,sxx,syy,szz,sxy,syz,szx")
for y in range(11):
    for x in range(11):
        print(x, y, 0, -5, -1, 0, 0, 0, 0, sep=",")' > pressed.csv
    expect 0 stressfield --stress pressed.csv --case X s --output t
    [[ $err == 'stressfield: look: on 100 % of the area (4 vertices) the greatest stress of case X points out of the surface;'*' [stress-across]' ]]
    facts t stressfield | grep -qx 'stress.X.out-of-surface 1'
    expect 0 stressfield --stress pressed.csv --case X --tangent s --output t
    [[ -z $err ]]
}

@test "far away, or in another unit: said" {
    python3 -c '
for y in range(11):
    for x in range(11):
        print(x / 1000, y / 1000, 0, 1, 0, 0)' > metres.csv
    expect 0 stressfield --stress metres.csv --case X s --output t
    [[ $err == 'stressfield: look: 66.7 mm2 of surface (3 vertices) have no stress of case X; worst at 10,10,0;'*' [stress-unknown]' ]]
    [[ $(columns t stress.X.s1) == 'stress.X.s1 1.0 inf inf inf' ]]
    expect 0 stressfield --stress metres.csv --unit m s --output t
    [[ -z $err ]]
    sed 's/ 0 1 0 0/ 9 1 0 0/' metres.csv > far.csv
    expect 3 stressfield --stress far.csv s
    complaint stressfield
    [[ $err == *--unit* ]]
}

@test "bad files: each its own word" {
    : > empty.csv
    expect 4 stressfield --stress empty.csv s
    complaint stressfield
    head -c 300 stress.csv > cut.csv
    expect 4 stressfield --stress cut.csv s
    complaint stressfield
    sed '5s/,[^,]*$//' stress.csv > short.csv
    expect 3 stressfield --stress short.csv s
    complaint stressfield
    [[ $err == *'line 5'* ]]
    sed 's/$/\r/' stress.csv > dos.csv
    stressfield --stress dos.csv --case X s > dos
    stressfield --stress stress.csv --case X s > unix
    [[ $(columns dos stress.X.s1) == $(columns unix stress.X.s1) ]]
    sed '5s/.*/0,4,0,nan,0,0,1,1,1/' stress.csv > nan.csv
    expect 0 stressfield --stress nan.csv --case X s --output t
    [[ $err == 'stressfield: look: 1 sample that is not finite was dropped;'*' [sample-not-finite]' ]]
    expect 3 stressfield --stress square.off s
    complaint stressfield
    expect 5 stressfield --stress no-such-file s
    complaint stressfield
}

@test "CalculiX results: good ones, and what is wrong with bad ones" {
    frd=$FILUM_SOURCE/tests/lib/curved/stressfield/elements.frd
    printf 'OFF\n3 1 0\n1.2 1.7 2.9  1.21 1.7 2.9  1.2 1.71 2.9\n3 0 1 2\n' > speck.off
    geodesic speck.off > s
    expect 0 stressfield --quiet --stress "$frd" --case X s --output t
    columns t stress.X.s2 | awk '{ exit !($2 > 1.69 && $2 < 1.71) }'
    sed 's/$/\r/' "$frd" > dos.frd
    stressfield --quiet --stress dos.frd --case X s > u
    [[ $(columns t stress.X.s1) == $(columns u stress.X.s1) ]]
    # a stress of 1e-100 and one of -2e-100, which takes a column more
    awk '/^ -4  STRESS/ { on = 1 }
        on && /^ -1/ && !done { $0 = substr($0, 1, 13) "1.00000E-100-2.00000E-100" substr($0, 38); done = 1 }
        { print }' "$frd" > digits.frd
    expect 0 stressfield --quiet --stress digits.frd --case X s --output t
    head -c 5000 "$frd" > cut.frd
    expect 4 stressfield --stress cut.frd s
    complaint stressfield
    sed 's/^ -1         7/ -1          7/' "$frd" > moved.frd
    expect 3 stressfield --stress moved.frd s
    complaint stressfield
    [[ $err == *'line '* ]]
    sed 's/^ -4  STRESS/ -4  TOSTRA/' "$frd" > none.frd
    expect 3 stressfield --stress none.frd s
    complaint stressfield
    [[ $err == *STRESS* ]]
    expect 2 stressfield --stress "$frd" --step 7 s
    [[ $err == *'steps 1' ]]
    sed '/^ 9999/d' "$frd" > open.frd
    expect 0 stressfield --stress open.frd --case X s --output t
    [[ $err == *'lacks its end mark'* ]]
}

@test "VTK grids: good ones, and what is wrong with bad ones" {
    seeds=$FILUM_SOURCE/tests/fuzz/seeds/stress_read
    printf 'OFF\n3 1 0\n0.1 0.1 0  0.3 0.1 0  0.1 0.3 0\n3 0 1 2\n' > face.off
    geodesic face.off > s
    stressfield --quiet --stress "$seeds/1.vtu" s > one # plain
    stressfield --quiet --stress "$seeds/5.vtu" s > two # packed and appended
    [[ $(columns one stress.S.s1 stress.S.s3) == $(columns two stress.S.s1 stress.S.s3) ]]
    head -c 1200 "$seeds/5.vtu" > cut.vtu
    expect 4 stressfield --stress cut.vtu s
    complaint stressfield
    sed 's/UnstructuredGrid/PolyData/' "$seeds/1.vtu" > poly.vtu
    expect 3 stressfield --stress poly.vtu s
    complaint stressfield
    expect 2 stressfield --stress "$seeds/1.vtu" --columns T s
    complaint stressfield
    [[ $err == *"'S'"* ]]
}

# vtu NAME ATTRIBUTES VALUES: a grid of two triangles over the square, one array of 6 numbers, all points alike
vtu() {
    cat << EOF
<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="2"><PointData>
<DataArray type="Float64" Name="$1" NumberOfComponents="6" $2 format="ascii">$3 $3 $3 $3</DataArray>
<DataArray type="Float64" Name="E" NumberOfComponents="6" format="ascii">$3 $3 $3 $3</DataArray>
</PointData><Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 10 0 0 10 10 0 0 10 0</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 0 2 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3 6</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">5 5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>
EOF
}

@test "VTK grids: names of components give their order, strains are no stresses, doubts are refused" {
    names='ComponentName0="XX" ComponentName1="XY" ComponentName2="XZ" ComponentName3="YY" ComponentName4="YZ" ComponentName5="ZZ"'
    vtu S "$names" '10 3 -4 2 .5 1' > named.vtu
    expect 0 stressfield --stress named.vtu s --output t
    [[ $(columns t stress.S.s1) == 'stress.S.s1 12.208967 12.208967 12.208967 12.208967' ]]
    [[ $(peek t) == *"array of strains was ignored: 'E'"* && $err != *order* ]]
    peek t > shown
    grep -q 'stress_read.S = S: xx xy zx yy yz zz, MPa' shown
    [[ $(grep -c 'stress\.E' shown) == 0 ]]
    vtu S '' '10 2 1 3 .5 -4' > plain.vtu
    expect 0 stressfield --stress plain.vtu s --output t
    [[ $(columns t stress.S.s1) == 'stress.S.s1 12.208967 12.208967 12.208967 12.208967' ]]
    [[ $err == *"VTK's order"* && $err == *--order* ]]
    vtu S '' '10 2 1 3 -4 .5' > abaqus.vtu
    for order in abaqus xx,yy,zz,xy,xz,yz S11,S22,S33,S12,S13,S23; do
        stressfield --quiet --stress abaqus.vtu --order $order s > t
        [[ $(columns t stress.S.s1) == 'stress.S.s1 12.208967 12.208967 12.208967 12.208967' ]]
    done
    vtu 'S [Pa]' "$names" '10e6 3e6 -4e6 2e6 5e5 1e6' > pascal.vtu
    stressfield --quiet --stress pascal.vtu --case S s > t
    [[ $(columns t stress.S.s1) == 'stress.S.s1 12.208967 12.208967 12.208967 12.208967' ]]
    vtu what '' '10 2 1 3 .5 -4' > what.vtu
    expect 3 stressfield --stress what.vtu s
    [[ $err == *"'what'"*--columns* ]]
    vtu S "${names/XZ/RZ}" '10 3 -4 2 .5 1' > round.vtu
    expect 3 stressfield --stress round.vtu s
    [[ $err == *--order* ]]
    expect 2 stressfield --stress plain.vtu --order xx,yy s
    [[ $err == *--order* ]]
}

@test "tables: quotes, decimal commas, text columns, units, line ends of any kind" {
    python3 - << 'EOF'
rows = [(x, y, 0, 10, 2, 1, 3, .5, -4) for y in range(0, 11, 2) for x in range(0, 11, 2)]
names = "X Y Z S11 S22 S33 S12 S23 S13".split()
def table(file, head, cell, mark=",", end="\n", before=""):
    with open(file, "w", newline="") as f:
        f.write(mark.join(head) + end + "".join(before + mark.join(cell % v for v in r).replace(*(".,") if "," in cell or '"' in cell else "..") + end for r in rows))
table("quoted.csv", ['"%s"' % n for n in names], '"%.3f"')
table("text.csv", ["ODB Name", "Step"] + names, "%g", before="a.odb,Step-1,")
table("mac.csv", names, "%g", end="\r")
table("tabs.csv", names, "%g", mark="\t", end="\r\n")
table("ksi.csv", [n + (" (mm)" if len(n) == 1 else " (ksi)") for n in names], "%g")
table("wide.csv", names, "%g", before="7,")
table("step.csv", ["Step"] + names, "%g", before="1,")
EOF
    for file in quoted text mac tabs step; do
        expect 0 stressfield --stress $file.csv --case X s --output t
        [[ -z $err ]]
        [[ $(columns t stress.X.s1) == 'stress.X.s1 12.208967 12.208967 12.208967 12.208967' ]]
    done
    stressfield --stress ksi.csv --case X s > t
    columns t stress.X.s1 | awk '{ exit !($2 > 84.177 && $2 < 84.179) }'
    expect 3 stressfield --stress wide.csv s
    [[ $err == *'line 2: it has 10 columns, the header 9'* ]]
    sed '$s/^1,/2,/' step.csv > steps.csv
    expect 3 stressfield --stress steps.csv s
    [[ $err == *"'Step' has '1' and '2'"* ]]
    expect 2 stressfield --stress text.csv --order vtk s
}

@test "options that make no sense are usage errors" {
    for bad in '--case a,b' '--case a.b' '--columns x,y' '--columns x,y,z,what' '--mask 2' '--mask -1' '--mask nan' '--reach -1' \
        '--unit mile' '--stress-unit bar'; do
        # shellcheck disable=SC2086
        expect 2 stressfield --stress stress.csv $bad s
        complaint stressfield
    done
    expect 2 stressfield --stress stress.csv --step 1 s
    complaint stressfield
    expect 2 stressfield --stress "$FILUM_SOURCE/tests/lib/curved/stressfield/elements.frd" --columns x,y,z s
    complaint stressfield
}

# Load adequacy of lines in any direction, by area: the mean of |line . greatest stress|.
adequacy() {
    peek --json "$1" | python3 -c '
import json, math, sys
s = [f for f in json.load(sys.stdin)["frames"] if f["kind"] == "surface"][0]
p, t, case = s["points"], s["triangles"], sys.argv[1]
x = list(zip(p["x"], p["y"], p["z"]))
d = list(zip(*(p["stress.%s.d1.%s" % (case, c)] for c in "xyz")))
cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
minus = lambda a, b: tuple(i - j for i, j in zip(a, b))
dot = lambda a, b: sum(i * j for i, j in zip(a, b))
unit = lambda a: tuple(i / math.sqrt(dot(a, a)) for i in a)
n = [(0, 0, 0)] * len(x)
for a, b, c in zip(t["a"], t["b"], t["c"]):
    m = cross(minus(x[b], x[a]), minus(x[c], x[a]))
    for v in (a, b, c):
        n[v] = tuple(i + j for i, j in zip(n[v], m))
known = [v for v in range(len(x)) if d[v][0] is not None]
area = [math.sqrt(dot(m, m)) for m in n]
for k in range(6):
    total = 0
    for v in known:
        u = unit(cross(n[v], (0.123, 0.456, 0.88)))
        w = cross(unit(n[v]), u)
        line = [math.cos(k * math.pi / 6) * i + math.sin(k * math.pi / 6) * j for i, j in zip(u, w)]
        total += area[v] * abs(dot(line, d[v]))
    print(total / sum(area[v] for v in known))' "$2"
}

@test "stresses of a bracket read three ways give one load adequacy within 0.001" {
    bracket=$FILUM_SOURCE/examples/bracket
    "$bracket/to-vtu" "$bracket/bracket.frd.gz" bracket.vtu X Y
    for patch in A:Y B:Y C:X D:X E:Y; do
        case=${patch#*:}
        geodesic "$bracket/patch_${patch%:*}.ply" > patch
        stressfield --quiet --stress "$bracket/bracket.frd.gz" --case X,Y patch | adequacy - "$case" > frd
        stressfield --quiet --stress bracket.vtu --case X,Y patch | adequacy - "$case" > vtu
        stressfield --quiet --stress "$bracket/stress_$case.csv.gz" --case "$case" patch | adequacy - "$case" > csv
        paste frd vtu csv | awk -v patch="$patch" '
            function far(a, b) { return a > b + 0.001 || b > a + 0.001 }
            $1 < 0.01 || far($1, $2) || far($1, $3) { print patch, $0; bad = 1 }
            END { exit bad || NR != 6 }'
    done
}

# Vectors tell less: where the greatest and the next are nearly the same, the mean of two directions is a guess.
@test "vectors instead of tensors do so where there is stress" {
    bracket=$FILUM_SOURCE/examples/bracket
    for patch in A:Y E:Y; do
        case=${patch#*:}
        geodesic "$bracket/patch_${patch%:*}.ply" > patch
        stressfield --quiet --mask 0.02 --stress "$bracket/bracket.frd.gz" --case X,Y patch | adequacy - "$case" > frd
        stressfield --quiet --mask 0.02 --stress "$bracket/stress_$case.csv.gz" --case "$case" \
            --columns x,y,z,s1x,s1y,s1z,s1,s2,s3,-,-,-,-,-,- patch | adequacy - "$case" > csv
        paste frd csv | awk '$1 > $2 + 0.001 || $2 > $1 + 0.001 { print; bad = 1 } END { exit bad || NR != 6 }'
    done
}
