#include "skins/skins.hpp"

#include "../../trials.hpp"
#include "../fill/pattern_check.hpp"
#include "base/error.hpp"
#include "infill/ruler.hpp"
#include "polygon/stretches.hpp"

#include <algorithm>
#include <cmath>

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
        radius = std::clamp(radius + uniform(-1.2, 1.2), 2.0, 14.0);
        x += uniform(-0.5, 0.5);
        if (layer == layers / 2) radius = 5;
        Loops area = polygon::subtract(test::disc({x, 0}, radius), test::disc({x - 3, 0.3 * layer - 5}, 1));
        area = polygon::intersect(area, core);
        for (const Loops& part : polygon::split(area).part) {
            Region r;
            r.id = static_cast<std::uint32_t>(out.size());
            r.layer = layer;
            r.z = 0.2 * (layer + 1);
            r.height = 0.2;
            r.loops = part;
            r.area = polygon::signed_area(part);
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

// By the definition, layer by layer: nothing sparse has less than so many layers of material above or below it, except
// what is narrower than a hairline; nothing sparse is a wall.
TEST(Skins, NothingSparseIsSeenThroughTooFewLayers) {
    for (unsigned seed = 0, n = trials(6); seed < n; ++seed)
        for (const auto& [top, bottom] : {std::pair{4, 4}, {1, 3}, {3, 0}, {0, 2}, {7, 5}}) {
            const auto before = random_part(seed, 30);
            auto part = before;
            Options o;
            o.top = top;
            o.bottom = bottom;
            o.walls = 1 + seed % 3;
            o.solid_below = 0;
            Facts facts;
            skins(part, o, {}, facts);
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

TEST(Skins, ModifiersChangeWhatLiesWithin) {
    const auto before = random_part(3, 40);
    const Loops body = test::rectangle(-4, -4, 5, 4);
    Options o;
    o.solid_below = 0;
    Modifier m{std::vector<Loops>(30, body), modified(o, "infill=40%,infill-pattern=wave,top=6")};
    m.where[10] = {};
    auto plain = before, changed = before;
    Facts facts;
    skins(plain, o, {}, facts);
    skins(changed, o, std::span(&m, 1), facts);
    EXPECT_EQ(facts.back().name, "modifier-1-infill-spacing");
    double within = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const bool there = before[i].layer < 30 && before[i].layer != 10;
        Loops rest = sparse_of(plain[i]);
        for (const auto& a : changed[i].areas) {
            if (a.kind != AreaKind::sparse) continue;
            const bool waves = a.pattern == polygon::InfillPattern::wave;
            const Loops off =
                waves ? polygon::subtract(a.loops, polygon::offset(body, -o.bead_width + 1e-2))
                      : polygon::intersect(a.loops, there ? polygon::offset(body, o.bead_width - 1e-2) : Loops{});
            EXPECT_LT(polygon::signed_area(off), 1e-3) << i; // a bead from the border, on either side
            EXPECT_TRUE(there || !waves) << i;
            within += waves ? polygon::signed_area(a.loops) : 0;
        }
        if (!there) {
            EXPECT_NEAR(polygon::signed_area(sparse_of(changed[i])), polygon::signed_area(rest), 1e-2) << i;
        }
    }
    EXPECT_GT(within, 100);
}

// Zones of a region, and what they say together.
Loops zones_of(const Region& r, std::size_t& walls_inside, const Loops& body) {
    Loops all;
    for (const auto& a : r.areas) {
        if (a.kind != AreaKind::zone) continue;
        EXPECT_LT(polygon::signed_area(polygon::intersect(all, a.loops)), 1e-3);
        all = polygon::unite(all, a.loops);
        if (!polygon::intersect(a.loops, polygon::offset(body, -0.5)).empty()) walls_inside = a.walls;
    }
    return all;
}

TEST(Skins, ModifiersWithOtherWallsOrBeadsMakeZones) {
    const auto before = random_part(3, 40);
    const Loops body = test::rectangle(-4, -4, 5, 4);
    struct Case {
        const char* settings;
        std::uint32_t common, inside; // walls of regions that lie on both sides, and of the zone within
        double width;                 // mm
    };
    Options o;
    o.solid_below = 0;
    for (const Case& c : {Case{"infill=40%,walls=1", 1, 0, 0.4},
                          {"infill=40%,walls=4", 2, 2, 0.4},
                          {"infill=40%,bead-width=0.6", 1, 1, 0.6},
                          {"infill=40%,walls=3,bead-width=0.3", 1, 2, 0.3}}) {
        const Modifier m{std::vector<Loops>(30, body), modified(o, c.settings)};
        auto part = before;
        Facts facts;
        skins(part, o, std::span(&m, 1), facts);
        const double spacing = facts.back().value;
        std::size_t cut = 0;
        double within = 0;
        for (const Region& r : part) {
            const Loops shared = r.layer < 30 ? polygon::intersect(r.loops, body) : Loops{};
            std::size_t inside = 0;
            const Loops zones = zones_of(r, inside, body);
            if (polygon::opened(shared, c.width / 2).empty()) {
                EXPECT_TRUE(zones.empty()) << c.settings;
                EXPECT_EQ(r.walls, 2U) << c.settings;
                continue;
            }
            if (zones.empty()) continue; // all of it is one kind, or solid
            ++cut;
            EXPECT_EQ(r.walls, c.common) << c.settings;
            EXPECT_EQ(inside, c.inside) << c.settings;
            const double depth = c.common * o.bead_width + c.inside * c.width;
            for (const auto& a : r.areas) {
                if (a.kind != AreaKind::sparse || a.spacing != spacing) continue;
                within += polygon::signed_area(a.loops);
                const Loops room = polygon::intersect(polygon::offset(r.loops, -depth + 0.02),
                                                      polygon::offset(body, -(c.inside * c.width) + 0.02));
                EXPECT_LT(polygon::signed_area(polygon::subtract(a.loops, room)), 1e-3) << c.settings;
            }
        }
        EXPECT_GT(cut, 10U) << c.settings;
        EXPECT_GT(within, 100) << c.settings;
    }
}

TEST(Skins, ZonesInASolidPartAreThoseOfOtherBeads) {
    const auto before = random_part(3, 20);
    Options o;
    o.infill = 1;
    for (const auto& [settings, any] : {std::pair{"walls=1", false}, {"bead-width=0.6", true}}) {
        const Modifier m{std::vector<Loops>(20, test::rectangle(-4, -4, 5, 4)), modified(o, settings)};
        auto part = before;
        Facts facts;
        const Notes notes = skins(part, o, std::span(&m, 1), facts); // of what is asked for in vain
        ASSERT_FALSE(notes.empty());
        for (const Note& n : notes) EXPECT_EQ(n.code == NoteCode::modifier_wall_width, any) << code_name(n);
        const bool zones = std::ranges::any_of(part, [](const Region& r) {
            return std::ranges::any_of(r.areas, [](const auto& a) { return a.kind == AreaKind::zone; });
        });
        EXPECT_EQ(zones, any) << settings;
    }
}

// Regions with a bead width of their own do not take that of a modifier: a note counts those that it meets.
TEST(Skins, AWidthThatAToolOverridesIsNoted) {
    for (const auto& [own, settings, noted] : {std::tuple{0.5, "bead-width=0.6", true},
                                               {0.5, "bead-width=0.5", false},
                                               {0.5, "walls=3", false},
                                               {0.0, "bead-width=0.6", false}}) {
        auto part = random_part(3, 20);
        for (Region& r : part) r.width = own;
        const Modifier m{std::vector<Loops>(20, test::rectangle(-4, -4, 5, 4)), modified({}, settings)};
        Facts facts;
        const Notes notes = skins(part, {}, std::span(&m, 1), facts);
        const auto idle = std::ranges::count(notes, NoteCode::modifier_width_idle, &Note::code);
        EXPECT_EQ(idle > 0, noted) << own << ' ' << settings;
    }
}

TEST(Skins, TheLastOfSeveralModifiersCounts) {
    auto part = random_part(5, 30);
    Options o;
    o.solid_below = 0;
    const std::vector<Loops> wide(30, test::rectangle(-20, -20, 20, 20));
    const Modifier solid{wide, modified(o, "infill=100%")}, loose{wide, modified(o, "infill=10%")};
    const auto sparse_by = [&](const Modifier& first, const Modifier& second) {
        const std::vector<Modifier> both{first, second};
        Facts facts;
        auto regions = part;
        skins(regions, o, both, facts);
        double out = 0;
        for (const Region& r : regions) out += polygon::signed_area(sparse_of(r));
        return out;
    };
    EXPECT_EQ(sparse_by(loose, solid), 0);
    EXPECT_GT(sparse_by(solid, loose), 100);
}

TEST(Skins, SettingsOfModifiersThatMeanNothingAreRefused) {
    for (const char* text :
         {"infill", "infill=-1%", "infill=200%", "walls=0", "walls=2.5", "walls=two", "top=-1", "spacing=3",
          "bead-width=0", "bead-width=x", "infill-pattern=stars", "=4", "infill=20%,,top=3", "top="})
        EXPECT_THROW(modified({}, text), Error) << text;
    EXPECT_EQ(modified({}, "top=0,bottom=9").bottom, 9);
    EXPECT_EQ(modified({}, "walls=1,bead-width=0.6").bead_width, 0.6);
    try {
        modified({}, "infil=40%");
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("did you mean 'infill'?"), std::string::npos) << e.what();
    }
}

TEST(Skins, AreasOfARegionDoNotOverlap) {
    auto part = random_part(3, 40);
    Facts facts;
    Options o;
    o.infill = 0.1; // so that lines under skins are nearer
    skins(part, o, {}, facts);
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

// Where more rows begin inside what is sparse, a row of their layer or of the one below lies there.
TEST(Skins, MoreRowsBeginOnRows) {
    std::size_t inside = 0;
    for (unsigned seed = 0, n = trials(6); seed < n; ++seed) {
        auto part = random_part(seed, 40);
        Facts facts;
        Options o;
        o.infill = 0.08 + 0.02 * seed;
        skins(part, o, {}, facts);
        for (const Region& r : part) {
            const Loops room = polygon::offset(polygon::unite(sparse_of(r)), -0.05);
            for (const auto& a : r.areas) {
                if (a.kind != AreaKind::sparse || a.gap == 0) continue;
                const Loops level = polygon::rotated(a.loops, -a.direction);
                const auto squares = infill::Ruler::of_squares({.spacing = a.spacing, .bead_width = o.bead_width});
                const auto from_row = [&](double v) {
                    const double j = squares.below(v);
                    return std::min(v - squares.place(j), squares.place(j + 1) - v);
                };
                for (std::size_t i = 0; i < level.points.size(); ++i) {
                    if (!polygon::contains(room, a.loops.points[i])) continue;
                    ++inside;
                    const auto [x, y] = level.points[i];
                    const double off = std::min(from_row(x), from_row(y));
                    EXPECT_LT(off, 1e-3) << seed << " layer " << r.layer << " at " << x << "," << y;
                }
            }
        }
    }
    EXPECT_GT(inside, kSanitized ? 0U : 50U);
}

// The areas of a part do not depend on what stands beside it.
TEST(Skins, PartsOfAPlateAreAsEachAlone) {
    constexpr double kApart = 40;
    std::vector<Region> plate;
    std::vector<std::vector<Region>> alone;
    const Options o{.infill = 0.2};
    Facts facts;
    for (unsigned k = 0; k < 6; ++k) {
        auto part = random_part(k % 2, 14);
        for (Region& r : part)
            for (auto& p : r.loops.points) p.x += kApart * k;
        plate.insert(plate.end(), part.begin(), part.end());
        skins(part, o, {}, facts);
        alone.push_back(std::move(part));
    }
    skins(plate, o, {}, facts);
    std::size_t at = 0;
    for (const auto& part : alone)
        for (const Region& r : part) {
            const Region& same = plate[at++];
            ASSERT_EQ(same.areas.size(), r.areas.size()) << "layer " << r.layer;
            for (std::size_t i = 0; i < r.areas.size(); ++i) {
                EXPECT_EQ(same.areas[i].kind, r.areas[i].kind);
                EXPECT_NEAR(polygon::signed_area(same.areas[i].loops), polygon::signed_area(r.areas[i].loops), 1e-2);
            }
        }
    EXPECT_EQ(at, plate.size());
}

TEST(Skins, SmallSparsePartsAreSolid) {
    for (const double least : {0.0, 40.0, 120.0, 1e4}) {
        auto part = random_part(5, 30);
        Facts facts;
        Options o;
        o.solid_below = least;
        skins(part, o, {}, facts);
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
    skins(part, o, {}, facts);
    for (const Region& r : part) EXPECT_TRUE(r.areas.empty() && r.walls == 0);
}

TEST(Skins, ShareReadsPercentAndNumbers) {
    EXPECT_DOUBLE_EQ(share("15%"), 0.15);
    EXPECT_DOUBLE_EQ(share("0.15"), 0.15);
    EXPECT_DOUBLE_EQ(share("100%"), 1);
    EXPECT_EQ(share("0%"), 0);
    EXPECT_EQ(share("0"), 0);
    for (const char* wrong : {"", "%", "101%", "1.5", "-5%", "x", "15%%"}) EXPECT_THROW(share(wrong), Error);
}

} // namespace
} // namespace filum::skins
