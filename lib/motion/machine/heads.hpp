// The heads of a machine's tools, and how they hang beside each other.
#pragma once

#include "geom/vec.hpp"
#include "machine/head.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace filum::machine {

struct Profile;

// A common head, and others for some tools.  Tools on the same carriage move together: while one of them prints, the
// tips of the others follow beside it.
struct Heads {
    Head common;
    std::map<std::uint32_t, Head> own;
    // The tools on the carriage: mm from tool 0's tip to theirs, all in the same state.  Empty: idle tools are away.
    std::map<std::uint32_t, geom::Vec3> mount;
    double raised = 0; // mm that the tips of idle tools on the carriage are raised

    Heads() = default;
    Heads(const Head& head) : common(head) {} // NOLINT: a head is the head of all tools
    [[nodiscard]] const Head& of(std::uint32_t tool) const {
        const auto found = own.find(tool);
        return found == own.end() ? common : found->second;
    }

    // A tool that hangs beside the one in use.
    struct Idle {
        std::uint32_t tool = 0;
        geom::Vec3 shift; // mm, from the tip in use to its tip
    };
    // The idle tools on the carriage while `tool` is in use, ascending.
    [[nodiscard]] std::vector<Idle> beside(std::uint32_t tool) const;
};

// The heads of a profile's tools.
Heads heads(const Profile& profile);

// The heads of a choice: of all tools of a named profile, each with the sizes of the choice.  Throws as load_profile
// does.
Heads heads(const HeadChoice& choice);

} // namespace filum::machine
