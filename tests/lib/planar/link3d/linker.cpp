#include "../../trials.hpp"
#include "stacks.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace filum::link3d {

using namespace test;
TEST(Linker, ClimbsAPrismWithoutLayingAnythingBetween) {
    const auto regions = column(std::vector<std::vector<Curve>>(20, {comb({0, 0}, 8, 10)}));
    const auto r = link(regions);
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(r.counts.lifts, 19U);
    EXPECT_LT(r.counts.lift_length, 1e-5);
    EXPECT_TRUE(r.notes.empty());
    const double gap = cut_gap(regions[0].curves[0]);
    const Curve& c = regions[0].curves[0];
    const double around = length(c.points) + geom::distance(c.points.back(), c.points.front());
    EXPECT_NEAR(volume(r, false), 20 * (around - gap) * kWidth * kHeight, 1e-4);
}

// Layers that have nothing in common but their place: turned, moved, other curves.
TEST(Linker, ClimbsFromAnyCurveToAnyOther) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Random random{seed};
        std::vector<std::vector<Curve>> layers;
        for (int i = 0; i < 12; ++i) {
            const bool round = random() < 0.5;
            const Vec2 at{random(), random()};
            const double size = random(), rest = random();
            const Curve c = round ? rings(Vec2{4, 4} + at, 3 + size, 6 + static_cast<int>(2 * rest))
                                  : comb(Vec2{2, 2} + at, 4 + size, 12, 0.3 * rest);
            layers.push_back({random() < 0.5 ? c : refined(c, 0.3, random)});
        }
        const auto regions = column(layers);
        const auto r = link(regions);
        check(regions, r);
        EXPECT_EQ(r.counts.strokes, 1U);
    }
}

// A plate, then a pin on it far from where the plate was entered: a lane leads there, and costs no material.
TEST(Linker, LaysALaneWhenThePinIsFar) {
    for (const bool fine : {false, true}) {
        for (const std::uint32_t look_ahead : {1U, 2U, 16U}) {
            Random random{9};
            std::vector<std::vector<Curve>> layers(4, {comb({0, 0}, 20, 40)});
            layers.resize(7, {rings({17.3, 12.7}, 1, 2)});
            if (fine)
                for (auto& l : layers) l[0] = refined(l[0], 0.3, random);
            const auto regions = column(layers);
            Options options;
            options.look_ahead = look_ahead;
            options.seam = Seam::nearest;
            auto r = link(regions, options);
            check(regions, r);
            EXPECT_EQ(r.counts.strokes, 1U);
            if (look_ahead == 1) {
                EXPECT_EQ(r.counts.lanes, 1U);
            }
            if (look_ahead == 16) {
                EXPECT_EQ(r.counts.lanes, 0U) << "the stroke may begin below the pin";
            }
            double plain = 0;
            for (const auto& p : regions) {
                const auto& c = p.curves[0];
                for (std::size_t i = 0; i < c.points.size(); ++i) {
                    const std::size_t j = (i + 1) % c.points.size();
                    plain += geom::distance(c.points[i], c.points[j]) * (c.width_at(i) + c.width_at(j)) / 2 * kHeight;
                }
            }
            EXPECT_NEAR(volume(r, false), plain, 0.002 * plain);
        }
    }
}

// A band of two lanes, entered by a jog from one to the other: of the two ends that its bead can have one is shut in.
TEST(Linker, LeavesAStripOnTheSideThatIsOpen) {
    for (const std::size_t bands : {2U, 3U}) {
        std::vector<std::vector<Curve>> layers(bands, {{true, {{0, 0}, {20, 0}, {20, kWidth}, {0, kWidth}}, {kWidth}}});
        layers.push_back({rings({19, 0}, 1, 2)});
        Options options;
        options.look_ahead = 1;
        const auto r = link(column(layers), options);
        check(column(layers), r);
        EXPECT_EQ(r.counts.strokes, 1U) << bands;
        EXPECT_EQ(r.counts.lanes, 1U);
    }
}

// The column leans by more than a bead per layer: entries drift with it.
TEST(Linker, FollowsAColumnThatLeansAndShrinks) {
    std::vector<std::vector<Curve>> layers;
    for (int i = 0; i < 10; ++i) layers.push_back({comb({0.55 * i, 0.3 * i}, 12 - 0.9 * i, 24 - 2 * i)});
    const auto regions = column(layers);
    const auto r = link(regions);
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_TRUE(r.notes.empty());
}

