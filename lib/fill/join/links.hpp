// The links between rings made so far, found by place: as many as there are rings, so no list to run through.
#pragma once

#include "geom/segment_grid.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace filum::fill::join {

class Links {
  public:
    // `cell` mm: about the length of a link.
    explicit Links(double cell) : cell_(cell) {}

    void push_back(const geom::Segment& s) {
        cells(s, 0, [&](std::uint64_t key) { at_[key].push_back(s); });
    }

    // Whether one comes nearer to `s` than `distance` mm.
    [[nodiscard]] bool any_nearer(const geom::Segment& s, double distance) const {
        bool found = false;
        cells(s, distance, [&](std::uint64_t key) {
            const auto here = at_.find(key);
            if (found || here == at_.end()) return;
            for (const auto& m : here->second) found = found || geom::segment_distance(s.a, s.b, m.a, m.b) < distance;
        });
        return found;
    }

  private:
    template <class F>
    void cells(const geom::Segment& s, double margin, F&& f) const {
        const auto index = [&](double v) { return static_cast<std::int32_t>(std::floor(v / cell_)); };
        const auto x1 = index(std::max(s.a.x, s.b.x) + margin), y1 = index(std::max(s.a.y, s.b.y) + margin);
        for (auto y = index(std::min(s.a.y, s.b.y) - margin); y <= y1; ++y)
            for (auto x = index(std::min(s.a.x, s.b.x) - margin); x <= x1; ++x)
                f(static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32U | static_cast<std::uint32_t>(x));
    }

    double cell_;
    std::unordered_map<std::uint64_t, std::vector<geom::Segment>> at_; // asked by key, never run through
};

} // namespace filum::fill::join
