#include "link3d/segment_index.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <queue>
#include <tuple>

namespace filum::link3d {

namespace {

constexpr std::uint32_t kFan = 16;

void add(Box2& to, const Box2& from) {
    to.add(from.lo);
    to.add(from.hi);
}

} // namespace

SegmentIndex::SegmentIndex(std::span<const toolpath::Curve> curves) {
    std::size_t n = 0;
    for (const auto& c : curves) n += c.points.size() + 1;
    points_.reserve(n);
    first_.push_back(0);
    for (const auto& c : curves) {
        points_.insert(points_.end(), c.points.begin(), c.points.end());
        if (c.closed && !c.points.empty()) points_.push_back(c.points.front());
        const auto segments = c.points.size() + (c.closed ? 1 : 0);
        first_.push_back(first_.back() + static_cast<std::uint32_t>(segments > 0 ? segments - 1 : 0));
    }
    const std::uint32_t count = first_.back();
    if (count == 0) return;
    std::vector<Box2> boxes((count + kFan - 1) / kFan);
    for (std::uint32_t c = 0; c + 1 < first_.size(); ++c)
        for (std::uint32_t s = first_[c]; s < first_[c + 1]; ++s) {
            boxes[s / kFan].add(points_[s + c]);
            boxes[s / kFan].add(points_[s + c + 1]);
        }
    levels_.push_back(std::move(boxes));
    while (levels_.back().size() > 1) {
        const auto& below = levels_.back();
        std::vector<Box2> above((below.size() + kFan - 1) / kFan);
        for (std::size_t i = 0; i < below.size(); ++i) add(above[i / kFan], below[i]);
        levels_.push_back(std::move(above));
    }
}

std::uint32_t SegmentIndex::curve_of(std::uint32_t segment) const {
    return static_cast<std::uint32_t>(std::upper_bound(first_.begin(), first_.end(), segment) - first_.begin() - 1);
}

std::pair<Vec2, Vec2> SegmentIndex::ends(std::uint32_t segment) const {
    const std::uint32_t at = segment + curve_of(segment); // every curve has one point more than segments
    return {points_[at], points_[at + 1]};
}

Place SegmentIndex::place(std::uint32_t segment, double t, Vec2 from) const {
    const auto [a, b] = ends(segment);
    const auto curve = curve_of(segment);
    const Vec2 at = geom::lerp(a, b, t);
    return {curve, segment - first_[curve], t, at, geom::distance(at, from)};
}

std::vector<Place> SegmentIndex::extremes() const {
    std::vector<Place> out;
    if (empty()) return out;
    for (const Vec2 way : {Vec2{-1, 0}, Vec2{1, 0}, Vec2{0, -1}, Vec2{0, 1}}) {
        std::uint32_t best = 0;
        for (std::uint32_t s = 1; s < first_.back(); ++s)
            if (geom::dot(ends(s).first, way) > geom::dot(ends(best).first, way)) best = s;
        out.push_back(place(best, 0, ends(best).first));
    }
    return out;
}

std::optional<Place> SegmentIndex::nearest(Vec2 p, double limit, std::span<const char> skip) const {
    if (empty()) return std::nullopt;
    using Node = std::tuple<double, std::size_t, std::uint32_t>; // distance, level, box
    std::priority_queue<Node, std::vector<Node>, std::greater<>> open;
    open.emplace(std::sqrt(distance2(levels_.back().front(), p)), levels_.size() - 1, 0U);
    double best = limit;
    std::optional<std::uint32_t> found;
    while (!open.empty()) {
        const auto [d, level, box] = open.top();
        open.pop();
        if (d > best) break;
        const std::uint32_t from = box * kFan;
        if (level > 0) {
            const auto& below = levels_[level - 1];
            const auto to = std::min<std::uint32_t>(from + kFan, static_cast<std::uint32_t>(below.size()));
            for (std::uint32_t i = from; i < to; ++i)
                if (const double e = std::sqrt(distance2(below[i], p)); e <= best) open.emplace(e, level - 1, i);
            continue;
        }
        const auto to = std::min(from + kFan, first_.back());
        for (std::uint32_t s = from, c = curve_of(from); s < to; ++s) {
            while (s >= first_[c + 1]) ++c;
            if (!skip.empty() && skip[c] != 0) continue;
            const double e = geom::point_segment_distance(points_[s + c], points_[s + c + 1], p);
            if (e < best || (e == best && (!found || s < *found))) {
                best = e;
                found = s;
            }
        }
    }
    if (!found) return std::nullopt;
    const auto [a, b] = ends(*found);
    return place(*found, geom::nearest_parameter(a, b, p), p);
}

void SegmentIndex::within(const Box2& box, const std::function<bool(std::uint32_t, Vec2, Vec2)>& visit) const {
    if (empty()) return;
    std::vector<std::pair<std::size_t, std::uint32_t>> open{{levels_.size() - 1, 0U}}; // a stack: ascending order
    while (!open.empty()) {
        const auto [level, at] = open.back();
        open.pop_back();
        if (!meet(levels_[level][at], box)) continue;
        const std::uint32_t from = at * kFan;
        if (level > 0) {
            const auto to = std::min<std::uint32_t>(from + kFan, static_cast<std::uint32_t>(levels_[level - 1].size()));
            for (std::uint32_t i = to; i-- > from;) open.emplace_back(level - 1, i);
            continue;
        }
        const auto to = std::min(from + kFan, first_.back());
        for (std::uint32_t s = from, c = curve_of(from); s < to; ++s) {
            while (s >= first_[c + 1]) ++c;
            Box2 own;
            own.add(points_[s + c]);
            own.add(points_[s + c + 1]);
            if (meet(own, box) && !visit(s, points_[s + c], points_[s + c + 1])) return;
        }
    }
}

bool is_free(const SegmentIndex& index, Vec2 a, Vec2 b, double margin, double skip_a, double skip_b) {
    const double length = geom::distance(a, b);
    if (length <= skip_a + skip_b) return true;
    const Vec2 p = geom::lerp(a, b, skip_a / length), q = geom::lerp(b, a, skip_b / length);
    Box2 box;
    box.add(p);
    box.add(q);
    box.lo = box.lo - Vec2{margin, margin};
    box.hi = box.hi + Vec2{margin, margin};
    bool free = true;
    index.within(box,
                 [&](std::uint32_t, Vec2 c, Vec2 d) { return free = geom::segment_distance(p, q, c, d) > margin; });
    return free;
}

} // namespace filum::link3d
