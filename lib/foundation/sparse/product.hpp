// Products of dense matrices whose bits do not depend on the processor.
#pragma once

namespace filum::sparse {

// Computes C += alpha A B', column-major. A is m x k with leading dimension lda, B is n x k, C is m x n. Every entry of
// C is summed in the order of k, in blocks of 256, and each multiplication and addition is rounded by itself. Wider
// registers only process more entries at once, so all x86-64 processors give the same bits.
void add_product(int m, int n, int k, double alpha, const double* a, int lda, const double* b, int ldb, double* c,
                 int ldc);

// Computes C += alpha A A' for the lower triangle of C, n x n, in the same order.
void add_square(int n, int k, double alpha, const double* a, int lda, double* c, int ldc);

} // namespace filum::sparse
