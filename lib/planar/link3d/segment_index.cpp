#include "link3d/segment_index.hpp"

#include "geom/segment.hpp"
#include "toolpath/grid.hpp"

#include <algorithm>

namespace filum::link3d {

namespace {

constexpr double kOnSegment = 1e-6; // mm; a point closer than this lies on the segment
constexpr double kLeastCell = 0.01; // mm; segments of the grid are no finer in general

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
    for (const Vec2 p : points_) bounds_.add(p);
    std::vector<geom::CapsuleTree::Segment> segments;
    segments.reserve(count);
    for (std::size_t c = 0; c + 1 < first_.size(); ++c)
        for (std::uint32_t s = first_[c]; s < first_[c + 1]; ++s)
            segments.emplace_back(points_[s + c], points_[s + c + 1]);
    tree_ = geom::CapsuleTree(segments);
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
    double best = limit;
    std::optional<std::uint32_t> found;
    tree_.near(p, best, [&](const geom::CapsuleTree::Run& run) {
        auto s = static_cast<std::uint32_t>(run.first);
        for (std::uint32_t c = curve_of(s); s < run.last; ++s) {
            while (s >= first_[c + 1]) ++c;
            if (!skip.empty() && skip[c] != 0) continue;
            const double e = geom::point_segment_distance(points_[s + c], points_[s + c + 1], p);
            if (e < best || (e == best && (!found || s < *found))) {
                best = e;
                found = s;
            }
        }
        return best;
    });
    if (!found) return std::nullopt;
    const auto [a, b] = ends(*found);
    return place(*found, geom::nearest_parameter(a, b, p), p);
}

std::optional<Place> SegmentIndex::follow(Vec2 p, const std::optional<Place>& last) const {
    constexpr std::int64_t kBeside = 2;
    if (last) {
        const std::int64_t first = first_[last->curve], count = first_[last->curve + 1] - first;
        const bool closed = points_[first + last->curve] == points_[first + count + last->curve];
        for (std::int64_t k = 0; k <= 2 * kBeside; ++k) { // the segment itself, then one ahead, one behind, and so on
            std::int64_t i = last->segment + (k % 2 == 0 ? -k / 2 : (k + 1) / 2);
            if (closed) i = ((i % count) + count) % count;
            if (i < 0 || i >= count) continue;
            const auto at = static_cast<std::size_t>(first + i + last->curve);
            if (geom::point_segment_distance(points_[at], points_[at + 1], p) > kOnSegment) continue;
            return place(static_cast<std::uint32_t>(first + i),
                         geom::nearest_parameter(points_[at], points_[at + 1], p), p);
        }
    }
    return nearest(p);
}

void SegmentIndex::within(const Box2& box, const std::function<bool(std::uint32_t, Vec2, Vec2)>& visit) const {
    if (empty()) return;
    tree_.visit(box, [&](const geom::CapsuleTree::Run& run) {
        auto s = static_cast<std::uint32_t>(run.first);
        for (std::uint32_t c = curve_of(s); s < run.last; ++s) {
            while (s >= first_[c + 1]) ++c;
            Box2 own;
            own.add(points_[s + c]);
            own.add(points_[s + c + 1]);
            if (meet(own, box) && !visit(s, points_[s + c], points_[s + c + 1])) return false;
        }
        return true;
    });
}

SegmentCells::SegmentCells(std::span<const toolpath::Curve> curves)
    : segments_(toolpath::segments_of(curves)), cell_(geom::cell_for(segments_, kLeastCell)), grid_(segments_, cell_) {}

void SegmentCells::search(Vec2 p, double limit, std::optional<Nearest>& found) const {
    grid_.near(p - Vec2{limit, limit}, p + Vec2{limit, limit}, [&](std::uint32_t s) {
        const double e = geom::point_segment_distance(segments_[s].a, segments_[s].b, p);
        if (e > limit) return;
        if (!found || e < found->distance || (e == found->distance && s < found->segment)) found = Nearest{s, e};
    });
}

std::optional<SegmentCells::Nearest> SegmentCells::nearest(Vec2 p, double limit) const {
    std::optional<Nearest> found;
    search(p, std::min(limit, cell_), found); // where lines are close together this is enough
    if (!found && limit > cell_) search(p, limit, found);
    return found;
}

bool SegmentCells::is_free(Vec2 a, Vec2 b, double margin) const {
    Box2 box;
    box.add(a - Vec2{margin, margin});
    box.add(a + Vec2{margin, margin});
    box.add(b - Vec2{margin, margin});
    box.add(b + Vec2{margin, margin});
    bool free = true;
    grid_.near(box.lo, box.hi, [&](std::uint32_t s) {
        free = free && geom::segment_distance(a, b, segments_[s].a, segments_[s].b) > margin;
    });
    return free;
}

bool is_free(const SegmentCells& cells, Vec2 a, Vec2 b, double margin, double skip_a, double skip_b) {
    const double length = geom::distance(a, b);
    if (length <= skip_a + skip_b) return true;
    return cells.is_free(geom::lerp(a, b, skip_a / length), geom::lerp(b, a, skip_b / length), margin);
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
