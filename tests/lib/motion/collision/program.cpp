#include "collision/program.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"
#include "kinematics/chain.hpp"

#include <gtest/gtest.h>

namespace {

using namespace filum;
using namespace filum::collision;

using geom::kDegree;

machine::Profile plain() {
    machine::Profile p;
    p.name = "plain";
    p.extrusion.relative = true;
    return p;
}

machine::Profile trunnion(machine::Numbers numbers) {
    machine::Profile p = plain();
    p.extrusion.letter = 'B';
    p.axes.chain.carrier = kinematics::Carrier::table_table;
    p.axes.chain.tilt_axis = {1, 0, 0};
    p.axes.chain.tilt_point = {0, 20, 10};
    p.axes.tilt_letter = 'A';
    p.axes.turn_letter = 'C';
    p.axes.numbers = numbers;
    p.axes.tcp_on = "M428";
    p.axes.tcp_off = "M429";
    return p;
}

Program read(const std::string& text, const machine::Profile& p = plain(), ProgramOptions o = {0.4, 0.2, {}}) {
    return read_program(text, "'part.ngc'", p, o);
}

std::string refusal(const std::string& text, ProgramOptions o = {0.4, 0.2, {}}) {
    try {
        read(text, plain(), o);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        return e.what();
    }
    return "";
}

TEST(Program, ToolsHaveTheirOwnCodesAndPlaces) {
    for (const std::string axes : {"", "[kinematics]\ncarrier = \"head-table\"\ntip_to_tilt_z = 50\n"}) {
        const auto p =
            machine::parse_profile("name = \"two\"\n[bed]\nx = [-9, 9]\ny = [-9, 9]\nz = [0, 9]\n[extrusion]\nkind = "
                                   "\"valve\"\non = \"M760\"\n"
                                   "off = \"M761\"\n" +
                                       axes +
                                       "[tools]\nfirst = 1\n[tool.0]\nchange = \"M751\"\n[tool.1]\n"
                                       "change = \"G0 Z{z_park}\\nM106 S0\\nT{tool_no}\"\noffset = [30, 0, 1]\n"
                                       "extrusion.on = \"M762\\nG4 P100\"\nextrusion.off = \"M763\"\n",
                                   "two.toml");
        const Program r =
            read("G90\nG0 X0 Y0 Z1 \nM760\nG1 X5\nM761\nG0 Z5\nM106 S0\nT2\nG0 X0 Y0 Z4\nM760\nG1 X1\nM762\n"
                 "G4 P100\nG1 X5\nM763\nM751\nG0 X0 Y0 Z1\nM762\nG1 X9\n",
                 p);
        ASSERT_EQ(r.moves.size(), 5U);
        EXPECT_EQ(r.unknown, 3U); // the first, and those behind changes of the tool
        const bool lays[] = {true, false, false, true, false};
        const std::uint32_t tools[] = {0, 0, 1, 1, 0};
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_EQ(r.moves[i].travel, !lays[i]) << i;
            EXPECT_EQ(r.moves[i].tool, tools[i]) << i;
        }
        EXPECT_LT(distance(r.moves[3].to.tip, {35, 0, 5}), 1e-9);
    }
}

TEST(Program, ModalMovesAndBeads) {
    const Program p =
        read("%\n(a comment)\nN10 G21 G90 ; another\nG0 Z5\nG0X0Y0\nG1 Z.2\nX10 E1\n\nG1 Y10 (in between) E+1\n"
             "G1 E-1\nG0 x 0 y 0\nM104 S200\nM92 X80\nG92 E0\nG1 X1 E.1\nM2\n");
    EXPECT_EQ(p.lines, 7U);
    EXPECT_EQ(p.unknown, 2U); // Z alone, and then from an unknown place
    EXPECT_EQ(p.ignored, 6U);
    ASSERT_EQ(p.moves.size(), 5U);
    EXPECT_EQ(p.moves[0].to.tip, (Vec3{0, 0, 0.2}));
    EXPECT_EQ(p.moves[1].source, 7U);
    EXPECT_EQ(p.moves[2].to.tip, (Vec3{10, 10, 0.2}));
    EXPECT_TRUE(p.moves[3].travel);
    EXPECT_FALSE(p.moves[4].travel);
    EXPECT_EQ(p.beads.size(), 3U);
}

TEST(Program, AbsoluteExtruderAndItsZero) {
    machine::Profile absolute = plain();
    absolute.extrusion.relative = false;
    EXPECT_EQ(read("G1 X0 Y0 Z0 E5\nX1 E5\nX2 E6\nG92 E0\nX3 E0.5\nX4 E0.2\n", absolute).beads.size(), 2U);
    EXPECT_EQ(read("M83\nG1 X0 Y0 Z0 E5\nX1 E5\nX2 E6\n", absolute).beads.size(), 2U);
}

TEST(Program, AValveOpensAndCloses) {
    machine::Profile valve = plain();
    valve.extrusion.feeding = machine::Feeding::valve;
    valve.extrusion.on = "M64 P0";
    valve.extrusion.off = "M65 P0";
    EXPECT_EQ(read("G0 X0 Y0 Z0\nG1 X1\nM64 P0\nX2\nX3\nM65 P0\nX4\n", valve).beads.size(), 2U);
}

