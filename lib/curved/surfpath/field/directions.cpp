#include "surfpath/field/directions.hpp"

#include "base/error.hpp"
#include "surface/directions/pull.hpp"
#include "surfpath/field/rings.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::surfpath::field {

namespace {

using surface::kNone;
using surface::directions::direction;
using surface::directions::doubled;
using surface::directions::transport;

constexpr double kFall = 0.25;       // factor of a weight in every round
constexpr double kLeastShare = 1e-4; // weights below this share of the prescribed one become 0
constexpr int kPatience = 3;         // rounds without improvement before the search ends
constexpr double kAround = 0.25;     // least radii around a place that bends too much in which weights are lowered, too

void add_stress(const surface::Sheet& sheet, const Cells& cells, double share, PrescribedDirections& out) {
    const auto pull = surface::directions::pull(sheet, cells, {});
    if (std::none_of(pull.trust.begin(), pull.trust.end(), [](double t) { return t > 0; }))
        throw Error(Exit::bad_input, "cannot follow the stress: the surface carries no tensile stress; run stressfield "
                                     "first");
    for (std::size_t v = 0; v < out.z.size(); ++v)
        out.z[v] += share * pull.trust[v] * doubled(pull.along[v], cells.normal[v]);
}

void add_given(const surface::Sheet& sheet, const Cells& cells, const DirectionMix& o, PrescribedDirections& out) {
    const auto it = std::find_if(sheet.fields.begin(), sheet.fields.end(),
                                 [&](const surface::Field& f) { return f.name == o.field && f.components == 3; });
    if (it == sheet.fields.end())
        throw Error(Exit::bad_input,
                    "cannot follow a direction: the surface carries no vector field '" + std::string(o.field) + "'");
    for (std::size_t v = 0; v < out.z.size(); ++v) {
        const Vec3 d = it->vector(v);
        if (const double l = norm(d); l > 0 && std::isfinite(l))
            out.z[v] += o.given * doubled(1 / l * d, cells.normal[v]);
    }
}

// Finds the vertices at which a prescribed field is not a finite number.
void find_unknown(const surface::Sheet& sheet, const Cells& cells, const DirectionMix& o, PrescribedDirections& out) {
    std::vector<char> unknown(out.z.size(), 0);
    for (const auto& f : sheet.fields) {
        const bool pull = f.name.starts_with("stress.") && (f.name.ends_with(".d1") || f.name.ends_with(".s1"));
        if (!(o.given > 0 && f.name == o.field) && !(o.stress > 0 && pull)) continue;
        for (std::size_t i = 0; i < f.values.size(); ++i)
            if (!std::isfinite(f.values[i])) unknown[i / f.components] = 1;
    }
    for (std::size_t v = 0; v < unknown.size(); ++v) {
        if (!unknown[v]) continue;
        if (out.unknown == 0) out.unknown_at = sheet.surface.vertices[v];
        out.unknown += cells.area[v];
    }
}

void add_angle(const Surface& s, const Cells& cells, const DirectionMix& o, PrescribedDirections& out) {
    const Vec3 to = 1 / norm(o.reference) * o.reference;
    const Complex turned = std::polar(1.0, 2 * o.turn);
    for (std::size_t v = 0; v < out.z.size(); ++v) { // doubled() has the squared length of the tangential part
        const Complex z = doubled(to, cells.normal[v]);
        out.z[v] += o.angle * turned * z;
        // The weight is the squared sine of the angle between normal and reference direction, so smoothing reaches
        // kSmoothed over that sine. From a whole spacing on the surroundings decide.
        if (std::abs(z) >= kSmoothed * kSmoothed) continue;
        if (out.upright == 0) out.upright_at = s.vertices[v];
        out.upright += cells.area[v];
    }
}

void add_rims(const Surface& s, const Cells& cells, double share, PrescribedDirections& out) {
    for (const auto& rim : s.rims)
        for (const std::uint32_t h : rim.sides) {
            const Vec3 d = s.vertices[s.head(h)] - s.vertices[s.tail(h)];
            for (const std::uint32_t v : {s.tail(h), s.head(h)}) {
                const Complex z = doubled(d, cells.normal[v]);
                out.z[v] += std::abs(z) > 0 ? share / 2 / std::abs(z) * z : Complex{};
            }
        }
}

// Curvature of the lines through a triangle, 1/mm: the derivative of their angle along them.
double bend(const Surface& s, const Cells& cells, std::span<const Complex> z, std::uint32_t t) {
    const auto& c = s.triangles[t];
    const Vec3 n = surface::normal(s, t);
    std::array<Complex, 3> u;
    Complex sum{};
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = z[c[k]] * transport(cells.normal[c[k]], n);
        if (!(std::abs(u[k]) > rules::kTiny)) return 0;
        u[k] /= std::abs(u[k]);
        sum += u[k];
    }
    if (!(std::abs(sum) > rules::kTiny)) return std::numeric_limits<double>::infinity();
    const Vec3 d = direction(sum, n);
    Vec3 slope;
    const double twice_area = 2 * surface::area(s, t);
    for (std::size_t k = 0; k < 3; ++k) { // half of the doubled angle, relative to the mean
        const double angle = std::arg(u[k] * std::conj(sum)) / 2;
        slope = slope + angle / twice_area * cross(n, s.vertices[c[(k + 2) % 3]] - s.vertices[c[(k + 1) % 3]]);
    }
    return std::abs(dot(slope, d));
}

} // namespace

