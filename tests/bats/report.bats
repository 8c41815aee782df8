#!/usr/bin/env bats
# Reports: what the page holds, and, where Chromium is, what it shows and does.
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    make_inputs
    boxes towers.stl 0,0,0,12,12,4 30,0,0,42,12,4
    filum print towers.stl --keep kept --report towers.html -o towers.gcode
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "a report is made of every kind of stream, alone and whole, the same each time" {
    for s in Layers Regions Paths Toolpath Surface; do
        render $s -o $s.html
        render $s -o again.html
        cmp $s.html again.html
        [[ $(head -n 1 $s.html) == '<!doctype html>' && $(tail -n 1 $s.html) == '</html>' ]]
        run -1 grep -q 'src="\|href="\|@import\|url(' <(sed 's/<script>/\n&/g' $s.html | grep -v 'threejs.org')
    done
    run -1 grep -q "$BATS_FILE_TMPDIR" Toolpath.html towers.html
}

@test "a name that holds HTML is text of the page" {
    render --title '<!--<script></title></script>&' Toolpath -o hostile.html
    [[ $(grep -oi '<!--\|<script\|</script\|</title' hostile.html | sort | uniq -c) == \
        "$(grep -oi '<!--\|<script\|</script\|</title' Toolpath.html | sort | uniq -c)" ]]
    # A browser reads the data up to the next </script and parses it.
    python3 -c 'import json, re, sys
text = open("hostile.html", encoding="utf-8").read()
data = re.search(r"<script type=\"application/json\">(.*?)</script", text, re.S)[1]
assert json.loads(data)["name"] == "<!--<script></title></script>&"'
}

@test "options of reports and of pictures are not mistaken for each other" {
    expect 2 render Toolpath --figures none.tsv -o x.png
    complaint render
    expect 2 render Toolpath --machine klipper -o x.png
    expect 0 render Toolpath --size 99,99 -o x.html
    [[ $err == *"--size has no effect"* ]]
    printf 'a\tb\n1\t2\n' > wrong.tsv
    expect 3 render Toolpath --figures wrong.tsv -o x.html
    complaint render
    expect 5 render Toolpath --beside none -o x.html
    expect 2 filum print part.stl --report report.txt -o x.gcode
    head -c 400 Toolpath > cut
    rm -f x.html
    expect 4 render cut -o x.html
    [[ ! -e x.html ]]
}

@test "the page shows the part, and its controls do what they say" {
    command -v chromium > /dev/null && command -v chromedriver > /dev/null || skip "no chromium with chromedriver"
    geodesic disc.off --source boundary --spacing 2 -o disc.surface
    surfpath geo-contour disc.surface --spacing 1 2> /dev/null | render --surface disc.surface -o surface.html
    render kept/5-link3d.toolpath --beside <(ingest -q towers.gcode) -o beside.html
    python3 "$FILUM_SOURCE/tests/report/drive.py" towers.html beside.html surface.html
}
