#!/usr/bin/env bats
# Hollow parts: walls, skins and sparse infill in as few strokes as the solid part.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    box_stl > part.stl
    slice --layer-height 0.05 part.stl | regions --bead-width 0.2 -o part.regions # 20 layers
    slice --scale 3 part.stl | regions -o large.regions                          # 27 x 27 x 3 mm
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

# value NAME: of a fact in the summary on standard input.
value() { awk -v name="$1" '$1 == "fact" && $3 == name { print $4 }'; }

# less A B: both are numbers above 0, and A is less than B.
less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(0 < a + 0 && a + 0 < b + 0) }'; }

@test "a hollow box is one stroke without a stop" {
    skins large.regions | sequence | fill | link3d --quiet -o large.toolpath
    [[ $(metrics --format tsv large.toolpath | awk '$2 == "strokes" || $1 == "strokes" { print; exit }') =~ [[:space:]]1([[:space:]]|$) ]]
    peek --text large.toolpath | grep -q 'feature infill'
}

@test "walls, skins and infill are told apart, and rows turn from layer to layer" {
    skins large.regions | sequence | fill | link3d --quiet | peek --text > large.text
    for feature in outer_wall wall solid infill; do grep -q "feature $feature" large.text; done
    skins large.regions | peek --text | awk '/area kind sparse/ { for (i = 1; i < NF; i++) if ($i == "direction") print $(i + 1) }' |
        sort -u > directions
    [[ $(wc -l < directions) == 2 ]]
}

@test "a modifier goes where the part goes, is filled otherwise, and all stays one stroke" {
    # the middle of the part, a box of 9 x 9 x 1 mm; turned and three times as large, as the part is
    block() { # FROM TO, of x and y
        printf 'OFF\n8 12 0\n'
        for z in -1 2; do printf '%s %s %s\n' "$1" 3 $z "$2" 3 $z "$2" 6 $z "$1" 6 $z; done
        printf '3 %s %s %s\n' 0 2 1 0 3 2 4 5 6 4 6 7 0 1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7
    }
    block 3 6 > knob.off
    chain() { slice --scale 3 --rotate 0,0,30 --translate 50,9,0 part.stl | regions | skins --solid-below 0 "$@"; }
    chain --modifier knob.off:infill=50% -o knob.regions 2> said
    [[ ! -s said ]]
    less "$(peek knob.regions | value modifier-1-infill-spacing)" "$(peek knob.regions | value infill-spacing)"
    sequence knob.regions | fill | link3d --quiet -o knob.toolpath
    [[ $(metrics --format tsv knob.toolpath | awk '$2 == "strokes" || $1 == "strokes" { print; exit }') =~ [[:space:]]1([[:space:]]|$) ]]
    # nothing of a path enters the history
    peek knob.regions | { ! grep -q 'knob.off'; }
    run chain --modifier far.off:infill=50% -o no
    [[ $status == 5 && $output == *far.off* && ! -e no ]]
    block 903 906 > far.off
    run chain --modifier far.off:infill=50% -o far.regions
    [[ $status == 0 && $output == *"[body-apart]"* ]]
    filum print part.stl --scale 3 --infill 15% --modifier 'knob.off:infill=50%' -q -o knob.gcode
    [[ $(tail -n 1 knob.gcode) == *"end of program"* ]]
}

@test "several parts on a bed have no modifiers" {
    run bash -c 'slice part.stl --copies 2 | regions --quiet | skins --modifier part.stl:infill=40%'
    [[ $status == 4 || $status == 3 ]]
    [[ $output == *"a single part"* ]]
}

