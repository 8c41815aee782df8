#include "judge.hpp"

#include "geodesic/query.hpp"
#include "geom/bvh.hpp"
#include "surface/curve/locate.hpp"

#include "random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace filum::trials {

namespace {

constexpr std::size_t kPlaces = 20'000; // on the surface
constexpr double kRipple = 0.02;        // spacings that a path may be off without turning: docs/surface-metrics.md
constexpr double kStep = 0.05;          // mm between places of the path that are looked at
constexpr double kFar = std::numeric_limits<double>::infinity();

// A chain: what is laid without a break.
struct Fibre {
    std::vector<Vec3> points, normals;
    std::vector<char> hairpin; // per stretch
    std::vector<double> way, widths;
};

std::vector<Fibre> chains(const std::vector<Span>& spans, double& jump) {
    std::vector<Fibre> out;
    std::optional<Vec3> at;
    for (const Span& s : spans) {
        const double gap = at ? distance(*at, s.points.front()) : 0;
        jump = std::max(jump, gap);
        const bool lays = toolpath::extrudes(s.role),
                   fresh = out.empty() || gap > 1e-6 || !at || out.back().points.empty();
        at = s.points.back();
        if (!lays) {
            if (!out.empty() && !out.back().points.empty()) out.emplace_back();
            continue;
        }
        if (fresh && (out.empty() || !out.back().points.empty())) out.emplace_back();
        Fibre& c = out.back();
        for (std::size_t i = c.points.empty() ? 0 : 1; i < s.points.size(); ++i) {
            if (!c.points.empty()) c.hairpin.push_back(s.role == toolpath::Role::hairpin);
            c.way.push_back(c.points.empty() ? 0 : c.way.back() + distance(c.points.back(), s.points[i]));
            c.points.push_back(s.points[i]);
            c.normals.push_back(s.normals[i]);
            c.widths.push_back(s.width_at(i));
        }
    }
    std::erase_if(out, [](const Fibre& c) { return c.points.size() < 2; });
    return out;
}

struct At {
    Vec3 point, normal;
    std::size_t stretch;
};

At at(const Fibre& c, double way) {
    const auto it = std::upper_bound(c.way.begin() + 1, c.way.end() - 1, way);
    const auto i = static_cast<std::size_t>(it - c.way.begin()) - 1;
    const double l = c.way[i + 1] - c.way[i], t = l > 0 ? std::clamp((way - c.way[i]) / l, 0.0, 1.0) : 0;
    return {c.points[i] + t * (c.points[i + 1] - c.points[i]), (1 - t) * c.normals[i] + t * c.normals[i + 1], i};
}

// The circle through three points, drawn on the plane that touches the surface.
void measure_turns(const Fibre& c, const Asked& asked, Judged& out) {
    const double limit = asked.least_radius > 0 ? 1 / asked.least_radius : kFar;
    const double ripple = kRipple * asked.spacing,
                 reach = std::max(asked.spacing / 4, 2 * std::sqrt(ripple * asked.least_radius));
    for (double way = reach; way + reach <= c.way.back(); way += kStep) {
        const At here = at(c, way);
        const Vec3 n = 1 / norm(here.normal) * here.normal;
        const auto flat = [&](const Vec3& v) { return v - dot(v, n) * n; };
        const Vec3 a = flat(here.point - at(c, way - reach).point), b = flat(at(c, way + reach).point - here.point);
        const double sides = norm(a) * norm(b) * norm(a + b);
        const double k = sides > 0 ? 2 * norm(cross(a, b)) / sides : dot(a, b) < 0 ? kFar : 0;
        const double bend = dot(a, b) < 0 ? std::max(k, 2 / reach) : k;
        out.least_radius = std::min(out.least_radius, bend > 0 ? 1 / bend : kFar);
        if (!(bend > 1.02 * limit)) continue;
        out.tight += kStep;
        if (c.hairpin[here.stretch]) continue;
        if (out.unmarked == 0) out.unmarked_at = here.point;
        out.unmarked += kStep;
    }
}

struct FibreSegment {
    Vec3 a, b, normal;
    std::size_t chain;
    double way, along, width; // mm
};

geom::Box3 box(const Vec3& a, const Vec3& b, double by) {
    return {{std::min(a.x, b.x) - by, std::min(a.y, b.y) - by, std::min(a.z, b.z) - by},
            {std::max(a.x, b.x) + by, std::max(a.y, b.y) + by, std::max(a.z, b.z) + by}};
}

class FibreSegments {
  public:
    explicit FibreSegments(const std::vector<Fibre>& chains) : all_(cut(chains)), tree_(boxes()) {}

