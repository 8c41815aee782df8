#include "base/error.hpp"
#include "base/number.hpp"
#include "slice/slice.hpp"

#include <algorithm>
#include <cmath>

namespace filum::slice {

namespace {

constexpr double kMaxLayers = 1e6, kMaxAdaptive = 1e5;

struct Reach {
    double bottom, top;
};

Reach reach(const mesh::Mesh& mesh) {
    const auto [lo, hi] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                                              [](const geom::Vec3& a, const geom::Vec3& b) { return a.z < b.z; });
    return {lo->z, hi->z};
}

[[noreturn]] void too_many(double limit) {
    throw Error(Exit::bad_input, "cannot slice into more than " + shortest_text(limit) +
                                     " layers; check --unit, --scale and --layer-height");
}

std::vector<Level> uniform(double bottom, double height, double first, double step) {
    const double more = std::max(0.0, std::floor((height - first - 2 * kLift) / step + 0.5));
    if (more >= kMaxLayers) too_many(kMaxLayers);
    std::vector<Level> out{{bottom + first, first, bottom + first / 2}};
    for (std::size_t i = 1; i <= static_cast<std::size_t>(more); ++i) {
        const double below = first + static_cast<double>(i - 1) * step;
        out.push_back({bottom + first + static_cast<double>(i) * step, step, bottom + below + step / 2});
    }
    return out;
}

constexpr std::size_t kClasses = 16; // classes of slope, by |n_z|
constexpr double kIgnored = 0.05;    // of the surface at one height is ignored as the steepest: specks, letters
constexpr double kLevel = 0.9999;    // |n_z| of faces that leave no steps

// Per bin of the height, a bound on |n_z| for all of the surface there except the kIgnored share.
std::vector<double> slopes(const mesh::Mesh& mesh, double bottom, double bin, std::size_t bins) {
    // the area per class and bin, as differences to the bin below; each triangle is entered at its first bin and after
    // its last
    std::vector<double> change(kClasses * (bins + 1), 0);
    for (const auto& t : mesh.triangles) {
        const auto &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const auto n = cross(b - a, c - a);
        const double l = norm(n), slope = std::abs(n.z) / l;
        if (!(slope < kLevel)) continue;
        const auto of = [&](double z) {
            return static_cast<std::size_t>(std::clamp((z - bottom) / bin, 0.0, static_cast<double>(bins - 1)));
        };
        const std::size_t i = of(std::min({a.z, b.z, c.z})), j = of(std::max({a.z, b.z, c.z})) + 1;
        const auto k = static_cast<std::size_t>(slope * kClasses);
        change[i * kClasses + k] += l / static_cast<double>(j - i);
        change[j * kClasses + k] -= l / static_cast<double>(j - i);
    }
    std::vector<double> out(bins);
    double area[kClasses] = {};
    for (std::size_t i = 0; i < bins; ++i) {
        double all = 0, steeper = 0;
        for (std::size_t k = 0; k < kClasses; ++k) all += std::max(0.0, area[k] += change[i * kClasses + k]);
        std::size_t k = kClasses;
        while (k > 0 && steeper + area[k - 1] <= kIgnored * all) steeper += area[--k];
        out[i] = static_cast<double>(k) / kClasses;
    }
    return out;
}

std::vector<Level> adaptive(const mesh::Mesh& mesh, const Reach& r, double first, const Options& o) {
    const double height = r.top - r.bottom, least = o.min_layer_height;
    if (height / least >= kMaxAdaptive) too_many(kMaxAdaptive);
    const auto bins = static_cast<std::size_t>(std::ceil(4 * height / least)) + 1;
    const double bin = height / static_cast<double>(bins);
    std::vector<double> limit = slopes(mesh, r.bottom, bin, bins);
    for (double& l : limit) l = std::clamp(o.cusp / std::max(l, 1e-9), least, o.max_layer_height);
    constexpr double kGrowth = 0.3; // largest growth of the height per mm of z: neighbours differ by less than a third
    for (std::size_t i = 1; i < bins; ++i) limit[i] = std::min(limit[i], limit[i - 1] + kGrowth * bin);
    for (std::size_t i = bins - 1; i-- > 0;) limit[i] = std::min(limit[i], limit[i + 1] + kGrowth * bin);
    std::vector<Level> out{{r.bottom + first, first, r.bottom + first / 2}};
    for (double z = first; height - z >= least / 2;) {
        double h = o.max_layer_height;
        for (auto i = static_cast<std::size_t>(z / bin); i < bins && static_cast<double>(i) * bin < z + h; ++i)
            h = std::min(h, limit[i]);
        // If less than two layers are left, they share the rest, so that the last one ends at the top.
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
        notes.push_back({.code = NoteCode::part_below_first_layer, .amount = height});
        return {{r.bottom + first, first, r.bottom + height / 2}};
    }
    return o.adaptive ? adaptive(mesh, r, first, o) : uniform(r.bottom, height, first, o.layer_height);
}

} // namespace filum::slice
