#include "polygon/cut.hpp"

#include "polygon/simple.hpp"

#include <algorithm>
#include <cmath>

namespace filum::polygon {

namespace {

Vec2 crossing(const ClipLine& cut, Vec2 a, Vec2 b) {
    const double fa = cut.above(a), fb = cut.above(b);
    return cut.point(std::lerp(cut.along(a), cut.along(b), fa / (fa - fb)));
}

} // namespace

double between_grid_points(double at) { return (std::floor(at / kGridStep) + 0.5) * kGridStep; }

CutSide side(const Loops& area, const ClipLine& cut, bool upper) {
    const auto here = [&](Vec2 p) { return (cut.above(p) > 0) == upper; };
    CutSide s;
    for (std::size_t l = 0; l < area.size(); ++l) {
        const auto loop = area[l];
        const std::size_t n = loop.size();
        std::size_t first = 0; // a point where the loop enters
        for (bool before = here(loop[n - 1]); first < n; ++first) {
            const bool now = here(loop[first]);
            if (now && !before) break;
            before = now;
        }
        if (first == n) {
            if (here(loop[0])) s.whole.add(loop);
            continue;
        }
        Vec2 before = loop[first == 0 ? n - 1 : first - 1];
        for (std::size_t k = 0, i = first; k < n; ++k) {
            const Vec2 p = loop[i];
            i = i + 1 == n ? 0 : i + 1;
            if (here(p)) {
                if (!here(before)) {
                    s.in.push_back({cut.along(crossing(cut, p, before)), s.chains.size(), p, before});
                    s.chains.emplace_back();
                }
                s.chains.back().push_back(p);
                if (!here(loop[i]))
                    s.out.push_back({cut.along(crossing(cut, p, loop[i])), s.chains.size() - 1, p, loop[i]});
            }
            before = p;
        }
    }
    for (auto* ends : {&s.in, &s.out})
        std::stable_sort(ends->begin(), ends->end(),
                         [](const CutEnd& a, const CutEnd& b) { return a.along < b.along; });
    return s;
}

std::optional<Loops> clipped_simple(const CutSide& s, const ClipLine& cut) {
    struct Crossing {
        double along;
        bool out;
        std::size_t chain;
    };
    std::vector<Crossing> all;
    for (const CutEnd& e : s.in) all.push_back({e.along, false, e.chain});
    for (const CutEnd& e : s.out) all.push_back({e.along, true, e.chain});
    std::stable_sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.along < b.along; });
    std::vector<std::size_t> next(s.chains.size());
    std::vector<double> begin(s.chains.size()), end(s.chains.size());
    for (std::size_t k = 0; k + 1 < all.size(); k += 2) {
        const Crossing &a = all[k], &b = all[k + 1];
        if (a.out == b.out || a.along == b.along) return std::nullopt;
        const Crossing &leaves = a.out ? a : b, &comes = a.out ? b : a;
        next[leaves.chain] = comes.chain;
        end[leaves.chain] = leaves.along;
        begin[comes.chain] = comes.along;
    }
    Loops out = s.whole;
    std::vector<char> seen(s.chains.size(), 0);
    for (std::size_t start = 0; start < s.chains.size(); ++start) {
        if (seen[start]) continue;
        for (std::size_t c = start; !seen[c]; c = next[c]) {
            seen[c] = 1;
            out.points.push_back(cut.point(begin[c]));
            out.points.insert(out.points.end(), s.chains[c].begin(), s.chains[c].end());
            out.points.push_back(cut.point(end[c]));
        }
        out.close();
    }
    return out;
}

std::optional<Loops> clipped_simple(const Loops& area, const Box2& box) {
    Loops out = area;
    const auto clip = [&](bool upright, double at, bool upper) {
        const ClipLine cut{upright, between_grid_points(at)};
        auto part = clipped_simple(side(out, cut, upper), cut);
        if (part) out = std::move(*part);
        return part.has_value();
    };
    if (clip(true, box.lo.x, true) && clip(true, box.hi.x, false) && clip(false, box.lo.y, true) &&
        clip(false, box.hi.y, false))
        return out;
    return std::nullopt;
}

} // namespace filum::polygon
