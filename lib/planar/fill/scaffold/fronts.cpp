#include "fill/scaffold/fronts.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/polyline.hpp"
#include "geom/segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::fill::scaffold {

namespace {

constexpr double kMostCells = 1e6; // rows times columns, a limit of work; larger boxes get wider columns
constexpr double kStable = 0.5;    // columns that a front may advance in one step
constexpr double kFlat = 0.001;    // mm; points of curves nearer to their neighbours' chord are left out

// A front after the next step: up if `sign` is 1, down if it is -1.
std::vector<double> advanced(const std::vector<double>& y, double left, double step, double by, double sign,
                             const SpacingAt& spacing) {
    std::vector<double> out(y.size());
    const std::size_t last = y.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const double before = i > 0 ? sign * (y[i - 1] - y[i]) / step : -std::numeric_limits<double>::infinity();
        const double after = i < last ? sign * (y[i + 1] - y[i]) / step : -std::numeric_limits<double>::infinity();
        // The front comes from where it is ahead. Beyond the box it goes on as it is at its side.
        const double slope = i == 0 ? std::abs(after) : i == last ? std::abs(before) : std::max({before, after, 0.0});
        const Vec2 at{left + static_cast<double>(i) * step, y[i]};
        out[i] = y[i] + sign * by * spacing(at) * std::sqrt(1 + slope * slope);
    }
    return out;
}

// Leaves out points that lie on the chord between the points that remain.
std::vector<Vec2> without_flat_points(std::span<const Vec2> line) {
    std::vector<Vec2> out{line.front()};
    for (std::size_t i = 0; i + 1 < line.size();) {
        std::size_t end = i + 1;
        const auto flat = [&](std::size_t to) {
            for (std::size_t k = i + 1; k < to; ++k)
                if (geom::point_segment_distance(line[i], line[to], line[k]) > kFlat) return false;
            return true;
        };
        while (end + 1 < line.size() && end - i < 64 && flat(end + 1)) ++end;
        out.push_back(line[end]);
        i = end;
    }
    return out;
}

} // namespace

Fronts::Fronts(const geom::Box2& box, double resolution, const SpacingAt& spacing) : left_(box.lo.x) {
    const double width = std::max(box.hi.x - box.lo.x, resolution), height = std::max(box.hi.y - box.lo.y, resolution);
    const double wanted = std::max(resolution, std::sqrt(width * height / (kMostCells * kStable)));
    const auto columns = static_cast<std::size_t>(std::ceil(width / wanted));
    step_ = width / static_cast<double>(columns);
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (std::size_t i = 0; i <= columns; ++i)
        for (double y = box.lo.y; y <= box.hi.y; y += wanted) {
            const double s = spacing({left_ + static_cast<double>(i) * step_, y});
            least = std::min(least, s);
            most = std::max(most, s);
        }
    if (most > kMostRatio * least)
        throw Error(Exit::usage, "cannot space strands from " + fixed_text(least, 3) + " to " + fixed_text(most, 3) +
                                     " mm within a layer: they may differ by a factor of " + shortest_text(kMostRatio) +
                                     "; change --pore-size or --porosity less");
    const auto parts = static_cast<std::size_t>(std::ceil(most / (kStable * step_)));
    per_row_ = 1 / static_cast<double>(parts);
    const std::vector<double> middle(columns + 1, (box.lo.y + box.hi.y) / 2);
    std::vector<std::vector<double>> up{middle}, down{middle};
    while (*std::ranges::min_element(up.back()) < box.hi.y)
        up.push_back(advanced(up.back(), left_, step_, per_row_, 1, spacing));
    while (*std::ranges::max_element(down.back()) > box.lo.y)
        down.push_back(advanced(down.back(), left_, step_, per_row_, -1, spacing));
    first_ = -per_row_ * static_cast<double>(down.size() - 1);
    rows_.assign(down.rbegin(), down.rend() - 1);
    rows_.insert(rows_.end(), up.begin(), up.end());
}

std::pair<std::size_t, double> Fronts::column(double x) const {
    const double last = static_cast<double>(rows_.front().size() - 1);
    const double at = std::clamp((x - left_) / step_, 0.0, last);
    const double whole = std::min(std::floor(at), std::max(0.0, last - 1));
    return {static_cast<std::size_t>(whole), at - whole};
}

double Fronts::row_y(std::size_t row, std::size_t column, double share) const {
    const auto& y = rows_[row];
    return y[column] + share * (y[column + 1] - y[column]);
}

double Fronts::level(Vec2 p) const {
    const auto [c, share] = column(p.x);
    std::size_t low = 0, high = rows_.size() - 1;
    while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (row_y(middle, c, share) <= p.y ? low : high) = middle;
    }
    const double a = row_y(low, c, share), b = row_y(high, c, share);
    return first_ + per_row_ * (static_cast<double>(low) + (p.y - a) / (b - a));
}

double Fronts::y(double x, double level) const {
    const auto [c, share] = column(x);
    const double at = std::clamp((level - first_) / per_row_, 0.0, static_cast<double>(rows_.size() - 1));
    const auto row = std::min(static_cast<std::size_t>(at), rows_.size() - 2);
    const double a = row_y(row, c, share), b = row_y(row + 1, c, share);
    return a + (at - static_cast<double>(row)) * (b - a);
}

std::vector<Vec2> Fronts::line(double from, double to, double level) const {
    std::vector<Vec2> out{{from, y(from, level)}};
    for (double k = std::floor((from - left_) / step_) + 1; left_ + k * step_ < to; k += 1) {
        const double x = left_ + k * step_;
        if (x > from) out.push_back({x, y(x, level)});
    }
    out.push_back({to, y(to, level)});
    return without_flat_points(out);
}

StrandGraph bent_strand_graph(const Loops& area, const Fronts& fronts, std::span<const double> levels, double shortest,
                              std::optional<Vec2> start) {
    // Fronts become straight if y is replaced by the level. So the strands are those of an area in these coordinates,
    // whose edges are cut so short that they stay straight.
    const auto flat = [&](Vec2 p) { return Vec2{p.x, fronts.level(p)}; };
    const auto raised = [&](Vec2 p) { return Vec2{p.x, fronts.y(p.x, p.y)}; };
    Loops flattened;
    for (std::size_t l = 0; l < area.size(); ++l) {
        const auto loop = area[l];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
            const auto parts =
                static_cast<std::size_t>(std::max(1.0, std::ceil(geom::distance(a, b) / fronts.column_width())));
            for (std::size_t k = 0; k < parts; ++k)
                flattened.points.push_back(flat(geom::lerp(a, b, static_cast<double>(k) / static_cast<double>(parts))));
        }
        flattened.close();
    }
    StrandGraph out = strand_graph(flattened, levels, shortest, start ? std::optional(flat(*start)) : std::nullopt);
    for (std::size_t k = 0; k < out.strands; ++k) {
        const Vec2 a = out.node[2 * k], b = out.node[2 * k + 1];
        out.line.push_back(fronts.line(a.x, b.x, a.y));
    }
    for (Vec2& p : out.node) p = raised(p);
    for (Arc& arc : out.arcs) {
        for (Vec2& p : arc.line) p = raised(p);
        arc.line = without_flat_points(arc.line);
        arc.length = geom::length(arc.line);
    }
    return out;
}

} // namespace filum::fill::scaffold
