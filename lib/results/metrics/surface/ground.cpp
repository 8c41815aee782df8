#include "metrics/surface/ground.hpp"

#include "parallel/parallel.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>

namespace filum::metrics::surface {

namespace {

constexpr int kHalvings = 6;      // of a segment whose ends no straight line on the surface connects
constexpr double kPoint = 1e-9;   // mm: shorter segments are points
constexpr double kOnRim = 1e-6;   // weight of a corner: below it a place is on the opposite side
constexpr double kBeside = 0.05;  // of the bead: greatest distance past a rim that counts as on the surface
constexpr double kInside = -1e-9; // weight of a corner: from it on a place is inside the triangle

filum::surface::curve::Place nearest(const filum::surface::curve::Locator& locator, const Vec3& p, const Vec3& axis,
                                     double farther) {
    const filum::surface::curve::Place any = locator.nearest(p);
    if (axis == Vec3{}) return any;
    const filum::surface::curve::Place facing = locator.nearest(p, axis);
    const bool near = facing.triangle != filum::surface::curve::kNone &&
                      distance(p, facing.point) <= distance(p, any.point) + farther;
    return near ? facing : any;
}

bool on_rim(const Surface& s, const filum::surface::curve::Place& at) {
    const auto w = filum::surface::curve::barycentric(s, at);
    for (std::uint32_t k = 0; k < 3; ++k) // at a corner, whose triangle may have no side on that rim
        if (w[k] > 1 - 2 * kOnRim && s.on_rim(s.triangles[at.triangle][k])) return true;
    for (std::uint32_t k = 0; k < 3; ++k)
        if (w[k] < kOnRim && s.twin[3 * at.triangle + (k + 1) % 3] == filum::surface::curve::kNone) return true;
    return false;
}

Vec3 axis_at(const Fibre& c, std::size_t stretch, double t) {
    const Vec3 v = (1 - t) * c.axes[stretch] + t * c.axes[stretch + 1];
    return norm(v) > 0.5 ? v : Vec3{};
}

bool inside(const Surface& s, const filum::surface::curve::Place& place) {
    const auto w = filum::surface::curve::barycentric(s, place);
    return std::min({w[0], w[1], w[2]}) >= kInside;
}

// Projects one segment of a chain onto the finer surface.
class Projector {
  public:
    Projector(const Ground& ground, double level, Shadow& out)
        : ground_(ground), surface_(ground.finer.surface), level_(level), out_(out) {}

    void stretch(const Fibre& c, std::size_t i, double from, double to, int halvings = 0) {
        const filum::surface::curve::Place a = place(c, i, from), b = place(c, i, to);
        const ShadowState a_state = shadow_state(c, i, from, a), b_state = shadow_state(c, i, to, b);
        if (a_state != ShadowState::present && a_state == b_state) {
            const double length = (to - from) * (c.along[i + 1] - c.along[i]);
            (a_state == ShadowState::beside ? out_.beside : out_.aloft) += length;
            if (a_state == ShadowState::beside) out_.beside_area += length * c.width[i];
            return;
        }
        const filum::surface::curve::Line way = a.triangle == b.triangle ? filum::surface::curve::Line{{a, b}, false}
                                                                         : filum::surface::curve::join(surface_, a, b);
        const std::size_t n = way.places.size();
        const bool whole = n > 2 || a.triangle == b.triangle || inside(surface_, {a.triangle, b.point}) ||
                           inside(surface_, {b.triangle, a.point});
        if ((!whole || a_state != b_state) && halvings < kHalvings) {
            stretch(c, i, from, (from + to) / 2, halvings + 1);
            return stretch(c, i, (from + to) / 2, to, halvings + 1);
        }
        if (!whole) {
            out_.lost += (to - from) * (c.along[i + 1] - c.along[i]);
            add(c, i, a.triangle, a.point, a.point);
            return add(c, i, b.triangle, b.point, b.point);
        }
        if (n == 2)
            return add(c, i, inside(surface_, {a.triangle, b.point}) ? a.triangle : b.triangle, a.point, b.point);
        for (std::size_t k = 0; k + 1 < n; ++k)
            add(c, i, way.places[k].triangle, way.places[k].point, way.places[k + 1].point);
    }

  private:
    [[nodiscard]] filum::surface::curve::Place place(const Fibre& c, std::size_t i, double t) const {
        return ground_.fine_foot(at(c, i, t), axis_at(c, i, t));
    }
    static Vec3 at(const Fibre& c, std::size_t i, double t) {
        return c.points[i] + t * (c.points[i + 1] - c.points[i]);
    }
    // Whether a place of the path has a shadow, or why it has none.
    enum class ShadowState : std::uint8_t { present, beside, aloft };
    [[nodiscard]] ShadowState shadow_state(const Fibre& c, std::size_t i, double t,
                                           const filum::surface::curve::Place& foot) const {
        const Vec3 p = at(c, i, t), way = p - foot.point;
        if (past_rim(surface_, foot, p, c.width[i])) return ShadowState::beside;
        return norm(way) > level_ + c.width[i] / 2 ? ShadowState::aloft : ShadowState::present;
    }
    void add(const Fibre& c, std::size_t i, std::uint32_t triangle, const Vec3& a, const Vec3& b) {
        out_.segments.push_back({triangle, a, distance(a, b) > kPoint ? b : a});
        out_.width.push_back(c.width[i]);
    }

