#!/usr/bin/env bats
# A parameter study by make and by Slurm.  scripts/sweep-check does the whole of it; here are four small jobs.

load common

setup() {
    top=$BATS_TEST_DIRNAME/../..
    sweep=$top/examples/sweep
    cd "$BATS_TEST_TMPDIR"
}

# A table of four jobs that take long enough to be killed.
small_table() {
    printf 'axis\tname\tvalue\toptions\n'
    printf 'part\tbracket\tbracket\t--layer-height 0.5\npart\tbar\tbar\t\n'
    printf 'pattern\tspiral\tfill --pattern spiral\t\nwidth\t0.6\t\t\nwidth\t0.8\t\t\n'
}

has_slurm() { PATH=$PATH:/usr/sbin command -v slurmctld slurmd munged srun > /dev/null; }

# make_sweep ARGUMENTS: into ./out, with the commands under test; $jobs are those that were done.  Fails where make fails.
make_sweep() {
    make -C "$top" -f Makefile.examples sweep BIN="$(commands_folder)" OUT="$PWD/out" "$@" > log 2>&1 || local failed=$?
    jobs=$(grep -c '^examples/sweep/job ' log || true)
    return "${failed:-0}"
}

@test "sweep: a killed job leaves no result; it is redone, the rest not" {
    small_table > small.tsv
    run "$top/scripts/sweep-check" --no-slurm --victim bracket/spiral/0.6 SWEEP="$PWD/small.tsv" BIN="$(commands_folder)"
    echo "$output"
    [ "$status" -eq 0 ]
    [[ $output == "make: 4 jobs in "* ]]
}

@test "sweep: on a one-node Slurm the same, byte for byte" {
    has_slurm || skip "Slurm is not installed (Debian: slurm-wlm munge)"
    [ -z "${FILUM_SANITIZED:-}" ] || skip "the same programs as without sanitizers"
    small_table > small.tsv
    run "$top/scripts/sweep-check" --victim bracket/spiral/0.6 SWEEP="$PWD/small.tsv" BIN="$(commands_folder)"
    echo "$output"
    [ "$status" -eq 0 ]
    [[ $output == *"slurm: 4 jobs in "*"identical: "* ]]
}

@test "sweep: only what a change of the table concerns is done again" {
    disc 15 > disc.off
    printf 'axis\tname\tvalue\toptions\npart\tbar\tbar\t--layer-height 0.5\npattern\tspiral\tfill\t\nwidth\t0.8\t\t\n' > t.tsv
    make_sweep SWEEP="$PWD/t.tsv"
    [ "$jobs" -eq 1 ]
    printf 'pattern\tzigzag\tfill --pattern zigzag\t\nwidth\t1\t\t\n' >> t.tsv
    make_sweep SWEEP="$PWD/t.tsv"
    [ "$jobs" -eq 3 ]
    sed -i 's/fill --pattern zigzag/fill --pattern zigzag --angles 0,90/' t.tsv
    make_sweep SWEEP="$PWD/t.tsv"
    [ "$jobs" -eq 2 ]
    make_sweep SWEEP="$PWD/t.tsv"
    [ "$jobs" -eq 0 ]
    [ "$(wc -l < out/sweep/table.tsv)" -eq 5 ]
    # a part by its file, a pattern of fill, one width: the table is of these
    cp "$top/examples/bar/bar.stl" mine.stl
    make_sweep SWEEP="$PWD/t.tsv" PARTS="$PWD/mine.stl bar" PATTERNS=contour WIDTHS=1
    [ "$jobs" -eq 2 ]
    [ "$(wc -l < out/sweep/table.tsv)" -eq 3 ]
    # a candidate on a surface
    printf 'axis\tname\tvalue\toptions\npart\tdisc\t%s\t\npattern\trings\tsurfpath geo-fiso\t--source boundary\nwidth\t2\t\t\n' \
        "$PWD/disc.off" > s.tsv
    make_sweep SWEEP="$PWD/s.tsv"
    [ "$jobs" -eq 1 ]
    awk -F '\t' 'NR == 2 { exit !($1 == "disc" && $4 == 1 && $6 > 0.9) }' out/sweep/table.tsv
}

