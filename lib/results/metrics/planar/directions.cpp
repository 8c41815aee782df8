#include "metrics/planar/directions.hpp"

#include <cmath>
#include <numbers>

namespace filum::metrics::planar {

Directions directions(const Beads& beads) {
    Directions out;
    constexpr double kBin = std::numbers::pi / Directions::kBins;
    double total = 0;
    for (const auto& [index, layer] : beads.layer)
        for (std::size_t k = 0; k < layer.runs.size(); ++k) {
            if (!toolpath::fills(layer.runs[k].role)) continue;
            for (std::size_t i = layer.runs[k].first; i + 1 < layer.end(k); ++i) {
                const Vec2 d = layer.points[i + 1] - layer.points[i];
                const double l = geom::norm(d);
                const auto bin =
                    static_cast<int>(std::floor(std::atan2(d.y, d.x) / kBin + 0.5)) + 2 * Directions::kBins;
                out.share[static_cast<std::size_t>(bin) % Directions::kBins] += l;
                total += l;
            }
        }
    if (total > 0)
        for (double& s : out.share) s /= total;
    return out;
}

} // namespace filum::metrics::planar
