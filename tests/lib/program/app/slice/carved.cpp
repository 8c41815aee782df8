// Negative bodies cut away layer by layer, against unit cells that are counted.
#include "app/slice/carved.hpp"

#include "base/error.hpp"
#include "mesh/place.hpp"
#include "polygon/loops.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace filum::app::slice {
namespace {

constexpr int kCells = 12; // along each axis

struct Block {
    std::array<int, 3> lo, hi;
    [[nodiscard]] bool has(int x, int y, int z) const {
        return lo[0] <= x && x < hi[0] && lo[1] <= y && y < hi[1] && lo[2] <= z && z < hi[2];
    }
};

mesh::Mesh box(const Block& b) {
    mesh::Mesh m;
    for (int i = 0; i < 8; ++i)
        m.vertices.push_back({static_cast<double>((i & 1) != 0 ? b.hi[0] : b.lo[0]),
                              static_cast<double>((i & 2) != 0 ? b.hi[1] : b.lo[1]),
                              static_cast<double>((i & 4) != 0 ? b.hi[2] : b.lo[2])});
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return m;
}

Block random_block(std::mt19937& random) {
    Block out{};
    for (std::size_t k = 0; k < 3; ++k) {
        const int a = static_cast<int>(random() % kCells), b = static_cast<int>(random() % kCells);
        out.lo[k] = std::min(a, b);
        out.hi[k] = std::max(a, b) + 1;
    }
    return out;
}

// Parts of some items, and what is cut away from each.
struct Scene {
    mesh::File file;
    std::vector<std::pair<std::uint32_t, Block>> parts, negatives;

    [[nodiscard]] bool solid(int x, int y, int z) const {
        for (const auto& [item, part] : parts) {
            if (!part.has(x, y, z)) continue;
            bool cut = false;
            for (const auto& [of, negative] : negatives) cut = cut || (of == item && negative.has(x, y, z));
            if (!cut) return true;
        }
        return false;
    }
    [[nodiscard]] int area(int z) const {
        int out = 0;
        for (int x = 0; x < kCells; ++x)
            for (int y = 0; y < kCells; ++y) out += solid(x, y, z) ? 1 : 0;
        return out;
    }
};

Scene random_scene(std::mt19937& random) {
    Scene out;
    const auto items = 1 + random() % 3;
    for (std::uint32_t item = 0; item < items; ++item) {
        for (auto n = 1 + random() % 2; n > 0; --n) out.parts.emplace_back(item, random_block(random));
        for (auto n = random() % 3; n > 0; --n) out.negatives.emplace_back(item, random_block(random));
    }
    for (const auto& [item, block] : out.parts) {
        const mesh::Mesh m = box(block);
        const auto first = static_cast<std::uint32_t>(out.file.mesh.vertices.size());
        out.file.mesh.vertices.insert(out.file.mesh.vertices.end(), m.vertices.begin(), m.vertices.end());
        for (const auto& t : m.triangles) {
            out.file.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
            out.file.items.push_back(item);
        }
    }
    for (const auto& [item, block] : out.negatives) {
        mesh::Body& body = out.file.bodies.emplace_back();
        body.what = mesh::Body::Purpose::negative;
        body.mesh = box(block);
        body.item = item;
    }
    return out;
}

} // namespace

TEST(CarvedPart, AreasAndHeightsAreThoseOfCells) {
    std::mt19937 random(11);
    const char* asked = std::getenv("FILUM_TRIALS");
    const int trials = asked != nullptr ? std::atoi(asked) : 60;
    for (int trial = 0; trial < trials; ++trial) {
        const Scene scene = random_scene(random);
        int low = kCells, high = 0;
        for (int z = 0; z < kCells; ++z)
            if (scene.area(z) > 0) {
                low = std::min(low, z);
                high = z + 1;
            }
        Notes notes;
        if (high == 0) {
            EXPECT_THROW(carve(scene.file, 0.05, 0.1, 1, notes), Error);
            continue;
        }
        CarvedPart carved = carve(scene.file, 0.05, 0.1, 1, notes);
        EXPECT_NEAR(carved.box.lo.z, low, 1e-9) << trial;
        EXPECT_NEAR(carved.box.hi.z, high, 1e-9) << trial;
        std::vector<filum::slice::Level> levels;
        for (int z = 0; z < kCells; ++z) levels.push_back({z + 1.0, 1.0, z + 0.5});
        sweep(carved, {}, levels, 1);
        for (std::size_t chunk = 0; chunk * filum::slice::kChunk < levels.size(); ++chunk)
            for (const polygon::Layer& layer : cut(carved, chunk).layers)
                EXPECT_NEAR(polygon::signed_area(layer.contours), scene.area(static_cast<int>(layer.index)), 1e-3)
                    << trial << " layer " << layer.index;
    }
}

} // namespace filum::app::slice
