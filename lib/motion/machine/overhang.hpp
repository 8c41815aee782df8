// The speed and the fan of walls that are partly over air: [overhang] of a profile.
#pragma once

#include "machine/reader.hpp"

#include <string_view>
#include <vector>

namespace filum::machine {

struct Overhang {
    struct Step {
        double share = 0; // of the bead's width over air, 0 to 1
        double value = 0; // of a speed mm/s, or a share of the wall's own speed; of a fan its speed as in [cooling]
        bool relative = false;
    };
    std::vector<Step> steps; // of speeds, with growing shares; empty: overhang does not change the speed
    std::vector<Step> fans;  // the same of the fan

    // The feed of a wall whose own feed is `own`, mm/s, with `share` of its width over air: linear between two steps,
    // `own` below the first one, and that of the last step above it.
    [[nodiscard]] double feed(double own, double share) const;
    // The least speed of the fan for such a wall; -1: any.
    [[nodiscard]] double fan(double share) const;
};

// The steps that a text like "0:100% 0.25:40 1:15" lists: share:feed, with a feed in mm/s or in percent of the wall's
// own. Throws Error(usage) for any other text, and unless shares are from 0 to 1 and grow, and feeds are above 0.
std::vector<Overhang::Step> overhang_feeds(std::string_view text);
// The same of fans: share:speed, with speeds from 0.
std::vector<Overhang::Step> overhang_fans(std::string_view text);

void read_overhang(Document& doc, Overhang& overhang); // `feeds` and `fans`, texts as above

} // namespace filum::machine
