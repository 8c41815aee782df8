// What the program that reads STEP files hands back on descriptor 3; private to lib/step.
#pragma once

#include <cstdint>

namespace filum::mesh::step {

// After it: the text of a failure, `vertices` bytes; or of the mesh per vertex x, y, z as doubles, per triangle three
// indices, then per triangle its face, as 32-bit numbers.  All as this machine has them.
struct Answer {
    static constexpr std::uint64_t kMark = 0x3170657473'6c6966; // "filstep1"
    std::uint64_t mark = kMark;
    std::uint64_t failed = 0; // 1: a text follows
    std::uint64_t vertices = 0, triangles = 0;
    std::uint64_t unread = 0;   // faces in the file that became none of the shape
    std::uint64_t unmeshed = 0; // faces of the shape without triangles
    double x = 0, y = 0;        // where the first of those is
};

} // namespace filum::mesh::step
