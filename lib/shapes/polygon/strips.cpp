#include "polygon/strips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::polygon {

namespace {

constexpr int kSteps = 40;       // steps per strip height
constexpr double kFlat = 0.25;   // slope from which an edge no longer counts as flat
constexpr double kUneven = 0.15; // cost of a strip twice as high as `height`, as a share of its area

// The length of flat outline per step of y; a steeper edge counts less.
std::vector<double> flats(const Loops& area, double low, double step, std::size_t count) {
    std::vector<double> out(count, 0.0);
    for (std::size_t i = 0; i < area.size(); ++i) {
        const auto loop = area[i];
        for (std::size_t j = 0, k = loop.size() - 1; j < loop.size(); k = j++) {
            const double dx = std::abs(loop[j].x - loop[k].x), dy = std::abs(loop[j].y - loop[k].y);
            if (dy >= kFlat * dx) continue;
            const int parts = 1 + static_cast<int>(dy / step);
            for (int part = 0; part < parts; ++part) {
                const double y = loop[k].y + (loop[j].y - loop[k].y) * (part + 0.5) / parts;
                const auto at = static_cast<std::size_t>(std::lround((y - low) / step));
                out[std::min(at, count - 1)] += dx * (1 - dy / (kFlat * dx)) / parts;
            }
        }
    }
    return out;
}

// The cost of the flat outline between each pair of cuts i < j; constant time by running sums.
struct Misfit {
    std::vector<double> length, moment; // sums over the steps before i of f and f * i

    explicit Misfit(const std::vector<double>& f) : length(f.size() + 1, 0.0), moment(f.size() + 1, 0.0) {
        for (std::size_t i = 0; i < f.size(); ++i) {
            length[i + 1] = length[i] + f[i];
            moment[i + 1] = moment[i] + f[i] * static_cast<double>(i);
        }
    }
    // The sum of f * steps to the nearer of i and j.
    [[nodiscard]] double operator()(std::size_t i, std::size_t j) const {
        const std::size_t m = (i + j + 1) / 2;
        const double below = moment[m] - moment[i] - static_cast<double>(i) * (length[m] - length[i]);
        const double above = static_cast<double>(j) * (length[j] - length[m]) - (moment[j] - moment[m]);
        return below + above;
    }
};

} // namespace

std::vector<double> strip_bounds(const Loops& area, double height, double give) {
    const auto box = bounds(area);
    const double extent = box.hi.y - box.lo.y;
    const double wanted = std::max(1.0, std::round(extent / height));
    std::vector<double> even;
    for (int i = 0; i <= static_cast<int>(wanted); ++i) even.push_back(box.lo.y + i * extent / wanted);
    const double least = (1 - give) * height, most = (1 + give) * height;
    if (extent / wanted < least || extent / wanted > most) return even;

    const auto steps = static_cast<std::size_t>(std::max(1.0, std::round(extent / (height / kSteps))));
    const double step = extent / static_cast<double>(steps);
    const Misfit misfit(flats(area, box.lo.y, step, steps + 1));
    const auto lo = static_cast<std::size_t>(std::ceil(least / step - 1e-9));
    const auto hi = static_cast<std::size_t>(std::floor(most / step + 1e-9));
    const double breadth = signed_area(area) / extent; // mean length of a line in the area
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> cost(steps + 1, never);
    std::vector<std::size_t> from(steps + 1, 0);
    cost[0] = 0;
    for (std::size_t j = lo; j <= steps; ++j)
        for (std::size_t h = lo; h <= std::min(hi, j); ++h) {
            if (cost[j - h] == never) continue;
            const double off = static_cast<double>(h) * step / height - 1;
            const double c = cost[j - h] + misfit(j - h, j) * step + kUneven * breadth * height * off * off;
            if (c < cost[j]) {
                cost[j] = c;
                from[j] = j - h;
            }
        }
    if (cost[steps] == never) return even;
    std::vector<double> out;
    for (std::size_t j = steps; j > 0; j = from[j]) out.push_back(box.lo.y + static_cast<double>(j) * step);
    out.push_back(box.lo.y);
    std::reverse(out.begin(), out.end());
    out.back() = box.hi.y;
    return out;
}

} // namespace filum::polygon