    template <class F>
    void near(const Vec3& p, const Vec3& n, double reach, const F& f) const {
        tree_.visit(box(p, p, reach), [&](std::uint32_t i) {
            const FibreSegment& g = all_[i];
            const Vec3 d = g.b - g.a;
            const double l2 = dot(d, d), t = l2 > 0 ? std::clamp(dot(p - g.a, d) / l2, 0.0, 1.0) : 0;
            const double far = distance(p, g.a + t * d);
            if (far <= reach && dot(g.normal, n) > 0) f(g, far, g.way + t * g.along);
        });
    }
    [[nodiscard]] const std::vector<FibreSegment>& all() const { return all_; }
    [[nodiscard]] const geom::Bvh& tree() const { return tree_; }

  private:
    static std::vector<FibreSegment> cut(const std::vector<Fibre>& chains) {
        std::vector<FibreSegment> out;
        for (std::size_t c = 0; c < chains.size(); ++c)
            for (std::size_t i = 0; i + 1 < chains[c].points.size(); ++i) {
                const Fibre& k = chains[c];
                out.push_back({k.points[i], k.points[i + 1], k.normals[i] + k.normals[i + 1], c, k.way[i],
                               k.way[i + 1] - k.way[i], (k.widths[i] + k.widths[i + 1]) / 2});
            }
        return out;
    }
    std::vector<geom::Box3> boxes() const {
        std::vector<geom::Box3> out;
        for (const FibreSegment& g : all_) out.push_back(box(g.a, g.b, 0));
        return out;
    }
    std::vector<FibreSegment> all_;
    geom::Bvh tree_;
};

// Covered is what lies under a bead in the width that its span states.
void measure_area(const Surface& s, const FibreSegments& path, double spacing, Judged& out) {
    std::vector<double> sum;
    double widest = spacing, deposited = 0;
    for (const FibreSegment& g : path.all()) {
        widest = std::max(widest, g.width);
        deposited += g.along * g.width;
    }
    for (const auto& [a, b, c] : s.triangles)
        sum.push_back((sum.empty() ? 0 : sum.back()) +
                      norm(cross(s.vertices[b] - s.vertices[a], s.vertices[c] - s.vertices[a])) / 2);
    out.area = sum.back();
    Random random(7);
    std::size_t covered = 0, bare = 0;
    for (std::size_t i = 0; i < kPlaces; ++i) {
        const double at = (static_cast<double>(i) + random.unit()) / kPlaces * out.area;
        const auto t = static_cast<std::uint32_t>(std::lower_bound(sum.begin(), sum.end() - 1, at) - sum.begin());
        double u = random.unit(), v = random.unit();
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        const auto& [a, b, c] = s.triangles[t];
        const Vec3 p = s.vertices[a] + u * (s.vertices[b] - s.vertices[a]) + v * (s.vertices[c] - s.vertices[a]);
        double least = kFar;
        bool under = false;
        path.near(p, surface::normal(s, t), std::max(spacing, widest / 2),
                  [&](const FibreSegment& g, double far, double) {
                      least = std::min(least, far);
                      under = under || far <= g.width / 2;
                  });
        covered += under ? 1 : 0;
        bare += least > spacing ? 1 : 0;
    }
    out.covered = static_cast<double>(covered) / kPlaces;
    out.bare = static_cast<double>(bare) / kPlaces;
    out.overlap = deposited / out.area - out.covered;
}

// Where rings come from, and how far from there they are.
class Rise {
  public:
    Rise(const Surface& s, const surface::curve::Locator& ground, surface::Sources from)
        : s_(s), ground_(ground), field_(geodesic::exact(s, with_rims(s, std::move(from)))) {}

    // True if it falls to both sides of the path: rings of both slopes of a ridge come together, as in a neck.
    [[nodiscard]] bool ridge(const At& at, const Vec3& along, double width) const {
        const Vec3 across = cross(at.normal, along), side = 0.5 * width / norm(across) * across;
        const double here = height(at.point, at.normal) - 0.2 * width;
        return height(at.point + side, at.normal) < here && height(at.point - side, at.normal) < here;
    }

  private:
    static surface::Sources with_rims(const Surface& s, surface::Sources out) {
        for (const auto& rim : s.rims)
            for (const auto h : rim.sides)
                out.segments.push_back({h / 3, s.vertices[s.tail(h)], s.vertices[s.head(h)]});
        return out;
    }
    [[nodiscard]] double height(const Vec3& p, const Vec3& normal) const {
        const auto q = ground_.nearest(p, normal);
        return q.triangle == surface::kNone ? 0 : geodesic::distance_at(s_, field_, q.triangle, q.point);
    }

