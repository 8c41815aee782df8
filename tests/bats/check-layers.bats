# scripts/check-layers must pass a clean tree and find each kind of breach in a bad one.

setup() {
    check="$BATS_TEST_DIRNAME/../../scripts/check-layers"
    tree="$BATS_TEST_TMPDIR/tree"
    mkdir -p "$tree"/lib/low/base "$tree"/lib/low/geom "$tree"/lib/low/cli "$tree"/cmds "$tree"/docs "$tree"/tests/lib/low/geom
    printf '[low]\nbase:\ngeom: base\ncli: base\n' >"$tree/lib/LAYERS"
    printf '#pragma once\nnamespace filum {\n}\n' >"$tree/lib/low/base/error.hpp"
    printf '#pragma once\n#include "base/error.hpp"\n#include <vector>\nnamespace filum::geom {\n}\n' >"$tree/lib/low/geom/vec.hpp"
    printf '#include "base/error.hpp"\n#include <CLI/CLI.hpp>\nnamespace filum::cli {\n}\n' >"$tree/lib/low/cli/parse.cpp"
    printf '// cut - cuts\n// reads:  a\n// writes: b\n// memory: c\n#include "geom/vec.hpp"\n' >"$tree/cmds/cut.cpp"
    printf '# cut\n\nCuts.\n' >"$tree/cmds/cut.md"
    echo 'Wing `low`: `base`, `geom`, `cli`.' >"$tree/docs/architecture.md"
}

# The check fails, and one finding contains $1.
finds() {
    run "$check" "$tree"
    echo "$output"
    [ "$status" -eq 1 ]
    [[ "$output" == *"$1"* ]]
}

@test "a clean tree passes" {
    run "$check" "$tree"
    echo "$output"
    [ "$status" -eq 0 ]
}

@test "this tree passes" {
    run "$check"
    echo "$output"
    [ "$status" -eq 0 ]
}

@test "no checkout: exit 2" {
    run "$check" "$BATS_TEST_TMPDIR"
    [ "$status" -eq 2 ]
}

@test "a sibling that LAYERS does not allow" {
    printf '#include "geom/vec.hpp"\nnamespace filum::cli {\n}\n' >"$tree/lib/low/cli/more.cpp"
    finds 'lib/low/cli/more.cpp:1: cli includes geom'
}

@test "a test with another kind of name" {
    printf 'TEST(Vec, IsOne) {\n}\n' >"$tree/tests/lib/low/geom/vec.cpp"
    run "$check" "$tree"
    [ "$status" -eq 0 ]
    printf 'TEST(Vec, is_one) {\n}\n' >"$tree/tests/lib/low/geom/vec.cpp"
    finds "tests/lib/low/geom/vec.cpp:1: test 'Vec.is_one'"
    mv "$tree/tests/lib/low/geom/vec.cpp" "$tree/tests/lib/low/geom/vec_test.cpp"
    finds "tests/lib/low/geom/vec_test.cpp: is in tests/lib"
    mkdir "$tree/tests/lib/high"
    mv "$tree/tests/lib/low/geom" "$tree/tests/lib/high/geom"
    finds "tests/lib/high/geom/vec_test.cpp: is beside no room of lib"
}

@test "a room in another wing than its line says" {
    mkdir "$tree/lib/high"
    mv "$tree/lib/low/geom" "$tree/lib/high/geom"
    finds "lib/high/geom: has no line below [high]"
    finds "'geom' has no folder in lib/low"
}

@test "a line that names a folder below it in the file" {
    printf '[low]\nbase: geom\ngeom: base\ncli: base\n' >"$tree/lib/LAYERS"
    finds "lib/LAYERS:2: 'base' names 'geom'"
}

@test "a folder without a line, a line without a folder" {
    printf '[low]\nbase:\ngeom: base\ncli: base\nmesh: base\n' >"$tree/lib/LAYERS"
    finds "'mesh' has no folder"
    mkdir "$tree/lib/low/fill"
    printf 'namespace filum::fill {\n}\n' >"$tree/lib/low/fill/fill.cpp"
    finds 'lib/low/fill: has no line'
}

