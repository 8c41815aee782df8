#include "surfpath/rows.hpp"

#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath {

namespace {

using surface::kNone;

double longest_edge(const Surface& s) {
    double out = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h)
        out = std::max(out, distance(s.vertices[s.tail(h)], s.vertices[s.head(h)]));
    return out;
}

surface::Sources rims(const Surface& s) {
    surface::Sources out;
    for (const auto& rim : s.rims)
        for (const std::uint32_t h : rim.sides)
            out.segments.push_back({h / 3, s.vertices[s.tail(h)], s.vertices[s.head(h)]});
    return out;
}

// Cuts lines where they come nearer to a rim than the margin.
class Cutter {
  public:
    Cutter(const Surface& s, double margin) : surface_(s), margin_(margin) {
        if (s.rims.empty()) return;
        field_ = geodesic::exact(s, rims(s), margin + 2 * longest_edge(s));
        const double level[] = {margin};
        for (const auto& isoline : geodesic::isolines(s, field_, level)) inset_.rings.push_back(curve::line(isoline));
        for (const Line& ring : inset_.rings) inset_.ways.push_back(curve::ways(ring));
    }

    [[nodiscard]] Inset& inset() { return inset_; }

    // The stretches of the line that keep the margin, mm along it.
    [[nodiscard]] std::vector<std::pair<double, double>> kept(const Line& line, std::span<const double> ways) const {
        std::vector<std::pair<double, double>> out;
        const std::size_t n = line.size(), stretches = ways.size() - 1;
        bool in = room(line.places[0]) >= 0;
        double begin = 0;
        for (std::size_t i = 0; i < stretches; ++i) {
            const Place& next = line.places[(i + 1) % n];
            const bool then = room({line.places[i].triangle, next.point}) >= 0;
            if (in == then) continue;
            const double way = ways[i] + crossing(line.places[i], next, in) * (ways[i + 1] - ways[i]);
            if (in) out.emplace_back(begin, way);
            else begin = way;
            in = then;
        }
        if (in) out.emplace_back(begin, ways.back());
        // Of a closed line the first and the last stretch are one, over its first point.
        if (line.closed && out.size() > 1 && out.front().first == 0 && out.back().second == ways.back()) {
            out.front().first = out.back().first - ways.back();
            out.pop_back();
        }
        return out;
    }

    [[nodiscard]] Port port(const Vec3& p) const {
        Port out;
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t r = 0; r < inset_.rings.size(); ++r) {
            const Line& ring = inset_.rings[r];
            const std::size_t n = ring.size();
            for (std::size_t i = 0; i + 1 < inset_.ways[r].size(); ++i) {
                const Vec3 &a = ring[i], d = ring[(i + 1) % n] - a;
                const double l2 = dot(d, d), t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
                const double far = distance(p, a + t * d);
                if (far < least) least = far, out = {r, inset_.ways[r][i] + t * std::sqrt(l2)};
            }
        }
        return out;
    }

  private:
    [[nodiscard]] double room(const Place& p) const {
        if (inset_.rings.empty() && surface_.rims.empty()) return margin_;
        return geodesic::distance_at(surface_, field_, p.triangle, p.point) - margin_;
    }

    // Where the stretch from `a` to `b`, within a's triangle, crosses the margin: part of it.
    [[nodiscard]] double crossing(const Place& a, const Place& b, bool from_inside) const {
        double lo = 0, hi = 1;
        for (int i = 0; i < 30; ++i) {
            const double mid = (lo + hi) / 2;
            const bool in = room({a.triangle, a.point + mid * (b.point - a.point)}) >= 0;
            (in == from_inside ? lo : hi) = mid;
        }
        return from_inside ? lo : hi;
    }

    const Surface& surface_;
    double margin_;
    geodesic::ExactField field_;
    Inset inset_;
};

} // namespace

Rows rows(const Surface& s, const std::vector<Raw>& lines, double margin) {
    Rows out;
    Cutter cutter(s, margin);
    for (const Raw& raw : lines) {
        const auto ways = curve::ways(raw.line);
        for (const auto& [from, to] : cutter.kept(raw.line, ways)) {
            if (raw.line.closed && to - from >= ways.back()) {
                out.rows.push_back({raw.line, raw.level, {}, {}});
            } else if (to - from < margin) {
                out.dropped += to - from;
            } else {
                Row row{curve::part(raw.line, ways, from, to), raw.level, {}, {}};
                row.begin = cutter.port(row.line.places.front().point);
                row.end = cutter.port(row.line.places.back().point);
                out.rows.push_back(std::move(row));
            }
        }
    }
    std::stable_sort(out.rows.begin(), out.rows.end(), [](const Row& a, const Row& b) { return a.level < b.level; });
    out.inset = std::move(cutter.inset());
    return out;
}

} // namespace filum::surfpath
