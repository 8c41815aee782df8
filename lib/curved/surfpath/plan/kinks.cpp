#include "surfpath/plan/kinks.hpp"

#include "geom/polyline.hpp"
#include "surface/curve/turns.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::surfpath::plan {

namespace {

namespace curve = surface::curve;

constexpr double kRadius = 0.5; // spacings: that of the turn from a line to its neighbour
constexpr double kBeside = 1.2; // spacings of path on both sides of a kink that may move with it
// spacings between points of the flow: half of the reach over which kinks are measured, so that three points of such a
// circle are five of the flow
const double kStep = curve::turn_reach(curve::kKinkRadius, 1) / 2;
constexpr double kPace = 0.1;       // of the flow; it is stable below 1/8
constexpr double kEven = 0.2;       // share of the way along the path to the middle of the neighbours, per round
constexpr double kCorridor = 0.5;   // spacings that points may move: the bead still lies on its old middle line
constexpr int kRounds = 4000;       // most rounds of the flow
constexpr int kRoundsBetween = 100; // and those between two looks for kinks
constexpr double kKinkMargin =
    1.02; // factor of the radius of kinks: the plane in which the flow runs is not the surface

struct Stretch {
    double from, to; // mm along the line
};

// The parts of the line around its kinks that may move; those that overlap are one.
std::vector<Stretch> around_kinks(const Surface& s, std::span<const Vec3> normals, const Line& line, double length,
                                  double spacing) {
    std::vector<Vec3> points, up;
    for (const Place& p : line.places) {
        points.push_back(p.point);
        up.push_back(curve::normal_at(s, normals, p));
    }
    const double limit = curve::kKinkRadius * spacing;
    std::vector<Stretch> out;
    for (const auto& t : curve::tight_turns(points, up, limit, curve::turn_reach(limit, spacing))) {
        const Stretch now{std::max(0.0, t.from - kBeside * spacing), std::min(length, t.to + kBeside * spacing)};
        if (out.empty() || now.from > out.back().to)
            out.push_back(now);
        else
            out.back().to = now.to;
    }
    return out;
}

// Moves points of a polyline in the plane until it turns no tighter than the radius: where curvature exceeds the limit,
// points move inwards, and their neighbours outwards by as much (surface diffusion of the excess of curvature). So a
// tip becomes a bulb and a corner an arc on both sides of it, and the area on both sides of the line stays the same.
class ExcessFlow {
  public:
    ExcessFlow(std::vector<Vec2> points, double radius, double step)
        : start_(points), now_(std::move(points)), excess_(now_.size(), 0), most_(1 / radius), step_(step) {}

    void run(int rounds, double corridor) {
        for (int round = 0; round < rounds; ++round) {
            measure();
            for (std::size_t i = 2; i + 2 < now_.size(); ++i) move(i, corridor);
        }
    }
    [[nodiscard]] const std::vector<Vec2>& points() const { return now_; }

  private:
    // Signed curvature, positive to the left.
    [[nodiscard]] double curvature(std::size_t i) const {
        const Vec2 a = now_[i] - now_[i - 1], b = now_[i + 1] - now_[i];
        const double l = (norm(a) + norm(b)) / 2;
        return l > 0 ? std::atan2(cross(a, b), dot(a, b)) / l : 0;
    }

    // Sets the excess of curvature of every point.
    void measure() {
        for (std::size_t i = 1; i + 1 < now_.size(); ++i) {
            const double k = curvature(i), over = std::abs(k) - most_;
            excess_[i] = over > 0 ? std::copysign(over, k) : 0;
        }
    }

