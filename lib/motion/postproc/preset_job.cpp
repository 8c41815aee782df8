#include "postproc/preset_job.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace filum::postproc {

namespace {

preset::Job job_of(const machine::Profile& profile, const FirstPass& s, Vec2 shift) {
    preset::Job out;
    out.tools.clear();
    for (const auto& [tool, totals] : s.tools) {
        if (!(totals.path_len > 0)) continue;
        out.tools.push_back(tool);
        const auto& e = machine::of_tool(profile, tool).extrusion;
        out.volume[tool] = totals.volume * e.flow;
    }
    if (out.tools.empty()) out.tools.push_back(0);
    out.first_tool = s.first_tool;
    out.layers = s.layers;
    for (const Vec2& p : s.first_layer.hull()) out.first_layer.push_back(p + shift);
    out.height = s.part_high[2];
    out.objects = static_cast<std::uint32_t>(std::max<std::size_t>(1, s.parts.size()));
    return out;
}

} // namespace

std::unique_ptr<preset::Program> preset_program(const machine::Profile& profile, const FirstPass& first_pass,
                                                Vec2 shift) {
    if (profile.preset == nullptr) return nullptr;
    auto out = std::make_unique<preset::Program>(*profile.preset, job_of(profile, first_pass, shift));
    const bool orca = out->of_orca();
    const std::pair<const char*, const char*> temperatures[] = {
        {"nozzle_temp", orca ? "nozzle_temperature" : "temperature"},
        {"first_nozzle_temp", orca ? "nozzle_temperature_initial_layer" : "first_layer_temperature"},
        {"bed_temp", orca ? "bed_temperature_single" : "bed_temperature"},
        {"first_bed_temp", orca ? "bed_temperature_initial_layer_single" : "first_layer_bed_temperature"}};
    for (const auto& [ours, theirs] : temperatures)
        if (const auto found = profile.values.find(ours); found != profile.values.end())
            out->set(theirs, found->second);
    return out;
}

void check_outline(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift) {
    const std::vector<Vec2>& bed = profile.bed.outline;
    constexpr double slack = 0.01; // mm
    for (std::size_t i = 0; i < bed.size(); ++i) {
        const Vec2 a = bed[i], side = bed[(i + 1) % bed.size()] - a;
        const double length = geom::norm(side);
        if (!(length > 0)) continue;
        for (const Vec2& corner : first_pass.footprint.hull()) {
            const Vec2 p = corner + shift;
            if (geom::cross(side, p - a) >= -slack * length) continue;
            throw Error(Exit::failure, "cannot print at x " + fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) +
                                           ": it is off the bed of '" + profile.name +
                                           "'; move, turn or scale the part");
        }
    }
}

} // namespace filum::postproc
