#include "surfpath/fronts/fronts.hpp"

#include "base/error.hpp"
#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath::fronts {

namespace {

// Steps: a line that ends farther from the next front has not reached it. As far from the ends of a front are its
// outermost samples.
constexpr double kArrived = 0.05;
constexpr int kRings = 3; // rings of triangles around a place in which fronts are searched

// The triangle and its neighbours, ring by ring.
std::vector<std::uint32_t> about(const Surface& s, std::uint32_t triangle) {
    std::vector<std::uint32_t> out{triangle};
    std::size_t begin = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        const std::size_t end = out.size();
        for (; begin < end; ++begin)
            for (std::uint32_t h = 3 * out[begin]; h < 3 * out[begin] + 3; ++h)
                if (s.twin[h] != surface::kNone && std::find(out.begin(), out.end(), s.twin[h] / 3) == out.end())
                    out.push_back(s.twin[h] / 3);
    }
    return out;
}

// Makes the targets of samples ascend along each front: targets that crossed are replaced by their mean (pool adjacent
// violators). Lines that start perpendicular to a smooth front do not cross; but on a mesh all curvature is in the
// vertices, and lines that pass a convex vertex on both sides do cross. On closed fronts arc lengths continue beyond
// the start. Where they fall by more than `back` mm, another stretch of the front begins.
template <class Sample>
void uncross(std::vector<Sample>& samples, const std::vector<Front>& fronts, double back) {
    struct Pool {
        double mean;
        std::size_t first, count;
    };
    for (std::size_t i = 0; i < samples.size();) {
        if (!samples[i].to) {
            ++i;
            continue;
        }
        const std::uint32_t front = samples[i].to->front;
        const double around = fronts[front].line.closed ? fronts[front].length() : 0;
        std::vector<Pool> pools;
        for (double before = samples[i].to->x; i < samples.size() && samples[i].to && samples[i].to->front == front;
             ++i) {
            double x = samples[i].to->x;
            if (around > 0) x -= around * std::round((x - before) / around);
            if (x < before - back) break; // another stretch: a closed front opened here
            before = x;
            pools.push_back({x, i, 1});
            while (pools.size() > 1 && pools[pools.size() - 2].mean > pools.back().mean) {
                const Pool last = pools.back();
                pools.pop_back();
                Pool& p = pools.back();
                p.mean = (p.mean * static_cast<double>(p.count) + last.mean * static_cast<double>(last.count)) /
                         static_cast<double>(p.count + last.count);
                p.count += last.count;
            }
        }
        for (const Pool& p : pools)
            for (std::size_t k = p.first; k < p.first + p.count; ++k) samples[k].to->x = p.mean;
    }
}

Vec3 right_of(const Vec3& along, const Vec3& normal) { return cross(along, normal); }

} // namespace

Fronts::Fronts(const Surface& surface, const surface::Sources& sources, double spacing)
    : surface_(surface), field_(geodesic::exact(surface, sources)), step_(spacing / 2) {
    const double step = step_, far = geodesic::farthest(surface, field_);
    if (!(far < rules::kMostLines * spacing))
        throw Error(Exit::usage, "cannot follow more than 20000 fronts; raise --spacing");
    std::vector<Line> lines = source_lines(sources);
    for (std::size_t i = 0, n = lines.size(); i < n; ++i) {
        Line back = lines[2 * i];
        surface::curve::reverse(back);
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(2 * i + 1), std::move(back));
    }
    add_level(std::move(lines));
    std::vector<double> levels;
    for (std::size_t k = 1; static_cast<double>(k) * step <= far; ++k) levels.push_back(static_cast<double>(k) * step);
    levels = geodesic::off_vertices(std::move(levels), field_.distance, step);
    const auto isolines = geodesic::isolines(surface, field_, levels);
    std::size_t next = 0;
    for (const double level : levels) {
        lines.clear();
        for (; next < isolines.size() && isolines[next].level == level; ++next)
            if (isolines[next].points.size() > 1) lines.push_back(surface::curve::line(isolines[next]));
        add_level(std::move(lines));
    }
    for (std::size_t k = 0; k + 1 < levels_.size(); ++k) sample(k);
}

void Fronts::add_level(std::vector<Line> lines) {
    Level level;
    for (Line& line : lines) {
        auto ways = surface::curve::arc_lengths(line);
        if (!(ways.back() > rules::kSamePoint)) continue; // a tiny loop around a vertex
        const auto front = static_cast<std::uint32_t>(level.fronts.size());
        for (std::uint32_t i = 0; i + 1 < ways.size(); ++i)
            level.segments.push_back({line.places[i].triangle, front, i});
        level.fronts.push_back({std::move(line), std::move(ways)});
    }
    std::stable_sort(level.segments.begin(), level.segments.end(),
                     [](const FrontSegment& a, const FrontSegment& b) { return a.triangle < b.triangle; });
    levels_.push_back(std::move(level));
}

Place Fronts::place(std::size_t level, Spot spot) const {
    const Front& f = levels_[level].fronts[spot.front];
    return surface::curve::at(f.line, f.ways, spot.x);
}

