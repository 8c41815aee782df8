#include "fill/join/splices.hpp"

#include "geom/polyline.hpp"

#include <algorithm>

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

std::vector<double> lengths(const RingGraph& graph) {
    std::vector<double> out;
    for (std::uint32_t r = 0; r < graph.size(); ++r) out.push_back(graph.length(r));
    return out;
}

} // namespace

Splices::Splices(const RingGraph& graph) : graph_(&graph), weave_(lengths(graph)) {
    for (std::uint32_t r = 0; r < graph.size(); ++r)
        if (graph.open(r)) weave_.open(r);
}

void Splices::add(Splice splice) {
    std::vector<std::uint32_t> number;
    for (const weave::Window& w : splice.windows) number.push_back(weave_.cut(w));
    for (Link& l : splice.links) {
        weave_.link({number[l.from.window], l.from.after}, {number[l.to.window], l.to.after});
        beads_.push_back(std::move(l.bead));
    }
}

// Appends the points of the part and of the link that follows it.
void Splices::walk(const weave::Step& step, Curve& line) const {
    const auto first = static_cast<std::ptrdiff_t>(line.points.size());
    graph_->append(step.curve, step.from, step.to, line);
    if (step.backwards) {
        std::reverse(line.points.begin() + first, line.points.end());
        std::reverse(line.width.begin() + first, line.width.end());
    }
    if (step.link == kNone) return;
    append(beads_[step.link].points, step.link_backwards, line.points);
    append(beads_[step.link].width, step.link_backwards, line.width);
}

std::vector<Curve> Splices::trace() const {
    std::vector<Curve> out;
    for (const weave::Trace& trace : weave_.traces()) {
        double points = 0; // an estimate
        for (const weave::Step& s : trace.steps)
            points += graph_->points(s.curve) * (s.to - s.from) / graph_->length(s.curve) + 8;
        Curve line{trace.closed, {}, {}};
        line.points.reserve(static_cast<std::size_t>(points));
        line.width.reserve(static_cast<std::size_t>(points));
        for (const weave::Step& s : trace.steps) walk(s, line);
        out.push_back(std::move(line));
    }
    const auto closed = std::find_if(out.begin(), out.end(), [](const Curve& c) { return c.closed; });
    std::stable_sort(closed, out.end(), [](const Curve& a, const Curve& b) { return length(a) > length(b); });
    return out;
}

} // namespace filum::fill::join
