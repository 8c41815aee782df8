#include "link3d/features.hpp"

#include <algorithm>
#include <utility>

namespace filum::link3d {

namespace {

// Points `first` to `last` of the span, both included.
toolpath::Span piece_of(const toolpath::Span& s, std::size_t first, std::size_t last) {
    const auto cut = [&](const auto& from) {
        using List = std::remove_cvref_t<decltype(from)>;
        if (from.size() <= 1) return from;
        return List(from.begin() + static_cast<std::ptrdiff_t>(first),
                    from.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    };
    toolpath::Span out{s.role, s.stroke, s.layer, s.region, cut(s.points), cut(s.width), cut(s.height)};
    out.tool = s.tool;
    return out;
}

// A stretch of one feature that is shorter than the bead is wide takes the feature of the stretch before it. At the
// beginning of the bead it takes that of the next long stretch.
void extend_long(const toolpath::Span& s, std::vector<toolpath::Feature>& feature) {
    std::size_t known = 0; // segments at the beginning in short stretches only
    for (std::size_t i = 0, j = 0; i < feature.size(); i = j) {
        double length = 0;
        for (j = i; j < feature.size() && feature[j] == feature[i]; ++j)
            length += geom::distance(s.points[j], s.points[j + 1]);
        if (length < s.width_at(i) && i > 0)
            std::fill(feature.begin() + static_cast<std::ptrdiff_t>(i),
                      feature.begin() + static_cast<std::ptrdiff_t>(j), feature[i - 1]);
        else if (length < s.width_at(i) && j < feature.size())
            known = j;
        else if (known > 0)
            std::fill_n(feature.begin(), std::exchange(known, 0), feature[i]);
    }
}

} // namespace

void emit_by_feature(toolpath::Span bead, std::span<const toolpath::Curve> curves, const SegmentIndex& index,
                     const std::function<void(const toolpath::Span&)>& emit) {
    if (std::all_of(curves.begin(), curves.end(), [](const toolpath::Curve& c) { return c.feature.empty(); }))
        return emit(bead);
    std::vector<toolpath::Feature> feature;
    std::vector<std::uint8_t> over_air; // percent
    std::optional<Place> at;
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
        at = index.follow(geom::lerp(bead.points[i].xy(), bead.points[i + 1].xy(), 0.5), at);
        feature.push_back(at ? curves[at->curve].feature_at(at->segment) : toolpath::Feature::none);
        over_air.push_back(at ? curves[at->curve].over_air_at(at->segment) : std::uint8_t{0});
    }
    extend_long(bead, feature);
    for (std::size_t i = 0, j = 0; i < feature.size(); i = j) {
        for (j = i; j < feature.size() && feature[j] == feature[i] && over_air[j] == over_air[i];) ++j;
        toolpath::Span piece = piece_of(bead, i, j);
        piece.feature = feature[i];
        piece.over_air = over_air[i];
        emit(piece);
    }
}

} // namespace filum::link3d
