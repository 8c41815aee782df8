#!/usr/bin/env bats
# render from the outside: every stream, PNG and SVG, faults.

load common

setup_file() {
    cd "$BATS_FILE_TMPDIR"
    flat_box_stl > part.stl
    slice part.stl | regions > part.regions
    sequence part.regions | fill > part.paths
    link3d part.paths > part.toolpath
}

setup() { cd "$BATS_FILE_TMPDIR"; }

is_png() { [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ]; }

@test "every stream has a picture" {
    slice part.stl > part.layers
    for s in layers regions paths toolpath; do
        render --size 80,60 part.$s -o $s.png 2> err
        [ ! -s err ]
        is_png $s.png
        render --size 80,60 --layer 2 part.$s > $s.flat.png
        is_png $s.flat.png
        run -1 cmp -s $s.png $s.flat.png
    done
}

@test "every colour and view has its own picture" {
    for c in progress layer width speed class; do render --size 80,60 --color $c part.toolpath -o c-$c.png; done
    for v in iso top front 1,1,0.2; do render --size 80,60 --view $v part.toolpath -o v-$v.png; done
    [ "$(cat c-progress.png | cksum)" != "$(cat c-class.png | cksum)" ]
    [ "$(cksum < v-iso.png)" != "$(cksum < v-top.png)" ]
    [ "$(cksum < v-iso.png)" != "$(cksum < v-1,1,0.2.png)" ]
}

@test "threads change nothing" {
    for t in 1 2 8; do
        render --threads $t --size 160,120 part.toolpath -o t$t.png 2> err
        [ ! -s err ]
        render --threads $t --size 160,120 --layer 1 --regions part.regions part.toolpath -o f$t.png
    done
    cmp t1.png t2.png
    cmp t1.png t8.png
    cmp f1.png f8.png
}

@test "a layer as SVG, by name or by option" {
    render --layer 0 --regions part.regions part.toolpath -o layer.svg
    render --layer 0 --regions part.regions --format svg part.toolpath > layer2.svg
    cmp layer.svg layer2.svg
    grep -q '<svg ' layer.svg
    tail -n 1 layer.svg | grep -q '</svg>'
    render --layer 0 --regions part.regions part.toolpath -o layer.pdf
    head -c 5 layer.pdf | grep -q '%PDF-'
    render --layer 0 part.toolpath --format pdf | head -c 5 | grep -q '%PDF-'
}

@test "a surface, a path on it, and several views" {
    geodesic part.stl --source vertex:0 --spacing 1 -o part.surface
    for t in 1 2 8; do
        render --threads $t --size 160,120 --by distance part.surface -o s$t.png 2> err
        [ ! -s err ]
        render --threads $t --size 160,120 --surface part.surface --voids --overlap --views iso,back,1,1,1 \
            part.toolpath -o d$t.png
    done
    is_png s1.png
    is_png d1.png
    cmp s1.png s2.png
    cmp s1.png s8.png
    cmp d1.png d2.png
    cmp d1.png d8.png
    render --size 160,120 part.surface -o plain.png
    run -1 cmp -s plain.png s1.png
    render --size 160,120 --around 1,1,0,2 part.surface -o near.png
    run -1 cmp -s plain.png near.png
    render --size 160,120 --views iso,top part.toolpath -o views.png
    is_png views.png
}

@test "VTP of a surface and of a path" {
    geodesic part.stl --source vertex:0 -o part.surface
    render part.surface -o surface.vtp
    grep -q 'Name="distance"' surface.vtp
    render part.toolpath -o path.vtp
    grep -q 'Name="progress"' path.vtp
    for f in surface path; do tail -n 1 $f.vtp | grep -q '</VTKFile>'; done
    run render part.regions -o regions.vtp
    [ "$status" -eq 2 ]
    [ ! -e regions.vtp ]
}

@test "what needs a surface says so" {
    geodesic part.stl -o bare.surface
    for o in --voids --overlap "--by distance" "--arrows distance" "--around 0,0,0,1"; do
        run render $o part.toolpath
        [ "$status" -eq 2 ]
        [[ "$output" == *"without a surface; name it with --surface"* ]]
    done
    run render --by distance bare.surface
    [ "$status" -eq 2 ]
    [[ "$output" == *"no such field"* ]]
    run render --voids bare.surface
    [ "$status" -eq 2 ]
    run render --surface part.regions part.toolpath
    [ "$status" -eq 3 ]
    run render --surface bare.surface part.regions
    [ "$status" -eq 2 ]
    run render --around 0,0,0,0 bare.surface
    [ "$status" -eq 2 ]
    run render --views iso,top --layer 1 part.toolpath
    [ "$status" -eq 2 ]
}

@test "what does not fit together is refused" {
    run render --format jpg part.toolpath
    [ "$status" -eq 2 ]
    run render --view 0,0,0 part.toolpath
    [ "$status" -eq 2 ]
    run render --color mauve part.toolpath
    [ "$status" -eq 2 ]
    run render --size 5 part.toolpath
    [ "$status" -eq 2 ]
    run render --layer 77 part.toolpath
    [ "$status" -eq 2 ]
    [[ "$output" == *"nothing there"* ]]
}

@test "no picture is left of a stream cut short" {
    head -c 400 part.toolpath > cut
    run render cut -o cut.png
    [ "$status" -eq 4 ]
    [ ! -e cut.png ]
    echo nonsense > bad
    run render bad -o cut.png
    [ "$status" -eq 3 ]
    [ ! -e cut.png ]
}
