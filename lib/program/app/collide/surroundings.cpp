#include "app/collide/surroundings.hpp"

#include "cli/head_options.hpp"

namespace filum::app::collide {

std::vector<cli::Option> options(Surroundings& to) {
    using cli::Option;
    const auto length = [](const char* name, double* at, const char* help) { return Option{name, at, "MM", help}; };
    return cli::with(
        {Option{"part", &to.part, "FILE,...", "meshes that are there from the start, such as a core or a mould"}
             .not_a_setting(),
         Option{"fixture", &to.fixture, "FILE,...", "meshes of the fixtures that hold the part"}.not_a_setting(),
         Option{"bed", &to.bed, "", "the plane z = 0 is an obstacle, too"}.a_limit(),
         Option{"machine", &to.machine, "NAME|FILE", "machine profile: its head, unless --head names another"}
             .not_a_setting(),
         Option{"set", &to.set, "KEY=VALUE,...", "changes keys of the profile, such as travel.lift=2"}.when("machine"),
         length("step", &to.check.step, "how far a point of the head moves between two checks")
             .within(0.001, 1000)
             .a_limit(),
         length("press", &to.check.press, "obstacles that rise less above the tip do not count")
             .within(0, 10)
             .a_limit(),
         length("margin", &to.check.margin, "distance that the head must keep").within(0, 1e4).a_limit(),
         Option{"strict", &to.strict, "", "a collision is an error (the default; =false for a note)"}.a_limit(),
         Option{"places", &to.places, "FILE", "list of collisions, as TSV"}.not_a_setting()},
        cli::head_options(to.head));
}

cli::Group group() {
    return {"what the head meets", {"part", "fixture", "bed", "step", "press", "margin", "strict", "places"}};
}

} // namespace filum::app::collide
