// Tool frames in three languages: read back they are the places and tool axes of the toolpath.
#include "postproc/robot.hpp"

#include "base/error.hpp"
#include "robots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <regex>

using namespace filum;
using geom::Vec3;
using Orientation = geom::Rotation;
using namespace robots;

namespace {

using std::numbers::pi;

Vec3 spun_by(const Vec3& v, const Vec3& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return c * v + s * cross(axis, v) + (1 - c) * dot(axis, v) * axis;
}

struct RobotRandom {
    std::mt19937 engine{11};
    double operator()(double lo, double hi) { return lo + (hi - lo) * static_cast<double>(engine()) / 4294967296.0; }
    Vec3 unit() {
        for (;;) {
            const Vec3 v{(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)};
            if (norm(v) > 0.1 && norm(v) < 1) return 1 / norm(v) * v;
        }
    }
};

void expect_same(const Orientation& a, const Orientation& b, double tolerance = 1e-7) {
    EXPECT_LT(distance(a.x, b.x), tolerance);
    EXPECT_LT(distance(a.y, b.y), tolerance);
    EXPECT_LT(distance(a.z, b.z), tolerance);
}

Orientation from_quaternion(const std::array<double, 4>& q) {
    const auto [w, x, y, z] = q;
    return {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
            {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
            {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

Orientation from_euler(double a, double b, double c) {
    const Vec3 x0{1, 0, 0}, y0{0, 1, 0}, z0{0, 0, 1};
    const Vec3 y1 = spun_by(y0, z0, a), x2 = spun_by(spun_by(x0, z0, a), y1, b);
    const auto all = [&](const Vec3& v) { return spun_by(spun_by(spun_by(v, z0, a), y1, b), x2, c); };
    return {all(x0), all(y0), all(z0)};
}

Orientation from_vector(const std::array<double, 3>& v) {
    const Vec3 r{v[0], v[1], v[2]};
    const double angle = norm(r);
    const Vec3 axis = angle > 0 ? 1 / angle * r : Vec3{0, 0, 1};
    return {spun_by({1, 0, 0}, axis, angle), spun_by({0, 1, 0}, axis, angle), spun_by({0, 0, 1}, axis, angle)};
}

// All numbers of every line that begins with `word`.
std::vector<std::vector<double>> numbers(const std::string& text, const std::string& word) {
    std::vector<std::vector<double>> out;
    const std::regex number("-?[0-9]+\\.?[0-9]*");
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (line.rfind(word, 0) != 0) continue;
        line = std::regex_replace(line, std::regex("E1 |9E9"), "");
        out.emplace_back();
        for (std::sregex_iterator i(line.begin(), line.end(), number), end; i != end; ++i)
            out.back().push_back(std::stod(i->str()));
    }
    return out;
}

// One frame to approach along the tool, 40 of the beads, one to leave.
void expect_arc(const std::vector<std::pair<Vec3, Orientation>>& frames, bool fixed = true) {
    const auto want = arc()[0];
    ASSERT_EQ(frames.size(), 42U);
    EXPECT_LT(distance(frames[0].first, want.points[0]), 1e-4);
    for (std::size_t i = 0; i < 40; ++i) {
        const auto& [tip, o] = frames[1 + i];
        EXPECT_LT(distance(tip, want.points[1 + i]), 1e-4);
        EXPECT_LT(distance(o.z, -1.0 * want.normals[1 + i]), 1e-5); // z out of the nozzle
        if (!fixed) continue;
        EXPECT_GT(o.x.x, 0);
        EXPECT_NEAR(o.x.y, 0, 1e-5);
    }
    const Vec3 off = frames[41].first - want.points.back();
    EXPECT_LT(norm(cross(off, want.normals.back())), 1e-4);
    EXPECT_GT(dot(off, want.normals.back()), 1);
}

} // namespace

TEST(Robot, OrientationsComeBackFromEveryForm) {
    RobotRandom random;
    for (int i = 0; i < 500; ++i) {
        Vec3 axis = random.unit(), heading = random.unit();
        if (i % 10 == 0) axis = i % 20 == 0 ? Vec3{0, 0, 1} : Vec3{0, 0, -1};
        if (i % 10 == 1) axis = {0, 1, 0}, heading = {0, 0, i % 20 == 1 ? 1.0 : -1.0}; // x straight up or down
        if (norm(cross(axis, heading)) < 0.05) continue;
        const auto o = postproc::orientation(axis, heading);
        EXPECT_LT(distance(cross(o.x, o.y), o.z), 1e-12);
        EXPECT_LT(distance(o.z, -1.0 * axis), 1e-12);
        EXPECT_GT(dot(o.x, heading), 0);
        expect_same(from_quaternion(geom::quaternion(o)), o);
        EXPECT_GE(geom::quaternion(o)[0], 0);
        const auto [a, b, c] = geom::euler_zyx(o);
        expect_same(from_euler(a, b, c), o);
        expect_same(from_vector(geom::rotation_vector(o)), o, 1e-6);
    }
}

TEST(Robot, KrlSaysPlacesAnglesAndTheExtruder) {
    const auto text = robot_program({});
    EXPECT_NE(text.find("$VEL.CP=0.02\n"), std::string::npos);
    std::vector<std::pair<Vec3, Orientation>> frames;
    double fed = 0;
    for (const auto& n : numbers(text, "LIN {")) {
        ASSERT_EQ(n.size(), 7U);
        const double d = pi / 180;
        frames.push_back({{n[0], n[1], n[2]}, from_euler(n[3] * d, n[4] * d, n[5] * d)});
        EXPECT_GE(n[6], fed);
        fed = n[6];
    }
    expect_arc(frames);
    EXPECT_EQ(numbers(text, "LIN {")[0][6], 0); // the extruder does not turn back on the way to the part
    double length = 0;
    const auto want = arc()[0].points;
    for (std::size_t i = 1; i < want.size(); ++i) length += distance(want[i - 1], want[i]);
    EXPECT_NEAR(fed, length * 0.2 / (pi * 1.75 * 1.75 / 4), 1e-4);
}

TEST(Robot, KrlBeginsWithAPostureThatSaysItsWayToStand) {
    const auto text = robot_program({});
    const auto begin = numbers(text, "PTP {X");
    ASSERT_EQ(begin.size(), 1U);
    const auto& n = begin[0];
    ASSERT_EQ(n.size(), 9U) << text; // X Y Z A B C S T E1
    const double d = pi / 180;
    const Orientation o = from_euler(n[3] * d, n[4] * d, n[5] * d);
    const Vec3 off = Vec3{n[0], n[1], n[2]} - arc()[0].points[0];
    EXPECT_LT(norm(cross(off, o.z)), 1e-4);
    EXPECT_LT(dot(off, o.z), -1); // before the place, along the tool
    EXPECT_LT(text.find("PTP {X"), text.find("LIN {X"));
    EXPECT_EQ(n[6], 2); // KUKA's Status: the wrist in front, axis 3 below, axis 5 positive
    // The same, of all ways to stand there: the axes of one have the signs that Turn says.
    const auto p = robot_profile({});
    const geom::Frame flange = p.robot.base * geom::Frame{o, {n[0], n[1], n[2]}} * geom::inverse(p.robot.tool);
    int fits = 0;
    for (const auto& q : kinematics::inverse(*p.robot.arm, flange, p.robot.start))
        fits += postproc::krl_status(*p.robot.arm, q) == 2 && postproc::krl_turn(q) == static_cast<int>(n[7]) ? 1 : 0;
    EXPECT_EQ(fits, 1);
}

TEST(Robot, KrlFliesByAtMostAThirdOfTheShorterNeighbour) {
    auto spans = arc();
    for (std::size_t i = 0; i < spans[0].points.size(); ++i)
        spans[0].points[i].y += i > 20 ? 3 * static_cast<double>(i - 20) : i > 10 ? 0.0 : -2.0; // of many lengths
    for (const double most : {0.1, 0.5, 5.0}) {
        Asked asked;
        asked.kinematics = "blend = " + std::to_string(most) + "\n";
        double blend = 0;
        std::vector<Vec3> at;
        std::vector<double> blends; // at the end of each line; 0 where it halts
        for (const auto& line : lines_of(written(asked, spans).text)) {
            if (line.starts_with("$APO.CDIS=")) blend = std::stod(line.substr(10));
            if (!line.starts_with("LIN {")) continue;
            const auto n = numbers(line, "LIN {")[0];
            at.push_back({n[0], n[1], n[2]});
            blends.push_back(line.ends_with("C_DIS") ? blend : 0);
        }
        std::size_t flown = 0;
        for (std::size_t i = 1; i + 1 < at.size(); ++i) {
            const double shorter = std::min(distance(at[i - 1], at[i]), distance(at[i], at[i + 1]));
            EXPECT_LE(blends[i], shorter / 3 + 1e-3);
            EXPECT_LE(blends[i], most);
            if (blends[i] == 0) continue;
            EXPECT_GT(blends[i], std::min(shorter / 3, most) / 2 - 1e-3); // no less than needed
            ++flown;
        }
        EXPECT_GE(flown, 38U);
        EXPECT_EQ(blends.back(), 0);
    }
}

const Asked kRapid{"rapid", "kind = \"valve\"\non_trigger = \"trOn\"\noff_trigger = \"trOff\"\n"};

TEST(Robot, RapidSaysPlacesAndQuaternionsAndSwitchesAtTheVeryPlace) {
    const auto text = robot_program(kRapid);
    std::vector<std::pair<Vec3, Orientation>> frames;
    std::vector<std::size_t> on, off;
    for (const auto& line : lines_of(text)) {
        if (!line.starts_with("MoveL [[") && !line.starts_with("TriggL [[")) continue;
        if (line.find(",trOn,") != std::string::npos) on.push_back(frames.size());
        if (line.find(",trOff,") != std::string::npos) off.push_back(frames.size());
        const auto n = numbers(line, line.substr(0, 5))[0];
        frames.push_back({{n[0], n[1], n[2]}, from_quaternion({n[3], n[4], n[5], n[6]})});
    }
    expect_arc(frames);
    EXPECT_EQ(on, (std::vector<std::size_t>{0}));   // where the stroke begins
    EXPECT_EQ(off, (std::vector<std::size_t>{40})); // where it ends
}

TEST(Robot, RapidHaltsForLinesAndFliesByWithTriggers) {
    const Asked halts{"rapid", "kind = \"valve\"\non = \"SetDO d,1;\"\noff = \"SetDO d,0;\"\n"};
    const auto text = lines_of(robot_program(halts));
    const auto on = std::find(text.begin(), text.end(), "SetDO d,1;");
    const auto off = std::find(text.begin(), text.end(), "SetDO d,0;");
    ASSERT_LT(on, off);
    ASSERT_NE(off, text.end());
    EXPECT_NE((on - 1)->find(",fine,"), std::string::npos);
    EXPECT_NE((off - 1)->find(",fine,"), std::string::npos);
    EXPECT_EQ((on + 1)->find(",fine,"), std::string::npos);
    for (const auto& line : lines_of(robot_program(kRapid)))
        EXPECT_FALSE(line.starts_with("TriggL") && line.find(",fine,") != std::string::npos) << line;
}

TEST(Robot, RapidAndUrscriptBeginWithTheAxesOfTheFirstPlace) {
    const std::string angles = "MoveAbsJ [[", joints = "movej([";
    for (const auto& [dialect, word] : {std::pair<std::string, std::string>{"rapid", angles}, {"urscript", joints}}) {
        Asked asked = kRapid;
        asked.dialect = dialect;
        if (dialect == "urscript") asked.extrusion = "kind = \"valve\"\non = \"a()\"\noff = \"b()\"\n";
        const auto p = robot_profile(asked);
        const auto text = robot_program(asked);
        const auto found = numbers(text, word);
        ASSERT_EQ(found.size(), 1U) << text;
        kinematics::Posture q{};
        for (std::size_t k = 0; k < q.size(); ++k) q[k] = dialect == "rapid" ? found[0][k] * pi / 180 : found[0][k];
        const geom::Frame tip = geom::inverse(p.robot.base) * kinematics::forward(*p.robot.arm, q) * p.robot.tool;
        const auto want = arc()[0];
        EXPECT_LT(distance(tip.turn.z, -1.0 * want.normals[0]), 1e-5);
        const Vec3 off = tip.origin - want.points[0];
        EXPECT_LT(norm(cross(off, want.normals[0])), 1e-2);
        EXPECT_GT(dot(off, want.normals[0]), 1);
        EXPECT_LT(text.find(word), text.find("ove", text.find(word) + 5)); // before all others
    }
}

TEST(Robot, UrscriptSaysMetresAndRotationVectorsInThePart) {
    const Asked asked{"urscript", "kind = \"valve\"\non = \"a()\"\noff = \"b()\"\n"};
    std::vector<std::pair<Vec3, Orientation>> frames;
    const auto found = numbers(robot_program(asked), "movel(pose_trans(filum_part,p[");
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto& n = found[i];
        ASSERT_EQ(n.size(), 9U);
        frames.push_back({1000.0 * Vec3{n[0], n[1], n[2]}, from_vector({n[3], n[4], n[5]})});
        EXPECT_NEAR(n[7], i == 0 || i == 41 ? 0.15 : 0.02, 1e-3); // m/s: travels and beads
        if (i == 0 || i + 1 == found.size()) continue;
        const double next = distance(1000.0 * Vec3{found[i + 1][0], found[i + 1][1], found[i + 1][2]}, frames[i].first);
        const double shorter = std::min(next, distance(frames[i].first, frames[i - 1].first));
        EXPECT_LE(n[8] * 1000, shorter / 3 + 1e-3); // the blend
    }
    expect_arc(frames);
    Asked wrong = asked;
    wrong.extrusion = "kind = \"filament\"\ndiameter = 1.75\n";
    EXPECT_THROW(robot_program(wrong), Error);
    wrong.dialect = "gcode";
    EXPECT_THROW(robot_program(wrong), Error);
}

TEST(Robot, ALongProgramGoesOnInModules) {
    Asked asked = kRapid;
    auto spans = arc();
    spans[0].points.clear();
    spans[0].normals.clear();
    for (int i = 0; i <= 500; ++i) {
        spans[0].points.push_back({0.2 * i - 50, 5 * std::sin(i * 0.1), 0});
        spans[0].normals.push_back({0, 0, 1});
    }
    const auto moves = [](const std::string& text) {
        std::vector<std::string> out;
        for (const auto& line : lines_of(text))
            if (line.starts_with("MoveL") || line.starts_with("TriggL") || line.starts_with("MoveAbsJ"))
                out.push_back(line);
        return out;
    };
    const auto whole = written(asked, spans);
    EXPECT_TRUE(whole.modules.empty());
    asked.robot = "module_moves = 100\nmodule_file = \"m{module}.mod\"\nmodule_start = \"BEGIN {module}\"\n"
                  "module_end = \"END\"\nmodule_load = \"LOAD {module}\"\nmodule_call = \"CALL {module}\"\n";
    const auto parts = written(asked, spans);
    std::vector<std::string> together;
    EXPECT_EQ(parts.modules.size(), 6U); // of 503 moves
    for (std::size_t m = 1; m <= parts.modules.size(); ++m) {
        const std::string& text = parts.modules.at("m" + std::to_string(m) + ".mod");
        EXPECT_TRUE(text.starts_with("BEGIN " + std::to_string(m) + "\n"));
        EXPECT_TRUE(text.ends_with("END\n"));
        const auto some = moves(text);
        EXPECT_LE(some.size(), 100U);
        together.insert(together.end(), some.begin(), some.end());
        EXPECT_NE(parts.text.find("CALL " + std::to_string(m) + "\n"), std::string::npos);
        EXPECT_LT(parts.text.find("LOAD " + std::to_string(m)), parts.text.find("CALL 1\n"));
    }
    EXPECT_EQ(together, moves(whole.text));
    EXPECT_TRUE(moves(parts.text).empty());
}
