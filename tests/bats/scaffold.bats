#!/usr/bin/env bats
# Porous scaffolds through the whole chain: strokes and stops of the program, pores of the toolpath, wrong options.

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR"
    export FILUM_SOURCE=${FILUM_SOURCE:-$(cd "$BATS_TEST_DIRNAME/../.." && pwd)}
    make_part=$FILUM_SOURCE/examples/scaffold/make-part
    $make_part block 20 20 2 block.stl
    $make_part disc 10 2 disc.stl
    $make_part ring 14 6 2 ring.stl
    $make_part ell 16 14 5 2 ell.stl
    for part in block disc ring ell; do slice $part.stl | regions > $part.regions; done
}

setup() { cd "$BATS_FILE_TMPDIR"; }

value() { awk -F'\t' -v name="$1" '$1 == name { print $2; exit }' m.tsv; }

# strokes and stops of a program
unbroken() { "$FILUM_SOURCE/scripts/gcode-strokes" "$1" | awk -F'\t' 'NR == 2 { print $2, $3 }'; }

@test "a block is one stroke of known porosity, windows and throats" {
    filum print block.stl --machine marlin --pattern scaffold --spacing 1 -o block.gcode
    [ "$(unbroken block.gcode)" = "1 0" ]
    sequence block.regions | fill --pattern scaffold --spacing 1 | link3d | metrics --pores --regions block.regions --format tsv > m.tsv
    [ "$(value strokes)" -eq 1 ]
    [ "$(value stops)" -eq 0 ]
    [ "$(value crossings)" -eq 0 ]
    [ "$(value strands)" -eq 200 ]
    [ "$(value openings_through)" -eq 361 ]
    awk -v p="$(value porosity_volume)" -v s="$(value pore_mm)" -v t="$(value throat_lateral_mm)" \
        'BEGIN { exit !(p > 0.594 && p < 0.606 && s > 0.597 && s < 0.603 && t == 0.2) }'
}

@test "discs, tubes and notches, with and without rings, in any sequence of angles: one stroke" {
    for part in block disc ring ell; do
        for angles in 0,90 0,60,120 30; do
            for rings in 0 1; do
                sequence $part.regions | fill -q --pattern scaffold --spacing 1.1 --angles $angles --rings $rings |
                    link3d | metrics --regions $part.regions --format tsv > m.tsv
                echo "$part $angles $rings: $(value strokes) strokes, $(value crossings) crossings"
                [ "$(value strokes)" -eq 1 ]
                [ "$(value stops)" -eq 0 ]
                [ "$(value crossings)" -eq 0 ]
            done
        done
    done
}

@test "pores have the size asked for, from 0.3 to 0.8 mm, in a block and in a disc" {
    for part in block disc; do
        for size in 0.3 0.55 0.8; do
            sequence $part.regions | fill -q --pattern scaffold --pore-size $size | link3d |
                metrics --pores --regions $part.regions --format tsv > m.tsv
            echo "$part $size: $(value pore_mm)"
            [ "$(value strokes)" -eq 1 ]
            awk -v p="$(value pore_mm)" -v s="$size" 'BEGIN { exit !(p > 0.97 * s && p < 1.03 * s) }'
        done
    done
}

@test "pores that change along z have at each height the size asked for there, in one stroke" {
    $FILUM_SOURCE/examples/scaffold/make-part block 20 20 4 high.stl
    slice -q high.stl | regions -q > high.regions
    sequence high.regions | fill -q --pattern scaffold --pore-size 0.3@0,0.8@4 | link3d |
        metrics --pores --regions high.regions --per-layer layers.tsv --format tsv > m.tsv
    [ "$(value strokes)" -eq 1 ]
    # column 13 is the spacing, column 10 the strands; layer n is at z = (n + 1) / 5
    awk -F'\t' 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "spacing_mm") c = i; next }
        { want = 0.4 + 0.3 + 0.5 * ($1 + 1) / 20; if ($c < want - 0.002 || $c > want + 0.002) exit 1 }' layers.tsv
    sequence high.regions | fill -q --pattern scaffold --porosity 40@0,70@4 | link3d |
        metrics --pores --regions high.regions --format tsv > m.tsv
    awk -v p="$(value porosity_volume)" 'BEGIN { exit !(p > 0.535 && p < 0.565) }' # 55 % in the middle
    for wrong in 40,80 40@3,80@1 40@ 0.5@0,80@4; do
        expect 2 fill --pattern scaffold --porosity "$wrong" high.regions
    done
}

