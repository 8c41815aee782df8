#!/usr/bin/env bats
# The front command.
# shellcheck disable=SC2154

load common

setup_file() { make_part_and_contracts; }

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "filum STAGE is the stage" {
    filum slice part.stl > a
    slice part.stl > b
    cmp a b
    expect 2 filum slice --no-such-option
    complaint slice
}

@test "filum list names every stage with what it reads and writes" {
    expect 0 filum list
    [[ $out =~ slice\ +file\ -\>\ Layers && $out =~ fill\ +Regions\ -\>\ Paths ]]
}

@test "unknown commands, and none at all, end with 2" {
    expect 2 filum
    complaint filum
    expect 2 filum no-such-stage
    complaint filum
    expect 2 filum ../bin/slice
    expect 2 filum list extra
    expect 2 filum help no-such-stage
}

@test "filum help explains stages and itself" {
    expect 0 filum help slice
    [[ $out == 'slice - '* ]]
    expect 0 filum help
    [[ $out == 'filum - '* ]]
    expect 0 filum help print
    [[ $out == 'usage: filum print'* ]]
}

@test "filum print is the pipeline by hand" {
    filum print part.stl -o a.gcode
    slice part.stl | regions | sequence | fill | link3d | postproc > b.gcode
    cmp a.gcode b.gcode
    filum print < part.stl > c.gcode
    cmp a.gcode c.gcode
}

@test "options go to every stage that has them, --STAGE.OPTION to one" {
    expect 0 filum print part.stl --layer-height 0.25 --bead-width=0.5 --fill.bead-width 0.6 --dry-run
    [[ $out =~ slice\ --layer-height=0.25 ]]
    [[ $out =~ regions\ --bead-width=0.5\  ]]
    [[ $out =~ fill\ --bead-width=0.5\ --bead-width=0.6 ]]
    filum print part.stl --layer-height 0.25 --bead-width=0.5 > a.gcode
    filum print part.stl --layer-height 0.25 --bead-width=0.5 --dry-run | bash > b.gcode
    cmp a.gcode b.gcode
}

@test "filum print refuses what no stage knows" {
    expect 2 filum print part.stl --no-such-option 3
    complaint filum
    expect 2 filum print part.stl --slice.pattern spiral
    expect 5 filum print part.stl other.stl
    expect 2 filum print part.stl --layer-height
    expect 2 filum print part.stl -o
    expect 2 filum print part.stl --layer-height=-1
    complaint slice
}

@test "filum print: files with odd names" {
    cp part.stl "a part's name.stl"
    filum print "a part's name.stl" -o 'out put.gcode'
    [[ -s 'out put.gcode' ]]
    filum print "a part's name.stl" --dry-run | bash | cmp - 'out put.gcode'
}

@test "filum env puts the stages on the PATH" {
    front=$(command -v filum)
    # shellcheck disable=SC2016
    out=$(env -i HOME=/ PATH=/usr/bin:/bin bash -c 'eval "$("$1" env)" && slice part.stl | peek --check && echo fine' - "$front")
    [[ $out == fine ]]
}

@test "filum print takes a file behind --" {
    cp part.stl ./-part.stl
    expect 0 filum print -o dashes.gcode -- -part.stl
    [[ -s dashes.gcode ]]
    expect 0 filum print -o plain.gcode -- part.stl
    cmp dashes.gcode plain.gcode
}

@test "filum print tells of a wrong profile once, and what was meant" {
    expect 2 filum print part.stl --machine marln
    complaint filum
    [[ $err == *"did you mean 'marlin'?"* ]]
    expect 2 filum print part.stl --set nozzle_tmp=250
    complaint filum
    [[ $err == *"did you mean 'nozzle_temp'?"* ]]
    expect 2 filum print part.stl --head marln
    complaint filum
    printf 'name = "x"\nabuot = "y"\n' > wrong.toml
    expect 3 filum print part.stl --machine ./wrong.toml
    complaint filum
}

@test "filum print writes no program to a terminal, and ends quietly if its reader leaves" {
    command -v script > /dev/null || skip "no script(1)"
    code=0
    script -qec "filum print part.stl" /dev/null > tty.out < /dev/null || code=$?
    [[ $code == 2 && $(cat tty.out) == *"-o part.gcode"* && $(wc -c < tty.out) -lt 200 ]]
    boxes big.stl 0,0,0,60,60,6
    filum print big.stl 2> err | head -n 1 > first
    [[ -s first && ! -s err ]] || { cat err; false; }
}

