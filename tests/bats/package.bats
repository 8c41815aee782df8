#!/usr/bin/env bats
# scripts/package: what is in the packages, and that they run; in a clean Debian where FILUM_CLEAN_TREE names one (a root
# folder, as `mmdebstrap --variant=minbase bookworm DIR` makes it).
# shellcheck disable=SC2154

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    for tool in cpack dpkg-deb dpkg-shlibdeps; do command -v $tool > /dev/null || skip "no $tool"; done
    box_stl > part.stl
    "$FILUM_SOURCE/scripts/package" --out "$PWD" > said 2>&1 || { cat said && exit 1; }
    for package in filum_*.deb python3-filum_*.deb; do dpkg-deb -x $package tree; done
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "the packages hold programs, pages, messages and the Python package" {
    for file in bin/filum libexec/filum/slice share/man/man1/filum.1 share/man/man1/filum-slice.1 share/doc/filum/LICENSE \
        share/bash-completion/completions/filum share/filum/proto/filum/stream.proto share/filum/profiles/marlin.toml \
        lib/python3/dist-packages/filum/stream_pb2.py lib/python3/dist-packages/filum/__init__.py; do
        [ -s "tree/usr/$file" ] || { echo "missing: $file" && return 1; }
    done
    dpkg-deb -f filum_*.deb Depends | grep -q libtbb
    dpkg-deb -f python3-filum_*.deb Depends | grep -q python3-numpy
    [ "$(dpkg-deb -f python3-filum_*.deb Architecture)" = all ]
    run -1 grep -rlI "$FILUM_SOURCE" tree/usr
}

@test "unpacked, they print, from the shell and from Python" {
    env -i PATH=/usr/bin:/bin tree/usr/bin/filum print part.stl -o part.gcode
    [ "$(grep -c '^G1 ' part.gcode)" -gt 20 ]
    /usr/bin/python3 -c 'import numpy, google.protobuf' 2> /dev/null || skip "no python3-numpy, python3-protobuf"
    env -i PATH="$PWD/tree/usr/bin:/usr/bin:/bin" PYTHONPATH=tree/usr/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1 \
        /usr/bin/python3 -c 'import filum; print(filum.slice("part.stl").regions().sequence().fill().link3d().gcode(), end="")' > python.gcode
    cmp part.gcode python.gcode
}

@test "the tarball holds what git does, and nothing else" {
    command -v git > /dev/null || skip "no git"
    git -c safe.directory='*' -C "$FILUM_SOURCE" rev-parse > /dev/null 2>&1 || skip "no git tree"
    tar -tf filum-*.tar.xz | grep -v '/$' | sed 's|^[^/]*/||' | sort > packed
    git -c safe.directory='*' -C "$FILUM_SOURCE" ls-files | sort > tracked
    [ -z "$(comm -13 packed tracked)" ] || { comm -13 packed tracked | head -n 5 && return 1; }
    # what is in the tree and not in git, and no leftover either, may be work under way
    comm -23 packed tracked > besides
    while read -r file; do git -c safe.directory='*' -C "$FILUM_SOURCE" check-ignore -q "$file" && echo "$file" && return 1; done < besides
    tar -xf filum-*.tar.xz
    cmake -S filum-*/ -B from-tarball -G Ninja -DFILUM_TESTS=OFF > log 2>&1 || { tail -n 5 log && return 1; }
}

@test "a clean Debian installs them and prints the demo part" {
    [ -n "$FILUM_CLEAN_TREE" ] || skip "FILUM_CLEAN_TREE names no clean tree"
    "$FILUM_SOURCE/scripts/package" --out "$PWD/again" --check "$FILUM_CLEAN_TREE"
}