// The nozzle stands at a corner of the curve as often as not: it leaves it across, not along a bead that begins there.
TEST(Linker, DriftsFromCornersAcrossBeadsOnly) {
    std::size_t drifted = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random{seed};
        const Curve disc = refined(rings({0, 0}, 4, 8), 0.6, random);
        std::vector<std::vector<Curve>> layers(12, {disc});
        layers.push_back({rings({3.3 * std::cos(seed), 3.3 * std::sin(seed)}, 0.4, 1)});
        const auto regions = column(layers);
        Options options;
        options.look_ahead = 11;
        const auto r = link(regions, options);
        check(regions, r);
        for (const auto& s : r.spans) {
            if (s.role != toolpath::Role::lift || s.points.back().z > 12.5 * kHeight) continue;
            const Vec2 a = s.points[s.points.size() - 2].xy(), b = s.points.back().xy();
            if (geom::distance(a, b) < kWidth / 8) continue;
            ++drifted;
            double off = 1e9;
            for (std::size_t i = 0; i < disc.points.size(); ++i)
                off = std::min(off,
                               geom::point_segment_distance(disc.points[i], disc.points[(i + 1) % disc.points.size()],
                                                            geom::lerp(a, b, 0.5)));
            EXPECT_GT(off, kWidth / 20) << seed;
        }
    }
    EXPECT_GT(drifted, 20U);
}

// A leaning column with teeth a few micrometres deep all round: a join that ends on one does not run through another.
TEST(Linker, CrossesNoFineTeeth) {
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(trials(40)); ++seed) {
        Random random{seed};
        std::vector<std::vector<Curve>> layers;
        for (int i = 0; i < 12; ++i) {
            Curve c{true, {}, {kWidth}};
            for (int k = 0; k < 1500; ++k) {
                const double angle = 2 * std::numbers::pi * (k + 0.8 * random()) / 1500;
                const double radius = 2 + (k % 2 == 0 ? 0 : 0.02 * random());
                c.points.push_back({0.5 * i + radius * std::cos(angle), 0.3 * i + radius * std::sin(angle)});
            }
            layers.push_back({c});
        }
        const auto regions = column(layers);
        const auto r = link(regions);
        EXPECT_EQ(crossings(r.spans), 0U) << seed;
    }
}

TEST(Linker, BreaksWhereThereIsNoWay) {
    auto regions = column({{comb({0, 0}, 8, 10)}, {comb({20, 0}, 8, 10)}, {}, {comb({20, 0}, 8, 10)}});
    const auto r = link(regions);
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 3U);
    EXPECT_EQ(r.counts.broken, 2U);
    std::map<std::string, std::uint64_t> notes;
    for (const auto& n : r.notes) notes[code_name(n)] += n.count;
    EXPECT_EQ(notes["join-out-of-reach"], 1U);
    EXPECT_EQ(notes["join-no-bead"], 1U);
    EXPECT_EQ(notes["region-without-bead"], 1U);
    EXPECT_EQ(notes["strokes-more"], 1U);
    EXPECT_EQ(r.counts.planned, 1U);
}

TEST(Linker, JoinsRingsOfARegionButNotBeyondReach) {
    std::vector<Curve> nested;
    for (int k = 0; k < 8; ++k) nested.push_back(circle({0, 0}, 4 - k * kWidth, 120));
    auto regions = column({nested, nested});
    regions.push_back(region(2, 2, Join::vertical, {circle({0, 0}, 4, 90), circle({0, 0}, 2, 60)}));
    auto r = link(regions);
    check(regions, r);
    EXPECT_EQ(r.counts.jogs, 14U);
    EXPECT_GE(r.counts.breaks, 1U);
    Options none;
    none.reach = 0;
    r = link(regions, none);
    check(regions, r);
    EXPECT_EQ(r.counts.jogs, 0U);
    EXPECT_EQ(r.counts.strokes, 18U - r.counts.lifts) << "a lift straight up needs no reach";
}

TEST(Linker, EntersOpenLinesAtTheirEnds) {
    std::vector<Curve> lines;
    for (int k = 0; k < 20; ++k) lines.push_back({false, {{0, k * kWidth}, {10, k * kWidth}}, {kWidth}});
    const auto regions = column({lines, lines});
    const auto r = link(regions);
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(r.counts.jogs, 38U);
    EXPECT_NEAR(volume(r, true), 2 * 20 * 10 * kWidth * kHeight, 1e-6);
}