    void move(std::size_t i, double corridor) {
        const Vec2 ahead = now_[i + 1] - now_[i - 1];
        const double l = norm(ahead);
        if (!(l > 0)) return;
        const Vec2 along = 1 / l * ahead, left = geom::left_of(along);
        const double spread = 2 * excess_[i] - excess_[i - 1] - excess_[i + 1];
        const double slip = dot(0.5 * (now_[i - 1] + now_[i + 1]) - now_[i], along);
        const double most = kPace * step_; // a point of a cusp must not pass its neighbours
        const Vec2 to = now_[i] + std::clamp(kPace * step_ * step_ * spread, -most, most) * left + kEven * slip * along;
        if (distance(to, start_[i]) <= corridor) now_[i] = to;
    }

    std::vector<Vec2> start_, now_;
    std::vector<double> excess_;
    double most_, step_; // 1/mm, mm
};

// mm of kinks of a polyline in the plane.
double kinks(std::span<const Vec2> flat, double spacing) {
    const double limit = kKinkMargin * curve::kKinkRadius * spacing;
    std::vector<Vec3> points;
    for (const Vec2 p : flat) points.push_back({p.x, p.y, 0});
    const std::vector<Vec3> up(points.size(), Vec3{0, 0, 1});
    return curve::length(curve::tight_turns(points, up, limit, curve::turn_reach(limit, spacing)));
}

// The polyline after the flow, as soon as it has no kinks; otherwise with the least length of them.
std::vector<Vec2> least_kinked(const std::vector<Vec2>& given, double spacing) {
    ExcessFlow flow(given, kRadius * spacing, kStep * spacing);
    std::vector<Vec2> best = given;
    double least = kinks(given, spacing);
    for (int rounds = 0; rounds < kRounds && least > 0; rounds += kRoundsBetween) {
        flow.run(kRoundsBetween, kCorridor * spacing);
        if (const double now = kinks(flow.points(), spacing); now < least) {
            least = now;
            best = flow.points();
        }
    }
    return best;
}

// The stretch without its kinks, or with fewer; none if all stay, or if it does not lie on the surface.
std::optional<Line> rounded(const Surface& s, std::span<const Vec3> normals, const Line& line,
                            std::span<const double> arcs, const Stretch& at, double spacing) {
    const Line given = curve::part(line, arcs, at.from, at.to);
    const Line even = curve::resampled(given, kStep * spacing);
    if (even.size() < 6) return {};
    const Place& middle = even.places[even.size() / 2];
    const Vec3 up = curve::normal_at(s, normals, middle);
    const curve::Chart chart = curve::chart(middle, up, even.places.back().point - even.places.front().point);
    std::vector<Vec2> flat;
    for (const Place& p : even.places) flat.push_back(chart.to(p.point));
    const auto better = least_kinked(flat, spacing);
    if (better == flat) return {};
    auto found = curve::from_chart(s, chart, even.places.front(), better);
    if (!found.whole || found.line.size() < 2) return {};
    const Place& end = given.places.back();
    if (distance(found.line.places.back().point, end.point) > 1e-6 * spacing) return {}; // another sheet of the surface
    found.line.places.back() = end;
    return std::move(found.line);
}

} // namespace

void round_kinks(const Surface& s, Plan& plan, double spacing) {
    const auto normals = curve::vertex_normals(s);
    for (Stroke& stroke : plan.strokes) {
        Line joined;
        for (const Section& section : stroke.sections) curve::append(joined, section.line);
        if (joined.size() < 3) continue;
        const Line line = curve::threaded(s, joined);
        const auto arcs = curve::arc_lengths(line);
        Line out;
        double done = 0;
        for (const Stretch& at : around_kinks(s, normals, line, arcs.back(), spacing)) {
            const auto better = rounded(s, normals, line, arcs, at, spacing);
            if (!better) continue;
            if (at.from > done) curve::append(out, curve::part(line, arcs, done, at.from));
            curve::append(out, *better);
            done = at.to;
        }
        if (done == 0) continue;
        if (done < arcs.back()) curve::append(out, curve::part(line, arcs, done, arcs.back()));
        stroke.sections = {{std::move(out), false}};
    }
}

} // namespace filum::surfpath::plan
