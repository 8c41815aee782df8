// partition - divide a surface into patches in which fibres can go one way
// reads:  Surface
// writes: Surface
// memory: the surfaces, and some hundred bytes per vertex
#include "app/partition/partition.hpp"
#include "cli/command.hpp"

namespace {

using namespace filum;
using cli::Option;

constexpr const char* kDescription =
    "Divides surfaces into patches whose directions and normals stay near their mean. It writes a surface for each, "
    "the greatest first, named A, B, C and so on, with all fields. Triangles are split where smooth borders cross "
    "them. A surface with a name is a patch already and passes unchanged, so patches of several origins can be "
    "combined. With --as-is surfaces without a name pass, too.\n\n"
    "Directions are those of the greatest principal stress in the tangent plane, from `stressfield`, or of --field. "
    "At each place the load case that pulls most counts. Directions have no arrow. They count less where there is "
    "little load. Where there is none, or where it points out of the surface, they are continued from around. "
    "Without stresses, or with --by shape, only normals count.\n\n"
    "Neighbouring places merge while a patch's directions keep to --angle and its normals to --bend, except for a "
    "twentieth of the patch, or until --patches are left. Then borders move to where they are short, patches are "
    "even, and few strong directions are cut. Some borders always exist: edges that bend more than --crease, edges "
    "between CAD faces with --faces, and lines drawn onto the surface by --seam. --seam is a text of points with "
    "three numbers a line; an empty line separates two lines of points. A line that ends within a patch stays a "
    "slit.\n\n"
    "Patches below --min-area are joined to a neighbour. Patches without a neighbour are left out, and so are parts "
    "with less load than --mask. Notes give place and area of both. For each patch, facts give its area, the mean "
    "cosine between directions and their mean (coherence), and the angle and bend that 95 % of it stay below.";

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
        .description = kDescription,
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
