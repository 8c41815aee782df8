#include "fill/hollow/over_air.hpp"

#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "polygon/inside_test.hpp"
#include "polygon/segments.hpp"
#include "toolpath/grid.hpp"

#include <algorithm>

namespace filum::fill::hollow {

namespace {

using geom::Vec2;
using polygon::kBeadArc;
using polygon::Loops;
using toolpath::Curve;
using toolpath::Feature;

// The area whose walls are carried; empty if all of them are.
Loops carried(const polygon::Region& r, double w) {
    Loops bottom;
    for (const polygon::Area& a : r.areas)
        if (a.kind == polygon::AreaKind::skin_bottom) bottom.add(a.loops);
    // The middle of a wall over air is half a bead from the outline and from what is carried.
    if (bottom.empty() || polygon::offset(bottom, -w / 2, kBeadArc).empty()) return {};
    const Loops rest = polygon::opened_difference(r.loops, bottom, w / 4, kBeadArc);
    return rest.empty() ? Loops{} : polygon::offset(rest, w / 2, kBeadArc);
}

bool is_wall(Feature f) { return f == Feature::wall || f == Feature::outer_wall; }

class WallsOverAir {
  public:
    WallsOverAir(const Loops& carried, double w)
        : w_(w), inside_(carried), edge_(polygon::segments(carried)), grid_(edge_, geom::cell_for(edge_, 2 * w)) {}

    void mark(Curve& c) const {
        Curve out{c.closed, {}, {}};
        const std::size_t n = c.feature.size();
        const bool widths = c.width.size() == c.points.size();
        const auto put = [&](Vec2 p, double width, Feature f) {
            out.points.push_back(p);
            if (widths) out.width.push_back(width);
            out.feature.push_back(f);
        };
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t next = (i + 1) % c.points.size();
            const Vec2 a = c.points[i], b = c.points[next];
            if (!is_wall(c.feature[i])) {
                put(a, c.width_at(i), c.feature[i]);
                continue;
            }
            for (const Piece& piece : pieces(a, b)) {
                const Vec2 p = piece.from == 0 ? a : toolpath::on_grid(geom::lerp(a, b, piece.from));
                put(p, std::lerp(c.width_at(i), c.width_at(next), piece.from),
                    piece.over_air ? Feature::bridge : c.feature[i]);
            }
        }
        if (!c.closed) {
            out.points.push_back(c.points.back());
            if (widths) out.width.push_back(c.width.back());
        }
        if (!widths) out.width = c.width;
        c.points = std::move(out.points);
        c.width = std::move(out.width);
        c.feature = std::move(out.feature);
    }

  private:
    struct Piece {
        double from; // share of the segment
        bool over_air;
    };

    // The pieces of a -> b, cut where it passes the edge of what is carried. Pieces shorter than a bead belong to the
    // one before.
    [[nodiscard]] std::vector<Piece> pieces(Vec2 a, Vec2 b) const {
        const double length = geom::distance(a, b);
        std::vector<double> cuts{0, 1};
        if (length > w_)
            grid_.near({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                       [&](std::uint32_t k) {
                           const auto hit = geom::ray_parameters(a, b - a, edge_[k].a, edge_[k].b);
                           if (hit && hit->t < 1) cuts.push_back(hit->t);
                       });
        std::ranges::sort(cuts);
        std::vector<Piece> out;
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const bool over_air = !inside_(geom::lerp(a, b, (cuts[k] + cuts[k + 1]) / 2));
            const bool is_short = (cuts[k + 1] - cuts[k]) * length < w_;
            if (out.empty() || (!is_short && over_air != out.back().over_air)) out.push_back({cuts[k], over_air});
        }
        return out;
    }

    double w_; // mm, width of a bead
    polygon::InsideTest inside_;
    std::vector<geom::Segment> edge_;
    geom::SegmentGrid grid_;
};

} // namespace

void mark_walls_over_air(const polygon::Region& r, double bead_width, std::vector<Curve>& curves) {
    const Loops area = carried(r, bead_width);
    if (area.empty()) return;
    const WallsOverAir walls(area, bead_width);
    for (Curve& c : curves) walls.mark(c);
}

} // namespace filum::fill::hollow
