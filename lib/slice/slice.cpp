#include "slice/slice.hpp"

#include "polygon/clip.hpp"

#include <map>

namespace filum::slice {

std::vector<polygon::Layer> slice(const mesh::Mesh& mesh, const Options& options, Notes&) {
    double lo = 1e300, hi = -1e300;
    for (const auto& v : mesh.vertices) lo = std::min(lo, v.z), hi = std::max(hi, v.z);
    const auto count = static_cast<std::uint32_t>(std::lround((hi - lo) / options.layer_height));
    std::vector<polygon::Layer> out;
    for (std::uint32_t i = 0; i < count; ++i) {
        polygon::Layer layer{
            i, (i + 1) * options.layer_height, options.layer_height, lo + (i + 0.5) * options.layer_height, {}};
        using Edge = std::pair<std::uint32_t, std::uint32_t>;
        std::map<Edge, std::pair<geom::Vec2, Edge>> next;
        for (const auto& t : mesh.triangles) {
            Edge from, to;
            geom::Vec2 at{};
            int hits = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto a = t[k], b = t[(k + 1) % 3];
                const bool up = mesh.vertices[a].z >= layer.plane, vp = mesh.vertices[b].z >= layer.plane;
                if (up == vp) continue;
                const auto [p, q] = std::minmax(a, b);
                const auto &P = mesh.vertices[p], &Q = mesh.vertices[q];
                if (!up)
                    from = {p, q}, at = lerp(P.xy(), Q.xy(), (layer.plane - P.z) / (Q.z - P.z));
                else
                    to = {p, q};
                ++hits;
            }
            if (hits == 2) next[to] = {at, from};
        }
        while (!next.empty()) {
            auto it = next.begin();
            std::vector<geom::Vec2> loop;
            while (it != next.end()) {
                loop.push_back(it->second.first);
                const auto key = it->second.second;
                next.erase(it);
                it = next.find(key);
            }
            if (loop.size() > 2) layer.contours.add(loop);
        }
        layer.contours = polygon::unite(layer.contours);
        out.push_back(std::move(layer));
    }
    return out;
}

} // namespace filum::slice
