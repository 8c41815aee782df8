#include "surface/curve/strands.hpp"

#include "geom/segment.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>

namespace filum::surface::curve {

namespace {

constexpr double kUnmoved = 1e-4; // mm: points that moved less count as unmoved

} // namespace

Strands::Strands(const Surface& s, std::span<const Line> lines, double step, std::size_t fewest) : s_(s), step_(step) {
    for (const Line& line : lines) {
        Strand strand{places.size(), 0, line.closed, line, {}};
        if (line.size() >= 3) {
            strand.threaded = threaded(s, line);
            strand.arcs = arc_lengths(strand.threaded);
            const Line points = resampled(strand.threaded, step);
            if (points.size() >= fewest) {
                strand.count = points.size();
                places.insert(places.end(), points.places.begin(), points.places.end());
                of.resize(places.size(), static_cast<std::uint32_t>(all.size()));
            }
        }
        all.push_back(std::move(strand));
    }
    start = places;
}

bool Strands::moved(std::size_t point) const { return distance(places[point].point, start[point].point) >= kUnmoved; }

std::vector<StrandRun> Strands::moved_runs(const Strand& strand) const {
    std::vector<StrandRun> out;
    const auto n = static_cast<std::ptrdiff_t>(strand.count);
    std::ptrdiff_t begin = 0;
    if (strand.closed) // begins at a point that did not move, if there is one
        while (begin < n && moved(strand.first + static_cast<std::size_t>(begin))) ++begin;
    if (begin == n) begin = 0;
    for (std::ptrdiff_t i = begin; i < begin + n; ++i) {
        if (!moved(strand.first + static_cast<std::size_t>(i % n))) continue;
        if (!out.empty() && out.back().to == i)
            ++out.back().to;
        else
            out.push_back({i, i + 1});
    }
    return out;
}

double Strands::area_moved(const Strand& strand, StrandRun run, std::ptrdiff_t beside) const {
    double out = 0;
    for (std::ptrdiff_t i = run.from; i < run.to; ++i) {
        const auto j = static_cast<std::size_t>(strand.at(0, i));
        const Vec3& p = places[strand.first + j].point;
        double least = distance(p, start[strand.first + j].point);
        for (std::ptrdiff_t k = -beside; k < beside; ++k) {
            const std::ptrdiff_t a = strand.at(j, k), b = strand.at(j, k + 1);
            if (a < 0 || b < 0) continue;
            const Vec3 &u = start[strand.first + static_cast<std::size_t>(a)].point,
                       &v = start[strand.first + static_cast<std::size_t>(b)].point;
            least = std::min(least, distance(p, u + geom::nearest_parameter(u, v, p) * (v - u)));
        }
        out += least * step_;
    }
    return out;
}

Line Strands::line(const Strand& strand) const {
    const Line& line = strand.threaded;
    if (moved_runs(strand).empty()) return line;
    const std::size_t n = strand.count;
    const double unit = strand.arcs.back() / static_cast<double>(line.closed ? n : n - 1);
    Line out{{}, line.closed};
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
        const std::size_t a = strand.first + i, b = strand.first + (i + 1) % n;
        const double from = unit * static_cast<double>(i);
        append(out,
               !moved(a) && !moved(b) ? part(line, strand.arcs, from, from + unit) : join(s_, places[a], places[b]));
    }
    if (line.closed && out.size() > 1 && distance(out[0], out[out.size() - 1]) < 1e-9) out.places.pop_back();
    return out;
}

} // namespace filum::surface::curve
