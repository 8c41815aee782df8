#include "app/supports/supports.hpp"

#include "app/modifier/modifier.hpp"
#include "base/error.hpp"
#include "cli/output.hpp"
#include "geom/angle.hpp"
#include "polygon/stack.hpp"
#include "regions/air.hpp"
#include "wire/planar.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace filum::app::supports {

namespace {

// Most layers without regions.  Supports can stand in them, so they take memory.  20,000 thin layers are a metre high.
constexpr std::uint32_t kMostEmptyLayers = 20000;

// Renumbers the layers of the regions so that the numbers can be indices.  Returns the original number of each layer.
std::vector<std::uint32_t> usable_as_indices(std::vector<polygon::Region>& regions,
                                             const filum::supports::Options& options) {
    if (const std::string fault = polygon::fault(regions); !fault.empty())
        throw Error(Exit::bad_input, "cannot support these regions: " + fault);
    if (options.carries() || options.raft > 0) polygon::refuse_high(regions, "support a part");
    if (!options.carries()) return polygon::close_gaps(regions, static_cast<std::uint32_t>(options.gap + 1));
    std::uint32_t before = 0;
    for (const polygon::Region& r : regions) {
        if (r.layer > before && r.layer - before > kMostEmptyLayers)
            throw Error(Exit::bad_input, "cannot carry region " + std::to_string(r.id) + " on layer " +
                                             std::to_string(r.layer) + ": more than " +
                                             std::to_string(kMostEmptyLayers) +
                                             " layers below it are empty; number the layers one after the other");
        before = r.layer;
    }
    return polygon::close_gaps(regions, kMostEmptyLayers);
}

// The original numbers of all layers, raised by the layers of a raft and its gap; the new layers come first.
std::vector<std::uint32_t> raised(const std::vector<std::uint32_t>& original, const filum::supports::Options& options) {
    const auto by = options.raft > 0 ? static_cast<std::uint32_t>(options.raft + options.gap) : 0;
    std::vector<std::uint32_t> out(by);
    std::iota(out.begin(), out.end(), 0U);
    for (const std::uint32_t n : original) out.push_back(n + by);
    return out;
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    filum::supports::Options options = o.how;
    options.angle = geom::radians(o.angle_deg);
    options.taper = geom::radians(o.taper_deg);
    options.on_part = o.on == "everywhere";
    std::vector<polygon::Region> given;
    auto whole = cli::read_all(io.input, stream::Payload::regions,
                               [&](stream::RawFrame frame) { given.push_back(wire::region(frame)); });
    const auto original = usable_as_indices(given, options);
    Facts facts;
    Notes notes, found;
    cli::Io self = io;
    const auto read = [&](const std::string& option, const std::string& file, std::vector<polygon::Loops>& to) {
        if (file.empty()) return;
        auto [body, painted] =
            modifier::support_places(file, option == "support-in", whole.header, given, io.threads, notes);
        to = std::move(body.outlines);
        if (modifier::is_part(body.crc32c, whole.header))
            std::erase_if(whole.notes, [](const Note& n) { return n.code == NoteCode::project_support_body; });
        if (painted > 0) facts.push_back({"", option + "-painted", painted, "mm2"});
        self.settings.push_back({option, "FILE", true}); // files have no names in the history
        self.settings.push_back({option + "_crc32c", body.crc32c});
    };
    read("support-in", o.wanted, options.wanted);
    read("no-support-in", o.unwanted, options.unwanted);
    polygon::restore_layers(notes, original);
    auto all = filum::supports::supports(std::move(given), options, facts, found);
    const auto numbers = raised(original, options);
    for (polygon::Region& r : all) r.layer = numbers[r.layer];
    polygon::restore_layers(found, numbers);
    notes.insert(notes.end(), found.begin(), found.end());
    // Notes on overhangs without supports are dropped, since this stage writes its own on those that remain.
    if (options.carries()) std::erase_if(whole.notes, [](const Note& n) { return regions::of_air(n.code); });
    whole.header.expected = all.size();
    cli::Output output(io, cli::header(self, stream::Payload::regions, {&whole.header}));
    output.pass_on(whole);
    output.add(notes);
    output.add(facts);
    for (const auto& r : all) output.write(wire::frame(r));
    output.close();
}

} // namespace filum::app::supports
