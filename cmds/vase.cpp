// vase - a floor and one outline per layer, for a wall in one helix
// reads:  Regions
// writes: Regions
// memory: the whole part
#include "vase/vase.hpp"

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "polygon/stack.hpp"
#include "regions/air.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

cli::Spec spec(vase::Options& o) {
    using cli::Option;
    return {
        .name = "vase",
        .synopsis = "a floor and one outline per layer, for a wall in one helix",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::regions),
        .out = cli::writes(stream::Payload::regions),
        .memory = "the whole part",
        .options =
            {Option{"bottom", &o.bottom, "LAYERS", "solid layers of the floor; 0: no floor"}.within(0, 1e6).a_limit(),
             Option{"walls", &o.walls, "N", "beads side by side above the floor"}.within(1, 1000),
             Option{"bead-width", &o.bead_width, "MM", "width of a bead"}
                 .within(0.01, 100)
                 .same_as({"regions.bead-width"})
                 .a_limit()},
        .examples = {{"slice part.stl | regions | vase --bottom 2 | sequence | fill | link3d --lift helical > "
                      "part.toolpath",
                      "two layers of floor, then one bead all the way up"},
                     {"filum print part.stl --vase -o part.gcode", "the same to machine code"}},
        .see_also = {"regions", "skins", "fill", "link3d"}};
}

void run(const vase::Options& options, const cli::Io& io) {
    std::vector<polygon::Region> part;
    auto whole = cli::read_all(io.input, stream::Payload::regions,
                               [&](stream::RawFrame frame) { part.push_back(wire::region(frame)); });
    if (const std::string fault = polygon::fault(part); !fault.empty())
        throw Error(Exit::bad_input, "cannot use the regions: " + fault);
    polygon::refuse_high(part, "make a vase");
    Notes notes;
    Facts facts;
    const auto regions = vase::vase(part, options, notes, facts);
    whole.header.expected = regions.size();
    cli::Output output(io, cli::header(io, stream::Payload::regions, {&whole.header}));
    // The overhangs of the solid part say nothing of the wall alone.
    std::erase_if(whole.notes, [](const Note& n) { return regions::of_air(n.code); });
    output.pass_on(whole);
    output.add(notes);
    output.add(facts);
    for (const auto& r : regions) output.write(wire::frame(r));
    output.close();
}

} // namespace

int main(int argc, char** argv) { return cli::main<vase::Options>(argc, argv, spec, run); }
