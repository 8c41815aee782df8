#!/usr/bin/env bats
# Programs read back: the same numbers as scripts/gcode-strokes counts, which knows nothing of Filum's reader.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    box_stl > part.stl
    boxes towers.stl 0,0,0,12,12,4 30,0,0,42,12,4
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

# same PROGRAM [OPTION...]: ingest's facts and metrics' figures are what gcode-strokes counts.
same() {
    local program=$1
    shift
    "$FILUM_SOURCE/scripts/gcode-strokes" "$program" | tail -n 1 > counted
    ingest -q "$program" "$@" -o read.toolpath
    peek --check read.toolpath
    metrics --format tsv read.toolpath > figures.tsv
    peek --json read.toolpath > read.json
    python3 - << 'END'
import json
name, strokes, stops, travels, retractions, extruded, travelled, volume = open("counted").read().split("\t")
facts = {f["name"]: f["value"] for f in json.load(open("read.json"))["frames"] if f.get("kind") == "fact"}
figures = {}
for row in open("figures.tsv").read().splitlines()[1:]:
    figures.setdefault(row.split("\t")[0], row.split("\t")[1])
for fact, counted in (("strokes", strokes), ("stops", stops), ("travels", travels), ("retractions", retractions)):
    assert facts[fact] == int(counted), (fact, facts[fact], counted)
assert (figures["strokes"], figures["stops"]) == (strokes, stops), (figures["strokes"], figures["stops"], strokes, stops, name)
# of an arc gcode-strokes takes the chord
chords = 0.02 * float(extruded) if facts["arcs"] else 0
for mine, theirs, unit in (("extruded", extruded, 1e3), ("travelled", travelled, 1e3), ("volume", volume, 1e3)):
    assert abs(facts[mine] / unit - float(theirs)) <= 0.0011 + chords, (mine, facts[mine], theirs)
# straight up is a lift: metrics counts its length, gcode-strokes does not
assert abs((float(figures["extruded_mm"]) - float(figures["lifts_mm"])) / 1e3 - float(extruded)) <= 0.0011 + chords
measured = float(figures["volume_mm3"]) / 1e3
assert abs(measured - float(volume)) <= 0.001 * float(volume) + 0.001, (measured, volume)
END
}

@test "programs of Filum read back: strokes, stops, length, volume" {
    for machine in marlin klipper reprapfirmware; do
        for part in part towers; do
            filum print $part.stl --machine $machine -o $part.gcode
            same $part.gcode
        done
    done
}

@test "programs of PrusaSlicer read back: strokes, stops, length, volume" {
    command -v prusa-slicer > /dev/null || skip "no prusa-slicer"
    for how in 'concentric' 'rectilinear --use-relative-e-distances' 'gyroid --use-firmware-retraction' 'grid --gcode-flavor marlin2'; do
        # shellcheck disable=SC2086
        prusa-slicer --export-gcode --fill-density 30% --fill-pattern $how -o prusa.gcode towers.stl > prusa.log 2>&1 ||
            { cat prusa.log; false; }
        same prusa.gcode
        peek --json read.toolpath > features
        for feature in outer_wall wall infill solid top; do grep -q "\"feature\":\"$feature\"" features; done
    done
}

@test "what is read can go everywhere a toolpath goes" {
    filum print towers.stl -o towers.gcode
    ingest -q towers.gcode | collide --strict=false > collided
    peek --check collided
    ingest -q towers.gcode | render --size 64,64 -o read.png
    ingest -q towers.gcode | postproc --place as-is > again.gcode
    "$FILUM_SOURCE/scripts/gcode-strokes" towers.gcode again.gcode | cut -f 2,3,4 | uniq | wc -l | grep -qx 2
}

@test "a mesh, binary G-code and nothing at all are refused with a word on what to do" {
    expect 3 ingest part.stl
    complaint ingest
    [[ $err == *"export G-code"* ]]
    expect 4 ingest < /dev/null
    echo 'hello' > text
    expect 3 ingest text
    [[ $err == *"--machine"* ]]
    printf 'G1 X\n' > broken
    expect 3 ingest broken
    [[ $err == *"line 1"* ]]
    expect 2 ingest --machine ur text
}

