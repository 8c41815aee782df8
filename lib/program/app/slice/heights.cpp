#include "app/slice/heights.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"
#include "slice/compensate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace filum::app::slice {

namespace {

using filum::slice::kLift;
using filum::slice::Level;
using polygon::Loops;

constexpr double kSameHeight = 1e-6; // of a layer; typed heights differ from multiples by rounding only

// Layers `first` to `last` of the job, which a tool prints as one.
struct Cell {
    std::size_t first = 0, last = 0;
    std::uint32_t skipped = 0;
};

// The layers of the job that a body meets, from `first` to before `end`.
struct Extent {
    std::size_t first = 0, end = 0;
};

Extent extent(const BedPart& body, std::span<const Level> levels, std::size_t bottom, std::size_t end) {
    Extent out{0, std::min(body.sweep.levels.size(), end)};
    if (body.sweep.levels.size() > 1)
        while (out.first < out.end && levels[out.first].plane + kLift <= body.box.lo.z) ++out.first;
    out.first = std::max(out.first, bottom);
    return out;
}

// The layers of a tool, anew from each layer in `begins`. The first layer of the job is one of its own if it has a
// height of its own.
std::vector<Cell> cells(Extent of, std::uint32_t layers, const std::set<std::size_t>& begins, bool first_alone) {
    std::vector<Cell> out;
    for (std::size_t from = of.first; from < of.end; from = out.back().last + 1) {
        const std::size_t count = from == 0 && first_alone ? 1 : layers;
        const auto next = begins.upper_bound(from);
        const std::size_t last = std::min({from + count, of.end, next == begins.end() ? of.end : *next}) - 1;
        out.push_back({from, last, static_cast<std::uint32_t>(last - of.first - out.size())});
    }
    return out;
}

bool share_height(const Cell& a, const Cell& b) { return a.first <= b.last && b.first <= a.last; }

// Sections of a body at the middles of layers, with all copies.
class Sections {
  public:
    Sections(const BedPart& body, const Options& o, std::vector<Level> levels, int threads)
        : body_(body), options_(o), sweep_(filum::slice::sweep_over(*body.part, o.slice, std::move(levels), threads)) {
        cut_.resize(sweep_.levels.size());
        parallel::for_chunks(sweep_.chunks(), 1, threads, [&](std::size_t chunk, std::size_t) {
            for (polygon::Layer& layer : filum::slice::cut(sweep_, chunk).layers)
                cut_[layer.index] = std::move(layer.contours);
        });
    }
    // `middle`: a layer of the job within layer k.
    [[nodiscard]] Loops at(std::size_t k, std::size_t middle, bool on_bed) const {
        Loops own = cut_[k];
        if (options_.compensation.any()) {
            Notes known; // the layers of the job report the same
            own = filum::slice::compensated(own, middle < body_.bores.size() ? body_.bores[middle] : Loops{},
                                            options_.compensation, on_bed ? 0 : 1, known);
        }
        Loops out;
        add_copies(own, body_.at, out);
        return out;
    }

  private:
    const BedPart& body_;
    const Options& options_;
    filum::slice::Sweep sweep_;
    std::vector<Loops> cut_;
};

} // namespace

std::uint32_t layers_of_height(const std::string& item, double height, const filum::slice::Options& o) {
    const auto refuse = [&](const std::string& why) {
        throw Error(Exit::usage, "cannot use '" + item + "' as --body: " + why);
    };
    if (o.adaptive) refuse("a tool has no height of its own with --adaptive; leave out one of both");
    const double times = height / o.layer_height;
    const double whole = std::round(times);
    if (whole >= 1 && whole <= polygon::kMostLayers && std::abs(times - whole) < kSameHeight)
        return static_cast<std::uint32_t>(whole);
    const auto possible = [&](double n) {
        return fixed_text(std::clamp<double>(n, 1, polygon::kMostLayers) * o.layer_height, 4);
    };
    std::string next = possible(std::floor(times));
    if (const std::string above = possible(std::ceil(times)); above != next) next += " or " + above;
    refuse("layers of " + fixed_text(height, 4) + " mm are not 1 to " + std::to_string(polygon::kMostLayers) +
           " layers of " + fixed_text(o.layer_height, 4) + " mm; the next possible height is " + next +
           " mm; or change --layer-height");
    return 1;
}

namespace {

// The sections of a body, and those of later bodies that have the material where they overlap.
struct Cuts {
    Sections own;
    std::vector<Sections> later;

