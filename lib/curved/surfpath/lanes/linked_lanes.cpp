#include "surfpath/lanes/linked_lanes.hpp"

#include <algorithm>

namespace filum::surfpath::lanes {

namespace {

std::vector<double> lengths(const Lanes& lanes) {
    std::vector<double> out;
    for (std::uint32_t l = 0; l < lanes.size(); ++l) out.push_back(lanes.length(l));
    return out;
}

void append(Line& to, Line line, bool backwards) {
    if (backwards) surface::curve::reverse(line);
    surface::curve::append(to, line);
}

} // namespace

LinkedLanes::LinkedLanes(const Lanes& lanes) : lanes_(lanes), weave_(lengths(lanes)) {}

weave::Window LinkedLanes::window(std::uint32_t lane, double from, double to) const {
    return {lane, from, from + lanes_.ahead(lane, from, to, 1)};
}

bool LinkedLanes::free(const weave::Window& w, double margin) const {
    return weave_.free({w.curve, w.from - margin, w.to + margin});
}

void LinkedLanes::link(weave::End a, weave::End b, Line line) {
    weave_.link(a, b);
    lines_.push_back(std::move(line));
}

void LinkedLanes::tail(weave::End a, Line line) {
    weave_.tail(a);
    lines_.push_back(std::move(line));
}

void LinkedLanes::exchange(const weave::Window& a, const weave::Window& b, bool same, std::array<Line, 2> lines) {
    weave_.exchange(a, b, same);
    for (Line& line : lines) lines_.push_back(std::move(line));
}

LinkedLanes::Curve LinkedLanes::curve(const weave::Trace& trace) const {
    Curve out{{}, trace.closed, {}};
    if (trace.tail != kNone) append(out.line, lines_[trace.tail], true);
    for (const weave::Step& s : trace.steps) {
        append(out.line, lanes_.part(s.curve, s.from, s.to), s.backwards);
        if (s.link != kNone) append(out.line, lines_[s.link], s.link_backwards);
        out.lanes.push_back(s.curve);
    }
    std::sort(out.lanes.begin(), out.lanes.end());
    out.lanes.erase(std::unique(out.lanes.begin(), out.lanes.end()), out.lanes.end());
    return out;
}

Line LinkedLanes::Curve::take(const Vec3& begin) {
    line.closed = closed;
    if (closed)
        line.places.pop_back();
    else if (distance(line[0], begin) > distance(line.places.back().point, begin))
        surface::curve::reverse(line);
    return std::move(line);
}

std::vector<LinkedLanes::Curve> LinkedLanes::curves() const {
    std::vector<Curve> out;
    for (const weave::Trace& trace : weave_.traces()) out.push_back(curve(trace));
    return out;
}

} // namespace filum::surfpath::lanes
