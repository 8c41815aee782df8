// Direct solvers for symmetric positive definite systems.
#pragma once

#include <Eigen/SparseCore>

#include <memory>

namespace filum::sparse {

using Matrix = Eigen::SparseMatrix<double>; // the lower triangle of a symmetric matrix

// A factorisation by CHOLMOD. It uses supernodes if they pay: from 40 operations per entry of the factor on.
class Factor {
  public:
    Factor();
    ~Factor();
    Factor(Factor&&) noexcept;
    Factor& operator=(Factor&&) noexcept;

    // Chooses an order of the unknowns. All later matrices must have their entries in the same places.
    void analyse(const Matrix& a);
    // Factorises `a`. Returns false if it is not positive definite.
    [[nodiscard]] bool factorise(const Matrix& a);
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    // A new factor for matrices with entries in the same places. It reuses the results of analyse().
    [[nodiscard]] Factor same_order() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::sparse
