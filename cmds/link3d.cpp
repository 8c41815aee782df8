// link3d - curves to one toolpath
// reads:  Paths
// writes: Toolpath
// memory: the regions it looks ahead; all of them with --connect inside or outside, or --links sun2019
#include "base/error.hpp"
#include "base/number.hpp"
#include "baselines/sun2019/link.hpp"
#include "cli/command.hpp"
#include "cli/head_options.hpp"
#include "link3d/linker.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Cuts every closed curve open where it is entered, and joins curves, regions and layers to strokes: stretches that"
    " a machine prints without stopping.\n\n"
    "Regions are printed in the order in which they arrive. Where `sequence` says that a region continues the one "
    "below it, the nozzle rises on the spot and reaches the nearest place of the next curve by a short jog, at half a "
    "bead's width, which crosses no bead. If the next curve is out of reach, a lane is laid before, from the end of "
    "the curve along the middle of the strip between two of its beads, to where the next region is in reach; both "
    "beads beside it are thinned so that the amount of material stays the same. Entries drift towards where the part "
    "goes, within reach, as far as the regions are known, so that lanes stay rare.\n\n"
    "Several curves of a region are printed nearest first, and joined by a jog if that is within reach and crosses no "
    "bead. What cannot be joined is a break: the nozzle travels, level, or over what the head would meet.\n\n"
    "With --interlace, the starts of neighbouring layers are at least three bead widths apart: a lane of a few widths "
    "leads from the end of each layer to beneath the start of the next, at two places in turn, spread by the golden "
    "section, or at random; with --seam inside only to where beads on both sides hide them. A start that cannot move "
    "is reported. Open curves begin at their two ends in turn by themselves.\n\n"
    "With --lift ramp, a layer begins by rising along its curve, at most 1 in 20 and over five beads or more, as thick"
    " as the gap below, and its end lies over that ramp with what is missing there: no blob, and the next layer begins"
    " further on by itself. With --lift helical, z rises all along each layer of a column whose one curve lies on the "
    "one below, and the last turn is flat; others get ramps.\n\n"
    "A region in another place is reached by a break, or, with --connect outside, by a connector around everything "
    "printed, to be trimmed later: thin at both ends, where it is to break off, and on the same way in all layers, so "
    "that they stack to a fin. With --connect inside, a region of the same layer is reached by a thin strand straight "
    "over. Either must cross nothing, and the head must meet nothing; else there is a break, which is reported.\n\n"
    "--links sun2019 links as in the 2019 paper, to compare: closed curves begin on the main axis of their points, "
    "layers and parts are linked straight or around the box of all, unchecked.";

struct Options {
    link3d::Options link;
    std::string seam = "nearest";
    enum class Links : std::uint8_t { free, sun2019 } links = Links::free;
    baselines::sun2019::LinkOptions sun2019;
    machine::HeadChoice head;
};

// How curves are joined clear of all beads.
std::vector<cli::Option> free_options(Options& o) {
    using cli::Option;
    return {
        Option{"reach", &o.link.reach, "WIDTHS",
               "the longest jog, in bead widths; a climb takes at most one; 0 joins only what touches"}
            .within(0, 10)
            .a_limit(),
        Option{"look-ahead", &o.link.look_ahead, "REGIONS", "how many regions are read before one is printed"}
            .within(1, 1000)
            .a_limit(),
        Option{"connect", &o.link.connect, "", "how to reach a region that lies aside"}
            .one_of({"break", "inside", "outside"})
            .a_limit(),
        Option{"strand", &o.link.strand, "", "what carries connectors outside: nothing need, or the bed or one below"}
            .one_of({"free", "carried"})
            .when("connect=outside")
            .a_limit(),
        Option{
            "seam", &o.seam, "nearest|inside|back|X,Y",
            "where a stroke begins: nearest to where the one before ended, in the middle of its column, at the back, "
            "or nearest to a place, mm"},
        Option{"lift", &o.link.lift, "", "how the nozzle gets to the next layer: straight up, by a ramp, or all along"}
            .one_of({"plain", "ramp", "helical"}),
        Option{"interlace", &o.link.interlace, "", "how the starts of neighbouring layers are set apart"}.one_of(
            {"none", "alternate", "golden", "random"}),
        Option{"seed", &o.link.seed, "N", "of random starts"}.within(0, 1e15).when("interlace=random"),
        Option{"alternate-direction", &o.link.alternate_direction, "",
               "every second layer runs the other way (the default; =false for none)"}};
}