// Behind the anchor nothing feeds a fibre that the nozzle pulls: its codes tell where it lies.
TEST(Program, AFibreLiesBetweenItsCodes) {
    machine::Profile fibre = plain();
    fibre.fibre.on = "M64 P1";
    fibre.fibre.off = "M65 P1";
    const std::string text = "G0 X0 Y0 Z0\nM64 P1\nG1 X2 E1\nG1 X4\nG1 X6\nM65 P1\nG1 X8\n";
    EXPECT_EQ(read(text, fibre).beads.size(), 1U) << "no fibre head";
    fibre.fibre.cut_to_nozzle = 45;
    EXPECT_EQ(read(text, fibre).beads.size(), 3U);
}

TEST(Program, BeadsAsTheCommentsSay) {
    const Program p = read(";WIDTH:0.8\n;HEIGHT:0.3\nG1 X0 Y0 Z1\nX5 E1\n(WIDTH:0.5)\nX9 E1\n", plain(), {});
    ASSERT_EQ(p.beads.size(), 2U);
    EXPECT_DOUBLE_EQ(p.beads[0].radius, 0.15);
    EXPECT_DOUBLE_EQ(std::abs(p.beads[0].corner[0].y), 0.25);
    EXPECT_DOUBLE_EQ(std::abs(p.beads[1].corner[0].y), 0.1);
}

TEST(Program, ShiftMovesAll) {
    const Program p = read("G1 X0 Y0 Z0\nX5\n", plain(), {0.4, 0.2, {1, 2, 3}});
    EXPECT_EQ(p.moves[0].to.tip, (Vec3{6, 2, 3}));
}

TEST(Program, RefusesWhatItCannotFollow) {
    EXPECT_NE(refusal("G1 X0 Y0 Z0\nG2 X5 I2\n").find("line 2"), std::string::npos);
    for (const char* bad :
         {"G20", "G91", "G53 G0 X0", "G92 X0", "X5", "G1 X", "G1 Xnan", "G1 X1000000000", "G", "G1 X1..2"})
        EXPECT_NE(refusal(bad).find("line 1"), std::string::npos) << bad;
    EXPECT_NE(refusal("G1 X0 Y0 Z0\nX5 E1\n", {}).find("--bead"), std::string::npos);
    EXPECT_EQ(read("").moves.size(), 0U);
    EXPECT_EQ(read("START_PRINT BED=60\n").ignored, 1U);
    EXPECT_EQ(read("G1 X0 Y0 Z0\nG28\nX1\nG1 Y2 Z2\nX2\n").unknown, 3U);
}

// The same poses from numbers of the tip and from those of the axes.
TEST(Program, TipAndJointsAreTheSameWay) {
    const machine::Profile tip = trunnion(machine::Numbers::tip), joints = trunnion(machine::Numbers::joints);
    std::string one = "M428\n", other;
    for (int i = 0; i <= 4; ++i) {
        const double tilt = -10.0 * i, turn = 3.0 * i;
        const Vec3 p{2.0 * i, 1, 3};
        const auto j = kinematics::place(tip.axes.chain, p, tilt * kDegree, turn * kDegree);
        const auto words = [&](const Vec3& v) {
            return "G1 X" + std::to_string(v.x) + " Y" + std::to_string(v.y) + " Z" + std::to_string(v.z) + " A" +
                   std::to_string(tilt) + " C" + std::to_string(turn) + "\n";
        };
        one += words(p);
        other += words(j.xyz);
    }
    one += "M429\nG1 X0\n"; // now a number of the axes
    const Program a = read(one, tip), b = read(other, joints);
    EXPECT_GT(a.moves.size(), 20U); // cut while the axes turn
    const auto last = [](const Program& p, std::uint32_t line) {
        ToolFrame out;
        for (const Move& m : p.moves)
            if (m.source == line) out = m.to;
        return out;
    };
    for (std::uint32_t i = 2; i <= 5; ++i) {
        const ToolFrame x = last(a, i + 1), y = last(b, i);
        EXPECT_LT(distance(x.tip, y.tip), 1e-5);
        EXPECT_LT(distance(x.axis, y.axis), 1e-5);
        EXPECT_LT(distance(x.side, y.side), 1e-5);
        EXPECT_NEAR(dot(x.axis, x.side), 0, 1e-12);
    }
    for (const Program* p : {&a, &b})
        for (std::size_t i = 1; i < p->moves.size(); ++i)
            EXPECT_LT(distance(p->moves[i].from.tip, p->moves[i - 1].to.tip), 1e-9);
    // after M429 the X axis moves alone: the tip goes along what is machine x in the part's frame
    const Vec3 way = a.moves.back().to.tip - a.moves.back().from.tip;
    EXPECT_NEAR(std::abs(dot(way, a.moves.back().from.side)), norm(way), 1e-9);
}

// Joints that turn far: their tip runs on an arc, which the pieces follow.
TEST(Program, JointsRunOnArcs) {
    const machine::Profile p = trunnion(machine::Numbers::joints);
    const Program q = read("G1 X30 Y0 Z0 A0 C0\nG0 C90\n", p);
    ASSERT_GT(q.moves.size(), 40U);
    for (const Move& m : q.moves) {
        EXPECT_NEAR(norm(m.to.tip), 30, 1e-9);
        EXPECT_NEAR(norm(at(m, 0.5).tip), 30, 0.0021);
    }
}

} // namespace
