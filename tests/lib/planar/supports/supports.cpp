#include "supports/supports.hpp"

#include "../../trials.hpp"
#include "../fill/pattern_check.hpp"

namespace filum::supports {
namespace {

using polygon::Loops;
using polygon::Region;
using polygon::RegionClass;

std::vector<Region> part_of(const std::vector<Loops>& layers) {
    std::vector<Region> out;
    for (std::uint32_t layer = 0; layer < layers.size(); ++layer)
        for (const Loops& part : polygon::split(layers[layer]).part) {
            Region r;
            r.id = static_cast<std::uint32_t>(out.size());
            r.layer = layer;
            r.z = 0.2 * (layer + 1);
            r.height = 0.2;
            r.loops = part;
            r.area = polygon::signed_area(part);
            r.box = polygon::bounds(part[0]);
            r.inradius = 0.2;
            if (layer > 0)
                for (const Region& below : out)
                    if (const Loops both = polygon::intersect(below.loops, part);
                        below.layer + 1 == layer && !both.empty())
                        r.below.push_back({below.id, polygon::signed_area(both), 0.2, true});
            out.push_back(std::move(r));
        }
    return out;
}

Options with_support() {
    Options o;
    o.support = true;
    return o;
}

// A stem and a plate on it.
std::vector<Loops> mushroom() {
    std::vector<Loops> out(10, test::disc({0, 0}, 3));
    for (int k = 0; k < 3; ++k) out.push_back(test::disc({0, 0}, 12));
    return out;
}

// Blobs that wander and change in size from layer to layer.
std::vector<Loops> random_layers(unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (random() / 4294967296.0); };
    std::vector<Loops> out;
    double r = 5, x = 0, y = 8;
    for (int layer = 0; layer < 30; ++layer) {
        r = std::clamp(r + uniform(-0.8, 1), 1.5, 9.0);
        x += uniform(-0.6, 0.6);
        y += uniform(-0.4, 0.3);
        out.push_back(polygon::unite(test::disc({x, 0}, r), test::disc({0.5 * x, y}, 2)));
    }
    return out;
}

double support_area(const std::vector<Region>& regions) {
    double out = 0;
    for (const Region& r : regions)
        if (r.is == RegionClass::support) out += r.area;
    return out;
}

// Bodies say where supports are wanted and where not, in layers of the part, with any raft below it.
TEST(Supports, StandWhereABodyWantsThem) {
    const std::vector<Loops> right(13, test::rectangle(0, -20, 20, 20));
    Facts facts;
    Notes notes;
    Options all = with_support(), some, other = with_support();
    some.wanted = right;
    other.unwanted = right;
    const double whole = support_area(supports(part_of(mushroom()), all, facts, notes));
    const auto wanted = supports(part_of(mushroom()), some, facts, notes);
    for (const Region& r : wanted)
        if (r.is == RegionClass::support) {
            EXPECT_GT(r.box.lo.x, -1) << r.layer;
        }
    const double half = support_area(wanted), rest = support_area(supports(part_of(mushroom()), other, facts, notes));
    EXPECT_NEAR(half, whole / 2, 0.05 * whole);
    EXPECT_NEAR(rest, whole / 2, 0.05 * whole);
    // what leans by less than the angle is carried where it is wanted
    std::vector<Loops> cone;
    cone.reserve(20);
    for (int k = 0; k < 20; ++k) cone.push_back(test::disc({0, 0}, 5 + 0.3 * k));
    all.angle = std::numbers::pi / 3;
    EXPECT_EQ(support_area(supports(part_of(cone), all, facts, notes)), 0);
    all.wanted.assign(20, test::rectangle(-20, -20, 20, 20));
    EXPECT_GT(support_area(supports(part_of(cone), all, facts, notes)), 0);
    // layers of a raft lie below those of the body
    const auto on_top = [&](bool raft) {
        Options o;
        o.raft = raft ? 2 : 0;
        o.wanted.assign(13, {});
        o.wanted[10] = right[0];
        double out = 0;
        for (const Region& r : supports(part_of(mushroom()), o, facts, notes))
            if (r.is == RegionClass::support && r.layer > (raft ? 4U : 0U)) out += r.area;
        return out;
    };
    EXPECT_GT(on_top(false), 100);
    EXPECT_NEAR(on_top(true), on_top(false), 0.2 * on_top(false));
}

TEST(Supports, CarriesAPlateAcrossTheGap) {
    Facts facts;
    Notes notes;
    const auto all = supports(part_of(mushroom()), with_support(), facts, notes);
    ASSERT_EQ(notes.size(), 1U); // between stem and column, half a bead from both
    EXPECT_NEAR(notes[0].amount, 3.1416 * (3.8 * 3.8 - 3.2 * 3.2), 0.1);
    EXPECT_EQ(notes[0].code, NoteCode::overhang_bridge);
    EXPECT_EQ(notes[0].detail, "1 mm");
    std::size_t carriers = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_EQ(all[i].id, i);
        for (const auto& o : all[i].below) EXPECT_LT(all[o.below].layer, all[i].layer);
        if (all[i].is != RegionClass::support) continue;
        ++carriers;
        EXPECT_LE(all[i].layer, 8U); // one layer is left out below the plate
        EXPECT_GT(all[i].area, 0.8 * 3.1416 * (144 - 9));
        if (all[i].layer > 0) {
            ASSERT_EQ(all[i].below.size(), 1U);
            EXPECT_TRUE(all[i].below[0].link);
        }
    }
    EXPECT_EQ(carriers, 9U);
    const auto plate = std::find_if(all.begin(), all.end(), [](const Region& r) { return r.layer == 10; });
    const auto from_afar = std::count_if(plate->below.begin(), plate->below.end(), [&](const polygon::Overlap& o) {
        return all[o.below].is == RegionClass::support && all[o.below].layer == 8 && !o.link;
    });
    EXPECT_EQ(from_afar, 1);
}