// The direction of a line: perpendicular to a source curve on its right; elsewhere along the gradient of the distance.
Vec3 Fronts::heading(std::size_t level, Spot spot, const Place& from) const {
    const Vec3 normal = surface::normal(surface_, from.triangle);
    const Front& f = levels_[level].fronts[spot.front];
    const auto after = std::upper_bound(f.ways.begin() + 1, f.ways.end() - 1, spot.x) - f.ways.begin();
    const auto i = static_cast<std::size_t>(after - 1);
    const Vec3 along = f.line[(i + 1) % f.line.size()] - f.line[i];
    if (level == 0) return right_of(along, normal);
    const auto& [a, b, c] = surface_.triangles[from.triangle];
    const Vec3 middle = 1.0 / 3 * (surface_.vertices[a] + surface_.vertices[b] + surface_.vertices[c]);
    const Vec3 inner = from.point + 1e-4 * (middle - from.point);
    const double e = 0.5e-4 * distance(middle, from.point);
    if (!(e > 0)) return right_of(along, normal);
    const Vec3 side = surface_.vertices[b] - surface_.vertices[a], x = 1 / norm(side) * side, y = cross(normal, x);
    const auto slope = [&](const Vec3& d) {
        return geodesic::distance_at(surface_, field_, from.triangle, inner + e * d) -
               geodesic::distance_at(surface_, field_, from.triangle, inner - e * d);
    };
    const Vec3 up = slope(x) * x + slope(y) * y;
    return dot(up, right_of(along, normal)) > 0 ? up : right_of(along, normal);
}

std::optional<Spot> Fronts::locate(std::size_t level, const Place& p) const {
    const Level& l = levels_[level];
    double least = kArrived * step_;
    std::optional<Spot> out;
    for (const std::uint32_t t : about(surface_, p.triangle)) {
        auto it = std::lower_bound(l.segments.begin(), l.segments.end(), t,
                                   [](const FrontSegment& a, std::uint32_t v) { return a.triangle < v; });
        for (; it != l.segments.end() && it->triangle == t; ++it) {
            const Front& f = l.fronts[it->front];
            const Vec3 &a = f.line[it->segment], d = f.line[(it->segment + 1) % f.line.size()] - a;
            const double l2 = dot(d, d), along = l2 > 0 ? std::clamp(dot(p.point - a, d) / l2, 0.0, 1.0) : 0;
            const double off = distance(p.point, a + along * d);
            if (off < least) {
                least = off;
                out = Spot{it->front, f.ways[it->segment] + along * std::sqrt(l2)};
            }
        }
    }
    return out;
}

std::optional<Spot> Fronts::walk_on(std::size_t level, Spot spot) const {
    const Place from = place(level, spot);
    const Vec3 way = heading(level, spot, from);
    if (!(norm(way) > 0)) return {};
    return locate(level + 1, surface::curve::walk(surface_, from, way, step_).places.back());
}

// Computes where lines lead that are a step apart, in order (see uncross).
void Fronts::sample(std::size_t level) {
    const double grain = step_;
    levels_[level].onward.clear();
    for (std::uint32_t f = 0; f < levels_[level].fronts.size(); ++f) {
        const Front& front = levels_[level].fronts[f];
        const double l = front.length(), inset = front.line.closed ? 0 : std::min(kArrived * grain, 0.25 * l);
        const auto n = static_cast<std::size_t>(std::ceil(l / grain)) + 1;
        std::vector<Sample> samples;
        for (std::size_t i = 0; i < n; ++i) {
            const double x = inset + (l - 2 * inset) * static_cast<double>(i) / static_cast<double>(n - 1);
            samples.push_back({x, walk_on(level, {f, x})});
        }
        uncross(samples, levels_[level + 1].fronts, 2 * grain);
        levels_[level].onward.push_back(std::move(samples));
    }
}

std::optional<Spot> Fronts::onward(std::size_t level, Spot spot) const {
    if (level + 1 >= levels_.size()) return {};
    const auto& samples = levels_[level].onward[spot.front];
    auto b =
        std::upper_bound(samples.begin(), samples.end(), spot.x, [](double x, const Sample& s) { return x < s.x; });
    if (b == samples.begin()) ++b;
    if (b == samples.end()) --b;
    const Sample &lo = *(b - 1), &hi = *b;
    if (!lo.to || !hi.to || lo.to->front != hi.to->front) return walk_on(level, spot);
    const Front& target = levels_[level + 1].fronts[lo.to->front];
    const double grown = hi.to->x - lo.to->x;
    if (!(grown >= 0 && grown < 4 * (hi.x - lo.x) + step_)) return walk_on(level, spot);
    double x = lo.to->x + (spot.x - lo.x) / (hi.x - lo.x) * grown;
    if (target.line.closed)
        x -= target.length() * std::floor(x / target.length());
    else
        x = std::clamp(x, 0.0, target.length());
    return Spot{lo.to->front, x};
}

Line Fronts::last(std::size_t level, Spot spot) const {
    const Place from = place(level, spot);
    const Vec3 way = heading(level, spot, from);
    if (!(norm(way) > 0)) return {{from}, false};
    const Line whole = surface::curve::walk(surface_, from, way, 2 * step_);
    const auto ways = surface::curve::arc_lengths(whole);
    const auto shortest = [&](double w) {
        const Place p = surface::curve::at(whole, ways, w);
        return geodesic::distance_at(surface_, field_, p.triangle, p.point) >
               static_cast<double>(level) * step_ + w - kArrived * step_;
    };
    double lo = 0, hi = ways.back();
    if (shortest(hi)) return whole;
    for (int i = 0; i < 20; ++i) (shortest((lo + hi) / 2) ? lo : hi) = (lo + hi) / 2;
    return surface::curve::part(whole, ways, 0, lo);
}

} // namespace filum::surfpath::fronts
