#include "route/tilt.hpp"

#include "geom/angle.hpp"
#include "parallel/parallel.hpp"
#include "route/dense.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::route {

namespace {

using geom::Vec2;

using geom::kDegree;
constexpr double kCoarse = 5 * kDegree, kFine = 0.25 * kDegree; // first and last step of the tilt
constexpr double kGap = 1.5 * kDegree;                          // narrower room may be missed
constexpr double kStiff = 2;                                    // mm; see lean()
constexpr double kEase = 3;                                     // lengths kStiff over which a tilt fades out
constexpr double kBlocked = 1e4;            // rad2: cost of missing room, more than that of any tilt
constexpr double kNothing = 0.01 * kDegree; // smaller tilts are none

struct TiltState {
    Vec2 tilt; // rad
    double cost = 0, sum = 0;
    std::uint32_t from = 0; // index of the state at the station before
};

// A place at which room is tested.
struct TestPlace {
    std::size_t point = 0;           // of the dense stroke
    std::size_t first = 0, last = 0; // points that are nearest to it, or only that one
    double weight = 0;               // mm of path
    bool stuck = false;              // none of the tilts tested gives room
};

// A place at which a tilt is chosen, for the test places around it.
struct Station {
    std::size_t point = 0; // of the dense stroke
    std::size_t first = 0, last = 0;
    Vec2 tilt;
    std::vector<TiltState> states;
};

class TiltSearch {
  public:
    TiltSearch(const collision::Room& room, const DenseStroke& dense, const TiltOptions& o, const TestDensity& pace,
               int threads)
        : room_(room), points_(dense.points), o_(o), spacing_(pace.spacing), threads_(threads), tilts_(points_.size()) {
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (i == 0 || i + 1 == points_.size() || points_[i].arc - points_[looks_.back().point].arc >= spacing_)
                looks_.push_back({i, i, i + 1});
        for (std::size_t k = 0; k < looks_.size(); ++k) {
            const auto arc = [&](std::size_t l) { return points_[looks_[l].point].arc; };
            looks_[k].weight = std::max((arc(std::min(k + 1, looks_.size() - 1)) - arc(k > 0 ? k - 1 : 0)) / 2, 1e-3);
            if (!pace.every || k == 0) continue;
            std::size_t half = looks_[k].point;
            while (half - 1 > looks_[k - 1].point && 2 * points_[half - 1].arc > arc(k - 1) + arc(k)) --half;
            looks_[k - 1].last = looks_[k].first = half;
        }
    }

    // The tilt at each point.
    std::vector<Vec2> run() {
        const double rings = std::ceil(o_.most / kCoarse);
        double step = o_.most / rings;
        level(step, static_cast<int>(rings));
        first_ = false;
        while (step > kFine) {
            step /= 2;
            level(step, stride_ > 1 ? 2 : 1); // what was between two stations may need more change
        }
        for (Vec2& t : tilts_)
            if (norm(t) < kNothing) t = {};
        return tilts_;
    }

    // Marks the segments from the test place before to the one behind those without room.
    void mark_stuck(std::vector<std::vector<bool>>& stuck) const {
        for (std::size_t k = 0; k < looks_.size(); ++k) {
            if (!looks_[k].stuck) continue;
            const std::size_t a = looks_[k > 0 ? k - 1 : k].point, b = looks_[std::min(k + 1, looks_.size() - 1)].point;
            for (std::size_t i = a; i <= b; ++i) stuck[points_[i].span][points_[i].segment] = true;
        }
    }

  private:
    [[nodiscard]] double arc(std::size_t station) const { return points_[stations_[station].point].arc; }

