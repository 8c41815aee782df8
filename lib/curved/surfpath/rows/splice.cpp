#include "surfpath/rows/splice.hpp"

#include "geom/point_grid.hpp"
#include "surface/curve/ease.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/lanes/linked_lanes.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace filum::surfpath::rows {

namespace {

// A sample point near a loop.
struct NearbySample {
    std::uint32_t line = surface::kNone;
    double way = 0, far = std::numeric_limits<double>::infinity();
};

// Where a loop is spliced into another line: arc lengths on both, and whether they run in the same direction.
struct SpliceSite {
    double loop = 0, other = 0;
    std::uint32_t line = surface::kNone;
    bool same = true;
};

// A line as points rules::kGrain spacings apart.
struct SampledLine {
    std::vector<Vec3> points;
    geom::Box3 box;
    double length = 0; // mm
};

class Splicer {
  public:
    Splicer(const Surface& s, std::vector<Line>& lines, double spacing)
        : s_(s), lines_(lines), d_(spacing), samples_(lines.size()) {
        for (std::uint32_t i = 0; i < lines.size(); ++i) sample(i);
    }

    // Sets the radius of the next shifts, mm.
    void keep_to(double radius) {
        radius_ = rules::kRounded * std::max(radius, d_ / 2);
        half_ = rules::shift_length(radius_, d_) / 2;
    }

    // Splices the loop into another line. Returns false if there is no place for it.
    bool take_in(std::uint32_t loop, std::vector<Vec3>& crossed) {
        if (lines_[loop].size() < 2) return false; // it was taken in before
        const auto ways = surface::curve::arc_lengths(lines_[loop]);
        if (ways.back() < 6 * half_) return false;
        gather(loop);
        const SpliceSite at = best(lines_[loop], ways);
        if (at.line == surface::kNone) return false;
        Line made = joined(loop, at);
        if (made.size() < 2) return false;
        crossed.push_back(surface::curve::at(lines_[loop], ways, at.loop).point);
        lines_[at.line] = std::move(made);
        lines_[loop].places.clear();
        sample(at.line);
        sample(loop);
        return true;
    }

  private:
    void sample(std::uint32_t i) {
        samples_[i] = {};
        if (lines_[i].size() < 2) return;
        const auto ways = surface::curve::arc_lengths(lines_[i]);
        samples_[i].length = ways.back();
        for (double way = 0; way < ways.back(); way += rules::kGrain * d_) {
            samples_[i].points.push_back(surface::curve::at(lines_[i], ways, way).point);
            samples_[i].box.add(samples_[i].points.back());
        }
    }

    // Collects the sample points of other lines near the loop.
    void gather(std::uint32_t loop) {
        spots_.clear();
        std::vector<Vec3> points;
        const geom::Box3 about = geom::grown(samples_[loop].box, (rules::kBeside + rules::kGrain) * d_);
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            if (i == loop || !geom::meet(about, samples_[i].box)) continue;
            double way = 0;
            for (const Vec3& p : samples_[i].points) {
                if (!(geom::distance(about, p) > 0)) {
                    spots_.push_back({i, way, 0});
                    points.push_back(p);
                }
                way += rules::kGrain * d_;
            }
        }
        grid_ = geom::PointGrid<Vec3>(points, rules::kBeside * d_);
        points_ = std::move(points);
    }

    // The nearest sample point of the line, or of any line for kNone.
    [[nodiscard]] NearbySample nearest(const Vec3& p, std::uint32_t line) const {
        NearbySample out;
        grid_.near(p, 1, [&](std::uint32_t i) {
            const double far = distance(points_[i], p);
            if ((line == surface::kNone || spots_[i].line == line) && far <= rules::kBeside * d_ && far < out.far)
                out = {spots_[i].line, spots_[i].way, far};
        });
        return out;
    }

