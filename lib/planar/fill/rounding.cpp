#include "fill/rounding.hpp"

#include "fill/rings/wall_lanes.hpp"
#include "geom/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace filum::fill {

namespace {

// A closed line by arc length. Queries near the previous one are fast.
class ArcLengthCurve {
  public:
    explicit ArcLengthCurve(const toolpath::Curve& line) : line_(&line), n_(line.points.size()) {
        s_.reserve(n_ + 1);
        sum_.reserve(n_ + 1);
        s_.push_back(0);
        sum_.push_back({});
        for (std::size_t i = 0; i < n_; ++i) {
            const Vec2 a = point(i), b = point(i + 1);
            const double l = geom::distance(a, b);
            s_.push_back(s_.back() + l);
            sum_.push_back(sum_.back() + l * geom::lerp(a, b, 0.5));
        }
    }
    [[nodiscard]] double length() const { return s_.back(); }
    [[nodiscard]] double s(std::size_t vertex) const { return s_[vertex]; }

    struct At {
        Vec2 point;
        double width;
        Vec2 sum; // integral of the points over arc length, from the start of the line
    };
    // The place at s. `i` is the segment where the search begins, and becomes the segment found.
    [[nodiscard]] At at(double s, std::size_t& i) const {
        const double turns = s >= 0 && s < length() ? 0 : std::floor(s / length());
        s -= turns * length();
        while (i + 1 < n_ && s_[i + 1] <= s) ++i;
        while (i > 0 && s_[i] > s) --i;
        const double l = s_[i + 1] - s_[i], t = l > 0 ? (s - s_[i]) / l : 0;
        const Vec2 a = point(i), p = geom::lerp(a, point(i + 1), t);
        const double w = line_->width[i] + t * (line_->width[i + 1 == n_ ? 0 : i + 1] - line_->width[i]);
        return {p, w, sum_[i] + (s - s_[i]) * geom::lerp(a, p, 0.5) + turns * sum_.back()};
    }

  private:
    [[nodiscard]] Vec2 point(std::size_t i) const { return line_->points[i == n_ ? 0 : i]; } // at most n_
    const toolpath::Curve* line_;
    std::size_t n_;
    std::vector<double> s_;
    std::vector<Vec2> sum_;
};

struct Corner {
    double s, reach;
};

struct RoundedStretch {
    double begin, end;
    std::vector<Corner> corner; // ascending
};

// The reach along a stretch, for places that ascend: constant near a corner, and continuous. A point moves to the mean
// of the line within it.
class Reach {
  public:
    explicit Reach(const RoundedStretch& part) : corner_(part.corner) {
        for (const Corner& c : corner_) most_ = std::max(most_, 2 * c.reach);
    }
    // mm, at s
    double operator()(double s) {
        while (first_ < corner_.size() && corner_[first_].s + most_ < s) ++first_;
        double out = 0;
        for (std::size_t k = first_; k < corner_.size() && corner_[k].s - most_ <= s; ++k)
            out = std::max(out, std::min(corner_[k].reach, 2 * corner_[k].reach - std::abs(s - corner_[k].s)));
        return out;
    }

  private:
    std::span<const Corner> corner_;
    double most_ = 0;       // mm: the farthest that a corner matters
    std::size_t first_ = 0; // corners before it are behind
};

// The reach on each side of a right angle that replaces it by a parabola leaving `open` mm2 beyond it.
double reach_for(double open) { return std::sqrt(6 * open); }

class Rounding {
  public:
    Rounding(const toolpath::Curve& line, double width, const Corners& how, const Room& room)
        : line_(&line), curve_(line), width_(width), tolerance_(how.tolerance),
          outline_(how.round == Rounded::everywhere), room_(&room) {
        const std::size_t n = line.points.size();
        turned_before_.reserve(n + 1);
        turned_before_.push_back(0);
        for (std::size_t i = 0; i < n; ++i) turned_before_.push_back(turned_before_.back() + turn(i));
    }

    // Finds the stretches to round: ascending, disjoint, and all within one lap from the start of the first one.
    // `open`: mm2 of void beyond a rounded right angle.
    void find_corners(double open) {
        reach_ = reach_for(open);
        step_ = std::sqrt(2 * reach_ * tolerance_);
        parts_.clear();
        turned_ = 0;
        collect_corners();
        close_lap();
    }

    // The sum of the turns at corners, in right angles.
    [[nodiscard]] double right_angles() const { return turned_ / std::numbers::sqrt2; }

    toolpath::Curve run() {
        if (parts_.empty()) return *line_;
        const std::size_t n = line_->points.size();
        const bool about_begin = parts_.front().begin < 0; // the first stretch holds the line's first point
        std::size_t points = n;
        for (const RoundedStretch& part : parts_) points += static_cast<std::size_t>(steps(part)) + 1;
        out_.points.reserve(points);
        out_.width.reserve(points);
        std::size_t next = 0;
        const auto keep_until = [&](double s) {
            for (; next < n && curve_.s(next) < s; ++next) out_.add(line_->points[next], line_->width[next]);
        };
        for (const RoundedStretch& part : parts_) {
            if (part.begin >= 0) keep_until(part.begin);
            smooth(part);
            while (next < n && curve_.s(next) <= part.end) ++next;
        }
        keep_until(about_begin ? parts_.front().begin + curve_.length() : curve_.length() + 1);
        return std::move(out_);
    }

