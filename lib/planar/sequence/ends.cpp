#include "sequence/ends.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <array>

namespace filum::sequence {

namespace {

struct EndCauses {
    const Graph& g;
    std::span<const Index> order;
    const Arcs& support;
    const std::vector<Outline>& outlines;
    const machine::Heads& heads;
    std::vector<Index> place; // of each region in the order

    // Which part of the head over `lower` would touch `upper`.
    [[nodiscard]] Cause part(Index lower, Index upper, double apart) const {
        const machine::Head& head = heads.of(g.node[lower].tool);
        const Reach r = reach(head, g.node[upper].z - g.node[lower].z);
        if (apart < head.flat_radius) return Cause::tip;
        if (apart < r.radius) return Cause::cone;
        const Reach box{0, r.half_x, r.half_y, false};
        if (within(outlines[lower], outlines[upper], box)) return Cause::carriage;
        const bool beside = !r.everywhere && !heads.beside(g.node[lower].tool).empty();
        return beside ? Cause::idle : Cause::gantry;
    }

    [[nodiscard]] End end(Index stroke, Index u) const {
        End e{stroke, u, Cause::top, kNone, kNone, 0};
        for (const Index v : g.up[u])
            if (e.ahead == kNone || place[v] < place[e.ahead]) e.ahead = v;
        if (e.ahead == kNone) return e;
        if (const Index p = place[e.ahead]; continues(g, order[p - 1], e.ahead)) {
            e.cause = Cause::taken;
            return e;
        }
        for (const Index p : g.before[e.ahead])
            if (place[p] > place[u] && (e.awaited == kNone || place[p] > place[e.awaited])) e.awaited = p;
        if (e.awaited == kNone) {
            e.cause = Cause::open;
            return e;
        }
        const auto carried = support[e.awaited];
        if (std::binary_search(carried.begin(), carried.end(), e.ahead)) {
            e.cause = Cause::support;
            return e;
        }
        e.distance = distance(outlines[e.awaited], outlines[e.ahead]);
        e.cause = part(e.awaited, e.ahead, e.distance);
        return e;
    }
};

} // namespace

std::string_view name(Cause c) {
    constexpr std::array<std::string_view, kCauses> names{"top",      "taken",  "support", "tip", "cone",
                                                          "carriage", "gantry", "open",    "idle"};
    return names[static_cast<std::size_t>(c)];
}

std::vector<End> ends(const Graph& g, std::span<const Index> order, const Arcs& support,
                      const std::vector<Outline>& outlines, const machine::Heads& heads) {
    EndCauses s{g, order, support, outlines, heads, std::vector<Index>(g.size())};
    for (std::size_t i = 0; i < order.size(); ++i) s.place[order[i]] = static_cast<Index>(i);
    std::vector<End> out;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i + 1 == order.size() || !continues(g, order[i], order[i + 1]))
            out.push_back(s.end(static_cast<Index>(out.size()), order[i]));
    return out;
}

std::vector<Index> tally(const std::vector<End>& ends) {
    std::vector<Index> out(kCauses, 0);
    for (const End& e : ends) ++out[static_cast<std::size_t>(e.cause)];
    return out;
}

std::string table(const Graph& g, const std::vector<End>& ends) {
    std::string out = "stroke\tregion\tlayer\tz_mm\tx_mm\ty_mm\tcause\tahead\tawaited\trise_mm\tdistance_mm\n";
    const auto region = [](Index v) { return v == kNone ? std::string("-") : std::to_string(v); };
    for (const End& e : ends) {
        const Node& n = g.node[e.region];
        const bool head = (e.cause >= Cause::tip && e.cause <= Cause::gantry) || e.cause == Cause::idle;
        out += std::to_string(e.stroke) + '\t' + region(e.region) + '\t' + std::to_string(n.layer) + '\t' +
               fixed_text(n.z, 4) + '\t' + fixed_text(n.centre.x, 3) + '\t' + fixed_text(n.centre.y, 3) + '\t' +
               std::string(name(e.cause)) + '\t' + region(e.ahead) + '\t' + region(e.awaited) + '\t' +
               (head ? fixed_text(g.node[e.ahead].z - g.node[e.awaited].z, 4) : "-") + '\t' +
               (head ? fixed_text(e.distance, 4) : "-") + '\n';
    }
    return out;
}

} // namespace filum::sequence
