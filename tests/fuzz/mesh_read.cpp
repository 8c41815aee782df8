// Any bytes give an error or a mesh that keeps the promises of mesh::read.
#include "base/error.hpp"
#include "mesh/read.hpp"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const auto file = filum::mesh::read({reinterpret_cast<const char*>(data), size}, "it");
        for (const auto& t : file.mesh.triangles) {
            if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) std::abort();
            for (const auto v : t)
                if (v >= file.mesh.vertices.size()) std::abort();
        }
        for (const auto& v : file.mesh.vertices)
            if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) std::abort();
    } catch (const filum::Error&) { // said clearly
    }
    return 0;
}