// Meanders begun where the one below ended: whichever end is nearer to the corner, the stroke begins at the one that
// leads on.
TEST(Linker, ClimbsOpenCurvesFromEndToEnd) {
    const Curve up{false, {{0, 0}, {10, 0}, {10, 5}, {0, 5}, {0, 10}, {10, 10}}, {0.4}};
    Curve down = up;
    std::reverse(down.points.begin(), down.points.end());
    for (const auto& layers : {std::vector<Curve>{up, down, up, down}, std::vector<Curve>{down, up, down, up}}) {
        std::vector<std::vector<Curve>> curves;
        for (const auto& c : layers) curves.push_back({c});
        const auto regions = column(curves);
        const Result r = link(regions);
        check(regions, r);
        EXPECT_EQ(r.counts.breaks, 0U);
        EXPECT_EQ(r.counts.lifts, 3U);
    }
    // only one end leads on: above its far end stands a post
    const Curve post{false, {{10, 10}, {10, 9}}, {0.4}};
    for (const bool turned : {false, true}) {
        const auto regions = column({{turned ? down : up}, {post}});
        const Result r = link(regions);
        check(regions, r);
        EXPECT_EQ(r.counts.breaks, 0U) << turned;
        EXPECT_EQ(r.spans.front().points.front().xy(), (Vec2{0, 0}));
    }
    const Curve near{false, {{0, 0}, {1, 0}}, {0.4}};
    for (const bool turned : {false, true}) {
        const Result r = link(column({{turned ? down : up}, {near}}));
        EXPECT_EQ(r.counts.breaks, 0U) << turned;
        EXPECT_EQ(r.spans.front().points.front().xy(), (Vec2{10, 10}));
    }
}

// An open curve can hide the nearest place of another: it is entered at its ends only.
TEST(Linker, ClimbsAcrossNoOpenCurve) {
    const Curve below{false, {{0, 5}, {5, 5}}, {kWidth}};
    const Curve wall{false, {{5.1, 0}, {5.1, 10}}, {kWidth}};
    const auto square = [](double x, double y) {
        return Curve{true, {{x, y}, {x + 3, y}, {x + 3, y + 3}, {x, y + 3}}, {kWidth}};
    };
    const Curve behind = square(5.25, 3.5), before = square(1.9, 5.3);
    const auto told = [](const Result& r) {
        return std::count_if(r.notes.begin(), r.notes.end(),
                             [](const Note& n) { return n.code == NoteCode::jog_crosses_bead; });
    };
    const Result r = link(column({{below}, {wall, behind, before}}));
    EXPECT_EQ(told(r), 0);
    EXPECT_EQ(r.spans[1].role, Role::lift);
    EXPECT_NEAR(r.spans[1].points.back().y, 5.3, 1e-9) << "the square that nothing hides";
    EXPECT_EQ(told(link(column({{below}, {wall, behind}}))), 1) << "nothing else is in reach";
}

// The nozzle comes up 4 um beside a bead that lies across the jog: the bead gives way.
TEST(Linker, ClimbsAcrossNoBeadNextToItsEnd) {
    const Curve below{false, {{0, 0.004}, {5, 0.004}}, {kWidth}};
    const Curve across{false, {{2, 0}, {8, 0}}, {kWidth}}, behind{false, {{5, -0.3}, {5, -3}}, {kWidth}};
    const Result r = link(column({{below}, {across, behind}}));
    EXPECT_EQ(crossings(r.spans), 0U);
    EXPECT_TRUE(std::none_of(r.notes.begin(), r.notes.end(),
                             [](const Note& n) { return n.code == NoteCode::jog_crosses_bead; }));
    ASSERT_EQ(r.spans[1].role, Role::lift);
    EXPECT_EQ(r.spans[1].points.front(), r.spans[0].points.back());
    EXPECT_EQ(r.spans[1].points.back().xy(), (Vec2{5, -0.3}));
    double most = 0;
    for (const auto& p : r.spans.back().points)
        most = std::max(most, std::min(geom::distance(p.xy(), {2, 0}), geom::distance(p.xy(), {8, 0})));
    EXPECT_GT(most, 0);
    EXPECT_LE(most, 0.0101);
}

TEST(Linker, TravelsOverWhatIsPrinted) {
    std::vector<RegionPaths> regions;
    const auto add = [&](double x, std::uint32_t layer, Join join) {
        regions.push_back(region(static_cast<std::uint32_t>(regions.size()), layer, join, {comb({x, 0}, 4, 8)}));
    };
    for (std::uint32_t i = 0; i < 3; ++i) add(0, i, i == 0 ? Join::start : Join::vertical);
    for (std::uint32_t i = 0; i < 30; ++i) add(10, i, i == 0 ? Join::start : Join::vertical);
    for (std::uint32_t i = 0; i < 3; ++i) add(60, i, i == 0 ? Join::start : Join::vertical);
    add(0, 3, Join::start);
    const auto r = link(regions);
    check(regions, r);
    ASSERT_EQ(r.counts.breaks, 3U);
    std::vector<double> highest;
    for (const auto& s : r.spans) {
        if (s.role != Role::travel) continue;
        highest.push_back(0);
        for (const auto& p : s.points) highest.back() = std::max(highest.back(), p.z);
        for (std::size_t i = 0; i + 1 < s.points.size(); ++i)
            EXPECT_TRUE(s.points[i].z == s.points[i + 1].z || s.points[i].xy() == s.points[i + 1].xy())
                << "upright or level";
    }
    EXPECT_NEAR(highest[0], 0.6, 1e-9) << "nothing is in the way";
    EXPECT_NEAR(highest[1], 6.0, 1e-9) << "from the top of the tall column";
    EXPECT_NEAR(highest[2], 6.0, 1e-9) << "over the tall column";
    Options none;
    none.head.none = true;
    double top = 0;
    for (const auto& s : link(regions, none).spans)
        if (s.role == Role::travel && s.stroke == 2)
            for (const auto& p : s.points) top = std::max(top, p.z);
    EXPECT_NEAR(top, 0.8, 1e-9) << "nothing can be in the way of no head";
}

