#include "surfpath/lanes/weave.hpp"

#include <algorithm>

namespace filum::surfpath::lanes {

bool Weave::free(std::uint32_t lane, double from, double to, double margin) const {
    const double wide = lanes_.ahead(lane, from, to, 1) + 2 * margin;
    if (wide > lanes_.length(lane)) return false;
    return std::all_of(of_[lane].begin(), of_[lane].end(), [&](std::uint32_t w) {
        const double on = lanes_.ahead(lane, from - margin, openings_[w].from, 1);
        return on >= wide && on + openings_[w].length <= lanes_.length(lane);
    });
}

std::uint32_t Weave::cut(std::uint32_t lane, double from, double to) {
    const auto w = static_cast<std::uint32_t>(openings_.size());
    openings_.push_back({lane, from, lanes_.ahead(lane, from, to, 1)});
    of_[lane].push_back(w);
    links_.resize(2 * openings_.size());
    linked_.resize(2 * openings_.size(), 0);
    return w;
}

void Weave::link(LaneEnd a, LaneEnd b, Line line) {
    Line back = line;
    surface::curve::reverse(back);
    links_[index(a)] = {b, std::move(line), false};
    links_[index(b)] = {a, std::move(back), false};
    linked_[index(a)] = linked_[index(b)] = 1;
}

void Weave::tail(LaneEnd a, Line line) {
    links_[index(a)] = {a, std::move(line), true};
    linked_[index(a)] = 1;
}

// The remainder of the lane from one end to the next opening.
Line Weave::remainder(LaneEnd from, LaneEnd& to) const {
    const Opening& w = openings_[from.opening];
    const double all = lanes_.length(w.lane), at = from.after ? w.from + w.length : w.from;
    double least = all;
    std::uint32_t best = from.opening;
    if (of_[w.lane].size() == 1) least = all - w.length;
    for (const auto o : of_[w.lane]) {
        if (o == from.opening) continue;
        const Opening& other = openings_[o];
        const double on =
            lanes_.ahead(w.lane, at, from.after ? other.from : other.from + other.length, from.after ? 1 : -1);
        if (on < least) {
            least = on;
            best = o;
        }
    }
    to = {best, !from.after};
    if (from.after) return lanes_.part(w.lane, at, at + least);
    Line out = lanes_.part(w.lane, at - least, at);
    surface::curve::reverse(out);
    return out;
}

Weave::Curve Weave::follow(LaneEnd from, std::vector<char>& seen) const {
    Curve out;
    const LaneEnd first = from;
    for (;;) {
        seen[index(from)] = 1;
        LaneEnd to;
        surface::curve::append(out.line, remainder(from, to));
        seen[index(to)] = 1;
        out.lanes.push_back(openings_[to.opening].lane);
        if (!linked_[index(to)]) break;
        const Link& link = links_[index(to)];
        surface::curve::append(out.line, link.line);
        if (link.open) break;
        from = link.to;
        if (from.opening == first.opening && from.after == first.after) {
            out.closed = true;
            break;
        }
    }
    std::sort(out.lanes.begin(), out.lanes.end());
    out.lanes.erase(std::unique(out.lanes.begin(), out.lanes.end()), out.lanes.end());
    return out;
}

std::vector<Weave::Curve> Weave::curves() const {
    std::vector<Curve> out;
    std::vector<char> seen(links_.size(), 0);
    for (const bool closed : {false, true})
        for (std::uint32_t w = 0; w < openings_.size(); ++w)
            for (const bool after : {false, true}) {
                const LaneEnd e{w, after};
                if (seen[index(e)] || (!closed && linked_[index(e)] && !links_[index(e)].open)) continue;
                Curve path = follow(e, seen);
                if (!closed && linked_[index(e)]) {
                    Line head = links_[index(e)].line;
                    surface::curve::reverse(head);
                    surface::curve::append(head, path.line);
                    path.line = std::move(head);
                }
                out.push_back(std::move(path));
            }
    for (std::uint32_t l = 0; l < lanes_.size(); ++l)
        if (of_[l].empty()) out.push_back({lanes_.part(l, 0, lanes_.length(l)), true, {l}});
    return out;
}

} // namespace filum::surfpath::lanes
