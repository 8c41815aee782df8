#include "machine/heads.hpp"

#include "machine/profile.hpp"

namespace filum::machine {

std::vector<Heads::Idle> Heads::beside(std::uint32_t tool) const {
    std::vector<Idle> out;
    const auto own_mount = mount.find(tool);
    if (own_mount == mount.end()) return out;
    for (const auto& [other, place] : mount) {
        if (other == tool || of(other).none) continue;
        geom::Vec3 shift = place - own_mount->second;
        shift.z += raised;
        out.push_back({other, shift});
    }
    return out;
}

Heads heads(const Profile& profile) {
    Heads out = profile.head;
    out.raised = profile.tools.raised;
    for (const auto& [tool, own] : profile.own) {
        out.own.emplace(tool, own->head);
        if (own->mounted) out.mount[tool] = own->mount;
    }
    if (!out.mount.empty()) out.mount.try_emplace(0); // tool 0 is where the others are measured from
    return out;
}

Heads heads(const HeadChoice& choice) {
    if (choice.name == "none" || choice.name == "ordinary") return head(choice);
    Heads out = heads(load_profile(choice.name));
    out.common = altered(out.common, choice);
    for (auto& [tool, own] : out.own) own = altered(own, choice);
    return out;
}

} // namespace filum::machine
