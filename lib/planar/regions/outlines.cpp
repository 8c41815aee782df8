#include "regions/outlines.hpp"

#include "geom/segment_grid.hpp"
#include "polygon/simple.hpp"
#include "regions/gaps.hpp"
#include "regions/inradius.hpp"

#include <algorithm>
#include <cmath>

namespace filum::regions {

namespace {

using geom::Vec2;
using polygon::Loops;
using polygon::Parts;

constexpr double kGrid = polygon::kGridPerMm;

Loops on_grid(const Loops& a) {
    Loops out;
    out.points.reserve(a.points.size());
    for (std::size_t l = 0; l < a.size(); ++l) {
        const std::size_t first = out.points.size();
        for (const Vec2 p : a[l]) {
            const Vec2 q{std::round(p.x * kGrid) / kGrid, std::round(p.y * kGrid) / kGrid};
            if (out.points.size() == first || out.points.back() != q) out.points.push_back(q);
        }
        while (out.points.size() > first + 1 && out.points.back() == out.points[first]) out.points.pop_back();
        if (out.points.size() < first + 3)
            out.points.resize(first);
        else
            out.close();
    }
    return out;
}

bool crosses_itself(const Loops& loops) {
    std::vector<geom::Segment> edges;
    edges.reserve(loops.points.size());
    double length = 0;
    const auto whole = [](Vec2 p) { return Vec2{std::round(p.x * kGrid), std::round(p.y * kGrid)}; };
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto loop = loops[l];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            edges.push_back({whole(loop[i]), whole(loop[(i + 1) % loop.size()])});
            length += geom::distance(edges.back().a, edges.back().b);
        }
    }
    if (edges.empty()) return false;
    const geom::SegmentGrid grid(edges, length / static_cast<double>(edges.size()));
    for (const auto& e : edges)
        if (grid.crosses(e.a, e.b, edges, [](std::uint32_t) { return true; })) return true;
    return false;
}

// The parts of outlines that touch: those of Clipper, mended where its rounding left a crossing.
Parts mended(const Loops& loops, Notes& notes) {
    Parts found = polygon::split(loops), out;
    std::vector<int> place(found.part.size(), -1);
    for (std::size_t i = 0; i < found.part.size(); ++i) {
        Loops part = found.part[i];
        for (double r = 0.0005; r < 0.02 && crosses_itself(part); r *= 2) {
            const Parts opened = polygon::split(polygon::opened(found.part[i], r));
            part = {};
            double largest = 0; // smaller parts that an opening by a few um cuts off are dust
            for (const auto& p : opened.part)
                if (const double a = polygon::signed_area(p); a > largest) {
                    largest = a;
                    part = p;
                }
        }
        const double lost = polygon::signed_area(found.part[i]) - (part.empty() ? 0 : polygon::signed_area(part));
        if (part.empty() || crosses_itself(part)) {
            const Vec2 at = found.part[i].points.front();
            notes.push_back({NoteCode::outline_crosses_itself, lost, 1, -1, at.x, at.y});
            continue;
        }
        place[i] = static_cast<int>(out.part.size());
        out.part.push_back(std::move(part));
        out.parent.push_back(static_cast<int>(i)); // its number in `found`, until all places are known
    }
    for (int& p : out.parent) {
        p = found.parent[static_cast<std::size_t>(p)];
        if (p >= 0) p = place[static_cast<std::size_t>(p)];
    }
    return out;
}

// The loops without new holes into which no circle of diameter `hairline` fits. Holes that `before` has too stay.
Loops without_remnants(const Loops& loops, const Loops& before, double hairline) {
    std::vector<Vec2> known(before.points);
    const auto less = [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
    std::sort(known.begin(), known.end(), less);
    Loops out;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const bool old = std::all_of(loops[l].begin(), loops[l].end(),
                                     [&](Vec2 p) { return std::binary_search(known.begin(), known.end(), p, less); });
        if (!old && polygon::signed_area(loops[l]) < 0) {
            std::vector<Vec2> turned(loops[l].rbegin(), loops[l].rend());
            Loops hole;
            hole.add(turned);
            if (inradius_bound(hole, hairline / 2, hairline / 2) == 0) continue;
        }
        out.add(loops[l]);
    }
    return out;
}

// Closes the gaps of simple loops that are narrower than `hairline`, and adds a note. False if there are none.
bool close_gaps(Loops& loops, double tolerance, double hairline, Notes& notes, int layer) {
    const Loops patches = bridges(loops, hairline, layer);
    if (patches.empty()) return false;
    const double before = polygon::signed_area(loops);
    constexpr std::size_t kMany = 2000; // points of patches; fewer are united with the loops at once
    const bool many = patches.points.size() > kMany;
    Loops closed = polygon::unite(loops, many ? polygon::unite_by_halves(patches) : patches);
    closed = without_remnants(closed, loops, hairline);
    const Vec2 at = geom::lerp(patches[0][0], patches[0][patches[0].size() / 2], 0.5);
    loops = on_grid(polygon::simplify(closed, tolerance));
    notes.push_back(
        {NoteCode::hairline_gap_closed, std::max(0.0, polygon::signed_area(loops) - before), 1, -1, at.x, at.y});
    return true;
}

} // namespace

Parts outlines(const Loops& contours, double tolerance, double hairline, Notes& notes, int layer) {
    Loops loops = on_grid(polygon::simplify(contours, tolerance));
    bool simple = polygon::is_simple(loops);
    if (!simple) loops = polygon::unite(loops);
    if (hairline > 0 && close_gaps(loops, tolerance, hairline, notes, layer)) simple = false;
    for (int attempt = 0; attempt < 3; ++attempt) {
        if (simple || polygon::is_simple(loops)) return polygon::split(loops);
        loops = polygon::unite(loops);
    }
    return mended(loops, notes);
}

} // namespace filum::regions
