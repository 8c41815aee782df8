// skins - what of each region must be solid, and what is filled in part
// reads:  Regions
// writes: Regions
// memory: the whole part
#include "skins/skins.hpp"
#include "base/number.hpp"
#include "cli/output.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

struct Options {
    skins::Options how;
    std::string infill = "15%";
};

cli::Spec spec(Options& all) {
    using cli::Option;
    skins::Options& o = all.how;
    return {
        .name = "skins",
        .synopsis = "what of each region must be solid, and what is filled in part",
        .description =
            "Marks the inside of each region that may be filled in part. Solid stays what is seen from above or below, "
            "--top and --bottom layers deep, and --walls rings along the outline.",
        .in = cli::reads(stream::Payload::regions),
        .out = cli::writes(stream::Payload::regions),
        .memory = "the whole part",
        .options = {Option{"infill", &all.infill, "PERCENT",
                           "share of the volume inside that is laid: 15%, or 0.15; 100%: all is solid"},
                    Option{"bridge", &o.bridge, "MM",
                           "widest gap between lines under a skin; there they lie nearer to each other if need be"}
                        .within(0, 1e6)
                        .a_limit(),
                    Option{"walls", &o.walls, "N", "rings along the outline"}.within(1, 1000),
                    Option{"top", &o.top, "LAYERS", "solid layers under what is seen from above"}.within(0, 1e6),
                    Option{"bottom", &o.bottom, "LAYERS", "solid layers over what is seen from below"}.within(0, 1e6),
                    Option{"bead-width", &o.bead_width, "MM", "width of a bead"}.within(0.01, 100).same_as(
                        {"regions.bead-width"})},
        .examples = {{"slice part.stl | regions | skins > part.regions", "two walls, four skins, 15 % inside"},
                     {"slice part.stl | regions | skins --infill 30% --walls 3 | sequence | fill > part.paths",
                      "stronger"}},
        .see_also = {"regions", "sequence", "fill"}};
}

void run(const Options& o, const cli::Io& io) {
    skins::Options options = o.how;
    options.infill = skins::share(o.infill);
    std::vector<polygon::Region> regions;
    auto whole = cli::read_all(io.input, stream::Payload::regions,
                               [&](stream::RawFrame frame) { regions.push_back(wire::region(frame)); });
    Facts facts;
    skins::skins(regions, options, facts);
    whole.header.expected = regions.size();
    cli::Output output(io, cli::header(io, stream::Payload::regions, {&whole.header}));
    output.pass_on(whole);
    output.add(facts);
    for (const auto& r : regions) output.write(wire::frame(r));
    output.close();
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