    [[nodiscard]] SpliceSite best(const Line& loop, std::span<const double> ways) const {
        SpliceSite out;
        double least = std::numeric_limits<double>::infinity();
        for (double way = 0; way < ways.back(); way += d_) {
            const NearbySample here = nearest(surface::curve::at(loop, ways, way).point, surface::kNone);
            if (here.line == surface::kNone) continue;
            const double all = samples_[here.line].length;
            if (all < 6 * half_) continue;
            if (!lines_[here.line].closed && (here.way < 2 * half_ || here.way > all - 2 * half_)) continue;
            double off = std::abs(here.far - d_);
            std::array<double, 2> on{};
            bool good = true;
            for (const std::size_t k : {0U, 1U}) {
                const double side = k == 0 ? -half_ : half_;
                const NearbySample there = nearest(surface::curve::at(loop, ways, way + side).point, here.line);
                on[k] = std::remainder(there.way - here.way, lines_[here.line].closed ? all : 4 * all);
                good =
                    good && there.line != surface::kNone && std::abs(std::abs(on[k]) - half_) < std::max(d_, half_) / 2;
                off += std::abs(there.far - d_);
            }
            if (!good || on[0] * on[1] >= 0 || off >= least) continue;
            least = off;
            out = {way, here.way, here.line, on[1] > 0};
        }
        return out;
    }

    // The other line up to the site, the whole loop, and the rest of the other line: an exchange whose links cross.
    [[nodiscard]] Line joined(std::uint32_t loop, const SpliceSite& at) const {
        // lane 0 is the other line, lane 1 the loop
        Line round = lines_[at.line];
        const bool open = !round.closed;
        const double length = surface::curve::length(round);
        round.closed = true;
        const lanes::Lanes lanes(s_, {std::move(round), lines_[loop]}, d_);
        lanes::LinkedLanes linked(lanes);
        if (open) linked.cut(linked.window(0, length, 0));
        const auto window = [&](std::uint32_t lane, double middle) {
            return weave::Window{lane, middle - 2 * half_, middle + 2 * half_};
        };
        const Line there = shift(lanes, at, 1);
        Line back = shift(lanes, at, -1);
        if (there.size() < 2 || back.size() < 2) return {};
        surface::curve::reverse(back);
        linked.exchange(window(0, at.other), window(1, at.loop), !at.same, {there, back});
        auto curves = linked.curves();
        if (curves.size() != 1 || curves[0].closed == open) return {};
        return curves[0].take(lines_[at.line][0]);
    }

    // The shift from the other line to the loop (way 1) or from the loop to the other line (way -1), with half_ mm of
    // both lines before and after it, eased to the radius. Empty if it leaves the surface.
    [[nodiscard]] Line shift(const lanes::Lanes& lanes, const SpliceSite& at, double way) const {
        const double turned = at.same ? 1 : -1;
        const auto on = [&](std::uint32_t lane, double off) {
            return lanes.at(lane, lane == 0 ? at.other + off : at.loop + turned * off);
        };
        const std::uint32_t from = way > 0 ? 0 : 1, to = 1 - from;
        const int n = std::max(8, static_cast<int>(std::ceil(2 * half_ / (rules::kGrain * d_))));
        Line out;
        for (int i = 0; i < n / 2; ++i) out.places.push_back(on(from, half_ * (2.0 * i / n - 2)));
        for (int i = 0; i <= n; ++i) {
            const double t = static_cast<double>(i) / n, off = half_ * (2 * t - 1);
            const Line across = surface::curve::join(s_, on(from, off), on(to, off));
            if (!surface::curve::leads(s_, across)) return {};
            const auto ways = surface::curve::arc_lengths(across);
            out.places.push_back(surface::curve::at(across, ways, rules::shifted(t) * ways.back()));
        }
        for (int i = n / 2; i-- > 0;) out.places.push_back(on(to, half_ * (2 - 2.0 * i / n)));
        return surface::curve::ease(s_, surface::curve::threaded(s_, out),
                                    {.radius = radius_, .corridor = rules::kGive * d_})
            .line;
    }

    const Surface& s_;
    std::vector<Line>& lines_;
    double d_, radius_ = 0, half_ = 0;
    std::vector<NearbySample> spots_;
    std::vector<Vec3> points_;
    std::vector<SampledLine> samples_; // per line
    geom::PointGrid<Vec3> grid_;
};

} // namespace

std::vector<Vec3> splice_loops(const Surface& s, std::vector<Line>& lines, std::vector<char> keep, double spacing,
                               double radius) {
    std::vector<std::uint32_t> loops;
    std::vector<double> length;
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        length.push_back(surface::curve::length(lines[i]));
        if (lines[i].closed && !keep[i]) loops.push_back(i);
    }
    std::stable_sort(loops.begin(), loops.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return length[a] < length[b]; });
    std::vector<Vec3> crossed;
    Splicer splicer(s, lines, spacing);
    splicer.keep_to(radius);
    for (const std::uint32_t i : loops) splicer.take_in(i, crossed);
    return crossed;
}

} // namespace filum::surfpath::rows
