#include "collision/check.hpp"

#include "collision/beads.hpp"
#include "collision/report.hpp"

#include "geom/angle.hpp"
#include "walls.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace filum;
using namespace filum::collision;

using geom::kDegree;
using walls::triangle;
using walls::wall;
const double kCos30 = std::cos(30 * kDegree);

Scene scene(std::vector<Solid> part, std::vector<Solid> beads = {}) {
    return {Tree(std::move(beads)), Tree(std::move(part)), Tree({}), Tree({})};
}

Move move(const Vec3& from, const Vec3& to) { return {{from}, {to}, 0, 0, 0, 0, false}; }

CheckResult run(const Scene& s, const machine::Head& head, const std::vector<Move>& moves, Options o = {}) {
    return check(s, head, moves, o, 1);
}

double part_clearance(const CheckResult& f) {
    const auto& least = f.least[static_cast<std::size_t>(Obstacle::part)];
    return least ? least->clearance : std::numeric_limits<double>::infinity();
}

TEST(Check, AWallBesideThePath) {
    const std::vector<Move> along{move({0, -10, 0}, {0, 10, 0})};
    // Below the carriage: from its top edge across to the cone.
    const CheckResult low = run(scene(wall(6, 5)), {}, along);
    EXPECT_NEAR(part_clearance(low), (6 - 0.2 - 5 * std::tan(30 * kDegree)) * kCos30, 1e-6);
    EXPECT_TRUE(low.collisions.empty());
    EXPECT_EQ(low.least[1]->piece, HeadPiece::nozzle);
    // Above its underside: to the box.
    EXPECT_NEAR(part_clearance(run(scene(wall(23, 50)), {}, along)), 3, 1e-6);
    const CheckResult hit = run(scene(wall(19, 50)), {}, along);
    EXPECT_EQ(hit.moves, 1U);
    ASSERT_EQ(hit.collisions.size(), 1U);
    EXPECT_EQ(hit.collisions[0].piece, HeadPiece::carriage);
    EXPECT_EQ(hit.collisions[0].against, Obstacle::part);
    // What does not rise above the tip does not count.
    EXPECT_FALSE(run(scene(wall(0.1, 0)), {}, along).least[1]);
    EXPECT_EQ(run(scene(wall(23, 50)), {}, along, {.margin = 3.1}).moves, 1U);
    EXPECT_EQ(run(scene(wall(23, 50)), {}, along, {.margin = 2.9}).moves, 0U);
}

TEST(Check, ABoxThatIsTurnedIsWider) {
    auto turned = move({0, -10, 0}, {0, 10, 0}), unknown = turned;
    turned.from.side = turned.to.side = {std::sqrt(0.5), std::sqrt(0.5), 0};
    unknown.from.side = unknown.to.side = {};
    for (const Move& m : {turned, unknown})
        EXPECT_NEAR(part_clearance(run(scene(wall(30, 50)), {}, {m})), 30 - std::hypot(20, 20), 1e-6);
}

// The tool leans by `lean` above the bed, the tip `t` above it: the bed rises above the tip's plane t / sin(lean) away,
// and leaves the side of the nozzle, steeper than it, from there on.
TEST(Check, ALeaningToolAboveTheBed) {
    machine::Head head;
    head.carriage_x = head.carriage_y = 0;
    head.cone_height = 60;
    const Scene s{Tree({}), Tree({}), Tree({}), Tree(bed({move({-10, -10, 0}, {10, 10, 0})}))};
    for (const double lean : {10.0, 30.0, 50.0}) {
        Move m = move({-5, 0, 1}, {5, 0, 1});
        m.from.axis = m.to.axis = {std::sin(lean * kDegree), 0, std::cos(lean * kDegree)};
        const CheckResult f = check(s, head, {m}, {.press = 0}, 1);
        ASSERT_TRUE(f.least[3]) << lean;
        EXPECT_NEAR(f.least[3]->clearance, (1 / std::sin(lean * kDegree) - 0.2) * kCos30, 1e-6) << lean;
    }
    Move down = move({-5, 0, 1}, {5, 0, 1}); // steeper than the side of the nozzle
    down.from.axis = down.to.axis = {std::sin(65 * kDegree), 0, std::cos(65 * kDegree)};
    EXPECT_EQ(check(s, head, {down}, {}, 1).moves, 1U);
}