# Gives the tree two folders within a folder: mesh/step and mesh/text; mesh itself has no sources.
nest() {
    mkdir -p "$tree"/lib/low/mesh/step "$tree"/lib/low/mesh/text
    printf '[low]\nbase:\ngeom: base\nmesh/text: base\nmesh/step: base mesh/text\ncli: base mesh/step\n' >"$tree/lib/LAYERS"
    printf '#pragma once\nnamespace filum::mesh::text {\n}\n' >"$tree/lib/low/mesh/text/text.hpp"
    printf '#include "mesh/text/text.hpp"\nnamespace filum::mesh::step {\n}\n' >"$tree/lib/low/mesh/step/step.cpp"
    echo 'And `mesh/step`, `mesh/text`.' >>"$tree/docs/architecture.md"
}

@test "folders within folders pass" {
    nest
    printf '#include "mesh/step/step.hpp"\nnamespace filum::mesh::step {\nclass A;\n}\nnamespace filum::cli {\n}\n' >"$tree/lib/low/cli/more.cpp"
    printf '#pragma once\nnamespace filum::mesh::step::detail {\n}\n' >"$tree/lib/low/mesh/step/step.hpp"
    run "$check" "$tree"
    echo "$output"
    [ "$status" -eq 0 ]
}

@test "a folder within a folder that LAYERS does not allow" {
    nest
    printf '#include "mesh/step/step.hpp"\nnamespace filum::mesh::text {\n}\n' >"$tree/lib/low/mesh/text/more.cpp"
    printf '#pragma once\nnamespace filum::mesh::step {\n}\n' >"$tree/lib/low/mesh/step/step.hpp"
    finds 'lib/low/mesh/text/more.cpp:1: mesh/text includes mesh/step'
    rm "$tree/lib/low/mesh/text/more.cpp"
    printf '#include "mesh/text/text.hpp"\nnamespace filum::cli {\n}\n' >"$tree/lib/low/cli/more.cpp"
    finds 'lib/low/cli/more.cpp:1: cli includes mesh/text'
}

@test "a folder within a folder without a line" {
    nest
    mkdir "$tree/lib/low/mesh/off"
    printf 'namespace filum::mesh::off {\n}\n' >"$tree/lib/low/mesh/off/off.cpp"
    finds 'lib/low/mesh/off: has no line'
    rm -r "$tree/lib/low/mesh/off"
    printf 'namespace filum::mesh {\n}\n' >"$tree/lib/low/mesh/mesh.cpp"
    finds 'lib/low/mesh: has no line'
}

@test "a line for a folder that has only folders" {
    nest
    sed -i '2a mesh: base' "$tree/lib/LAYERS"
    finds "'mesh' has no folder in lib/low with sources"
}

@test "code of a folder within a folder in another namespace" {
    nest
    printf 'namespace filum::step {\n}\n' >"$tree/lib/low/mesh/step/more.cpp"
    finds 'lib/low/mesh/step/more.cpp:1: has nothing in namespace filum::mesh::step'
    printf 'namespace filum::mesh::step {\n}\nnamespace filum::mesh {\n}\n' >"$tree/lib/low/mesh/step/more.cpp"
    finds 'lib/low/mesh/step/more.cpp:3: opens namespace filum::mesh;'
    printf 'namespace filum::mesh::stepping {\n}\n' >"$tree/lib/low/mesh/step/more.cpp"
    finds 'more.cpp:1: has nothing in namespace filum::mesh::step'
    printf 'namespace filum::mesh::text {\n}\nnamespace filum::mesh::step {\n}\n' >"$tree/lib/low/mesh/text/more.cpp"
    finds 'lib/low/mesh/text/more.cpp:3: opens namespace filum::mesh::step;'
}

@test "an include that is in no wing of lib" {
    printf '#include "error.hpp"\nnamespace filum {\n}\n' >"$tree/lib/low/base/more.cpp"
    finds "more.cpp:1: includes 'error.hpp', which is in no wing of lib/"
}

@test "protobuf outside stream and wire" {
    printf '#include <google/protobuf/message.h>\nnamespace filum::geom {\n}\n' >"$tree/lib/low/geom/more.cpp"
    finds "more.cpp:1: includes protobuf's"
}

@test "generated protobuf code in a command" {
    printf '#include "filum/stream.pb.h"\n' >>"$tree/cmds/cut.cpp"
    finds "cut.cpp:6: includes protobuf's"
}

@test "CLI11 outside cli" {
    printf '#include <CLI/CLI.hpp>\nnamespace filum::geom {\n}\n' >"$tree/lib/low/geom/more.cpp"
    finds "more.cpp:1: includes CLI11's"
}

