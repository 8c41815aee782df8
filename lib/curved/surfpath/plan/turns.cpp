#include "surfpath/plan/turns.hpp"

#include "geom/point_grid.hpp"
#include "surface/curve/ease.hpp"
#include "surface/curve/turns.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace filum::surfpath::plan {

namespace {

namespace curve = surface::curve;

// Shares of the radius to which a turn is eased, the best first. The smaller ones keep no radius. They give way to what
// lies inside a turn, so that the turns outside it need not give up theirs.
constexpr std::array kShares{1.0, 0.8, 0.6};

// A turn of a line, and what it may become.
struct RoundedTurn {
    double from = 0, to = 0; // mm along the line
    Line given;
    std::vector<Line> eased{}; // per share of the radius
    double apart = 0;          // spacings: least distance of the given turn from other lines (TurnRounder::Nearest)
    std::size_t choice = 0;    // index of an eased turn, or their number: the given turn

    [[nodiscard]] bool changed() const { return choice < eased.size(); }
    [[nodiscard]] const Line& shape() const { return changed() ? eased[choice] : given; }
};

// A line that is open or was opened far from its turns.
struct OpenedLine {
    Line line;
    std::vector<double> arcs;
    bool closed = false;
    std::vector<RoundedTurn> turns;
};

struct NormalLine {
    std::vector<Vec3> points, normals;
};

NormalLine with_normals(const Surface& s, std::span<const Vec3> normals, const Line& line) {
    NormalLine out;
    for (const Place& p : line.places) {
        out.points.push_back(p.point);
        out.normals.push_back(curve::normal_at(s, normals, p));
    }
    return out;
}

class TurnRounder {
  public:
    TurnRounder(const Surface& s, const TurnRounding& o)
        : s_(s), o_(o), normals_(curve::vertex_normals(s)), reach_(curve::turn_reach(o.radius, o.spacing)) {
        const double apart = rules::kGrain * o.spacing;
        for (const auto& rim : s.rims)
            for (const std::uint32_t h : rim.sides) {
                const Vec3 &a = s.vertices[s.tail(h)], &b = s.vertices[s.head(h)];
                const auto n = static_cast<int>(std::max(1.0, std::ceil(distance(a, b) / apart)));
                for (int i = 0; i < n; ++i) {
                    rim_.points.push_back(a + static_cast<double>(i) / n * (b - a));
                    rim_.normals.push_back(surface::normal(s, h / 3));
                }
            }
    }

    void run(std::vector<Line>& lines) {
        for (const Line& line : lines) opened_.push_back(opened(line));
        for (OpenedLine& line : opened_) propose(line);
        collect(false);
        for (std::uint32_t i = 0; i < opened_.size(); ++i)
            for (RoundedTurn& t : opened_[i].turns) t.apart = nearest_line(i, t, t.given).far;
        while (give_way()) {
        }
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (std::any_of(opened_[i].turns.begin(), opened_[i].turns.end(),
                            [](const auto& t) { return t.changed(); }))
                lines[i] = result(opened_[i]);
    }

  private:
    [[nodiscard]] std::vector<curve::TightTurn> tight(const Line& line) const {
        const NormalLine l = with_normals(s_, normals_, line);
        return curve::tight_turns(l.points, l.normals, o_.radius, reach_);
    }

    // The line itself, or a closed one opened in the middle of its longest stretch without tight turns.
    [[nodiscard]] OpenedLine opened(const Line& line) const {
        OpenedLine out{line, {}, line.closed, {}};
        if (line.size() >= 3) out.line = curve::threaded(s_, line);
        if (line.closed && line.size() >= 3) {
            const auto arcs = curve::arc_lengths(out.line);
            const double all = arcs.back();
            const Line twice = [&] {
                Line once = curve::part(out.line, arcs, 0, all), two = once;
                curve::append(two, once);
                return two;
            }();
            double at = 0, longest = 0, before = -1;
            for (const curve::TightTurn& t : tight(twice)) {
                if (before >= 0 && t.from - before > longest) {
                    longest = t.from - before;
                    at = (t.from + before) / 2;
                }
                before = t.to;
            }
            at = std::fmod(at, all);
            out.line = curve::part(out.line, arcs, at, at + all);
        }
        out.arcs = curve::arc_lengths(out.line);
        return out;
    }

    // The eased stretch around a tight turn, if it is worth it.
    void propose(OpenedLine& line) const {
        if (line.line.size() < 3) return;
        const double all = line.arcs.back(), around = (1 + std::numbers::sqrt2) * o_.radius;
        double last = 0;
        const auto turns = tight(line.line);
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const double next = i + 1 < turns.size() ? turns[i + 1].from : all;
            RoundedTurn now{std::max(last, turns[i].from - around), std::min(next, turns[i].to + around), {}};
            last = turns[i].to;
            if (!(now.to - now.from > 2 * reach_)) continue;
            now.given = curve::part(line.line, line.arcs, now.from, now.to);
            now.eased.push_back(eased(now.given, kShares[0] * o_.radius));
            // a corner is compared with the turn that it becomes in any case
            const Line least = eased(now.given, o_.spacing / 2);
            const double shorter = curve::length(least) - curve::length(now.eased[0]);
            const double saved = curve::length(tight(least)) - curve::length(tight(now.eased[0]));
            if (!(saved > 0) || shorter > saved) continue;
            for (std::size_t k = 1; k < kShares.size(); ++k)
                now.eased.push_back(eased(now.given, kShares[k] * o_.radius));
            last = now.to;
            line.turns.push_back(std::move(now));
        }
    }

