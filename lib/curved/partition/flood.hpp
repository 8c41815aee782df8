// Connected pieces of triangles.
#pragma once

#include "surface/surface.hpp"

#include <vector>

namespace filum::partition {

// Per triangle the number of its piece, in the order of first triangles. A piece continues across side h where
// joined(h); it is not called for sides of rims.
template <class Joined>
std::vector<std::uint32_t> flood(const surface::Surface& s, Joined joined) {
    std::vector<std::uint32_t> out(s.triangles.size(), surface::kNone), pending;
    std::uint32_t count = 0;
    for (std::uint32_t first = 0; first < out.size(); ++first) {
        if (out[first] != surface::kNone) continue;
        out[first] = count;
        pending.assign(1, first);
        while (!pending.empty()) {
            const std::uint32_t t = pending.back();
            pending.pop_back();
            for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
                if (s.twin[h] == surface::kNone || !joined(h)) continue;
                const std::uint32_t over = s.twin[h] / 3;
                if (out[over] == surface::kNone) {
                    out[over] = count;
                    pending.push_back(over);
                }
            }
        }
        ++count;
    }
    return out;
}

} // namespace filum::partition