# A project of PrusaSlicer on standard output: a block of 40 x 24 x 4 mm on z = 0 and in it a body of 14 x 24 mm, whose
# settings are KEY=VALUE; PAINT on the lower face of the block.
project_3mf() { # PAINT KEY=VALUE...
    python3 -c '
import io, sys, zipfile
def box(x0, y0, x1, y1, z0, z1):
    return [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
faces = [(0,2,1),(0,3,2),(4,5,6),(4,6,7),(0,1,5),(0,5,4),(1,2,6),(1,6,5),(2,3,7),(2,7,6),(3,0,4),(3,4,7)]
paint, settings = sys.argv[1], [w.split("=", 1) for w in sys.argv[2:]]
points = box(0, 0, 40, 24, 5, 9) + box(4, -1, 18, 25, 4, 10) + box(0, 0, 5, 24, 0, 5)
rows = []
for first, color in ((0, paint), (16, ""), (8, "")):
    for k, t in enumerate(faces):
        on = " slic3rpe:custom_supports=\"%s\"" % color if color and k < 2 else ""
        rows.append("<triangle v1=\"%d\" v2=\"%d\" v3=\"%d\"%s/>" % (*(v + first for v in t), on))
model = ("<model unit=\"millimeter\" xmlns:slic3rpe=\"p\"><resources><object id=\"1\"><mesh><vertices>" +
         "".join("<vertex x=\"%g\" y=\"%g\" z=\"%g\"/>" % p for p in points) + "</vertices><triangles>" +
         "".join(rows) + "</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>")
meta = "".join("<metadata type=\"volume\" key=\"%s\" value=\"%s\"/>" % tuple(w)
               for w in [("volume_type", "ParameterModifier")] + settings)
out = io.BytesIO()
with zipfile.ZipFile(out, "w") as z:
    z.writestr("_rels/.rels", "<Relationships><Relationship Target=\"/3D/3dmodel.model\" Id=\"r\" "
               "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>")
    z.writestr("3D/3dmodel.model", model)
    z.writestr("Metadata/Slic3r_PE_model.config",
               "<config><object id=\"1\"><volume firstid=\"24\" lastid=\"35\">%s</volume></object></config>" % meta)
    z.writestr("Metadata/Slic3r_PE.config", "; fill_density = 15%\n; perimeters = 3\n; support_material = 1\n"
               "; support_material_auto = 0\n")
sys.stdout.buffer.write(out.getvalue())' "$@"
}

strokes_of() { metrics --format tsv "$1" | awk '$1 == "strokes" || $2 == "strokes" { print $NF; exit }'; }

@test "fewer walls and other beads in a body: told in zones, one stroke, more material of wider beads" {
    block() { # X0 X1
        printf 'OFF\n8 12 0\n'
        for z in -1 2; do printf '%s %s %s\n' "$1" -1 $z "$2" -1 $z "$2" 10 $z "$1" 10 $z; done
        printf '3 %s %s %s\n' 0 2 1 0 3 2 4 5 6 4 6 7 0 1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7
    }
    block 1 4 > few.off
    block 5 8 > wide.off
    slice --scale 4 part.stl | regions -o four.regions
    skins --walls 3 --solid-below 0 --modifier 'few.off:walls=1;wide.off:bead-width=0.8' four.regions -o zones.regions
    peek --text zones.regions | grep 'area kind zone' > zones
    [[ $(wc -l < zones) -gt 0 ]]
    sequence zones.regions | fill | link3d --quiet -o zones.toolpath
    [[ $(strokes_of zones.toolpath) == 1 ]]
    for threads in 1 2 8; do skins --threads $threads --walls 3 --solid-below 0 \
        --modifier 'few.off:walls=1;wide.off:bead-width=0.8' four.regions | sequence | fill --threads $threads | cksum; done |
        sort -u > sums
    [[ $(wc -l < sums) == 1 ]]
    # beads as wide as asked within 2 % (rounded corners are wider by what they are shorter), and of infill the share asked, in
    # what the outer wall leaves of the body
    skins --bridge 9 --modifier 'wide.off:walls=1,bead-width=0.5,infill=40%' four.regions | sequence | fill | link3d --quiet |
        peek --text > dense.text
    awk '/^span/ { inside = / feature infill / }
         /^ / { if (inside && p && $1 > 20 && $1 < 32 && x > 20 && x < 32) {
                    l = sqrt(($1 - x) ^ 2 + ($2 - y) ^ 2); sum += l; wide += l * ($4 + w) / 2 }
                x = $1; y = $2; w = $4; p = inside }
         END { share = sum * 0.5 / (12 * 12 * 35.2); print share, wide / sum
               if (share < 0.392 || share > 0.408 || wide / sum < 0.49 || wide / sum > 0.51) exit 1 }' dense.text
}

@test "settings of modifiers: other slicers' names work, wrong ones say what to type" {
    skins --modifier part.stl:fill_density=40%,perimeters=3 large.regions -o theirs.regions
    skins --modifier part.stl:infill=40%,walls=3 large.regions -o ours.regions
    cmp theirs.regions ours.regions
    run skins --modifier part.stl:infil=40% large.regions -o no
    [[ $status == 2 && $output == *"did you mean 'infill'?"* ]]
    run skins --modifier part.stl:fill_pattern=honeycomb large.regions -o no
    [[ $status == 2 && $output == *"here it is 'infill-pattern'"* ]]
    run skins --modifier part.stl large.regions -o no
    [[ $status == 2 && $output == *"FILE:SETTINGS"* ]]
    [[ ! -e no ]]
}

@test "a project's modifiers, enforcers and paint" {
    project_3mf 4 name=knob fill_density=40% perimeters=1 extrusion_width=0 fuzzy_skin=all > project.3mf
    project_3mf '' name=knob fuzzy_skin=all > idle.3mf
    slice project.3mf 2> said | regions --quiet -o p.regions
    [[ $(< said) == *'[project-modifier]'* ]]
    skins --walls 3 --modifier project.3mf p.regions -o p.skins 2> said
    [[ $(< said) == *"setting 'fuzzy_skin=all' of a part or modifier of the project was ignored"* && $(< said) != *extrusion_width* ]]
    [[ -n $(peek p.skins | value modifier-1-infill-spacing) ]]
    peek --text p.skins | grep -q 'area kind zone'
    # paint, in two of twelve triangles, looks down over 35 x 24 mm of air
    supports --support-in project.3mf p.skins -o p.supports
    [[ $(peek p.supports | value support-in-painted) == 960* ]]
    peek --text p.supports | grep -q 'purpose carrier'
    run supports --no-support-in project.3mf --support p.skins -o no
    [[ $status == 3 && $output == *'--support-in'* ]]
    run skins --modifier part.3mf p.regions -o no
    [[ $status == 5 ]]
    # all of it by --load, where it is the part as well
    filum print project.3mf --dry-run --load project.3mf > line 2> said
    [[ $(< line) == *"--modifier=project.3mf"*"--support-in=project.3mf"* ]]
    [[ $(< line) != *'--support '* && $(< line) != *'--no-support-in'* ]]
    filum print part.stl --dry-run --load project.3mf > line 2> said
    [[ $(< line) != *modifier* && $(< said) == *"bodies that change settings in 'project.3mf' left out"* ]]
    filum print project.3mf --load project.3mf -q -o project.gcode
    [[ $(tail -n 1 project.gcode) == *"end of program"* ]]
}

@test "concentric lines lie at one place in all layers, and make one stroke with the walls" {
    skins --infill-pattern concentric large.regions | sequence | fill > rings.paths
    [[ $(peek rings.paths | value infill-share) =~ ^1[45] ]]
    peek --text rings.paths | { ! grep 'not joined'; }
    link3d --quiet rings.paths -o rings.toolpath
    [[ $(metrics --format tsv rings.toolpath | awk '$2 == "strokes" || $1 == "strokes" { print; exit }') =~ [[:space:]]1([[:space:]]|$) ]]
}

@test "--infill 100% is the solid part, byte for byte but for the history" {
    frames() { peek --json | sed 's/"history".*"frames"/"frames"/'; }
    sequence large.regions | fill | peek --text | sed '1,/^paths/{/^paths/!d}' > solid
    skins --infill 100% large.regions | sequence | fill | peek --text | sed '1,/^paths/{/^paths/!d}' > full
    [ -s solid ]
    cmp solid full
}

@test "more infill is more material, in the share that is asked for" {
    slice --scale 4 part.stl --layer-height 0.1 | regions -o deep.regions # 36 x 36 x 4 mm, 40 layers
    local before=0 laid
    for infill in 10 20 40; do
        skins --infill $infill% --bridge 9 deep.regions | sequence | fill | link3d --quiet | peek --text > deep.text
        # mm of infill, over 32 layers, in 34.4 x 34.4 mm of them
        laid=$(awk '/^span/ { inside = / feature infill /; n = 0 }
                    /^ / { if (inside && n++) sum += sqrt(($1 - x) ^ 2 + ($2 - y) ^ 2); x = $1; y = $2 }
                    END { print sum }' deep.text)
        awk -v laid="$laid" -v infill="$infill" 'BEGIN {
            share = laid * 0.4 / (32 * 34.4 * 34.4) * 100
            if (share < 0.96 * infill || share > 1.04 * infill) { print infill, share; exit 1 } }'
    done
}

@test "what --infill cannot be is told" {
    for wrong in 101% -1 x '' 15%%; do
        expect 2 skins --infill "$wrong" part.regions
        complaint skins
        [[ $err == *infill* ]]
    done
}

@test "filum print takes skins into the chain where asked" {
    [[ $(filum print part.stl --dry-run) != *skins* ]]
    [[ $(filum print part.stl --dry-run --bead-width 0.5) != *skins* ]]
    [[ $(filum print part.stl --dry-run --infill 20%) == *'| skins --infill=20% |'* ]]
    [[ $(filum print part.stl --dry-run --skins.bead-width 0.5) == *'| skins --bead-width=0.5 |'* ]]
    filum print part.stl --walls 3 --infill 20% --layer-height 0.1 --quiet --machine marlin -o part.gcode
    [ -s part.gcode ]
}

@test "a table is carried by columns that are printed before its top, and is one part with few strokes" {
    boxes table.stl 0,0,0,4,4,4 16,0,0,20,4,4 0,0,4,20,4,5
    filum print table.stl --infill 20% --support --quiet --machine marlin -o table.gcode
    [ -s table.gcode ]
    slice table.stl | regions -o hanging.regions
    peek --text hanging.regions | grep -qE "^note stage regions .* code '?overhang"
    skins hanging.regions | supports --support --beside 0.4 | peek --text > whole.text
    [[ $(grep -cE "code '?overhang" whole.text) == 0 ]] # it hangs no more
    skins hanging.regions | supports --support -o table.regions
    peek --text table.regions | grep overhang > beside
    grep -q '^note stage supports .*longest bridge spans 1[. ]' beside # from the legs to the columns
    sequence table.regions | fill | link3d --quiet -o table.toolpath
    peek --text table.toolpath > table.text
    grep -q 'feature support' table.text
    grep -q 'feature interface' table.text
    # no bead of a support is laid after the first one of the top
    awk '/^span/ { top = top || (/ layer 20 / && !/ travel /); if (top && / feature (support|interface) /) exit 1 }' table.text
    # three columns 1 mm apart, climbed in turns: the cone lets one be 1.4 mm ahead
    [[ $(awk '/^span role travel/ { n++ } END { print n + 1 }' table.text) -le 10 ]]
}

@test "a lid over a cup is laid in rows along its shorter side, in one stroke" {
    boxes cup.stl 0,0,0,20,14,1 0,0,1,2,14,3 18,0,1,20,14,3 2,0,1,18,2,3 2,12,1,18,14,3 0,0,3,20,14,4
    slice cup.stl | regions --quiet | skins -o cup.regions
    [[ $(peek --text cup.regions | grep -c 'area kind bridge.* direction 1.570796 ') == 1 ]]
    sequence cup.regions | fill | link3d -o cup.toolpath
    peek --text cup.toolpath | awk '/^span/ { inside = / feature bridge /; n = 0; strokes += / role travel / }
        /^ / { if (inside && n++) { u += ($1 - x) ^ 2 > ($2 - y) ^ 2 ? sqrt(($1 - x) ^ 2) : 0; v += sqrt(($2 - y) ^ 2) }
               x = $1; y = $2 }
        END { exit !(v > 16 * 10 / 0.4 && u < 0.1 * v && strokes == 0) }'
    filum print cup.stl --infill 15% --quiet --machine marlin --set feeds.bridge=11 -o cup.gcode
    grep -q ';TYPE:Bridge infill' cup.gcode
    grep -q 'F660$' cup.gcode
}

# hanging: mm2 that hang in the air, as the stream on standard input tells it.
hanging() { peek --text | sed -nE "/ code '?overhang/s/^note .* amount ([0-9.]+).*/\1/p"; }

@test "what supports leave in the air is told" {
    # on the bed only: over a block none stand
    boxes over.stl 0,0,0,4,4,4 16,0,0,20,4,4 7,0,0,13,4,2 0,0,4,20,4,5
    slice over.stl | regions --quiet -o over.regions
    local all anywhere bed steps
    all=$(hanging < over.regions)
    anywhere=$(supports --support --quiet over.regions | hanging)
    bed=$(supports --support --support-on bed --quiet over.regions | hanging)
    awk -v all="$all" -v anywhere="$anywhere" -v bed="$bed" 'BEGIN { exit !(anywhere < 6 && bed > 24 && bed < all) }'
    # stairs that lean by 72 degrees, carried from 80 degrees on: as if there were no supports
    mapfile -t steps < <(for k in {0..9}; do awk -v k="$k" 'BEGIN { print "0,0," 0.2 * k "," 5 + 0.6 * k ",8,3" }'; done)
    boxes stairs.stl "${steps[@]}"
    slice stairs.stl | regions --quiet -o stairs.regions
    hanging < stairs.regions > before
    supports --support --support-angle 80 --quiet stairs.regions | hanging > after
    [ -s before ]
    cmp before after
    # carried, but for the first step and the last, where there is no room for a column
    supports --support --support-angle 60 --beside 0.2 --quiet stairs.regions | hanging > after
    awk 'NR == FNR { before = $1; next } { exit !($1 * 9 < before * 2.1) }' before after
}

@test "a brim is part of a stroke, solid or hollow, on a bed of several parts, too" {
    for more in "" "--infill 20%" "--infill 20% --support" "--raft 2" "--copies 3"; do
        # shellcheck disable=SC2086
        for brim in 0 4; do filum print part.stl --scale 3 $more --brim $brim --quiet -o brim-$brim.gcode; done
        strokes() { sed -nE 's/^; layers = .*strokes = ([0-9]+)$/\1/p' "$1"; }
        echo "$more: $(strokes brim-0.gcode), with a brim $(strokes brim-4.gcode)"
        [[ -n $(strokes brim-0.gcode) && $(strokes brim-0.gcode) == "$(strokes brim-4.gcode)" ]]
        run -1 cmp -s brim-0.gcode brim-4.gcode
    done
}

@test "a brim and a skirt are laid with the first layer only" {
    slice part.stl | regions | supports --brim 3 --skirt 2 | sequence | fill | link3d --quiet | peek --text > brim.text
    grep -q 'feature skirt' brim.text
    grep 'feature skirt' brim.text | run -1 grep -qv 'layer 0 '
}

@test "a raft is laid first, and the part on it" {
    slice part.stl | regions --quiet | skins --quiet | supports --raft 3 --quiet -o raft.regions
    sequence raft.regions | fill | link3d --quiet -o raft.toolpath
    peek --text raft.toolpath > raft.text
    # layers 0 to 2 are raft, 3 is left out, 4 to 8 are the part
    awk '/^span role bead/ { raft = / feature (support|interface) /; for (i = 1; i < NF; i++) if ($i == "layer") layer = $(i + 1)
             if (raft != (layer < 3) || layer == 3 || (raft && part)) exit 1
             part = part || !raft; if (layer > last) last = layer }
         END { exit last != 8 }' raft.text
    expect 2 supports --raft 3 --beside 2 raft.regions
    complaint supports
}

@test "sparse areas get the share of material that was asked" {
    "$FILUM_SOURCE/tests/parts/infill-volumes" volumes --parts l --shares 20 --every 5
}

@test "walls that lean out have the speed of their share over air, as each slicer has it" {
    "$FILUM_SOURCE/tests/parts/overhang-speeds" speeds --step 20
    skins large.regions | sequence | fill --overhang-shares | link3d --quiet | peek --text > upright.text
    run ! grep -q 'over_air [1-9]' upright.text
}
