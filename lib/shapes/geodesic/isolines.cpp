#include "geodesic/isolines.hpp"

#include "geodesic/query.hpp"

#include <algorithm>

namespace filum::geodesic {

using surface::kNone;

namespace {

constexpr double kTolerance = 1e-3; // mm between an isoline and the level set
// shares of the distance of levels: a level nearer to a vertex's distance is raised, to twice that above it
constexpr double kOffVertices = 1e-6;

struct Crossing {
    std::uint32_t edge;                                            // the half-edge of lower number
    double x;                                                      // mm from its tail
    std::uint32_t before = kNone, after = kNone;                   // neighbours on the line
    std::uint32_t before_triangle = kNone, after_triangle = kNone; // the triangles between
};

// All isolines of one level.
class Tracer {
  public:
    Tracer(const Surface& s, std::span<const double> distance, double level, const Inside& at)
        : surface_(s), distance_(distance), level_(level), at_(at) {}

    void add(std::uint32_t edge, double x) { crossings_.push_back({edge, x}); }
    void join(std::uint32_t triangle);
    void trace(std::vector<Isoline>& out, std::vector<EdgePlace>& begins);
    [[nodiscard]] bool empty() const { return crossings_.empty(); }
    [[nodiscard]] std::span<const Crossing> crossings() const { return crossings_; }

  private:
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> on_edge(std::uint32_t edge) const;
    [[nodiscard]] Vec3 place(const Crossing& c) const;
    Isoline follow(std::uint32_t first, std::vector<char>& seen) const;

    const Surface& surface_;
    std::span<const double> distance_;
    double level_;
    const Inside& at_;
    std::vector<Crossing> crossings_; // by edge, then by x
    std::vector<std::uint32_t> around_;
};

std::pair<std::uint32_t, std::uint32_t> Tracer::on_edge(std::uint32_t edge) const {
    const auto less = [](const Crossing& c, std::uint32_t e) { return c.edge < e; };
    const auto first = std::lower_bound(crossings_.begin(), crossings_.end(), edge, less);
    auto last = first;
    while (last != crossings_.end() && last->edge == edge) ++last;
    return {static_cast<std::uint32_t>(first - crossings_.begin()),
            static_cast<std::uint32_t>(last - crossings_.begin())};
}

Vec3 Tracer::place(const Crossing& c) const {
    const Vec3 &a = surface_.vertices[surface_.tail(c.edge)], &b = surface_.vertices[surface_.head(c.edge)];
    return a + c.x / distance(a, b) * (b - a);
}

// Connects the crossings around a triangle. Counter-clockwise they alternately lead above the level and below it.
void Tracer::join(std::uint32_t triangle) {
    around_.clear();
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const std::uint32_t twin = surface_.twin[h];
        const auto [first, last] = on_edge(std::min(h, twin));
        if (twin < h)
            for (std::uint32_t c = last; c > first; --c) around_.push_back(c - 1);
        else
            for (std::uint32_t c = first; c < last; ++c) around_.push_back(c);
    }
    if (around_.size() < 2) return;
    const std::size_t n = around_.size();
    const std::size_t out = distance_[surface_.triangles[triangle][0]] < level_ ? 0 : 1; // the first that leads above
    bool near_joined = false; // the part below the level is connected through the middle
    if (n > 2) {
        Vec3 middle;
        for (const std::uint32_t c : around_) middle = middle + 1.0 / static_cast<double>(n) * place(crossings_[c]);
        near_joined = at_(triangle, middle) < level_;
    }
    for (std::size_t i = out; i < n + out; i += 2) {
        const std::uint32_t from = around_[i % n], to = around_[(near_joined ? i + 1 : i + n - 1) % n];
        crossings_[from].after = to;
        crossings_[from].after_triangle = triangle;
        crossings_[to].before = from;
        crossings_[to].before_triangle = triangle;
    }
}

Isoline Tracer::follow(std::uint32_t first, std::vector<char>& seen) const {
    Isoline line{.level = level_, .closed = false, .points = {}, .triangles = {}};
    for (std::uint32_t c = first; c != kNone; c = crossings_[c].after) {
        if (seen[c] != 0) {
            line.closed = true;
            break;
        }
        seen[c] = 1;
        line.points.push_back(place(crossings_[c]));
        if (crossings_[c].after != kNone) line.triangles.push_back(crossings_[c].after_triangle);
    }
    return line;
}

void Tracer::trace(std::vector<Isoline>& out, std::vector<EdgePlace>& begins) {
    std::vector<char> seen(crossings_.size(), 0);
    const auto add = [&](std::uint32_t c) {
        Isoline line = follow(c, seen);
        if (line.points.size() < 2) return;
        out.push_back(std::move(line));
        begins.push_back({crossings_[c].edge, crossings_[c].x});
    };
    for (std::uint32_t c = 0; c < seen.size(); ++c)
        if (crossings_[c].before == kNone) add(c);
    for (std::uint32_t c = 0; c < seen.size(); ++c)
        if (seen[c] == 0) add(c);
}

// `length(half-edge)` is in mm.
template <class Length>
std::vector<Isoline> traced(const Surface& s, std::span<const double> distance, std::span<const double> levels,
                            const Length& length, const Crosser& cross, const Inside& at,
                            std::vector<EdgePlace>* begins) {
    std::vector<Tracer> tracers;
    tracers.reserve(levels.size());
    for (const double level : levels) tracers.emplace_back(s, distance, level, at);
    std::vector<double> places;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        if (s.twin[h] < h) continue;
        const double a = distance[s.tail(h)], b = distance[s.head(h)];
        if (!std::isfinite(a) || !std::isfinite(b)) continue;
        const double l = length(h);
        auto level = std::lower_bound(levels.begin(), levels.end(), std::min({a, b, (a + b - l) / 2}));
        for (; level != levels.end() && within_reach(a, b, l, *level); ++level) {
            cross(h, *level, places);
            for (const double x : places) tracers[static_cast<std::size_t>(level - levels.begin())].add(h, x);
        }
    }
    std::vector<Isoline> out;
    std::vector<EdgePlace> unused;
    std::vector<std::uint32_t> last_joined(s.triangles.size(), kNone);
    for (std::uint32_t i = 0; i < tracers.size(); ++i) {
        const std::size_t n = tracers[i].crossings().size();
        for (std::size_t c = 0; c < n; ++c) {
            const std::uint32_t edge = tracers[i].crossings()[c].edge;
            for (const std::uint32_t h : {edge, s.twin[edge]}) {
                if (h == kNone || last_joined[h / 3] == i) continue;
                last_joined[h / 3] = i;
                tracers[i].join(h / 3);
            }
        }
        tracers[i].trace(out, begins != nullptr ? *begins : unused);
    }
    return out;
}

} // namespace

