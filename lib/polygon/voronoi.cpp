#include "polygon/voronoi.hpp"

#include "base/error.hpp"

#include <boost/polygon/voronoi.hpp>

#include <cmath>
#include <limits>

// A number with a bound of its relative error, as Boost.Polygon's predicates reckon with it: in units of the last place
// of a double, whatever the number itself is.
template <>
class boost::polygon::detail::robust_fpt<long double> {
  public:
    using floating_point_type = long double;
    using relative_error_type = long double;

    robust_fpt() = default;
    explicit robust_fpt(long double value, long double places = 0) : value_(value), error_(places * kPlace) {}

    [[nodiscard]] long double fpv() const { return value_; }
    [[nodiscard]] long double re() const { return error_; }
    [[nodiscard]] long double ulp() const { return error_; }
    [[nodiscard]] bool has_pos_value() const { return value_ > 0; }
    [[nodiscard]] bool has_neg_value() const { return value_ < 0; }
    [[nodiscard]] bool has_zero_value() const { return value_ == 0; }

    robust_fpt operator-() const { return made(-value_, error_); }
    robust_fpt operator+(const robust_fpt& b) const {
        const long double sum = value_ + b.value_;
        const bool apart = (value_ < 0 && b.value_ > 0) || (value_ > 0 && b.value_ < 0); // then it may cancel
        const long double error =
            apart ? std::abs((value_ * error_ - b.value_ * b.error_) / sum) : std::max(error_, b.error_);
        return made(sum, error + kPlace);
    }
    robust_fpt operator-(const robust_fpt& b) const { return *this + -b; }
    robust_fpt operator*(const robust_fpt& b) const { return made(value_ * b.value_, error_ + b.error_ + kPlace); }
    robust_fpt operator/(const robust_fpt& b) const { return made(value_ / b.value_, error_ + b.error_ + kPlace); }
    robust_fpt& operator+=(const robust_fpt& b) { return *this = *this + b; }
    robust_fpt& operator-=(const robust_fpt& b) { return *this = *this - b; }
    robust_fpt& operator*=(const robust_fpt& b) { return *this = *this * b; }
    robust_fpt& operator/=(const robust_fpt& b) { return *this = *this / b; }
    [[nodiscard]] robust_fpt sqrt() const { return made(std::sqrt(value_), error_ / 2 + kPlace); }

  private:
    // Rounding of a long double, in places of a double.
    static constexpr long double kPlace =
        std::numeric_limits<long double>::epsilon() / std::numeric_limits<double>::epsilon();

    static robust_fpt made(long double value, long double error) {
        robust_fpt out;
        out.value_ = value;
        out.error_ = error;
        return out;
    }

    long double value_ = 0, error_ = 0;
};

namespace filum::polygon {

namespace {

namespace detail = boost::polygon::detail;
using Usual = detail::voronoi_ctype_traits<std::int32_t>;

struct ToLong {
    template <class T>
    long double operator()(const T& value) const {
        if constexpr (std::is_arithmetic_v<T>)
            return static_cast<long double>(value);
        else
            return value.d();
    }
};

struct Long : Usual {
    using fpt_type = long double;
    using to_fpt_converter_type = ToLong;
};

// Circles worked out in long double.  Those of two neighbouring segments and one of their three vertices, as many as
// there are segments, have a formula without differences of near numbers.
template <class Site, class Circle>
struct Circles : detail::voronoi_predicates<Long>::lazy_circle_formation_functor<Site, Circle> {
    using Base = detail::voronoi_predicates<Long>::lazy_circle_formation_functor<Site, Circle>;

    // The circle lies left of `one` from its second end to its first, and of `two` from its first end to its second.
    void pss(const Site& point, const Site& one, const Site& two, int place, Circle& out) {
        const auto p = point.point0();
        const Vector a = vector(one.point1(), one.point0()), b = vector(two.point0(), two.point1());
        const std::int64_t turn = a.x * b.y - a.y * b.x, along = a.x * b.x + a.y * b.y; // within 63 bits
        for (const auto& v : {one.point0(), one.point1()}) {
            if (turn == 0 || (two.point0() != v && two.point1() != v)) continue;
            if (p == v) {
                out = Circle(p.x(), p.y(), p.x());
                return;
            }
            const bool on_one = one.point0() == p || one.point1() == p;
            if (!on_one && two.point0() != p && two.point1() != p) continue;
            const long double lengths = std::sqrt(norm2(a)) * std::sqrt(norm2(b));
            const long double tangent =
                along > 0 ? turn / (lengths + along) : (lengths - along) / turn; // of half the turn
            touching(p, vector(v, p), on_one ? tangent : -tangent, out);
            return;
        }
        Base::pss(point, one, two, place, out);
    }

  private:
    struct Vector {
        std::int64_t x, y;
    };
    template <class Point>
    static Vector vector(const Point& from, const Point& to) {
        return {static_cast<std::int64_t>(to.x()) - from.x(), static_cast<std::int64_t>(to.y()) - from.y()};
    }
    static long double norm2(const Vector& a) {
        return static_cast<long double>(a.x) * a.x + static_cast<long double>(a.y) * a.y;
    }
    // The circle about p + by * (u turned left by a right angle) through p.
    template <class Point>
    static void touching(const Point& p, const Vector& u, long double by, Circle& out) {
        const long double x = -by * u.y, y = by * u.x, r = std::sqrt(x * x + y * y);
        const long double right = x < 0 ? y * y / (r - x) : r + x;
        out =
            Circle(static_cast<double>(p.x() + x), static_cast<double>(p.y() + y), static_cast<double>(p.x() + right));
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

    Diagram out;
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
