#include "polygon/voronoi.hpp"

#include "polygon/circles.hpp"

#include <boost/polygon/voronoi.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace filum::polygon {

namespace {

constexpr double kFit = 1; // grid units; vertices are exact to a small share of it, so one off by more is wrong

namespace detail = boost::polygon::detail;
using Usual = detail::voronoi_ctype_traits<std::int32_t>;

// Boost's circles, replaced by those of circles.hpp where 64-bit numbers are exact enough.
template <class Site, class Circle>
struct Circles : detail::voronoi_predicates<Usual>::lazy_circle_formation_functor<Site, Circle> {
    using Base = detail::voronoi_predicates<Usual>::lazy_circle_formation_functor<Site, Circle>;

    void pps(const Site& one, const Site& two, const Site& line, int place, Circle& out) {
        if (!take(touching_circle(at(one.point0()), at(two.point0()), line_of(line), place == 2), out))
            Base::pps(one, two, line, place, out);
    }
    // Passes the first segment from its second end to its first.
    void pss(const Site& point, const Site& one, const Site& two, int place, Circle& out) {
        const SiteLine first{at(one.point1()), at(one.point0())};
        if (!take(touching_circle(at(point.point0()), first, line_of(two), place == 2), out))
            Base::pss(point, one, two, place, out);
    }
    void sss(const Site& one, const Site& two, const Site& three, Circle& out) {
        if (!take(touching_circle(line_of(one), line_of(two), line_of(three)), out)) Base::sss(one, two, three, out);
    }

  private:
    template <class Point>
    static SitePoint at(const Point& p) {
        return {p.x(), p.y()};
    }
    static SiteLine line_of(const Site& site) { return {at(site.point0()), at(site.point1())}; }
    static bool take(const std::optional<SiteCircle>& found, Circle& out) {
        if (found) out = Circle(found->x, found->y, found->right);
        return found.has_value();
    }
};

struct Predicates : detail::voronoi_predicates<Usual> {
    template <class Site, class Circle>
    using circle_formation_predicate =
        detail::voronoi_predicates<Usual>::circle_formation_predicate<Site, Circle, circle_existence_predicate<Site>,
                                                                      Circles<Site, Circle>>;
};

// Records the result of the sweep, edge by edge. Edges never move, because the sweep holds pointers to them.
class Record {
  public:
    struct Edge {
        std::uint32_t from = kNone, prev = kNone, next = kNone, cell = 0;
        bool between_sites = true;
    };

    std::vector<Edge> edge; // the twin of edge e is e ^ 1
    std::vector<Vec2> vertex;
    std::vector<std::uint32_t> segment;
    std::vector<Diagram::Part> part;

    // The functions that boost::polygon::voronoi_builder calls, by its names.
    void _reserve(std::size_t sites) { // three sites for each segment
        edge.reserve(6 * sites);
        vertex.reserve(2 * sites);
        segment.reserve(sites);
        part.reserve(sites);
    }
    template <class Site>
    void _process_single_site(const Site& site) {
        add_cell(site);
    }
    // Adds an edge along which two sites meet; its ends are not known yet.
    template <class Site>
    std::pair<void*, void*> _insert_new_edge(const Site& one, const Site& two) {
        if (part.empty()) add_cell(one);
        add_cell(two);
        const std::uint32_t e = add_edge(one, two);
        return {&edge[e], &edge[e + 1]};
    }
    // Adds a vertex at which the edges `in` and `out` end and an edge between their outer cells begins.
    template <class Site, class Circle>
    std::pair<void*, void*> _insert_new_edge(const Site& one, const Site& three, const Circle& circle, void* in,
                                             void* out) {
        const std::uint32_t e12 = number(in), e23 = number(out), e = add_edge(one, three);
        const auto v = static_cast<std::uint32_t>(vertex.size());
        vertex.push_back({circle.x(), circle.y()});
        edge[e12].from = edge[e23].from = edge[e + 1].from = v;
        follow(e, e12);
        follow(e12 ^ 1U, e23);
        follow(e23 ^ 1U, e + 1);
        return {&edge[e], &edge[e + 1]};
    }
    void _build() {}