std::vector<cli::Option> options(Options& o) {
    using cli::Option;
    auto out = cli::when("links=free", cli::with(free_options(o), cli::head_options(o.head)));
    out.push_back(Option{"links", &o.links, "", "how to link: clear of all beads, or as in the 2019 paper"}.one_of(
        {"free", "sun2019"}));
    out.push_back(
        Option{"start-shift", &o.sun2019.start_shift, "MM", "way of starts from layer to layer"}.within(0, 1e6).when(
            "links=sun2019"));
    return out;
}

cli::Spec spec(Options& o) {
    return {
        .name = "link3d",
        .synopsis = "curves to one toolpath",
        .description = kDescription,
        .in = cli::reads(stream::Payload::paths),
        .out = cli::writes(stream::Payload::toolpath),
        .memory = "the regions it looks ahead; all of them with --connect inside or outside, or --links sun2019",
        .options = options(o),
        .groups = {{"regions that lie aside", {"reach", "look-ahead", "connect", "strand"}},
                   {"starts", {"seam", "interlace", "seed", "alternate-direction"}},
                   cli::head_group(),
                   {"links of the 2019 paper", {"start-shift"}}},
        .examples = {{"slice part.stl | regions | sequence | fill | link3d > part.toolpath", "the toolpath of a part"},
                     {"slice part.stl | regions | sequence | fill | link3d --connect outside > part.toolpath",
                      "around the part instead of stops"}},
        .see_also = {"sequence", "fill", "postproc", "metrics"}};
}

void set_seam(const std::string& text, link3d::Options& to) {
    using link3d::Seam;
    const std::pair<const char*, Seam> names[] = {
        {"nearest", Seam::nearest}, {"inside", Seam::inside}, {"back", Seam::back}};
    for (const auto& [name, seam] : names) {
        if (text != name) continue;
        to.seam = seam;
        return;
    }
    const auto comma = text.find(',');
    if (comma == std::string::npos)
        throw Error(Exit::usage, "cannot use '" + text +
                                     "' for --seam: it must be one of nearest, inside, back, or a "
                                     "place, as 100,50");
    to.seam = Seam::place;
    to.seam_at = {parse_number(text.substr(0, comma), "--seam"), parse_number(text.substr(comma + 1), "--seam")};
}

template <class Linker>
void link(Linker linker, const cli::Io& io) {
    const auto to = [](const auto& emit) { return [&emit](const toolpath::Span& span) { emit(wire::frame(span)); }; };
    cli::scan_stage(
        io, stream::Payload::paths, stream::Payload::toolpath,
        [&](const stream::RawFrame& frame, const auto& emit, Notes& notes) {
            linker.add(wire::paths(frame), to(emit), notes);
        },
        [&](const auto& emit, Notes& notes) {
            linker.finish(to(emit), notes);
            for (auto& fact : link3d::facts(linker.counts())) {
                fact.stage = io.program;
                emit({stream::Tag::fact, stream::serialise(fact)});
            }
        });
}

void run(const Options& o, const cli::Io& given) {
    if (o.links == Options::Links::sun2019) return link(baselines::sun2019::Linker(o.sun2019), given);
    cli::Io io = given;
    link3d::Options how = o.link;
    how.head = machine::head(o.head);
    set_seam(o.seam, how);
    for (const auto& [name, value, changed] : machine::settings(how.head))
        io.settings.push_back({name, value, changed});
    link(link3d::Linker(how), io);
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