// A pin that only the middle of a long move comes near to, or of a turn.
TEST(Check, LooksBetweenTheEnds) {
    const auto pin = [](double x, double y, double top) {
        return std::vector<Solid>{triangle({x, y, -1}, {x, y + 1e-3, -1}, {x, y, top})};
    };
    const double want = (3 - 0.2 - 2 * std::tan(30 * kDegree)) * kCos30;
    for (const double step : {2.0, 0.5, 0.05}) {
        const double got =
            part_clearance(run(scene(pin(3, 7.3, 2)), {}, {move({0, -100, 0}, {0, 60, 0})}, {.step = step}));
        EXPECT_GE(got, want - 1e-6);
        EXPECT_LE(got, want + step / 2);
    }
    machine::Head needle{0.1, 0, 50, 0, 0, std::numeric_limits<double>::infinity(), false};
    Move swing = move({0, 0, 0}, {0, 0, 0});
    swing.from.axis = {-1, 0, 0}, swing.to.axis = {0.6, 0, 0.8};
    EXPECT_EQ(run(scene(pin(0, -0.05, 40)), needle, {swing}).moves, 1U);
    EXPECT_EQ(run(scene(pin(0, 5, 40)), needle, {swing}).moves, 0U);
    EXPECT_NEAR(part_clearance(run(scene(pin(0, 5, 40)), needle, {swing}, {.step = 0.01})), 4.9, 0.005);
}

struct Random {
    std::mt19937 engine{11};
    double operator()(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine); }
    Vec3 place(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
    Vec3 axis() {
        const Vec3 v{(*this)(-1, 1), (*this)(-1, 1), (*this)(0.1, 1)};
        return (1 / norm(v)) * v;
    }
};

// Against a fine sampling of all moves, without any of the bounds.
TEST(Check, RandomMovesAgreeWithSampling) {
    Random random;
    machine::Head head;
    head.carriage_x = head.carriage_y = 6;
    for (int trial = 0; trial < 8; ++trial) {
        std::vector<Solid> part, beads;
        for (int i = 0; i < 40; ++i) {
            const Vec3 a = random.place(60);
            part.push_back(triangle(a, a + random.place(3), a + random.place(3)));
            beads.push_back(bead({random.place(60), random.axis()}, {random.place(60), random.axis()}, 1, 0.3,
                                 static_cast<std::uint32_t>(i)));
            beads.back().corner[2] = beads.back().corner[1] + random.place(2);
            beads.back().corner[3] = beads.back().corner[0] + random.place(2);
        }
        const Scene s = scene(part, beads);
        const Shape shape(head);
        for (int i = 0; i < 10; ++i) {
            Move m{{random.place(20), random.axis(), {}}, {random.place(20), random.axis(), {}}, 25, 0, 0, 0, false};
            const Options o{.step = 0.2};
            const CheckResult got = run(s, head, {m}, o);
            for (const std::size_t k : {0U, 1U}) {
                double least = 1e9;
                for (int n = 0; n <= 1000; ++n) {
                    Probe p{at(m, n / 1000.0), k == 0 ? 25U : 1U, o.press, least};
                    least = s[k].nearest(shape, p).distance;
                }
                const double clearance = got.least[k] ? got.least[k]->clearance : 1e9;
                if (least > 1e8) continue;
                EXPECT_LE(clearance, least + o.step / 2 + 1e-6);
                EXPECT_GE(clearance, std::min(0.0, least) - o.step / 2);
                EXPECT_GE(clearance, least - 0.2); // samples are so far apart
            }
        }
    }
}

