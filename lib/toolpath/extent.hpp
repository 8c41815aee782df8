// The size of a part as it is printed.
#pragma once

#include "toolpath/path.hpp"

namespace filum::toolpath {

// The box around the beads of a part, as wide and high as they are laid.  Supports, skirts, towers and connectors are
// not of the part, and joins add nothing to it.
struct Extent {
    Vec3 low{kNone, kNone, kNone}, high{-kNone, -kNone, -kNone}; // mm
    void add(const Span& span);
    [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
    // mm along x, y and z; 0 if it is empty.
    [[nodiscard]] Vec3 size() const { return empty() ? Vec3{} : high - low; }

  private:
    static constexpr double kNone = 1e300;
};

} // namespace filum::toolpath
