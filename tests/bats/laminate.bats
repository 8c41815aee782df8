#!/usr/bin/env bats
# Plies on each other, from a table to a map.

load common

setup() {
    cd "$BATS_TEST_TMPDIR" || exit 1
    awk 'BEGIN { # a shallow dome of 16 x 16 mm
        n = 16
        printf "OFF\n%d %d 0\n", (n + 1) * (n + 1), 2 * n * n
        for (j = 0; j <= n; j++) for (i = 0; i <= n; i++)
            printf "%d %d %.6f\n", i, j, sqrt(1600 - (i - 8) ^ 2 - (j - 8) ^ 2) - 40
        for (j = 0; j < n; j++) for (i = 0; i < n; i++) {
            a = j * (n + 1) + i
            printf "3 %d %d %d\n3 %d %d %d\n", a, a + 1, a + n + 2, a, a + n + 2, a + n + 1
        }
    }' > dome.off
    geodesic dome.off > dome.surface
}

figure() { awk -F '\t' -v key="$1" '$1 == key { print $2 }' dome.tsv; }

@test "a table of plies becomes one toolpath, a layer per ply, with a map and figures of each" {
    printf '# angle from X\nangle height side\n0 0.3 over\n90 0.3 over\n0 0.2 under\n' > plies.txt
    laminate --table plies.txt --spacing 2 --min-radius 1 --map dome.map dome.surface --output dome.toolpath 2> said
    grep -q 'stack is not symmetric' said
    metrics --surface dome.surface --format tsv dome.toolpath > dome.tsv
    [ "$(figure plies)" = 3 ]
    [ "$(figure said.laminate.thickness_nominal)" = 0.8 ]
    awk -v t="$(figure said.laminate.thickness_mean)" 'BEGIN { exit !(t > 0.68 && t < 0.92) }'
    for k in 1 2 3; do
        awk -v a="$(figure said.laminate.ply.$k.angle_median)" 'BEGIN { exit !(a != "" && a < 0.5) }'
    done
    peek --check dome.map
    peek --text dome.map > text
    for field in thickness thickness-even fibre-volume ply-1.covered ply-3.gap ply-2.deviation; do grep -q "$field" text; done
    render dome.map --output dome.vtp
    grep -q 'Name="ply-3.deviation"' dome.vtp
}

@test "metrics maps the finished toolpath as laminate maps its plan" {
    printf 'angle height side\n0 0.3 over\n60 0.3 over\n0 0.2 under\n' > plies.txt
    laminate --quiet --table plies.txt --spacing 2 --min-radius 1 dome.surface --output dome.toolpath
    metrics --surface dome.surface --map dome.vtp --format tsv dome.toolpath > dome.tsv
    grep -q 'Name="ply-3.deviation"' dome.vtp
    same() { awk -v a="$(figure "$1")" -v b="$(figure "$2")" -v e="$3" 'BEGIN { exit !(a != "" && b != "" && a - b < e && b - a < e) }'; }
    same thickness.points.mean_mm said.laminate.thickness_mean 0.005
    same thickness.even.least_mm said.laminate.even_least 0.03
    for k in 1 2 3; do
        same ply.$k.bare said.laminate.ply.$k.bare 0.005
        same ply.$k.twice said.laminate.ply.$k.twice 0.005
        same ply.$k.off_mean_deg said.laminate.ply.$k.angle_mean 0.5
    done
    # Without the facts of laminate, and nothing on the surface to follow, nothing is told of angles.
    surfpath field --spacing 2 --min-radius 1 dome.surface --quiet > one.toolpath
    metrics --surface dome.surface --map one.map --format tsv one.toolpath > dome.tsv
    [ "$(figure ply.1.bare)" != "" ]
    [ "$(figure ply.1.off_mean_deg)" = "" ]
    peek --check one.map
    expect 2 metrics --map x.map dome.toolpath
}

