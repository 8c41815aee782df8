#include "fill/medial_axis.hpp"

#include "base/error.hpp"
#include "geom/segment.hpp"

#include <boost/polygon/voronoi.hpp>

#include <cmath>

namespace filum::fill {

namespace {

constexpr double kScale = 1e4; // grid units per mm

struct Site { // one segment of the outline, in grid units about the middle
    std::int32_t x0, y0, x1, y1;
    bool reflex; // the solid's corner at (x0, y0) is larger than 180 degrees
};

using Diagram = boost::polygon::voronoi_diagram<double>;

std::vector<Site> sites_of(const Loops& area, Vec2 middle) {
    std::vector<Site> out;
    for (std::size_t i = 0; i < area.size(); ++i) {
        std::vector<std::pair<std::int32_t, std::int32_t>> grid;
        for (const Vec2 p : area[i]) {
            const auto x = static_cast<std::int32_t>(std::lround((p.x - middle.x) * kScale));
            const auto y = static_cast<std::int32_t>(std::lround((p.y - middle.y) * kScale));
            if (grid.empty() || grid.back() != std::pair{x, y}) grid.emplace_back(x, y);
        }
        while (grid.size() > 1 && grid.back() == grid.front()) grid.pop_back();
        const std::size_t n = grid.size();
        if (n < 3) continue;
        for (std::size_t k = 0; k < n; ++k) {
            const auto [px, py] = grid[(k + n - 1) % n];
            const auto [x, y] = grid[k];
            const auto [qx, qy] = grid[(k + 1) % n];
            const double turn = (static_cast<double>(x) - px) * (static_cast<double>(qy) - y) -
                                (static_cast<double>(y) - py) * (static_cast<double>(qx) - x);
            out.push_back({x, y, qx, qy, turn < 0});
        }
    }
    return out;
}

class Axis {
  public:
    Axis(const Loops& area, double step) : step_(step) {
        const auto box = polygon::bounds(area);
        middle_ = 0.5 * (box.lo + box.hi);
        if (std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y) * kScale / 2 > 2e9)
            throw Error(Exit::failure, "cannot fill a region wider than 400 m");
        sites_ = sites_of(area, middle_);
    }

    MedialAxis run() {
        Diagram diagram;
        boost::polygon::default_voronoi_builder builder;
        for (const Site& s : sites_) builder.insert_segment(s.x0, s.y0, s.x1, s.y1);
        builder.construct(&diagram);
        std::size_t index = 0;
        for (const auto& v : diagram.vertices()) v.color(index++);
        vertex_.assign(index, kNew);
        for (const auto& e : diagram.edges()) {
            if (!e.is_primary() || e.is_infinite() || &e > e.twin()) continue;
            if (inside(e)) add(e);
        }
        return std::move(out_);
    }

  private:
    static constexpr std::uint32_t kNew = 0xffffffff;

    [[nodiscard]] Vec2 begin_of(const Site& s) const { return {static_cast<double>(s.x0), static_cast<double>(s.y0)}; }
    [[nodiscard]] Vec2 end_of(const Site& s) const { return {static_cast<double>(s.x1), static_cast<double>(s.y1)}; }

    // Distance from p (grid units) to what the cell belongs to.
    [[nodiscard]] double distance(const Diagram::cell_type& cell, Vec2 p) const {
        const Site& s = sites_[cell.source_index()];
        if (cell.contains_segment()) return geom::point_segment_distance(begin_of(s), end_of(s), p);
        const bool start = cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
        return geom::distance(start ? begin_of(s) : end_of(s), p);
    }

    // Whether the edge lies in the solid: left of a segment it belongs to, or about a reflex corner.
    [[nodiscard]] bool inside(const Diagram::edge_type& e) const {
        const Vec2 mid{(e.vertex0()->x() + e.vertex1()->x()) / 2, (e.vertex0()->y() + e.vertex1()->y()) / 2};
        for (const auto* cell : {e.cell(), e.twin()->cell()}) {
            if (!cell->contains_segment()) continue;
            const Site& s = sites_[cell->source_index()];
            return geom::orient(begin_of(s), end_of(s), mid) > 0;
        }
        return reflex(*e.cell());
    }

    [[nodiscard]] bool reflex(const Diagram::cell_type& cell) const {
        const std::size_t i = cell.source_index();
        if (cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT) return sites_[i].reflex;
        const Site& s = sites_[i]; // its end is the start of the segment after it
        for (const std::size_t k : {i + 1, i + 1 - loop_length(i)})
            if (k < sites_.size() && sites_[k].x0 == s.x1 && sites_[k].y0 == s.y1) return sites_[k].reflex;
        return false;
    }

