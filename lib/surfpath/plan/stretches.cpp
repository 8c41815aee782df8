#include "surfpath/plan/stretches.hpp"

#include <algorithm>
#include <array>

namespace filum::surfpath::plan {

namespace {

std::vector<Stretch> listed(const Surface& s, const Plan& plan) {
    constexpr double kApart = 1e6; // mm
    std::vector<Stretch> out;
    std::size_t count = 0;
    for (const Stroke& stroke : plan.strokes)
        for (const Piece& piece : stroke.pieces) count += piece.line.size();
    out.reserve(count);
    double way = 0;
    for (const Stroke& stroke : plan.strokes) {
        for (const Piece& piece : stroke.pieces)
            for (std::size_t i = 0; i + 1 < piece.line.size(); ++i) {
                const Vec3 &a = piece.line[i], &b = piece.line[i + 1];
                out.push_back({a, b, surface::normal(s, piece.line.places[i].triangle), way, piece.hairpin,
                               static_cast<std::uint32_t>(&stroke - plan.strokes.data())});
                way += distance(a, b);
            }
        way += kApart;
    }
    return out;
}

std::vector<geom::Box3> boxes_of(const std::vector<Stretch>& all) {
    std::vector<geom::Box3> out;
    out.reserve(all.size());
    for (const Stretch& l : all) out.push_back(geom::box_of(std::array{l.a, l.b}));
    return out;
}

} // namespace

Stretches::Stretches(const Surface& s, const Plan& plan) : all_(listed(s, plan)), tree_(boxes_of(all_)) {}

void Stretches::about(const geom::Box3& box, const Vec3& normal, std::vector<const Stretch*>& out) const {
    out.clear();
    tree_.visit(box, [&](std::uint32_t k) {
        if (dot(normal, all_[k].normal) > 0) out.push_back(&all_[k]);
    });
}

std::size_t passes(std::vector<double>& ways, double width) {
    std::sort(ways.begin(), ways.end());
    std::size_t out = ways.empty() ? 0 : 1;
    for (std::size_t i = 1; i < ways.size(); ++i) out += ways[i] - ways[i - 1] > width ? 1 : 0;
    return out;
}

} // namespace filum::surfpath::plan
