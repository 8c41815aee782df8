#include "link3d/bead.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace filum::link3d {

namespace {

constexpr double kSame = 1e-6; // mm; points nearer than this are one

void append(Bead& b, Vec2 p, double w, bool per_point) {
    if (!b.points.empty() && geom::distance(b.points.back(), p) < kSame) return;
    b.points.push_back(p);
    if (per_point) b.width.push_back(w);
}

// Walks back along the end of the bead by `gap` mm.
void shorten(Bead& b, double gap) {
    const bool per_point = b.width.size() > 1;
    while (b.points.size() > 2) {
        const Vec2 last = b.points.back(), before = b.points[b.points.size() - 2];
        const double l = geom::distance(last, before);
        if (l > gap + kSame) break;
        gap -= l;
        b.points.pop_back();
        if (per_point) b.width.pop_back();
    }
    const std::size_t n = b.points.size();
    const double l = geom::distance(b.points[n - 2], b.points[n - 1]), t = l > 0 ? std::min(gap / l, 1.0) : 0;
    b.points[n - 1] = geom::lerp(b.points[n - 1], b.points[n - 2], t);
    if (per_point) b.width[n - 1] += t * (b.width[n - 2] - b.width[n - 1]);
}

} // namespace

double mean_width(const toolpath::Curve& curve) {
    return std::accumulate(curve.width.begin(), curve.width.end(), 0.0) / static_cast<double>(curve.width.size());
}

double length(std::span<const Vec2> line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += geom::distance(line[i], line[i + 1]);
    return sum;
}

double length(std::span<const geom::Vec3> line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += geom::distance(line[i], line[i + 1]);
    return sum;
}

Vec2 along(const toolpath::Curve& curve, const Place& place, double l) {
    const std::size_t n = curve.points.size();
    Vec2 at = place.point;
    for (std::size_t k = 1; k <= n; ++k) {
        if (!curve.closed && place.segment + k >= n) break;
        const Vec2 b = curve.points[(place.segment + k) % n];
        const double d = geom::distance(at, b);
        if (d > 0 && d >= l) return geom::lerp(at, b, l / d);
        l -= d, at = b;
    }
    return at;
}

double cut_gap(const toolpath::Curve& curve) {
    const double around = length(curve.points) + geom::distance(curve.points.back(), curve.points.front());
    constexpr double kRounded = 0.2146018366025517; // 1 - pi / 4
    return std::min(kRounded * mean_width(curve), around / 10);
}

Bead cut(const toolpath::Curve& curve, const Place& at, bool against, double gap) {
    const std::size_t n = curve.points.size();
    const bool per_point = curve.width.size() > 1;
    const std::size_t k = at.segment, next = (k + 1) % n;
    const double w = curve.width_at(k) + at.t * (curve.width_at(next) - curve.width_at(k));
    Bead b;
    b.points.reserve(n + 2);
    if (per_point) b.width.reserve(n + 2);
    append(b, at.point, w, per_point);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = against ? (k + n - i) % n : (next + i) % n;
        append(b, curve.points[j], curve.width_at(j), per_point);
    }
    append(b, at.point, w, per_point);
    if (b.points.size() < 2) b.points.push_back(at.point), b.width.push_back(w); // a curve of no length
    if (!per_point) b.width = {curve.width[0]};
    shorten(b, gap);
    return b;
}

Bead run(const toolpath::Curve& curve, bool against) {
    Bead b{curve.points, curve.width};
    if (against) {
        std::reverse(b.points.begin(), b.points.end());
        std::reverse(b.width.begin(), b.width.end());
    }
    return b;
}

void pin(Bead& bead, Vec2 p, double reach) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i)
        if (const double d = geom::point_segment_distance(bead.points[i], bead.points[i + 1], p); d < least)
            least = d, best = i;
    if (least > reach) return;
    if (bead.points[best] == p || bead.points[best + 1] == p) return;
    const double t = geom::nearest_parameter(bead.points[best], bead.points[best + 1], p);
    const auto at = static_cast<std::ptrdiff_t>(best + 1);
    if (bead.width.size() > 1)
        bead.width.insert(bead.width.begin() + at, bead.width[best] + t * (bead.width[best + 1] - bead.width[best]));
    bead.points.insert(bead.points.begin() + at, p);
}

