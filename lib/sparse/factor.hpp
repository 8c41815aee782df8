// Direct solvers for symmetric positive definite systems.
#pragma once

#include <Eigen/SparseCore>

#include <memory>

namespace filum::sparse {

using Matrix = Eigen::SparseMatrix<double>; // the lower triangle of a symmetric matrix

// A factorisation by CHOLMOD, over supernodes where they pay: where it takes 40 operations for each entry or more.
class Factor {
  public:
    Factor();
    ~Factor();
    Factor(Factor&&) noexcept;
    Factor& operator=(Factor&&) noexcept;

    // Orders the unknowns; all matrices to come have entries in the same places.
    void analyse(const Matrix& a);
    // False if the matrix is not positive definite.
    [[nodiscard]] bool factorise(const Matrix& a);
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    // Another factor of matrices with entries in the same places, with what analyse() found.
    [[nodiscard]] Factor same_order() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::sparse