@test "plies over the surface lie over it, those under it under it" {
    printf 'angle height side\n0 0.5 over\n0 0.5 over\n0 0.5 under\n0 0.5 under\n' > plies.txt
    laminate --table plies.txt --spacing 2 --min-radius 1 dome.surface --output dome.toolpath 2> said
    run -1 grep -q 'stack is not' said
    metrics --surface dome.surface --format tsv dome.toolpath > dome.tsv
    [ "$(figure plies)" = 4 ]
}

@test "wrong tables and lists are refused with what is wrong" {
    printf 'angle side\n0 left\n' > plies.txt
    expect 3 laminate --table plies.txt dome.surface
    [[ $err == *"line 2"*"'over' or 'under'"* ]]
    expect 5 laminate --table none.txt dome.surface
    expect 2 laminate --plies 0,x dome.surface
    expect 2 laminate --plies 0 --reference 0,0,0 dome.surface
}

@test "plies end along curves, and step down by the ramp that is asked" {
    printf '3 3 0\n13 3 0\n13 13 0\n3 13 0\n' > square.txt
    printf 'angle height within\n0 0.2 all\n0 0.2 square.txt\n90 0.2 square.txt\n90 0.2 all\n' > plies.txt
    laminate --table plies.txt --spacing 1 --min-radius 0.5 --ramp 1:10 --map dome.map dome.surface -o dome.toolpath 2> said
    grep -q 'edge-moved' said
    metrics --surface dome.map --map again.map --format tsv dome.toolpath > dome.tsv
    [ "$(figure plies)" = 4 ]
    awk -v a="$(figure said.laminate.ply.2.area)" -v b="$(figure said.laminate.ply.3.area)" \
        'BEGIN { exit !(a > 97 && a < 103 && b > 33 && b < 38) }'
    awk -v a="$(figure ply.2.bare)" -v b="$(figure said.laminate.ply.2.bare)" \
        'BEGIN { exit !(a - b < 0.02 && b - a < 0.02 && a < 0.3) }'
    peek --text again.map | grep -q 'ply-3.edge'
    laminate --quiet --table plies.txt --spacing 1 --min-radius 0.5 dome.surface 2> said | peek > /dev/null
    laminate --plies 0 --ramp 1:20 --spacing 2 dome.surface 2> said > /dev/null
    grep -q 'ramp' said
    expect 2 laminate --plies 0 --ramp 20 dome.surface
    complaint laminate
    printf 'angle within\n0 faces:9\n' > plies.txt
    expect 3 laminate --table plies.txt dome.surface
    complaint laminate
    printf 'angle within\n0 none.txt\n' > plies.txt
    expect 5 laminate --table plies.txt dome.surface
}

@test "turns outside are for machines that allow them" {
    sed 's/^\[limits\].*/[limits]\nturn_outside = 2/' "$FILUM_SOURCE/lib/motion/machine/profiles/linuxcnc-xyzac.toml" > ./mine.toml
    grep -q turn_outside mine.toml || printf '[limits]\nturn_outside = 2\n' >> mine.toml
    laminate --quiet --plies 0,90 --spacing 1 --min-radius 0.5 --turn-outside 3 --trim-list trims.tsv dome.surface -o out.toolpath
    [ "$(head -1 trims.tsv)" = "$(printf 'ply\tstroke\talong\tx\ty\tz')" ]
    [ "$(tail -n +2 trims.tsv | cut -f 1 | sort -u | tr '\n' ' ')" = "0 1 " ]
    expect 2 postproc --machine ./mine.toml out.toolpath
    [[ $err == *"laminate --turn-outside 3"*"limits.turn_outside"* ]]
    expect 2 laminate --plies 0 --turn-outside 3 --machine ./mine.toml dome.surface
    complaint laminate
    expect 2 surfpath field --angle 5 --turn-outside 3 --machine ./mine.toml dome.surface
    complaint surfpath
    surfpath field --quiet --angle 5 --min-radius 0.5 --turn-outside 2 --machine ./mine.toml dome.surface -o out.toolpath
    postproc --machine ./mine.toml out.toolpath > /dev/null
}
