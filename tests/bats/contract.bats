#!/usr/bin/env bats
# What every command promises, run for every command there is: a new one is covered by being there.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    ask_all
    make_inputs
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

# Where only sound input is tried, programs with sanitizers do what the unit tests did with them.
sound_only() { [[ -z ${FILUM_SANITIZED:-} ]] || skip "the same programs as without sanitizers"; }

@test "--help and --version go to standard output and end with 0" {
    sound_only
    for c in filum $(stages); do
        expect 0 "$c" --help
        [[ $out == "$c - "* && -z $err ]] || { echo "$c: $out $err"; false; }
        expect 0 "$c" --version
        [[ $out =~ ^$c\ \(filum\)\ [0-9] && -z $err ]] || { echo "$c: $out $err"; false; }
    done
}

@test "the self-description is complete" {
    sound_only
    for c in slice regions sequence fill link3d postproc peek; do [[ " "$(stages | tr '\n' ' ') == *" $c "* ]]; done
    for c in filum $(stages); do
        [[ -n $(fact "$c" synopsis) && -n $(fact "$c" in) && -n $(fact "$c" out) && -n $(fact "$c" example) ]] ||
            { echo "$c"; "$c" --print-contract; false; }
        "$c" --print-man | grep -q '^.SH DESCRIPTION'
    done
}

@test "the lists of commands that the other tests go through are not empty" {
    [[ $(stages | wc -l) -ge 20 && $(readers | wc -l) -ge 18 && $(stream_readers | wc -l) -ge 15 ]] ||
        { stages | wc -l; readers | wc -l; stream_readers | wc -l; false; }
}

@test "an unknown option ends with 2 and is named" {
    for c in filum $(stages); do
        expect 2 "$c" --no-such-option < /dev/null
        complaint "$c"
        [[ -z $out && $err == *--no-such-option* ]] || { echo "$c: $err"; false; }
    done
}

@test "a missing file ends with 5 and is named" {
    for c in $(readers); do
        expect 5 "$c" no-such-file
        complaint "$c"
        [[ -z $out && $err == *no-such-file* ]] || { echo "$c: $err"; false; }
    done
}

@test "an empty file name ends with 2" {
    for c in $(readers); do
        expect 2 "$c" ''
        expect 2 "$c" "$(input_of "$c")" --output ''
    done
}

@test "empty standard input ends with 4 for streams, 3 or 4 for foreign files" {
    for c in $(readers); do
        if [[ $(fact "$c" in) == file ]]; then expect '3|4' "$c" < /dev/null; else expect 4 "$c" < /dev/null; fi
        complaint "$c"
    done
}

@test "what is no stream, or another payload, ends with 3" {
    for c in $(stream_readers); do
        expect 3 "$c" < part.stl
        complaint "$c"
        for payload in Layers Regions Paths Toolpath Surface; do
            in=$(fact "$c" in)
            [[ $in == "stream $payload" || $in == 'stream unknown' ]] && continue
            expect 3 "$c" < $payload
            complaint "$c"
            [[ $err == *"$payload"* ]] || { echo "$c: $err"; false; }
        done
    done
}

@test "a stream cut at a frame border or inside a frame ends with 4, and no file appears" {
    for c in $(stream_readers); do
        in=$(input_of "$c")
        size=$(stat -c %s "$in")
        borders=$(peek --frames "$in" | cut -d ' ' -f 1 | awk 'NR <= 3 || NR % 4 == 0' | head -n 6)
        places=(7 15 16 $borders $((size - 9)) $((size - 1)))
        [[ -z ${FILUM_SANITIZED:-} ]] || places=(16 "${borders%%$'\n'*}" $((size - 9))) # these take five times as long
        for at in "${places[@]}"; do
            for cut in "$at" $((at + 3)); do
                [[ $cut -lt $size ]] || continue
                head -c "$cut" "$in" > cut.stream
                expect 4 "$c" cut.stream --output result
                complaint "$c"
                [[ ! -e result ]] && ! compgen -G './*.part*' > /dev/null || { echo "$c left a file"; ls; false; }
            done
        done
    done
}

@test "a flipped byte ends with 3 or 4" {
    for c in $(stream_readers); do
        in=$(input_of "$c")
        size=$(stat -c %s "$in")
        places=(0 5 12 15 17 19 25 $((size / 3)) $((size / 2)) $((size * 3 / 4)) $((size - 14)) $((size - 8)) $((size - 1)))
        [[ -z ${FILUM_SANITIZED:-} ]] || places=(12 19 $((size / 3)) $((size * 3 / 4)) $((size - 8)))
        for at in "${places[@]}"; do
            cp "$in" flipped.stream
            flip flipped.stream "$at"
            expect '3|4' "$c" flipped.stream --output result
            complaint "$c"
            [[ ! -e result ]] || { echo "$c wrote a result, byte $at"; false; }
        done
    done
}

