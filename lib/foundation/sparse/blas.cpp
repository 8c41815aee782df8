// The six functions of BLAS and LAPACK that CHOLMOD calls, by Eigen and sparse/product.
//
// OpenBLAS, the usual BLAS of Debian, chooses its kernels by the processor. A sum in another order can differ in its
// last bit. The definitions below replace these functions in every program that links this library. They use Eigen,
// compiled for any x86-64 processor, with the same block sizes on all machines. Arguments, orders and layouts are those
// of the BLAS standard: column-major, all arguments by address. CHOLMOD uses unit strides and only these letters:
//   dgemm  N,C  C = alpha A B' + beta C          dsyrk  L,N  C = alpha A A' + beta C, lower triangle
//   dtrsm  R,L,C,N  B = B L'^-1 and L,L,(N|C),N  B = L^-1 B, L'^-1 B        dpotrf  L  A = L L'
//   dgemv  (N|C)  y = alpha A x + beta y         dtrsv  L,(N|C),N  x = L^-1 x, L'^-1 x
#include "sparse/product.hpp"

#include <Eigen/Core>
#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace filum::sparse {

namespace {

using Columns = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using ConstColumns = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Vector = Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<>>;
using ConstVector = Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<>>;

// Sizes of the processor caches in bytes that Eigen chooses its blocks by: those of a small current processor.
constexpr std::ptrdiff_t kCache1 = 32 << 10, kCache2 = 256 << 10, kCache3 = 2 << 20;

void fix_blocks() {
    static const bool fixed = (Eigen::setCpuCacheSizes(kCache1, kCache2, kCache3), true);
    static_cast<void>(fixed);
}

bool transposed(const char* letter) { return *letter != 'N' && *letter != 'n'; }

// Ends the program for arguments that CHOLMOD never uses, because these functions do not support them.
void require(bool known) {
    if (!known) std::abort();
}

constexpr int kStep = 64; // columns of a triangle that are solved at once

// Solves B = B L'^-1 in steps of kStep columns; B is m x n, L lower triangular.
void solve_from_right(int m, int n, const double* l, int ldl, double* b, int ldb) {
    for (int j = 0; j < n; j += kStep) {
        const int width = std::min(kStep, n - j), left = n - j - width;
        const std::ptrdiff_t corner = j + std::ptrdiff_t{j} * ldl;
        Columns columns(b + std::ptrdiff_t{j} * ldb, m, width, Eigen::OuterStride<>(ldb));
        const ConstColumns triangle(l + corner, width, width, Eigen::OuterStride<>(ldl));
        triangle.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(columns);
        if (left > 0)
            add_product(m, left, width, -1, columns.data(), ldb, l + corner + width, ldl,
                        columns.data() + std::ptrdiff_t{width} * ldb, ldb);
    }
}

void scale(Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>> c, double beta) {
    if (beta == 0)
        c.setZero();
    else if (beta != 1)
        c *= beta;
}

} // namespace

} // namespace filum::sparse

using namespace filum::sparse; // NOLINT(google-build-using-namespace): the functions below have no namespace

extern "C" {

void dgemm_(const char* ta, const char* tb, const int* m, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* b, const int* ldb, const double* beta, double* c,
            const int* ldc) {
    fix_blocks();
    Columns out(c, *m, *n, Eigen::OuterStride<>(*ldc));
    scale(out, *beta);
    const ConstColumns left(a, transposed(ta) ? *k : *m, transposed(ta) ? *m : *k, Eigen::OuterStride<>(*lda));
    const ConstColumns right(b, transposed(tb) ? *n : *k, transposed(tb) ? *k : *n, Eigen::OuterStride<>(*ldb));
    require(!transposed(ta) || !transposed(tb));
    if (transposed(tb))
        add_product(*m, *n, *k, *alpha, a, *lda, b, *ldb, c, *ldc);
    else if (transposed(ta))
        out.noalias() += *alpha * (left.transpose() * right);
    else
        out.noalias() += *alpha * (left * right);
}

void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha, const double* a,
            const int* lda, const double* beta, double* c, const int* ldc) {
    fix_blocks();
    require(*uplo == 'L' && !transposed(trans));
    Columns out(c, *n, *n, Eigen::OuterStride<>(*ldc));
    if (*beta == 0)
        out.triangularView<Eigen::Lower>().setZero();
    else if (*beta != 1)
        for (int j = 0; j < *n; ++j) out.col(j).tail(*n - j) *= *beta;
    add_square(*n, *k, *alpha, a, *lda, c, *ldc);
}

void dtrsm_(const char* side, const char* uplo, const char* trans, const char* diag, const int* m, const int* n,
            const double* alpha, const double* a, const int* lda, double* b, const int* ldb) {
    fix_blocks();
    require(*uplo == 'L' && *diag == 'N');
    Columns out(b, *m, *n, Eigen::OuterStride<>(*ldb));
    scale(out, *alpha);
    const int order = *side == 'L' ? *m : *n;
    const ConstColumns known(a, order, order, Eigen::OuterStride<>(*lda));
    const auto lower = known.triangularView<Eigen::Lower>();
    if (*side == 'L') {
        if (transposed(trans))
            lower.transpose().solveInPlace(out);
        else
            lower.solveInPlace(out);
    } else {
        require(transposed(trans));
        solve_from_right(*m, *n, a, *lda, b, *ldb);
    }
}

void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info) {
    fix_blocks();
    require(*uplo == 'L');
    *info = 0;
    for (int j = 0; j < *n; j += kStep) {
        const int width = std::min(kStep, *n - j), left = *n - j - width;
        double* corner = a + j + std::ptrdiff_t{j} * *lda;
        Columns block(corner, width, width, Eigen::OuterStride<>(*lda));
        // -1 if the block is positive definite; else its first column, from 0, that is not
        const auto bad = Eigen::internal::llt_inplace<double, Eigen::Lower>::unblocked(block);
        if (bad >= 0) {
            *info = j + static_cast<int>(bad) + 1;
            return;
        }
        if (left <= 0) return;
        double* below = corner + width;
        solve_from_right(left, width, corner, *lda, below, *lda);
        add_square(left, width, -1, below, *lda, corner + width + std::ptrdiff_t{width} * *lda, *lda);
    }
}

void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* a, const int* lda,
            const double* x, const int* incx, const double* beta, double* y, const int* incy) {
    const bool turned = transposed(trans);
    const ConstColumns left(a, *m, *n, Eigen::OuterStride<>(*lda));
    const ConstVector in(x, turned ? *m : *n, Eigen::InnerStride<>(*incx));
    Vector out(y, turned ? *n : *m, Eigen::InnerStride<>(*incy));
    if (*beta == 0)
        out.setZero();
    else if (*beta != 1)
        out *= *beta;
    if (turned)
        out.noalias() += *alpha * (left.transpose() * in);
    else
        out.noalias() += *alpha * (left * in);
}

void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a, const int* lda,
            double* x, const int* incx) {
    require(*uplo == 'L' && *diag == 'N');
    const ConstColumns known(a, *n, *n, Eigen::OuterStride<>(*lda));
    Vector out(x, *n, Eigen::InnerStride<>(*incx));
    if (transposed(trans))
        known.triangularView<Eigen::Lower>().transpose().solveInPlace(out);
    else
        known.triangularView<Eigen::Lower>().solveInPlace(out);
}
}
