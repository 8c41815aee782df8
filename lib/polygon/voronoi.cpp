#include "polygon/voronoi.hpp"

#include "base/error.hpp"
#include "polygon/circles.hpp"

#include <boost/polygon/voronoi.hpp>

namespace filum::polygon {

namespace {

namespace detail = boost::polygon::detail;
using Usual = detail::voronoi_ctype_traits<std::int32_t>;

// Boost's circles, but sooner where numbers of 64 bits tell them.
template <class Site, class Circle>
struct Circles : detail::voronoi_predicates<Usual>::lazy_circle_formation_functor<Site, Circle> {
    using Base = detail::voronoi_predicates<Usual>::lazy_circle_formation_functor<Site, Circle>;

    void pps(const Site& one, const Site& two, const Site& line, int place, Circle& out) {
        if (!take(touching_circle(at(one.point0()), at(two.point0()), line_of(line), place == 2), out))
            Base::pps(one, two, line, place, out);
    }
    // The first segment is told from its second end to its first.
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

} // namespace

Diagram voronoi(const Sites& sites) {
    boost::polygon::voronoi_builder<std::int32_t, Usual, Predicates> builder;
    for (std::size_t i = 0; i < sites.size(); ++i)
        builder.insert_segment(sites.x[i], sites.y[i], sites.x[sites.next[i]], sites.y[sites.next[i]]);
    boost::polygon::voronoi_diagram<double> made;
    builder.construct(&made);
    builder.clear(); // its memory serves for what follows

    Diagram out;
    out.vertex.reserve(made.num_vertices());
    for (auto* v : {&out.from, &out.prev, &out.cell}) v->reserve(made.num_edges());
    out.between_sites.reserve(made.num_edges());
    for (const auto& v : made.vertices()) out.vertex.push_back({v.x(), v.y()});
    const auto number = [](const auto& all, const auto* one) { return static_cast<std::uint32_t>(one - all.data()); };
    for (std::uint32_t i = 0; i < made.num_edges(); ++i) {
        const auto& e = made.edges()[i];
        if (number(made.edges(), e.twin()) != (i ^ 1U))
            throw Error(Exit::failure, "internal error: the edges of a Voronoi diagram are not in pairs");
        out.from.push_back(e.vertex0() != nullptr ? number(made.vertices(), e.vertex0()) : kNone);
        out.prev.push_back(number(made.edges(), e.prev()));
        out.cell.push_back(number(made.cells(), e.cell()));
        out.between_sites.push_back(e.is_primary() ? 1 : 0);
    }
    out.segment.reserve(made.num_cells());
    out.part.reserve(made.num_cells());
    for (const auto& c : made.cells()) {
        out.segment.push_back(static_cast<std::uint32_t>(c.source_index()));
        const bool first = c.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
        out.part.push_back(c.contains_segment() ? Diagram::Part::segment
                           : first              ? Diagram::Part::first_end
                                                : Diagram::Part::second_end);
    }
    return out;
}

} // namespace filum::polygon
