#include "fill/hollow/over_air.hpp"

#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "polygon/inside_test.hpp"
#include "polygon/segments.hpp"
#include "toolpath/grid.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill::hollow {

namespace {

using geom::Vec2;
using polygon::kBeadArc;
using polygon::Loops;
using toolpath::Curve;
using toolpath::Feature;

constexpr double kShareStep = 5; // percent of a bead's width over air

// The bottom surfaces of a region.
Loops bottoms(const polygon::Region& r) {
    Loops out;
    for (const polygon::Area& a : r.areas)
        if (a.kind == polygon::AreaKind::skin_bottom) out.add(a.loops);
    return out;
}

// The part of a region that the layer below carries; empty if that is nothing.
Loops carried(const polygon::Region& r, const Loops& bottom, double w) {
    return polygon::opened_difference(r.loops, bottom, w / 4, kBeadArc);
}

// The area whose walls are carried; empty if all of them are.
Loops carried_walls(const polygon::Region& r, double w) {
    const Loops bottom = bottoms(r);
    // The middle of a wall over air is half a bead from the outline and from what is carried.
    if (bottom.empty() || polygon::offset(bottom, -w / 2, kBeadArc).empty()) return {};
    const Loops rest = carried(r, bottom, w);
    return rest.empty() ? Loops{} : polygon::offset(rest, w / 2, kBeadArc);
}

bool is_wall(Feature f) { return f == Feature::wall || f == Feature::outer_wall; }

// A piece of a segment, from a share of its length to the next piece.
struct Piece {
    double from = 0;
    Feature feature = Feature::none;
    std::uint8_t over_air = 0; // percent
};

// Cuts the segments of walls into pieces; `pieces(c, i)` gives those of segment i, in their order.
template <class Pieces>
void cut_walls(Curve& c, const Pieces& pieces) {
    Curve out{c.closed, {}, {}};
    const std::size_t n = c.feature.size();
    const bool widths = c.width.size() == c.points.size();
    const auto put = [&](Vec2 p, double width, const Piece& piece) {
        out.points.push_back(p);
        if (widths) out.width.push_back(width);
        out.feature.push_back(piece.feature);
        out.over_air.push_back(piece.over_air);
    };
    bool any = false;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % c.points.size();
        const Vec2 a = c.points[i], b = c.points[next];
        if (!is_wall(c.feature[i])) {
            put(a, c.width_at(i), {0, c.feature[i], c.over_air_at(i)});
            continue;
        }
        for (const Piece& piece : pieces(c, i)) {
            const Vec2 p = piece.from == 0 ? a : toolpath::on_grid(geom::lerp(a, b, piece.from));
            put(p, std::lerp(c.width_at(i), c.width_at(next), piece.from), piece);
            any = any || piece.over_air > 0;
        }
    }
    if (!c.closed) {
        out.points.push_back(c.points.back());
        if (widths) out.width.push_back(c.width.back());
    }
    if (widths) c.width = std::move(out.width);
    c.points = std::move(out.points);
    c.feature = std::move(out.feature);
    if (any || !c.over_air.empty()) c.over_air = std::move(out.over_air);
}

// An area, and where its edges are.
class OutlinedArea {
  public:
    OutlinedArea(const Loops& area, double w)
        : inside_(area), edge_(polygon::segments(area)), grid_(edge_, geom::cell_for(edge_, 2 * w)) {}

    [[nodiscard]] bool contains(Vec2 p) const { return inside_(p); }
    // mm from p to the nearest edge, at most `most`
    [[nodiscard]] double distance(Vec2 p, double most) const {
        double out = most;
        grid_.near({p.x - most, p.y - most}, {p.x + most, p.y + most}, [&](std::uint32_t k) {
            out = std::min(out, geom::point_segment_distance(edge_[k].a, edge_[k].b, p));
        });
        return out;
    }
    // The shares of the way from a to b at which it crosses an edge, in no order.
    [[nodiscard]] std::vector<double> crossings(Vec2 a, Vec2 b) const {
        std::vector<double> out;
        grid_.near({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                   [&](std::uint32_t k) {
                       const auto hit = geom::ray_parameters(a, b - a, edge_[k].a, edge_[k].b);
                       if (hit && hit->t < 1) out.push_back(hit->t);
                   });
        return out;
    }

  private:
    polygon::InsideTest inside_;
    std::vector<geom::Segment> edge_;
    geom::SegmentGrid grid_;
};

class WallsOverAir {
  public:
    WallsOverAir(const Loops& carried, double w) : w_(w), carried_(carried, w) {}

