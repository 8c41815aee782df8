#!/usr/bin/env bats
# What peek shows.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    ask_all
    make_inputs
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "the layers of a box, as text" {
    slice part.stl --layer-height 0.5 | peek --text > got
    [[ $(grep -c '^layer ' got) == 2 && $(grep -c '^  loop ' got) == 2 ]]
    [[ $(grep '^layer ' got | head -n 1) == 'layer index 0 z 0.5 height 0.5 plane 0.25 body 0 tool 0 width 0 layers 0 skipped 0 contours 1' ]]
    grep '^    [-0-9]' got | awk '!(($1 == 0 || $1 == 9) && $2 >= 0 && $2 <= 9 || ($2 == 0 || $2 == 9) && $1 >= 0 && $1 <= 9) { exit 1 }'
}

@test "the summary counts and measures" {
    expect 0 peek Regions
    [[ $out =~ payload\ +Regions ]]
    [[ $out =~ region\ +5 ]]
    [[ $out =~ area\ +405\ mm2 ]]
    [[ $out =~ z\ +0.2\ to\ 1\ mm ]]
}

@test "the history tells programs, parents and settings" {
    slice part.stl --layer-height 0.3 | regions | peek > got
    grep -q '^run 0  *slice [0-9.]*$' got
    grep -q '^ *layer-height = 0.3  (not the default)$' got
    grep -q '^run 1  *regions [0-9.]* after 0$' got
}

@test "--json is JSON with the same counts" {
    command -v jq > /dev/null || skip "no jq"
    for s in Layers Regions Paths Toolpath Surface; do
        frames=$(peek --frames $s | wc -l)
        [[ $(peek --json $s | jq '.frames | length') == "$frames" ]]
        [[ $(peek --json $s | jq -r .header.payload) == "$s" ]]
    done
    [[ $(peek --json Regions | jq '[.frames[].area] | add') == 405 ]]
}

@test "--script makes the same stream again" {
    slice part.stl --layer-height 0.5 | regions --bead-width 0.5 | sequence | fill > want
    peek --script want > remake
    grep -q -- '--layer-height=0.5' remake
    bash remake part.stl | cmp - want
    [[ $(grep -c -- '--bead-width' remake) == 1 ]] # fill has its default
    peek --script --defaults want > remake
    bash remake part.stl | cmp - want
    [[ $(grep -c -- '--bead-width' remake) == 2 ]]
}

@test "--check is quiet and tells by the exit code" {
    for s in Layers Regions Paths Toolpath Surface; do
        expect 0 peek --check $s
        [[ -z $out && -z $err ]]
    done
    head -c 200 Paths > short
    expect 4 peek --check short
    expect 3 peek --check part.stl
    expect 5 peek --check nowhere
}

@test "of a cut stream it shows what comes before the cut" {
    size=$(stat -c %s Layers)
    head -c $((size - 5)) Layers > short
    expect 4 peek --text short
    [[ $(grep -c '^layer ' <<< "$out") == 5 ]]
}

@test "--frames gives the offset of every frame" {
    last=0
    while read -r offset kind; do
        [[ $offset -gt $last && $kind == layer ]]
        last=$offset
        head -c "$offset" Layers > short
        expect 4 peek --check short
        [[ $err == *'before its end frame'* ]]
    done < <(peek --frames Layers)
    [[ $last -gt 0 ]]
}

@test "two views at once end with 2" {
    expect 2 peek --text --json Layers
    complaint peek
    expect 2 peek --decimals 12 Layers
}