PrescribedDirections prescribed(const surface::Sheet& sheet, const Cells& cells, const DirectionMix& o) {
    const std::size_t n = sheet.surface.vertices.size();
    PrescribedDirections out{std::vector<Complex>(n), std::vector<double>(n, 0), 0, {}, 0, {}};
    if (o.given > 0) add_given(sheet, cells, o, out);
    if (o.stress > 0) add_stress(sheet, cells, o.stress, out);
    if (o.angle > 0) add_angle(sheet.surface, cells, o, out);
    if (o.rim > 0) add_rims(sheet.surface, cells, o.rim, out);
    if (o.rings > 0) {
        const RingField found = ring_field(sheet, cells);
        for (std::size_t v = 0; v < n; ++v) out.z[v] += o.rings * found.z[v];
    }
    find_unknown(sheet, cells, o, out);
    for (std::size_t v = 0; v < n; ++v) {
        const double much = std::abs(out.z[v]);
        out.weight[v] = std::min(1.0, much);
        if (much > 0) out.z[v] /= much;
    }
    if (std::none_of(out.weight.begin(), out.weight.end(), [](double w) { return w > rules::kTiny; }))
        throw Error(Exit::bad_input, "cannot follow a direction: none is defined on the surface; see --follow "
                                     "and --reference");
    return out;
}

namespace {

struct BendStatistics {
    double most = 0, tight = 0; // greatest curvature, 1/mm; mm2 where it is above 1 / radius
    double excess = 0;          // mm: the integral of the curvature above 1 / radius
    Vec3 at;                    // place of the greatest
    std::vector<char> where;    // per vertex: whether it is a corner of a triangle that bends too much
};

BendStatistics bends(const Surface& s, const Cells& cells, std::span<const Complex> z, double radius) {
    BendStatistics out;
    out.where.assign(z.size(), 0);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const double k = bend(s, cells, z, t);
        if (k > out.most) {
            out.most = k;
            out.at = s.vertices[s.triangles[t][0]];
        }
        if (!(k * radius > 1)) continue;
        out.tight += surface::area(s, t);
        out.excess += (k - 1 / radius) * surface::area(s, t);
        for (const std::uint32_t v : s.triangles[t]) out.where[v] = 1;
    }
    return out;
}

// Extends the marked set by about `reach` mm, in steps of a mean edge.
void widen(const Cells& cells, double reach, std::vector<char>& where) {
    for (double done = 0; done < reach; done += cells.mean_side) {
        auto wider = where;
        for (const auto& side : cells.sides)
            if (where[side.a] != where[side.b]) wider[side.a] = wider[side.b] = 1;
        where.swap(wider);
    }
}

} // namespace

Directions smooth(const Surface& s, const Cells& cells, const PrescribedDirections& prescribed, double length,
                  double radius) {
    const std::size_t n = s.vertices.size();
    std::vector<double> share(n, 1), best_share, weight = prescribed.weight;
    std::vector<Complex> best;
    const double let_go = 4 * length * length / (radius * radius); // diffuses over half a radius in a round
    BendStatistics least;
    auto given = prescribed.z;
    surface::directions::Smoother smoother(cells, length);
    for (int round = 0, idle = 0; round < rules::kMostRounds && idle <= kPatience; ++round) {
        const auto z = smoother.smoothed(given, weight);
        BendStatistics now = bends(s, cells, z, radius);
        idle = best.empty() || now.excess < least.excess ? 0 : idle + 1;
        auto where = now.where;
        if (idle == 0) {
            best = z;
            best_share = share;
            least = std::move(now);
        }
        if (!(least.tight > 0)) break;
        widen(cells, kAround * radius * (1 + idle), where);
        for (std::size_t v = 0; v < n; ++v) {
            if (where[v]) share[v] = share[v] * kFall > kLeastShare ? share[v] * kFall : 0;
            weight[v] = prescribed.weight[v] * share[v];
            if (share[v] > 0 || !(std::abs(z[v]) > rules::kTiny)) continue;
            // nothing is prescribed any more: the direction of the last round, made of size 1, diffuses
            weight[v] = let_go;
            given[v] = 1 / std::abs(z[v]) * z[v];
        }
    }
    Directions out{{}, least.most, least.tight, least.at, 0};
    for (std::size_t v = 0; v < n; ++v) {
        out.along.push_back(direction(std::abs(best[v]) > 0 ? best[v] : Complex{1, 0}, cells.normal[v]));
        out.given_up += best_share[v] < 0.5 ? cells.area[v] : 0;
    }
    return out;
}

} // namespace filum::surfpath::field
