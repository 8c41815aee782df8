// metrics - measures a finished toolpath, or the curves of a fill
// reads:  Toolpath or Paths
// writes: text
// memory: the toolpath at 20 bytes per segment, and the outlines; with --surface the model and its windows
#include "app/metrics/metrics.hpp"
#include "metrics/figures/meanings.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Counts and measures a toolpath from its moves alone: strokes, stops, breaks and joins, lengths, print time and "
    "material, crossings, bead widths and directions, sharp turns, and the distance between the starts of "
    "neighbouring layers. With --regions it also measures coverage, area outside, overlaps, and the worst layer and "
    "region. It uses no claim of a stage. The facts and notes of earlier stages are listed at the end. "
    "docs/metrics.md lists the keys of JSON and TSV. The output of fill can be measured, too: each curve counts as "
    "printed by itself.\n\n"
    "A stop is a move of more than 0.05 mm in XY without extruding. A stroke ends at a stop, or where the nozzle "
    "rises by more than two layers without extruding. A bead is a straight stretch with round ends, as wide as its "
    "moves say; it belongs to the layer that it rises to. Shares refer to the outlines' area. Coverage is the area "
    "under beads. Outside is the area of beads outside the outlines, including connectors. Overfill is the sum of "
    "length times cross-section, divided by the layer's height, less the area under beads. In the air is the part "
    "that no bead of the layer below carries: a bead carries up to half a bead beside it, and the lowest layer lies "
    "on the bed. Crossings are pairs of moves of one layer that properly cross and do not follow each other. A move "
    "over another that shares at most a tenth of the layer with it does not cross it.\n\n"
    "Sharp turns follow the authors of the Connected Fermat Spirals: the path cuts a disc with the radius of one "
    "bead width in two, and the turn is sharp if the smaller part is below 0.3 of the disc. Areas are swept by rows "
    "with exact ends: their spacing shows in about the fourth digit. The print time assumes trapezoidal speeds with "
    "look-ahead. A job of several tools, or with the fibre of --machine, is also reported tool by tool.\n\n"
    "--pores is for scaffolds. It measures porosity by extruded volume, by covered area, and as 1 - width / spacing "
    "of an endless lattice; strands and their spacing; pore size, the largest circle in each window of a layer and "
    "those that cross it; and throats, the largest balls that fall straight through, or roll between two strands.\n\n"
    "--surface names a Surface stream that the path lies on; figures of layers are left out then. It measures the "
    "four criteria of Kipping et al. 2022 as printed, marked 'paper', and corrected ones beside them. These are cuts "
    "and lengths of fibre; geodesic and normal curvature, against the limit of the fibre; coverage within half a "
    "bead's width of the path along the surface, from exact distances; overlap, the largest void, and the gaps "
    "between neighbours; and how well the path follows the stress of every load case in the stream. "
    "docs/surface-metrics.md defines each figure. --voids writes the surface with the distance from the path, for "
    "render; farther than half a bead is not covered.\n\n"
    "--map writes the surface with the beads at every point, and reports ply by ply: thickness, uncovered area with "
    "its distance from a bead, overlaps, and how far beads leave their direction. This is the angle of `laminate`, "
    "else the surface's field 'direction', else the pull of its first load case.";

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
            {Option{"regions", &o.regions, "FILE", "Regions stream that the path should fill"}.not_a_setting().when(
                 "!surface"),
             Option{"format", &o.format, "", "how to write the figures"}.one_of({"table", "tsv", "json"}),
             Option{"per-region", &o.per_region, "FILE", "writes a line per region, as TSV"}.not_a_setting().when(
                 "!surface"),
             Option{"per-layer", &o.per_layer, "FILE", "writes a line per layer, as TSV"}.not_a_setting().when(
                 "!surface"),
             Option{"pores", &o.pores, "", "measures the pores of a scaffold, too"}.when("!surface regions"),
             Option{"pixel", &o.pixel, "MM", "spacing of the rows; 0: a sixteenth of the bead width"}
                 .zero_or_at_least(0.001)
                 .at_most(1000)
                 .when("!surface regions"),
             Option{"turn-samples", &o.turn_samples, "N", "places tested for sharp turns"}
                 .within(1, 1e8)
                 .when("!surface")
                 .a_limit(),
             Option{"machine", &o.machine, "NAME|FILE", "machine profile for the print time"}.not_a_setting().when(
                 "!surface"),
             Option{"set", &o.set, "KEY=VALUE,...", "changes keys of the profile, such as feeds.bead=40"}.when(
                 "!surface"),
             Option{"density", &o.density, "G/CM3",
                    "density of the material if the profile has none; that of fibre comes from the profile only"}
                 .above(0)
                 .at_most(100)
                 .when("!surface"),
             Option{"surface", &all.surface, "FILE", "the Surface stream that the path lies on"}.not_a_setting(),
             Option{"voids", &all.voids, "FILE", "writes the surface with its distances from the path"}
                 .not_a_setting()
                 .when("surface"),
             Option{"map", &all.map, "FILE",
                    "writes the surface with thickness, gaps and angles at every point; x.vtp: for ParaView"}
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
             Option{"max-curvature", &c.max_curvature, "1/MM", "largest curvature that the fibre allows"}
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