@test "something behind the end frame ends with 3" {
    for c in $(stream_readers); do
        cat "$(input_of "$c")" part.stl > long.stream
        expect 3 "$c" long.stream --output result
        [[ ! -e result ]]
    done
}

# told_of COMMAND: options in calm, with which nothing is told of the disc of make_inputs: it has no room for wide turns.
told_of() {
    calm=()
    [[ $1 != surfpath ]] || calm=(--min-radius 0)
    [[ $1 != @(laminate|surfpath-kipping2022) ]] || calm=(--quiet) # bare and doubled places, besides
}

@test "success is quiet, and a file or standard input give the same bytes for 1, 2 and 8 threads" {
    sound_only
    for c in $(readers); do
        in=$(input_of "$c")
        told_of "$c"
        expect 0 "$c" "$in" "${calm[@]}" --threads 1 --output one
        [[ -z $err && -z $out ]] || { echo "$c: $err"; false; }
        for threads in 2 8; do
            "$c" "${calm[@]}" --threads $threads < "$in" > other
            cmp one other || { echo "$c with $threads threads"; false; }
        done
        rm -f one other
    done
}

@test "binary is neither written to a terminal nor read from one" {
    sound_only
    command -v script > /dev/null || skip "no script(1)"
    for c in $(stages); do
        if [[ $(fact "$c" out) == stream* ]]; then
            code=0
            script -qec "$c $(input_of "$c")" /dev/null > tty.out < /dev/null || code=$?
            [[ $code == 2 && $(cat tty.out) == *terminal* ]] || { echo "$c: $code"; false; }
        fi
        if [[ $(fact "$c" in) == stream* ]]; then
            code=0
            script -qec "$c --output result" /dev/null > tty.out < /dev/null || code=$?
            [[ $code == 2 && $(cat tty.out) == *terminal* ]] || { echo "$c: $code"; false; }
        fi
    done
}

@test "a full disk ends with 5" {
    [[ -w /dev/full ]] || skip "no /dev/full"
    for c in $(readers); do
        expect_full() { "$@" > /dev/full; }
        [[ $c == peek ]] && continue # its --check writes nothing; below
        [[ -n ${FILUM_SANITIZED:-} && $c == @(choose|laminate) ]] && continue # take a minute, and write as surfpath does
        expect 5 expect_full "$c" "$(input_of "$c")"
        complaint "$c"
        [[ -n ${FILUM_SANITIZED:-} ]] || expect 5 "$c" "$(input_of "$c")" --output /dev/full
    done
    expect 5 expect_full peek Layers
}

@test "an output in a missing folder ends with 5 and is named" {
    sound_only
    for c in $(readers); do
        expect 5 "$c" "$(input_of "$c")" --output no/such/folder
        complaint "$c"
        [[ $err == *no/such/folder* ]] || { echo "$c: $err"; false; }
    done
}

@test "a named output replaces an old file only when it is whole" {
    for c in $(stream_readers); do
        echo old > kept
        head -c 100 "$(input_of "$c")" > cut.stream
        expect 4 "$c" cut.stream --output kept
        [[ $(cat kept) == old ]]
        expect 0 "$c" "$(input_of "$c")" --output kept
        [[ $(head -c 3 kept | tr -d '\0') != old ]]
    done
}

@test "a reader that leaves ends a command quietly" {
    sound_only
    for c in $(readers); do
        told_of "$c"
        "$c" "${calm[@]}" "$(input_of "$c")" 2> err | head -c 10 > /dev/null || true
        [[ ! -s err ]] || { echo "$c: $(cat err)"; false; }
    done
}

@test "the history holds no path, and equal work gives equal bytes elsewhere" {
    sound_only
    mkdir -p elsewhere
    for c in $(readers); do
        [[ $(fact "$c" out) == stream* ]] || continue
        cp "$(input_of "$c")" elsewhere/renamed
        "$c" "$(input_of "$c")" > here
        (cd elsewhere && "$c" renamed > there)
        cmp here elsewhere/there
        if grep -aq "$PWD\|renamed" elsewhere/there; then echo "$c"; false; fi
    done
}

@test "every example of every command runs as it stands" {
    sound_only
    for c in filum $(stages); do
        while IFS= read -r example; do
            mkdir -p example
            cp part.stl example/
            if ! (cd example && timeout 60 bash -c "set -o pipefail; $example" > ../example.out 2> ../example.err); then
                echo "$c: $example"
                cat example.err
                false
            fi
            rm -r example
        done < <("$c" --print-contract | sed -n 's/^example //p')
    done
}