@test "commands with flags, origins and text are passed over; rotary words and turned coordinates are not" {
    local begin='G21\nG90\nM83\nG28 XY\nM569 S1 X Y\nG1 Z0.2 F600\nG1 X10 Y10 F6000\n'
    local bead='G1 X30 Y10 E0.665 F1200\nG1 X30 Y30 E0.665\n'
    printf "${begin}${bead}M84 X Y E ; off\n" > flags.gcode
    same flags.gcode
    printf "${begin}G10 L2 P1 X100\nG54\n${bead}" > origin.gcode
    ingest origin.gcode -o origin.toolpath 2> said
    grep -q 'origin moved by G10' said
    peek --json origin.toolpath | grep -q '"name":"retractions"[^}]*"value":0\b'
    local line
    for line in 'G43.4 H1' M128 'G68 R30' 'G51 X2' 'G1 X40 U10 E1' 'G1 X40 A10 E1'; do
        printf "${begin}${bead}${line}\n${bead}" > turned.gcode
        expect 3 ingest turned.gcode
        complaint ingest
    done
}

@test "projects with a program a plate: the first, or the one that is asked for; damaged ones are refused" {
    filum print part.stl -o one.gcode
    filum print towers.stl -o two.gcode
    python3 - << 'END'
import zipfile
def project(name, *entries):
    with zipfile.ZipFile(name, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in entries:
            archive.writestr(path, data)
one, two = open("one.gcode").read(), open("two.gcode").read()
project("both.gcode.3mf", ("Metadata/plate_1.gcode", one), ("Metadata/plate_12.gcode", two), ("../evil.gcode", "G1 X1"))
project("none.3mf", ("3D/3dmodel.model", "<model/>"))
project("twice.gcode.3mf", ("Metadata/plate_1.gcode", one), ("Metadata/PLATE_1.gcode", two))
whole = open("both.gcode.3mf", "rb").read()
open("short.gcode.3mf", "wb").write(whole[: len(whole) // 2])
open("wrong.gcode.3mf", "wb").write(whole[:200] + bytes([whole[200] ^ 255]) + whole[201:])
open("names.gcode.3mf", "wb").write(whole.replace(b"plate_1.", b"plate_7.", 1))
END
    same one.gcode
    ingest one.gcode -o one.toolpath
    ingest two.gcode -o two.toolpath
    ingest both.gcode.3mf -o read.toolpath 2> said
    grep -q 'plate-program-ignored' said
    metrics --format tsv read.toolpath | grep -v '^said\|^noted' > read.tsv
    metrics --format tsv one.toolpath | grep -v '^said\|^noted' | diff - read.tsv
    ingest -q --plate 12 both.gcode.3mf -o read.toolpath
    metrics --format tsv read.toolpath | grep -v '^said\|^noted' > read.tsv
    metrics --format tsv two.toolpath | grep -v '^said\|^noted' | diff - read.tsv
    expect 2 ingest --plate 3 both.gcode.3mf
    local file
    for file in none.3mf twice.gcode.3mf short.gcode.3mf wrong.gcode.3mf names.gcode.3mf; do
        expect 3 ingest "$file"
        complaint ingest
    done
}

@test "binary G-code: what is written reads back as the text does" {
    filum print towers.stl --infill 15% -o towers.gcode
    filum print towers.stl --infill 15% -o towers.bgcode --thumbnails 16x16
    head -c 4 towers.bgcode | grep -q GCDE
    [[ $(stat -c %s towers.bgcode) -lt $(($(stat -c %s towers.gcode) / 2)) ]]
    for file in towers.gcode towers.bgcode; do
        ingest -q $file -o read.toolpath
        metrics --format tsv read.toolpath | grep -v '^said\|^noted' > $file.tsv
    done
    diff towers.gcode.tsv towers.bgcode.tsv
    expect 2 filum print towers.stl -o towers.3mf
    expect 2 filum print towers.stl --machine ur -o towers.bgcode
    head -c 5000 towers.bgcode > short.bgcode
    expect 4 ingest short.bgcode
}

@test "a Bambu Studio print file: the same program, its sum, where its parts stand" {
    filum print towers.stl --infill 15% --copies 2 -o towers.gcode
    for out in one two; do filum print towers.stl --infill 15% --copies 2 --thumbnails 16x16 -o $out.gcode.3mf; done
    cmp one.gcode.3mf two.gcode.3mf
    for file in towers.gcode one.gcode.3mf; do
        ingest -q $file -o read.toolpath
        metrics --format tsv read.toolpath | grep -v '^said\|^noted' > $file.tsv
    done
    diff towers.gcode.tsv one.gcode.3mf.tsv
    python3 - <<'END'
import hashlib, json, re, struct, zipfile
import xml.etree.ElementTree as xml
z = zipfile.ZipFile("one.gcode.3mf")
assert z.testzip() is None
read = lambda name: z.read("Metadata/" + name)
assert read("plate_1.gcode.md5").decode() == hashlib.md5(read("plate_1.gcode")).hexdigest().upper()
trees = {n: xml.fromstring(z.read(n)) for n in z.namelist() if n.endswith((".xml", ".rels", ".config", ".model"))}
for name, tree in trees.items():  # what a relation points to is there
    for relation in tree.findall("{*}Relationship"):
        assert relation.get("Target")[1:] in z.namelist(), relation.attrib
info = {m.get("key"): m.get("value") for m in trees["Metadata/slice_info.config"].iter("metadata")}
assert float(info["prediction"]) > 60 and info["support_used"] == "false" and "printer_model_id" not in info, info
plate = json.loads(read("plate_1.json"))
assert len(plate["bbox_objects"]) == len(trees["Metadata/slice_info.config"].findall(".//object")) == 2, plate
moves = [re.findall(r"([XYE])([-.\d]+)", l) for l in read("plate_1.gcode").decode().splitlines() if re.match("G1 X.* E[.\\d]", l)]
for k, axis in enumerate("XY"):  # the boxes hold what is printed
    values = [float(v) for words in moves for a, v in words if a == axis]
    low, high = plate["bbox_all"][k], plate["bbox_all"][k + 2]
    assert min(b["bbox"][k] for b in plate["bbox_objects"]) == low and low < max(values) and high > min(values)
for name, side in (("plate_1.png", 512), ("plate_1_small.png", 128)):
    assert struct.unpack(">II", read(name)[16:24]) == (side, side)
used = trees["Metadata/slice_info.config"].find(".//filament")
assert used.get("id") == "1" and float(used.get("used_m")) > 0.1, used.attrib
END
    head -c 5000 one.gcode.3mf > short.gcode.3mf
    expect 3 ingest short.gcode.3mf
    expect 2 filum print towers.stl --machine ur -o towers.gcode.3mf
}

@test "hollow programs with supports read back: time, lengths by role, volume" {
    boxes table.stl 0,0,0,4,12,4 20,0,0,24,12,4 0,0,4,24,12,6
    for how in '' '--infill 15%' '--infill 15% --support' '--infill 15% --lift ramp'; do
        # shellcheck disable=SC2086
        filum print table.stl $how --keep kept -o table.gcode
        ingest -q table.gcode -o read.toolpath
        metrics --machine marlin --format tsv kept/*.toolpath > laid.tsv
        metrics --machine marlin --format tsv read.toolpath > read.tsv
        python3 - << 'END'
def figures(name):
    out = {}
    for row in open(name).read().splitlines()[1:]:
        out.setdefault(row.split("\t")[0], row.split("\t")[1])
    return out
laid, read = figures("laid.tsv"), figures("read.tsv")
for key in ("strokes", "stops", "print_time_s", "extruded_mm", "beads_mm", "lifts_mm", "jogs_mm", "connectors_mm", "volume_mm3"):
    a, b = float(laid[key]), float(read[key])
    assert abs(a - b) <= 0.005 * max(a, b) + 0.001, (key, a, b)
END
        rm -r kept
    done
}

@test "public programs: a verdict for each" {
    [ -n "${FILUM_PUBLIC_PROGRAMS:-}" ] || skip "FILUM_PUBLIC_PROGRAMS names no folders with gcode-preview's test-data and libbgcode's tests"
    "$FILUM_SOURCE/tests/programs/check-programs" $FILUM_PUBLIC_PROGRAMS
}
