#include "surface/fit/fit.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/locate.hpp"
#include "surface/curve/walk.hpp"
#include "surface/fit/sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>

namespace filum::surface::fit {

namespace {

using curve::Locator;
using curve::Place;

constexpr double kMostTriangles = 2e7;
constexpr double kLong = 4.0 / 3, kShort = 4.0 / 5; // of the size: sides are halved, collapsed (Botsch, Kobbelt 2004)
constexpr int kRounds = 5;                          // of all four steps; then triangles hardly change
constexpr int kCorrections = 3;                     // of sizes, where chords are off by more
constexpr double kNear = 0.1;                       // of the size: as near as the nearest place
constexpr int kMostFlips = 20;                      // sweeps
constexpr double kFlat = 1e-9;                      // rad over half a turn: opposite angles of a side that is flipped
constexpr std::size_t kAtOnce = 1024;               // places of a piece of work

Vec3 fan_normal(const Editable& m, std::uint32_t v) {
    Vec3 out;
    each_leaving(m, v,
                 [&](std::uint32_t h) { out = out + cross(m.at[m.head(h)] - m.at[v], m.at[m.apex(h)] - m.at[v]); });
    return out;
}

// Changes triangles to sizes given on a surface, on which vertices stay.
class Fitter {
  public:
    Fitter(const Surface& s, const Locator& locator, std::vector<double>& sizes, Editable m)
        : surface_(s), locator_(locator), sizes_(sizes), m_(std::move(m)) {}

    void run() {
        for (std::uint32_t v = 0; v < m_.at.size(); ++v)
            if (m_.out[v] != kNone) m_.size[v] = size_at(put(v, m_.at[v]));
        for (int round = 0; round < kRounds; ++round) {
            split_long();
            collapse_short();
            flip_all();
            move_all();
        }
        flip_all();
    }
    [[nodiscard]] const Editable& result() const { return m_; }

  private:
    [[nodiscard]] double target(std::uint32_t a, std::uint32_t b) const { return std::min(m_.size[a], m_.size[b]); }

    // The nearest place of the surface; one that faces as the fan of `v` does if that is about as near.
    [[nodiscard]] Place put(std::uint32_t v, const Vec3& p) const {
        const Vec3 normal = fan_normal(m_, v);
        const Place any = locator_.nearest(p);
        if (dot(surface::normal(surface_, any.triangle), normal) > 0) return any;
        const Place facing = locator_.nearest(p, normal);
        const bool near =
            facing.triangle != kNone && distance(facing.point, p) <= distance(any.point, p) + kNear * m_.size[v];
        return near ? facing : any;
    }

    [[nodiscard]] double size_at(const Place& p) const {
        const auto w = curve::barycentric(surface_, p);
        double out = 0;
        for (std::size_t k = 0; k < 3; ++k)
            out += std::clamp(w[k], 0.0, 1.0) * sizes_[surface_.triangles[p.triangle][k]];
        return out;
    }

    // The longest for its size first: so what comes of it is shorter.
    void split_long() {
        std::priority_queue<std::pair<double, std::uint32_t>> open; // lengths, in sizes; half-edges
        const auto add = [&](std::uint32_t h) {
            const double sizes = m_.length(h) / target(m_.tail(h), m_.head(h));
            if (sizes > kLong) open.emplace(sizes, h);
        };
        for (std::uint32_t h = 0; h < m_.twin.size(); ++h)
            if (!m_.gone(h) && m_.first(h)) add(h);
        while (!open.empty()) {
            const auto [sizes, h] = open.top();
            open.pop();
            if (!(m_.length(h) / target(m_.tail(h), m_.head(h)) >= sizes)) continue; // split since
            const std::uint32_t v = split(m_, h, 0.5 * (m_.at[m_.tail(h)] + m_.at[m_.head(h)]));
            if (m_.kind[v] == Kind::free) {
                const Place on = put(v, m_.at[v]);
                m_.size[v] = size_at(on);
                if (may_move(v, on.point)) m_.at[v] = on.point;
            }
            each_leaving(m_, v, [&](std::uint32_t k) {
                add(k);
                if (m_.twin[prev(k)] == kNone) add(prev(k));
            });
        }
    }

    void collapse_short() {
        const auto most = [&](std::uint32_t a, std::uint32_t b) { return kLong * target(a, b); };
        for (std::uint32_t h = 0; h < m_.twin.size(); ++h)
            if (!m_.gone(h) && m_.length(h) < kShort * target(m_.tail(h), m_.head(h)) && collapsible(m_, h, most))
                collapse(m_, h);
    }

    // By the greater sum of angles, as Delaunay.
    void flip_all() {
        bool changed = true;
        for (int sweep = 0; sweep < kMostFlips && changed; ++sweep) {
            changed = false;
            for (std::uint32_t h = 0; h < m_.twin.size(); ++h) {
                if (m_.gone(h) || m_.twin[h] == kNone || !m_.first(h) || !(opposite(h) > kFlat)) continue;
                if (!flippable(m_, h)) continue;
                flip(m_, h);
                changed = true;
            }
        }
    }

