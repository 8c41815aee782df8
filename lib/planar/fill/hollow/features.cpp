#include "fill/hollow/features.hpp"

#include "geom/segment_grid.hpp"
#include "polygon/inside_test.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill::hollow {

namespace {

using geom::Vec2;
using polygon::Region;
using toolpath::Feature;

constexpr double kSame = 0.01; // mm: distances that differ by less count as the same

// Finds the points of a region that lie on a top surface.
class TopSkin {
  public:
    explicit TopSkin(const Region& r) {
        for (const polygon::Area& a : r.areas)
            if (a.kind == polygon::AreaKind::skin_top) inside_.emplace_back(a.loops);
    }
    [[nodiscard]] bool holds(Vec2 p) const {
        return std::any_of(inside_.begin(), inside_.end(), [&](const auto& inside) { return inside(p); });
    }

  private:
    std::vector<polygon::InsideTest> inside_; // of each area
};

// The feature at p in a region that is not of the part: skirt, support or interface.
Feature feature_beside(const Region& r, const TopSkin& top, Vec2 p) {
    if (r.is == polygon::RegionClass::rim) return Feature::skirt;
    return top.holds(p) ? Feature::interface : Feature::support;
}

// Finds the loop nearest to a point.
class NearestLoop {
  public:
    struct Hit {
        Feature feature;
        double best, same; // mm to the nearest loop, and to the nearest one with the requested feature
    };

    // `w`: mm; loops farther away do not count.
    NearestLoop(const LooseCurves& from, double w)
        : from_(&from), w_(w), segments_(polygon::segments(polygon::Loops{from.rings.points, from.rings.start})),
          grid_(segments_, geom::cell_for(segments_, 1.5 * w)) {
        for (std::uint32_t l = 0; l < from.rings.size(); ++l) loop_of_.resize(from.rings.start[l + 1], l);
    }
    // Distances are exact where one is less than kSame more than the other; else `same` may be larger.
    [[nodiscard]] Hit operator()(Vec2 p, Feature wanted) const {
        const double few = w_ / 4; // curves lie on their loops except at corners and links
        const Hit hit = within(p, few, wanted);
        return hit.best + kSame <= few ? hit : within(p, w_, wanted);
    }

  private:
    [[nodiscard]] Hit within(Vec2 p, double reach, Feature wanted) const {
        Hit out{Feature::solid, 4 * w_ * w_, 4 * w_ * w_}; // squares, until all segments are measured
        grid_.near(p - Vec2{reach, reach}, p + Vec2{reach, reach}, [&](std::uint32_t k) {
            const double d2 = geom::norm2(geom::nearest_point(segments_[k].a, segments_[k].b, p) - p);
            const Feature feature = from_->feature[loop_of_[k]];
            if (feature == wanted) out.same = std::min(out.same, d2);
            if (d2 < out.best) {
                out.best = d2;
                out.feature = feature;
            }
        });
        return {out.feature, std::sqrt(out.best), std::sqrt(out.same)};
    }

    const LooseCurves* from_;
    double w_;
    std::vector<geom::Segment> segments_;
    std::vector<std::uint32_t> loop_of_;
    geom::SegmentGrid grid_;
};

} // namespace

void tell_features(const Region& r, const LooseCurves& from, double w, std::vector<toolpath::Curve>& curves) {
    const NearestLoop nearest(from, w);
    const TopSkin top(r);
    for (auto& c : curves) {
        Feature last = Feature::solid; // of the loop of the segment before
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const Vec2 p = geom::lerp(c.points[i], c.points[(i + 1) % c.points.size()], 0.5);
            if (r.is != polygon::RegionClass::part) {
                c.feature.push_back(feature_beside(r, top, p));
                continue;
            }
            if (i > 0 && geom::distance(c.points[i], p) < kSame / 2) {
                c.feature.push_back(c.feature.back()); // a link ends in a piece as short as this
                continue;
            }
            const NearestLoop::Hit hit = nearest(p, last);
            if (i == 0 || hit.same - hit.best >= kSame) last = hit.feature; // else halfway on a link
            c.feature.push_back(last == Feature::solid && top.holds(p) ? Feature::top : last);
        }
    }
}

} // namespace filum::fill::hollow
