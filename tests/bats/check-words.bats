# scripts/check-words must find each kind of phrase where text is prose, and nowhere else.

setup() {
    mkdir -p "$BATS_TEST_TMPDIR"/scripts "$BATS_TEST_TMPDIR"/docs
    cd "$BATS_TEST_TMPDIR"
    cp "$BATS_TEST_DIRNAME"/../../scripts/check-words scripts/
    echo 'docs  # all pages' >scripts/plain-english.txt
    printf '# A page\n\nA bead covers the wall.\n' >docs/page.md
}

# The check fails, and says $1.
finds() {
    run scripts/check-words
    echo "$output"
    [ "$status" -eq 1 ]
    [[ "$output" == *"$1"* ]]
}

@test "the finished pages and folders of this tree pass" {
    run "$BATS_TEST_DIRNAME"/../../scripts/check-words
    echo "$output"
    [ "$status" -eq 0 ]
}

@test "a clean page passes" {
    run scripts/check-words
    [ "$status" -eq 0 ]
    [[ "$output" == *'1 files, no findings'* ]]
}

@test "a path that is not there: exit 2" {
    run scripts/check-words docs/none.md
    [ "$status" -eq 2 ]
}

@test "every phrase in a page, also across two lines" {
    for phrase in whence whoever 'nobody knows' 'but for' 'lies bare' 'laid twice' 'is told' likewise 'of which' \
        whatever nor 'by trial' 'what turns is reported'; do
        printf 'One line.\nThe path %s it.\n' "$phrase" >docs/page.md
        finds "docs/page.md:2: '$phrase'"
    done
    printf 'The path lies\nbare here.\n' >docs/page.md
    finds "docs/page.md:1: 'lies bare'"
}

@test "code in a page is not prose" {
    printf 'Run `whatever`, or [this](likewise.md):\n\n    nor this\n\n```\nwhence\n```\n' >docs/page.md
    run scripts/check-words
    [ "$status" -eq 0 ]
}

@test "comments and texts of a source, not its code" {
    printf '// A wall is\n// laid twice.\nint nor = 1;\n' >docs/a.cpp
    finds "docs/a.cpp:2: 'laid twice'"
    printf 'int nor = 1;\nchar c = %s;\n' "'\"'" >docs/a.cpp
    run scripts/check-words
    [ "$status" -eq 0 ]
    printf 'auto text = "the path is "\n            "told";\n' >docs/a.cpp
    finds "docs/a.cpp:1: 'is told'"
    printf 'f("the path is", "told");\n' >docs/a.cpp
    run scripts/check-words
    [ "$status" -eq 0 ]
}

@test "long sentences of a page" {
    command -v style >/dev/null || skip "no diction"
    printf 'This sentence has %s words and ends here.\n' "$(yes many | head -n 20 | tr '\n' ' ')" >docs/page.md
    finds 'words a sentence, more than 16'
}
