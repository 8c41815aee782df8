#!/usr/bin/env bats
# The Python package: its own tests, pip, the notebooks.
# shellcheck disable=SC2154

load common

setup_file() {
    source_tree=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
    export source_tree PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=Agg
    # The interpreter that knows protobuf and numpy: Debian's, even where another one comes first.
    for python in python3 /usr/bin/python3; do
        "$python" -c 'import google.protobuf, numpy' 2> /dev/null && break
        python=
    done
    [[ -n $python ]] || skip "no python3-protobuf, python3-numpy"
    export python
}

setup() { cd "$BATS_FILE_TMPDIR" || exit 1; }

@test "its own tests pass" {
    PYTHONPATH=$FILUM_BUILD/python "$python" -m unittest discover -s "$source_tree/python/tests" -t "$source_tree/python/tests" 2>&1
}

@test "pip installs it from the folder, with messages made by protoc, and it runs" {
    "$python" -c 'import setuptools, pip, wheel' 2> /dev/null || skip "no python3-pip, python3-setuptools, python3-wheel"
    command -v protoc > /dev/null || skip "no protoc"
    mkdir tree
    cp -r "$source_tree/python" "$source_tree/proto" tree
    "$python" -m pip install --quiet --no-index --no-deps --no-build-isolation --root-user-action ignore --target there tree/python
    ls there/filum/stream_pb2.py
    box_stl > part.stl
    PYTHONPATH=there "$python" -c '
import filum
text = filum.slice("part.stl").regions().sequence().fill(pattern="zigzag").link3d().gcode("marlin")
assert text.count("\nG1 ") > 20, text
' 2>&1
}

@test "both notebooks run" {
    command -v jupyter-nbconvert > /dev/null || skip "no jupyter-nbconvert"
    /usr/bin/python3 -c 'import ipykernel, matplotlib, nbclient, google.protobuf, numpy' 2> /dev/null || skip "no python3-ipykernel, python3-matplotlib"
    mkdir -p at/python
    cp -r "$source_tree/python/notebooks" at/python
    ln -s "$source_tree/examples" at/examples
    # Debian's kernel, whatever else the user has.
    mkdir -p kernels/kernels/python3
    printf '{"argv": ["/usr/bin/python3", "-m", "ipykernel_launcher", "-f", "{connection_file}"], "display_name": "Python 3", "language": "python"}' \
        > kernels/kernels/python3/kernel.json
    export JUPYTER_PATH=$PWD/kernels JUPYTER_DATA_DIR=$PWD/kernels JUPYTER_RUNTIME_DIR=$PWD/run JUPYTER_CONFIG_DIR=$PWD/config IPYTHONDIR=$PWD/ipython
    mkdir -p run
    for name in planar surface; do
        PYTHONPATH=$FILUM_BUILD/python /usr/bin/python3 -m nbconvert --to html --execute --ExecutePreprocessor.timeout=200 \
            "at/python/notebooks/$name.ipynb" > "$name.log" 2>&1 || { tail -n 30 "$name.log" && return 1; }
        [[ $(stat -c %s "at/python/notebooks/$name.html") -gt 100000 ]]
    done
}

@test "a stage in twenty lines" {
    [[ $(wc -l < "$source_tree/examples/swap-a-stage/walls") -le 20 ]]
    run -1 grep -qE '.{121}' "$source_tree/examples/swap-a-stage/walls"
}
