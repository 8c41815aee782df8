// The size of a printed part.
#pragma once

#include "toolpath/path.hpp"

namespace filum::toolpath {

// The bounding box of the beads of a part with their widths and heights. Supports, skirts, towers and connectors do
// not belong to the part, and joins do not enlarge it.
struct Extent {
    Vec3 low{kNone, kNone, kNone}, high{-kNone, -kNone, -kNone}; // mm
    void add(const Span& span);
    [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
    // mm along x, y and z; 0 if the box is empty.
    [[nodiscard]] Vec3 size() const { return empty() ? Vec3{} : high - low; }

  private:
    static constexpr double kNone = 1e300;
};

} // namespace filum::toolpath
