#include "metrics/surface/load.hpp"

#include "base/error.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::metrics::surface {

namespace {

constexpr double kAlongLoad = 0.9659258262890683; // cosine of 15 degrees
constexpr int kDirections = 180;

bool known(const Vec3& v) { return std::isfinite(v.x + v.y + v.z) && norm(v) > 0; }

double stress(const Surface& s, const filum::surface::Field* s1, const filum::surface::curve::Place& at) {
    if (s1 == nullptr) return 1;
    const auto w = filum::surface::curve::barycentric(s, at);
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += w[k] * s1->values[s.triangles[at.triangle][k]];
    return std::isfinite(sum) ? std::abs(sum) : 0;
}

std::uint32_t nearest_corner(const Surface& s, const filum::surface::curve::Place& at) {
    std::uint32_t best = s.triangles[at.triangle][0];
    for (const std::uint32_t v : s.triangles[at.triangle])
        if (distance(s.vertices[v], at.point) < distance(s.vertices[best], at.point)) best = v;
    return best;
}

Vec3 at_nearest_corner(const Surface& s, const filum::surface::Field& d1, const filum::surface::curve::Place& at) {
    const Vec3 d = d1.vector(nearest_corner(s, at));
    return known(d) ? 1 / norm(d) * d : Vec3{};
}

Vec3 in_plane(const Vec3& v, const Vec3& n) { return v - dot(v, n) * n; }

} // namespace

Vec3 direction(const Surface& s, const filum::surface::Field& d1, const filum::surface::curve::Place& at) {
    const auto w = filum::surface::curve::barycentric(s, at);
    const auto& corners = s.triangles[at.triangle];
    const auto most = static_cast<std::size_t>(std::max_element(w.begin(), w.end()) - w.begin());
    const Vec3 lead = d1.vector(corners[most]);
    if (!known(lead)) return {};
    Vec3 sum{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 v = d1.vector(corners[k]);
        if (known(v)) sum = sum + (dot(v, lead) < 0 ? -1 : 1) * std::max(0.0, w[k]) / norm(v) * v;
    }
    return geom::unit(sum, 1 / norm(lead) * lead);
}

std::vector<LoadCase> load_cases(const filum::surface::Sheet& sheet) {
    std::vector<LoadCase> out;
    for (const auto& f : sheet.fields) {
        if (!f.name.starts_with("stress.") || !f.name.ends_with(".d1")) continue;
        if (f.components != 3)
            throw Error(Exit::bad_input, "cannot measure load: field '" + f.name + "' is not a field of vectors");
        LoadCase c{f.name.substr(7, f.name.size() - 10), nullptr, &f};
        for (const auto& g : sheet.fields)
            if (g.name == "stress." + c.name + ".s1") c.s1 = &g;
        if (c.s1 != nullptr && c.s1->components != 1)
            throw Error(Exit::bad_input, "cannot measure load: field '" + c.s1->name + "' is not a field of numbers");
        out.push_back(c);
    }
    return out;
}

LoadFigures adequacy(std::span<const Sample> samples, const Surface& s, const LoadCase& load) {
    LoadFigures out;
    double all = 0, sum = 0, flat = 0, weight = 0;
    for (const Sample& p : samples) {
        all += p.length;
        const Vec3 d = direction(s, *load.d1, p.foot);
        if (!known(d)) continue;
        sum += p.length;
        const Vec3 t = in_plane(p.tangent, p.normal), e = in_plane(d, p.normal);
        out.mean += p.length * std::abs(dot(p.tangent, d));
        out.best += p.length * norm(e);
        if (!(norm(t) > 0) || !(norm(e) > 0)) continue;
        const double cosine = std::min(1.0, std::abs(dot(t, e)) / (norm(t) * norm(e)));
        const double w = p.length * stress(s, load.s1, p.foot);
        flat += p.length;
        weight += w;
        out.tangential += p.length * cosine;
        out.weighted += w * cosine;
        out.within += cosine >= kAlongLoad ? p.length : 0;
    }
    const auto over = [](double& v, double by) { v = by > 0 ? v / by : std::nan(""); };
    out.known = all > 0 ? sum / all : 0;
    over(out.mean, sum);
    over(out.best, sum);
    over(out.tangential, flat);
    over(out.within, flat);
    over(out.weighted, weight);
    for (int k = 0; k < kDirections; ++k)
        out.random += std::abs(std::cos(std::numbers::pi * (k + 0.5) / kDirections)) / kDirections;
    return out;
}

PaperLoad paper_adequacy(std::span<const Sample> samples, const Surface& s, std::span<const LoadCase> loads) {
    PaperLoad out;
    std::vector<geom::Vec2> flat(loads.size()); // directions in the tangent plane
    double n = 0;
    for (const Sample& p : samples) {
        double mean = 0, best = 0, random = 0;
        bool any = false;
        const Vec3 x = in_plane(p.tangent, p.normal), y = cross(p.normal, x);
        for (std::size_t k = 0; k < loads.size(); ++k) {
            const Vec3 d = at_nearest_corner(s, *loads[k].d1, p.foot);
            any = any || known(d);
            mean = std::max(mean, std::abs(dot(d, p.tangent)));
            flat[k] = norm(x) > 0 ? geom::Vec2{dot(d, x) / norm(x), dot(d, y) / norm(x)} : geom::Vec2{};
            best = std::max(best, norm(flat[k]));
        }
        if (!any) continue;
        for (int i = 0; i < kDirections; ++i) {
            const double a = std::numbers::pi * (i + 0.5) / kDirections;
            double most = 0;
            for (const auto& f : flat) most = std::max(most, std::abs(dot(f, geom::Vec2{std::cos(a), std::sin(a)})));
            random += most / kDirections;
        }
        ++n;
        out.mean += mean;
        out.best += best;
        out.random += random;
    }
    if (n > 0) {
        out.mean /= n;
        out.best /= n;
        out.random /= n;
    }
    return out;
}

Pull pull(std::span<const LoadCase> loads, std::uint32_t vertex, const Vec3& t) {
    Pull out;
    for (const LoadCase& load : loads) {
        const Vec3 d = load.d1->vector(vertex);
        const double s = load.s1 != nullptr ? load.s1->values[vertex] : 1;
        if (!known(d) || !std::isfinite(s) || !(s > 0)) continue;
        out.along = std::max(out.along, s * std::abs(dot(d, t)) / norm(d));
        out.most = std::max(out.most, s);
    }
    return out;
}

double pull_adequacy(std::span<const Sample> samples, const Surface& s, std::span<const LoadCase> loads) {
    double along = 0, most = 0;
    for (const Sample& p : samples) {
        const Pull at = pull(loads, nearest_corner(s, p.foot), p.tangent);
        along += p.length * at.along;
        most += p.length * at.most;
    }
    return most > 0 ? along / most : std::nan("");
}

} // namespace filum::metrics::surface
