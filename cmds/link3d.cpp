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
               "longest jog, in bead widths; a climb uses at most one; 0: only curves that touch are joined"}
            .within(0, 10)
            .a_limit(),
        Option{"look-ahead", &o.link.look_ahead, "REGIONS", "number of regions that are read before one is printed"}
            .within(1, 1000)
            .a_limit(),
        Option{"connect", &o.link.connect, "", "how to reach a region in another place"}
            .one_of({"break", "inside", "outside"})
            .a_limit(),
        Option{"strand", &o.link.strand, "",
               "free: connectors may hang in the air; carried: they must rest on the bed or on a connector below"}
            .one_of({"free", "carried"})
            .when("connect=outside")
            .a_limit(),
        Option{
            "seam", &o.seam, "nearest|inside|back|X,Y",
            "where a stroke begins: nearest to where the one before ended, in the middle of its column, at the back, "
            "or nearest to a place, mm"},
        Option{"lift", &o.link.lift, "",
               "how the nozzle reaches the next layer: straight up, on a ramp, or continuously (helix)"}
            .one_of({"plain", "ramp", "helical"}),
        Option{"interlace", &o.link.interlace, "", "how the starts of neighbouring layers are separated"}.one_of(
            {"none", "alternate", "golden", "random"}),
        Option{"seed", &o.link.seed, "N", "seed of random starts"}.within(0, 1e15).when("interlace=random"),
        Option{"alternate-direction", &o.link.alternate_direction, "",
               "every second layer runs the other way (the default; =false for none)"}};
}

std::vector<cli::Option> options(Options& o) {
    using cli::Option;
    auto out = cli::when("links=free", cli::with(free_options(o), cli::head_options(o.head)));
    out.push_back(Option{"links", &o.links, "", "method of links: clear of all beads, or as in the 2019 paper"}.one_of(
        {"free", "sun2019"}));
    out.push_back(Option{"start-shift", &o.sun2019.start_shift, "MM", "distance of starts from layer to layer"}
                      .within(0, 1e6)
                      .when("links=sun2019"));
    return out;
}

cli::Spec spec(Options& o) {
    return {
        .name = "link3d",
        .synopsis = "curves to one toolpath",
        .description = cli::kDescription,
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
