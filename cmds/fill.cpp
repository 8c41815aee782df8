// fill - bead lines that fill each region
// reads:  Regions
// writes: Paths
// memory: one region per thread at 40 times the bytes that it writes, and outlines filled before, up to 64 MB
#include "base/density.hpp"
#include "cli/command.hpp"
#include "fill/hollow/hollow.hpp"
#include "fill/reuse.hpp"
#include "fill/scaffold/gradient.hpp"
#include "fill/volume.hpp"
#include "polygon/clip.hpp"
#include "wire/planar.hpp"

#include <atomic>
#include <map>

namespace {

using namespace filum;

constexpr const char* kThin = "walls of a spiral thinner than a bead. lanes: two lanes, there and back; half-height: "
                              "there at half the layer's height and back on top, where lanes would be below "
                              "--min-width; single: one pass, where the curve may have two ends";

constexpr const char* kMinRadius =
    "rings of the spiral turn no tighter; notes report the area that this leaves open, and tighter turns";

constexpr const char* kVolume =
    "how much material a region gets. beads: what its beads hold, as wide as they are apart; exact: "
    "its area times its height; all its beads change by the same factor, up to 5 %; not where walls and infill have "
    "areas of their own";

struct Options {
    fill::Options how;
    bool overhang_shares = false;
    fill::Volume volume = fill::Volume::beads;
    std::string porosity, pore_size; // %, mm, as scaffold::Gradient; "": as --spacing says
};

std::vector<cli::Group> groups() {
    return {{"the spiral", {"min-width", "thin", "min-radius"}},
            {"rows and rings", {"angles", "rings"}},
            {"scaffold", {"spacing", "pore-size", "porosity", "stagger"}}};
}

std::vector<cli::Option> options(Options& all) {
    using cli::Option;
    fill::Options& o = all.how;
    return {
        Option{"pattern", &o.pattern, "", "how to fill"}.one_of(fill::kPatternNames),
        Option{"bead-width", &o.bead_width, "MM", "width of a bead"}.within(0.01, 100).same_as({"regions.bead-width"}),
        Option{"volume", &all.volume, "", kVolume}.one_of(fill::kVolumeNames).when("!pattern=scaffold"),
        Option{"overhang-shares", &all.overhang_shares, "",
               "measure how much of each wall of `skins` lies over air, in steps of 5 %, for the machine's "
               "overhang.feeds"},
        Option{"min-width", &o.min_width, "MM",
               "a note reports narrower beads of a spiral; 0: a quarter of --bead-width"}
            .within(0, 100)
            .when("pattern=spiral")
            .a_limit(),
        Option{"thin", &o.thin, "", kThin}.one_of(fill::kThinNames).when("pattern=spiral").a_limit(),
        Option{"min-radius", &o.min_radius, "MM", kMinRadius}.within(0, 1000).when("pattern=spiral"),
        Option{"angles", &o.angles_deg, "DEG,...",
               "angles of straight rows from the x axis, repeated layer by layer; none: 0, or 0,90 for a scaffold"}
            .within(-360, 360)
            .when("!pattern=spiral|contour"),
        Option{"spacing", &o.spacing, "MM", "from strand to strand, centre to centre; 0: two and a half bead widths"}
            .within(0, 1e6)
            .when("pattern=scaffold"),
        Option{
            "pore-size", &all.pore_size, "MM[@Z,...]",
            "width of a scaffold's pores, bead to bead; replaces --spacing. 0.3@0,0.8@10: changes from z = 0 to 10; or "
            "a formula of x, y, z and r, as 0.3+0.02*r"}
            .when("pattern=scaffold !spacing"),
        Option{"porosity", &all.porosity, "PERCENT[@Z,...]",
               "empty share of a scaffold; replaces --spacing. 40@0,80@10: changes from z = 0 to 10; or a formula, as "
               "--pore-size takes"}
            .when("pattern=scaffold !spacing/pore-size"),
        Option{"stagger", &o.stagger, "SPACINGS", "how far the strands of every other round of angles are shifted"}
            .within(0, 1)
            .when("pattern=scaffold"),
        Option{"rings", &o.rings, "N",
               "rings along the outline before straight rows, or most rings of contour; -1: the usual number"}
            .within(-1, 1e6)
            .when("!pattern=spiral|zigzag")};
}

cli::Spec spec(Options& all) {
    return {.name = "fill",
            .synopsis = "bead lines that fill each region",
            .description = cli::kDescription,
            .in = cli::reads(stream::Payload::regions),
            .out = cli::writes(stream::Payload::paths),
            .memory = "one region per thread at 40 times the bytes that it writes, and outlines filled before (64 MB)",
            .options = options(all),
            .groups = groups(),
            .examples = {{"slice part.stl | regions | sequence | fill > part.paths", "the fill of a part"},
                         {"slice part.stl | regions | sequence | fill --pattern zigzag --angles 0,90 > part.paths",
                          "rows, turned by 90 degrees from layer to layer"},
                         {"slice part.stl | regions | sequence | fill --pattern scaffold --spacing 1 > part.paths",
                          "a porous scaffold: strands 1 mm apart, 0/90"}},
            .see_also = {"sequence", "link3d", "metrics"}};
}

polygon::Region region_of(const stream::RawFrame& frame, double bead_width) {
    polygon::Region region = wire::region(frame);
    const bool own = region.width > 0;
    if (!own) region.width = bead_width;
    check_density(polygon::signed_area(region.loops), region.width, own ? Exit::bad_input : Exit::usage,
                  "--bead-width");
    return region;
}

// The options for regions with beads of this width.
fill::Options with_width(const Options& o, double width) {
    fill::Options out = o.how;
    out.bead_width = width;
    return out;
}

// Fills regions that have walls and areas of their own.
fill::Reuse hollow_fill(const fill::hollow::Options& how) {
    return fill::Reuse([how](const auto& region, Notes& notes) { return fill::hollow::fill(region, how, notes); },
                       [](std::uint32_t) { return 0.0; });
}

void run(const Options& o, const cli::Io& io) {
    const double usual = o.how.bead_width;
    if (o.how.pattern == fill::Pattern::scaffold) {
        const fill::scaffold::Pores pores(o.pore_size, o.porosity);
        const auto options_at = [&](double width, double z) {
            return fill::with_pores(with_width(o, width), pores, z);
        };
        fill::strand_spacing(options_at(usual, 0));
        std::map<std::uint32_t, fill::ScaffoldState> before; // by tool
        std::optional<polygon::Region> last;                 // waits for the region after it
        const auto fill_last = [&](const auto& emit, Notes& notes, const polygon::Region* after) {
            if (last)
                emit(wire::frame(
                    fill::fill_scaffold(*last, options_at(last->width, last->z), before[last->tool], notes, after)));
        };
        const auto work = [&](const stream::RawFrame& frame, const auto& emit, Notes& notes) {
            polygon::Region region = region_of(frame, usual);
            fill_last(emit, notes, &region);
            last = std::move(region);
        };
        return cli::scan_stage(io, stream::Payload::regions, stream::Payload::paths, work,
                               [&](const auto& emit, Notes& notes) { fill_last(emit, notes, nullptr); });
    }
    fill::ReuseByWidth solid([&](double width) { return fill::Reuse(with_width(o, width)); });
    fill::ReuseByWidth hollow([&](double width) { return hollow_fill({width, o.overhang_shares}); });
    std::atomic<bool> any_hollow = false;
    cli::map_stage(io, stream::Payload::regions, stream::Payload::paths, [&](stream::RawFrame frame, Notes& notes) {
        polygon::Region region = region_of(frame, usual);
        if (region.walls > 0) {
            any_hollow = true;
            region.loops = polygon::without_flat_starts(region.loops);
        }
        toolpath::RegionPaths paths = (region.walls > 0 ? hollow : solid).of(region.width)(region, notes);
        if (o.volume == fill::Volume::exact && region.walls == 0) fill::make_exact(paths, notes);
        return std::vector{wire::frame(paths)};
    });
    for (const char* name : {"pattern", "min-width", "thin", "min-radius", "angles", "rings"})
        if (any_hollow) io.idle(name, "regions with walls and areas of their own are filled by lanes and as these say");
    if (!any_hollow) io.idle("overhang-shares", "no region has walls of its own; skins makes them");
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
