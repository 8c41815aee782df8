#!/usr/bin/env bats
# metrics from the outside: figures of a box, the three formats, faults.

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR"
    flat_box_stl > part.stl
    slice part.stl | regions > part.regions
    sequence part.regions | fill > part.paths
    link3d part.paths > part.toolpath
}

setup() { cd "$BATS_FILE_TMPDIR"; }

value() { # of the figure named $1 in the TSV on standard input
    awk -F'\t' -v name="$1" '$1 == name { print $2 }'
}

@test "a box is told by its figures" {
    metrics --regions part.regions --format tsv part.toolpath > m.tsv
    [ "$(value regions < m.tsv)" -eq 5 ]
    [ "$(value crossings < m.tsv)" -eq 0 ]
    [ "$(value area_mm2 < m.tsv)" = 1000.00 ]
    awk -v c="$(value coverage < m.tsv)" 'BEGIN { exit !(c > 0.95 && c <= 1) }'
    # what is extruded is what the material says
    awk -v v="$(value volume_mm3 < m.tsv)" -v m="$(value material < m.tsv)" 'BEGIN { d = v - m * 1000 * 0.2; exit !(d * d < 4) }'
}

@test "the three formats agree" {
    metrics --regions part.regions part.toolpath > m.txt
    metrics --regions part.regions --format tsv part.toolpath > m.tsv
    metrics --regions part.regions --format json part.toolpath > m.json
    local lines
    lines=$(($(wc -l < m.tsv) - 1))
    [ "$(grep -c '^  ' m.txt)" -eq $((lines - 2)) ] # report and version are for programs
    [ "$(grep -c '^  "' m.json)" -eq "$lines" ]
    local strokes
    strokes=$(value strokes < m.tsv)
    grep -q "^  strokes  *$strokes\$" m.txt
    grep -q "\"strokes\": $strokes" m.json
    run grep -i -E 'nan|inf' m.json
    [ "$status" -eq 1 ]
}

@test "the curves of a fill have the same coverage as far as they go" {
    metrics --regions part.regions --format tsv part.paths > p.tsv
    metrics --regions part.regions --format tsv part.toolpath > t.tsv
    awk -v a="$(value coverage < p.tsv)" -v b="$(value coverage < t.tsv)" 'BEGIN { exit !((a - b) ^ 2 < 0.1 ^ 2) }'
    [ -z "$(value strokes < p.tsv)" ]
}

@test "tables have a line per region and per layer" {
    metrics --regions part.regions --per-region r.tsv --per-layer l.tsv part.toolpath > m.txt
    [ "$(wc -l < r.tsv)" -eq 6 ]
    [ "$(wc -l < l.tsv)" -eq 6 ]
    [ "$(awk -F'\t' '{ print NF }' r.tsv | sort -u | wc -l)" -eq 1 ]
}

@test "a finer raster tells the same" {
    metrics --regions part.regions --format tsv --pixel 0.005 part.toolpath > fine.tsv
    metrics --regions part.regions --format tsv part.toolpath > m.tsv
    awk -v a="$(value coverage < fine.tsv)" -v b="$(value coverage < m.tsv)" 'BEGIN { exit !((a - b) ^ 2 < 1e-6) }'
}

@test "threads change nothing" {
    for t in 1 2 8; do metrics --threads $t --regions part.regions part.toolpath > m$t.txt 2> m.err; [ ! -s m.err ]; done
    cmp m1.txt m2.txt
    cmp m1.txt m8.txt
}

@test "a slower machine takes longer" {
    local fast slow
    fast=$(metrics --format tsv part.toolpath | value print_time_s)
    slow=$(metrics --format tsv --set feeds.bead=10 part.toolpath | value print_time_s)
    awk -v f="$fast" -v s="$slow" 'BEGIN { exit !(s > 2 * f) }'
}

@test "what cannot be measured is refused" {
    run metrics part.regions
    [ "$status" -eq 3 ]
    [[ "$output" == *"carries Regions, not Toolpath or Paths"* ]]
    run metrics --regions part.paths part.toolpath
    [ "$status" -eq 3 ]
    run metrics --regions nowhere part.toolpath
    [ "$status" -eq 5 ]
    [[ "$output" == *"'nowhere'"* ]]
    head -c 400 part.toolpath > cut
    run metrics cut
    [ "$status" -eq 4 ]
    run metrics --pixel -1 part.toolpath
    [ "$status" -eq 2 ]
    run metrics --machine no-such part.toolpath
    [ "$status" -eq 2 ]
}

@test "no table is left where the toolpath is cut short" {
    head -c 400 part.toolpath > cut
    run metrics --regions part.regions --per-region none.tsv cut -o none.txt
    [ "$status" -eq 4 ]
    [ ! -e none.tsv ]
    [ ! -e none.txt ]
}

@test "every key is documented with its unit, and told once" {
    metrics --regions part.regions --format tsv part.toolpath > m.tsv
    [ "$(value report < m.tsv)" = metrics ]
    [ "$(value version < m.tsv)" = 1 ]
    [ "$(cut -f1 m.tsv | sort | uniq -d | wc -l)" -eq 0 ]
    metrics --print-keys | sed -nE 's/^\| `([^`]+)` \| ([^|]*) \|.*/\1\t\2/p' | sed 's/ $//' > keys
    while IFS=$'\t' read -r key _ unit; do
        case $key in key | report | version | said.* | noted.*) continue ;; esac
        [[ $key =~ ^[a-z0-9_.]+$ ]]
        general=$(sed -E 's/^(direction_share|width_share)\..*/\1.*/; s/^(tool)\.[0-9]+/\1.*/' <<< "$key")
        grep -qxF "$general"$'\t'"$unit" keys || { echo "not documented: $key, unit '$unit'" && return 1; }
    done < m.tsv
}