    // Chooses among tilts up to `rings` steps from the present ones. Stations are as far apart as a tilt needs for a
    // change by a step.
    void level(double step, int rings) {
        stride_ = static_cast<std::size_t>(std::max(1.0, std::ceil(step / (o_.rate * spacing_))));
        stations_.clear();
        for (std::size_t l = 0;; l = std::min(l + stride_, looks_.size() - 1)) {
            const std::size_t first = stations_.empty() ? 0 : stations_.back().last;
            const bool end = l + 1 == looks_.size();
            const std::size_t last = end ? l + 1 : std::min(l + (stride_ + 1) / 2, looks_.size() - 1);
            stations_.push_back({looks_[l].point, first, last, tilts_[looks_[l].point], {}});
            if (end) break;
        }
        constexpr std::size_t grain = 8;
        parallel::for_chunks(stations_.size(), grain, threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) offer(stations_[k], step, rings);
        });
        choose();
        spread();
    }

    // Calls f(tilt) for tilts up to `rings` steps from the middle.
    template <class F>
    void for_grid(const Vec2& middle, double step, int rings, const F& f) const {
        for (int j = -rings; j <= rings; ++j)
            for (int i = -rings; i <= rings; ++i) {
                const Vec2 t{middle.x + i * step, middle.y + j * step};
                if (norm(t) <= o_.most * (1 + 1e-9)) f(t);
            }
    }

    // Room may be a gap between two obstacles that the tilts of the first grid miss: where none is free, finer grids
    // are tried, and free tilts found become states.
    void seek(Station& s, const TestPlace& look, double step, int rings) const {
        const auto free = [&](const TiltState& state) { return room_for(state.tilt, look); };
        if (std::any_of(s.states.begin(), s.states.end(), free)) return;
        for (const std::size_t known = s.states.size(); step > kGap && s.states.size() == known;) {
            step /= 2;
            rings *= 2;
            for_grid({}, step, rings, [&](const Vec2& t) {
                if (room_for(t, look)) s.states.push_back({t});
            });
        }
    }

    // Adds the states of a station, the least tilts first.
    void offer(Station& s, double step, int rings) {
        const bool near = std::any_of(looks_.begin() + static_cast<std::ptrdiff_t>(s.first),
                                      looks_.begin() + static_cast<std::ptrdiff_t>(s.last),
                                      [&](const TestPlace& l) { return points_[l.point].near; });
        if (!near) {
            s.states.push_back({});
            return;
        }
        for_grid(s.tilt, step, rings, [&](const Vec2& t) { s.states.push_back({t}); });
        if (first_)
            for (std::size_t l = s.first; l < s.last; ++l) seek(s, looks_[l], step, rings);
        std::stable_sort(s.states.begin(), s.states.end(),
                         [](const TiltState& a, const TiltState& b) { return norm2(a.tilt) < norm2(b.tilt); });
        for (std::size_t l = s.first; l < s.last; ++l) {
            bool stuck = true;
            for (TiltState& state : s.states) {
                const bool free = room_for(state.tilt, looks_[l]);
                stuck = stuck && !free;
                state.cost += looks_[l].weight * (norm2(state.tilt) + (free ? 0 : kBlocked));
            }
            looks_[l].stuck = stuck && (first_ || looks_[l].stuck);
        }
    }

    [[nodiscard]] bool room_for(const Vec2& tilt, const TestPlace& look) const {
        return std::all_of(points_.begin() + static_cast<std::ptrdiff_t>(look.first),
                           points_.begin() + static_cast<std::ptrdiff_t>(look.last), [&](const DensePoint& p) {
                               return room_.at({p.tip, tilted(p, tilt), {}}, p.before);
                           });
    }

    void choose() {
        for (std::size_t k = 0; k < stations_.size(); ++k)
            for (TiltState& to : stations_[k].states) reach(k, to);
        const auto& last = stations_.back().states;
        auto best = static_cast<std::uint32_t>(
            std::min_element(last.begin(), last.end(), [](auto& a, auto& b) { return a.sum < b.sum; }) - last.begin());
        for (std::size_t k = stations_.size(); k-- > 0;) {
            stations_[k].tilt = stations_[k].states[best].tilt;
            best = stations_[k].states[best].from;
        }
    }

    void reach(std::size_t k, TiltState& to) const {
        to.sum = to.cost;
        if (k == 0) return;
        const auto& before = stations_[k - 1].states;
        const double way = std::max(arc(k) - arc(k - 1), 1e-6), most = o_.rate * way * (1 + 1e-9);
        double best = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < before.size(); ++i) {
            const double change = norm2(to.tilt - before[i].tilt);
            if (change > most * most) continue;
            const double sum = before[i].sum + kStiff * kStiff * change / way;
            if (sum < best) {
                best = sum;
                to.from = i;
            }
        }
        to.sum += best;
    }

    // Interpolates the tilts of the stations to all points.
    void spread() {
        tilts_[stations_[0].point] = stations_[0].tilt;
        for (std::size_t k = 0; k + 1 < stations_.size(); ++k) {
            const Station &a = stations_[k], &b = stations_[k + 1];
            const double way = arc(k + 1) - arc(k);
            for (std::size_t i = a.point + 1; i <= b.point; ++i)
                tilts_[i] = lerp(a.tilt, b.tilt, way > 0 ? (points_[i].arc - points_[a.point].arc) / way : 1);
        }
    }

    const collision::Room& room_;
    const std::vector<DensePoint>& points_;
    const TiltOptions& o_;
    double spacing_;
    int threads_;
    std::vector<Vec2> tilts_; // per point
    bool first_ = true;       // whether this is the first level
    std::size_t stride_ = 1;  // test places from one station to the next
    std::vector<TestPlace> looks_;
    std::vector<Station> stations_;
};

TiltSummary report(const DenseStroke& dense, const std::vector<Vec2>& tilts) {
    TiltSummary out;
    out.length = dense.points.back().arc;
    double sum = 0;
    for (std::size_t i = 0; i + 1 < tilts.size(); ++i) {
        const double way = dense.points[i + 1].arc - dense.points[i].arc;
        const double a = norm(tilts[i]), b = norm(tilts[i + 1]);
        out.most = std::max({out.most, a, b});
        if (a > 0 || b > 0) {
            out.leaning += way;
            sum += way * (a + b) / 2;
        }
    }
    out.mean = out.leaning > 0 ? sum / out.leaning : 0;
    return out;
}

} // namespace

TiltedStroke lean(const collision::Room& room, const Stroke& stroke, const TiltOptions& options,
                  const TestDensity& pace, int threads) {
    const DenseStroke dense = densified(stroke, options.most / options.rate + kEase * kStiff, pace.spacing);
    TiltSearch leaner(room, dense, options, pace, threads);
    const auto tilts = leaner.run();
    TiltedStroke out;
    if (std::any_of(tilts.begin(), tilts.end(), [](const Vec2& t) { return norm2(t) > 0; })) {
        out = with_tilts(dense, stroke, tilts);
        out.leaning = report(dense, tilts);
    } else {
        out.spans.assign(stroke.spans.begin(), stroke.spans.end());
        for (const auto& of_span : stroke.before) {
            auto& origin = out.origin.emplace_back(of_span.size());
            for (std::uint32_t i = 0; i < origin.size(); ++i) origin[i] = i;
        }
        out.leaning.length = dense.points.back().arc;
    }
    for (const auto& b : stroke.blocked) out.stuck.emplace_back(b.size(), false);
    leaner.mark_stuck(out.stuck);
    out.leaning.stroke = stroke.spans.front().stroke;
    out.leaning.layer = stroke.spans.front().layer;
    return out;
}

} // namespace filum::route