@test "heavy libraries in a header" {
    for header in CGAL/Polyhedron_3.h embree3/rtcore.h polyclipping/clipper.hpp boost/polygon/voronoi.hpp oneapi/tbb/task_arena.h tbb/tbb.h toml.hpp zip.h pugixml.hpp TopoDS.hxx png.h; do
        printf '#pragma once\n#include <%s>\nnamespace filum::geom {\n}\n' "$header" >"$tree/lib/low/geom/heavy.hpp"
        finds "heavy.hpp:2: a header includes '$header'"
    done
    sed '/pragma/d' "$tree/lib/low/geom/heavy.hpp" >"$tree/lib/low/geom/heavy.cpp"
    rm "$tree/lib/low/geom/heavy.hpp"
    "$check" "$tree"
}

@test "code in another folder's namespace" {
    printf 'namespace filum::geom {\n}\n' >"$tree/lib/low/cli/more.cpp"
    finds 'more.cpp:1: has nothing in namespace filum::cli'
    printf 'namespace filum::cli {\n}\nnamespace filum::geom {\n}\n' >"$tree/lib/low/cli/more.cpp"
    finds 'more.cpp:3: opens namespace filum::geom'
}

@test "using namespace in a header" {
    printf '#pragma once\nusing namespace std;\nnamespace filum::geom {\n}\n' >"$tree/lib/low/geom/more.hpp"
    finds "more.hpp:2: 'using namespace'"
}

@test "a file, a command that is too long" {
    { printf 'namespace filum::geom {\n}\n'; yes '//' | head -398; } >"$tree/lib/low/geom/long.cpp"
    "$check" "$tree"
    echo '//' >>"$tree/lib/low/geom/long.cpp"
    finds 'long.cpp:401: has 401 lines'
    yes '//' | head -166 >>"$tree/cmds/cut.cpp"
    finds 'cut.cpp:171: has 171 lines'
}

@test "a command without its four lines" {
    printf '// cut - cuts\n// reads:  a\n// memory: c\n' >"$tree/cmds/cut.cpp"
    finds "cut.cpp:3: line 3 does not begin with '// writes:'"
}

@test "a command without the page of its help, and one with another title" {
    printf 'Cuts.\n' >"$tree/cmds/cut.md"
    finds "cmds/cut.md:1: does not begin with the title '# cut'"
    rm "$tree/cmds/cut.md"
    finds "cmds/cut.md: is missing"
}

@test "something unknown at the top" {
    echo x >"$tree/notes.txt"
    finds 'notes.txt: does not belong at the top'
}

@test "a path of one machine" {
    for path in work/main root/x home/me Users/me tmp/x; do
        printf 'see %s\n' "/$path" >"$tree/docs/a.md"
        finds "docs/a.md:1: names '/"
    done
    printf 'see ${TMPDIR:-/%s}/x, frame/%s/x and https://example.org/%s/x\n' tmp work work >"$tree/docs/a.md"
    "$check" "$tree"
}

@test "a compiled program" {
    mkdir "$tree/examples"
    printf '\177ELF\0\0' >"$tree/examples/cut"
    finds 'examples/cut: is a compiled program'
}

@test "a link that leads nowhere" {
    printf '[a](b.md) [c](../lib/LAYERS) [d](https://example.org/e)\n' >"$tree/docs/a.md"
    finds "docs/a.md:1: links to 'docs/b.md'"
    echo x >"$tree/docs/b.md"
    "$check" "$tree"
}

@test "a link to a heading that is not there" {
    printf '# One word\n\n## Two: `words`, and [more](a.md)\n\n## One word\n\n```\n# no heading\n```\n' >"$tree/docs/a.md"
    printf '[1](a.md#one-word) [2](a.md#two-words-and-more) [3](a.md#one-word-1) [4](#top)\n# Top\n' >"$tree/docs/b.md"
    run "$check" "$tree"
    echo "$output"
    [ "$status" -eq 0 ]
    echo '[5](a.md#no-heading)' >"$tree/docs/c.md"
    finds "docs/c.md:1: links to 'docs/a.md#no-heading', a heading that is not there"
    echo '[6](#bottom)' >"$tree/docs/c.md"
    finds "docs/c.md:1: links to 'docs/c.md#bottom', a heading that is not there"
}

