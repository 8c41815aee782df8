#include "machine/head.hpp"

#include "base/number.hpp"
#include "geom/angle.hpp"
#include "machine/profile.hpp"

namespace filum::machine {

Head head(const HeadChoice& o) {
    Head h;
    if (o.name == "none")
        h.none = true;
    else if (o.name != "ordinary")
        h = load_profile(o.name).head;
    return altered(h, o);
}

Head altered(const Head& from, const HeadChoice& o) {
    Head h = from;
    if (!o.flat_radius.empty()) h.flat_radius = o.flat_radius[0];
    if (!o.cone_angle_deg.empty()) h.cone_angle = geom::radians(o.cone_angle_deg[0]);
    if (!o.cone_height.empty()) h.cone_height = o.cone_height[0];
    if (!o.carriage.empty()) {
        h.carriage_x = o.carriage[0];
        h.carriage_y = o.carriage[1];
    }
    if (!o.gantry_height.empty()) h.gantry_height = o.gantry_height[0] > 0 ? o.gantry_height[0] : Head{}.gantry_height;
    return h;
}

Head widened(const Head& head, double distance) {
    Head out = head;
    const double half = head.cone_angle / 2;
    out.flat_radius += distance / std::cos(half) + distance * std::tan(half); // aside, and as if the cone sank
    out.carriage_x += 2 * distance;
    out.carriage_y += 2 * distance;
    out.cone_height = std::max(0.0, head.cone_height - distance);
    out.gantry_height = std::max(0.0, head.gantry_height - distance);
    return out;
}

namespace {

std::vector<HeadSetting> plain(const Head& h) {
    if (h.none) return {{"head", "none", true}};
    const double degrees = std::round(geom::degrees(h.cone_angle) * 1e9) / 1e9;
    return {{"flat-radius", shortest_text(h.flat_radius)},
            {"cone-angle", shortest_text(degrees)},
            {"cone-height", shortest_text(h.cone_height)},
            {"carriage", shortest_text(h.carriage_x) + "," + shortest_text(h.carriage_y)},
            {"gantry-height", std::isinf(h.gantry_height) ? "0" : shortest_text(h.gantry_height)}};
}

} // namespace

std::vector<HeadSetting> settings(const Head& head) {
    auto out = plain(head);
    const auto ordinary = plain({});
    for (std::size_t i = 0; i < out.size(); ++i) out[i].changed = head.none || out[i].value != ordinary[i].value;
    return out;
}

} // namespace filum::machine