    // What the angles opposite of a side make more than half a turn, rad.
    [[nodiscard]] double opposite(std::uint32_t h) const {
        const auto at = [&](std::uint32_t k) {
            const Vec3 a = m_.at[m_.tail(k)] - m_.at[m_.apex(k)], b = m_.at[m_.head(k)] - m_.at[m_.apex(k)];
            return geom::angle(a, b);
        };
        return at(h) + at(m_.twin[h]) - std::numbers::pi;
    }

    [[nodiscard]] bool may_move(std::uint32_t v, const Vec3& to) const {
        bool may = true;
        each_leaving(m_, v, [&](std::uint32_t h) {
            may = may && faces_alike(m_.at[v], m_.at[m_.head(h)], m_.at[m_.apex(h)], to);
        });
        return may;
    }

    // Every free vertex to the middle of its fan, in which each triangle counts by how many of the wanted size it is.
    void move_all() {
        for (std::uint32_t v = 0; v < m_.at.size(); ++v) {
            if (m_.out[v] == kNone || m_.kind[v] != Kind::free) continue;
            Vec3 sum;
            double all = 0;
            each_leaving(m_, v, [&](std::uint32_t h) {
                const std::uint32_t a = m_.head(h), b = m_.apex(h);
                const double size = (m_.size[v] + m_.size[a] + m_.size[b]) / 3;
                const double weight = norm(cross(m_.at[a] - m_.at[v], m_.at[b] - m_.at[v])) / (size * size);
                sum = sum + weight / 3 * (m_.at[v] + m_.at[a] + m_.at[b]);
                all += weight;
            });
            if (!(all > 0)) continue;
            const Place on = put(v, 1 / all * sum);
            if (!may_move(v, on.point)) continue;
            m_.at[v] = on.point;
            m_.size[v] = size_at(on);
        }
    }

    const Surface& surface_;
    const Locator& locator_;
    std::vector<double>& sizes_;
    Editable m_;
};

struct Off {
    double far = 0; // mm
    Vec3 at;
};

// How far these places are from the nearest of a surface.
std::vector<Place> nearest(const Locator& locator, const std::vector<Vec3>& points) {
    std::vector<Place> out(points.size());
    parallel::for_chunks(points.size(), kAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) out[i] = locator.nearest(points[i]);
    });
    return out;
}

// Middles of sides, each once, and of triangles; with the length of the side, or of the longest.
void middles(const Surface& s, std::vector<Vec3>& points, std::vector<double>& lengths) {
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        double longest = 0;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const double length = side_length(s, h);
            longest = std::max(longest, length);
            if (s.twin[h] != kNone && s.twin[h] < h) continue;
            points.push_back(0.5 * (s.vertices[s.tail(h)] + s.vertices[s.head(h)]));
            lengths.push_back(length);
        }
        points.push_back(1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]));
        lengths.push_back(longest);
    }
}

void farther(Off& to, const std::vector<Vec3>& points, const std::vector<Place>& places) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const double far = distance(points[i], places[i].point); far > to.far) to = {far, points[i]};
}

// Makes sizes shorter where chords of `now` are farther from `s` than the tolerance; false if nowhere.
bool corrected(const Surface& s, const Locator& locator, const Surface& now, double tolerance,
               std::vector<double>& sizes, Off& off) {
    std::vector<Vec3> points;
    std::vector<double> lengths;
    middles(now, points, lengths);
    const auto places = nearest(locator, points);
    farther(off, points, places);
    bool out = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double far = distance(points[i], places[i].point);
        if (!(far > tolerance)) continue;
        const double most = std::max(kLeast * tolerance, lengths[i] * std::sqrt(tolerance / far));
        for (const std::uint32_t v : s.triangles[places[i].triangle]) {
            out = out || most < sizes[v];
            sizes[v] = std::min(sizes[v], most);
        }
    }
    if (out) grade(s, sizes);
    return out;
}

double triangles(const Surface& s, std::span<const double> sizes) {
    double out = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        const double size = (sizes[a] + sizes[b] + sizes[c]) / 3;
        out += area(s, t) / (std::sqrt(3) / 4 * size * size);
    }
    return out;
}

} // namespace

Fitted fitted(const Surface& s, const Options& o) {
    auto size = sizes(s, o.longest, o.tolerance);
    if (!(triangles(s, size) <= kMostTriangles))
        throw Error(Exit::usage, "cannot remesh to sides of " + shortest_text(o.longest) +
                                     " mm: that takes more than 20 million triangles; ask for longer ones");
    const Locator locator(s);
    Fitter fitter(s, locator, size, editable(s, size, o.tolerance));
    fitter.run();
    Fitted out{compact(fitter.result()), 0, {}};
    Off off;
    for (int k = 0; corrected(s, locator, out.surface, o.tolerance, size, off) && k < kCorrections; ++k) {
        fitter.run();
        out.surface = compact(fitter.result());
        off = {};
    }
    const Locator on_new(out.surface);
    farther(off, s.vertices, nearest(on_new, s.vertices));
    out.off = off.far;
    out.off_at = off.at;
    return out;
}

} // namespace filum::surface::fit
