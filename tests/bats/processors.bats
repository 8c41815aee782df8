#!/usr/bin/env bats
# The same bytes on every x86-64 processor: glibc, OpenBLAS and Embree choose their functions by the processor.
bats_require_minimum_version 1.5.0

setup() {
    top=$BATS_TEST_DIRNAME/../..
    cd "$BATS_TEST_TMPDIR"
}

# Runs "$@" as a processor without fused multiply-add, AVX2 and AVX-512 would.
older() {
    GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX512F_Usable,-AVX2,-FMA,-AVX512F OPENBLAS_CORETYPE=Nehalem "$@"
}

chain() {
    slice "$top/examples/bar/bar.stl" --layer-height 0.3 | regions | sequence | fill >"$1.paths"
    link3d "$1.paths" -o "$1.toolpath"
    postproc "$1.toolpath" --machine marlin -o "$1.gcode"
    render "$1.toolpath" --size 200,150 -o "$1.png"
    geodesic "$top/examples/bracket/patch_E.ply" --source boundary -o "$1.surface"
    surfpath hybrid --spacing 2 "$1.surface" -q -o "$1.hybrid"
    surfpath field --follow rim=1 --spacing 2 "$1.surface" -q -o "$1.field"
    metrics --surface "$1.surface" "$1.hybrid" --format json >"$1.json"
}

@test "every stage writes the same bytes without AVX2, AVX-512 and fused multiply-add" {
    chain here
    export -f chain older
    export top
    older bash -c 'chain there'
    for kind in paths toolpath gcode png surface hybrid field json; do cmp "here.$kind" "there.$kind"; done
}

@test "no program takes from libm or BLAS what depends on the processor" {
    # The functions that glibc has in several versions.  Those with exact results (floor, rint, fma, ...) are not listed.
    variants='^(sin|cos|tan|sincos|asin|acos|atan|atan2|exp|exp2|expm1|log|log2|log10|pow|sinf|cosf|sincosf|tanf|asinf|acosf|atanf|atan2f|expf|exp2f|logf|log2f|powf|sinh|cosh|tanh|log1p|d[a-z0-9]+_)(@.*)?$'
    for program in "$FILUM_BUILD"/bin/*; do
        [[ $(head -c 4 "$program" | tail -c 3) == ELF ]] || continue
        nm -D --undefined-only "$program" | awk '{ print $2 }' | grep -E "$variants" | sed "s#^#$program: #" >>wanted || true
    done
    [ ! -s wanted ] || { cat wanted && false; }
    # The check can fail: the C library's own users import them.
    printf 'extern "C" double sin(double); int main(int n, char **) { return sin(n) > 0; }' >probe.cpp
    c++ -O0 -fno-builtin probe.cpp -o probe 2>/dev/null
    nm -D --undefined-only probe | awk '{ print $2 }' | grep -qE "$variants"
}
