#!/usr/bin/env bats
# What cmake --install puts where, and that it runs from there.  Needs FILUM_BUILD and, for the pages, FILUM_SOURCE:
# ctest sets them; by hand they are guessed from the PATH.
# shellcheck disable=SC2154

load common

setup_file() {
    export FILUM_BUILD=${FILUM_BUILD:-$(dirname "$(commands_folder)")}
    export FILUM_SOURCE=${FILUM_SOURCE:-$(cd "$BATS_TEST_DIRNAME/../.." && pwd)}
    [[ -f $FILUM_BUILD/CMakeCache.txt ]] || skip "these commands are in no build tree"
    prefix=$BATS_FILE_TMPDIR/usr
    cmake --install "$FILUM_BUILD" --prefix "$prefix" > "$BATS_FILE_TMPDIR/log"
    mkdir "$BATS_FILE_TMPDIR/contracts"
    box_stl > "$BATS_FILE_TMPDIR/part.stl"
}

setup() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    prefix=$BATS_FILE_TMPDIR/usr
}

@test "filum alone is in bin, the stages in libexec/filum" {
    [[ $(ls "$prefix/bin") == filum ]]
    for c in slice regions sequence fill link3d postproc peek; do [[ -x $prefix/libexec/filum/$c ]]; done
    [[ ! -e $prefix/libexec/filum/filum ]]
}

@test "the installed chain runs with nothing of the build tree on the PATH" {
    env -i PATH=/usr/bin:/bin "$prefix/bin/filum" print part.stl -o part.gcode
    filum print part.stl | cmp - part.gcode
    # shellcheck disable=SC2016
    env -i HOME=/ PATH=/usr/bin:/bin bash -c 'set -euo pipefail; eval "$("$1" env)"
        slice part.stl | regions | sequence | fill | link3d | postproc | cmp - part.gcode
        [[ $MANPATH == *share/man:* ]]' - "$prefix/bin/filum"
}

@test "every command has a manual page without faults" {
    for c in slice regions sequence fill link3d postproc peek; do [[ -s $prefix/share/man/man1/filum-$c.1 ]]; done
    [[ -s $prefix/share/man/man1/filum.1 ]]
    command -v man > /dev/null || skip "no man"
    for page in "$prefix"/share/man/man1/*; do
        out=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 > /dev/null)
        [[ -z $out ]] || { echo "$page: $out"; false; }
    done
}

@test "completion knows stages, options and choices" {
    # shellcheck disable=SC1091
    . "$prefix/share/bash-completion/completions/filum"
    complete_line() {
        COMP_WORDS=("$@")
        COMP_CWORD=$(($# - 1))
        _filum
        echo " ${COMPREPLY[*]} "
    }
    [[ $(complete_line filum sl) == ' slice ' ]]
    [[ $(complete_line filum slice --layer-h) == *' --layer-height '* ]]
    [[ $(complete_line slice --layer-h) == *' --layer-height '* ]]
    [[ $(complete_line filum fill --pattern sp) == *' spiral'* ]]
    [[ $(complete_line filum print --bead-w) == ' --bead-width ' ]]
    [[ $(complete_line filum print part) == ' part.'* ]]
}

@test "docs/commands is what the commands say" {
    "$FILUM_SOURCE/scripts/generate-docs" --check "$FILUM_BUILD"
}

@test "a hidden file beside the programs, such as the loader of the portable package, is no stage" {
    mkdir -p hidden
    cp "$(command -v filum)" "$(command -v peek)" hidden
    printf '#!/bin/sh\nexit 9\n' > hidden/.loader
    chmod +x hidden/.loader
    hidden/filum list > list
    grep -q peek list
    run ! grep -q loader list
}