namespace {

// A piece of the lane's area that is to come out of one place of the bead.
struct Share {
    std::uint32_t segment;
    double t, area;
};

// Which places of the bead make room for the lane.
std::vector<Share> shares(const Bead& bead, std::span<const Vec2> lane, double lane_width, double reach) {
    const toolpath::Curve line{false, bead.points, {1.0}};
    const SegmentIndex index(std::span(&line, 1));
    std::vector<Share> out;
    for (std::size_t i = 0; i + 1 < lane.size(); ++i) {
        const Vec2 d = lane[i + 1] - lane[i];
        const double l = geom::norm(d);
        const auto pieces = static_cast<std::size_t>(std::ceil(l / (reach / 16)));
        for (std::size_t k = 0; k < pieces; ++k) {
            const Vec2 m =
                geom::lerp(lane[i], lane[i + 1], (static_cast<double>(k) + 0.5) / static_cast<double>(pieces));
            std::array<double, 2> near{reach, reach};
            std::array<Share, 2> side{};
            index.within({m - Vec2{reach, reach}, m + Vec2{reach, reach}}, [&](std::uint32_t s, Vec2 a, Vec2 b) {
                const double t = geom::nearest_parameter(a, b, m);
                const Vec2 q = geom::lerp(a, b, t) - m;
                const std::size_t which = geom::cross(d, q) > 0 ? 0 : 1;
                if (const double e = geom::norm(q); e < near[which]) near[which] = e, side[which] = {s, t, 0};
                return true;
            });
            const int found = static_cast<int>(near[0] < reach) + static_cast<int>(near[1] < reach);
            for (std::size_t w = 0; w < 2; ++w)
                if (near[w] < reach)
                    side[w].area = lane_width * l / static_cast<double>(pieces) / found, out.push_back(side[w]);
        }
    }
    std::sort(out.begin(), out.end(), [](const Share& a, const Share& b) {
        return std::tie(a.segment, a.t, a.area) < std::tie(b.segment, b.t, b.area);
    });
    return out;
}

} // namespace

double thin_beside(Bead& bead, std::span<const Vec2> lane, double lane_width, double reach, double least) {
    const auto cuts = shares(bead, lane, lane_width, reach);
    Bead out;
    std::vector<double> take; // mm2 per point of `out`
    const auto push = [&](Vec2 p, double w) { out.points.push_back(p), out.width.push_back(w), take.push_back(0); };
    const auto width = [&](std::size_t i) { return bead.width.size() == 1 ? bead.width[0] : bead.width[i]; };
    push(bead.points[0], width(0));
    auto next = cuts.begin();
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
        const double l = geom::distance(bead.points[i], bead.points[i + 1]);
        const bool hit = next != cuts.end() && next->segment == i;
        const auto pieces = hit ? std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(l / (reach / 2)))) : 1;
        for (std::size_t k = 1; k <= pieces; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(pieces);
            push(k == pieces ? bead.points[i + 1] : geom::lerp(bead.points[i], bead.points[i + 1], t),
                 width(i) + t * (width(i + 1) - width(i)));
        }
        for (; next != cuts.end() && next->segment == i; ++next) {
            const double at = next->t * static_cast<double>(pieces);
            const auto k = std::min(static_cast<std::size_t>(at), pieces - 1);
            const std::size_t a = out.points.size() - 1 - pieces + k;
            take[a] += next->area * (1 - (at - static_cast<double>(k)));
            take[a + 1] += next->area * (at - static_cast<double>(k));
        }
    }
    // What a point cannot give moves on along the bead, then back.
    const std::size_t n = out.points.size();
    const auto mass = [&](std::size_t i) {
        return ((i > 0 ? geom::distance(out.points[i - 1], out.points[i]) : 0) +
                (i + 1 < n ? geom::distance(out.points[i], out.points[i + 1]) : 0)) /
               2;
    };
    double carry = 0, taken = 0;
    const auto settle = [&](std::size_t i) {
        const double can = std::max(0.0, (1 - least) * out.width[i] * mass(i));
        carry += take[i];
        take[i] = std::min(can, carry);
        carry -= take[i];
    };
    for (std::size_t i = 0; i < n; ++i) settle(i);
    for (std::size_t i = n; i-- > 0;) settle(i);
    for (std::size_t i = 0; i < n; ++i) {
        taken += take[i];
        if (const double m = mass(i); m > 0) out.width[i] -= take[i] / m;
    }
    bead = std::move(out);
    return taken;
}

} // namespace filum::link3d
