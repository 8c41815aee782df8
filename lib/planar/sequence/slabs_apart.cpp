#include "sequence/slabs_apart.hpp"

#include <algorithm>

namespace filum::sequence {

namespace {

// The regions from `first` to `last`, numbered from 0, on layers from 0, without relations to others.
std::vector<polygon::Region> slab(const std::vector<polygon::Region>& all, std::size_t first, std::size_t last) {
    std::vector<polygon::Region> out(all.begin() + static_cast<std::ptrdiff_t>(first),
                                     all.begin() + static_cast<std::ptrdiff_t>(last));
    const auto id = static_cast<std::uint32_t>(first);
    const std::uint32_t layer = out.front().layer;
    for (polygon::Region& r : out) {
        r.id -= id;
        r.layer -= layer;
        if (r.parent >= 0) r.parent -= id;
        if (r.brim >= 0) r.brim -= id;
        std::erase_if(r.below, [&](const polygon::Overlap& o) { return o.below < id; });
        for (polygon::Overlap& o : r.below) o.below -= id;
    }
    return out;
}

double value(const Facts& facts, const std::string& name) {
    const auto at = std::find_if(facts.begin(), facts.end(), [&](const Fact& f) { return f.name == name; });
    return at == facts.end() ? 0 : at->value;
}

// Sums facts, except shares and facts about a single result.
void add_facts(const Facts& of, Facts& to) {
    for (const Fact& f : of) {
        const auto at = std::find_if(to.begin(), to.end(), [&](const Fact& t) { return t.name == f.name; });
        if (at == to.end())
            to.push_back(f);
        else if (f.name == "search-complete")
            at->value = std::min(at->value, f.value);
        else
            at->value += f.value;
    }
}

} // namespace

SequenceResult sequence_apart(const std::vector<polygon::Region>& regions, const Options& options,
                              const machine::Pauses& pauses) {
    // A region that is several layers high belongs to the uppermost of them.
    const auto before = [&](std::size_t i) {
        return pauses.before(regions[i].layer, regions[i].z, regions[i].height / regions[i].layers);
    };
    SequenceResult out;
    std::uint32_t strokes = 0;
    for (std::size_t first = 0, last = 0; first < regions.size(); first = last) {
        while (last < regions.size() && before(last) == before(first)) ++last;
        Options own = options;
        own.budget = options.budget * (last - first) / regions.size();
        const SequenceResult part = sequence(slab(regions, first, last), own);
        for (std::size_t i = 0; i < part.order.size(); ++i) {
            out.order.push_back(part.order[i] + static_cast<Index>(first));
            out.stroke.push_back(part.stroke[i] + strokes);
            out.join.push_back(part.join[i]);
        }
        strokes += part.stroke.back() + 1;
        add_facts(part.facts, out.facts);
        out.bound_by = out.bound_by.empty() || out.bound_by == part.bound_by ? part.bound_by : "several";
    }
    Index changes = 0;
    for (std::size_t i = 1; i < out.order.size(); ++i)
        changes += regions[out.order[i - 1]].tool == regions[out.order[i]].tool ? 0 : 1;
    for (Fact& f : out.facts) {
        if (f.name == "tools") f.value = static_cast<double>(tools(support_graph(regions)).size());
        if (f.name == "tool-changes") f.value = changes; // also those at pauses
    }
    // A bound that was computed for some slabs only is not a bound of the whole.
    std::erase_if(out.facts, [](const Fact& f) { return f.name == "relaxation-bound"; });
    for (Fact& f : out.facts)
        if (f.name == "gap")
            f.value = 100 * (1 - value(out.facts, "lower-bound") / value(out.facts, "planned-strokes"));
    return out;
}

} // namespace filum::sequence