// A taper saves, and yet every layer of a column lies on the one below it, a column keeps a tenth of its height as
// width, and what the part lies on is as without.
TEST(Supports, TaperWithoutHanging) {
    std::vector<std::vector<Loops>> parts{std::vector<Loops>(60, test::disc({0, 0}, 3))};
    for (int k = 0; k < 3; ++k) parts[0].push_back(test::disc({0, 0}, 14));
    for (unsigned seed = 0; seed < static_cast<unsigned>(trials(4)); ++seed) parts.push_back(random_layers(seed));
    for (const auto& part : parts)
        for (const bool on_part : {true, false}) {
            Options straight = with_support(), o;
            straight.on_part = on_part;
            o = straight;
            o.taper = std::numbers::pi / 6;
            Facts facts;
            Notes before, notes;
            const auto was = supports(part_of(part), straight, facts, before);
            const auto all = supports(part_of(part), o, facts, notes);
            EXPECT_LE(support_area(all), support_area(was) + 1e-6);
            std::vector<Loops> column(part.size());
            for (const Region& r : all)
                if (r.is == RegionClass::support) column[r.layer].add(r.loops);
            for (std::size_t i = 1; i < part.size(); ++i) {
                if (column[i].empty()) continue;
                Loops below = i >= 2 ? part[i - 2] : Loops{};
                below.add(column[i - 1]);
                if (below.empty()) continue;
                const Loops hangs =
                    polygon::subtract(column[i], polygon::offset(polygon::unite(below), 0.5 * o.bead_width));
                if (!on_part) {
                    EXPECT_LT(polygon::signed_area(hangs), 0.05) << i;
                }
                for (const Loops& piece : polygon::split(column[i]).part)
                    EXPECT_FALSE(polygon::opened(piece, 0.9 * o.bead_width).empty()) << i;
            }
            double carried = 0, now = 0;
            for (const Note& n : before) carried += n.amount;
            for (const Note& n : notes) now += n.amount;
            EXPECT_LE(now, carried * 1.15 + 0.1); // slivers that lay on a column which is now narrower
        }
    Facts facts;
    Notes notes;
    Options o = with_support();
    const double straight = support_area(supports(part_of(parts[0]), o, facts, notes));
    o.taper = std::numbers::pi / 6;
    const auto all = supports(part_of(parts[0]), o, facts, notes);
    EXPECT_LT(support_area(all), 0.7 * straight);
    for (const Region& r : all)
        if (r.is == RegionClass::support && r.layer == 0) {
            EXPECT_FALSE(polygon::opened(r.loops, 0.7).empty());
        }
}

