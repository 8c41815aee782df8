// slice - cut a mesh into layers of closed contours
// reads:  mesh files: STL, OBJ, PLY, OFF, 3MF, AMF or STEP
// writes: Layers
// memory: the model at 400 bytes a triangle, 32 layers a thread at twice what it writes; all to compensate holes
#include "app/slice/slice.hpp"
#include "app/slice/grid.hpp"
#include "cli/step_options.hpp"

namespace {

using namespace filum;
using cli::Option;

std::vector<Option> placing(mesh::Placement& p) {
    return {
        Option{"unit", &p.unit, "", "unit of the file; auto guesses from the size, 3MF and STEP state their own"}
            .one_of({"mm", "cm", "m", "in", "um", "auto"}),
        Option{"scale", &p.scale, "S|X,Y,Z", "factor on the size, one or one per axis; negative ones mirror"}.within(
            -1e6, 1e6),
        Option{"rotate", &p.rotate_deg, "X,Y,Z", "degrees to turn about the x axis, then y, then z"}.numbers(3).within(
            -360, 360),
        Option{"translate", &p.translate, "X,Y,Z", "distance to move by, mm"}.numbers(3).within(-1e7, 1e7),
        Option{"center", &p.center, "X,Y", "place of the middle of the part's box, mm"}.numbers(2).within(-1e7, 1e7),
        Option{"on-bed", &p.on_bed, "", "moves the part's lowest point to z = 0; on unless --no-on-bed is given"}
            .when("!no-on-bed")
            .a_limit(),
        Option{"no-on-bed", &p.keep_z, "", "leaves the part at its own height"}.a_limit(),
    };
}

std::vector<Option> cutting(slice::Options& s) {
    return {
        Option{"layer-height", &s.layer_height, "MM", "thickness of a layer"}.within(0.001, 1000),
        Option{"first-layer-height", &s.first_layer_height, "MM", "thickness of the first layer; 0: as the others"}
            .zero_or_at_least(0.001)
            .at_most(1000),
        {"adaptive", &s.adaptive, "", "chooses the thickness of every layer by the slope of the surface"},
        Option{"min-layer-height", &s.min_layer_height, "MM", "least thickness of adaptive layers"}
            .within(0.001, 1000)
            .when("adaptive")
            .a_limit(),
        Option{"max-layer-height", &s.max_layer_height, "MM", "greatest thickness of adaptive layers"}
            .within(0.001, 1000)
            .when("adaptive")
            .a_limit(),
        Option{"cusp", &s.cusp, "MM", "largest distance of the steps of adaptive layers from the surface"}
            .within(1e-5, 100)
            .when("adaptive")
            .a_limit(),
        Option{"close-gaps", &s.close_gaps, "MM", "width up to which gaps in contours are closed"}
            .within(0, 100)
            .a_limit(),
        Option{"close-openings", &s.close_openings, "SHARE",
               "closes wider openings straight, up to this part of the contour's length; 0: never, and no holes either"}
            .within(0, 1)
            .a_limit(),
        Option{"hairline", &s.hairline, "MM", "heals gaps and slivers between bodies narrower than this"}
            .within(0, 1)
            .a_limit(),
    };
}

std::vector<Option> compensating(app::slice::Options& o) {
    return {
        Option{"first-layer-width", &o.first_layer_width, "MM",
               "width of all beads of the first layer; 0: as those of other layers"}
            .zero_or_at_least(0.01)
            .at_most(100),
        Option{"elephant-foot", &o.compensation.elephant_foot, "MM",
               "distance that the first layer's outline moves inwards; no place loses more than half of its width"}
            .within(0, 10),
        Option{"xy-compensation", &o.compensation.xy, "MM",
               "distance that all outlines move outwards, so that holes close; negative: inwards"}
            .within(-10, 10),
        Option{
            "hole-compensation", &o.compensation.holes, "MM",
            "additional distance that holes widen in radius, and bores where windows open them; negative: they close"}
            .within(-10, 10),
        Option{"shrinkage", &o.shrinkage, "%|X,Y,Z",
               "shrinkage of the part as it cools, 0.5 if 100 mm become 99.5; the part is enlarged to compensate; one "
               "number, or one per axis"}
            .within(-50, 50),
    };
}

std::vector<Option> leaving_out(app::slice::Options& o) {
    return {
        Option{"cut-below", &o.cut_below, "MM",
               "leaves out everything below this height, to the nearest layer; the rest comes down to the bed"}
            .numbers(1)
            .within(0, 1e7)
            .a_limit(),
        Option{"cut-above", &o.cut_above, "MM", "leaves out everything above this height, to the nearest layer"}
            .numbers(1)
            .within(0, 1e7)
            .a_limit(),
        Option{"from-layer", &o.from_layer, "N",
               "leaves out the layers before this one, counted from 0; the others keep their height, to continue a "
               "print that stopped; make sure that the start codes do not touch it"}
            .within(0, 1e6),
    };
}

cli::Spec spec(app::slice::Options& o) {
    auto options = cutting(o.slice);
    for (Option& option : compensating(o)) options.push_back(std::move(option));
    for (Option& option : leaving_out(o)) options.push_back(std::move(option));
    for (Option& option : placing(o.place)) options.push_back(std::move(option));
    for (Option& option : cli::step_options(o.step)) options.push_back(std::move(option));
    for (Option& option : app::slice::plate_options(o)) options.push_back(std::move(option));
    return {
        .name = "slice",
        .synopsis = "cut a mesh into layers of closed contours",
        .description = cli::kDescription,
        .in = cli::file("mesh file"),
        .out = cli::writes(stream::Payload::layers),
        .memory =
            "the model at 400 bytes per triangle, 32 layers per thread at twice the bytes that it writes, and all "
            "contours with --hole-compensation",
        .options = std::move(options),
        .groups = {{"heights of layers", {"adaptive", "min-layer-height", "max-layer-height", "cusp"}},
                   {"mending", {"close-gaps", "close-openings", "hairline"}},
                   {"sizes",
                    {"first-layer-width", "elephant-foot", "xy-compensation", "hole-compensation", "shrinkage"}},
                   {"a part of the print", {"cut-below", "cut-above", "from-layer"}},
                   {"the file, and where the part stands",
                    {"unit", "deflection", "deflection-angle", "scale", "rotate", "translate", "center", "on-bed",
                     "no-on-bed"}},
                   {"several bodies", {"body"}},
                   {"several parts", {"plate", "copies", "wells", "grid", "pitch", "in-wells", "apart"}}},
        .examples = {{"slice part.stl > part.layers", "the layers of a part, 0.2 mm each"},
                     {"slice --layer-height 0.3 --rotate 0,0,45 --center 110,110 part.stl > part.layers",
                      "thicker layers of a part that is turned and put on the middle of the bed"},
                     {"slice part.stl --copies 4 --machine klipper > part.layers",
                      "four of it on the bed of a machine"},
                     {"slice --body part.stl --body part.stl:tool=1 > part.layers", "two bodies, printed by two tools"},
                     {"slice --adaptive --max-layer-height 0.3 < part.stl > part.layers",
                      "thin layers on gentle slopes, thick ones on steep walls; from standard input"}},
        .see_also = {"regions", "peek"},
        .arguments = "[INPUT...]",
        .many_inputs = true};
}

} // namespace

int main(int argc, char** argv) { return cli::main<app::slice::Options>(argc, argv, spec, app::slice::run); }
