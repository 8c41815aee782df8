// metrics - measures a finished toolpath, or the curves of a fill
// reads:  Toolpath or Paths
// writes: text
// memory: the toolpath at 10 times the bytes that it reads, and the outlines; with --surface the model and its windows
#include "app/metrics/metrics.hpp"
#include "figures/meanings.hpp"

namespace {

using namespace filum;

std::vector<cli::Option> options(app::metrics::Options& all) {
    using cli::Option;
    metrics::planar::Options& o = all.plane;
    metrics::surface::Options& c = all.curved;
    std::vector<Option> planar{
        Option{"regions", &o.regions, "FILE", "Regions stream that the path should fill"}.not_a_setting().when(
            "!surface"),
        Option{"format", &o.format, "", "how to write the figures"}.one_of({"table", "tsv", "json"}),
        Option{"per-region", &o.per_region, "FILE", "writes a line per region, as TSV"}.not_a_setting().when(
            "!surface"),
        Option{"per-layer", &o.per_layer, "FILE", "writes a line per layer, as TSV"}.not_a_setting().when("!surface"),
        Option{"pores", &o.pores, "", "measures the pores of a scaffold, too"}.when("!surface regions"),
        Option{"per-pore", &o.per_pore, "FILE", "writes a line per pore with its place, as TSV"}.not_a_setting().when(
            "pores"),
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
        Option{"set", &o.set, "KEY=VALUE,...", "changes keys of the profile, such as feeds.bead=40"}.when("!surface"),
        Option{"density", &o.density, "G/CM3",
               "density of the material if the profile has none; that of fibre comes from the profile only"}
            .above(0)
            .at_most(100)
            .when("!surface")};
    const std::vector<Option> curved{
        Option{"surface", &all.surface, "FILE", "the Surface stream that the path lies on"}.not_a_setting(),
        Option{"voids", &all.voids, "FILE", "writes the surface with its distances from the path"}.not_a_setting().when(
            "surface"),
        Option{"map", &all.map, "FILE",
               "writes the surface with thickness, gaps and angles at every point; a large map has fewer; x.vtp: all, "
               "for ParaView"}
            .not_a_setting()
            .when("surface"),
        Option{"spacing", &c.spacing, "MM", "between strands on a surface, d; 0: the median bead width"}
            .within(0, 1e4)
            .when("surface")
            .same_as({"surfpath.spacing", "surfpath-kipping2022.spacing"}),
        Option{"step", &c.step, "MM", "between samples on a surface; 0: d / 4"}
            .zero_or_at_least(0.001)
            .at_most(1000)
            .when("surface"),
        Option{"max-curvature", &c.max_curvature, "1/MM", "largest curvature that the fibre allows"}
            .above(0)
            .at_most(1e6)
            .when("surface"),
        Option{"min-radius", &c.min_radius, "MM", "path that turns tighter is tight; 0: 1 / --max-curvature"}
            .within(0, 1e5)
            .when("surface")};
    planar.insert(planar.end(), curved.begin(), curved.end());
    return planar;
}

cli::Spec spec(app::metrics::Options& all) {
    return {
        .name = "metrics",
        .synopsis = "measure a finished toolpath, or the curves of a fill",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::unknown),
        .out = cli::text("a table, TSV or JSON"),
        .memory = "the toolpath at 10 times the bytes that it reads, and the outlines; with --surface the model and "
                  "its windows",
        .options = options(all),
        .groups = {{"planar toolpaths",
                    {"regions", "per-region", "per-layer", "pores", "per-pore", "pixel", "turn-samples"}},
                   {"time and mass", {"machine", "set", "density"}},
                   {"paths on a surface",
                    {"surface", "voids", "map", "spacing", "step", "max-curvature", "min-radius"}}},
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
        .pages = {{"keys", figures::meanings_page}}};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::metrics::Options>(argc, argv, spec, app::metrics::run); }
