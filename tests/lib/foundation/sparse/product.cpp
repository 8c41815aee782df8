#include "sparse/product.hpp"

#include "base/mix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace filum::sparse {
namespace {

constexpr int kDepth = 256; // as in the header: sums are added up in blocks of so many

struct Sizes {
    int m, n, k;
};

std::vector<double> numbers(int count, std::uint64_t seed) {
    std::vector<double> out(static_cast<std::size_t>(count));
    for (double& v : out) v = 2 * next_share(seed) - 1;
    return out;
}

// One entry of C += alpha A B', added up in the order that the header promises.
double entry(double c, double alpha, const double* a, int lda, const double* b, int ldb, int k) {
    for (int from = 0; from < k; from += kDepth) {
        double sum = 0;
        for (int i = from; i < std::min(k, from + kDepth); ++i) sum += a[i * lda] * b[i * ldb];
        c += alpha * sum;
    }
    return c;
}

TEST(Product, HasTheBitsOfAPlainLoop) {
    std::uint64_t seed = 3;
    for (const auto& [m, n, k] :
         {Sizes{1, 1, 1}, {3, 5, 2}, {16, 4, 7}, {17, 9, 300}, {130, 33, 64}, {257, 70, 513}, {5, 1, 1000}}) {
        const int lda = m + 3, ldb = n + 1, ldc = m + 2;
        const auto a = numbers(lda * k, ++seed), b = numbers(ldb * k, ++seed), before = numbers(ldc * n, ++seed);
        auto c = before;
        add_product(m, n, k, -0.7, a.data(), lda, b.data(), ldb, c.data(), ldc);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < ldc; ++i) {
                const auto at = static_cast<std::size_t>(j * ldc + i);
                ASSERT_EQ(c[at], i < m ? entry(before[at], -0.7, &a[static_cast<std::size_t>(i)], lda,
                                               &b[static_cast<std::size_t>(j)], ldb, k)
                                       : before[at])
                    << m << ' ' << n << ' ' << k << " at " << i << ' ' << j;
            }
    }
}

TEST(Product, OfASquareOnlyTheLowerTriangleChanges) {
    for (const auto& [n, m, k] : {Sizes{1, 0, 1}, {63, 0, 5}, {64, 0, 64}, {65, 0, 10}, {200, 0, 300}}) {
        const auto a = numbers(n * k, 5), before = numbers(n * n, 6);
        auto c = before;
        add_square(n, k, 1, a.data(), n, c.data(), n);
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const auto at = static_cast<std::size_t>(j * n + i);
                const double right =
                    entry(before[at], 1, &a[static_cast<std::size_t>(i)], n, &a[static_cast<std::size_t>(j)], n, k);
                if (i < j)
                    ASSERT_EQ(c[at], before[at]);
                else
                    ASSERT_NEAR(c[at], right, 1e-12 * k);
            }
    }
}

} // namespace
} // namespace filum::sparse