    const Ground& ground_;
    const Surface& surface_;
    double level_; // mm
    Shadow& out_;
};

} // namespace

bool past_rim(const Surface& s, const filum::surface::curve::Place& foot, const Vec3& p, double width) {
    const Vec3 way = p - foot.point, n = filum::surface::normal(s, foot.triangle);
    return norm(way - dot(way, n) * n) > kBeside * width && on_rim(s, foot);
}

Ground::Ground(const Surface& s, double edge)
    : surface(s), finer(filum::surface::finer(s, edge)), normals_(filum::surface::curve::vertex_normals(s)),
      locator_(s), fine_locator_(finer.surface), farther_(2 * edge) {}

filum::surface::curve::Place Ground::foot(const Vec3& p, const Vec3& axis) const {
    return nearest(locator_, p, axis, farther_);
}
filum::surface::curve::Place Ground::fine_foot(const Vec3& p, const Vec3& axis) const {
    return nearest(fine_locator_, p, axis, farther_);
}
Vec3 Ground::normal(const filum::surface::curve::Place& place) const {
    return filum::surface::curve::normal_at(surface, normals_, place);
}

std::vector<Sample> samples(const Fibres& fibres, const Ground& ground, double step, int threads) {
    std::vector<Sample> out;
    for (std::uint32_t k = 0; k < fibres.all.size(); ++k) {
        const Fibre& c = fibres.all[k];
        const auto n = static_cast<std::size_t>(std::max(1.0, std::round(c.length() / step)));
        const double length = c.length() / static_cast<double>(n);
        std::size_t stretch = 0;
        Vec3 a = c.points.front();
        for (std::size_t i = 0; i < n; ++i) {
            Sample s{.chain = k, .along = (static_cast<double>(i) + 0.5) * length, .length = length, .a = a};
            s.at = point_at(c, s.along, stretch);
            s.layer = c.layer[stretch];
            s.width = c.width[stretch];
            s.hairpin = c.role[stretch] == toolpath::Role::hairpin;
            const Vec3 here = c.points[stretch + 1] - c.points[stretch];
            s.axis = axis_at(c, stretch, (s.along - c.along[stretch]) / norm(here));
            s.b = i + 1 == n ? c.points.back() : point_at(c, static_cast<double>(i + 1) * length, stretch);
            const Vec3 way = s.b - s.a;
            s.tangent = norm(way) > 0.1 * length ? 1 / norm(way) * way : 1 / norm(here) * here;
            a = s.b;
            out.push_back(s);
        }
    }
    parallel::for_chunks(out.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            out[i].foot = ground.foot(out[i].at, out[i].axis);
            out[i].off = distance(out[i].at, out[i].foot.point);
            out[i].beside = past_rim(ground.surface, out[i].foot, out[i].at, out[i].width);
            out[i].normal = ground.normal(out[i].foot);
        }
    });
    return out;
}

Feet feet(const Fibres& fibres, const Ground& ground, int threads) {
    Feet out;
    std::vector<std::vector<Weighted>> off(fibres.all.size());
    out.normals.resize(fibres.all.size());
    parallel::for_chunks(fibres.all.size(), 1, threads, [&](std::size_t k, std::size_t) {
        const Fibre& c = fibres.all[k];
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const filum::surface::curve::Place at = ground.foot(c.points[i], c.axes[i]);
            const double before = i > 0 ? c.along[i] - c.along[i - 1] : 0;
            const double after = i + 1 < c.points.size() ? c.along[i + 1] - c.along[i] : 0;
            const double width = c.width[std::min(i, c.width.size() - 1)], away = distance(c.points[i], at.point);
            const bool on = away <= width && !past_rim(ground.surface, at, c.points[i], width);
            out.normals[k].push_back(on || c.axes[i] == Vec3{} ? ground.normal(at) : c.axes[i]);
            off[k].push_back({away, (before + after) / 2});
        }
    });
    for (const auto& part : off) out.off.insert(out.off.end(), part.begin(), part.end());
    return out;
}

Shadow shadow(const Fibres& fibres, const Ground& ground, const ShadowOptions& options, int threads) {
    std::vector<Shadow> parts(fibres.all.size());
    parallel::for_chunks(parts.size(), 1, threads, [&](std::size_t k, std::size_t) {
        const Fibre& c = fibres.all[k];
        Projector projector(ground, options.level, parts[k]);
        for (std::size_t i = 0; i + 1 < c.points.size(); ++i) {
            if (c.layer[i] != options.layer) continue;
            const auto n = static_cast<std::size_t>(std::ceil((c.along[i + 1] - c.along[i]) / options.step));
            for (std::size_t j = 0; j < n; ++j)
                projector.stretch(c, i, static_cast<double>(j) / static_cast<double>(n),
                                  static_cast<double>(j + 1) / static_cast<double>(n));
        }
    });
    Shadow out;
    for (const Shadow& p : parts) {
        out.segments.insert(out.segments.end(), p.segments.begin(), p.segments.end());
        out.width.insert(out.width.end(), p.width.begin(), p.width.end());
        out.lost += p.lost;
        out.beside += p.beside;
        out.beside_area += p.beside_area;
        out.aloft += p.aloft;
    }
    return out;
}

} // namespace filum::metrics::surface
