#!/usr/bin/env bats
# Notes: every code is used, a print says each once, nothing harmless unless asked.

load common

setup() { cd "$BATS_TEST_TMPDIR" || return; }

@test "every code of the table is used" {
    local code
    sed -nE 's/^NOTE\((\w+),.*/\1/p' "$FILUM_SOURCE/lib/foundation/base/notes.def" > codes
    [[ -s codes ]]
    cat "$FILUM_SOURCE"/cmds/*.cpp $(find "$FILUM_SOURCE/lib" -name '*.?pp' -not -path '*/base/*') > all
    while read -r code; do
        grep -q "NoteCode::$code\b" all || { echo "unused: $code"; false; }
    done < codes
}

@test "an ordinary hollow print says nothing harmless; --notes all does" {
    local bar=$FILUM_SOURCE/examples/bar/bar.stl
    filum print "$bar" --infill 15 --notes all -o all.gcode 2> all
    filum print "$bar" --infill 15 -o part.gcode 2> said
    run ! grep -q harmless said
    grep -v harmless all | cmp - said
    [[ $(sort said | uniq -d | wc -l) == 0 ]]
}

@test "a print says each note once, at the end, the gravest first" {
    boxes table.stl 0,0,0,4,4,4 16,0,0,20,4,4 0,0,4,20,4,5
    filum print table.stl --keep kept -o table.gcode 2> said
    [[ $(grep -c 'add --support' said) == 1 && $(< said) == postproc:* ]]
    grep -q '^; note: look: .*overhang' table.gcode
    sed -E 's/^postproc: (will fail|look): .*/\1/' said | uniq | cmp - <(sed -E 's/^postproc: (will fail|look): .*/\1/' said | sort -ru)
    metrics --format json kept/5-link3d.toolpath | grep -q 'overhang'
    # a stage alone says its own
    regions kept/1-slice.layers 2>&1 > /dev/null | grep -q '^regions: look: .*\[overhang'
    slice table.stl | regions 2> /dev/null | sequence 2>&1 > /dev/null | grep -c overhang | grep -qx 0
}
