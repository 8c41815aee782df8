#!/usr/bin/env bats
# What is left behind when a stage dies, the disk is full, or the user gives up.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    ask_all
    make_inputs
    postproc Toolpath > whole.gcode
}

setup() {
    mkdir -p "$BATS_TEST_TMPDIR/work"
    cd "$BATS_TEST_TMPDIR/work" || exit 1
    in=$BATS_FILE_TMPDIR
}

teardown() {
    local pid
    for pid in $(jobs -p); do kill -9 "$pid" 2> /dev/null || true; done
}

# kill_halfway STAGE INPUT OUTPUT: feeds half the input, and kills the stage while it waits for the rest.
kill_halfway() {
    rm -f gate
    mkfifo gate
    "$1" < gate > "$3" 3>&- &
    local victim=$!
    exec 9> gate
    head -c $(($(stat -c %s "$2") / 2)) "$2" >&9
    sleep 0.1
    kill -9 "$victim"
    exec 9>&-
    wait "$victim" 2> /dev/null || true
}

@test "after a stage is killed half-way, no later file passes for whole" {
    chain=(slice regions sequence fill link3d)
    inputs=("$in/part.stl" "$in/Layers" "$in/Regions" "$in/sequenced" "$in/Paths")
    for ((k = 0; k < ${#chain[@]}; ++k)); do
        kill_halfway "${chain[k]}" "${inputs[k]}" "out.$k"
        expect 4 peek --check "out.$k"
        for ((later = k + 1; later < ${#chain[@]}; ++later)); do
            "${chain[later]}" < "out.$((later - 1))" > "out.$later" 2> /dev/null && false
            expect 4 peek --check "out.$later"
        done
        expect 4 postproc "out.$((${#chain[@]} - 1))" --output part.gcode
        [[ ! -e part.gcode ]]
    done
}

@test "machine code whose making was cut short is told from whole" {
    kill_halfway postproc "$in/Toolpath" part.gcode
    [[ $(tail -n 1 part.gcode) != "$(tail -n 1 "$in/whole.gcode")" || ! -s part.gcode ]]
    head -c $(($(stat -c %s "$in/Toolpath") - 5)) "$in/Toolpath" > short
    expect 4 postproc short
    [[ ! -s $BATS_TEST_TMPDIR/out || $(tail -n 1 "$BATS_TEST_TMPDIR/out") != "$(tail -n 1 "$in/whole.gcode")" ]]
}

@test "a stage killed while it writes a named file leaves nothing behind" {
    mkfifo gate
    fill gate --output part.paths 3>&- &
    victim=$!
    exec 9> gate
    head -c $(($(stat -c %s "$in/sequenced") / 2)) "$in/sequenced" >&9
    sleep 0.1
    kill -9 $victim
    exec 9>&-
    wait $victim 2> /dev/null || true
    [[ ! -e part.paths ]]
    [[ -z $(ls ./*.part* 2> /dev/null) ]] || skip "this file system knows no unnamed files"
}

@test "a full disk fails the stage, and leaves no file" {
    mkdir disk
    mount -t tmpfs -o size=16k tmpfs disk 2> /dev/null || skip "cannot mount a small file system"
    code=0
    (cd disk && fill "$in/sequenced" --output part.paths) 2> err || code=$?
    ls disk > left
    (cd disk && head -c 100000 /dev/zero > filler 2> /dev/null) || true
    stdout=0
    fill "$in/sequenced" 2>> err > disk/again || stdout=$?
    umount disk
    [[ $stdout == 5 ]]
    [[ $code == 5 || $(stat -c %s "$in/Paths") -lt 16000 ]]
    [[ $code == 0 || ! -s left ]]
}

@test "filum print: one message, the exit code of the stage that failed, no file" {
    head -c 200 "$in/part.stl" > broken.stl
    expect '3|4' filum print broken.stl -o part.gcode
    complaint slice
    [[ ! -e part.gcode ]]
    expect 5 filum print nowhere.stl -o part.gcode
    complaint slice
    expect 5 filum print "$in/part.stl" -o no/such/part.gcode
    complaint postproc
}

@test "filum print: killing it kills the chain" {
    mkfifo gate
    filum print gate -o part.gcode 3>&- &
    front=$!
    exec 9> gate
    sleep 0.3
    children=$(cat "/proc/$front/task/$front/children" 2> /dev/null) || skip "the kernel does not list children"
    [[ $(wc -w <<< "$children") -eq 6 ]]
    kill -9 $front
    wait $front 2> /dev/null || true
    sleep 0.3
    for pid in $children; do
        if [[ -d /proc/$pid && $(cut -d ' ' -f 3 "/proc/$pid/stat") != Z ]]; then
            echo "still there: $(tr '\0' ' ' < "/proc/$pid/cmdline")"
            false
        fi
    done
    exec 9>&-
    [[ ! -e part.gcode ]]
}
