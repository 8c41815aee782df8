#include "postproc/approach.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

using kinematics::Joints;

constexpr double kTurnStep = 2 * geom::kDegree; // largest angle between two poses while the axes turn

} // namespace

Motion approached(const machine::Profile& profile, Motion stroke, std::size_t& added) {
    const auto& a = profile.axes;
    added = 0;
    if (!a.start || stroke.joints.empty()) return stroke;
    const Joints &from = *a.start, to = stroke.joints.front();
    const double high = std::max(from.xyz.z, to.xyz.z);
    Motion out;
    const auto add = [&](const Joints& j, Act act, double feed) {
        Leg leg = stroke.legs.front();
        leg.act = act;
        leg.feed = feed;
        leg.straight = false;
        out.joints.push_back(j);
        out.poses.push_back(kinematics::forward(a.chain, j));
        out.legs.push_back(leg);
    };
    // If the tilt is 0, a tip rises as Z does.
    const bool alone = a.numbers == machine::Numbers::joints || from.tilt == 0;
    add({{from.xyz.x, from.xyz.y, high}, from.tilt, from.turn}, alone ? Act::climb : Act::travel, profile.feeds.z);
    const double turned = std::max(std::abs(to.tilt - from.tilt), std::abs(to.turn - from.turn));
    const int parts =
        a.numbers == machine::Numbers::joints ? 1 : std::max(1, static_cast<int>(std::ceil(turned / kTurnStep)));
    for (int k = 1; k <= parts; ++k) {
        const double f = k / static_cast<double>(parts);
        const Vec3 at = from.xyz + f * (to.xyz - from.xyz);
        add({{at.x, at.y, high}, from.tilt + f * (to.tilt - from.tilt), from.turn + f * (to.turn - from.turn)},
            Act::travel, profile.feeds.travel);
    }
    added = out.poses.size();
    stroke.legs.front().straight = false;
    out.poses.insert(out.poses.end(), stroke.poses.begin(), stroke.poses.end());
    out.legs.insert(out.legs.end(), stroke.legs.begin(), stroke.legs.end());
    out.joints.insert(out.joints.end(), stroke.joints.begin(), stroke.joints.end());
    return out;
}

} // namespace filum::postproc
