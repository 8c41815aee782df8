#include "sparse/product.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace filum::sparse {

namespace {

// Depth of a block: columns of A and B that are summed at once. Height of a block: rows of A, which fit into the
// second-level cache.
constexpr int kDepth = 256, kHeight = 128;
constexpr int kColumns = 4; // columns of C in a tile
constexpr int kTallest = 16;
constexpr int kSquare = 64; // columns of C in each step along the diagonal of a square

constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Packs a matrix into strips of `width` rows, each column after column, padded with zeros.
void pack(int rows, int depth, int width, const double* from, int stride, std::vector<double>& to) {
    to.assign(at((rows + width - 1) / width * width) * at(depth), 0);
    double* out = to.data();
    for (int i = 0; i < rows; i += width)
        for (int j = 0; j < depth; ++j, out += width)
            std::copy_n(from + at(j) * at(stride) + i, std::min(width, rows - i), out);
}

// The operands of a block of C: packed strips of A and of B, and the place of C.
struct Block {
    int m, n, depth;
    double alpha;
    const double *a, *b;
    double* c;
    int ldc;
};

// A register with `lanes` neighbouring entries of a column of C.
template <int lanes>
struct Register {
    using type [[gnu::vector_size(lanes * sizeof(double)), gnu::aligned(sizeof(double))]] = double;
};

// Computes a block of C in tiles of two registers by four columns, with the sums of a tile in eight registers. Inlined
// into one function for each register size.
template <int lanes>
[[gnu::always_inline]] inline void tiles(const Block& o) {
    using Lanes = typename Register<lanes>::type;
    static_assert(kColumns == 4);
    constexpr int rows = 2 * lanes;
    for (int j = 0; j < o.n; j += kColumns)
        for (int i = 0; i < o.m; i += rows) {
            const double* a = o.a + at(i) * at(o.depth);
            const double* b = o.b + at(j) * at(o.depth);
            Lanes s0{}, s1{}, s2{}, s3{}, t0{}, t1{}, t2{}, t3{};
            for (int k = 0; k < o.depth; ++k, a += rows, b += kColumns) {
                const Lanes upper = *reinterpret_cast<const Lanes*>(a),
                            lower = *reinterpret_cast<const Lanes*>(a + lanes);
                s0 += upper * b[0], t0 += lower * b[0];
                s1 += upper * b[1], t1 += lower * b[1];
                s2 += upper * b[2], t2 += lower * b[2];
                s3 += upper * b[3], t3 += lower * b[3];
            }
            const Lanes sum[kColumns][2] = {{s0, t0}, {s1, t1}, {s2, t2}, {s3, t3}};
            for (int y = 0; y < std::min(kColumns, o.n - j); ++y)
                for (int x = 0; x < std::min(rows, o.m - i); ++x)
                    o.c[at(j + y) * at(o.ldc) + at(i + x)] += o.alpha * sum[y][x / lanes][x % lanes];
        }
}

[[gnu::target("avx512f")]] void tiles_of_16(const Block& o) { tiles<8>(o); }
[[gnu::target("avx")]] void tiles_of_8(const Block& o) { tiles<4>(o); }
void tiles_of_4(const Block& o) { tiles<2>(o); }

struct Kernel {
    int rows;
    void (*run)(const Block&);
};

Kernel best() {
    if (__builtin_cpu_supports("avx512f") != 0) return {16, tiles_of_16};
    if (__builtin_cpu_supports("avx") != 0) return {8, tiles_of_8};
    return {4, tiles_of_4};
}

} // namespace

void add_product(int m, int n, int k, double alpha, const double* a, int lda, const double* b, int ldb, double* c,
                 int ldc) {
    static const Kernel kernel = best();
    static_assert(kHeight % kTallest == 0);
    thread_local std::vector<double> left, right;
    for (int from = 0; from < k; from += kDepth) {
        const int depth = std::min(kDepth, k - from);
        pack(n, depth, kColumns, b + at(from) * at(ldb), ldb, right);
        for (int i = 0; i < m; i += kHeight) {
            const int height = std::min(kHeight, m - i);
            pack(height, depth, kernel.rows, a + at(from) * at(lda) + i, lda, left);
            kernel.run({height, n, depth, alpha, left.data(), right.data(), c + i, ldc});
        }
    }
}

void add_square(int n, int k, double alpha, const double* a, int lda, double* c, int ldc) {
    std::array<double, at(kSquare) * at(kSquare)> corner;
    for (int j = 0; j < n; j += kSquare) {
        const int width = std::min(kSquare, n - j);
        corner.fill(0);
        add_product(width, width, k, alpha, a + j, lda, a + j, lda, corner.data(), kSquare);
        for (int y = 0; y < width; ++y)
            for (int x = y; x < width; ++x) c[at(j + y) * at(ldc) + at(j + x)] += corner[at(y * kSquare + x)];
        if (const int below = j + width; below < n)
            add_product(n - below, width, k, alpha, a + below, lda, a + j, lda, c + at(j) * at(ldc) + below, ldc);
    }
}

} // namespace filum::sparse
