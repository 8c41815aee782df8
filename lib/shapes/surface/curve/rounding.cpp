#include "surface/curve/rounding.hpp"

#include "geom/point_grid.hpp"
#include "surface/curve/strands.hpp"
#include "surface/curve/turns.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::surface::curve {

namespace {

constexpr std::size_t kPerReach = 4;           // points per reach over which radii are measured
constexpr std::size_t kFewest = 3 * kPerReach; // points of a line, on which radii can be measured
constexpr int kSweeps = 1000;                  // most steps of the flow between two judgements
constexpr int kSweepsApart = 4; // steps after which distances between lines are looked at, as that takes longest
constexpr double kEven = 0.2;   // share of the way along the line to the middle of the neighbours, per step; below 1/2
// Shares of the distance of points: smaller steps are none. Long waves move slowly, so it is far below what matters.
constexpr double kRest = 1e-5;
// Most judgements. A stretch that fails one only has kinks rounded after it, and stays where it was after a second one.
constexpr int kJudgements = 4;

// The maximum over x of (sin(x / 2) / (x / 2))^2 (1 - cos x)^2, rounded up.
constexpr double kGrowth = 1.65;

// A displacement whose curvature is a triangle function: its sum is 0, so that as much area is gained on one side of
// the line as is lost on the other.
class Bump {
  public:
    explicit Bump(std::size_t k) : k_(static_cast<std::ptrdiff_t>(k)) {
        const auto hat = [&](std::ptrdiff_t j) {
            return std::max(0.0, 1 - std::abs(static_cast<double>(j)) / static_cast<double>(k));
        };
        for (std::ptrdiff_t j = -2 * k_ + 1; j < 2 * k_; ++j)
            share_.push_back(hat(j) - (hat(j - k_) + hat(j + k_)) / 2);
        // The pull of a wave of the line, after all points were pushed by such bumps, grows by at most kGrowth k times
        // the step. Steps below 2 / (kGrowth k) are stable; bumps of two sizes act together, so each has half of it.
        for (double& f : share_) f /= kGrowth * static_cast<double>(k);
    }
    [[nodiscard]] std::ptrdiff_t k() const { return k_; }
    [[nodiscard]] std::ptrdiff_t reach() const { return 2 * k_ - 1; }
    [[nodiscard]] double at(std::ptrdiff_t j) const { return share_[static_cast<std::size_t>(j + reach())]; }

  private:
    std::ptrdiff_t k_;
    std::vector<double> share_;
};

// A set of points in the order in which they were inserted.
class PointSet {
  public:
    void resize(std::size_t points) { has_.assign(points, 0); }
    [[nodiscard]] bool has(std::size_t point) const { return has_[point] != 0; }
    [[nodiscard]] const std::vector<std::uint32_t>& all() const { return all_; }
    bool insert(std::size_t point) { // whether it is new
        if (has_[point] != 0) return false;
        has_[point] = 1;
        all_.push_back(static_cast<std::uint32_t>(point));
        return true;
    }
    void clear() {
        for (const std::uint32_t i : all_) has_[i] = 0;
        all_.clear();
    }

  private:
    std::vector<char> has_;
    std::vector<std::uint32_t> all_;
};

class LineRounder {
  public:
    LineRounder(const Surface& s, std::span<const Line> lines, const RoundingOptions& o)
        : s_(s), o_(o), reach_(turn_reach(o.limit, o.spacing)), step_(reach_ / kPerReach),
          kink_(kKinkRadius * o.spacing), kink_reach_(turn_reach(kink_, o.spacing)), wide_(kPerReach),
          narrow_(static_cast<std::size_t>(std::max(1.0, std::round(kink_reach_ / step_)))),
          normals_(vertex_normals(s)), strands_(s, lines, step_, kFewest) {
        const std::size_t n = places().size();
        move_.assign(n, Vec3{});
        most_.assign(n, 1 / o.radius);
        for (PointSet* set : {&live_, &touched_, &displaced_}) set->resize(n);
        fails_.assign(n, 0);
        near_.assign(n, {});
        if (o.nearest > 0) {
            add_rims();
            std::vector<Vec3> points;
            for (const Place& p : strands_.start) points.push_back(p.point);
            points.insert(points.end(), rim_.begin(), rim_.end());
            grid_ = geom::PointGrid<Vec3>(points, o.nearest + 2 * o.corridor);
        }
    }