    Cuts(const std::vector<BedPart>& bodies, std::size_t b, const Options& o, const std::vector<Level>& levels,
         int threads)
        : own(bodies[b], o, levels, threads) {
        for (std::size_t c = b + 1; c < bodies.size(); ++c)
            if (bodies[c].tool != bodies[b].tool) later.emplace_back(bodies[c], o, levels, threads);
    }
    // The area of the body without `taken` and that of later bodies.
    [[nodiscard]] Loops at(std::size_t k, std::size_t middle, bool on_bed, Loops taken) const {
        for (const Sections& s : later) taken.add(s.at(k, middle, on_bed));
        Loops out = own.at(k, middle, on_bed);
        return taken.empty() ? out : polygon::subtract(out, polygon::unite(taken));
    }
};

// The layers at which a body has a floor or a roof that is wider than a bead: there one of its layers must begin.
std::vector<std::size_t> floors(const Cuts& cuts, Extent of, double bead, int threads) {
    std::vector<Loops> areas(of.end - of.first);
    parallel::for_chunks(areas.size(), 1, threads,
                         [&](std::size_t k, std::size_t) { areas[k] = cuts.at(k, of.first + k, false, {}); });
    std::vector<char> found(areas.size(), 0);
    parallel::for_chunks(areas.size(), 1, threads, [&](std::size_t k, std::size_t) {
        if (k == 0) return;
        for (const auto& [a, b] : {std::pair(k - 1, k), std::pair(k, k - 1)})
            if (!polygon::opened_difference(areas[a], areas[b], bead / 2).empty()) found[k] = 1;
    });
    std::vector<std::size_t> out;
    for (std::size_t k = 0; k < found.size(); ++k)
        if (found[k] != 0) out.push_back(of.first + k);
    return out;
}

// The cells of a tool that a body meets, cut off where it begins and ends.
std::vector<Cell> within(const std::vector<Cell>& all, Extent of) {
    std::vector<Cell> out;
    for (const Cell& cell : all) {
        if (cell.last < of.first || cell.first >= of.end) continue;
        const std::size_t last = std::min(cell.last, of.end - 1);
        out.push_back(
            {std::max(cell.first, of.first), last, cell.skipped - static_cast<std::uint32_t>(cell.last - last)});
    }
    return out;
}

// All of these layers as one: its top, height and middle.
Level joined(std::span<const Level> levels, const Cell& cell) {
    const double low = levels[cell.first].z - levels[cell.first].height, top = levels[cell.last].z;
    return {top, top - low, (low + top) / 2};
}

// What bodies with high layers of one tool have in common.
struct ToolLayers {
    Extent extent;
    std::set<std::size_t> begins;
};

} // namespace

HighLayers::HighLayers(const std::vector<BedPart>& bodies, std::span<const Level> levels, std::size_t bottom,
                       std::size_t end, const Options& o, int threads) {
    std::map<std::uint32_t, ToolLayers> tools;
    std::vector<Extent> extents;
    std::vector<std::size_t> order; // of the bodies with high layers: the highest first, then the later ones
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Extent own = extent(bodies[b], levels, bottom, end);
        extents.push_back(own);
        if (bodies[b].layers < 2 || own.first >= own.end) continue;
        order.push_back(b);
        const auto [at, fresh] = tools.try_emplace(bodies[b].tool, ToolLayers{own, {}});
        Extent& all = at->second.extent;
        all = {std::min(all.first, own.first), std::max(all.end, own.end)};
        const std::vector<Level> cut(levels.begin() + static_cast<std::ptrdiff_t>(own.first),
                                     levels.begin() + static_cast<std::ptrdiff_t>(own.end));
        const double bead = std::max(bodies[b].width, bodies[b].layers * o.slice.layer_height);
        for (const std::size_t k : floors(Cuts(bodies, b, o, cut, threads), own, bead, threads))
            at->second.begins.insert(k);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(bodies[a].layers, a) > std::pair(bodies[b].layers, b);
    });
    at_.assign(bodies.size(), std::vector<std::int64_t>(levels.size(), -1));
    const bool first_alone = o.slice.first_layer_height > 0 && o.slice.first_layer_height != o.slice.layer_height;
    for (const std::size_t b : order) {
        const ToolLayers& tool = tools.at(bodies[b].tool);
        const auto own = within(cells(tool.extent, bodies[b].layers, tool.begins, first_alone), extents[b]);
        std::vector<Level> middles;
        middles.reserve(own.size());
        for (const Cell& cell : own) middles.push_back(joined(levels, cell));
        const Cuts cuts(bodies, b, o, middles, threads);
        for (std::size_t k = 0; k < own.size(); ++k) {
            const Cell& cell = own[k];
            Loops taken; // by higher layers, and by layers of the same tool that begin or end elsewhere
            for (const HighLayer& before : layers_) {
                const bool same = before.first == cell.first && before.last == cell.last &&
                                  bodies[before.body].tool == bodies[b].tool;
                if (!same && share_height(cell, {before.first, before.last, 0})) taken.add(before.area);
            }
            const bool on_bed = cell.first == bottom && o.from_layer == 0;
            for (std::size_t i = cell.first; i <= cell.last; ++i) at_[b][i] = static_cast<std::int64_t>(layers_.size());
            layers_.push_back({b, cell.first, cell.last, middles[k].height, middles[k].plane, cell.skipped,
                               cuts.at(k, (cell.first + cell.last) / 2, on_bed, std::move(taken))});
        }
    }
}

const HighLayer* HighLayers::of(std::size_t body, std::size_t i) const {
    if (at_.empty() || at_[body][i] < 0) return nullptr;
    return &layers_[static_cast<std::size_t>(at_[body][i])];
}

void HighLayers::share(std::size_t i, const std::vector<BedPart>& bodies, std::vector<Loops>& contours) const {
    if (!any()) return;
    Loops taken;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (const HighLayer* high = of(b, i)) taken.add(high->area);
    taken = polygon::unite(taken);
    for (std::size_t c = 0; c < bodies.size(); ++c)
        if (bodies[c].layers < 2 && !contours[c].empty() && !taken.empty())
            contours[c] = polygon::subtract(contours[c], taken);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].layers < 2) continue;
        Loops rest = taken.empty() ? std::move(contours[b]) : polygon::subtract(contours[b], taken);
        contours[b] = {};
        const HighLayer* high = of(b, i);
        for (std::size_t c = 0; high != nullptr && c < bodies.size(); ++c) {
            if (rest.empty() || bodies[c].layers > 1 || contours[c].empty()) continue;
            const Loops filled = polygon::intersect(rest, polygon::offset(contours[c], high->height));
            if (filled.empty()) continue;
            rest = polygon::subtract(rest, filled);
            contours[c] = polygon::unite(contours[c], filled);
        }
    }
}

} // namespace filum::app::slice