// Along winding ways, turning, over hills of triangles and of beads that grow: what many moves together are known to
// be clear of, each of them alone is.
TEST(Check, ManyMovesAgreeWithEachAlone) {
    Random random;
    machine::Head head;
    head.carriage_x = head.carriage_y = 12;
    for (int trial = 0; trial < 6; ++trial) {
        std::vector<Solid> part;
        for (int i = 0; i < 200; ++i) {
            const Vec3 a = random.place(25) + Vec3{0, 0, 22};
            part.push_back(triangle(a, a + random.place(2), a + random.place(2)));
        }
        BeadGrowth growth(head);
        const bool turned = trial % 2 == 1, known = trial >= 4;
        const double tight = random(0.05, 0.3);
        ToolFrame here{random.place(8), {0, 0, 1}, known ? Vec3{1, 0, 0} : Vec3{}};
        for (int i = 0; i < 256; ++i) {
            const double t = tight * i, lean = turned ? 0.4 * std::sin(0.05 * i) : 0.0;
            ToolFrame next = here;
            next.tip = here.tip + Vec3{0.3 * std::cos(t), 0.3 * std::sin(t), turned ? 0.1 * std::sin(0.3 * i) : 0.002};
            next.axis = {0, std::sin(lean), std::cos(lean)};
            growth.add({here, next, 0, static_cast<std::uint32_t>(i), 0, 0, false}, 0.4, 0.2);
            here = next;
        }
        const Scene s = scene(part, growth.beads);
        const Options o{.step = 0.1};
        const CheckResult together = run(s, head, growth.moves, o);
        std::array<double, 2> alone{1e9, 1e9};
        std::size_t colliding = 0;
        for (const Move& m : growth.moves) {
            const CheckResult f = run(s, head, {m}, o);
            for (const std::size_t k : {0U, 1U})
                if (f.least[k]) alone[k] = std::min(alone[k], f.least[k]->clearance);
            colliding += f.moves;
        }
        EXPECT_EQ(together.moves, colliding) << trial;
        for (const std::size_t k : {0U, 1U}) {
            ASSERT_EQ(together.least[k].has_value(), alone[k] < 1e9) << trial;
            if (!together.least[k]) continue;
            EXPECT_NEAR(together.least[k]->clearance, alone[k], o.step / 2) << trial;
        }
    }
}

TEST(Check, TheSameForAnyNumberOfThreads) {
    Random random;
    std::vector<Solid> part;
    for (int i = 0; i < 300; ++i) {
        const Vec3 a = random.place(100);
        part.push_back(triangle(a, a + random.place(3), a + random.place(3)));
    }
    std::vector<Move> moves;
    ToolFrame here{random.place(80), random.axis(), {}};
    for (int i = 0; i < 9000; ++i) {
        const ToolFrame next{here.tip + random.place(0.5), here.axis, {}};
        moves.push_back({here, next, 0, static_cast<std::uint32_t>(i), 0, 0, false});
        here = next;
    }
    const Scene s = scene(part);
    const CheckResult one = check(s, {}, moves, {}, 1);
    for (const int threads : {2, 8}) {
        const CheckResult other = check(s, {}, moves, {}, threads);
        EXPECT_EQ(places({moves, one, {}}), places({moves, other, {}}));
        EXPECT_EQ(figures::text(summary({moves, one, {}}), figures::Format::json),
                  figures::text(summary({moves, other, {}}), figures::Format::json));
    }
}

TEST(Check, NothingToMeet) {
    EXPECT_TRUE(run(scene({}), {}, {}).collisions.empty());
    const std::vector<Move> moves{move({0, 0, 0}, {1, 0, 0}), move({1, 0, 0}, {1, 0, 0})};
    EXPECT_FALSE(run(scene({}), {}, moves).least[1]);
    EXPECT_FALSE(run(scene(wall(0, 50)), machine::Head{.none = true}, moves).least[1]);
    EXPECT_EQ(run(scene(wall(0, 50)), {}, moves).moves, 2U);
    // a triangle that is a point
    EXPECT_EQ(run(scene({triangle({0.5, 0, 1}, {0.5, 0, 1}, {0.5, 0, 1})}), {}, moves).moves, 2U);
}

TEST(Check, AxesThatTurnRound) {
    Move m = move({0, 0, 50}, {0, 0, 50});
    m.to.axis = {0, 0, -1};
    for (const double along : {0.0, 0.25, 0.5, 1.0}) EXPECT_NEAR(norm(at(m, along).axis), 1, 1e-12);
    EXPECT_NEAR(at(m, 0.5).axis.z, 0, 1e-9);
    EXPECT_EQ(run(scene(wall(0.5, 20)), {}, {m}).moves, 1U); // upside down it is there
}

} // namespace
