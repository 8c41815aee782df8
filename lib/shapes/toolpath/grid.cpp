#include "toolpath/grid.hpp"

#include "geom/segment_grid.hpp"

#include <algorithm>

namespace filum::toolpath {

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// A point of a curve, and the segments that end and begin there.
struct Knot {
    Vec2* point;
    std::optional<std::uint32_t> in, out;
};

// All segments of the curves, in a grid that remains valid if points move by kMostMoved.
class SegmentIndex {
  public:
    SegmentIndex(std::vector<Curve>& curves, double cell)
        : segments_(segments_of(curves)), grid_(segments_, cell, kMostMoved) {
        for (Curve& c : curves) add_knots(c);
    }

    [[nodiscard]] bool cross(std::uint32_t i, std::uint32_t j) const {
        return geom::cross_properly(segments_[i].a, segments_[i].b, segments_[j].a, segments_[j].b);
    }

    // Moves an end of one of two segments by the least offset that leaves its segments without crossings.
    void separate(std::uint32_t i, std::uint32_t j, const std::vector<Vec2>& offsets, std::optional<Vec2> fixed) {
        std::vector<std::pair<double, Knot>> knots; // with mm from the other segment
        for (const auto& [s, t] : {std::pair{i, j}, std::pair{j, i}})
            for (const Knot& knot : {begin_[s], end_[s]})
                if (!fixed || *knot.point != *fixed)
                    knots.emplace_back(geom::point_segment_distance(segments_[t].a, segments_[t].b, *knot.point), knot);
        std::stable_sort(knots.begin(), knots.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const Vec2 offset : offsets)
            for (const auto& [off, knot] : knots) {
                const Vec2 at = *knot.point;
                put(knot, on_grid(at + offset));
                if (is_free(knot) && !cross(i, j)) return;
                put(knot, at);
            }
    }

  private:
    void add_knots(Curve& c) {
        const auto n = static_cast<std::uint32_t>(c.points.size()), count = n - (c.closed || n == 0 ? 0 : 1);
        const auto first = static_cast<std::uint32_t>(begin_.size());
        const auto number = [&](std::uint32_t k) { return std::optional(first + k % count); };
        for (std::uint32_t k = 0; k < count; ++k) {
            begin_.push_back({&c.points[k], c.closed || k > 0 ? number(k - 1 + count) : std::nullopt, first + k});
            end_.push_back(
                {&c.points[(k + 1) % n], first + k, c.closed || k + 1 < count ? number(k + 1) : std::nullopt});
        }
    }
    template <class F>
    void near(std::uint32_t i, F&& f) const {
        const auto [a, b] = segments_[i];
        grid_.near({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}, f);
    }
    void put(const Knot& knot, Vec2 p) {
        *knot.point = p;
        if (knot.in) segments_[*knot.in].b = p;
        if (knot.out) segments_[*knot.out].a = p;
    }
    [[nodiscard]] bool is_free(const Knot& knot) const {
        bool free = true;
        for (const auto& i : {knot.in, knot.out}) {
            if (!i) continue;
            free = free && segments_[*i].a != segments_[*i].b;
            if (free) near(*i, [&](std::uint32_t j) { free = free && !cross(*i, j); });
        }
        return free;
    }

    std::vector<geom::Segment> segments_;
    geom::SegmentGrid grid_;
    std::vector<Knot> begin_, end_; // of each segment
};

// Offsets of whole micrometres up to kMostMoved, the shortest first.
std::vector<Vec2> all_offsets() {
    constexpr int kMost = static_cast<int>(kMostMoved * 1e3 + 0.5);
    std::vector<std::pair<int, int>> steps;
    for (int x = -kMost; x <= kMost; ++x)
        for (int y = -kMost; y <= kMost; ++y)
            if (const int r2 = x * x + y * y; r2 > 0 && r2 <= kMost * kMost) steps.emplace_back(x, y);
    std::stable_sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) {
        return a.first * a.first + a.second * a.second < b.first * b.first + b.second * b.second;
    });
    std::vector<Vec2> out;
    out.reserve(steps.size());
    for (const auto& [x, y] : steps) out.push_back({x * 1e-3, y * 1e-3});
    return out;
}

} // namespace

std::vector<geom::Segment> segments_of(std::span<const Curve> curves) {
    std::vector<geom::Segment> out;
    for (const Curve& c : curves)
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
            out.push_back({c.points[i], c.points[i + 1 == c.points.size() ? 0 : i + 1]});
    return out;
}

void put_on_grid(Curve& curve) {
    Curve out{curve.closed, {}, {}};
    const bool per_point = curve.width.size() > 1;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const Vec2 p = on_grid(curve.points[i]);
        curve.points[i] = p;
        if (!out.points.empty() && out.points.back() == p) continue;
        out.add(p, curve.width_at(i));
    }
    while (curve.closed && out.points.size() > 1 && out.points.back() == out.points.front()) out.drop_last();
    if (out.points.size() < (curve.closed ? 3 : 2)) return;
    if (!per_point) out.width = curve.width;
    curve = std::move(out);
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const std::vector<Curve>& curves, double cell,
                                                                    std::span<const char> fresh) {
    const std::vector<geom::Segment> all = segments_of(curves);
    Pairs out;
    const auto compare = [&](std::uint32_t i, std::uint32_t j) {
        if (geom::cross_properly(all[i].a, all[i].b, all[j].a, all[j].b)) out.emplace_back(i, j);
    };
    if (fresh.empty()) {
        geom::SegmentPairs pairs(all, geom::cell_for(all, cell));
        for (std::uint32_t j = 0; j < all.size(); ++j) pairs.add(j, [&](std::uint32_t i) { compare(i, j); });
    } else {
        geom::MarkedSegments(all, fresh, cell).pairs(compare);
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>>
part_crossings(std::vector<Curve>& curves, double cell, std::optional<Vec2> fixed, std::span<const char> fresh) {
    Pairs left = crossing_pairs(curves, cell, fresh);
    if (left.empty()) return left;
    const std::vector<Vec2> offsets = all_offsets();
    // a point that could not be moved may be free after another one was moved
    for (std::size_t before = left.size() + 1; !left.empty() && left.size() < before;) {
        before = left.size();
        SegmentIndex net(curves, cell);
        for (const auto& [i, j] : left)
            if (net.cross(i, j)) net.separate(i, j, offsets, fixed);
        left = crossing_pairs(curves, cell, fresh);
    }
    return left;
}

} // namespace filum::toolpath
