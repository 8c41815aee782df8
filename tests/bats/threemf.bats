#!/usr/bin/env bats
# 3MF files and slicers' projects: what is cut away, plates, and public files.

bats_require_minimum_version 1.5.0

setup() {
    PATH="$(cd "$(dirname "$(command -v slice)")" && pwd):$PATH" # a relative entry must outlive the cd
    cd "$BATS_TEST_TMPDIR" || return 1
}

# project FILE CONFIG: a cube of 30 mm and a larger block that begins half way up it, with CONFIG as PrusaSlicer's.
project() {
    python3 - "$1" "$2" <<'PY'
import sys, zipfile
def corners(lo, hi): return [[(hi if i >> k & 1 else lo)[k] for k in range(3)] for i in range(8)]
faces = [(0,2,1),(1,2,3),(4,5,6),(5,7,6),(0,1,4),(1,5,4),(2,6,3),(3,6,7),(0,4,2),(2,4,6),(1,3,5),(3,7,5)]
points = corners((-15,-15,0), (15,15,30)) + corners((-20,-20,15), (20,20,55))
triangles = faces + [tuple(i + 8 for i in f) for f in faces]
model = ('<model><resources><object id="1"><mesh><vertices>'
         + ''.join('<vertex x="%g" y="%g" z="%g"/>' % tuple(p) for p in points) + '</vertices><triangles>'
         + ''.join('<triangle v1="%d" v2="%d" v3="%d"/>' % t for t in triangles)
         + '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>')
with zipfile.ZipFile(sys.argv[1], 'w') as z:
    z.writestr('_rels/.rels', '<Relationships><Relationship Target="/3D/3dmodel.model" Id="r" '
               'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
    z.writestr('3D/3dmodel.model', model)
    z.writestr('Metadata/Slic3r_PE_model.config', sys.argv[2])
PY
}

@test "a negative volume is cut away, and what is left has its own height" {
    project part.3mf '<config><object id="1"><volume firstid="12" lastid="23"><metadata key="volume_type" value="NegativeVolume"/></volume></object></config>'
    run slice --notes all part.3mf -o part.layers
    [ "$status" -eq 0 ]
    [[ "$output" == *"1 negative body of the slicer's project was cut away"* ]]
    [ "$(peek --text part.layers | grep -c '^layer')" -eq 75 ]
    peek --text part.layers | grep '^layer' | tail -1 | grep -q 'z 15 '
}

@test "of several plates the first one is made, and the others are named" {
    "$FILUM_SOURCE/tests/threemf/two-plates" plates.3mf
    run filum print plates.3mf -o first.gcode
    [ "$status" -eq 0 ]
    [[ "$output" == *"plate 2"* ]]
    filum print plates.3mf --plate 2 -q -o second.gcode
    [ "$(grep -c '^;LAYER_CHANGE' first.gcode)" -eq 10 ]
    [ "$(grep -c '^;LAYER_CHANGE' second.gcode)" -eq 20 ]
    run filum print plates.3mf --plate 3 -o third.gcode
    [ "$status" -eq 3 ]
}

@test "public 3MF files: a verdict for each" {
    [ -n "${FILUM_3MF_SAMPLES:-}" ] || skip "FILUM_3MF_SAMPLES names no folder with 3mf-samples and lib3mf"
    "$FILUM_SOURCE/tests/threemf/check-samples" $FILUM_3MF_SAMPLES
}
