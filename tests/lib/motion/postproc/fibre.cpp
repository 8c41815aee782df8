// Fibre strokes: cut where the tail needs it, for any path and machine; none is too short.
#include "fibre.hpp"
#include "base/error.hpp"
#include "postproc/job.hpp"

#include <random>

namespace filum::postproc {
namespace {

// Corners, long and short moves, moves of no length, back on itself, up and down; closed for odd seeds.
std::vector<Vec3> random_path(unsigned seed) {
    std::mt19937 gen(seed);
    const auto uniform = [&gen](double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(gen()) / 4294967296.0);
    };
    std::vector<Vec3> out{{uniform(-90, 90), uniform(-90, 90), 20}};
    while (length(out) < 60) {
        const double step = std::pow(10.0, uniform(-4, 2));
        const Vec3 to = out.back() + Vec3{uniform(-step, step), uniform(-step, step), uniform(-0.1, 0.1) * step};
        out.push_back(gen() % 8 == 0 ? out.back() : gen() % 8 == 1 && out.size() > 1 ? out[out.size() - 2] : to);
    }
    if (seed % 2 == 1) out.push_back(out.front());
    return out;
}

TEST(Fibre, TheCutComesAsFarBeforeTheEndAsTheCutterIs) {
    for (const char* mode : {"mode = \"pull\"\n", "mode = \"push\"\nratio = 1.1\n", "anchor = 30\n"}) {
        const auto p = profile(mode);
        const std::vector<std::vector<Vec3>> paths{
            {{0, 0, 0.2}, {300, 0, 0.2}},                                                        // one long move
            {{0, 0, 0.2}, {30, 0, 0.2}, {30, 30, 0.2}, {0, 30, 0.2}, {0, 0, 0.2}},               // closed
            {{0, 0, 0.2}, {10, 0, 0.2}, {10, 10, 0.2}, {0, 10, 0.2}, {0, 45, 0.2}},              // a corner 35 off
            {{0, 0, 0.2}, {55, 0, 0.2}, {100, 0, 0.2}},                                          // at a point
            {{0, 0, 0.2}, {55.0005, 0, 0.2}, {100, 0, 0.2}},                                     // nearly at one
            {{0, 0, 0.2}, {kCut, 0, 0.2}},                                                       // nothing but tail
            {{0, 0, 0.2}, {0, 0, 0.2}, {50, 0, 0.2}, {50, 0, 0.2}, {50, 0, 0.2}, {90, 0, 0.2}}}; // points twice
        for (const auto& path : paths) {
            const auto seen = walk(p, {fibre(path)});
            ASSERT_EQ(seen.strokes.size(), 1U);
            expect_rules(p, seen.strokes[0], length(path));
        }
        for (unsigned seed = 0; seed < 60; ++seed) {
            const auto path = random_path(seed);
            const auto seen = walk(p, {fibre(path)});
            ASSERT_EQ(seen.strokes.size(), 1U) << seed;
            // Points nearer to each other than any move may be are no points of the program.
            expect_rules(p, seen.strokes[0], length(path), 0.01);
        }
    }
}

TEST(Fibre, AStrokeOfSeveralSpansIsOneAndATravelEndsIt) {
    const auto p = profile();
    const auto one = walk(p, {fibre({{0, 0, 0}, {30, 0, 0}}), fibre({{30, 0, 0}, {60, 0, 0}}, 1)});
    ASSERT_EQ(one.strokes.size(), 1U);
    expect_rules(p, one.strokes[0], 60);
    const auto two =
        walk(p, {fibre({{0, 0, 0}, {60, 0, 0}}), travel({60, 0, 0}, {60, 1, 0}), fibre({{60, 1, 0}, {-40, 1, 0}})});
    ASSERT_EQ(two.strokes.size(), 2U);
    expect_rules(p, two.strokes[0], 60);
    expect_rules(p, two.strokes[1], 100);
}

TEST(Fibre, StrokesThatAreTooShortAreLeftOutAndTold) {
    const auto p = profile();
    const std::vector<Span> spans{fibre({{0, 0, 0}, {60, 0, 0}}), travel({60, 0, 0}, {0, 9, 0}),
                                  fibre({{0, 9, 0}, {44.9, 9, 0}}), travel({44.9, 9, 0}, {0, 20, 0}),
                                  fibre({{0, 20, 0}, {50, 20, 0}})};
    const auto seen = walk(p, spans);
    ASSERT_EQ(seen.strokes.size(), 2U);
    ASSERT_EQ(seen.omitted.size(), 1U);
    EXPECT_NEAR(seen.omitted[0].length, 44.9, 1e-9);
    for (const Step& s : seen.steps)
        if (s.act == Act::extrude) {
            EXPECT_NE(s.to.y, 9);
        }
    try {
        (void)measured(p, spans);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::failure);
        EXPECT_EQ(std::string(e.what()),
                  "cannot lay 1 fibre stroke below the 45 mm of fibre.least_path: the shortest, 44.9 mm, begins on "
                  "layer 0 at x 0, y 9, z 0 of the toolpath; join or lengthen them before postproc, or leave them out "
                  "by --short drop");
    }
    auto lenient = p;
    lenient.fibre.omit_short = true;
    const FirstPass first_pass = measured(lenient, spans);
    const auto notes = omissions(first_pass);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].count, 1U);
    EXPECT_NEAR(notes[0].amount, 44.9, 1e-9);
    EXPECT_EQ(notes[0].y, 9);
    EXPECT_NEAR(first_pass.tools.at(1).path_len, 110, 1e-9);
    EXPECT_NEAR(first_pass.tools.at(1).fibre_len, 110 + 2 * 7, 1e-9);
    EXPECT_EQ(first_pass.tools.at(1).cuts, 2U);
}

// The first and the last one, one beside plastic without a travel: no move goes where they would have been.
TEST(Fibre, LeftOutStrokesAtEitherEndLeaveNoWayToThem) {
    auto p = profile();
    Span plastic{Role::bead, 0, 0, 0, {{10, 0, 0}, {20, 0, 0}}, {1}, {0.2}, {}};
    const auto seen = walk(p, {fibre({{0, 0, 0}, {10, 0, 0}}), plastic, travel({20, 0, 0}, {200, 0, 0}),
                               fibre({{200, 0, 0}, {210, 0, 0}}), travel({210, 0, 0}, {90, 0, 0})});
    EXPECT_EQ(seen.omitted.size(), 2U);
    for (const Step& s : seen.steps)
        if (s.act == Act::travel || s.act == Act::climb || s.act == Act::extrude) {
            EXPECT_GE(s.to.x, 10);
            EXPECT_LE(s.to.x, 20);
        }
}

TEST(Fibre, TooLongAStrokeAndTooSmallASpoolAreErrors) {
    const auto failure = [](const machine::Profile& p) -> std::string {
        try {
            (void)measured(p, {fibre({{0, 0, 0}, {200, 0, 0}})});
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_EQ(failure(profile()), "");
    EXPECT_NE(failure(profile("most_path = 150\n")).find("200"), std::string::npos);
    EXPECT_NE(failure(profile("spool = 206\n")).find("207"), std::string::npos); // 7 of it pushed into the air
    EXPECT_EQ(failure(profile("spool = 208\n")), "");
}

} // namespace
} // namespace filum::postproc