  private:
    [[nodiscard]] std::uint32_t number(const void* e) const {
        return static_cast<std::uint32_t>(static_cast<const Edge*>(e) - edge.data());
    }
    void follow(std::uint32_t before, std::uint32_t after) {
        edge[before].next = after;
        edge[after].prev = before;
    }
    template <class Site>
    void add_cell(const Site& site) {
        segment.push_back(static_cast<std::uint32_t>(site.initial_index()));
        const bool first = site.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
        part.push_back(site.is_segment() ? Diagram::Part::segment
                       : first           ? Diagram::Part::first_end
                                         : Diagram::Part::second_end);
    }
    template <class Site>
    static bool is_end(const Site& point, const Site& segment) {
        return !point.is_segment() && segment.is_segment() &&
               (point.point0() == segment.point0() || point.point0() == segment.point1());
    }
    template <class Site>
    std::uint32_t add_edge(const Site& one, const Site& two) {
        const bool between = !is_end(one, two) && !is_end(two, one);
        for (const Site* site : {&one, &two})
            edge.push_back({kNone, kNone, kNone, static_cast<std::uint32_t>(site->sorted_index()), between});
        return static_cast<std::uint32_t>(edge.size()) - 2;
    }
};

// For each segment, the edges between its cell and those of its own ends. Each segment has one at either end. It begins
// there and runs away from the outline, on the side where the outline's angle is larger.
struct EndEdges {
    std::vector<std::uint32_t> first, second;
    bool sound = true; // whether there is one at each end

    EndEdges(const Sites& sites, const Diagram& d) : first(sites.size(), kNone), second(sites.size(), kNone) {
        for (std::uint32_t e = 0; e < d.edges(); ++e) {
            if (d.between_sites[e] || d.part[d.cell[e]] != Diagram::Part::segment) continue;
            const std::uint32_t i = d.segment[d.cell[e]];
            std::uint32_t& place = vertex_of(sites, d, d.cell[e ^ 1U]) == i ? first[i] : second[i];
            sound = sound && place == kNone;
            place = e;
        }
        for (std::size_t i = 0; i < sites.size(); ++i) sound = sound && first[i] != kNone && second[i] != kNone;
    }
};

// Marks the edges after `begin` and before `end` round their cell as inside. False if `end` does not follow, or if one
// of the edges cannot be inside.
bool mark_between(std::uint32_t begin, std::uint32_t end, const std::vector<std::uint32_t>& next, Diagram& d) {
    for (std::uint32_t e = next[begin]; e != end; e = next[e]) {
        if (e == kNone || !d.between_sites[e] || d.inside[e]) return false;
        d.inside[e] = 1;
    }
    return true;
}

// Marks the edges inside the region, by the order of the edges alone. False if two cells disagree about the edge
// between them.
//
// Edges round the cell of a segment, counter-clockwise: first those on its left, from its last end to its first, then
// those on its right. The edges at the cells of its two ends separate both groups. In the cell of a vertex two segments
// meet. Its inside edges come after the edge beside the segment that begins there. They come before the edge beside the
// segment that ends there.
bool mark_inside(const Sites& sites, const std::vector<std::uint32_t>& next, Diagram& d) {
    const EndEdges ends(sites, d);
    if (!ends.sound) return false;
    for (std::uint32_t i = 0; i < sites.size(); ++i)
        if (!mark_between(ends.second[i], ends.first[i], next, d) ||
            !mark_between(ends.first[i] ^ 1U, ends.second[sites.prev[i]] ^ 1U, next, d))
            return false;
    for (std::uint32_t e = 0; e < d.edges(); ++e)
        if (d.inside[e] != d.inside[e ^ 1U] || (d.inside[e] && d.from[e] == kNone)) return false;
    return true;
}

// How far p is from a cell's part of the outline, grid units. Negative or infinite if p lies on the right of its
// segment or beyond its ends, where no point of its cell inside the region can be.
double distance_in(const Sites& sites, const Diagram& d, std::uint32_t cell, Vec2 p) {
    if (const std::uint32_t v = vertex_of(sites, d, cell); v != kNone) return geom::distance(sites.at(v), p);
    const std::uint32_t i = d.segment[cell];
    const Vec2 begin = sites.at(i), along = sites.at(sites.next[i]) - begin;
    const double length = geom::norm(along), at = geom::dot(along, p - begin) / length;
    if (at < -kFit || at > length + kFit) return std::numeric_limits<double>::infinity();
    return geom::cross(along, p - begin) / length;
}

// Whether both ends of each edge inside the region are as far from the one cell as from the other, and on the inner
// side of both. Near coincidences of many sites can lead the sweep to another diagram, whose edges follow each other
// well.
bool fits(const Sites& sites, const Diagram& d) {
    for (std::uint32_t e = 0; e < d.edges(); ++e) {
        if (!d.inside[e]) continue;
        const Vec2 p = d.vertex[d.from[e]];
        const double one = distance_in(sites, d, d.cell[e], p), two = distance_in(sites, d, d.cell[e ^ 1U], p);
        if (!(one > -kFit && two > -kFit && std::abs(one - two) <= kFit)) return false;
    }
    return true;
}

// Removes edges inside the region whose two ends differ only by rounding, by Boost's own test of equal vertices. The
// edges that met at the two ends then share one vertex.
void remove_short_edges(std::vector<std::uint32_t>& next, Diagram& d) {
    const boost::polygon::voronoi_diagram_traits<double>::vertex_equality_predicate_type same;
    std::vector<std::uint32_t> stands_for(d.vertex.size());
    std::iota(stands_for.begin(), stands_for.end(), 0U);
    const auto root = [&](std::uint32_t v) {
        while (stands_for[v] != v) v = stands_for[v] = stands_for[stands_for[v]];
        return v;
    };
    bool any = false;
    for (std::uint32_t e = 0; e < d.edges(); e += 2) {
        if (!d.inside[e]) continue;
        const std::uint32_t a = root(d.from[e]), b = root(d.to(e));
        const auto at = [&](std::uint32_t v) {
            return boost::polygon::voronoi_vertex<double>(d.vertex[v].x, d.vertex[v].y);
        };
        if (a == b || !same(at(a), at(b))) continue;
        stands_for[b] = a;
        any = true;
        for (const std::uint32_t half : {e, e + 1}) {
            d.inside[half] = 0;
            const std::uint32_t before = d.prev[half], after = next[half];
            next[before] = after;
            d.prev[after] = before;
        }
    }
    if (!any) return;
    for (std::uint32_t& v : d.from)
        if (v != kNone) v = root(v);
}

} // namespace

