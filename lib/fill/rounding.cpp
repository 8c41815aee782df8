#include "fill/rounding.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill {

namespace {

// Of rounded corners; in reaches unless said otherwise.
constexpr double kTurned = 0.97;    // chord to arc: a smaller ratio is a corner
constexpr double kAcute = 0.66;     // and a smaller one than this an acute corner
constexpr double kAcuteReach = 2.6; // about those
constexpr double kInnerReach = 2;   // about other corners of inner lanes, which lie in those of the lanes around them
constexpr double kOuter = 0.75; // bead widths from the outline: nearer, acute corners are worth more than their room
constexpr double kShortestRounded = 60; // a shorter line stays as it is
constexpr double kWiden = 1.7;          // times the width, at most
constexpr double kSpill = 0.03;         // bead widths that a widened bead may reach over the outline
constexpr int kPoints = 6;              // per corner

// A closed line by arc length.  Asking for places near the last one is quick.
class Course {
  public:
    explicit Course(const BeadLine& line) : line_(&line), n_(line.points.size()) {
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
        Vec2 sum; // of the points from the line's begin on, times mm
    };
    // i: the segment to look from; then the one that was found.
    [[nodiscard]] At at(double s, std::size_t& i) const {
        const double turns = std::floor(s / length());
        s -= turns * length();
        while (i + 1 < n_ && s_[i + 1] <= s) ++i;
        while (i > 0 && s_[i] > s) --i;
        const double l = s_[i + 1] - s_[i], t = l > 0 ? (s - s_[i]) / l : 0;
        const Vec2 a = point(i), p = geom::lerp(a, point(i + 1), t);
        const double w = line_->width[i] + t * (line_->width[(i + 1) % n_] - line_->width[i]);
        return {p, w, sum_[i] + (s - s_[i]) * geom::lerp(a, p, 0.5) + turns * sum_.back()};
    }

  private:
    [[nodiscard]] Vec2 point(std::size_t i) const { return line_->points[i % n_]; }
    const BeadLine* line_;
    std::size_t n_;
    std::vector<double> s_;
    std::vector<Vec2> sum_;
};

struct Corner {
    double s, reach;
};

struct RoundedStretch {
    double begin, end;
    std::vector<Corner> corner;
    // A point is moved to the mean of what is nearer to it than this: constant about a corner, and continuous.
    [[nodiscard]] double reach(double s) const {
        double out = 0;
        for (const Corner& c : corner) out = std::max(out, std::min(c.reach, 2 * c.reach - std::abs(s - c.s)));
        return out;
    }
};

class Rounding {
  public:
    Rounding(const BeadLine& line, double width, const Reach& reach, const std::function<double(Vec2)>& room)
        : line_(&line), course_(line), width_(width), reach_(reach.mm), outline_(reach.at_outline), room_(&room) {}

    BeadLine run() {
        find_corners();
        if (parts_.empty()) return *line_;
        const std::size_t n = line_->points.size();
        const bool about_begin = parts_.front().begin < 0; // the first stretch holds the line's first point
        std::size_t next = 0;
        const auto keep_until = [&](double s) {
            for (; next < n && course_.s(next) < s; ++next) out_.add(line_->points[next], line_->width[next]);
        };
        for (const RoundedStretch& part : parts_) {
            if (part.begin >= 0) keep_until(part.begin);
            smooth(part);
            while (next < n && course_.s(next) <= part.end) ++next;
        }
        keep_until(about_begin ? parts_.front().begin + course_.length() : course_.length() + 1);
        return std::move(out_);
    }

