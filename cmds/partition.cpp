// partition - divide a surface into patches in which fibres can go one way
// reads:  Surface
// writes: Surface
// memory: the surfaces, and some hundred bytes per vertex
#include "app/partition/partition.hpp"
#include "cli/command.hpp"

namespace {

using namespace filum;
using cli::Option;

std::vector<cli::Option> options(app::partition::Options& o) {
    using cli::Option;
    return {
        Option{"by", &o.how.pull.by, "", "source of the directions; auto: stress if there is one, else shape"}
            .one_of({"auto", "stress", "shape"})
            .when("!as-is")
            .a_limit(),
        Option{"case", &o.cases, "NAME,...", "the load cases that count; none: all"}.when("!by=shape !field !as-is"),
        Option{"field", &o.how.pull.field, "NAME", "a field of vectors whose directions count instead of stresses"}
            .when("!by=shape !as-is"),
        Option{"angle", &o.how.limits.angle_deg, "DEG", "largest angle between directions and the mean of their patch"}
            .above(0)
            .at_most(90)
            .when("!as-is !by=shape")
            .a_limit(),
        Option{"bend", &o.how.limits.bend_deg, "DEG", "largest angle between normals and the mean of their patch"}
            .above(0)
            .at_most(180)
            .when("!as-is")
            .a_limit(),
        Option{"crease", &o.how.seams.crease_deg, "DEG", "edges that bend more are borders"}
            .above(0)
            .at_most(180)
            .when("!as-is")
            .a_limit(),
        Option{"seam", &o.seam, "FILE", "lines of points that are borders: a text, as geodesic's --source-lines"}
            .not_a_setting(),
        Option{"faces", &o.how.seams.faces, "", "edges between CAD faces are borders"}.when("!as-is"),
        Option{"patches", &o.how.limits.patches, "N", "number of patches, at any angles; 0: by the angles"}
            .at_least(0)
            .at_most(10000)
            .when("!as-is")
            .a_limit(),
        Option{"min-area", &o.how.limits.least_area, "MM2", "smallest area of a patch; 0: a hundredth of the surface"}
            .within(0, 1e12)
            .when("!as-is")
            .a_limit(),
        Option{"mask", &o.how.mask, "SHARE", "leaves out parts with less than this share of the greatest load"}
            .within(0, 1)
            .when("!as-is !by=shape")
            .a_limit(),
        Option{"detail", &o.how.detail, "MM", "smaller details are smoothed; 0: a 50th of the root of the area"}
            .zero_or_at_least(0.001)
            .at_most(1e6)
            .when("!as-is")
            .a_limit(),
        Option{"as-is", &o.as_is, "", "does not divide; surfaces without a name are patches, too"}.a_limit(),
        {"names", &o.names, "NAME,...", "names of the unnamed patches, in order; none: letters"},
        {"only", &o.only, "NAME,...", "write only these patches"}};
}

cli::Spec spec(app::partition::Options& o) {
    return {
        .name = "partition",
        .synopsis = "divide a surface into patches in which fibres can go one way",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::surface),
        .out = cli::writes(stream::Payload::surface),
        .memory = "the surfaces, and some hundred bytes per vertex",
        .options = options(o),
        .groups = {{"directions", {"by", "case", "field"}},
                   {"where patches end",
                    {"angle", "bend", "crease", "seam", "faces", "patches", "min-area", "mask", "detail"}},
                   {"patches", {"as-is", "names", "only"}}},
        .examples = {{"geodesic part.stl | partition > part.patches", "the faces of a part"},
                     {"geodesic part.stl | partition | partition --only B > face.surface", "one of them"}},
        .see_also = {"stressfield", "surfpath", "geodesic", "render"},
        .arguments = "[INPUT...]",
        .many_inputs = true,
    };
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::partition::Options>(argc, argv, spec, app::partition::run); }
