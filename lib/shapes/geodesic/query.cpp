#include "geodesic/query.hpp"

#include <array>
#include <limits>
#include <memory_resource>

namespace filum::geodesic {

namespace {

constexpr double kGlue = 1e-7; // edges: smaller gaps between windows are none
constexpr double kEnd = 1e-9;  // edges: least distance of a level from an end above it

// Distance of (px, py), py >= 0, via the window; the path bends at the window's end if it cannot be straight. Returns
// `least` early if the path cannot be shorter.
double through(const Window& w, double px, double py, double least) {
    constexpr double kRounding = 1e-12; // relative: more than a few rounding errors
    const double dx = w.is_line() ? w.sx : px - w.sx, dy = w.is_line() ? w.sy : py - w.sy;
    const double room = least - w.sigma + kRounding * (least + std::abs(w.sigma));
    if (w.is_line() ? dx * px + dy * py > room : room <= 0 || dx * dx + dy * dy > room * room) return least;
    const double x = dy > 0 ? px - dx / dy * py : px;
    if (x >= w.b0 && x <= w.b1)
        return w.is_line() ? w.sigma + w.sx * px + w.sy * py : w.sigma + std::sqrt(dx * dx + dy * dy);
    const double b = std::clamp(x, w.b0, w.b1), end = w.at(b), away = std::max(std::abs(px - b), py);
    if (end + (1 - kRounding) * away > least) return least; // avoids hypot, which is at least `away`
    return end + std::hypot(px - b, py);
}

double to_segment(const Segment& s, const Vec3& p) {
    const Vec3 d = s.b - s.a;
    const double l2 = dot(d, d);
    const double t = l2 > 0 ? std::clamp(dot(p - s.a, d) / l2, 0.0, 1.0) : 0;
    return distance(p, s.a + t * d);
}

struct Interval {
    double a, b;
};

// The part of a window that is below the level.
Interval below(const Window& w, double level) {
    if (w.is_line()) {
        const double rest = level - w.sigma;
        if (w.sx == 0) return rest > 0 ? Interval{w.b0, w.b1} : Interval{0, 0};
        const double x = rest / w.sx;
        return w.sx > 0 ? Interval{w.b0, std::min(w.b1, x)} : Interval{std::max(w.b0, x), w.b1};
    }
    const double r = level - w.sigma, r2 = r * r - w.sy * w.sy;
    if (r <= 0 || r2 <= 0) return {0, 0};
    const double half = std::sqrt(r2);
    return {std::max(w.b0, w.sx - half), std::min(w.b1, w.sx + half)};
}

} // namespace

double distance_at(const Surface& s, const ExactField& field, std::uint32_t triangle, const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const std::uint32_t v = s.tail(h);
        least = std::min(least, field.distance[v] + distance(s.vertices[v], p));
        if (field.first[h] == surface::kNone) continue;
        const geom::Vec2 q = flatten(s, field.unfolding->frame[h], h, p);
        for (std::uint32_t w = field.first[h]; w != surface::kNone; w = field.windows[w].next)
            least = std::min(least, through(field.windows[w], q.x, std::max(0.0, q.y), least));
    }
    const auto& own = field.segments;
    auto it = std::lower_bound(own.begin(), own.end(), triangle,
                               [](const Segment& a, std::uint32_t t) { return a.triangle < t; });
    for (; it != own.end() && it->triangle == triangle; ++it) least = std::min(least, to_segment(*it, p));
    return least;
}

void level_crossings(const Surface& s, const ExactField& field, std::uint32_t h, double level,
                     std::vector<double>& out) {
    const double l = field.unfolding->frame[h].length, tail = field.distance[s.tail(h)],
                 head = field.distance[s.head(h)];
    const double lo = tail < level ? 0 : kEnd * l, hi = head < level ? l : (1 - kEnd) * l;
    std::array<std::byte, 64 * sizeof(Interval)> room; // usually enough without allocating
    std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
    std::pmr::vector<Interval> parts(&memory);
    parts.reserve(32);
    const auto add = [&](Interval i) {
        i = {std::max(i.a, lo), std::min(i.b, hi)};
        if (i.a < i.b) parts.push_back(i);
    };
    // An end that is below the level by rounding only gets a small interval; otherwise the number of crossings would
    // be odd.
    if (tail < level) add({0, std::max(level - tail, kEnd * l)});
    if (head < level) add({l - std::max(level - head, kEnd * l), l});
    for (std::uint32_t w = field.first[h]; w != surface::kNone; w = field.windows[w].next)
        add(below(field.windows[w], level));
    for (std::uint32_t w = field.first[field.unfolding->across[h]]; w != surface::kNone; w = field.windows[w].next) {
        const Interval i = below(field.windows[w], level);
        if (i.a < i.b) add({l - i.b, l - i.a});
    }
    std::sort(parts.begin(), parts.end(), [](const Interval& a, const Interval& b) { return a.a < b.a; });
    out.clear();
    for (std::size_t i = 0; i < parts.size();) {
        double end = parts[i].b;
        const double begin = parts[i].a;
        for (++i; i < parts.size() && parts[i].a <= end + kGlue * l; ++i) end = std::max(end, parts[i].b);
        if (begin > 0) out.push_back(begin);
        if (end < l) out.push_back(end);
    }
}

// Between the ends of windows distances have no maximum, as they are linear or roots of sums of squares.
double farthest(const Surface& s, const ExactField& field) {
    double out = 0;
    for (const double d : field.distance)
        if (std::isfinite(d)) out = std::max(out, d);
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        if (s.twin[h] < h) continue;
        const double l = field.unfolding->frame[h].length,
                     most = (field.distance[s.tail(h)] + field.distance[s.head(h)] + l) / 2;
        if (!std::isfinite(most) || most <= out) continue;
        const Vec3 &a = s.vertices[s.tail(h)],
                   along = field.unfolding->frame[h].inverse_length * (s.vertices[s.head(h)] - a);
        for (const std::uint32_t list : {h, field.unfolding->across[h]})
            for (std::uint32_t w = field.first[list]; w != surface::kNone; w = field.windows[w].next)
                for (const double x : {field.windows[w].b0, field.windows[w].b1}) {
                    const Vec3 p = a + (list == h ? x : l - x) * along;
                    double d = distance_at(s, field, h / 3, p);
                    if (s.twin[h] != surface::kNone) d = std::min(d, distance_at(s, field, s.twin[h] / 3, p));
                    out = std::max(out, d);
                }
    }
    return out;
}

} // namespace filum::geodesic
