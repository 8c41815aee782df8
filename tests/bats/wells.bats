#!/usr/bin/env bats
# Parts in grids and in the wells of plates: where they stand, and that no travel meets a wall.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    boxes disc.stl 3,4,0,9,10,1
    boxes tall.stl 0,0,0,3,3,5
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

# walls PROGRAM HEIGHT COLUMNS ROWS PITCH RADIUS: reads a program by itself, from its first move on.  Prints the number of
# wells in which something is laid and the least height above the walls at which the nozzle is between wells.
walls() {
    "$FILUM_SOURCE/tests/bodies/read-wells" "$@"
}

@test "a part in each well of a plate, no travel less than 2 mm above the walls, the first included" {
    for plate in "12 4 3 26.01 11 17.53" "24 6 4 19.3 8 17.4" "6 3 2 39.12 17 17.4"; do
        read -r wells columns rows pitch radius depth <<< "$plate"
        filum print disc.stl --wells "$wells" --machine syringe -q -o plate.gcode
        read -r used clear where <<< "$(walls plate.gcode "$depth" "$columns" "$rows" "$pitch" "$radius")"
        echo "$wells wells: $used used, $clear mm above the walls, $where"
        [[ $used == "$wells" && $where == inside ]]
        python3 -c "assert $clear >= 2 - 1e-6"
    done
}

@test "some wells by name; walls of another height; small parts in 96 wells" {
    filum print disc.stl --wells 12 --in-wells a1,B3 --wall-height 30 --machine syringe -q -o some.gcode
    read -r used clear where <<< "$(walls some.gcode 30 4 3 26.01 11)"
    [[ $used == 2 && $where == inside ]]
    python3 -c "assert $clear >= 2 - 1e-6"
    slice disc.stl --wells 12 --in-wells A1,B3 -q | peek --text > told
    grep -q 'object disc_A1 ' told
    grep -q 'object disc_B3 ' told
    filum print tall.stl --scale 1,1,0.2 --wells 96 --machine syringe -q -o small.gcode
    read -r used clear where <<< "$(walls small.gcode 10.67 12 8 9 3.4)"
    [[ $used == 96 && $where == inside ]]
    python3 -c "assert $clear >= 2 - 1e-6"
}

@test "A1 is at the back on the left; the middle of the part's box is over that of its place" {
    slice disc.stl --grid 3x2 --pitch 20,30 --center 0,0 -q | peek --text | grep ' object ' > told
    [[ $(wc -l < told) == 6 ]]
    slice disc.stl --grid 3x2 --pitch 20,30 --center 0,0 --in-wells A1 -q | regions -q | peek --text > one
    [[ $(< one) == *"-23"* ]] # from -23 to -17, and from 12 to 18
    slice disc.stl tall.stl --grid 2x1 --pitch 20 -q | peek --text > two
    grep -q 'object disc_A1 ' two
    grep -q 'object tall_A2 ' two
}

@test "grids that cannot be are refused" {
    expect 2 slice disc.stl --wells 13
    complaint slice
    expect 2 slice disc.stl --wells 12 --in-wells D1
    complaint slice
    expect 2 slice disc.stl --grid 4x3
    complaint slice
    expect 2 slice disc.stl --grid 4 --pitch 20
    complaint slice
    expect 2 slice disc.stl --grid 4x3 --pitch 20 --copies 2
    complaint slice
    expect 2 slice disc.stl tall.stl --grid 4x3 --pitch 20
    complaint slice
    expect 2 slice disc.stl --in-wells A1
    complaint slice
    expect 3 slice disc.stl --grid 4x3 --pitch 5
    complaint slice
    run filum print disc.stl --wells 12 --wall-height 200 --machine syringe -o high.gcode
    [[ $status == 2 && $output == *"reaches up to 150 mm"* && ! -e high.gcode ]]
}

@test "scaffolds by pore size, plungers by bore, nozzles by diameter" {
    boxes block.stl 0,0,0,20,20,1
    filum print block.stl --pattern scaffold --pore-size 0.5 --machine syringe --diameter 12.45 -q -o pores.gcode
    filum print block.stl --pattern scaffold --spacing 0.9 --machine syringe --set extrusion.diameter=12.45 -q -o spaced.gcode
    same() { grep -E '^G[01] ' "$1" | cksum; }
    [[ $(same pores.gcode) == "$(same spaced.gcode)" ]]
    expect 2 filum print block.stl --pattern scaffold --pore-size 0.5 --spacing 0.9 -o no.gcode
    expect 2 filum print block.stl --machine bio-x --diameter 12 -o no.gcode
    [[ $(filum print block.stl --nozzle 0.6 --dry-run) == *"fill --bead-width=0.6"*"--nozzle=0.6"* ]]
    [[ $(filum print block.stl --nozzle 0.6 --bead-width 0.7 --dry-run) == *"fill --bead-width=0.7"* ]]
    for machine in marlin klipper bio-x syringe cellink-inkredible clay linuxcnc; do
        filum print block.stl --machine $machine --nozzle 0.8 -q -o nozzle.gcode
    done
    run filum print block.stl --machine syringe --nozzle 0.2 --bead-width 0.9 --layer-height 0.5 -q -o no.gcode
    [[ $status == 1 && $output == *"above the 0.16 mm2"* && ! -e no.gcode ]]
}
