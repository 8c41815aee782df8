#!/usr/bin/env bats
# Meshes, projects and stresses as other programs write them, each with its right value: a few of each kind.
# tests/parts/strange-meshes and its neighbours try any number of them.

load common

@test "strange meshes have their area, volume, rims and numbers" {
    for kind in polygons seams ids text boxes; do
        "$FILUM_SOURCE/tests/parts/strange-meshes" "$kind" 0 5
    done
    "$FILUM_SOURCE/tests/parts/strange-meshes" needles 3 4
}

@test "projects of slicers have the volume of their plate without the negative bodies" {
    "$FILUM_SOURCE/tests/parts/strange-projects" negative 0 9
    "$FILUM_SOURCE/tests/parts/strange-projects" negative 48 48 # looped forever
    "$FILUM_SOURCE/tests/parts/strange-projects" plates 0 9
}

@test "a field of stresses comes back from every form in which it is written" {
    "$FILUM_SOURCE/tests/parts/strange-stresses" 0 23
}

@test "settings of slicers are used as they are meant, or named, in every form in which they come" {
    "$FILUM_SOURCE/tests/parts/strange-settings" 0 11
}

@test "streams as another program may send them are used as they are meant, or refused" {
    local python
    for python in python3 /usr/bin/python3; do # Debian's knows protobuf
        "$python" -c 'import google.protobuf, numpy' 2> /dev/null && break
        python=
    done
    [[ -n $python ]] || skip "no python3-protobuf, python3-numpy"
    for kind in loops crossings numbers spacings texts; do
        "$python" "$FILUM_SOURCE/tests/parts/strange-streams" "$kind" 0 5
    done
}