    // Number of segments of the loop that ends with segment i (only asked for the last of a loop).
    [[nodiscard]] std::size_t loop_length(std::size_t i) const {
        std::size_t n = 1;
        while (n <= i && sites_[i - n].x1 == sites_[i - n + 1].x0 && sites_[i - n].y1 == sites_[i - n + 1].y0) {
            if (sites_[i - n].x0 == sites_[i].x1 && sites_[i - n].y0 == sites_[i].y1) return n + 1;
            ++n;
        }
        return n;
    }

    std::uint32_t vertex(const Diagram::vertex_type& v, const Diagram::cell_type& cell) {
        std::uint32_t& known = vertex_[v.color()];
        if (known == kNew) known = add_point({v.x(), v.y()}, distance(cell, {v.x(), v.y()}));
        return known;
    }

    std::uint32_t add_point(Vec2 p, double radius) {
        out_.point.push_back(middle_ + (1 / kScale) * p);
        out_.radius.push_back(radius / kScale);
        return static_cast<std::uint32_t>(out_.point.size() - 1);
    }

    void add(const Diagram::edge_type& e) {
        const Vec2 p{e.vertex0()->x(), e.vertex0()->y()}, q{e.vertex1()->x(), e.vertex1()->y()};
        std::uint32_t from = vertex(*e.vertex0(), *e.cell());
        const std::uint32_t to = vertex(*e.vertex1(), *e.cell());
        const int n = e.is_curved() ? std::max(2, static_cast<int>(geom::distance(p, q) / (step_ * kScale)) + 1) : 1;
        for (int k = 1; k < n; ++k) {
            const Vec2 m = on_axis(e, geom::lerp(p, q, static_cast<double>(k) / n));
            const std::uint32_t next = add_point(m, std::min(distance(*e.cell(), m), distance(*e.twin()->cell(), m)));
            connect(from, next);
            from = next;
        }
        connect(from, to);
    }

    void connect(std::uint32_t a, std::uint32_t b) { out_.a.push_back(a), out_.b.push_back(b); }

    // The point of a parabolic edge above (or below) the chord's point m: equally far from corner and segment.
    [[nodiscard]] Vec2 on_axis(const Diagram::edge_type& e, Vec2 m) const {
        const bool first = e.cell()->contains_segment();
        const Site& s = sites_[(first ? e.cell() : e.twin()->cell())->source_index()];
        const auto& corner_cell = first ? *e.twin()->cell() : *e.cell();
        const Site& c = sites_[corner_cell.source_index()];
        const bool start = corner_cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
        const Vec2 focus = start ? begin_of(c) : end_of(c), a = begin_of(s), u = end_of(s) - a;
        const double l = geom::norm(u);
        const Vec2 t = (1 / l) * u, n = geom::left_of(t);
        const double x = geom::dot(m - focus, t), h = geom::dot(focus - a, n); // height of the corner over the line
        if (std::abs(h) < 1e-9) return m;
        const double y = (x * x + h * h) / (2 * h); // over the line
        return a + geom::dot(m - a, t) * t + y * n;
    }

    double step_;
    Vec2 middle_;
    std::vector<Site> sites_;
    std::vector<std::uint32_t> vertex_;
    MedialAxis out_;
};

} // namespace

MedialAxis medial_axis(const Loops& area, double step) { return Axis(area, step).run(); }

MedialAxis split_at(const MedialAxis& axis, double radius) {
    MedialAxis out{axis.point, axis.radius, {}, {}};
    const auto connect = [&](std::uint32_t a, std::uint32_t b) { out.a.push_back(a), out.b.push_back(b); };
    for (std::size_t k = 0; k < axis.a.size(); ++k) {
        const auto a = axis.a[k], b = axis.b[k];
        const double ra = axis.radius[a], rb = axis.radius[b];
        if ((ra < radius) == (rb < radius) || ra == radius || rb == radius) {
            connect(a, b);
            continue;
        }
        const auto between = static_cast<std::uint32_t>(out.point.size());
        out.point.push_back(geom::lerp(axis.point[a], axis.point[b], (radius - ra) / (rb - ra)));
        out.radius.push_back(radius);
        connect(a, between);
        connect(between, b);
    }
    return out;
}

} // namespace filum::fill
