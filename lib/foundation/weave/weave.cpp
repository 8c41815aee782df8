#include "weave/weave.hpp"

#include <algorithm>
#include <cmath>

namespace filum::weave {

namespace {

// The window with 0 <= from < length.
Window shifted(Window w, double length) {
    const double begin = std::floor(w.from / length) * length;
    return {w.curve, w.from - begin, w.to - begin};
}

} // namespace

struct Weave::Parts {
    struct PartEnd {
        std::uint32_t part = kNone; // kNone: a free end
        bool last = false;          // of the part: its last place, or its first
    };
    struct Part {
        std::uint32_t curve;
        double from, to;
        std::array<PartEnd, 2> next{};                   // what follows its first and its last place
        std::array<std::uint32_t, 2> link{kNone, kNone}; // the links there
        std::array<bool, 2> forwards{};                  // whether the link leads away from the part
    };
    std::vector<Part> all; // by curve, then by arc length
};

Weave::Weave(std::vector<double> lengths)
    : lengths_(std::move(lengths)), of_(lengths_.size()), groups_(lengths_.size()) {}

bool Weave::free(const Window& window) const {
    const double l = lengths_[window.curve];
    if (window.to - window.from >= l) return false;
    const Window w = shifted(window, l);
    return std::all_of(of_[w.curve].begin(), of_[w.curve].end(), [&](std::uint32_t k) {
        for (const double shift : {-l, 0.0, l})
            if (w.from + shift < windows_[k].to && windows_[k].from < w.to + shift) return false;
        return true;
    });
}

std::uint32_t Weave::cut(const Window& window) {
    const auto number = static_cast<std::uint32_t>(windows_.size());
    windows_.push_back(shifted(window, lengths_[window.curve]));
    of_[window.curve].push_back(number);
    return number;
}

std::uint32_t Weave::link(End a, End b) {
    links_.push_back({a, b, false});
    groups_.unite(windows_[a.window].curve, windows_[b.window].curve);
    return static_cast<std::uint32_t>(links_.size() - 1);
}

std::uint32_t Weave::tail(End a) {
    links_.push_back({a, {}, true});
    return static_cast<std::uint32_t>(links_.size() - 1);
}

std::array<std::uint32_t, 2> Weave::exchange(const Window& a, const Window& b, bool same) {
    const std::uint32_t first = cut(a), second = cut(b);
    return {link({first, false}, {second, !same}), link({first, true}, {second, same})};
}

Weave::Parts Weave::parts() const {
    Parts out;
    std::vector<Parts::PartEnd> ends(2 * windows_.size()); // per window: before it, after it
    for (std::uint32_t c = 0; c < lengths_.size(); ++c) {
        auto cuts = of_[c];
        std::sort(cuts.begin(), cuts.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return windows_[a].from < windows_[b].from; });
        const auto first = static_cast<std::uint32_t>(out.all.size()), n = static_cast<std::uint32_t>(cuts.size());
        for (std::uint32_t k = 0; k < n; ++k) {
            const bool wraps = k + 1 == n;
            const double end = windows_[cuts[wraps ? 0 : k + 1]].from + (wraps ? lengths_[c] : 0);
            out.all.push_back({c, windows_[cuts[k]].to, end});
            ends[2 * cuts[k]] = {first + (k + n - 1) % n, true};
            ends[2 * cuts[k] + 1] = {first + k, false};
        }
        if (n == 0) out.all.push_back({c, 0, lengths_[c], {{{first, true}, {first, false}}}});
    }
    const auto at = [&](End e) { return ends[2 * e.window + (e.after ? 1 : 0)]; };
    const auto connect = [&](Parts::PartEnd from, Parts::PartEnd to, std::uint32_t link, bool forwards) {
        Parts::Part& part = out.all[from.part];
        const std::size_t side = from.last ? 1 : 0;
        part.next[side] = to;
        part.link[side] = link;
        part.forwards[side] = forwards;
    };
    for (std::uint32_t k = 0; k < links_.size(); ++k) {
        const Link& link = links_[k];
        connect(at(link.from), link.tail ? Parts::PartEnd{} : at(link.to), k, true);
        if (!link.tail) connect(at(link.to), at(link.from), k, false);
    }
    return out;
}

// The curve that enters `part` at its last or its first place.
Trace Weave::trace(const Parts& parts, std::uint32_t part, bool last, std::vector<char>& seen) {
    Trace out;
    const Parts::Part& first = parts.all[part];
    const std::size_t entered = last ? 1 : 0;
    if (first.next[entered].part == kNone) {
        out.closed = false;
        out.tail = first.link[entered];
    }
    for (Parts::PartEnd at{part, last}; at.part != kNone && !seen[at.part];) {
        const Parts::Part& now = parts.all[at.part];
        seen[at.part] = 1;
        const std::size_t leaves = at.last ? 0 : 1;
        out.steps.push_back({now.curve, now.from, now.to, at.last, now.link[leaves], !now.forwards[leaves]});
        at = now.next[leaves];
    }
    return out;
}

std::vector<Trace> Weave::traces() const {
    const Parts all = parts();
    std::vector<char> seen(all.all.size(), 0);
    std::vector<Trace> out;
    for (const bool closed : {false, true})
        for (std::uint32_t p = 0; p < all.all.size(); ++p)
            for (const bool last : {false, true})
                if (!seen[p] && (closed || all.all[p].next[last ? 1 : 0].part == kNone))
                    out.push_back(trace(all, p, last, seen));
    return out;
}

} // namespace filum::weave
