#!/usr/bin/env bats
# The examples in the pages of docs/algorithms, run as they stand.  FILUM_PAGES=all runs those of every page (minutes);
# without it, those of a few quick pages.

load common

setup() {
    source_tree=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    cd "$BATS_TEST_TMPDIR" || exit 1
    for link in examples tests; do ln -s "$source_tree/$link" $link; done
}

# The indented commands of page $1, without comments and without code inside lists.
examples() {
    awk '/^```/ { fenced = !fenced } !fenced && /^    [^ ]/ && (blank || code) { code = 1; print substr($0, 5) }
         { blank = ($0 == "") } !/^    [^ ]/ { code = 0 }' "$1" | sed -E 's/ +# .*$//'
}

@test "examples of the algorithms' pages run" {
    local pages="plate regions geodesic rings" page line count=0
    [ "${FILUM_PAGES:-}" != all ] || pages=$(cd "$source_tree/docs/algorithms" && ls -- *.md | sed 's/\.md$//')
    for page in $pages; do
        while IFS= read -r line; do
            echo "$page: $line"
            bash -euo pipefail -c "$line" > out 2> err < /dev/null || { head -n 5 err; return 1; }
            count=$((count + 1))
        done < <(examples "$source_tree/docs/algorithms/$page.md")
    done
    [ "$count" -ge 8 ]
}
