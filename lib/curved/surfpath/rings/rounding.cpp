#include "surfpath/rings/rounding.hpp"

#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rings/necks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::surfpath::rings {

namespace {

constexpr double kOff = 0.01;    // radii: a rounded line is off its ring where it is farther from it
constexpr double kLongCut = 3.0; // least radii: a corner that is shortened by less is not rounded further
constexpr double kCusp = 0.15;   // rad: an outward turn of an arc beyond this is a cusp

class Rounder {
  public:
    Rounder(const Surface& s, const ExactField& field, double least, double spacing, double edge)
        : surface_(s), field_(field), least_(least), spacing_(spacing), edge_(edge) {}

    void prepare(Batch& b, const Within& within) const {
        auto& rings = b.rings;
        for (const Isoline* line : b.outer) rings.push_back({surface::curve::line(*line), {}});
        for (Ring& r : rings) r.ways = surface::curve::arc_lengths(r.line);
        const RingTree tree(rings);
        bool more = !rings.empty();
        for (std::size_t k = 0; k < b.radii.size() && more; ++k) {
            for (Ring& r : rings) r.by.emplace_back();
            std::size_t number = 0;
            for (const Line& line : opened(b.level, b.radii[k], within(b.radii[k])))
                sort_in(line, number++, b.level, b.radii[k], tree, rings);
            more = false;
            for (Ring& r : rings) {
                check(r);
                for (const Corner& c : r.by[k].corners) more |= r.ahead(c.from, c.to) - c.length > kLongCut * least_;
            }
        }
    }

    [[nodiscard]] double tight(const Batch& b) const {
        double out = 0;
        if (!worthwhile(b)) return out;
        const auto add = [&](double length, double radius) { out += length * std::max(0.0, 1 / radius - 1 / least_); };
        for (const RoundedCorner& c : bends(b)) add(c.corner->length, b.radii[c.scale]);
        for (const Ring& r : b.rings)
            if (gone(r)) add(2 * std::numbers::pi * b.radii[0], b.radii[0]);
        return out;
    }

    void finish(Batch& b) const {
        if (!b.rings.empty() && worthwhile(b)) assemble(b);
    }

    double gain = 0;

  private:
    // Morphological opening: the lines at a distance `radius` outside of the isolines `inner`.
    [[nodiscard]] std::vector<Line> opened(double level, double radius,
                                           const std::vector<const Isoline*>& inner) const {
        std::vector<Line> out;
        if (inner.empty()) return out;
        // Distances are not needed farther inside, where the other side of each line would be.
        const auto shut = geodesic::triangles_beyond(surface_, field_.distance, level + radius + edge_);
        const auto near = geodesic::exact(surface_, as_sources(inner), radius + 1.01 * edge_, field_.unfolding, shut);
        const double levels[] = {radius};
        for (const auto& line : geodesic::isolines(surface_, near, levels)) {
            if (!line.closed || line.points.size() < 3) continue;
            if (height(surface::curve::line(line).places[0]) > level + radius) continue;
            out.push_back(surface::curve::line(line));
            surface::curve::reverse(out.back()); // smaller distances are on its left again
        }
        return out;
    }

    [[nodiscard]] double height(const Place& p) const {
        return geodesic::distance_at(surface_, field_, p.triangle, p.point);
    }