// A region that breaks into pieces leaves bodies without an extent: they are nowhere.
TEST(PrintedBodies, IgnoresBodiesWithNothingInThem) {
    PrintedBodies printed;
    printed.begin();
    printed.begin();
    printed.add({{0, 0}, {1, 1}}, 0.4, 2);
    EXPECT_EQ(printed.bounds().hi, (Vec2{1, 1}));
    EXPECT_FALSE(printed.blocks({5, 5, 1}, {6, 6, 1}, 0.5, 0.1, false));
    EXPECT_TRUE(printed.blocks({-1, 0.5, 1}, {2, 0.5, 1}, 0.5, 0.1, false));
    EXPECT_FALSE(printed.blocks({-1, 0.5, 1}, {2, 0.5, 1}, 0.5, 0.1, true));
    EXPECT_EQ(travel(printed, {50, 50, 1}, {60, 60, 1.5}, {}).size(), 3U);
}

// The head touches the side of a bead, half a width beside its middle line, for any place, width and height.
TEST(PrintedBodies, AreAsWideAsTheirBeads) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(0, 1);
    const machine::Head head;
    for (int trial = 0; trial < 1000; ++trial) {
        const double width = 0.1 + 2 * any(random), up = 0.01 + 0.99 * any(random) * head.cone_height;
        const double near = width / 2 + head.cone_radius(up), side = 20 * any(random) - 10;
        for (const bool connector : {false, true}) {
            PrintedBodies printed;
            const std::array<Vec3, 2> line{{{-5, side, up}, {5, side, up}}};
            if (connector) {
                printed.connector(line, width);
            } else {
                printed.begin();
                printed.add({line[0].xy(), line[1].xy()}, width, up);
            }
            EXPECT_DOUBLE_EQ(printed.widest(), width);
            for (const double sign : {-1.0, 1.0}) {
                const double touching = side + sign * (near - 1e-3), clear = side + sign * (near + 1e-3);
                EXPECT_TRUE(printed.hits({-9, touching, 0}, {9, touching, 0}, head)) << width << " " << up;
                EXPECT_FALSE(printed.hits({-9, clear, 0}, {9, clear, 0}, head)) << width << " " << up;
            }
        }
    }
}

TEST(Linker, TakesNothingAndOddThings) {
    EXPECT_TRUE(link({}).spans.empty());
    const Curve dot{true, {{1, 1}, {1, 1}}, {kWidth}}, flat{true, {{0, 0}, {1, 0}}, {kWidth}};
    const Curve line{false, {{2, 2}, {2, 2}}, {kWidth}};
    const auto r = link(column({{dot}, {flat}, {line}, {dot, flat, line}, {circle({0, 0}, 0.01, 3)}}));
    for (std::size_t i = 1; i < r.spans.size(); ++i) EXPECT_EQ(r.spans[i].points.front(), r.spans[i - 1].points.back());
    for (const auto& s : r.spans)
        for (const auto& p : s.points) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

// A ring about a square: the stroke goes on from the one to the other.
TEST(Linker, GoesOnFromABrimToItsRegion) {
    const auto square = [](double r) { return Curve{true, {{-r, -r}, {r, -r}, {r, r}, {-r, r}}, {kWidth}}; };
    const double w = kWidth;
    std::vector<RegionPaths> regions{region(0, 0, Join::start, {square(3)}),
                                     region(1, 0, Join::beside, {square(3 - w)}),
                                     region(2, 1, Join::vertical, {square(3 - w)})};
    const Result r = link(regions);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(r.counts.planned, 1U);
    EXPECT_EQ(r.counts.brims, 1U);
    EXPECT_TRUE(r.notes.empty());
    ASSERT_GE(r.spans.size(), 4U);
    EXPECT_EQ(r.spans[1].role, Role::jog);
    EXPECT_NEAR(geom::length(r.spans[1].points), w, 0.3 * w);
    regions[1].curves = regions[2].curves = {square(3 - 3 * w)};
    const Result far = link(regions);
    EXPECT_EQ(far.counts.brims, 0U);
    EXPECT_EQ(far.counts.strokes, 2U);
    ASSERT_FALSE(far.notes.empty());
    EXPECT_EQ(far.notes[0].code, NoteCode::join_brim);
}

} // namespace filum::link3d
