// Toolpaths and things in their way, for the commands about collisions.
#pragma once

#include "files.hpp"
#include "toolpath/path.hpp"
#include "wire/planar.hpp"

namespace filum::app::test {

// A box as a mesh file.
inline std::string box(const Folder& at, const std::string& name, geom::Vec3 lo, geom::Vec3 hi) {
    std::string text = "OFF\n8 12 0\n";
    for (int i = 0; i < 8; ++i) {
        const double x = (i & 1) != 0 ? hi.x : lo.x, y = (i & 2) != 0 ? hi.y : lo.y, z = (i & 4) != 0 ? hi.z : lo.z;
        text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    }
    for (const char* t :
         {"0 2 1", "1 2 3", "4 5 6", "5 7 6", "0 1 4", "1 5 4", "2 6 3", "3 6 7", "0 4 2", "2 4 6", "1 3 5", "3 7 5"})
        text += std::string("3 ") + t + "\n";
    return at.write(name, text);
}

// Two strokes of one bead along x on the bed, from 0 to 10 and from 30 to 40 mm, and the travel between them.
inline std::vector<toolpath::Span> two_strokes() {
    using toolpath::Role;
    return {{Role::bead, 0, 0, 0, {{0, 0, 0.2}, {10, 0, 0.2}}, {0.4}, {0.2}},
            {Role::travel, 1, 0, 0, {{10, 0, 0.2}, {30, 0, 0.2}}, {}, {}},
            {Role::bead, 1, 0, 0, {{30, 0, 0.2}, {40, 0, 0.2}}, {0.4}, {0.2}}};
}

inline std::vector<stream::RawFrame> frames(const std::vector<toolpath::Span>& spans) {
    std::vector<stream::RawFrame> out;
    for (const auto& s : spans) out.push_back(wire::frame(s));
    return out;
}

} // namespace filum::app::test
