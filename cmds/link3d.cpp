// link3d - curves to one toolpath
// reads:  Paths
// writes: Toolpath
// memory: the regions it looks ahead at 11 times the bytes that it reads; all of them with --connect inside or outside
#include "app/link3d/link.hpp"
#include "app/link3d/seam.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "cli/head_options.hpp"

namespace {

using namespace filum;

struct Options {
    link3d::Options link;
    std::string seam = "nearest", seam_in;
    machine::HeadChoice head;
};

std::vector<cli::Option> options(Options& o) {
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
        Option{"strand", &o.link.connector_support, "",
               "free: connectors may hang in the air; carried: they must rest on the bed or on a connector below"}
            .one_of({"free", "carried"})
            .when("connect=outside")
            .a_limit(),
        Option{
            "seam", &o.seam, "nearest|inside|back|X,Y",
            "where a stroke begins: nearest to where the one before ended, in the middle of its column, at the back, "
            "or nearest to a place, mm"},
        Option{
            "seam-in", &o.seam_in, "FILE",
            "strokes begin on the faces that this project of a slicer has painted for seams, and not on faces painted "
            "against them"}
            .not_a_setting()
            .a_limit(),
        Option{"lift", &o.link.lift, "",
               "how the nozzle reaches the next layer: straight up, on a ramp, or continuously (helix)"}
            .one_of({"plain", "ramp", "helical"}),
        Option{"interlace", &o.link.interlace, "", "how the starts of neighbouring layers are separated"}.one_of(
            {"none", "alternate", "golden"}),
        Option{"alternate-direction", &o.link.alternate_direction, "",
               "every second layer runs the other way (the default; =false for none)"}};
}

cli::Spec spec(Options& o) {
    return {
        .name = "link3d",
        .synopsis = "curves to one toolpath",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::paths),
        .out = cli::writes(stream::Payload::toolpath),
        .memory =
            "the regions it looks ahead at 11 times the bytes that it reads; all of them with --connect inside or "
            "outside",
        .options = cli::with(options(o), cli::head_options(o.head)),
        .groups = {{"regions that lie aside", {"reach", "look-ahead", "connect", "strand"}},
                   {"starts", {"seam", "seam-in", "interlace", "alternate-direction"}},
                   cli::head_group()},
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

void run(const Options& o, const cli::Io& given) {
    cli::Io io = given;
    link3d::Options how = o.link;
    how.head = machine::head(o.head);
    set_seam(o.seam, how);
    for (const auto& [name, value, changed] : machine::settings(how.head))
        io.settings.push_back({name, value, changed});
    const app::link3d::PaintedSeams painted(o.seam_in, how, io);
    app::link3d::link(link3d::Linker(how), io, painted.begin());
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
