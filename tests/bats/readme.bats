#!/usr/bin/env bats
# Every command of the README and of the pages for its four readers: run, in the order of the page.
# shellcheck disable=SC2154

load common

setup_file() {
    source_tree=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    export source_tree PROFILES=$source_tree/lib/motion/machine/profiles PYTHONDONTWRITEBYTECODE=1
    cd "$BATS_FILE_TMPDIR" || exit 1
    for link in scripts examples python cmake tests; do ln -s "$source_tree/$link" $link; done
    ln -s "$FILUM_BUILD" build
    box_stl > part.stl
    examples/scaffold/make-part block 6 6 2 block.stl
    LAYERS=5 "$source_tree/tests/bodies/make-bodies" core-ring inks
    cp inks/a.stl ring.stl
    cp inks/b.stl core.stl
    LAYERS=5 "$source_tree/tests/bodies/make-bodies" vessels vessels
    cp vessels/a.stl vessels.stl
    cp examples/bracket/patch_A.ply face.ply
    cp examples/bracket/bracket.frd.gz result.frd.gz
    for python in python3 /usr/bin/python3; do
        "$python" -c 'import google.protobuf, numpy' 2> /dev/null && break
        python=
    done
    export python PYTHONPATH=$FILUM_BUILD/python
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

# What is tested elsewhere, or is what runs this: the tests that run it.
elsewhere() {
    case $1 in
        scripts/setup*) grep -q 'scripts/setup' "$source_tree/tests/bats/setup.bats" ;;
        'cmake --preset release && cmake --build build --target programs') [ -f "$FILUM_BUILD/build.ninja" ] ;;
        scripts/demo*) grep -q 'scripts/demo' "$source_tree/tests/bats/readme.bats" ;;
        scripts/test) grep -q 'scripts/test' "$source_tree/.ci/run" ;;
        *) false ;;
    esac
}

# The lines of page $1 that are code, without what they say behind #; python blocks as files python-N.
commands() { sed -nE '/^```/,/^```/d; s/^    ([^ ].*)$/\1/p' "$1" | sed -E 's/ +# .*$//'; }

run_page() {
    local line count=0
    while IFS= read -r line; do
        elsewhere "$line" && continue
        echo "+ $line"
        bash -euo pipefail -c "$line" > out 2> err < /dev/null || { echo "failed: $line"; head -n 5 err; return 1; }
        count=$((count + 1))
    done < <(commands "$1")
    [ "$count" -ge "$2" ]
}

@test "the README, two screens of it" {
    [ "$(wc -l < "$source_tree/README.md")" -le 80 ]
    run_page "$source_tree/README.md" 3
    [ "$(grep -c '^G1 ' part.gcode)" -gt 20 ]
}

@test "scripts/demo, on a small part" {
    [ "$(realpath "$FILUM_BUILD")" = "$(realpath "$source_tree/build")" ] || skip "these programs are not in build/"
    "$source_tree/scripts/demo" --out "$PWD/demo" bar > said
    tail -n 1 said | grep -q "look at the picture: $PWD/demo/part.png"
    [ -s demo/part.png ]
    [ -s demo/part.gcode ]
    [ -s demo/face.ngc ]
}

@test "bioprinting" {
    run_page "$source_tree/docs/bioprinting.md" 8
    [ "$(metrics --format tsv block.toolpath | awk -F'\t' '$1 == "strokes" || $1 == "stops" { print $2 }' | tr '\n' ' ')" = '1 0 ' ]
}

@test "paste and filament" { run_page "$source_tree/docs/paste-and-filament.md" 8; }

# first_print NAME: a folder of its own for the page of that printer.
first_print() {
    mkdir -p "first-$1"
    cd "first-$1" || return 1
    cp ../part.stl part.stl
    cp ../part.stl other.stl
}

@test "the first print from PrusaSlicer" {
    first_print prusa
    cp "$source_tree/tests/presets/plain-marlin.ini" config.ini
    "$source_tree/tests/threemf/sliced-project" prusa project.3mf config.ini
    run_page "$source_tree/docs/first-print-prusa.md" 9
    grep -q '^G1 Z3 F600' project.gcode # the start of the printer
    grep -q 'on the bed x 40.2 to 55.8, y 30.2 to 45.8' project.gcode
    [ "$(head -c 4 project.bgcode)" = GCDE ]
}

@test "the first print from Bambu Studio" {
    first_print bambu
    orca=$source_tree/tests/presets/orca
    "$source_tree/tests/threemf/sliced-project" bambu project.3mf "$orca/machine/bambu-like.json" "$orca/process/fast.json" "$orca/filament/warm.json"
    run_page "$source_tree/docs/first-print-bambu.md" 6
    grep -q '^M971 S11' project.gcode
    python3 -m zipfile -l project.gcode.3mf | grep -q plate_1.gcode
}

@test "the first print with Klipper" {
    first_print klipper
    for kind in machine process filament; do cp -r "$source_tree/tests/presets/orca/$kind" .; done
    cp machine/heats-by-macro.json machine.json
    cp process/fast.json process.json
    cp filament/warm.json filament.json
    export FILUM_PRESETS=$PWD # with what they inherit
    run_page "$source_tree/docs/first-print-klipper.md" 10
    grep -q '^EXCLUDE_OBJECT_DEFINE' two.gcode
    run ! grep -qE '^M1(04|09|40|90) S[1-9]' <(sed '/^;LAYER:1$/,$d' part.gcode) # the macro heats
}

@test "fibre" { run_page "$source_tree/docs/fibre.md" 8; }

@test "stage authors: python first, then the pipes" {
    [ -n "$python" ] || skip "no python3-protobuf, python3-numpy"
    awk '/^```python/ { ++n; on = 1; next } /^```/ { on = 0 } on { print > ("block-" n ".py") }' "$source_tree/docs/stage-authors.md"
    mv block-1.py walls.py
    mkdir -p bin
    ln -sf "$(command -v "$python")" bin/python3
    PATH=$PWD/bin:$PATH run_page "$source_tree/docs/stage-authors.md" 4
    "$python" block-2.py | grep -q '^1 strokes'
}

@test "python/README" {
    [ -n "$python" ] || skip "no python3-protobuf, python3-numpy"
    # its first block is Python; the second a stage; what is shell there is pip's, and tested in python.bats
    sed -nE '/^    import filum$/,/^[A-Z#]/s/^    //p' "$source_tree/python/README.md" > all.py
    awk '/^import filum$/ { ++n } { print > ("readme-" n ".py") }' all.py
    /usr/bin/python3 -c 'import matplotlib' 2> /dev/null || sed -i '/plot/d' readme-1.py
    sed -i 's/plot.layer(path, 10)/plot.layer(path, 3)/' readme-1.py
    MPLBACKEND=Agg "$python" readme-1.py
    slice part.stl | regions | sequence | "$python" readme-2.py --bead-width 0.5 | link3d | peek --check
}

@test "the site: every page of the four, and a search index" {
    command -v mkdocs > /dev/null || skip "no mkdocs"
    "$source_tree/scripts/site" --out "$PWD/site"
    for page in index docs/bioprinting docs/fibre docs/paste-and-filament docs/stage-authors docs/metrics python/index; do
        [ -s "site/html/$page.html" ] || { echo "missing: $page" && return 1; }
    done
    grep -q 'cut_to_nozzle' site/html/search/search_index.json
    [ -s site/html/docs/pictures/benchy.png ]
    grep -q 'src="docs/pictures/benchy.png"' site/html/index.html
}
