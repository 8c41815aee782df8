#include "base/error.hpp"
#include "base/number.hpp"
#include "slice/slice.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace filum::slice {

namespace {

constexpr double kMaxLayers = 1e6;

struct Reach {
    double bottom, top;
};

Reach reach(const mesh::Mesh& mesh) {
    const auto [lo, hi] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                              [](const geom::Vec3& a, const geom::Vec3& b) { return a.z < b.z; });
    return {lo->z, hi->z};
}

[[noreturn]] void too_many() {
    throw Error(Exit::bad_input,
                "cannot slice into more than 1000000 layers; check --unit, --scale and --layer-height");
}

std::vector<Level> uniform(double bottom, double height, double first, double step) {
    const double more = std::max(0.0, std::floor((height - first) / step + 0.5 + 1e-9));
    if (more >= kMaxLayers) too_many();
    std::vector<Level> out{{bottom + first, first, bottom + first / 2}};
    for (std::size_t i = 1; i <= static_cast<std::size_t>(more); ++i) {
        const double below = first + static_cast<double>(i - 1) * step;
        out.push_back({bottom + first + static_cast<double>(i) * step, step, bottom + below + step / 2});
    }
    return out;
}

// The greatest |n_z| among the triangles that reach into each of `bins` slices of the height.
std::vector<double> steepest(const mesh::Mesh& mesh, double bottom, double bin, std::size_t bins) {
    // level k holds maxima over 2^k bins; each triangle is entered twice, then all is handed down
    const auto depth = static_cast<std::size_t>(std::bit_width(bins));
    std::vector<std::vector<double>> table(depth, std::vector<double>(bins, 0));
    for (const auto& t : mesh.triangles) {
        const auto &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const auto n = cross(b - a, c - a);
        const double l = norm(n);
        if (!(l > 0)) continue;
        const auto of = [&](double z) {
            return static_cast<std::size_t>(std::clamp((z - bottom) / bin, 0.0, static_cast<double>(bins - 1)));
        };
        const std::size_t i = of(std::min({a.z, b.z, c.z})), j = of(std::max({a.z, b.z, c.z})) + 1;
        const auto k = static_cast<std::size_t>(std::bit_width(j - i)) - 1;
        for (const std::size_t at : {i, j - (std::size_t{1} << k)})
            table[k][at] = std::max(table[k][at], std::abs(n.z) / l);
    }
    for (std::size_t k = depth - 1; k > 0; --k)
        for (std::size_t i = 0; i < bins; ++i) {
            const std::size_t j = i + (std::size_t{1} << (k - 1));
            table[k - 1][i] = std::max(table[k - 1][i], table[k][i]);
            if (j < bins) table[k - 1][j] = std::max(table[k - 1][j], table[k][i]);
        }
    return std::move(table[0]);
}

std::vector<Level> adaptive(const mesh::Mesh& mesh, const Reach& r, double first, const Options& o) {
    const double height = r.top - r.bottom, least = o.min_layer_height;
    if (height / least >= kMaxLayers) too_many();
    const auto bins = static_cast<std::size_t>(std::ceil(4 * height / least)) + 1;
    const double bin = height / static_cast<double>(bins);
    std::vector<double> limit = steepest(mesh, r.bottom, bin, bins);
    for (double& l : limit) l = std::clamp(o.cusp / std::max(l, 1e-9), least, o.max_layer_height);
    constexpr double kGrowth =
        0.3; // of the height, per mm of z and mm of height: neighbours differ by less than a third
    for (std::size_t i = 1; i < bins; ++i) limit[i] = std::min(limit[i], limit[i - 1] + kGrowth * bin);
    for (std::size_t i = bins - 1; i-- > 0;) limit[i] = std::min(limit[i], limit[i + 1] + kGrowth * bin);
    std::vector<Level> out{{r.bottom + first, first, r.bottom + first / 2}};
    for (double z = first; height - z >= least / 2;) {
        double h = o.max_layer_height;
        for (auto i = static_cast<std::size_t>(z / bin); i < bins && static_cast<double>(i) * bin < z + h; ++i)
            h = std::min(h, limit[i]);
        // Two layers share what is left for less than two, so that the top is met.
        const double left = height - z;
        if (left < h)
            h = std::max(left, least);
        else if (left < 2 * h)
            h = std::max(left / 2, least);
        out.push_back({r.bottom + z + h, h, r.bottom + z + std::min(h, left) / 2});
        z += h;
    }
    return out;
}

} // namespace

std::vector<Level> levels(const mesh::Mesh& mesh, const Options& o, Notes& notes) {
    if (o.adaptive && o.min_layer_height > o.max_layer_height)
        throw Error(Exit::usage, "cannot use --min-layer-height " + shortest_text(o.min_layer_height) +
                                     ": it is above --max-layer-height " + shortest_text(o.max_layer_height));
    const Reach r = reach(mesh);
    const double height = r.top - r.bottom;
    const double first = o.first_layer_height > 0 ? o.first_layer_height : o.layer_height;
    if (height < first / 2 * (1 - 1e-9))
        throw Error(Exit::bad_input, "cannot slice a part " + fixed_text(height, 6) +
                                         " mm high: it is lower than half a layer of " + fixed_text(first, 6) +
                                         " mm; check --unit, or give a smaller --layer-height");
    if (height < first * (1 - 1e-6)) {
        notes.push_back({.stage = "", .what = "part lower than its one layer", .amount = height, .unit = "mm"});
        return {{r.bottom + first, first, r.bottom + height / 2}};
    }
    return o.adaptive ? adaptive(mesh, r, first, o) : uniform(r.bottom, height, first, o.layer_height);
}

} // namespace filum::slice
