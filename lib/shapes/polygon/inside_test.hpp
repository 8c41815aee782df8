// A test for many points of whether they lie in an area.
#pragma once

#include "polygon/loops.hpp"

#include <cstdint>
#include <vector>

namespace filum::polygon {

// Gives the results of contains(), but compares a point only with the edges in its row of y. Linear memory.
class InsideTest {
  public:
    explicit InsideTest(const Loops& area);

    [[nodiscard]] bool operator()(Vec2 p) const;

  private:
    struct Edge {
        Vec2 a, b;
    };
    [[nodiscard]] std::size_t row(double y) const;

    std::vector<Edge> edge_;
    Box2 box_;
    double per_mm_ = 0; // rows per mm
    std::size_t rows_ = 0;
    std::vector<std::uint32_t> first_, item_; // edges of row k: item_[first_[k]] .. item_[first_[k + 1])
};

} // namespace filum::polygon
