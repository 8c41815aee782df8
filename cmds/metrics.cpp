// metrics - measures a finished toolpath, or the curves of a fill
// reads:  Toolpath or Paths
// writes: text
// memory: the toolpath at 20 bytes per segment, and the outlines; with --surface the model and its windows
#include "app/metrics/metrics.hpp"
#include "metrics/figures/meanings.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Counts and measures what a toolpath is, from its moves alone: strokes, stops, breaks and joins, lengths, print "
    "time and material, crossings, bead widths and directions, sharp turns, how far apart neighbouring layers begin. "
    "With --regions also what it fills: coverage, what lies outside, what is laid where there is material already, the "
    "worst layer and region. No stage's own claim is used, but what the stages before said they dropped or repaired is "
    "listed at the end. docs/metrics.md has the keys of JSON and TSV. The output of fill can be measured, too: each "
    "curve counts as printed by itself.\n\n"
    "A stop is a way of more than 0.05 mm in XY without extruding; a stroke ends at a stop, or where the nozzle rises "
    "by more than two layers without extruding. A bead is a straight stretch with round ends, as wide as its moves "
    "say; "
    "it belongs to the layer that it rises to. Shares are of the outlines' area: coverage is what lies under beads, "
    "outside are beads over no outline (connectors, too), overfill is the sum of length times cross-section by the "
    "layer's height less the area under beads. In the air is what no bead of the layer below carries: a bead "
    "carries what is at most half a bead aside of it, and the lowest layer lies on the bed. Crossings are pairs of "
    "moves of one layer that properly cross and do not follow each other; one that lies over another, and shares "
    "no more than a tenth of the layer with it, does not cross it.\n\n"
    "Sharp turns follow the authors of the Connected Fermat Spirals: the path cuts a disc of one bead width's radius "
    "in two, and the turn is sharp where the smaller part is below 0.3 of the disc. Areas are swept by rows with exact "
    "ends: their spacing shows in the fourth digit or so. The print time is by trapezoidal speeds with look-ahead; a "
    "job of several tools, or with fibre by the profile of --machine, is told tool by tool, too.\n\n"
    "--pores is for scaffolds: porosity by extruded volume, by covered area, and 1 - width / spacing of an endless "
    "lattice; strands and their spacing; pore size, the largest circle in each window of a layer and the ones that "
    "cross it; and throats, the largest balls that fall straight through, or roll between two strands.\n\n"
    "--surface names a Surface stream that the path lies on; what tells of layers is left out then. It measures the "
    "four criteria of Kipping et al. 2022 as printed, marked 'paper', and beside them honest ones: cuts and lengths of "
    "fibre; geodesic and normal curvature, against what the fibre can be bent to; coverage within half a bead's width "
    "of the path along the surface, swept by rows whose ends are solved from exact distances, overlap, the largest "
    "void, and the gaps between neighbours; and how well the path follows the stress of every load case in the "
    "stream. docs/surface-metrics.md defines each figure. --voids writes the surface with the distance from the path, "
    "for render: what is farther than half a bead is not covered. --map writes the surface with what lies at every "
    "point, and tells it ply by ply: thickness, what is bare and how far that is from a bead, what is laid twice, and "
    "how far beads run off what the ply is to follow: the angles of `laminate`, else the surface's field 'direction', "
    "else the pull of its first load case.";

cli::Spec spec(app::metrics::Options& all) {
    using cli::Option;
    metrics::planar::Options& o = all.plane;
    metrics::surface::Options& c = all.curved;
    return {
        .name = "metrics",
        .synopsis = "measure a finished toolpath, or the curves of a fill",
        .description = kDescription,
        .in = cli::reads(stream::Payload::unknown),
        .out = cli::text("a table, TSV or JSON"),
        .memory = "the toolpath at 20 bytes per segment, and the outlines; with --surface the model and its windows",
        .options =
            {Option{"regions", &o.regions, "FILE", "the Regions stream that should be filled"}.not_a_setting().when(
                 "!surface"),
             Option{"format", &o.format, "", "how to write the figures"}.one_of({"table", "tsv", "json"}),
             Option{"per-region", &o.per_region, "FILE", "also a line per region, as TSV"}.not_a_setting().when(
                 "!surface"),
             Option{"per-layer", &o.per_layer, "FILE", "also a line per layer, as TSV"}.not_a_setting().when(
                 "!surface"),
             Option{"pores", &o.pores, "", "measure the pores of a scaffold, too"}.when("!surface regions"),
             Option{"pixel", &o.pixel, "MM", "spacing of the rows; 0: a sixteenth of the bead width"}
                 .zero_or_at_least(0.001)
                 .at_most(1000)
                 .when("!surface regions"),
             Option{"turn-samples", &o.turn_samples, "N", "places tested for sharp turns"}
                 .within(1, 1e8)
                 .when("!surface")
                 .a_limit(),
             Option{"machine", &o.machine, "NAME|FILE", "machine profile of the print time"}.not_a_setting().when(
                 "!surface"),
             Option{"set", &o.set, "KEY=VALUE,...", "change keys of the profile, as feeds.bead=40"}.when("!surface"),
             Option{"density", &o.density, "G/CM3",
                    "density of the material where the profile says none; of fibre, only the profile does"}
                 .above(0)
                 .at_most(100)
                 .when("!surface"),
             Option{"surface", &all.surface, "FILE", "the Surface stream that the path lies on"}.not_a_setting(),
             Option{"voids", &all.voids, "FILE", "also the surface with its distances from the path"}
                 .not_a_setting()
                 .when("surface"),
             Option{"map", &all.map, "FILE",
                    "also the surface with thickness, gaps and angles at every point; x.vtp: for ParaView"}
                 .not_a_setting()
                 .when("surface"),
             Option{"spacing", &c.spacing, "MM", "between strands on a surface, d; 0: the median bead width"}
                 .within(0, 1e4)
                 .when("surface")
                 .same_as({"surfpath.spacing"}),
             Option{"step", &c.step, "MM", "between samples on a surface; 0: d / 4"}
                 .zero_or_at_least(0.001)
                 .at_most(1000)
                 .when("surface"),
             Option{"max-curvature", &c.max_curvature, "1/MM", "what the fibre can be bent to"}
                 .above(0)
                 .at_most(1e6)
                 .when("surface")},
        .groups = {{"planar toolpaths", {"regions", "per-region", "per-layer", "pores", "pixel", "turn-samples"}},
                   {"time and mass", {"machine", "set", "density"}},
                   {"paths on a surface", {"surface", "voids", "map", "spacing", "step", "max-curvature"}}},
        .examples =
            {{"slice part.stl | regions > part.regions; sequence part.regions | fill | link3d | metrics --regions "
              "part.regions",
              "all figures of a part"},
             {"slice part.stl | regions > part.regions; sequence part.regions | fill | metrics --regions part.regions "
              "--per-region part.tsv --format json",
              "how well the fill fills, region by region"},
             {"geodesic part.stl --cut 0,0,1,0.5 --source plane:1,0,0,4.5 > part.surface; surfpath fina part.surface > "
              "part.toolpath; metrics --surface part.surface part.toolpath",
              "how well a path covers a curved surface, and how sharply it bends"}},
        .see_also = {"fill", "link3d", "surfpath", "stressfield", "render"},
        .pages = {{"keys", metrics::figures::meanings_page}}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::metrics::Options>(argc, argv, spec, app::metrics::run); }
