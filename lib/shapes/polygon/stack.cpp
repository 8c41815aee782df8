#include "polygon/stack.hpp"

#include "base/error.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace filum::polygon {

std::vector<std::uint32_t> close_gaps(std::vector<Region>& regions, std::uint32_t most) {
    std::vector<std::uint32_t> given;
    given.reserve(regions.size());
    for (const Region& r : regions)
        for (std::int64_t k = r.rests_on() + 1; k <= r.layer; ++k) given.push_back(static_cast<std::uint32_t>(k));
    std::sort(given.begin(), given.end());
    given.erase(std::unique(given.begin(), given.end()), given.end());
    // original: old numbers by new number; now: new numbers by place in `given`
    std::vector<std::uint32_t> original, now(given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::uint32_t before = i == 0 ? given[0] : given[i] - given[i - 1] - 1; // empty layers
        for (std::uint32_t k = std::min(before, most); k > 0; --k) original.push_back(given[i] - k);
        now[i] = static_cast<std::uint32_t>(original.size());
        original.push_back(given[i]);
    }
    for (Region& r : regions)
        r.layer = now[static_cast<std::size_t>(std::lower_bound(given.begin(), given.end(), r.layer) - given.begin())];
    return original;
}

void restore_layers(Notes& notes, std::span<const std::uint32_t> original) {
    for (Note& n : notes)
        if (n.layer >= 0 && static_cast<std::size_t>(n.layer) < original.size())
            n.layer = original[static_cast<std::size_t>(n.layer)];
}

namespace {

std::string number(std::uint32_t n) { return std::to_string(n); }

// The fault of a region that follows `before`, which is null for the first region; empty if there is none.
std::string order_fault(const Region& r, const Region* before) {
    if (before == nullptr) return "";
    if (r.layer < before->layer) return "region " + number(r.id) + " is on a lower layer than the one before it";
    if (r.layer > before->layer && !(r.z > before->z))
        return "layer " + number(r.layer) + " is not higher than layer " + number(before->layer);
    return "";
}

} // namespace

std::string fault(const std::vector<Region>& regions) {
    std::unordered_map<std::int64_t, std::size_t> place;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (!place.emplace(regions[i].id, i).second) return "two regions have the id " + number(regions[i].id);
        if (auto text = order_fault(regions[i], i == 0 ? nullptr : &regions[i - 1]); !text.empty()) return text;
    }
    for (const Region& r : regions) {
        for (const Overlap& o : r.below) {
            const auto to = place.find(o.below);
            if (to == place.end() || regions[to->second].layer >= r.layer)
                return "region " + number(r.id) + " lies on region " + number(o.below) + ", which is on no lower layer";
        }
        for (const std::int64_t other : {r.parent, r.brim}) {
            if (other < 0) continue;
            const auto to = place.find(other);
            if (to == place.end() || regions[to->second].layer != r.layer || other == r.id)
                return "region " + number(r.id) + " is within region " + std::to_string(other) +
                       ", which is not on its layer";
        }
    }
    return "";
}

void refuse_high(const std::vector<Region>& regions, const std::string& what) {
    const auto high = std::ranges::find_if(regions, [](const Region& r) { return r.layers > 1; });
    if (high == regions.end()) return;
    throw Error(Exit::bad_input, "cannot " + what + " of layers with several heights: those of tool " +
                                     number(high->tool) + " are " + number(high->layers) +
                                     " layers high; leave out height= of --body");
}

std::string fault(const Loops& loops) {
    if (is_simple(loops)) return "";
    double around = 0;
    for (std::size_t l = 0; l < loops.size(); ++l) around += perimeter(loops[l]);
    // The largest change of the area by rounding, to the grid and in the union.
    const double tolerance = 2 * around / kGridPerMm;
    const double given = signed_area(loops), united = signed_area(unite(loops));
    if (given < -tolerance) return "it runs clockwise";
    if (std::abs(united - given) > tolerance) return "its loops cross or do not run as outline and holes";
    return "";
}

} // namespace filum::polygon