TEST(Supports, WhatHangsHalfABeadFromAColumnIsCarried) {
    Options o = with_support();
    o.beside = o.bead_width;
    Facts facts;
    Notes notes;
    for (const Region& r : supports(part_of(mushroom()), o, facts, notes)) EXPECT_EQ(r.unsupported, 0) << r.layer;
    EXPECT_TRUE(notes.empty());
}

TEST(Supports, WhatStillHangsIsTold) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        Options o = with_support();
        o.gap = 1 + seed % 3;
        o.on_part = seed % 2 == 0;
        o.angle = seed % 4 == 3 ? 1.4 : 0.8;
        const auto layers = random_layers(seed);
        Facts facts;
        Notes notes;
        const auto all = supports(part_of(layers), o, facts, notes);
        std::vector<Loops> carrying(layers.size());
        std::vector<double> told(layers.size(), 0);
        for (const Region& r : all)
            for (std::size_t l = 0; r.is == RegionClass::support && l < r.loops.size(); ++l)
                carrying[r.layer].add(r.loops[l]);
        for (const Region& r : all) told[r.layer] += r.is == RegionClass::part ? r.unsupported : 0;
        double sum = 0;
        for (std::size_t i = 1, far = static_cast<std::size_t>(o.gap) + 1; i < layers.size(); ++i) {
            const Loops below = i < far ? layers[i - 1] : polygon::unite(layers[i - 1], carrying[i - far]);
            const Loops bare = polygon::subtract(layers[i], polygon::offset(below, o.bead_width / 2));
            // all but what is smaller than a dot or narrower than a hairline
            EXPECT_LE(told[i], polygon::signed_area(bare) + 0.05) << seed << " layer " << i;
            EXPECT_GE(told[i], polygon::signed_area(polygon::offset(bare, -0.05)) - 0.5) << seed << " layer " << i;
            sum += told[i];
        }
        EXPECT_NEAR(sum, notes.empty() ? 0 : notes[0].amount, 1e-9) << seed;
        EXPECT_GT(sum, 0) << seed;
    }
}

TEST(Supports, KeepClearOfThePart) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        Options o = with_support();
        o.gap = 1 + seed % 3;
        o.beside = 0.3 + 0.2 * (seed % 4);
        o.on_part = seed % 2 == 0;
        const auto layers = random_layers(seed);
        Facts facts;
        Notes notes;
        const auto all = supports(part_of(layers), o, facts, notes);
        for (const Region& r : all) {
            if (r.is != RegionClass::support) continue;
            const auto meets = [&](const Loops& other) {
                // except for the deviation of round corners
                return polygon::signed_area(polygon::intersect(polygon::offset(r.loops, -0.05), other)) > 0.02;
            };
            EXPECT_FALSE(meets(polygon::offset(layers[r.layer], o.beside - 0.05))) << seed << " layer " << r.layer;
            for (std::int64_t k = -o.gap; k <= o.gap; ++k) {
                const std::int64_t at = static_cast<std::int64_t>(r.layer) + k;
                if (k == 0 || at < 0 || at >= static_cast<std::int64_t>(layers.size())) continue;
                EXPECT_FALSE(meets(layers[static_cast<std::size_t>(at)]))
                    << seed << " layer " << r.layer << " to " << k;
            }
            EXPECT_TRUE(o.on_part || r.layer == 0 || !r.below.empty()) << seed; // stands on what stands on the bed
        }
    }
}

TEST(Supports, RimsLieAboutTheFirstLayer) {
    Options o;
    o.brim = 4;
    o.skirt = 3;
    Facts facts;
    Notes notes;
    const auto all = supports(part_of(mushroom()), o, facts, notes);
    ASSERT_EQ(all.size(), 15U);
    EXPECT_EQ(all[1].is, RegionClass::rim);
    EXPECT_EQ(all[1].layer, 0U);
    EXPECT_NEAR(all[1].area, 3.1416 * (49 - 9), 1.5);
    EXPECT_EQ(all[2].is, RegionClass::rim);
    EXPECT_NEAR(polygon::bounds(all[2].loops).hi.x, 3 + 4 + 3 + 0.8, 0.05);
}