    RoundingResult run() {
        RoundingResult out;
        if (std::isfinite(o_.worth))
            for (const Strand& strand : strands_.all) limit_sharp_turns(strand);
        for (const Strand& strand : strands_.all)
            for (std::size_t i = 0; i < strand.count; ++i) wake(strand, i);
        for (int round = 0; round < kJudgements; ++round) {
            for (int i = 0; i < kSweeps; ++i)
                if (!sweep(i % kSweepsApart == 0)) break;
            if (put_back() == 0) break;
        }
        for (const Strand& strand : strands_.all) {
            out.moved.push_back(strands_.moved_runs(strand).empty() ? 0 : 1);
            out.lines.push_back(strands_.line(strand));
        }
        return out;
    }

  private:
    void add_rims() {
        for (const auto& rim : s_.rims)
            for (const std::uint32_t h : rim.sides) {
                const Vec3 &a = s_.vertices[s_.tail(h)], &b = s_.vertices[s_.head(h)];
                const auto n = static_cast<int>(std::max(1.0, std::ceil(distance(a, b) / step_)));
                for (int i = 0; i < n; ++i) rim_.push_back(a + static_cast<double>(i) / n * (b - a));
            }
    }

    [[nodiscard]] const std::vector<Place>& places() const { return strands_.places; }
    std::vector<Place>& places() { return strands_.places; }

    [[nodiscard]] Vec3 normal(std::size_t i) const { return normal_at(s_, normals_, places()[i]); }

    // The pull of the point to the middle of its neighbours `k` points away, across the line; `excess` is the share of
    // it by which the line turns tighter than allowed.
    struct Bend {
        Vec3 pull;
        double excess = 0;
    };
    [[nodiscard]] Bend bend(const Strand& strand, std::size_t i, std::ptrdiff_t k, double most) const {
        const std::ptrdiff_t a = strand.at(i, -k), b = strand.at(i, k);
        if (a < 0 || b < 0) return {};
        const Vec3& p = places()[strand.first + i].point;
        const Vec3 &u = places()[strand.first + static_cast<std::size_t>(a)].point,
                   &v = places()[strand.first + static_cast<std::size_t>(b)].point;
        const Vec3 chord = v - u;
        Vec3 pull = 0.5 * (u + v) - p;
        // most arcs are straight enough by this alone
        const double side2 = (norm2(p - u) + norm2(v - p)) / 2, allowed = most * side2 / 2;
        if (norm2(pull) <= allowed * allowed) return {};
        const Vec3 n = normal(strand.first + i);
        pull = pull - dot(pull, n) * n;
        const double l2 = norm2(chord);
        if (l2 > 0) pull = pull - dot(pull, chord) / l2 * chord;
        const double size = norm(pull);
        if (!(size > allowed)) return {};
        return {pull, (size - allowed) / size};
    }

    void add(std::size_t point, const Vec3& way) {
        if (touched_.insert(point)) move_[point] = Vec3{};
        move_[point] = move_[point] + way;
    }

    void push(const Strand& strand, std::size_t i, const Bump& bump, double most) {
        const Bend now = bend(strand, i, bump.k(), most);
        if (!(now.excess > 0)) return;
        const Vec3 way = now.excess * now.pull;
        for (std::ptrdiff_t j = -bump.reach(); j <= bump.reach(); ++j)
            if (const std::ptrdiff_t to = strand.at(i, j); to >= 0)
                add(strand.first + static_cast<std::size_t>(to), bump.at(j) * way);
    }

    [[nodiscard]] const Strand& strand_of(std::size_t point) const { return strands_.all[strands_.of[point]]; }

    // One step of the flow of all points. Returns whether any point moves.
    bool sweep(bool apart) {
        touched_.clear();
        for (const std::uint32_t i : live_.all()) {
            if (fails_[i] > 1) continue;
            const Strand& strand = strand_of(i);
            push(strand, i - strand.first, wide_, most_[i]);
            if (narrow_.k() < wide_.k()) push(strand, i - strand.first, narrow_, 2 / o_.spacing);
        }
        if (o_.nearest > 0 && apart) keep_apart();
        live_.clear();
        for (const std::uint32_t i : touched_.all()) {
            const Strand& strand = strand_of(i);
            const std::size_t at = i - strand.first;
            if (fails_[i] > 1 || (!strand.closed && (at == 0 || at + 1 == strand.count))) continue;
            if (take_step(strand, at)) wake(strand, at);
        }
        return !live_.all().empty();
    }