std::uint32_t vertex_of(const Sites& sites, const Diagram& d, std::uint32_t cell) {
    if (d.part[cell] == Diagram::Part::segment) return kNone;
    return d.part[cell] == Diagram::Part::first_end ? d.segment[cell] : sites.next[d.segment[cell]];
}

std::optional<Diagram> voronoi(const Sites& sites) {
    boost::polygon::voronoi_builder<std::int32_t, Usual, Predicates> builder;
    for (std::size_t i = 0; i < sites.size(); ++i)
        builder.insert_segment(sites.x[i], sites.y[i], sites.x[sites.next[i]], sites.y[sites.next[i]]);
    Record record;
    builder.construct(&record);
    builder.clear(); // frees its memory for the next steps

    Diagram out;
    const std::size_t edges = record.edge.size();
    for (auto* v : {&out.from, &out.prev, &out.cell}) v->reserve(edges);
    out.between_sites.reserve(edges);
    out.inside.assign(edges, 0);
    std::vector<std::uint32_t> next;
    next.reserve(edges);
    for (const Record::Edge& e : record.edge) {
        out.from.push_back(e.from);
        out.prev.push_back(e.prev);
        out.cell.push_back(e.cell);
        out.between_sites.push_back(e.between_sites ? 1 : 0);
        next.push_back(e.next);
    }
    out.vertex = std::move(record.vertex);
    out.segment = std::move(record.segment);
    out.part = std::move(record.part);
    if (!mark_inside(sites, next, out) || !fits(sites, out)) return std::nullopt;
    remove_short_edges(next, out);
    return out;
}

} // namespace filum::polygon
