# scripts/setup with dpkg-query, apt-get and id replaced, so that nothing is installed.

bats_require_minimum_version 1.5.0

setup() {
    script="$BATS_TEST_DIRNAME/../../scripts/setup"
    cd "$BATS_TEST_TMPDIR"
    mkdir stubs
    # All packages are installed but those that the file missing names.
    cat >stubs/dpkg-query <<'END'
#!/bin/sh
for package in "$@"; do :; done
grep -qx "$package" missing && exit 1
printf 'install ok installed'
END
    cat >stubs/apt-get <<'END'
#!/bin/sh
echo "$@" >>calls
grep -q fail missing && echo 'E: no network' && exit 100
exit 0
END
    printf '#!/bin/sh\ncat user\n' >stubs/id
    printf '#!/bin/sh\necho sudo >>calls\nexec "$@"\n' >stubs/sudo
    chmod +x stubs/*
    echo 0 >user
    : >missing
    : >calls
    PATH="$PWD/stubs:$PATH"
}

@test "nothing missing: apt-get is not called" {
    run "$script" --all
    [ "$status" -eq 0 ]
    [ "$output" = "setup: everything is installed" ]
    [ ! -s calls ]
}

@test "only what is missing is installed" {
    printf 'cmake\nbats\nprusa-slicer\n' >missing
    run "$script"
    [ "$status" -eq 0 ]
    [[ "$output" == *"installing cmake"* ]]
    grep -qx 'install -y --no-install-recommends cmake' calls
    run -1 grep -q sudo calls
    run "$script" --test --peers
    grep -qx 'install -y --no-install-recommends bats cmake prusa-slicer' calls
}

@test "a user without root goes through sudo" {
    echo 1000 >user
    echo cmake >missing
    run "$script"
    [ "$status" -eq 0 ]
    grep -qx sudo calls
}

@test "apt-get fails: its words, and exit 1" {
    printf 'cmake\nfail\n' >missing
    run "$script"
    [ "$status" -eq 1 ]
    [[ "$output" == *"E: no network"* ]]
}

@test "--list names what CMake looks for; a wrong option is refused" {
    run "$script" --list
    [ "$status" -eq 0 ]
    for package in g++ cmake ninja-build libprotobuf-dev libembree-dev libpolyclipping-dev; do
        [[ $'\n'"$output"$'\n' == *$'\n'"$package"$'\n'* ]]
    done
    run "$script" --everything
    [ "$status" -eq 2 ]
}