// A frame with a block within it, and one beside: brims lie outside, and each region knows the one about it.
TEST(Supports, RegionsKnowTheirBrims) {
    Loops l;
    l.add(std::vector<geom::Vec2>{{0, 0}, {20, 0}, {20, 20}, {0, 20}});
    l.add(std::vector<geom::Vec2>{{2, 2}, {2, 18}, {18, 18}, {18, 2}});
    const auto add_box = [&](double x, double y, double w, double h) {
        l.add(std::vector<geom::Vec2>{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}});
    };
    add_box(8, 8, 4, 4);
    add_box(40, 0, 5, 5);
    add_box(48, 0, 5, 5); // its brim and that of the one before are one
    Options o;
    o.brim = 3;
    o.skirt = 2;
    Facts facts;
    Notes notes;
    const auto all = supports(part_of({l}), o, facts, notes);
    std::map<std::int64_t, int> about;
    for (const Region& r : all) {
        if (r.is == RegionClass::part) ++about[r.brim];
        EXPECT_TRUE(r.brim < 0 || all[static_cast<std::size_t>(r.brim)].is == RegionClass::rim);
    }
    ASSERT_EQ(about.size(), 3U);
    EXPECT_EQ(about[-1], 1) << "the block within the frame has none";
    for (const auto& [brim, regions] : about) {
        if (brim < 0) continue;
        const Loops& loops = all[static_cast<std::size_t>(brim)].loops;
        EXPECT_EQ(loops.size(), 1 + static_cast<std::size_t>(regions)) << "a hole for each region";
    }
}

TEST(Supports, ARaftCarriesTheFirstLayer) {
    for (const bool support : {false, true})
        for (const std::int64_t gap : {1, 2}) {
            Options o;
            o.raft = 3;
            o.gap = gap;
            o.support = support;
            o.brim = 2;
            const auto before = part_of(mushroom());
            Facts facts;
            Notes notes;
            const auto all = supports(before, o, facts, notes);
            const auto raised = static_cast<std::uint32_t>(o.raft + gap);
            std::size_t part = 0;
            double rim = 0;
            for (const Region& r : all) {
                EXPECT_NEAR(r.z, 0.2 * (r.layer + 1), 1e-9);
                rim += r.is == RegionClass::rim ? r.area : 0;
                for (const auto& o : r.below) EXPECT_NE(all[o.below].is, RegionClass::rim) << "nothing lies on a brim";
                if (r.is == RegionClass::part) {
                    EXPECT_EQ(r.layer, before[part].layer + raised);
                    EXPECT_EQ(r.loops.points, before[part].loops.points);
                    EXPECT_TRUE(part > 0 || r.unsupported == 0);
                    ++part;
                }
                if (r.is == RegionClass::support && r.layer < raised) {
                    EXPECT_TRUE(r.layer < 3 || support) << r.layer; // columns beside the part go on
                    EXPECT_GT(r.area, 3.1416 * 3.7 * 3.7);
                }
            }
            EXPECT_EQ(part, before.size());
            const double least = 3.1416 * (5.8 * 5.8 - 3.8 * 3.8); // with supports the raft is as wide as the cap
            EXPECT_GT(rim, least - 0.5);
            EXPECT_EQ(rim < least + 0.5, !support);
            const auto on_raft = std::count_if(
                all.begin(), all.end(), [](const Region& r) { return r.layer < 3 && r.is == RegionClass::support; });
            EXPECT_EQ(on_raft, 3) << support;
        }
}

TEST(Supports, ABrimLiesAboutSupportsToo) {
    Options o = with_support();
    o.brim = 2;
    Facts facts;
    Notes notes;
    Loops laid;
    double sum = 0;
    for (const Region& r : supports(part_of(mushroom()), o, facts, notes)) {
        if (r.layer > 0) continue;
        sum += r.area;
        laid.add(r.loops);
    }
    EXPECT_NEAR(sum, polygon::signed_area(polygon::unite(laid)), 0.01); // nothing overlaps
}

TEST(Supports, WithoutWishesNothingChanges) {
    Facts facts;
    Notes notes;
    const auto before = part_of(mushroom());
    const auto all = supports(before, {}, facts, notes);
    ASSERT_EQ(all.size(), before.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].loops.points, before[i].loops.points);
}

} // namespace
} // namespace filum::supports
