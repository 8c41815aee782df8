// The answer of the program that reads STEP files, written to descriptor 3; private to lib/shapes/mesh/step.
#pragma once

#include <cstdint>

namespace filum::mesh::step {

// The header of an answer. After a failure, a text of `vertices` bytes follows. Otherwise the mesh follows: per vertex
// x, y and z as doubles; per triangle three indices; then per triangle its face. Indices and faces are 32-bit numbers.
// The byte order is that of this machine.
struct Answer {
    static constexpr std::uint64_t kMark = 0x3170657473'6c6966; // "filstep1"
    std::uint64_t mark = kMark;
    std::uint64_t failed = 0; // 1: a text follows
    std::uint64_t vertices = 0, triangles = 0;
    std::uint64_t unread = 0;   // faces of the file that are missing in the shape
    std::uint64_t unmeshed = 0; // faces of the shape without triangles
    double x = 0, y = 0;        // position of the first face without triangles, mm
};

} // namespace filum::mesh::step
