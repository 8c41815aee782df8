#!/usr/bin/env bats
# The format as it stands in docs/stream.md, seen from outside.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    ask_all
    make_inputs
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "every stream begins with the same 15 bytes" {
    for s in Layers Regions Paths Toolpath Surface; do
        [[ $(head -c 15 $s | od -An -tx1 | tr -d ' \n') == 0e09008946696c756d0a1501000000 ]]
    done
}

@test "an unknown version is refused and named" {
    cp Layers future
    printf '\2' | dd of=future bs=1 seek=11 conv=notrunc status=none
    expect 3 regions future
    complaint regions
    [[ $err == *version* ]]
}

@test "two streams in one file are refused" {
    cat Layers Layers > two
    expect 3 peek --check two
    [[ $err == *'follows its end frame'* ]]
}

@test "a stage left out is guessed" {
    expect 3 fill Layers
    [[ $err == *"Layers, not Regions; run 'regions | sequence' on it first"* ]]
}

@test "a frame longer than it is costs no memory" {
    [ -z "${FILUM_SANITIZED:-}" ] || skip "AddressSanitizer reserves more address space than the limit here"
    (head -c 15 Layers; printf '\377\377\377\37\12\377\377\377\37') > long
    expect '3|4' bash -c 'ulimit -v 4000000; peek --check long'
    (head -c 15 Layers; printf '\377\377\377\377\377\377\377\377\377\177') > long
    expect 3 peek --check long
    [[ $err == *malformed* || $err == *'64 MiB'* ]]
}

@test "every byte flipped of a small stream is noticed" {
    size=$(stat -c %s Layers)
    [[ $size -lt 3000 ]]
    for ((at = 0; at < size; at += 7)); do
        cp Layers flipped
        flip flipped "$at"
        expect '3|4' peek --check flipped
    done
}
