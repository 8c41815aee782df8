#include "sparse/factor.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

using namespace filum::sparse;

// The Laplacian of a grid of rows x columns, which holds supernodes if it is wide.
void expect_solved(int n, int m) {
    const int rows = n * m;
    std::vector<Eigen::Triplet<double>> entries;
    for (int v = 0; v < rows; ++v) {
        entries.emplace_back(v, v, 5.0);
        if (v % n > 0) entries.emplace_back(v, v - 1, -1.0);
        if (v >= n) entries.emplace_back(v, v - n, -1.0);
    }
    Matrix a(rows, rows);
    a.setFromTriplets(entries.begin(), entries.end());
    Eigen::VectorXd x(rows);
    for (int v = 0; v < rows; ++v) x[v] = (v * 7919) % 101;
    const Eigen::VectorXd b = a.selfadjointView<Eigen::Lower>() * x;
    Factor factor;
    factor.analyse(a);
    Factor same = factor.same_order();
    ASSERT_TRUE(factor.factorise(a));
    EXPECT_LT((factor.solve(b) - x).cwiseAbs().maxCoeff(), 1e-9);
    Matrix twice = 2 * a;
    ASSERT_TRUE(same.factorise(twice));
    EXPECT_LT((same.solve(b) - 0.5 * x).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((factor.solve(b) - x).cwiseAbs().maxCoeff(), 1e-9);
    Matrix negative = -1 * a;
    EXPECT_FALSE(same.factorise(negative));
}

TEST(Factor, SolvesWithAndWithoutSupernodes) {
    expect_solved(1, 1);
    expect_solved(4, 2000);
    expect_solved(200, 200);
}

TEST(Factor, LargeOnesMayBeMadeAtOnce) {
    const int n = 400; // a square grid, so that supernodes are large
    std::vector<Eigen::Triplet<double>> entries;
    for (int v = 0; v < n * n; ++v) {
        entries.emplace_back(v, v, 4.1);
        if (v % n > 0) entries.emplace_back(v, v - 1, -1.0);
        if (v >= n) entries.emplace_back(v, v - n, -1.0);
    }
    Matrix a(n * n, n * n);
    a.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd x = Eigen::VectorXd::Ones(n * n), b = a.selfadjointView<Eigen::Lower>() * x;
    double off[4] = {1, 1, 1, 1};
    {
        std::vector<std::jthread> all;
        for (double& own : off)
            all.emplace_back([&] {
                Factor factor;
                factor.analyse(a);
                own = factor.factorise(a) ? (factor.solve(b) - x).cwiseAbs().maxCoeff() : 1;
            });
    }
    for (const double own : off) EXPECT_LT(own, 1e-9);
}
