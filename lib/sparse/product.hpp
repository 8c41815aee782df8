// Products of dense matrices whose bits do not depend on the processor.
#pragma once

namespace filum::sparse {

// C += alpha A B', column-major: A is m x k with leading dimension lda, B n x k, C m x n.  Every entry of C is summed
// up in the order of k, in blocks of 256, by multiplications and additions that are rounded one by one.  Wider
// registers only work on more entries at once, so all x86-64 processors give the same bits.
void add_product(int m, int n, int k, double alpha, const double* a, int lda, const double* b, int ldb, double* c,
                 int ldc);

// The same of the lower triangle of C, n x n, with B = A.
void add_square(int n, int k, double alpha, const double* a, int lda, double* c, int ldc);

} // namespace filum::sparse