std::vector<Isoline> isolines(const Surface& s, std::span<const double> distance, std::span<const double> levels,
                              const Crosser& cross, const Inside& at, std::vector<EdgePlace>* begins) {
    return traced(
        s, distance, levels, [&](std::uint32_t h) { return surface::side_length(s, h); }, cross, at, begins);
}

std::vector<Isoline> isolines(const Surface& s, const ExactField& field, std::span<const double> levels,
                              std::vector<EdgePlace>* begins) {
    const Inside at = [&](std::uint32_t t, const Vec3& p) { return distance_at(s, field, t, p); };
    const Crosser cross = [&](std::uint32_t h, double level, std::vector<double>& out) {
        level_crossings(s, field, h, level, out);
    };
    const auto& frame = field.unfolding->frame;
    auto out = traced(
        s, field.distance, levels, [&](std::uint32_t h) { return frame[h].length; }, cross, at, begins);
    for (Isoline& line : out) refine(s, line, at, kTolerance);
    return out;
}

std::vector<Isoline> isolines(const Surface& s, std::span<const double> distance, std::span<const double> levels) {
    return isolines(
        s, distance, levels,
        [&](std::uint32_t h, double level, std::vector<double>& out) {
            out.clear();
            const double a = distance[s.tail(h)], b = distance[s.head(h)];
            if ((a < level) == (b < level)) return;
            out.push_back((level - a) / (b - a) * surface::side_length(s, h));
        },
        [](std::uint32_t, const Vec3&) { return 0.0; }); // not used, as there are two crossings at most
}

std::vector<double> off_vertices(std::vector<double> levels, std::vector<double> distance, double apart) {
    std::sort(distance.begin(), distance.end());
    const double off = kOffVertices * apart;
    for (double& level : levels)
        while (true) {
            const auto near = std::lower_bound(distance.begin(), distance.end(), level - off);
            if (near == distance.end() || *near > level + off) break;
            level = *near + 2 * off;
        }
    return levels;
}

} // namespace filum::geodesic
