#include "fill/rounding.hpp"

#include <algorithm>
#include <cmath>

namespace filum::fill {

namespace {

constexpr double kTurned = 0.97; // chord to arc: a smaller ratio is a corner
constexpr double kWiden = 1.35;  // at most
constexpr double kSpill = 0.05;  // widths that a bead may reach over the outline
constexpr int kPoints = 6;       // per corner

// A closed line by arc length, to be asked for ascending places.
class Course {
  public:
    explicit Course(const BeadLine& line) : line_(&line), n_(line.points.size()) {
        s_.push_back(0), sum_.push_back({});
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
    [[nodiscard]] At at(double s) const {
        const double turns = std::floor(s / length());
        s -= turns * length();
        const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
            std::upper_bound(s_.begin(), s_.end(), s) - s_.begin() - 1, 0, static_cast<std::ptrdiff_t>(n_) - 1));
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

struct Stretch {
    double begin, end;
};

// Where the line is to be rounded: about its corners, ascending, apart, within a turn from the first one's begin.
std::vector<Stretch> corners(const BeadLine& line, const Course& course, double reach) {
    std::vector<Stretch> out;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const double s = course.s(i);
        const double chord = geom::distance(course.at(s - reach).point, course.at(s + reach).point);
        if (chord >= kTurned * 2 * reach) continue;
        if (!out.empty() && s - reach <= out.back().end)
            out.back().end = s + reach;
        else
            out.push_back({s - reach, s + reach});
    }
    while (out.size() > 1 && out.back().end >= out.front().begin + course.length()) {
        out.front().begin = std::min(out.front().begin, out.back().begin - course.length());
        out.pop_back();
    }
    return out;
}

void smooth(const Course& course, const Stretch& part, double reach, const std::function<double(Vec2)>& room,
            BeadLine& out) {
    const int n = std::max(2, static_cast<int>(std::ceil(kPoints * (part.end - part.begin) / (2 * reach))));
    for (int k = 0; k <= n; ++k) {
        const double s = part.begin + (part.end - part.begin) * k / n;
        const auto a = course.at(s - reach), b = course.at(s + reach);
        const double slower = 2 * reach / std::max(1e-9, geom::distance(a.point, b.point));
        const Vec2 p = (1 / (2 * reach)) * (b.sum - a.sum);
        const double w = course.at(s).width;
        out.add(p, std::max(w, std::min(w * std::min(slower, kWiden), 2 * room(p) + kSpill * w)));
    }
}

} // namespace

BeadLine rounded(const BeadLine& line, double reach, const std::function<double(Vec2)>& room) {
    const Course course(line);
    if (line.points.size() < 3 || course.length() < 60 * reach) return line;
    const auto parts = corners(line, course, reach);
    if (parts.empty()) return line;
    BeadLine out;
    std::size_t next = 0;
    const auto keep_until = [&](double s) {
        for (; next < line.points.size() && course.s(next) < s; ++next) out.add(line.points[next], line.width[next]);
    };
    const auto skip_until = [&](double s) {
        while (next < line.points.size() && course.s(next) <= s) ++next;
    };
    const double wrapped = parts.front().begin + course.length(); // where the first part begins again
    skip_until(parts.front().begin < 0 ? parts.front().end : -1);
    for (const Stretch& part : parts) {
        if (part.begin >= 0) keep_until(part.begin);
        smooth(course, part, reach, room, out);
        skip_until(part.end);
    }
    keep_until(parts.front().begin < 0 ? wrapped : course.length() + 1);
    return out;
}

} // namespace filum::fill
