#include "surfpath/plan/path_segments.hpp"

#include <algorithm>
#include <array>

namespace filum::surfpath::plan {

namespace {

std::vector<PathSegment> listed(const Surface& s, const Plan& plan) {
    std::vector<PathSegment> out;
    std::size_t count = 0;
    for (const Stroke& stroke : plan.strokes)
        for (const Section& piece : stroke.sections) count += piece.line.size();
    out.reserve(count);
    double arc = 0;
    for (const Stroke& stroke : plan.strokes) {
        for (const Section& piece : stroke.sections)
            for (std::size_t i = 0; i + 1 < piece.line.size(); ++i) {
                const Vec3 &a = piece.line[i], &b = piece.line[i + 1];
                out.push_back({a, b, surface::normal(s, piece.line.places[i].triangle), arc, piece.hairpin,
                               static_cast<std::uint32_t>(&stroke - plan.strokes.data()),
                               piece.widths.empty() ? 0 : (piece.widths[i] + piece.widths[i + 1]) / 2});
                arc += distance(a, b);
            }
        arc += kStrokesApart;
    }
    return out;
}

std::vector<geom::Box3> boxes_of(const std::vector<PathSegment>& all) {
    std::vector<geom::Box3> out;
    out.reserve(all.size());
    for (const PathSegment& l : all) out.push_back(geom::box_of(std::array{l.a, l.b}));
    return out;
}

} // namespace

PathSegments::PathSegments(const Surface& s, const Plan& plan) : all_(listed(s, plan)), tree_(boxes_of(all_)) {}

void PathSegments::in_box(const geom::Box3& box, const Vec3& normal, std::vector<const PathSegment*>& out) const {
    out.clear();
    tree_.visit(box, [&](std::uint32_t k) {
        if (dot(normal, all_[k].normal) > 0) out.push_back(&all_[k]);
    });
}

std::size_t passes(std::vector<double>& arcs, double width) {
    std::sort(arcs.begin(), arcs.end());
    std::size_t out = arcs.empty() ? 0 : 1;
    for (std::size_t i = 1; i < arcs.size(); ++i) out += arcs[i] - arcs[i - 1] > width ? 1 : 0;
    return out;
}

} // namespace filum::surfpath::plan