@test "on a terminal filum print says in five lines what it made, and the same stands first in the program" {
    command -v script > /dev/null || skip "no script(1)"
    script -qec "filum print part.stl -o made.gcode" /dev/null < /dev/null | tr -d '\r' | sed 's/\x1b\[K//g' > tty.out
    [[ $(wc -l < tty.out) -eq 5 && $(head -n 1 tty.out) == made.gcode ]] || { cat tty.out; false; }
    for n in 2 3 4 5; do
        [[ "; $(sed -n "${n}s/^  //p" tty.out)" == "$(sed -n ${n}p made.gcode)" ]] || { cat tty.out; head -n 6 made.gcode; false; }
    done
    [[ $(sed -n 2p made.gcode) == '; 1 stroke (proven the fewest); 0 stops' ]]
    filum print part.stl -o plain.gcode 2> err
    [[ ! -s err ]]
    cmp plain.gcode made.gcode
    # the history is at the end
    [[ $(grep -n '^; made by' plain.gcode | cut -d : -f 1) -gt $(grep -n '^M84' plain.gcode | cut -d : -f 1) ]]
}

@test "a stage says how far it is where it is told to, and filum print draws that" {
    slice part.stl | regions | sequence > sequenced
    FILUM_PROGRESS=3 fill sequenced -o paths 3> told
    grep -qx "fill 5 5" told
}

@test "filum print --keep leaves every stage's stream, --picture a picture; a failure leaves nothing" {
    filum print part.stl --keep kept --picture part.png -o kept.gcode
    [[ $(ls kept) == $'1-slice.layers\n2-regions.regions\n3-sequence.regions\n4-fill.paths\n5-link3d.toolpath' ]]
    for s in kept/*; do peek --check "$s"; done
    postproc kept/5-link3d.toolpath | cmp - kept.gcode
    [[ $(head -c 4 part.png | tail -c 3) == PNG ]]
    expect 1 filum print part.stl --set limits.section=0.01 --keep none --picture none.png -o none.gcode
    [[ -z $(ls none) && ! -e none.png && ! -e none.gcode ]]
}

@test "filum machines and filum patterns list what there is to choose" {
    expect 0 filum machines
    [[ $out == *marlin* && $out == *linuxcnc-xyzac* && $(wc -l <<< "$out") -ge 15 ]]
    expect 0 filum patterns
    [[ $out == *'fill --pattern spiral'* && $out == *'surfpath fina'* ]]
    expect 2 filum machines extra
}

@test "filum NAME runs filum-NAME of the PATH, but nothing hides a stage" {
    mkdir -p own
    printf '#!/bin/sh\necho "mine: $*"\n' > own/filum-mine
    cp own/filum-mine own/filum-slice
    chmod +x own/*
    PATH=$PATH:$PWD/own expect 0 filum mine 1 2
    [[ $out == 'mine: 1 2' ]]
    PATH=$PATH:$PWD/own expect 0 filum list
    [[ $out == *"'filum-mine' on the PATH"* && $(grep -c '^slice' <<< "$out") -eq 1 ]]
    PATH=$PATH:$PWD/own filum slice part.stl | peek --check -
    expect 2 filum mine
}

@test "filum print --stage puts a program of one's own in the chain" {
    printf '#!/bin/sh\nexec %s --pattern contour\n' "$(command -v fill)" > my-fill
    chmod +x my-fill
    filum print part.stl --stage fill=./my-fill -o mine.gcode
    filum print part.stl --pattern contour | cmp - mine.gcode
    expect 2 filum print part.stl --stage fll=./my-fill
    [[ $err == *"did you mean 'fill'?"* ]]
    expect 2 filum print part.stl --stage fill=./none
    complaint filum
    expect 2 filum print part.stl --stage fill
    complaint filum
}

@test "filum check finds the promises that a program breaks" {
    expect 0 filum check "$(command -v fill)" --as fill
    [[ $out == *'all promises kept'* && $out != *BROKEN* ]] || { echo "$out"; false; }
    printf '#!/bin/sh\nexec cat\n' > passes
    chmod +x passes
    expect 1 filum check ./passes --as fill
    for broken in 'it carries Paths' 'a truncated input' 'a flipped byte' 'another payload' 'an unknown option'; do
        grep -q "^BROKEN  $broken" <<< "$out" || { echo "$out"; false; }
    done
    expect 2 filum check ./passes --as fll
    [[ $err == *"did you mean 'fill'?"* ]]
    expect 2 filum check ./none --as fill
}

@test "names of other slicers are answered with ours" {
    expect 2 slice part.stl --layer_height 0.2
    [[ $err == *"here it is '--layer-height'"* ]]
    expect 2 fill part.stl --line-width 0.5
    [[ $err == *"here it is '--bead-width'"* ]]
    expect 2 postproc part.stl --print-speed 80
    [[ $err == *"here it is '--set feeds.bead=N'"* ]]
    expect 2 fill --fill-pattern zigzag part.stl
    [[ $err == *"here it is '--pattern'"* ]]
    expect 2 filum print part.stl --export-gcode x
    [[ $err == *"here it is '--output'"* ]]
}

@test "filum print takes options by the names of slicers, and their files of settings" {
    ours() { filum print part.stl --dry-run "$@"; }
    [[ $(ours --line-width 0.5) == *'| fill --bead-width=0.5 |'* ]]
    [[ $(ours --print-speed 80 --temperature 230) == *'postproc --set=feeds.bead=80,nozzle_temp=230'* ]]
    [[ $(ours --rotate 45 --scale 150%) == 'slice --rotate=0,0,45 --scale=1.5 '* ]]
    printf 'layer_height = 0.25\nfill_density = 20%%\nperimeters = 2\nironing = 1\n' > slicer.ini
    expect 0 filum print part.stl --dry-run --load slicer.ini --perimeters 3
    [[ $out == *'slice --layer-height=0.25 '*'| skins --infill=20% --walls=2 --walls=3 |'* ]]
    [[ $err == *'1 more setting of --load not used yet'*': ironing'* ]]
    printf 'seam_position = rear\nfilament_shrinkage_compensation_xy = 0.8%%\n' > slicer.ini
    expect 0 filum print part.stl --dry-run --load slicer.ini
    [[ $out == *'slice --shrinkage=0.8,0.8,0 '*'| link3d --seam=back |'* && -z $err ]]
    printf 'seam_position = aligned\nfilament_shrink = 99.5%%\n' > slicer.ini # of SuperSlicer: what is left
    expect 0 filum print part.stl --dry-run --load slicer.ini
    [[ $out == *'slice --shrinkage=0.5,0.5,0 '* && $out == *--seam=nearest* ]]
    [[ $err != *seam_position* ]]
    printf 'layer_height = 0.25\nfilament_shrink = 100%%\n' > slicer.ini
    expect 0 filum print part.stl --dry-run --load slicer.ini
    [[ $out == *'slice --layer-height=0.25 '* && $out != *shrinkage* && -z $err ]]
    printf 'layer_height = 0.25\nfill_density = 20%%\nperimeters = 2\nironing = 1\n' > slicer.ini
    expect 5 filum print part.stl --load missing.ini
    expect 3 filum print part.stl --load part.stl
    [[ $err == *'it holds no settings of a slicer'* ]]
    filum print part.stl --load slicer.ini --perimeters 3 --layer-height 0.1 --quiet --output loaded.gcode
    filum print part.stl --infill 20% --walls 3 --layer-height 0.1 --quiet --output typed.gcode
    cmp <(grep -v '^;' loaded.gcode) <(grep -v '^;' typed.gcode)
}

@test "filum print takes the settings of slicers' projects" {
    pack() { python3 -c 'import sys, zipfile; zipfile.ZipFile(sys.argv[1], "w").writestr(sys.argv[2], sys.stdin.read())' "$@"; }
    printf '; generated by a slicer\n; layer_height = 0.25\n; perimeters = 3\n; brim_width = 0\n; filament_diameter = 1.75,1.75\n' |
        pack prusa.3mf Metadata/Slic3r_PE.config
    expect 0 filum print part.stl --dry-run --load prusa.3mf
    [[ $out == *'slice --layer-height=0.25 '*'--walls=3'*'extrusion.diameter=1.75'* && -z $err ]]
    printf '{"layer_height": "0.25", "wall_loops": "3", "sparse_infill_density": "20%%", "sparse_infill_pattern": "grid",
        "line_width": "0.42", "nozzle_diameter": ["0.4"], "nozzle_temperature": ["225", "220"], "brim_width": "5",
        "brim_type": "no_brim", "skirt_loops": "0", "skirt_distance": "2", "timelapse_type": "1"}' | tee orca.json |
        pack orca.3mf Metadata/project_settings.config
    for file in orca.json orca.3mf; do
        expect 0 filum print part.stl --dry-run --load $file
        [[ $out == *'slice --layer-height=0.25 '*'skins '*'--infill=20%'*'--walls=3'*'--bead-width=0.42'*'nozzle_temp=225'* ]]
        [[ $out != *brim* && $out != *skirt* && -z $err ]]
    done
    for kind in outer_only auto_brim; do
        printf '{"brim_width": "5", "brim_type": "%s"}' $kind > brim.json
        expect 0 filum print part.stl --dry-run --load brim.json
        if [[ $kind == outer_only ]]; then [[ $out == *'supports --brim=5 '* && -z $err ]]; else
            [[ $out != *brim* && $err == *'no brim: brim_type is auto_brim'* ]]; fi
    done
    head -c 150 orca.3mf > cut.3mf
    expect 3 filum print part.stl --load cut.3mf
    [[ $err == *'no whole zip archive'* ]]
    head -c 150 orca.json > cut.json
    expect 3 filum print part.stl --load cut.json
    pack other.3mf 3D/3dmodel.model < /dev/null
    expect 3 filum print part.stl --load other.3mf
    [[ $err == *'it holds no settings of a slicer'* ]]
}

@test "an option that does nothing in any stage is refused by the stage that has it" {
    expect 2 filum print part.stl --spacing 1.2
    [[ $err == *"fill: cannot use --spacing: it does nothing without --pattern scaffold"* ]]
    expect 0 filum print part.stl --stage fill=fill-sun2019 --start-shift 1 --dry-run
    [[ $out == *"fill-sun2019 --start-shift=1"* && $out != *"link3d --start-shift"* ]]
}

@test "control codes of names and files are shown, not sent" {
    cp part.stl $'odd\033[31m\nname.stl'
    expect 5 slice $'no\033[31m\nsuch.stl'
    complaint slice
    [[ $err != *$'\033'* && $err == *'\x1b[31m\nsuch'* ]]
    head -c 30 part.stl > $'odd\033[31m\nname.stl'
    expect '3|4' slice $'odd\033[31m\nname.stl'
    complaint slice
    [[ $err != *$'\033'* ]]
    geodesic part.stl | partition --names $'a\033[31mb' 2> /dev/null > named.patches || true
    if [[ -s named.patches ]]; then
        peek --text named.patches > text
        run -1 grep -q $'\033' text
    fi
}

@test "an output keeps the mode of the file it replaces, follows links, and goes to what is open" {
    echo old > mine
    chmod 600 mine
    slice part.stl -o mine
    [[ $(stat -c %a mine) == 600 ]]
    peek --check mine
    ln -s later.layers dangling
    slice part.stl -o dangling
    [[ -L dangling ]]
    peek --check later.layers
    echo kept > appended
    slice part.stl | peek -o /dev/stdout >> appended
    [[ $(head -n 1 appended) == kept && $(wc -l < appended) -gt 3 ]]
    mkfifo tube
    cat tube > through &
    local reader=$!
    slice part.stl -o tube
    wait "$reader"
    cmp through mine
}

@test "ten typical mistakes are answered in one line that says what to type" {
    slice part.stl -o part.layers
    said() { # PATTERN COMMAND...: one line that holds it
        local pattern=$1
        shift
        expect '2|3' "$@"
        [[ $(wc -l <<< "$err") -eq 1 && $err == *"$pattern"* ]] || { echo "$*: $err"; false; }
    }
    said "did you mean '--layer-height'?" slice --layerheight 0.3 part.stl
    said "did you mean '--layer-height'?" slice -layer-height 0.3 part.stl
    said "did you mean 'spiral'?" fill --pattern spirl part.layers
    said "run 'regions | sequence' on it first" fill part.layers
    said "'slice'" regions part.stl
    said "did you mean 'marlin'?" postproc --machine marln part.layers
    said "did you mean 'feeds.bead'?" filum print part.stl --set feeds.baed=40
    said "--pattern scaffold" filum fill --spacing 1 part.layers
    said "did you mean 'slice'?" filum slcie part.stl
    said "at least" slice --layer-height 0 part.stl
    said "see 'regions --help'" regions part.layers other.layers
}

@test "filum's own commands have help, by either way" {
    for command in list env machines patterns check settings; do
        expect 0 filum help $command
        [[ $out == usage:*"filum $command"* ]]
        local by_help=$out
        expect 0 filum $command --help
        [[ $out == "$by_help" ]]
    done
}

@test "a print without a part, and an option without its value, say what to type" {
    expect 2 filum print < /dev/null
    [[ $err == *"filum print part.stl -o part.gcode"* ]]
    for option in connect infill layer-height; do
        expect 2 filum print part.stl --$option -o part.gcode
        [[ $err == *"'--$option' without a value"*"'-o' is an option"* ]]
    done
    expect 0 filum print part.stl --place -2.5,3 --dry-run # a number is a value
}
