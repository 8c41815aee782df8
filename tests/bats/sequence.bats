# The stages regions and sequence from the shell: real streams, options, bad input.

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    # two towers of 4 x 4 x 20 mm, 10 mm apart, as a binary STL
    {
        printf '%80s' towers
        printf '\x18\x00\x00\x00' # 24 triangles
        box 0 4
        box 14 18
    } > towers.stl
}

facet() { # nine coordinates
    printf '\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00'
    for v in "$@"; do
        case $v in # as 32-bit floats
        0) printf '\x00\x00\x00\x00' ;;
        4) printf '\x00\x00\x80\x40' ;;
        14) printf '\x00\x00\x60\x41' ;;
        18) printf '\x00\x00\x90\x41' ;;
        20) printf '\x00\x00\xa0\x41' ;;
        esac
    done
    printf '\x00\x00'
}

box() { # lower and upper x
    local a=$1 b=$2
    facet $a 0 0 $b 4 0 $b 0 0
    facet $a 0 0 $a 4 0 $b 4 0
    facet $a 0 20 $b 0 20 $b 4 20
    facet $a 0 20 $b 4 20 $a 4 20
    facet $a 0 0 $b 0 0 $b 0 20
    facet $a 0 0 $b 0 20 $a 0 20
    facet $b 0 0 $b 4 0 $b 4 20
    facet $b 0 0 $b 4 20 $b 0 20
    facet $b 4 0 $a 4 0 $a 4 20
    facet $b 4 0 $a 4 20 $b 4 20
    facet $a 4 0 $a 0 0 $a 0 20
    facet $a 4 0 $a 0 20 $a 4 20
}

strokes() { # options of sequence
    slice towers.stl | regions | sequence "$@" --report 2>&1 > out.regions | sed -n 's/^sequence: planned-strokes //p'
}

@test "two towers: a stroke each without a head, in turns with one, layer by layer on demand" {
    [ "$(strokes --head none)" = 2 ]
    [ "$(strokes)" = 4 ] # 100 layers, the carriage is in the way from 41 layers up: ceil(100 / 41) + 1
    [ "$(strokes --cone-height 4)" = 6 ]
    [ "$(strokes --carriage 18,40)" = 2 ] # the box ends before the neighbour
    [ "$(strokes --gantry-height 30)" = 4 ]
    [ "$(strokes --carriage 0,0 --gantry-height 10)" = 3 ]
    [ "$(strokes --order layers)" = 101 ]
    [ "$(strokes --head marlin --cone-height 4)" = 6 ] # a profile's head, changed
    peek --check out.regions
}

@test "equal work gives equal bytes for any number of threads" {
    slice towers.stl | regions --threads 1 | sequence --threads 1 > one
    slice towers.stl | regions --threads 8 | sequence --threads 8 > eight
    cmp one eight
}

@test "the report tells bounds and causes, --ends every end" {
    slice towers.stl | regions > r
    run sequence r --report --ends ends.tsv -o s
    [ "$status" -eq 0 ]
    for line in 'lower-bound 4' 'gap 0' 'ends-top 2' 'ends-carriage 2' 'ends-cone 0' 'bound-by relaxation-bound'; do
        grep -qx "sequence: $line" <<<"$output"
    done
    [ "$(wc -l < ends.tsv)" -eq 5 ]
    [ "$(cut -f7 ends.tsv | sort | uniq -c | tr -s ' ' | tr '\n' ';')" = ' 2 carriage; 1 cause; 2 top;' ]
    [[ "$(peek s)" == *ends-carriage* ]]
}

@test "a budget is steps or seconds; too little still gives an order" {
    slice towers.stl | regions > r
    sequence r --budget 0 -o none
    peek --check none
    sequence r --budget 600 | peek --text --decimals 3 | grep '^region' > steps
    sequence r --budget 2s | peek --text --decimals 3 | grep '^region' > seconds
    cmp steps seconds
    for wrong in -1 ten 5m 1e9 9999s; do
        run sequence r --budget "$wrong" -o x
        [ "$status" -eq 2 ]
        [[ "$output" == *--budget* ]]
    done
}

@test "a head by name or file, and what is said if there is none such" {
    slice towers.stl | regions > r
    sequence r --head marlin -o s
    cp "$(dirname "$(command -v sequence)")"/../share/filum/profiles/marlin.toml short.toml
    sequence r --head ./short.toml -o t
    cmp <(peek --text s | grep '^region') <(peek --text t | grep '^region')
    run sequence r --head nosuch -o x
    [ "$status" -eq 2 ]
    [[ "$output" == *"'nosuch'"*marlin* ]]
    run sequence r --head ./nosuch.toml -o x
    [ "$status" -eq 5 ]
    [[ "$output" == *"nosuch.toml"* ]]
}

@test "nothing on standard error without need" {
    slice towers.stl > layers
    run regions layers -o r
    [ "$status" -eq 0 ]
    [ -z "$output" ]
    run sequence r -o s
    [ "$status" -eq 0 ]
    [ -z "$output" ]
}

@test "regions in another order are refused" {
    slice towers.stl | regions | sequence > once
    run sequence once -o twice
    [ "$status" -eq 3 ]
    [[ "$output" == *"must come straight from 'regions'"* ]]
    [ ! -e twice ]
}

@test "a cut stream is refused and nothing is committed" {
    slice towers.stl | regions > whole
    head -c 5000 whole > cut
    run sequence cut -o out
    [ "$status" -eq 4 ]
    [ ! -e out ]
}

@test "wrong options are named" {
    slice towers.stl | regions > r
    run sequence --order sideways r
    [ "$status" -eq 2 ]
    [[ "$output" == *"'sideways'"* ]]
    run sequence --carriage 40 r
    [ "$status" -eq 2 ]
    [[ "$output" == *"--carriage"* ]]
    run regions --bead-width 0 layers
    [ "$status" -eq 2 ]
}
