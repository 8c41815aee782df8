#include "surface/curve/ease.hpp"

#include "surface/curve/walk.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surface::curve {

namespace {

constexpr int kRounds = 4000;
constexpr double kPace = 0.4;   // share of the way to the middle of the neighbours per step; stable below 0.5
constexpr double kStill = 1e-4; // mm: points that moved less count as unmoved
constexpr double kSlack = 1.02; // factor of the allowed curvature

class CurvatureFlow {
  public:
    CurvatureFlow(const Surface& s, Line& line, const EaseOptions& o)
        : surface_(s), line_(line), o_(o), n_(line.size()) {
        start_.reserve(n_);
        for (const auto& p : line.places) start_.push_back(p.point);
        normal_.reserve(n_);
        for (const auto& p : line.places) normal_.push_back(surface::normal(s, p.triangle));
        held_.assign(n_, 0);
    }

    void hold(std::size_t i) { held_[i] = 1; }

    // Moves points until no turn is too tight, or no point can move.
    void run() {
        std::vector<std::size_t> active(n_), next;
        for (std::size_t i = 0; i < n_; ++i) active[i] = i;
        std::vector<char> queued(n_, 0);
        for (int round = 0; round < kRounds && !active.empty(); ++round) {
            next.clear();
            for (const std::size_t i : active) queued[i] = 0;
            for (const std::size_t i : active)
                if (nudge(i))
                    for (const std::size_t k : {before(i), i, after(i)})
                        if (!queued[k]) {
                            queued[k] = 1;
                            next.push_back(k);
                        }
            std::sort(next.begin(), next.end());
            active.swap(next);
        }
    }

    [[nodiscard]] double moved(std::size_t i) const { return distance(line_[i], start_[i]); }

    // Geodesic curvature at a point, 1/mm.
    [[nodiscard]] double curvature(std::size_t i) const {
        if (!line_.closed && (i == 0 || i + 1 == n_)) return 0;
        const Vec3 a = line_[i] - line_[before(i)], b = line_[after(i)] - line_[i], &n = normal_[i];
        const double turn = std::atan2(dot(cross(a, b), n), dot(a, b) - dot(a, n) * dot(b, n));
        const double l = (norm(a) + norm(b)) / 2;
        return l > 0 ? std::abs(turn) / l : 0;
    }

  private:
    [[nodiscard]] std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : line_.closed ? n_ - 1 : 0; }
    [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 < n_ ? i + 1 : line_.closed ? 0 : i; }

    // One step of point i; false if it does not move.
    bool nudge(std::size_t i) {
        if (held_[i]) return false;
        const double k = curvature(i), most = 1 / o_.radius;
        if (!(k > most * kSlack)) return false;
        const Vec3 pull = 0.5 * (line_[before(i)] + line_[after(i)]) - line_[i];
        const Vec3 flat = pull - dot(pull, normal_[i]) * normal_[i];
        const Vec3 ahead = line_[after(i)] - line_[before(i)];
        const double l = norm(ahead);
        if (!(l > 0)) return false;
        const Vec3 along = dot(flat, ahead) / (l * l) * ahead;
        Vec3 way = kPace * (along + (1 - most / k) * (flat - along));
        if (distance(line_[i] + way, start_[i]) > o_.corridor) return false;
        const Place to = step(surface_, line_.places[i], way);
        if (distance(to.point, line_[i]) < 1e-9) return false;
        line_.places[i] = to;
        normal_[i] = surface::normal(surface_, to.triangle);
        return true;
    }

    const Surface& surface_;
    Line& line_;
    const EaseOptions& o_;
    std::size_t n_;
    std::vector<Vec3> start_, normal_;
    std::vector<char> held_;
};

// The line with its moved parts replaced by the moved points.
Line merged(const Surface& s, const Line& line, std::span<const double> ways, const Line& points,
            const CurvatureFlow& flow) {
    Line out{{}, line.closed};
    const std::size_t n = points.size();
    const double all = ways.back(), unit = all / static_cast<double>(line.closed ? n : n - 1);
    const auto still = [&](std::size_t i) { return flow.moved(i) < kStill; };
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
        const std::size_t j = (i + 1) % n;
        const double from = unit * static_cast<double>(i);
        append(out, still(i) && still(j) ? part(line, ways, from, from + unit)
                                         : join(s, points.places[i], points.places[j]));
    }
    if (line.closed && out.size() > 1 && distance(out[0], out[out.size() - 1]) < 1e-9) out.places.pop_back();
    return out;
}

} // namespace

EaseResult ease(const Surface& s, const Line& given, const EaseOptions& options) {
    EaseOptions o = options;
    if (!(o.step > 0)) o.step = o.radius / 10;
    EaseResult out{given, 0, 0};
    if (given.size() < 3) return out;
    const Line line = threaded(s, given);
    Line points = resampled(line, o.step);
    CurvatureFlow flow(s, points, o);
    const std::size_t n = points.size();
    if (!line.closed) {
        flow.hold(0);
        flow.hold(n - 1);
    }
    if (!line.closed && o.fixed_ends)
        for (std::size_t i = 0; i < n; ++i)
            if (const double from_end = o.step * static_cast<double>(std::min(i, n - 1 - i)); from_end < o.radius)
                flow.hold(i);
    flow.run();
    for (std::size_t i = 0; i < n; ++i) {
        out.moved = std::max(out.moved, flow.moved(i));
        if (flow.curvature(i) > 1.05 / o.radius) out.too_tight += o.step;
    }
    if (out.moved >= kStill) out.line = merged(s, line, arc_lengths(line), points, flow);
    return out;
}

} // namespace filum::surface::curve
