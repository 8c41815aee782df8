#include "fill/join/splices.hpp"

#include "geom/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::fill::join {

namespace {

template <class T>
void append(const std::vector<T>& piece, bool backwards, std::vector<T>& to) {
    if (backwards)
        to.insert(to.end(), piece.rbegin(), piece.rend());
    else
        to.insert(to.end(), piece.begin(), piece.end());
}

double length(const Curve& line) {
    return geom::length(line.points) + geom::distance(line.points.back(), line.points.front());
}

} // namespace

Splices::Splices(const RingGraph& graph) : graph_(&graph), used_(graph.size()) {
    // an open line is a ring with a window where it begins and ends, and no link there
    for (std::uint32_t r = 0; r < graph.size(); ++r)
        if (graph.open(r)) add({{{r, 0, 0}}, {}});
}

bool Splices::free(std::uint32_t ring, double s0, double s1) const {
    const double l = graph_->length(ring);
    if (s1 - s0 >= l) return false;
    const double begin = std::floor(s0 / l) * l;
    s0 -= begin;
    s1 -= begin;
    for (const auto& [a, b] : used_[ring])
        for (const double shift : {-l, 0.0, l})
            if (s0 + shift < b && a < s1 + shift) return false;
    return true;
}

void Splices::add(Splice splice) {
    for (Window& w : splice.windows) {
        const double l = graph_->length(w.ring), begin = std::floor(w.s0 / l) * l;
        w.s0 -= begin;
        w.s1 -= begin;
        used_[w.ring].emplace_back(w.s0, w.s1);
    }
    splices_.push_back(std::move(splice));
}

std::vector<Splices::Arc> Splices::arcs() const {
    // per ring the cuts in order of arc length; an arc runs from each cut to the next
    struct Cut {
        double s0, s1;
        std::uint32_t window; // counted over all splices
    };
    std::vector<std::vector<Cut>> cuts(graph_->size());
    std::uint32_t windows = 0;
    for (const Splice& s : splices_)
        for (const Window& w : s.windows) cuts[w.ring].push_back({w.s0, w.s1, windows++});

    std::vector<Arc> out;
    std::vector<End> rims(2 * windows); // per window: the arc that ends at s0, the one that begins at s1
    for (std::uint32_t r = 0; r < graph_->size(); ++r) {
        auto& c = cuts[r];
        std::sort(c.begin(), c.end(), [](const Cut& a, const Cut& b) { return a.s0 < b.s0; });
        const auto first = static_cast<std::uint32_t>(out.size()), n = static_cast<std::uint32_t>(c.size());
        for (std::uint32_t k = 0; k < n; ++k) {
            const bool wraps = k + 1 == n;
            const double end = c[wraps ? 0 : k + 1].s0 + (wraps ? graph_->length(r) : 0);
            out.push_back({r, c[k].s1, end, {}, {}, {}});
            rims[2 * c[k].window] = {first + (k + n - 1) % n, true};
            rims[2 * c[k].window + 1] = {first + k, false};
        }
        if (n == 0) out.push_back({r, 0, graph_->length(r), {{first, true}, {first, false}}, {}, {}});
    }

    const auto tie = [&](End a, End b, const Link& link, bool along) {
        Arc& arc = out[a.arc];
        const int side = a.last ? 1 : 0;
        arc.next[side] = b;
        arc.link[side] = &link;
        arc.along[side] = along;
    };
    std::uint32_t base = 0;
    for (const Splice& s : splices_) {
        for (const Link& l : s.links) {
            const End a = rims[2 * (base + l.from.window) + (l.from.end ? 1 : 0)];
            const End b = rims[2 * (base + l.to.window) + (l.to.end ? 1 : 0)];
            tie(a, b, l, true);
            tie(b, a, l, false);
        }
        base += static_cast<std::uint32_t>(s.windows.size());
    }
    return out;
}

// Appends the points of the arc and of the link that follows it.
void Splices::walk(const Arc& arc, bool backwards, Curve& line) const {
    const auto first = static_cast<std::ptrdiff_t>(line.points.size());
    graph_->append(arc.ring, arc.s0, arc.s1, line);
    if (backwards) {
        std::reverse(line.points.begin() + first, line.points.end());
        std::reverse(line.width.begin() + first, line.width.end());
    }
    const int side = backwards ? 0 : 1;
    if (arc.link[side] == nullptr) return;
    append(arc.link[side]->bead.points, !arc.along[side], line.points);
    append(arc.link[side]->bead.width, !arc.along[side], line.width);
}

std::vector<Curve> Splices::trace() const {
    const auto all = arcs();
    std::vector<char> seen(all.size(), 0);
    std::vector<Curve> out;
    std::vector<std::uint32_t> starts(all.size());
    std::iota(starts.begin(), starts.end(), 0U);
    std::stable_partition(starts.begin(), starts.end(), [&](std::uint32_t a) { return all[a].next[0].arc == kNone; });
    for (const std::uint32_t start : starts) {
        if (seen[start]) continue;
        std::vector<End> way; // where arcs are entered
        double points = 0;    // an estimate
        for (End at{start, false}; at.arc != kNone && !seen[at.arc]; at = all[at.arc].next[at.last ? 0 : 1]) {
            const Arc& arc = all[at.arc];
            seen[at.arc] = 1;
            way.push_back(at);
            points += graph_->points(arc.ring) * (arc.s1 - arc.s0) / graph_->length(arc.ring) + 8;
        }
        Curve line{all[start].next[0].arc != kNone, {}, {}};
        line.points.reserve(static_cast<std::size_t>(points));
        line.width.reserve(static_cast<std::size_t>(points));
        for (const End at : way) walk(all[at.arc], at.last, line);
        out.push_back(std::move(line));
    }
    const auto closed = std::find_if(out.begin(), out.end(), [](const Curve& c) { return c.closed; });
    std::stable_sort(closed, out.end(), [](const Curve& a, const Curve& b) { return length(a) > length(b); });
    return out;
}

} // namespace filum::fill::join
