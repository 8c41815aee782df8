#include "polygon/clip.hpp"

#include "base/error.hpp"
#include "polygon/simple.hpp"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>

namespace filum::polygon {

namespace {

namespace cl = ClipperLib;

constexpr double kScale = 1e4; // grid units per mm

cl::Paths to_clipper(const Loops& a) {
    cl::Paths out(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        out[i].reserve(a[i].size());
        for (const Vec2 p : a[i]) out[i].emplace_back(std::llround(p.x * kScale), std::llround(p.y * kScale));
    }
    return out;
}

void append(Loops& out, const cl::Path& path) {
    if (path.size() < 3) return;
    for (const auto& p : path)
        out.points.push_back({static_cast<double>(p.X) / kScale, static_cast<double>(p.Y) / kScale});
    out.close();
}

Loops from_clipper(const cl::Paths& paths) {
    Loops out;
    for (const auto& path : paths) append(out, path);
    return out;
}

cl::PolyFillType fill_type(Fill rule) {
    if (rule == Fill::even_odd) return cl::pftEvenOdd;
    return rule == Fill::positive ? cl::pftPositive : cl::pftNonZero;
}

Loops combine(cl::ClipType kind, const Loops& a, const Loops* b, Fill rule, bool strict = true) {
    try {
        cl::Clipper clipper;
        clipper.AddPaths(to_clipper(a), cl::ptSubject, true);
        if (b != nullptr) clipper.AddPaths(to_clipper(*b), cl::ptClip, true);
        cl::Paths out;
        clipper.Execute(kind, out, fill_type(rule), fill_type(rule));
        Loops result = from_clipper(out);
        if (!strict || is_simple(result)) return result;
        clipper.StrictlySimple(true); // takes time by the square of the points, and is seldom needed
        clipper.Execute(kind, out, fill_type(rule), fill_type(rule));
        return from_clipper(out);
    } catch (const cl::clipperException& e) {
        throw Error(Exit::bad_input, std::string("cannot combine outlines: ") + e.what());
    }
}

struct Ordered {
    Vec2 key;
    std::size_t part;
};

// Collects the outer node and its holes as one part, then the outers inside the holes.
void collect(const cl::PolyNode& outer, int parent, Parts& out) {
    Loops part;
    append(part, outer.Contour);
    if (part.empty()) return;
    for (const auto* hole : outer.Childs) append(part, hole->Contour);
    const int self = static_cast<int>(out.part.size());
    out.part.push_back(std::move(part));
    out.parent.push_back(parent);
    for (const auto* hole : outer.Childs)
        for (const auto* island : hole->Childs) collect(*island, self, out);
}

Vec2 lowest_left(std::span<const Vec2> loop) {
    return *std::min_element(loop.begin(), loop.end(),
                             [](Vec2 a, Vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
}

// Keeps the points of path[first..last] that stray from the chord by more than the tolerance; iterative, so that deep
// recursion on long loops is no danger.
void keep_far_points(std::span<const Vec2> loop, std::size_t first, std::size_t last, double tolerance,
                     std::vector<char>& keep) {
    std::vector<std::pair<std::size_t, std::size_t>> todo{{first, last}};
    const std::size_t n = loop.size();
    while (!todo.empty()) {
        const auto [i, j] = todo.back();
        todo.pop_back();
        const Vec2 a = loop[i % n], d = loop[j % n] - a;
        const double l2 = geom::norm2(d);
        double worst = tolerance * tolerance;
        std::size_t at = 0;
        for (std::size_t k = i + 1; k < j; ++k) {
            const Vec2 q = loop[k] - a;
            const double t = l2 > 0 ? std::clamp(geom::dot(q, d) / l2, 0.0, 1.0) : 0.0;
            const double e = geom::norm2(q - t * d);
            if (e > worst) worst = e, at = k;
        }
        if (at == 0) continue;
        keep[at] = 1;
        todo.emplace_back(i, at);
        todo.emplace_back(at, j);
    }
}

} // namespace

Loops unite(const Loops& a, Fill rule) { return combine(cl::ctUnion, a, nullptr, rule); }
Loops unite(const Loops& a, const Loops& b, Fill rule) { return combine(cl::ctUnion, a, &b, rule); }
Loops intersect(const Loops& a, const Loops& b, Fill rule) { return combine(cl::ctIntersection, a, &b, rule); }
Loops intersect_touching(const Loops& a, const Loops& b, Fill rule) {
    return combine(cl::ctIntersection, a, &b, rule, false);
}
Loops subtract(const Loops& a, const Loops& b, Fill rule) { return combine(cl::ctDifference, a, &b, rule); }

Loops offset(const Loops& a, double delta, double arc_tolerance) {
    try {
        cl::ClipperOffset offsetter(2.0, arc_tolerance * kScale);
        offsetter.AddPaths(to_clipper(a), cl::jtRound, cl::etClosedPolygon);
        cl::Paths out;
        offsetter.Execute(out, delta * kScale);
        return from_clipper(out);
    } catch (const cl::clipperException& e) {
        throw Error(Exit::bad_input, std::string("cannot offset outlines: ") + e.what());
    }
}

Loops around(std::span<const Vec2> line, double radius, double arc_tolerance) {
    try {
        cl::ClipperOffset offsetter(2.0, arc_tolerance * kScale);
        cl::Path path;
        for (const Vec2 p : line) path.emplace_back(std::llround(p.x * kScale), std::llround(p.y * kScale));
        offsetter.AddPath(path, cl::jtRound, cl::etOpenRound);
        cl::Paths out;
        offsetter.Execute(out, radius * kScale);
        return from_clipper(out);
    } catch (const cl::clipperException& e) {
        throw Error(Exit::bad_input, std::string("cannot widen a line: ") + e.what());
    }
}

Parts split(const Loops& a) {
    cl::PolyTree tree;
    try {
        cl::Clipper clipper;
        clipper.StrictlySimple(true);
        clipper.AddPaths(to_clipper(a), cl::ptSubject, true);
        clipper.Execute(cl::ctUnion, tree, cl::pftNonZero, cl::pftNonZero);
    } catch (const cl::clipperException& e) {
        throw Error(Exit::bad_input, std::string("cannot split outlines: ") + e.what());
    }
    Parts found;
    for (const auto* outer : tree.Childs) collect(*outer, -1, found);

    std::vector<Ordered> order;
    for (std::size_t i = 0; i < found.part.size(); ++i) order.push_back({lowest_left(found.part[i][0]), i});
    std::stable_sort(order.begin(), order.end(), [](const Ordered& l, const Ordered& r) {
        return l.key.y < r.key.y || (l.key.y == r.key.y && l.key.x < r.key.x);
    });
    std::vector<int> place(found.part.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i].part] = static_cast<int>(i);
    Parts out;
    for (const auto& o : order) {
        out.part.push_back(std::move(found.part[o.part]));
        const int parent = found.parent[o.part];
        out.parent.push_back(parent < 0 ? -1 : place[static_cast<std::size_t>(parent)]);
    }
    return out;
}

Loops simplify(const Loops& a, double tolerance) {
    Loops out;
    std::vector<char> keep;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const auto loop = a[i];
        if (loop.size() < 3) continue;
        std::size_t far = 0; // the two fixed points: the first, and the one farthest from it
        for (std::size_t k = 1; k < loop.size(); ++k)
            if (geom::norm2(loop[k] - loop[0]) > geom::norm2(loop[far] - loop[0])) far = k;
        if (far == 0) continue;
        keep.assign(loop.size(), 0);
        keep[0] = keep[far] = 1;
        keep_far_points(loop, 0, far, tolerance, keep);
        keep_far_points(loop, far, loop.size(), tolerance, keep);
        const std::size_t before = out.points.size();
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (keep[k]) out.points.push_back(loop[k]);
        if (out.points.size() - before < 3)
            out.points.resize(before);
        else
            out.close();
    }
    return out;
}

} // namespace filum::polygon
