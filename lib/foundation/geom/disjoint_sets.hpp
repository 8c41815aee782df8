// Disjoint sets (union-find).
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace filum::geom {

// Disjoint sets of the numbers 0 to n - 1. The least number of a set is its representative.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t n = 0) : parent_(n), sets_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

    [[nodiscard]] std::size_t size() const { return parent_.size(); }
    [[nodiscard]] std::size_t sets() const { return sets_; }
    std::uint32_t add() { // adds a set with one member
        parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
        ++sets_;
        return parent_.back();
    }
    std::uint32_t root(std::uint32_t v) {
        while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    // Unites the sets of a and b. Returns whether they were different.
    bool unite(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a == b) return false;
        parent_[std::max(a, b)] = std::min(a, b);
        --sets_;
        return true;
    }
    // Sets `set` to the number of each member's set; sets are numbered in the order of their least members. Returns
    // their count.
    std::size_t number(std::vector<std::uint32_t>& set) {
        set.resize(parent_.size());
        std::uint32_t count = 0;
        for (std::uint32_t v = 0; v < parent_.size(); ++v) { // the least member of a set comes first
            const std::uint32_t r = root(v);
            set[v] = r == v ? count++ : set[r];
        }
        return count;
    }

  private:
    std::vector<std::uint32_t> parent_;
    std::size_t sets_;
};

} // namespace filum::geom