    [[nodiscard]] Line eased(const Line& line, double radius) const {
        return curve::ease(s_, line,
                           {.radius = rules::kRounded * radius, .corridor = 2 * o_.radius, .fixed_ends = false})
            .line;
    }

    // The line with its changed turns.
    [[nodiscard]] Line result(const OpenedLine& line) const {
        Line out;
        double done = 0;
        for (const RoundedTurn& t : line.turns) {
            if (!t.changed()) continue;
            if (t.from > done) curve::append(out, curve::part(line.line, line.arcs, done, t.from));
            curve::append(out, t.shape());
            done = t.to;
        }
        if (done < line.arcs.back()) curve::append(out, curve::part(line.line, line.arcs, done, line.arcs.back()));
        if (line.closed) {
            out.places.pop_back(); // equal to the first one
            out.closed = true;
        }
        return out;
    }

    struct LinePoint {
        std::uint32_t line; // the number of lines: a rim
        double arc;
        Vec3 normal;
    };

    void add(const Line& line, std::uint32_t number, double from) {
        if (line.size() < 2) return;
        const Line even = curve::resampled(line, rules::kGrain * o_.spacing);
        double arc = from;
        for (std::size_t i = 0; i < even.size(); ++i) {
            points_.push_back(even[i]);
            of_.push_back({number, arc, curve::normal_at(s_, normals_, even.places[i])});
            if (i + 1 < even.size()) arc += distance(even[i], even[i + 1]);
        }
    }

    // Collects points of all lines, with changed turns or as they were given.
    void collect(bool changed) {
        points_ = rim_.points;
        of_.clear();
        for (const Vec3& n : rim_.normals) of_.push_back({static_cast<std::uint32_t>(opened_.size()), 0, n});
        for (std::uint32_t i = 0; i < opened_.size(); ++i) {
            const OpenedLine& line = opened_[i];
            double done = 0;
            for (const RoundedTurn& t : line.turns) {
                if (t.from > done) add(curve::part(line.line, line.arcs, done, t.from), i, done);
                add(changed ? t.shape() : t.given, i, t.from);
                done = t.to;
            }
            if (line.arcs.empty()) continue;
            if (done < line.arcs.back()) add(curve::part(line.line, line.arcs, done, line.arcs.back()), i, done);
        }
        grid_ = geom::PointGrid<Vec3>(points_, o_.spacing);
    }

    struct Nearest {
        // spacings to another line; to a rim so that half a spacing counts as the least distance of lines
        double far = std::numeric_limits<double>::infinity();
        Vec3 from, to;
        bool rim = false;
    };
    // Where the turn in this shape is nearest to another line or a rim; points on the same line count from half a turn
    // of the least radius on.
    [[nodiscard]] Nearest nearest_line(std::uint32_t line, const RoundedTurn& turn, const Line& shape) const {
        Nearest out;
        const double own = std::numbers::pi * o_.radius;
        for (const Place& p : curve::resampled(shape, rules::kGrain * o_.spacing).places) {
            const Vec3 n = curve::normal_at(s_, normals_, p);
            grid_.near(p.point, 1, [&](std::uint32_t i) {
                const LinePoint& other = of_[i];
                if (!(dot(other.normal, n) > 0)) return;
                if (other.line == line && other.arc > turn.from - own && other.arc < turn.to + own) return;
                const double apart = distance(points_[i], p.point) / o_.spacing;
                const bool rim = other.line == opened_.size();
                const double far = rim ? 2 * o_.nearest * apart : apart;
                if (far < out.far) out = {far, p.point, points_[i], rim};
            });
        }
        return out;
    }

    // Whether the turn has moved towards the line that it is nearest to.
    [[nodiscard]] static bool approaches(const RoundedTurn& turn, const Nearest& at) {
        double least = std::numeric_limits<double>::infinity();
        Vec3 before;
        for (const Place& p : turn.given.places)
            if (const double far = distance(p.point, at.from); far < least) {
                least = far;
                before = p.point;
            }
        return dot(at.from - before, at.to - at.from) > 0;
    }

    // Lets turns that came too near to another line take their next shape. Returns whether there are any.
    bool give_way() {
        collect(true);
        std::vector<RoundedTurn*> too_near;
        for (std::uint32_t i = 0; i < opened_.size(); ++i)
            for (RoundedTurn& t : opened_[i].turns) {
                if (!t.changed()) continue;
                const Nearest now = nearest_line(i, t, t.shape());
                // rows end where a line is nearer to a rim than half a spacing, even if it was as near elsewhere
                const double least = now.rim ? (1 - 2 * curve::kRipple) * o_.nearest : std::min(o_.nearest, t.apart);
                if (now.far < least && approaches(t, now)) too_near.push_back(&t);
            }
        for (RoundedTurn* t : too_near) ++t->choice;
        return !too_near.empty();
    }

    const Surface& s_;
    const TurnRounding& o_;
    std::vector<Vec3> normals_;
    double reach_;
    NormalLine rim_;
    std::vector<OpenedLine> opened_;
    std::vector<Vec3> points_;
    std::vector<LinePoint> of_; // per point
    geom::PointGrid<Vec3> grid_;
};

} // namespace

void round_turns(const Surface& s, std::vector<Line>& lines, const TurnRounding& o) { TurnRounder(s, o).run(lines); }

} // namespace filum::surfpath::plan
