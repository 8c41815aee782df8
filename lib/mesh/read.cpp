#include "mesh/read.hpp"

#include "base/error.hpp"

#include <cstring>
#include <map>
#include <tuple>

namespace filum::mesh {

Mesh read(std::string_view bytes, const std::string& name) {
    std::uint32_t n = 0;
    if (bytes.size() < 84) throw Error(Exit::bad_input, "cannot read " + name + ": it is no mesh");
    std::memcpy(&n, bytes.data() + 80, 4);
    if (bytes.size() < 84 + std::size_t{50} * n)
        throw Error(Exit::bad_input, "cannot read " + name + ": it is cut short");
    Mesh out;
    std::map<std::tuple<float, float, float>, std::uint32_t> seen;
    for (std::uint32_t t = 0; t < n; ++t) {
        std::array<std::uint32_t, 3> tri{};
        for (std::size_t k = 0; k < 3; ++k) {
            float v[3];
            std::memcpy(v, bytes.data() + 84 + std::size_t{50} * t + 12 + 12 * k, 12);
            const auto [it, fresh] =
                seen.try_emplace({v[0], v[1], v[2]}, static_cast<std::uint32_t>(out.vertices.size()));
            if (fresh) out.vertices.push_back({v[0], v[1], v[2]});
            tri[k] = it->second;
        }
        out.triangles.push_back(tri);
    }
    return out;
}

} // namespace filum::mesh
