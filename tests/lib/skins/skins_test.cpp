#include "skins/skins.hpp"

#include "../fill/pattern_check.hpp"
#include "base/error.hpp"

namespace filum::skins {
namespace {

using polygon::AreaKind;
using polygon::Loops;
using polygon::Region;

// A part of layers, each with some outlines that change at random from layer to layer.
std::vector<Region> random_part(unsigned seed, std::uint32_t layers) {
    std::mt19937 random(seed);
    const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (random() / 4294967296.0); };
    const Loops core = test::disc({0, 0}, 14);
    std::vector<Region> out;
    double radius = 10, x = 0;
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        radius = std::clamp(radius + uniform(-1.2, 1.2), 2.0, 14.0), x += uniform(-0.5, 0.5);
        if (layer == layers / 2) radius = 5;
        Loops area = polygon::subtract(test::disc({x, 0}, radius), test::disc({x - 3, 0.3 * layer - 5}, 1));
        area = polygon::intersect(area, core);
        for (const Loops& part : polygon::split(area).part) {
            Region r;
            r.id = static_cast<std::uint32_t>(out.size()), r.layer = layer, r.z = 0.2 * (layer + 1), r.height = 0.2;
            r.loops = part, r.area = polygon::signed_area(part);
            out.push_back(std::move(r));
        }
    }
    return out;
}

Loops layer_of(const std::vector<Region>& part, std::int64_t layer) {
    Loops out;
    for (const Region& r : part)
        if (r.layer == layer)
            for (std::size_t i = 0; i < r.loops.size(); ++i) out.add(r.loops[i]);
    return out;
}

Loops sparse_of(const Region& r) {
    Loops out;
    for (const auto& a : r.areas)
        if (a.kind == AreaKind::sparse)
            for (std::size_t i = 0; i < a.loops.size(); ++i) out.add(a.loops[i]);
    return out;
}

// By the definition, layer by layer: nothing sparse has less than so many layers of material above or below it, but for
// what is narrower than a hairline; nothing sparse is a wall.
TEST(Skins, NothingSparseIsSeenThroughTooFewLayers) {
    for (unsigned seed = 0; seed < 6; ++seed)
        for (const auto& [top, bottom] : {std::pair{4, 4}, {1, 3}, {3, 0}, {0, 2}, {7, 5}}) {
            const auto before = random_part(seed, 30);
            auto part = before;
            Options o;
            o.top = top, o.bottom = bottom, o.walls = 1 + seed % 3, o.solid_below = 0;
            Facts facts;
            skins(part, o, facts);
            double sparse = 0;
            for (std::size_t i = 0; i < part.size(); ++i) {
                EXPECT_EQ(part[i].loops.points, before[i].loops.points);
                const Loops open = sparse_of(part[i]);
                sparse += polygon::signed_area(open);
                const Loops room = polygon::offset(part[i].loops, -o.bead_width * o.walls + 0.02);
                EXPECT_LT(polygon::signed_area(polygon::subtract(open, room)), 1e-3) << seed;
                for (std::int64_t k = -bottom; k <= top; ++k) {
                    Loops over = polygon::subtract(open, layer_of(before, part[i].layer + k));
                    over = polygon::offset(over, -0.05 * o.bead_width);
                    EXPECT_LT(polygon::signed_area(over), 1e-3) << seed << " layer " << part[i].layer << " to " << k;
                }
            }
            EXPECT_GT(sparse, 100) << seed;
        }
}

TEST(Skins, AreasOfARegionDoNotOverlap) {
    auto part = random_part(3, 40);
    Facts facts;
    Options o;
    o.infill = 0.1; // so that lines under skins are nearer
    skins(part, o, facts);
    std::size_t dense = 0;
    for (const Region& r : part) {
        std::vector<const polygon::Area*> sparse;
        for (const auto& a : r.areas)
            if (a.kind == AreaKind::sparse) sparse.push_back(&a);
        if (sparse.size() < 2) continue;
        ++dense;
        EXPECT_LT(polygon::signed_area(polygon::intersect(sparse[0]->loops, sparse[1]->loops)), 1e-3);
        EXPECT_EQ(sparse[0]->gap, o.bridge);
        EXPECT_EQ(sparse[1]->gap, 0);
        EXPECT_EQ(sparse[0]->spacing, sparse[1]->spacing); // every line goes on
    }
    EXPECT_GT(dense, 0U);
}

TEST(Skins, SmallSparsePartsAreSolid) {
    for (const double least : {0.0, 40.0, 120.0, 1e4}) {
        auto part = random_part(5, 30);
        Facts facts;
        Options o;
        o.solid_below = least;
        skins(part, o, facts);
        std::size_t small = 0, large = 0;
        for (const Region& r : part)
            for (const Loops& piece : polygon::split(polygon::unite(sparse_of(r))).part) {
                const double area = polygon::signed_area(piece);
                if (area > 1e-3) ++(area < least - 1 ? small : large);
            }
        EXPECT_EQ(small, 0U) << least;
        EXPECT_EQ(large > 0, least < 1e4) << least;
    }
}

TEST(Skins, AllOfIt) {
    auto part = random_part(1, 20);
    Facts facts;
    Options o;
    o.infill = 1;
    skins(part, o, facts);
    for (const Region& r : part) EXPECT_TRUE(r.areas.empty() && r.walls == 0);
}

TEST(Skins, ShareReadsPercentAndNumbers) {
    EXPECT_DOUBLE_EQ(share("15%"), 0.15);
    EXPECT_DOUBLE_EQ(share("0.15"), 0.15);
    EXPECT_DOUBLE_EQ(share("100%"), 1);
    for (const char* wrong : {"", "%", "0", "0%", "101%", "1.5", "-5%", "x", "15%%"}) EXPECT_THROW(share(wrong), Error);
}

} // namespace
} // namespace filum::skins
