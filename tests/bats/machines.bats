#!/usr/bin/env bats
# Machines of one's own: copied from a profile, checked.
# shellcheck disable=SC2154

load common

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    boxes disc.stl 3,4,0,9,10,1
}

@test "a machine that states what differs from another one" {
    filum machines --new mine.toml --base ender3
    [[ $(wc -l < mine.toml) -lt 20 ]]
    printf '[values]\nnozzle_temp = 199\n' >> mine.toml
    filum print disc.stl --machine ./mine.toml -q -o mine.gcode
    filum print disc.stl --machine ender3 --temperature 199 -q -o theirs.gcode
    grep -q 'M104 S199\|M109 S199' mine.gcode
    cmp <(grep '^G1' mine.gcode) <(grep '^G1' theirs.gcode)
    mkdir sub
    printf 'name = "far"\nbase = "../mine.toml"\n' > sub/far.toml
    filum print disc.stl --machine sub/far.toml -q -o far.gcode
    cmp <(grep '^[GM]' mine.gcode) <(grep '^[GM]' far.gcode)
    printf 'name = "loop"\nbase = "loop.toml"\n' > loop.toml
    run filum print disc.stl --machine ./loop.toml -o no.gcode
    [[ $status == 3 && $output == *"is its own base"* ]]
    printf 'name = "lost"\nbase = "nosuch"\n' > lost.toml
    run filum print disc.stl --machine ./lost.toml -o no.gcode
    [[ $status == 2 && $output == *"unknown machine 'nosuch'"* ]]
    expect 2 filum machines --new other.toml --base ender3 --from ender3
}

@test "a machine of one's own: copied, checked" {
    filum machines --new mine.toml --from clay > said
    [[ $(< said) == *"filum machines --check mine.toml"* ]]
    grep -q '^name = "mine"' mine.toml
    filum machines --check mine.toml | grep -q 'nothing wrong or surprising'
    # places to measure are named until their remark is gone
    filum machines --new pair.toml --from marlin-dual > /dev/null
    run filum machines --check pair.toml
    [[ $status -eq 1 && $output == *"tool.1.mount is a placeholder"* ]]
    sed -i 's/ *# placeholder.*//' pair.toml
    filum machines --check pair.toml | grep -q 'nothing wrong or surprising'
    filum print disc.stl --machine ./mine.toml --nozzle 1 --layer-height 0.5 -q -o mine.gcode
    expect 2 filum machines --new mine.toml --from clay
    expect 2 filum machines --new other.toml
    expect 2 filum machines --new other.toml --from nosuch
    expect 2 filum machines --chek mine.toml
    sed 's/^G28$/M109 S210/; s/^nozzle = .*//; s/^section = .*//; s/^retract = .*/retract = 0/' mine.toml > hot.toml
    run filum machines --check hot.toml
    [[ $status == 1 && $output == *"M109 heats, and the material is cold"* && $output == *"extrusion.nozzle is missing"* &&
        $output == *"homes nothing"* ]]
    echo 'nonsense = 1' >> hot.toml
    expect 3 filum machines --check hot.toml
    names=$(filum machines | cut -d ' ' -f 1)
    [[ $(wc -w <<< "$names") -ge 10 ]]
    for name in $names; do
        run filum machines --check "$name"
        [[ $status -le 1 ]]
    done
}