@test "sweep: a job that fails says so, leaves nothing, and keeps none of the others from it" {
    printf 'axis\tname\tvalue\toptions\npart\tbar\tbar\t\npattern\tspiral\tfill\t\n' > t.tsv
    printf 'pattern\twrong\tfill --pattern swirl\t\nwidth\t0.8\t\t\n' >> t.tsv
    run ! make_sweep SWEEP="$PWD/t.tsv" --keep-going
    [ -e out/sweep/bar/spiral/0.8.tsv ]
    [ -z "$(find out/sweep/bar/wrong -type f)" ]
    grep -q 'swirl' log
    run ! make_sweep SWEEP="$PWD/t.tsv" PARTS=nowhere.stl
    grep -q "no mesh 'nowhere.stl'" log
    run "$sweep/job" one two
    [ "$status" -eq 2 ]
    printf 'pattern\tx\tpour\t\n' > odd
    : > part
    run "$sweep/job" part odd "$top/examples/bar/bar.stl" 0.4 odd-stem
    [ "$status" -eq 2 ]
    [[ $output == *"'pour'"* ]]
    ls odd-stem* && false
    run "$sweep/table" . bar spiral 0.4 t.out
    [ "$status" -eq 5 ]
}

@test "slurm-node: wrong arguments; no Slurm; the code of the command; nothing left after a signal" {
    run "$top/scripts/slurm-node"
    [ "$status" -eq 2 ]
    run "$top/scripts/slurm-node" --cpus none true
    [ "$status" -eq 2 ]
    has_slurm || skip "Slurm is not installed (Debian: slurm-wlm munge)"
    run "$top/scripts/slurm-node" --cpus 2 bash -c 'echo "$SLURM_CONF"; srun -n1 bash -c "exit 7"'
    [ "$status" -eq 7 ]
    conf=$(head -n 1 <<< "$output")
    [[ $conf == *slurm.conf ]]
    [ ! -e "$(dirname "$conf")" ]
    "$top/scripts/slurm-node" bash -c 'echo "$SLURM_CONF" > conf; srun -n1 sleep 60' 3>&- &
    node=$!
    for _ in {1..200}; do [ -s conf ] || sleep 0.1; done
    kill "$node"
    wait "$node" && false
    [ ! -e "$(dirname "$(cat conf)")" ]
    run -1 pgrep -f "$(dirname "$(cat conf)")"
}

@test "sweep: any option is an axis, and columns are called as the keys of metrics" {
    printf 'axis\tname\tvalue\toptions\npart\tbar\tbar\t--layer-height 1\npattern\tzigzag\tfill --pattern zigzag\t\nwidth\t1\t\t\n' > t.tsv
    printf 'angles\t0\t\t\nangles\t0,90\t\t\nmax-overhang\t1\t\t\n' > wrong
    printf 'angles\t0\t\t\nangles\t30,90\t\t\n' >> t.tsv
    make_sweep SWEEP="$PWD/t.tsv"
    [ "$jobs" -eq 2 ]
    head -n 1 out/sweep/table.tsv | grep -q "^part.pattern.angles.width.strokes.stops.coverage.overfill.crossings.extruded_mm.print_time_s$"
    awk -F '\t' 'NR > 1 { print $3 }' out/sweep/table.tsv | grep -qx '30,90'
    run cmp -s "out/sweep/bar/zigzag@angles=0/1.toolpath" "out/sweep/bar/zigzag@angles=30,90/1.toolpath"
    [ "$status" -eq 1 ]
    cat wrong >> t.tsv
    run make_sweep SWEEP="$PWD/t.tsv"
    [ "$status" -ne 0 ]
    grep -q "has the option '--max-overhang'" log
}
