// What follows from the values of a profile.
#include "base/error.hpp"
#include "base/number.hpp"
#include "machine/profile.hpp"

#include <numbers>

namespace filum::machine {

void allow_outside(const Profile& p, double depth, const std::string& where) {
    const double most = p.limits.turn_outside;
    if (depth <= most) return;
    throw Error(Exit::usage, "cannot use " + where + " " + shortest_text(depth) + " on '" + p.name +
                                 "': the profile allows " + (most > 0 ? shortest_text(most) + " mm" : "no turns") +
                                 " outside the part (limits.turn_outside); ask for less, or change the profile if "
                                 "there is room");
}

const std::string& change_codes(const Profile& profile, std::uint32_t tool) {
    const Profile& own = of_tool(profile, tool);
    return own.change.empty() ? profile.tools.change : own.change;
}

double Extrusion::per_mm3() const {
    const double area = std::numbers::pi * diameter * diameter / 4;
    return flow * (feeding == Feeding::filament || feeding == Feeding::plunger ? 1 / area : 1);
}

} // namespace filum::machine