    // The pieces of segment i of `c`, cut where it passes the edge of what is carried. Pieces shorter than a bead
    // belong to the one before.
    [[nodiscard]] std::vector<Piece> pieces(const Curve& c, std::size_t i) const {
        const Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
        const double length = geom::distance(a, b);
        std::vector<double> cuts = length > w_ ? carried_.crossings(a, b) : std::vector<double>{};
        cuts.insert(cuts.end(), {0, 1});
        std::ranges::sort(cuts);
        std::vector<Piece> out;
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const bool over_air = !carried_.contains(geom::lerp(a, b, (cuts[k] + cuts[k + 1]) / 2));
            const bool is_short = (cuts[k + 1] - cuts[k]) * length < w_;
            const Feature feature = over_air ? Feature::bridge : c.feature[i];
            if (out.empty() || (!is_short && feature != out.back().feature))
                out.push_back({cuts[k], feature, c.over_air_at(i)});
        }
        return out;
    }

  private:
    double w_; // mm, width of a bead
    OutlinedArea carried_;
};

class Overhangs {
  public:
    Overhangs(const Loops& bottom, const Loops& carried, double w) : w_(w), bottom_(bottom, w), carried_(carried, w) {}

    [[nodiscard]] std::vector<Piece> pieces(const Curve& c, std::size_t i) {
        const std::size_t next = (i + 1) % c.points.size();
        const Vec2 a = c.points[i], b = c.points[next];
        const auto n = static_cast<std::size_t>(std::max(1.0, std::floor(geom::distance(a, b) / (2 * w_))));
        std::vector<Piece> out;
        for (std::size_t k = 0; k < n; ++k) {
            const double from = static_cast<double>(k) / static_cast<double>(n),
                         middle = from + 0.5 / static_cast<double>(n);
            const double percent =
                100 * share(geom::lerp(a, b, middle), std::lerp(c.width_at(i), c.width_at(next), middle));
            // A share near the border of two steps keeps that of the segment before.
            if (std::abs(percent - last_) >= kShareStep || percent == 0 || percent == 100)
                last_ = kShareStep * std::round(percent / kShareStep);
            const auto over_air = static_cast<std::uint8_t>(last_);
            if (out.empty() || out.back().over_air != over_air) out.push_back({from, c.feature[i], over_air});
        }
        return out;
    }

  private:
    // The share over air of a bead with its middle at p: over the bottom surface, whose other edges are those of the
    // region. A middle that is carried is as far from the air as from the bottom surface, and one over air as far from
    // what is carried.
    [[nodiscard]] double share(Vec2 p, double width) const {
        const double half = width / 2;
        if (!(half > 0)) return 0;
        if (!bottom_.contains(p)) return (half - bottom_.distance(p, half)) / width;
        return (half + carried_.distance(p, half)) / width;
    }

    double w_;        // mm, width of a bead
    double last_ = 0; // percent, of the segment before
    OutlinedArea bottom_, carried_;
};

} // namespace

void mark_walls_over_air(const polygon::Region& r, double bead_width, std::vector<Curve>& curves) {
    const Loops area = carried_walls(r, bead_width);
    if (area.empty()) return;
    const WallsOverAir walls(area, bead_width);
    for (Curve& c : curves) cut_walls(c, [&](const Curve& curve, std::size_t i) { return walls.pieces(curve, i); });
}

void measure_overhangs(const polygon::Region& r, double bead_width, std::vector<Curve>& curves) {
    const Loops bottom = bottoms(r);
    if (bottom.empty()) return;
    const Loops rest = carried(r, bottom, bead_width);
    if (rest.empty()) return;
    Overhangs overhangs(bottom, rest, bead_width);
    for (Curve& c : curves) cut_walls(c, [&](const Curve& curve, std::size_t i) { return overhangs.pieces(curve, i); });
}

} // namespace filum::fill::hollow