    // Splits an opened line into arcs and stretches along the rings.
    void sort_in(const Line& line, std::size_t number, double level, double radius, const RingTree& tree,
                 std::vector<Ring>& rings) const {
        const double still = 0.0015 * radius, off = kOff * radius;
        const std::size_t n = line.size();
        std::vector<double> above(n);
        for (std::size_t i = 0; i < n; ++i) above[i] = height(line.places[i]) - level;
        const auto lowest = std::min_element(above.begin(), above.end()); // the line touches a ring at least there
        const auto first = static_cast<std::size_t>(lowest - above.begin());
        for (std::size_t k = 0; k < n;) { // counted from `first`
            std::size_t e = k;
            double most = 0;
            while (e < n && e > 0 && above[(first + e) % n] > still) {
                most = std::max(most, above[(first + e) % n]);
                ++e;
            }
            if (e == k) {
                const RingPosition on = tree.nearest(line[(first + k) % n]);
                rings[on.line].by.back().kept.push_back({on.way, number});
                ++k;
                continue;
            }
            if (most > off) add_arc(line, number, first + k - 1 + n, first + e + n, tree, rings);
            k = e;
        }
    }
    // Whether the arc turns outwards somewhere: discs on both sides of a narrow place meet there.
    [[nodiscard]] bool has_cusp(const Line& arc) const {
        for (std::size_t i = 1; i + 1 < arc.size(); ++i) {
            const Vec3 a = arc[i] - arc[i - 1], b = arc[i + 1] - arc[i];
            const Vec3 n = surface::normal(surface_, arc.places[i].triangle);
            if (std::atan2(dot(cross(a, b), n), dot(a, b) - dot(a, n) * dot(b, n)) > kCusp) return true;
        }
        return false;
    }
    void add_arc(const Line& line, std::size_t number, std::size_t begin, std::size_t end, const RingTree& tree,
                 std::vector<Ring>& rings) const {
        const std::size_t n = line.size();
        const RingPosition a = tree.nearest(line[begin % n]), b = tree.nearest(line[end % n]);
        if (a.line != b.line) return;
        Line arc;
        for (std::size_t i = begin; i <= end; ++i) arc.places.push_back(line.places[i % n]);
        if (has_cusp(arc)) return;
        const double l = surface::curve::length(arc), cut = rings[a.line].ahead(a.way, b.way);
        Ring::RadiusResult& to = rings[a.line].by.back();
        if (end - begin >= n || rings[a.line].ways.back() - cut < kOff * least_) { // it replaces the whole ring
            to.instead.push_back(line);
            to.numbers.push_back(number);
            return;
        }
        to.corners.push_back({a.way, b.way, std::move(arc), l});
    }
    // Removes arcs that lead across narrow places, where the ring between their ends is touched.
    void check(Ring& r) const {
        auto& now = r.by.back();
        std::erase_if(now.corners, [&](const Corner& c) {
            const double l = r.ahead(c.from, c.to);
            return std::any_of(now.kept.begin(), now.kept.end(), [&](const Ring::Contact& t) {
                const double on = r.ahead(c.from, t.way);
                return on > kOff * least_ && on < l - kOff * least_;
            });
        });
        std::sort(now.corners.begin(), now.corners.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
    }

    // By how many radians a corner exceeds the curvature of the least radius.
    [[nodiscard]] double tight(const Corner& c, double radius) const { return c.length * (1 / radius - 1 / least_); }
    [[nodiscard]] double all_round(const Batch& b) const { return 2 * std::numbers::pi * (1 - b.radii[0] / least_); }
    // Whether rings that turn tighter than the least radius all around are long enough for that.
    [[nodiscard]] bool worthwhile(const Batch& b) const {
        const double price = all_round(b);
        double length = 0;
        for (const Ring& r : b.rings) length += r.ways.back();
        return !(price > 0) || length > gain * least_ * price;
    }

    // Chooses the arc of this radius, or the arcs of the smaller radius within it that gain most.
    void choose(const Ring& r, const Batch& b, std::size_t k, const Corner& c, std::vector<RoundedCorner>& out) const {
        const double worth = -gain * least_;
        double most = c.length + worth * tight(c, b.radii[k]);
        std::vector<const Corner*> best;
        std::size_t by = k;
        for (std::size_t f = k + 1; f < r.by.size(); ++f) {
            std::vector<const Corner*> finer;
            double now = r.ahead(c.from, c.to);
            for (const Corner& corner : r.by[f].corners)
                if (r.within(corner, c)) {
                    finer.push_back(&corner);
                    now += corner.length - r.ahead(corner.from, corner.to);
                    now += worth * tight(corner, b.radii[f]);
                }
            if (!finer.empty() && now > most) {
                most = now;
                best = std::move(finer);
                by = f;
            }
        }
        if (by == k) out.push_back({0, &c, k, nullptr, {}});
        for (const Corner* corner : best) choose(r, b, by, *corner, out);
    }

    // Whether nothing remains of the ring itself: only lines that replace it as a whole touch it.
    static bool gone(const Ring& r) {
        const auto& now = r.by[0];
        return std::all_of(now.kept.begin(), now.kept.end(), [&](const Ring::Contact& t) {
            return std::find(now.numbers.begin(), now.numbers.end(), t.line) != now.numbers.end();
        });
    }

    // The chosen corners, in the order of their positions.
    [[nodiscard]] std::vector<RoundedCorner> bends(const Batch& b) const {
        std::vector<RoundedCorner> out;
        for (std::size_t i = 0; i < b.rings.size(); ++i) {
            const Ring& r = b.rings[i];
            if (gone(r)) continue;
            std::vector<RoundedCorner> own;
            for (const Corner& c : r.by[0].corners) choose(r, b, 0, c, own);
            std::sort(own.begin(), own.end(),
                      [](const RoundedCorner& x, const RoundedCorner& y) { return x.corner->from < y.corner->from; });
            for (RoundedCorner& c : own) {
                c.ring = i;
                out.push_back(std::move(c));
            }
        }
        return out;
    }

    void assemble(Batch& b) const {
        auto& rings = b.rings;
        auto bent = bends(b);
        bridge_necks(surface_, field_, b.level, spacing_, rings, bent);
        for (std::size_t i = 0; i < rings.size(); ++i) {
            if (gone(rings[i]))
                for (auto& line : rings[i].by[0].instead) b.lines.push_back(std::move(line));
            else if (std::none_of(bent.begin(), bent.end(), [&](const RoundedCorner& c) { return c.ring == i; }))
                b.lines.push_back(rings[i].line);
        }
        std::vector<char> seen(bent.size(), 0);
        for (std::size_t i = 0; i < bent.size(); ++i) {
            Line line{{}, false};
            for (std::size_t at = i; !seen[at];) {
                seen[at] = 1; // from the end of this corner along the ring to the next one, and across that
                const std::size_t to = after(bent, at);
                const Ring& r = rings[bent[at].ring];
                const Corner &c = *bent[at].corner, &next = *bent[to].corner;
                const double rest = at == to ? r.ways.back() - r.ahead(c.from, c.to) : r.ahead(c.to, next.from);
                // Otherwise the next corner begins where this one ends, or slightly before.
                if (rest < r.ways.back() - kOff * least_)
                    surface::curve::append(line, surface::curve::part(r.line, r.ways, c.to, c.to + rest));
                surface::curve::append(line, bent[to].bridged_to ? bent[to].bridge : next.arc);
                at = bent[to].bridged_to ? static_cast<std::size_t>(bent[to].bridged_to - bent.data()) : to;
            }
            if (line.size() < 3) continue;
            line.closed = true;
            b.lines.push_back(surface::curve::threaded(surface_, line));
        }
    }
    // The next corner of the same ring, cyclically.
    static std::size_t after(const std::vector<RoundedCorner>& bent, std::size_t i) {
        if (i + 1 < bent.size() && bent[i + 1].ring == bent[i].ring) return i + 1;
        while (i > 0 && bent[i - 1].ring == bent[i].ring) --i;
        return i;
    }

    const Surface& surface_;
    const ExactField& field_;
    double least_, spacing_, edge_;
};

} // namespace

surface::Sources as_sources(const std::vector<const Isoline*>& lines) {
    surface::Sources out;
    for (const Isoline* l : lines)
        for (std::size_t i = 0; i < l->triangles.size(); ++i)
            out.segments.push_back({l->triangles[i], l->points[i], l->points[(i + 1) % l->points.size()]});
    return out;
}

Rounding::Rounding(const Surface& s, const ExactField& field, double least, double spacing)
    : surface_(s), field_(field), least_(least), spacing_(spacing), edge_(longest_edge(s)) {}

void Rounding::prepare(Batch& b, const Within& within) const {
    Rounder(surface_, field_, least_, spacing_, edge_).prepare(b, within);
}
double Rounding::tight(const Batch& b, double gain) const {
    Rounder rounder(surface_, field_, least_, spacing_, edge_);
    rounder.gain = gain;
    return rounder.tight(b);
}
void Rounding::finish(Batch& b, double gain) const {
    Rounder rounder(surface_, field_, least_, spacing_, edge_);
    rounder.gain = gain;
    rounder.finish(b);
}

} // namespace filum::surfpath::rings