@test "a picture that no page shows" {
    mkdir "$tree/docs/pictures"
    echo x >"$tree/docs/pictures/a.png"
    echo '![a](pictures/a.png)' >"$tree/docs/a.md"
    run "$check" "$tree"
    echo "$output"
    [ "$status" -eq 0 ]
    echo x >"$tree/docs/pictures/b.png"
    finds 'docs/pictures/b.png: is in no page'
}

@test "a page named in a comment that is not there, or a heading of it" {
    printf '# Why\n' >"$tree/docs/a.md"
    printf '// Right, see docs/a.md#why; as docs/NAME.md.\n#include "base/error.hpp"\nnamespace filum::cli {\n}\n' >"$tree/lib/low/cli/more.cpp"
    run "$check" "$tree"
    echo "$output"
    [ "$status" -eq 0 ]
    sed -i 's/#why/#how/' "$tree/lib/low/cli/more.cpp"
    finds "lib/low/cli/more.cpp:1: links to 'docs/a.md#how', a heading that is not there"
    sed -i 's/a.md#how/b.md/' "$tree/lib/low/cli/more.cpp"
    finds "lib/low/cli/more.cpp:1: links to 'docs/b.md', which is not there"
}

@test "a folder that the page on architecture does not name" {
    nest
    "$check" "$tree"
    sed -i 's/`mesh.step`/`mesh`, step/' "$tree/docs/architecture.md"
    finds 'docs/architecture.md: does not name `mesh/step`'
    rm "$tree/docs/architecture.md"
    finds 'docs/architecture.md: is missing'
}

@test "a page that names what is not in lib" {
    echo 'See `lib/low/geom`, `lib/low/geom/vec.hpp`, `lib/NAME` and `lib/low/geom/NAME`.' >"$tree/docs/a.md"
    "$check" "$tree"
    echo 'See `lib/low/geom/box.hpp`.' >>"$tree/docs/a.md"
    finds "docs/a.md:2: names 'lib/low/geom/box.hpp', which is not there"
}

@test "an assertion of a shell test that cannot fail" {
    mkdir "$tree/tests/bats"
    good='    run ! cmp a b\n    peek a | run ! grep b\n    [ -e a ] || ! grep b c\n    if ! cmp a b; then false; fi\n'
    good+='    cmp a b && false\n    awk "a && b" c\n    [[ a && ! b ]]\n    # ! cmp a b\n    (cd a && cmp b c)\n'
    printf '@test "a" {\n'"$good"'}\n' >"$tree/tests/bats/a.bats"
    run "$check" "$tree"
    echo "$output"
    [ "$status" -eq 0 ]
    for bad in '! cmp a b' 'cmp a b; ! cmp a c' '! peek a | grep b' '[ -e a ] && ! cmp a b'; do
        printf '@test "a" {\n    %s\n    true\n}\n' "$bad" >"$tree/tests/bats/a.bats"
        finds "tests/bats/a.bats:2: an assertion that cannot fail, '! command'"
    done
    printf '@test "a" {\n    [ -e a ] && [ -e b ]\n    true\n}\n' >"$tree/tests/bats/a.bats"
    finds "tests/bats/a.bats:2: an assertion that cannot fail, 'A && B'"
}

@test "a page of an algorithm that names a function of yesterday" {
    mkdir -p "$tree/docs/algorithms"
    echo 'First `geom::parts()`, then `Pot::stir()` and `glue()`.' >"$tree/docs/algorithms/cut.md"
    echo 'int glue() { return parts(1) + stir(); }' >>"$tree/cmds/cut.cpp"
    printf '#pragma once\nnamespace filum::geom {\nstruct Pot {\n    int stir();\n};\nint parts(int n);\n}\n' >"$tree/lib/low/geom/pot.hpp"
    run "$check" "$tree"
    echo "$output"
    [ "$status" -eq 0 ]
    sed -i 's/parts(/pieces(/' "$tree/lib/low/geom/pot.hpp" # `parts` remains as a call in another folder
    finds "docs/algorithms/cut.md:1: names the function 'geom::parts()'"
    sed -i 's/Pot/Kettle/' "$tree/lib/low/geom/pot.hpp"
    finds "docs/algorithms/cut.md:1: names the function 'Pot::stir()'"
    sed -i 's/glue/tie/' "$tree/cmds/cut.cpp"
    finds "docs/algorithms/cut.md:1: names the function 'glue()'"
}