    // Has the points around a point of the strand looked at in the next step.
    void wake(const Strand& strand, std::size_t at) {
        for (std::ptrdiff_t k = -wide_.k(); k <= wide_.k(); ++k)
            if (const std::ptrdiff_t j = strand.at(at, k); j >= 0)
                live_.insert(strand.first + static_cast<std::size_t>(j));
    }

    bool take_step(const Strand& strand, std::size_t at) {
        const std::size_t i = strand.first + at;
        Vec3 way = move_[i];
        if (!(norm(way) > kRest * step_)) return false;
        // points keep equal distances along the line
        const Vec3 &a = places()[strand.first + static_cast<std::size_t>(strand.at(at, -1))].point,
                   &b = places()[strand.first + static_cast<std::size_t>(strand.at(at, 1))].point;
        const Vec3 chord = b - a;
        if (norm2(chord) > 0) way = way + kEven * dot(0.5 * (a + b) - places()[i].point, chord) / norm2(chord) * chord;
        const Vec3 to = places()[i].point + way;
        const double far = distance(to, strands_.start[i].point);
        if (far > o_.corridor)
            way = strands_.start[i].point + o_.corridor / far * (to - strands_.start[i].point) - places()[i].point;
        const Place next = step(s_, places()[i], way);
        const bool moves = distance(next.point, places()[i].point) > kRest * step_;
        places()[i] = next;
        displaced_.insert(i);
        return moves;
    }

    struct Neighbour {
        std::uint32_t point;
        float least; // mm
    };

    // The points of other lines, of other parts of the line and of rims that point `i` could come too near to.
    const std::vector<Neighbour>& neighbours(std::size_t i) {
        Neighbours& found = near_[i];
        if (found.known) return found.all;
        found.known = true;
        const Vec3 n = normal_at(s_, normals_, strands_.start[i]);
        const auto half_turn = static_cast<std::size_t>(std::ceil(std::numbers::pi / 2 * o_.spacing / step_));
        grid_.near(strands_.start[i].point, 1, [&](std::uint32_t j) {
            const bool rim = j >= places().size();
            const Vec3& q = rim ? rim_[j - places().size()] : strands_.start[j].point;
            const double far = distance(q, strands_.start[i].point), least = rim ? o_.nearest / 2 : o_.nearest;
            if (far > least + 2 * o_.corridor) return;
            if (!rim) {
                if (strands_.of[j] == strands_.of[i]) {
                    const std::size_t off = i > j ? i - j : j - i;
                    const Strand& strand = strands_.all[strands_.of[i]];
                    if (off <= half_turn || (strand.closed && strand.count - off <= half_turn)) return;
                }
                if (!(dot(normal_at(s_, normals_, strands_.start[j]), n) > 0)) return;
            }
            found.all.push_back({j, static_cast<float>(std::min(far, least))});
        });
        return found.all;
    }

    // Pushes points apart that would come too near to each other.
    void keep_apart() {
        const auto way_of = [&](std::size_t i) { return touched_.has(i) ? move_[i] : Vec3{}; };
        for (const std::uint32_t i : displaced_.all()) {
            if (fails_[i] > 1 || !strands_.moved(i)) continue;
            const Vec3 here = places()[i].point + way_of(i);
            for (const Neighbour& other : neighbours(i)) {
                const bool rim = other.point >= places().size();
                const Vec3 there =
                    rim ? rim_[other.point - places().size()] : places()[other.point].point + way_of(other.point);
                const Vec3 off = here - there;
                const double far2 = norm2(off), least = other.least;
                if (far2 >= least * least || !(far2 > 0)) continue;
                const double far = std::sqrt(far2);
                const bool alone = rim || fails_[other.point] > 1;
                const Vec3 way = (alone ? 1 : 0.5) * (least - far) / far * off;
                add(i, way);
                if (!alone) add(other.point, -1 * way);
            }
        }
    }

    struct RunPoints {
        std::vector<Vec3> points, normals;
    };
    [[nodiscard]] RunPoints measured(const Strand& strand, const std::vector<Place>& places, StrandRun r) const {
        RunPoints out;
        for (std::ptrdiff_t i = r.from; i < r.to; ++i) {
            const std::ptrdiff_t j = strand.at(0, i);
            if (j < 0) continue;
            const Place& p = places[strand.first + static_cast<std::size_t>(j)];
            if (!out.points.empty() && distance(out.points.back(), p.point) < 1e-9) continue;
            out.points.push_back(p.point);
            out.normals.push_back(normal_at(s_, normals_, p));
        }
        return out;
    }