  private:
    [[nodiscard]] double reach_at(std::size_t vertex) {
        const double s = course_.s(vertex);
        const double ratio =
            geom::distance(course_.at(s - reach_, behind_).point, course_.at(s + reach_, ahead_).point) / (2 * reach_);
        if (ratio >= kTurned) return 0;
        const bool outer = (*room_)(line_->points[vertex]) < kOuter * line_->width[vertex];
        const double reach = reach_ * std::min(1.0, 2 * line_->width[vertex] / width_); // narrow lanes are near
        if (outer) return outline_ ? reach : 0;
        return (ratio < kAcute ? kAcuteReach : kInnerReach) * reach;
    }
    [[nodiscard]] double turn(std::size_t i) const {
        const std::size_t n = line_->points.size();
        const Vec2 p = line_->points[i], u = p - line_->points[i == 0 ? n - 1 : i - 1];
        const Vec2 v = line_->points[i + 1 == n ? 0 : i + 1] - p;
        const double l = geom::norm2(u) * geom::norm2(v);
        return l > 0 ? std::sqrt(std::max(0.0, 2 - 2 * dot(u, v) / std::sqrt(l))) : 0;
    }

    // Ascending and apart, all within a turn from the first one's begin.
    void find_corners() {
        const std::size_t n = line_->points.size();
        std::vector<double> turned{0}; // up to vertex i, of the unit vectors along the segments: less than the angle
        for (std::size_t i = 0; i < n; ++i) turned.push_back(turned.back() + turn(i));
        // Unit vectors whose steps add up to less have a part of kTurned or more along one direction: so has the chord.
        const double least = 2 * std::sqrt(1 - kTurned * kTurned);
        std::size_t first = 0, last = 0; // vertices within the reach
        for (std::size_t i = 0; i < n; ++i) {
            const double s = course_.s(i);
            while (course_.s(first) < s - reach_) ++first;
            while (last < n && course_.s(last) <= s + reach_) ++last;
            const bool whole = s > reach_ && s < course_.length() - reach_;
            if (whole && turned[last] - turned[first] < least) continue;
            const double reach = reach_at(i);
            if (reach == 0) continue;
            if (parts_.empty() || s - reach > parts_.back().end) parts_.push_back({s - reach, s + reach, {}});
            parts_.back().end = std::max(parts_.back().end, s + reach);
            parts_.back().corner.push_back({s, reach});
        }
        while (parts_.size() > 1 && parts_.back().end >= parts_.front().begin + course_.length()) {
            RoundedStretch& first = parts_.front();
            for (Corner c : parts_.back().corner) {
                c.s -= course_.length();
                first.corner.push_back(c);
            }
            first.begin = std::min(first.begin, parts_.back().begin - course_.length());
            first.end = std::max(first.end, parts_.back().end - course_.length());
            parts_.pop_back();
        }
    }

    void smooth(const RoundedStretch& part) {
        const int n = std::max(2, static_cast<int>(std::lround(kPoints * (part.end - part.begin) / (2 * reach_))));
        for (int k = 0; k <= n; ++k) {
            const double s = part.begin + (part.end - part.begin) * k / n;
            const double reach = std::max(1e-6, part.reach(s));
            const auto a = course_.at(s - reach, behind_), b = course_.at(s + reach, ahead_);
            const double slower = 2 * reach / std::max(1e-9, geom::distance(a.point, b.point));
            const Vec2 p = (1 / (2 * reach)) * (b.sum - a.sum);
            const double w = course_.at(s, here_).width;
            out_.add(p, std::max(w, std::min(w * std::min(slower, kWiden), 2 * (*room_)(p) + kSpill * w)));
        }
    }

    const BeadLine* line_;
    Course course_;
    double width_, reach_;
    bool outline_;
    const std::function<double(Vec2)>* room_;
    std::size_t behind_ = 0, here_ = 0, ahead_ = 0; // segments of the places asked for last
    std::vector<RoundedStretch> parts_;
    BeadLine out_;
};

} // namespace

BeadLine rounded(const BeadLine& line, double width, const Reach& reach, const std::function<double(Vec2)>& room) {
    double length = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i)
        length += geom::distance(line.points[i], line.points[(i + 1) % line.points.size()]);
    return length < kShortestRounded * reach.mm ? line : Rounding(line, width, reach, room).run();
}

} // namespace filum::fill