  private:
    // The stretch of line within a reach of a place.
    struct Neighbourhood {
        Vec2 mean;
        double slower; // its length divided by that of its chord
    };
    [[nodiscard]] Neighbourhood neighbourhood(double s, double reach) {
        const auto a = curve_.at(s - reach, behind_), b = curve_.at(s + reach, ahead_);
        return {(1 / (2 * reach)) * (b.sum - a.sum), 2 * reach / std::max(1e-9, geom::distance(a.point, b.point))};
    }
    // The reach of the corner at a vertex; 0 if there is none.
    [[nodiscard]] double reach_at(std::size_t vertex) {
        const Vec2 p = line_->points[vertex];
        const double w = line_->width[vertex], most = rings::kMostOff * w;
        const double reach = reach_ * std::min(1.0, 2 * w / width_); // narrow lanes are near each other
        const double moved = geom::distance(p, neighbourhood(curve_.s(vertex), reach).mean);
        if (2 * moved < most) return 0;
        const double inside = std::min(w, width_);
        if ((*room_)(p, inside) >= inside) return reach; // else it lies along the outline
        return outline_ ? reach * std::min(1.0, most / moved) : 0;
    }
    // The turn at a vertex: the length of the difference of the unit vectors before and after it.
    [[nodiscard]] double turn(std::size_t i) const {
        const std::size_t n = line_->points.size();
        const Vec2 p = line_->points[i], u = p - line_->points[i == 0 ? n - 1 : i - 1];
        const Vec2 v = line_->points[i + 1 == n ? 0 : i + 1] - p;
        const double l = geom::norm2(u) * geom::norm2(v);
        return l > 0 ? std::sqrt(std::max(0.0, 2 - 2 * dot(u, v) / std::sqrt(l))) : 0;
    }

    // Sets the stretches about corners, ascending; their ends may lie beyond the line's.
    void collect_corners() {
        const std::size_t n = line_->points.size();
        // The middle of a neighbourhood with a smaller sum of turns moves by less than that of a corner.
        const double least = 2 * rings::kMostOff * width_ / reach_;
        std::size_t first = 0, last = 0; // vertices within the reach
        for (std::size_t i = 0; i < n; ++i) {
            const double s = curve_.s(i);
            while (curve_.s(first) < s - reach_) ++first;
            while (last < n && curve_.s(last) <= s + reach_) ++last;
            const bool whole = s > reach_ && s < curve_.length() - reach_;
            if (whole && turned_before_[last] - turned_before_[first] < least) continue;
            const double reach = reach_at(i);
            if (reach == 0) continue;
            if (parts_.empty() || s - reach > parts_.back().end) parts_.push_back({s - reach, s + reach, {}});
            parts_.back().end = std::max(parts_.back().end, s + reach);
            parts_.back().corner.push_back({s, reach});
            turned_ += turn(i);
        }
    }
    // Joins the last stretches to the first one where they reach it, and begins with the stretch that holds the line's
    // first point.
    void close_lap() {
        while (parts_.size() > 1 && parts_.back().end >= parts_.front().begin + curve_.length()) {
            RoundedStretch& first = parts_.front();
            std::vector<Corner>& before = parts_.back().corner;
            for (Corner& c : before) c.s -= curve_.length();
            first.corner.insert(first.corner.begin(), before.begin(), before.end());
            first.begin = std::min(first.begin, parts_.back().begin - curve_.length());
            first.end = std::max(first.end, parts_.back().end - curve_.length());
            parts_.pop_back();
        }
        if (!parts_.empty() && parts_.back().end >= curve_.length()) { // it holds the line's first point
            RoundedStretch part = std::move(parts_.back());
            parts_.pop_back();
            part.begin -= curve_.length();
            part.end -= curve_.length();
            for (Corner& c : part.corner) c.s -= curve_.length();
            parts_.insert(parts_.begin(), std::move(part));
        }
    }

    [[nodiscard]] int steps(const RoundedStretch& part) const {
        return std::max(2, static_cast<int>(std::ceil((part.end - part.begin) / step_)));
    }
    void smooth(const RoundedStretch& part) {
        const int n = steps(part);
        Reach reach(part);
        for (int k = 0; k <= n; ++k) {
            const double s = part.begin + (part.end - part.begin) * k / n;
            const auto [mean, slower] = neighbourhood(s, std::max(1e-6, reach(s)));
            const double w = curve_.at(s, here_).width, wider = w * std::min(slower, rings::kWidest);
            out_.add(mean, std::max(w, 2 * (*room_)(mean, std::min(wider / 2, width_))));
        }
    }

    const toolpath::Curve* line_;
    ArcLengthCurve curve_;
    double width_, tolerance_;          // mm
    double reach_ = 0, step_ = 0;       // mm; points step_ apart are off by at most a quarter of the tolerance
    std::vector<double> turned_before_; // per vertex: the sum of the turns before it
    bool outline_;
    const Room* room_;
    std::size_t behind_ = 0, here_ = 0, ahead_ = 0; // segments of the previous queries
    std::vector<RoundedStretch> parts_;
    double turned_ = 0; // sum of turn() over corners
    toolpath::Curve out_{true, {}, {}};
};

} // namespace

toolpath::Curve rounded(const toolpath::Curve& line, double width, const Corners& how, const Room& room) {
    if (how.round == Rounded::nowhere) return line;
    const double length = geom::length(line.points) + geom::distance(line.points.back(), line.points.front());
    if (length < 8 * reach_for(how.open)) return line;
    Rounding rounding(line, width, how, room);
    rounding.find_corners(how.open);
    if (length >= how.rare * rounding.right_angles()) return line;
    const double share = how.open_in_all / rounding.right_angles();
    if (share < how.open) rounding.find_corners(share);
    return rounding.run();
}

} // namespace filum::fill