@test "pores by a formula of the place have in each zone the size asked for there, in one stroke" {
    $FILUM_SOURCE/examples/scaffold/make-part block 20 20 1.6 low.stl
    slice -q low.stl | regions -q > low.regions
    for formula in "0.55 + 0.025 * x" "0.3 + 0.05 * r" "0.5 + 0.02 * (x + y)" "0.5 + 0.1 * sin(x / 3)" "0.4 + 0.2 * z"; do
        sequence -q low.regions | fill -q --pattern scaffold --pore-size "$formula" | link3d -q -o low.toolpath
        metrics --pores --per-pore pores.tsv --regions low.regions --format tsv low.toolpath > m.tsv
        echo "$formula: $(value strokes) $(value crossings)"
        [[ $(value strokes) -eq 1 && $(value crossings) -eq 0 ]]
        [[ $formula == *z* ]] && continue
        "$FILUM_SOURCE/tests/bodies/pores-by-zone" pores.tsv "$formula" 10 10 > zones.tsv
        cat zones.tsv
        awk '$1 == "worst" && $2 > 0.03 { exit 1 }' zones.tsv
    done
    for wrong in "0.5 - 0.1 * r" "0.5 * q" "(x" "max(0.01, 0.05 + 50 * (x + 10))"; do
        expect 2 fill --pattern scaffold --pore-size "$wrong" low.regions
    done
}

@test "the porosity of small discs is the one asked for" {
    for d in 8 14; do
        $FILUM_SOURCE/examples/scaffold/make-part disc $d 2 small.stl
        slice -q small.stl | regions -q > small.regions
        for p in 50 60 75; do
            sequence -q small.regions | fill -q --pattern scaffold --porosity $p | link3d -q |
                metrics --pores --regions small.regions --format tsv > m.tsv
            echo "$d $p: $(value porosity_volume)"
            awk -v got="$(value porosity_volume)" -v p=$p 'BEGIN { exit !(got > p / 100 - 0.02 && got < p / 100 + 0.02) }'
        done
    done
}

@test "curved scaffolds take no more strokes than planned" {
    for scale in 1,1,1 1.3,0.8,0.6; do
        "$FILUM_SOURCE/tests/bodies/make-bodies" ear ear
        slice -q --scale $scale ear/a.stl | regions -q > ear.regions
        for spacing in 0.9 1; do
            sequence --report ear.regions 2> ear.report | fill -q --pattern scaffold --spacing $spacing | link3d |
                metrics --format tsv > m.tsv
            echo "$scale $spacing: $(value strokes) strokes"
            [ "$(value strokes)" -eq "$(awk '/lower-bound/ { print $3 }' ear.report)" ]
        done
    done
}

@test "bioprinters get it without a stop" {
    for machine in bio-x syringe; do
        filum print disc.stl -q --machine $machine --pattern scaffold --spacing 1.2 -o $machine.gcode
        [ "$(unbroken $machine.gcode)" = "1 0" ]
    done
    filum print disc.stl -q --machine cellink-inkredible --pattern scaffold --spacing 1.2 -o cellink.gcode
    [ "$(grep -c '^M760' cellink.gcode)" -eq 1 ] # pressure on once
}

@test "wrong options are usage errors that say what to do" {
    for wrong in "--spacing 0.39" "--spacing -1" "--spacing nan" "--spacing 1e9" "--stagger 1.5" "--bead-width 2 --spacing 1.9" "--angles 0,x"; do
        run --separate-stderr fill --pattern scaffold $wrong block.regions
        echo "$wrong: $status $stderr"
        [ "$status" -eq 2 ]
        [ -n "$stderr" ]
        [ -z "$output" ]
    done
    run --separate-stderr metrics --pores /dev/null
    [ "$status" -eq 2 ]
    [[ "$stderr" == *"--regions"* ]]
}

@test "the layer table tells the pores of each layer" {
    sequence block.regions | fill --pattern scaffold --spacing 1 | link3d > block.toolpath
    metrics --pores --regions block.regions --per-layer layers.tsv block.toolpath > m.txt
    [ "$(awk -F'\t' 'NR > 1 && $10 == 20 && $13 == 1 && $15 == 361' layers.tsv | wc -l)" -eq 10 ]
    metrics --regions block.regions --per-layer plain.tsv block.toolpath > m.txt
    [ "$(cut -f1-9 layers.tsv | cmp - plain.tsv; echo $?)" -eq 0 ]
}

@test "the same bytes for any number of threads" {
    for threads in 1 8; do
        sequence ring.regions | fill -q --threads $threads --pattern scaffold --rings 1 > $threads.paths
        link3d $threads.paths | metrics --threads $threads --pores --regions ring.regions > $threads.txt
    done
    cmp 1.paths 8.paths
    cmp 1.txt 8.txt
}
