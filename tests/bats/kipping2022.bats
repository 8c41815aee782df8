#!/usr/bin/env bats
# The paper's paths on surfaces, from the outside.
# shellcheck disable=SC2154

load common

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    # a plate of 24 x 16 mm in cells of 2 mm
    python3 -c '
w, h = 12, 8
print("OFF"); print((w + 1) * (h + 1), 2 * w * h, 0)
for j in range(h + 1):
    for i in range(w + 1): print(2 * i, 2 * j, 0)
for j in range(h):
    for i in range(w):
        a = j * (w + 1) + i
        print(3, a, a + 1, a + w + 2); print(3, a, a + w + 2, a + w + 1)' > plate.off
}

source_of() {
    case $1 in
        fina | fexa) echo plane:1,0,0,12.5 ;;
        ortheo) echo plane:0,1,0,0 ;;
        geo-spiral) echo point:12,8,0 ;;
        *) echo boundary ;;
    esac
}
baseline() { surfpath-kipping2022 "$@"; }
facts() { peek "$1" | sed -n 's/^fact *surfpath-kipping2022: //p'; }

@test "all six algorithms lay a path, the same bytes with any number of threads" {
    for a in fina fexa ortheo geo-fiso geo-contour geo-spiral; do
        geodesic plate.off --source "$(source_of $a)" > s
        baseline $a s --threads 1 > one
        surfpath-kipping2022 --algorithm $a --threads 8 < s > eight
        cmp <(peek --text one | grep -v threads) <(peek --text eight | grep -v threads)
        cmp one eight
        peek one | grep -qx 'payload       Toolpath'
        facts one | grep -qx 'resample 0.25 mm'
        facts one | grep -qx 'savgol-window 5 points'
        metrics --surface s one | grep -q 'coverage'
    done
}

@test "rows: how many, how long" {
    geodesic plate.off --source plane:1,0,0,12.5 > s
    baseline fina s > t
    facts t | grep -qx 'pieces 23' # 12 on one side, 11 on the other
    metrics --surface s --format tsv t | awk -F '\t' '
        $1 == "chains" && $2 != 1 || $1 == "fibre_mm" && ($2 < 385 || $2 > 392) { print; bad = 1 } END { exit bad }'
}

@test "the paper's own distances go through" {
    geodesic plate.off --source boundary --method heat --paper > s
    for a in geo-fiso geo-contour; do baseline $a s > t; done
    facts t | grep -q '^spirals '
}

@test "a plane may be named, and then fexa needs no distances" {
    geodesic plate.off > s
    baseline fexa s --plane 1,0,0,12.5 > t
    facts t | grep -qx 'pieces 23'
    expect 3 baseline fina s --plane 1,0,0,12.5
    complaint surfpath-kipping2022
    [[ $err == *'run geodesic --source plane'* ]]
    expect 2 baseline fexa s --plane 0,0,0,1
    complaint surfpath-kipping2022
    expect 2 baseline fexa s --plane 1,0,0,99
    complaint surfpath-kipping2022
}

@test "what the paper leaves open can be set, and is in the history" {
    geodesic plate.off --source boundary > s
    baseline geo-fiso s --resample 0.5 --savgol-window 7 --savgol-degree 3 --t-dist 1.5 --n-thresh 3 > t
    for f in 'resample 0.5 mm' 'savgol-window 7 points' 'savgol-degree 3' 't-dist 1.5 mm' 'n-thresh 3 points'; do
        facts t | grep -qx "$f"
    done
    peek t | grep -q 'savgol-window = 7'
    geodesic plate.off --source plane:0,1,0,0 > s
    baseline ortheo s --d-iso 0.5 --min-spacing 0.3 > t
    facts t | grep -qx 'd-iso 0.5 mm'
    facts t | grep -qx 'least-spacing 0.3 mm'
}

@test "impossible parameters are wrong command lines" {
    geodesic plate.off --source boundary > s
    for o in '--spacing 0' '--spacing -1' '--spacing nan' '--spacing 1e9' '--spacing 1e-9' '--savgol-window 4' \
        '--savgol-window 0' '--savgol-window 3 --savgol-degree 3' '--resample -1' '--resample nan' '--t-dist -1' \
        '--n-thresh -1' '--plane 1,2,3' '--lift -1' '--resample 1e-9' '--resample 1e9'; do
        # shellcheck disable=SC2086
        expect 2 baseline geo-fiso s $o
        complaint surfpath-kipping2022
    done
}

@test "the wrong input, and none" {
    geodesic plate.off > s
    expect 3 baseline geo-fiso s
    complaint surfpath-kipping2022
    geodesic plate.off --source vertex:0 > s
    expect 2 baseline geo-fiso s
    expect 3 baseline ortheo s
    expect 2 baseline fina s
    expect 3 baseline geo-fiso plate.off
    complaint surfpath-kipping2022
    box_stl > part.stl
    slice part.stl > layers
    expect 3 baseline geo-fiso layers
    complaint surfpath-kipping2022
    geodesic part.stl --source vertex:0 > closed
    expect 3 baseline geo-contour closed
    [[ $err == *'closed surface'* ]]
    expect 0 baseline geo-spiral closed
}

@test "what no distance reaches is said" {
    geodesic plate.off --source boundary > /dev/null
    sed '2s/.*/120 193 0/; 119a 50 0 0\n60 0 0\n50 10 0' plate.off > two.off
    echo '3 117 118 119' >> two.off
    geodesic two.off --source plane:1,0,0,12.5 > s
    expect 0 baseline fina s -o t
    [[ $err == *'no distance reaches 1 component of the surface, so no path covers 50 mm2'* ]]
}
