#include "surface/fit/sizes.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace filum::surface::fit {

namespace {

constexpr double kGrading = 0.5; // change of size per mm along the surface: neighbours differ by half at most

// Angle between the normals at a side, rad; 0 at a rim.
double bend(const Surface& s, std::uint32_t h) {
    return s.twin[h] == kNone ? 0 : angle(normal(s, h / 3), normal(s, s.twin[h] / 3));
}

bool on_line(const Surface& s, std::uint32_t h) { return s.twin[h] == kNone || bend(s, h) > kSharp; }

// Mean height of the two triangles at a side, mm.
double height(const Surface& s, std::uint32_t h) {
    return (area(s, h / 3) + area(s, s.twin[h] / 3)) / side_length(s, h);
}

// The continuation of a line at the head of half-edge h, which is not a corner.
struct LineStep {
    std::uint32_t h = kNone;
    bool forward = true; // whether the line follows its direction

    [[nodiscard]] std::uint32_t end(const Surface& s) const { return forward ? s.head(h) : s.tail(h); }
};

// The line sides at each vertex, outwards.
std::vector<std::vector<LineStep>> lines_at(const Surface& s) {
    std::vector<std::vector<LineStep>> out(s.vertices.size());
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        if ((s.twin[h] != kNone && s.twin[h] < h) || !on_line(s, h)) continue;
        out[s.tail(h)].push_back({h, true});
        out[s.head(h)].push_back({h, false});
    }
    return out;
}

bool corner(const Surface& s, std::uint32_t v, const std::vector<LineStep>& lines) {
    if (lines.size() != 2) return !lines.empty();
    const Vec3 a = s.vertices[v] - s.vertices[lines[0].end(s)], b = s.vertices[lines[1].end(s)] - s.vertices[v];
    return angle(a, b) > kSharp;
}

// Fixes as many vertices between the ends of a chain as necessary.
void thin(const Surface& s, const std::vector<std::uint32_t>& chain, double tolerance, Editable& m) {
    const auto fits = [&](std::size_t i, std::size_t j) {
        const Vec3 &a = s.vertices[chain[i]], &b = s.vertices[chain[j]];
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = i; k <= j; ++k) {
            const Vec3& p = s.vertices[chain[k]];
            if (distance(p, a + geom::nearest_parameter(a, b, p) * (b - a)) > tolerance) return false;
            least = std::min(least, m.size[chain[k]]);
        }
        return distance(a, b) <= least;
    };
    m.kind[chain.front()] = m.kind[chain.back()] = VertexKind::fixed;
    for (std::size_t i = 0; i + 1 < chain.size();) {
        std::size_t j = i + 1;
        while (j + 1 < chain.size() && fits(i, j + 1)) ++j;
        m.kind[chain[j]] = VertexKind::fixed;
        i = j;
    }
}

void fix_lines(const Surface& s, double tolerance, Editable& m) {
    const auto lines = lines_at(s);
    for (std::uint32_t v = 0; v < lines.size(); ++v)
        if (!lines[v].empty()) m.kind[v] = corner(s, v, lines[v]) ? VertexKind::fixed : VertexKind::on_line;
    const auto corners = m.kind;
    std::vector<char> seen(s.twin.size(), 0);
    const auto follow = [&](std::uint32_t from, const LineStep& first) {
        if (seen[first.h]) return;
        std::vector<std::uint32_t> chain{from};
        for (LineStep at = first;;) {
            seen[at.h] = 1;
            const std::uint32_t v = at.end(s);
            chain.push_back(v);
            if (v == from || corners[v] == VertexKind::fixed) break;
            at = lines[v][0].h == at.h ? lines[v][1] : lines[v][0];
        }
        thin(s, chain, tolerance, m);
    };
    for (const bool ends : {true, false}) // lines from corners first, then closed ones without corners
        for (std::uint32_t v = 0; v < lines.size(); ++v)
            if ((corners[v] == VertexKind::fixed) == ends)
                for (const LineStep& step : lines[v]) follow(v, step);
}

} // namespace

void grade(const Surface& s, std::vector<double>& sizes) {
    using Next = std::pair<double, std::uint32_t>;
    std::priority_queue<Next, std::vector<Next>, std::greater<>> open;
    for (std::uint32_t v = 0; v < sizes.size(); ++v) open.emplace(sizes[v], v);
    while (!open.empty()) {
        const double size = open.top().first;
        const std::uint32_t v = open.top().second;
        open.pop();
        if (size > sizes[v]) continue;
        const auto reach = [&](std::uint32_t w) {
            const double most = size + kGrading * distance(s.vertices[v], s.vertices[w]);
            if (!(most < sizes[w])) return;
            sizes[w] = most;
            open.emplace(most, w);
        };
        each_outgoing(s, v, [&](std::uint32_t h) {
            reach(s.head(h));
            reach(s.tail(prev(h)));
        });
    }
}

Sizes sizes(const Surface& s, double longest, double tolerance) {
    Sizes out{std::vector<double>(s.vertices.size(), longest), std::vector<double>(s.vertices.size(), longest)};
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        const double turn = on_line(s, h) ? 0 : bend(s, h);
        if (!(turn > 0)) continue;
        const double across = height(s, h), least = std::max(kLeast * tolerance, across);
        const double chord = std::sqrt(6 * tolerance * across / turn); // chord on a sphere of that curvature
        for (const std::uint32_t v : {s.tail(h), s.head(h)}) {
            out.least[v] = std::min(out.least[v], least);
            out.wanted[v] = std::min(out.wanted[v], std::max(least, chord / kLong));
        }
    }
    grade(s, out.wanted);
    return out;
}

Editable editable(const Surface& s, std::vector<double> sizes, double tolerance) {
    Editable m;
    m.at = s.vertices;
    m.size = std::move(sizes);
    m.kind.assign(s.vertices.size(), VertexKind::free);
    m.triangles = s.triangles;
    m.twin = s.twin;
    m.out = s.outgoing;
    m.line.assign(s.twin.size(), 0);
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) m.line[h] = on_line(s, h);
    fix_lines(s, tolerance / 2, m);
    m.up.assign(s.vertices.size(), {});
    for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
        bool sharp = false;
        each_outgoing(s, v, [&](std::uint32_t h) {
            sharp = sharp || (m.line[h] != 0 && s.twin[h] != kNone);
            m.up[v] = m.up[v] + area(s, h / 3) * normal(s, h / 3);
        });
        if (sharp) m.up[v] = {};
    }
    return m;
}

} // namespace filum::surface::fit