    const Surface& s_;
    const surface::curve::Locator& ground_;
    geodesic::ExactField field_;
};

// Path on path, and path across path.
void measure_doubles(const std::vector<Fibre>& chains, const FibreSegments& path, const Rise* rise, double width,
                     Judged& out) {
    const double step = width / 4;
    for (std::size_t c = 0; c < chains.size(); ++c)
        for (double way = 0; way + step < chains[c].way.back(); way += step) {
            const At a = at(chains[c], way), b = at(chains[c], way + step);
            const Vec3 along = b.point - a.point;
            bool found = false;
            path.near(a.point, a.normal, 0.2 * width, [&](const FibreSegment& g, double, double on) {
                const Vec3 d = g.b - g.a;
                if (g.chain == c ? on < way + 3 * width : g.chain < c) return; // each pair once
                found = found || std::abs(dot(d, along)) > 0.966 * norm(d) * norm(along);
            });
            found = found && !(rise != nullptr && rise->ridge(a, along, width));
            if (found && out.doubled == 0) out.doubled_at = a.point;
            out.doubled += found ? step : 0;
        }
    for (std::uint32_t i = 0; i < path.all().size(); ++i) {
        const FibreSegment& g = path.all()[i];
        path.tree().visit(box(g.a, g.b, 0.01 * width), [&](std::uint32_t k) {
            const FibreSegment& h = path.all()[k];
            if (k <= i || (h.chain == g.chain && h.way - g.way - g.along < width) || dot(g.normal, h.normal) <= 0)
                return;
            const Vec3 n = g.normal + h.normal, d = g.b - g.a, e = h.b - h.a;
            const auto side = [&](const Vec3& from, const Vec3& way, const Vec3& p) {
                return dot(cross(way, p - from), n);
            };
            const bool crosses = (side(g.a, d, h.a) > 0) != (side(g.a, d, h.b) > 0) &&
                                 (side(h.a, e, g.a) > 0) != (side(h.a, e, g.b) > 0);
            if (crosses && std::abs(dot(h.a - g.a, n)) < 0.2 * width * norm(n)) ++out.crossings;
        });
    }
}

bool told(const Notes& notes, const std::string& word) {
    return std::any_of(notes.begin(), notes.end(),
                       [&](const Note& n) { return code_name(n).find(word) != std::string::npos; });
}

} // namespace

Judged judge(const Surface& s, const std::vector<Span>& spans, const Asked& asked) {
    Judged out;
    out.least_radius = kFar;
    const auto laid = chains(spans, out.jump);
    const surface::curve::Locator ground(s);
    for (const Fibre& c : laid) {
        out.length += c.way.back();
        measure_turns(c, asked, out);
        for (std::size_t i = 0; i + 1 < c.points.size(); ++i)
            for (const Vec3& p : {c.points[i], 0.5 * (c.points[i] + c.points[i + 1])})
                if (const double off = distance(ground.nearest(p).point, p); off > out.off) {
                    out.off = off;
                    out.off_at = p;
                }
    }
    const FibreSegments path(laid);
    measure_area(s, path, asked.spacing, out);
    std::optional<Rise> rise;
    if (asked.rings) rise.emplace(s, ground, asked.from);
    measure_doubles(laid, path, rise ? &*rise : nullptr, asked.spacing, out);
    return out;
}

std::vector<std::string> faults(const Surface& s, const std::vector<Span>& spans, const Judged& j, const Notes& notes,
                                const Asked& asked) {
    std::vector<std::string> out;
    const auto number = [](double v) { return std::to_string(v); };
    const auto place = [](const Vec3& p) {
        return std::to_string(p.x) + "," + std::to_string(p.y) + "," + std::to_string(p.z);
    };
    for (const Span& span : spans)
        for (const Vec3& p : span.points)
            if (!std::isfinite(norm(p))) return {"a point is no number"};
    for (const Note& n : notes)
        if (!std::isfinite(n.amount) || n.amount < 0 || n.amount > 1e9 || n.count > 1'000'000)
            out.push_back("note '" + code_name(n) + "' says " + number(n.amount) + ", " + std::to_string(n.count) +
                          " cases");
    if (j.jump > 1e-6) out.push_back("a span begins " + number(j.jump) + " mm from where one ended");
    if (asked.on_surface && j.off > 0.02)
        out.push_back("off the surface by " + number(j.off) + " mm at " + place(j.off_at));
    if (j.overlap > 0.055 && !told(notes, "area-doubled"))
        out.push_back("overlap " + number(j.overlap) + " is not told");
    if (j.bare > 0.015 && !told(notes, "no-line-near")) out.push_back("bare " + number(j.bare) + " is not told");
    if (j.covered < 0.945 && !told(notes, "area-bare")) out.push_back("covered " + number(j.covered) + " is not told");
    if (j.unmarked > 0)
        out.push_back("tight for " + number(j.unmarked) + " mm not marked, first at " + place(j.unmarked_at) +
                      ", least radius " + number(j.least_radius));
    if (j.tight > 0.5 && !told(notes, "too-tight")) out.push_back("tight for " + number(j.tight) + " mm, no note");
    if (asked.rings && j.doubled > 0.02 * j.length + 2 * asked.spacing)
        out.push_back("rings lie on each other for " + number(j.doubled) + " of " + number(j.length) +
                      " mm, first at " + place(j.doubled_at));
    if (s.triangles.empty()) out.push_back("no surface");
    return out;
}

} // namespace filum::trials
