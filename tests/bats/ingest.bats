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
    grep -q 'origins moved by G10' said
    peek --json origin.toolpath | grep -q '"name":"retractions"[^}]*"value":0\b'
    local line
    for line in 'G43.4 H1' M128 'G68 R30' 'G51 X2' 'G1 X40 U10 E1' 'G1 X40 A10 E1'; do
        printf "${begin}${bead}${line}\n${bead}" > turned.gcode
        expect 3 ingest turned.gcode
        complaint ingest
    done
}
