# shellcheck shell=bash disable=SC2034
# What the shell tests share: a small part, the commands, and an input for each of them.

# `run -N` and `run !` need bats 1.5; scripts/fuzz reads this file without bats.
if declare -F bats_require_minimum_version >/dev/null; then bats_require_minimum_version 1.5.0; fi

# Where the commands under test are.
commands_folder() { dirname "$(command -v filum)"; }

# All commands, without the front command.
stages() {
    if [[ -d $BATS_FILE_TMPDIR/contracts ]]; then (cd "$BATS_FILE_TMPDIR/contracts" && ls -I filum); else filum list | cut -d ' ' -f 1; fi
}

# Asks every command once for what it says about itself.
ask_all() {
    local c all
    all=$(stages)
    mkdir -p "$BATS_FILE_TMPDIR/contracts"
    for c in filum $all; do "$c" --print-contract > "$BATS_FILE_TMPDIR/contracts/$c"; done
}

# Writes a triangle (three corners, three coordinates each) of a binary STL.
stl_triangle() {
    printf '\0\0\0\0\0\0\0\0\0\0\0\0'
    local v
    for v in "$@"; do
        case $v in
            0) printf '\0\0\0\0' ;;
            1) printf '\0\0\200\77' ;;
            9) printf '\0\0\20\101' ;;
        esac
    done
    printf '\0\0'
}

# A box of 9 x 9 x 1 mm, as a binary STL on standard output.
box_stl() {
    printf '%-80s' 'box of 9 x 9 x 1 mm'
    printf '\14\0\0\0'
    stl_triangle 0 0 0  9 9 0  9 0 0; stl_triangle 0 0 0  0 9 0  9 9 0
    stl_triangle 0 0 1  9 0 1  9 9 1; stl_triangle 0 0 1  9 9 1  0 9 1
    stl_triangle 0 0 0  9 0 0  9 0 1; stl_triangle 0 0 0  9 0 1  0 0 1
    stl_triangle 9 0 0  9 9 0  9 9 1; stl_triangle 9 0 0  9 9 1  9 0 1
    stl_triangle 9 9 0  0 9 0  0 9 1; stl_triangle 9 9 0  0 9 1  9 9 1
    stl_triangle 0 9 0  0 0 0  0 0 1; stl_triangle 0 9 0  0 0 1  0 9 1
}

# What tests of the front command share: the contracts of all programs, and a box as part.stl in the file's folder.
make_part_and_contracts() {
    cd "$BATS_FILE_TMPDIR" || exit 1
    ask_all
    box_stl > part.stl
}

# A box of 20 x 10 x 1 mm, in the same form: corner i at x = bit 0, y = bit 1, z = bit 2.
# shellcheck disable=SC2059
flat_box_stl() {
    local zero='\0\0\0\0' one='\0\0\x80\x3f' ten='\0\0\x20\x41' twenty='\0\0\xa0\x41' i x y z count=0
    printf '%80s' box
    printf '\14\0\0\0'
    for i in 0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5; do
        [ $((++count % 3)) -ne 1 ] || printf "$zero$zero$zero"
        x=$zero y=$zero z=$zero
        [ $((i & 1)) -eq 0 ] || x=$twenty
        [ $((i & 2)) -eq 0 ] || y=$ten
        [ $((i & 4)) -eq 0 ] || z=$one
        printf "$x$y$z"
        [ $((count % 3)) -ne 0 ] || printf '\0\0'
    done
}

# boxes FILE X0,Y0,Z0,X1,Y1,Z1...: boxes from one corner to the other, as a binary STL.
boxes() {
    python3 - "$@" << 'END'
import struct
import sys

FACES = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6),
         (1, 3, 5), (3, 7, 5))

with open(sys.argv[1], "wb") as f:
    f.write(bytes(80) + struct.pack("<I", 12 * len(sys.argv[2:])))
    for box in sys.argv[2:]:
        ends = [float(v) for v in box.split(",")]
        corner = [[ends[3 * (i >> k & 1) + k] for k in range(3)] for i in range(8)]
        for face in FACES:
            f.write(struct.pack("<12x9fH", *sum((corner[i] for i in face), []), 0))
END
}