    // mm that turn tighter than the radius, and those that are kinks.
    struct Tight {
        double length = 0, kinks = 0;
    };
    [[nodiscard]] Tight tight(const RunPoints& m) const {
        return {length(tight_turns(m.points, m.normals, o_.limit, reach_)),
                length(tight_turns(m.points, m.normals, kink_, kink_reach_))};
    }

    // Turns that the corridor cannot round to the radius are rounded to half a spacing only.
    void limit_sharp_turns(const Strand& strand) {
        if (strand.count == 0) return;
        const auto n = static_cast<std::ptrdiff_t>(strand.count);
        const StrandRun all = strand.closed ? StrandRun{-n, 2 * n} : StrandRun{0, n};
        const RunPoints m = measured(strand, places(), all);
        // A corner by the angle a that becomes an arc of radius r moves by r (1 / cos(a / 2) - 1) in all, to both
        // sides.
        const double most = 2 * std::acos(1 / (1 + 2 * o_.corridor / o_.radius));
        for (const TightTurn& t : tight_turns(m.points, m.normals, o_.limit, reach_)) {
            const auto from = static_cast<std::ptrdiff_t>(t.from / step_),
                       to = static_cast<std::ptrdiff_t>(t.to / step_);
            double turn = 0;
            for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(1, from);
                 i <= to && i + 1 < static_cast<std::ptrdiff_t>(m.points.size()); ++i) {
                const auto k = static_cast<std::size_t>(i);
                const Vec3 a = m.points[k] - m.points[k - 1], b = m.points[k + 1] - m.points[k];
                turn += std::atan2(dot(cross(a, b), m.normals[k]), dot(a, b));
            }
            if (std::abs(turn) <= most) continue;
            const std::ptrdiff_t beside = wide_.k();
            for (std::ptrdiff_t i = from - beside; i <= to + beside; ++i) {
                const std::ptrdiff_t j = strand.at(0, i + all.from);
                if (j >= 0) most_[strand.first + static_cast<std::size_t>(j)] = 2 / o_.spacing;
            }
        }
    }

    // Puts runs back that are not worth it. Returns their number.
    std::size_t put_back() {
        std::size_t failed = 0;
        const auto beside = static_cast<std::ptrdiff_t>(2 * kPerReach);
        for (const Strand& strand : strands_.all)
            for (const StrandRun& r : strands_.moved_runs(strand)) {
                const StrandRun wide{r.from - beside, r.to + beside};
                const Tight before = tight(measured(strand, strands_.start, wide)),
                            after = tight(measured(strand, places(), wide));
                const double saved = before.length - after.length;
                if (after.kinks <= before.kinks && saved > 0 &&
                    (std::isinf(o_.worth) || saved * o_.worth > strands_.area_moved(strand, r, wide_.k())))
                    continue;
                ++failed;
                for (std::ptrdiff_t i = r.from; i < r.to; ++i) {
                    const std::size_t j = strand.first + static_cast<std::size_t>(strand.at(0, i));
                    places()[j] = strands_.start[j];
                    most_[j] = 2 / o_.spacing;
                    ++fails_[j];
                    wake(strand, j - strand.first);
                }
            }
        return failed;
    }

    const Surface& s_;
    const RoundingOptions& o_;
    double reach_, step_, kink_, kink_reach_;
    Bump wide_, narrow_;
    std::vector<Vec3> normals_;
    Strands strands_;
    std::vector<Vec3> move_;
    std::vector<double> most_; // per point: allowed curvature, 1/mm
    PointSet live_;            // may bend more than before
    PointSet touched_;         // are pushed in this step
    PointSet displaced_;       // took a step at any time
    std::vector<char> fails_;  // per point: judgements that its stretch failed
    struct Neighbours {
        bool known = false;
        std::vector<Neighbour> all;
    };
    std::vector<Neighbours> near_;
    std::vector<Vec3> rim_;
    geom::PointGrid<Vec3> grid_;
};

} // namespace

RoundingResult rounded(const Surface& s, std::span<const Line> lines, const RoundingOptions& options) {
    return LineRounder(s, lines, options).run();
}

} // namespace filum::surface::curve
