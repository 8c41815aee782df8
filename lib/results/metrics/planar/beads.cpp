#include "metrics/planar/beads.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::planar {

namespace {

constexpr double kShort = 1e-6; // mm
constexpr double kAlike = 1e-6; // of a layer's height

struct Segment {
    geom::Vec3 a, b;
    double section = 0; // mm2
    double height = 0;  // mm, as the span states
    std::uint32_t layer = 0, region = 0;
    toolpath::Role role = toolpath::Role::bead;
};

// The layer that contains the upper end of a segment; the top one for anything above. Horizontal segments have a
// tolerance of a thousandth of a layer; rising ones, as turns of a helix that rise by less than that, belong to the
// layer to which they rise.
const LayerMark& mark_of(const std::vector<LayerMark>& marks, const Segment& s, bool& above) {
    const double z = std::max(s.a.z, s.b.z), forgiven = s.a.z == s.b.z ? 1e-3 : 1e-9;
    const auto it = std::lower_bound(marks.begin(), marks.end(), z,
                                     [&](const LayerMark& m, double v) { return m.z + m.height * forgiven < v; });
    above = it == marks.end();
    return above ? marks.back() : *it;
}

void add(LayerBeads& to, const geom::Vec3& p) {
    if (to.points.empty()) to.first_z = p.z;
    if (!to.z.empty() || p.z != to.first_z) {
        to.z.resize(to.points.size(), static_cast<float>(to.first_z));
        to.z.push_back(static_cast<float>(p.z));
    }
    to.points.push_back(p.xy());
    to.width.push_back(0);
}

void add(Beads& beads, const Segment& s) {
    const bool moves = geom::distance(s.a.xy(), s.b.xy()) > kShort;
    if (!moves) {
        if (s.a == beads.at) beads.at = s.b; // a lift without beads does not interrupt
        return;
    }
    std::uint32_t layer = s.layer;
    double height = s.height;
    std::uint8_t layers = 1;
    if (!beads.marks.empty()) {
        bool above = false;
        const LayerMark& mark = mark_of(beads.marks, s, above);
        layer = mark.index;
        height = mark.height;
        if (const auto high = beads.layers.find(s.region); high != beads.layers.end()) layers = high->second;
        beads.misplaced += above ? 1 : 0;
    }
    LayerBeads& to = beads.layer[layer];
    to.height = std::max(to.height, height);
    const bool follows = beads.moving && s.a == beads.at && layer == beads.last_layer && s.region == beads.last_region;
    height *= layers;
    if (!follows || to.runs.empty() || to.runs.back().role != s.role) {
        to.runs.push_back(
            {static_cast<std::uint32_t>(to.points.size()), s.region, beads.segments, s.role, follows, layers});
        add(to, s.a);
    }
    to.width.back() = static_cast<float>(s.section / s.height);
    if (std::abs(s.height - height) > kAlike * height) {
        to.thick.resize(to.points.size(), 1);
        to.thick.back() = static_cast<float>(s.height / height);
    }
    add(to, s.b);
    ++beads.segments;
    beads.at = s.b;
    beads.last_layer = layer;
    beads.last_region = s.region;
    beads.moving = true;
}

} // namespace

std::vector<LayerMark> layer_marks(const std::vector<polygon::Region>& regions) {
    std::map<std::uint32_t, LayerMark> by_index;
    for (const auto& r : regions) by_index.try_emplace(r.layer, LayerMark{r.layer, r.z, r.height / r.layers});
    std::vector<LayerMark> out;
    out.reserve(by_index.size());
    for (const auto& [index, mark] : by_index) out.push_back(mark);
    std::stable_sort(out.begin(), out.end(), [](const LayerMark& a, const LayerMark& b) { return a.z < b.z; });
    return out;
}

std::map<std::uint32_t, std::uint8_t> high_regions(const std::vector<polygon::Region>& regions) {
    std::map<std::uint32_t, std::uint8_t> out;
    for (const auto& r : regions)
        if (r.layers > 1) out.emplace(r.id, static_cast<std::uint8_t>(r.layers));
    return out;
}

void add(Beads& beads, const toolpath::Span& span) {
    if (!toolpath::extrudes(span.role)) {
        beads.moving = false;
        return;
    }
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        const double section =
            (span.width_at(i) * span.height_at(i) + span.width_at(i + 1) * span.height_at(i + 1)) / 2;
        const double height = (span.height_at(i) + span.height_at(i + 1)) / 2;
        add(beads, {span.points[i], span.points[i + 1], section, height, span.layer, span.region, span.role});
    }
}

void add(Beads& beads, const toolpath::RegionPaths& paths) {
    for (const auto& c : paths.curves) {
        beads.moving = false;
        const std::size_t n = c.points.size();
        for (std::size_t i = 0; i + 1 < n + (c.closed ? 1 : 0); ++i) {
            const std::size_t j = (i + 1) % n;
            const double section = (c.width_at(i) + c.width_at(j)) / 2 * paths.height;
            const geom::Vec3 a{c.points[i].x, c.points[i].y, paths.z}, b{c.points[j].x, c.points[j].y, paths.z};
            add(beads, {a, b, section, paths.height, paths.layer, paths.region, toolpath::Role::bead});
        }
    }
}

} // namespace filum::metrics::planar