# disc RADIUS: a flat one, in 48 triangles.
disc() {
    awk -v r="$1" 'BEGIN {
        n = 48
        printf "OFF\n%d %d 0\n0 0 0\n", n + 1, n
        for (i = 0; i < n; i++) printf "%.6f %.6f 0\n", r * cos(6.28318530718 * i / n), r * sin(6.28318530718 * i / n)
        for (i = 0; i < n; i++) printf "3 0 %d %d\n", 1 + i, 1 + (i + 1) % n
    }'
}

# Makes part.stl and a stream of every payload in the current folder.
make_inputs() {
    box_stl > part.stl
    slice part.stl --output Layers
    regions Layers --output Regions
    sequence Regions --output sequenced
    fill sequenced --output Paths
    link3d Paths --output Toolpath
    postproc Toolpath --set purge=0 --output part.gcode # without a line before the part, which ingest notes
    disc 9 > disc.off
    geodesic disc.off --source boundary --spacing 2 --output Surface
}

# fact COMMAND KEY: the rest of that line of the command's contract.
fact() {
    local line
    while IFS= read -r line; do
        if [[ $line == "$2 "* ]]; then
            echo "${line#"$2 "}"
            return
        fi
    done < "$BATS_FILE_TMPDIR/contracts/$1"
}

# The file of make_inputs that the command reads; nothing for a command that reads none.
input_of() {
    local in
    in=$(fact "$1" in)
    case $1:$in in
        fill:*) echo sequenced ;;
        ingest:*) echo part.gcode ;;
        *:file) echo part.stl ;;
        *:'stream unknown') echo Paths ;;
        *:'stream '*) echo "${in#stream }" ;;
    esac
}

# Stages that read a stream, and all that read anything.
stream_readers() { for_each_input 'stream *'; }
readers() { for_each_input '[fs]*'; }
for_each_input() {
    local c
    for c in $(stages); do
        # shellcheck disable=SC2053
        if [[ $(fact "$c" in) == $1 ]]; then echo "$c"; fi
    done
}

# flip FILE OFFSET: inverts one byte.
flip() {
    local byte octal
    byte=$(od -An -tu1 -j "$2" -N 1 "$1")
    printf -v octal %o $((byte ^ 255))
    # shellcheck disable=SC2059
    printf "\\$octal" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}

# text_of NAME FILE: the variable becomes the file's text up to a zero byte, without line ends behind it.  Nothing is
# started for that: the contract asks a thousand times.
text_of() {
    local text
    IFS= read -r -d '' -n 10000 text < "$2" || true
    while [[ $text == *$'\n' ]]; do text=${text%$'\n'}; done
    printf -v "$1" %s "$text"
}

# expect CODE COMMAND...: runs it, keeps its output in $out and $err, complains unless it ends so.  CODE may be '3|4'.
expect() {
    local want=$1 code=0
    shift
    "$@" > "$BATS_TEST_TMPDIR/out" 2> "$BATS_TEST_TMPDIR/err" || code=$?
    text_of out "$BATS_TEST_TMPDIR/out"
    text_of err "$BATS_TEST_TMPDIR/err"
    if [[ ! $code =~ ^($want)$ ]]; then
        echo "expected $want, got $code: $*"
        echo "stderr: $err"
        return 1
    fi
}

# complaint NAME: standard error is one line in the house's grammar.
complaint() {
    if [[ $err == *$'\n'* || ! $err =~ ^$1:\ [^A-Z].*[^.]$ ]]; then
        echo "no proper complaint of $1: $err"
        return 1
    fi
}

# What rs274 needs to read programs of five axes; it knows no tool centre point control: M428 and M429, which switch it, are
# taken for nothing.
rs274_files() {
    mkdir -p subs
    for m in 428 429; do printf 'o<m%s> sub\no<m%s> endsub\nM2\n' $m $m > subs/m$m.ngc; done
    cat > axes.ini <<'INI'
[EMC]
VERSION = 1.1
[DISPLAY]
PROGRAM_PREFIX = .
[RS274NGC]
PARAMETER_FILE = p.var
SUBROUTINE_PATH = ./subs
REMAP = M428 modalgroup=10 ngc=m428
REMAP = M429 modalgroup=10 ngc=m429
[KINS]
KINEMATICS = trivkins coordinates=XYZABC
JOINTS = 6
[TRAJ]
COORDINATES = XYZABC
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
[EMCIO]
TOOL_TABLE = t.tbl
INI
    printf 'T1 P1 Z0 D0.4\nT2 P2 Z0 D1\n' > t.tbl
    : > p.var
}
