// Robot models: the tables that come along are the makers' drawings, and a URDF of the same robot is the same robot.
#include "machine/robot.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"
#include "machine/profile.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace filum;
using geom::Frame;
using geom::kDegree;
using kinematics::Arm;
using kinematics::Posture;
using std::numbers::pi;

namespace {

struct Line {
    const char *axis, *origin; // of each joint in the frame of the one before, m
};

std::string joint(int k, const Line& l, double low, double high) {
    const std::string n = std::to_string(k);
    return "<joint name=\"axis_" + n + "\" type=\"revolute\"><origin xyz=\"" + l.origin +
           "\" rpy=\"0 0 0\"/><parent link=\"" + (k == 1 ? "base_link" : "link_" + std::to_string(k - 1)) +
           "\"/><child link=\"link_" + n + "\"/><axis xyz=\"" + l.axis + "\"/><limit lower=\"" + std::to_string(low) +
           "\" upper=\"" + std::to_string(high) + "\" velocity=\"3\" effort=\"0\"/></joint>\n";
}

// A robot by six lines and its flange, which looks along x, as ROS-Industrial has them.
std::string urdf(const std::vector<Line>& lines, const std::string& more = "") {
    std::string out = "<?xml version=\"1.0\"?><robot name=\"r\"><link name=\"base_link\"/>\n";
    for (int k = 1; k <= 6; ++k) out += joint(k, lines[static_cast<std::size_t>(k) - 1], -3, 3);
    return out +
           "<joint name=\"end\" type=\"fixed\"><parent link=\"link_6\"/><child link=\"tool0\"/><origin xyz=\"0 0 0\" "
           "rpy=\"0 1.5707963267948966 0\"/></joint>" +
           more + "</robot>";
}

const std::vector<Line> kIrb{{"0 0 1", "0 0 0.495"}, {"0 1 0", "0.175 0 0"}, {"0 1 0", "0 0 0.9"},
                             {"1 0 0", "0 0 0.175"}, {"0 1 0", "0.960 0 0"}, {"1 0 0", "0.135 0 0"}};
const std::vector<Line> kKuka{{"0 0 -1", "0 0 0.450"}, {"0 1 0", "0.150 0 0"}, {"0 1 0", "0.610 0 0"},
                              {"-1 0 0", "0 0 0.02"},  {"0 1 0", "0.660 0 0"}, {"-1 0 0", "0.080 0 0"}};

void expect_same(const Arm& a, const Arm& b) {
    std::mt19937 engine{5};
    for (int i = 0; i < 50; ++i) {
        Posture q;
        for (double& t : q) t = 6.0 * (static_cast<double>(engine()) / 4294967296.0 - 0.5);
        const Frame x = kinematics::forward(a, q), y = kinematics::forward(b, q);
        EXPECT_LT(distance(x.origin, y.origin), 1e-6);
        EXPECT_LT(distance(x.turn.x, y.turn.x) + distance(x.turn.y, y.turn.y), 1e-9);
    }
}

std::string model_error(const std::string& text, const machine::RobotLinks& links = {}) {
    try {
        if (text.find('<') != std::string::npos)
            (void)machine::urdf_robot(text, "r.urdf", links);
        else
            (void)machine::table_robot(text, "r.toml");
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        return e.what();
    }
    return "";
}

const char* const kTable =
    "name = \"t\"\n[dh]\na = [175, 900, 175, 0, 0, 0]\nd = [495, 0, 0, 960, 0, 135]\nalpha_deg = "
    "[-90, 0, -90, 90, -90, 0]\n[limits]\nmin_deg = [-1, -1, -1, -1, -1, -1]\nmax_deg = [1, 1, 1, "
    "1, 1, 1]\nspeed_deg = [1, 1, 1, 1, 1, 1]\n";

std::string changed(std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
}

} // namespace

TEST(RobotModel, ThoseThatComeAlongAreTheMakers) {
    EXPECT_EQ(machine::robot_names(), (std::vector<std::string>{"irb4600-60-205", "kr10-r1420", "ur10e"}));
    const auto irb = machine::load_robot("irb4600-60-205", "", {});
    expect_same(irb, machine::urdf_robot(urdf(kIrb), "irb.urdf", {}));
    EXPECT_NEAR(irb.axes[1].max, 150 * kDegree, 1e-12);
    EXPECT_NEAR(irb.axes[4].speed, 250 * kDegree, 1e-12);
    expect_same(machine::load_robot("kr10-r1420", "", {}), machine::urdf_robot(urdf(kKuka), "kr.urdf", {}));
    const auto ur = machine::load_robot("ur10e", "", {});
    EXPECT_LT(distance(kinematics::forward(ur, {}).origin, {-1184.25, -290.7, 60.85}), 1e-9);
    // KUKA's own sense: HOME is the upper arm upright, the fore arm level and ahead.
    const auto kuka = machine::load_robot("kr10-r1420", "", {});
    const Posture home{0, -pi / 2, pi / 2, 0, 0, 0};
    EXPECT_LT(distance(kinematics::forward(kuka, home).origin, {150 + 660 + 80, 0, 450 + 610 + 20}), 1e-9);
    EXPECT_GT(kinematics::forward(kuka, {-0.5, -pi / 2, pi / 2, 0, 0, 0}).origin.y, 0); // A1 counts clockwise
    const auto c = kinematics::configuration(kuka, {0, -pi / 2, pi / 2, 0, 0.3, 0});
    EXPECT_EQ(c, (kinematics::Configuration{false, false, false}));
    EXPECT_TRUE(kinematics::configuration(kuka, {0, -pi / 2, pi / 2, 0, -0.3, 0}).flipped);
    EXPECT_TRUE(kinematics::configuration(kuka, {0, -2, -1, 0, 0.3, 0}).bent_down);
}

TEST(RobotModel, AUrdfSaysItsBaseAndFlange) {
    // The controller counts from a frame turned by half a turn, as Universal Robots' does.
    const std::string base =
        "<joint name=\"b\" type=\"fixed\"><parent link=\"base_link\"/><child link=\"base\"/><origin "
        "xyz=\"0 0 0.1\" rpy=\"0 0 3.141592653589793\"/></joint>";
    const auto arm = machine::urdf_robot(urdf(kIrb, base), "r.urdf", {});
    EXPECT_LT(distance(kinematics::forward(arm, {}).origin, {-1270, 0, 1470}), 1e-6);
    const auto from_root = machine::urdf_robot(urdf(kIrb, base), "r.urdf", {"base_link", "link_6"});
    EXPECT_LT(distance(kinematics::forward(from_root, {}).origin, {1270, 0, 1570}), 1e-6);
    EXPECT_LT(distance(kinematics::forward(from_root, {}).turn.z, {0, 0, 1}), 1e-9);
    EXPECT_EQ(from_root.build, kinematics::Build::wrist);
}

std::string fixed(const std::string& parent, const std::string& child, const std::string& xyz) {
    return "<joint name=\"to_" + child + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" + child +
           "\"/><origin xyz=\"" + xyz + "\"/></joint>";
}

// The position of the flange at rest, from the base that is found.
TEST(RobotModel, BaseAndTipAreKnownByTheirExactNamesFirst) {
    const auto at = [&](const std::string& text, const machine::RobotLinks& links = {}) {
        return kinematics::forward(machine::urdf_robot(text, "r.urdf", links), {}).origin;
    };
    const geom::Vec3 plain{1270, 0, 1570};
    const std::string gripper = fixed("tool0", "gripper_base", "0.1 0 0") +
                                fixed("gripper_base", "gripper_flange", "0 0 0.1") +
                                "<joint name=\"f\" type=\"prismatic\"><parent link=\"gripper_base\"/><child "
                                "link=\"finger\"/><axis xyz=\"0 1 0\"/></joint>";
    EXPECT_LT(distance(at(urdf(kIrb, gripper)), plain), 1e-6); // not the gripper's
    const std::string cell = fixed("world", "base_link", "1 2 3") + fixed("world", "table_base", "5 5 5");
    EXPECT_LT(distance(at(urdf(kIrb, cell)), plain), 1e-6); // not the world's frame, not the table's
    EXPECT_LT(distance(at(urdf(kIrb, cell + fixed("base_link", "base", "0 0 0.1"))), {1270, 0, 1470}), 1e-6);
    EXPECT_LT(distance(at(urdf(kIrb, cell), {"world", ""}), {2270, 2000, 4570}), 1e-6);
    EXPECT_NE(model_error(changed(urdf(kIrb, fixed("link_6", "a_tool0", "0 0 1")), "\"tool0\"", "\"b_tool0\""))
                  .find("may be 'a_tool0' or 'b_tool0'"),
              std::string::npos);
}

TEST(RobotModel, DegreesAndMillimetresAreFoundByTheirSize) {
    const auto has = [](const std::string& message, const std::string& part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    for (int k = 1; k <= 6; ++k) { // limits of robots in degrees
        std::string text = urdf(kIrb);
        const std::string name = "axis_" + std::to_string(k);
        const std::size_t at = text.find("lower=\"-3.000000\"", text.find(name));
        has(model_error(text.replace(at, 17, "lower=\"-120\"")), "joint '" + name + "' has a limit of -120 rad");
    }
    has(model_error(changed(urdf(kIrb), "velocity=\"3\"", "velocity=\"180\"")), "rad/s");
    has(model_error(changed(urdf(kIrb), "0 0 0.495", "0 0 495")), "if these are mm");
    EXPECT_EQ(model_error(changed(urdf(kIrb), "lower=\"-3.000000\"", "lower=\"-12.6\"")), ""); // two turns
    has(model_error(changed(urdf(kIrb), "\"revolute\"", "\"hinge\"")), "unknown type 'hinge'");
    std::string rail = urdf(kIrb, "<joint name=\"rail\" type=\"prismatic\"><parent link=\"track\"/><child "
                                  "link=\"base_link\"/><axis xyz=\"1 0 0\"/></joint>");
    has(model_error(rail), "joint 'rail' is a rail");
}

TEST(RobotModel, WhatIsNoRobotOfSixAxesSaysWhy) {
    const auto has = [](const std::string& message, const std::string& part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
        EXPECT_EQ(message.rfind("cannot use robot model 'r.", 0), 0U) << message;
    };
    has(model_error("<robot"), "it is no XML");
    has(model_error("<sdf/>"), "it has no <robot>");
    has(model_error("<robot><joint name=\"j\" type=\"fixed\"/></robot>"), "joint 'j' lacks its links");
    has(model_error(urdf(kIrb), {"", "link_5"}), "the way to link 'link_5' has 5 turning axes");
    has(model_error(urdf(kIrb), {"", "hand"}), "it has no link 'hand'");
    has(model_error(urdf(kIrb), {"link_1", ""}), "link 'link_1', the base, moves");
    has(model_error(changed(urdf(kIrb), "type=\"revolute\"", "type=\"prismatic\"")), "is a rail (prismatic)");
    has(model_error(changed(urdf(kIrb), "0 0 0.495", "0 0 ${h}")), "is it a xacro?");
    has(model_error(changed(urdf(kIrb), "0 0 0.495", "0 0")), "no number");
    has(model_error(changed(urdf(kIrb), "0 0 1\"", "0 0 0\"")), "joint 'axis_1' has no axis");
    has(model_error(changed(urdf(kIrb), "velocity=\"3\"", "velocity=\"0\"")), "its velocity");
    has(model_error(changed(urdf(kIrb), "lower=\"-3.000000\"", "lower=\"4\"")), "leave it no room");
    has(model_error(changed(urdf(kIrb), "child link=\"link_1\"", "child link=\"link_2\"")),
        "is the child of several joints");
    has(model_error(changed(changed(urdf(kIrb), "parent link=\"base_link\"", "parent link=\"tool0\""),
                            "<link name=\"base_link\"/>", "")),
        "go round in a circle");
    // seven axes without a name for the flange: it is not the sixth link
    const std::string seventh = "<joint name=\"axis_7\" type=\"revolute\"><parent link=\"link_6\"/><child "
                                "link=\"link_7\"/><axis xyz=\"0 0 1\"/><limit lower=\"-3\" upper=\"3\" "
                                "velocity=\"3\"/></joint>";
    const std::string nameless = changed(urdf(kIrb, seventh), "\"tool0\"", "\"plate\"");
    has(model_error(nameless), "joint 'axis_7' moves behind the sixth axis");
    EXPECT_EQ(model_error(nameless, {"", "link_6"}), "");
    // a joint beside the chain needs no limits
    EXPECT_EQ(model_error(urdf(kIrb, "<joint name=\"cylinder\" type=\"revolute\"><parent link=\"link_1\"/><child "
                                     "link=\"cylinder\"/><axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\" "
                                     "velocity=\"0\"/></joint>")),
              "");
    has(model_error(urdf(kIrb, "<xacro:include filename=\"x.xacro\"/>")), "it is a xacro");
    EXPECT_EQ(model_error(kTable), "");
    has(model_error(changed(kTable, "900, ", "")), "key 'dh.a': it must be 6 numbers in brackets");
    has(model_error(changed(kTable, "max_deg = [1,", "max_deg = [-2,")), "each must be below that of max_deg");
    has(model_error(changed(kTable, "[limits]", "sign = [1, 1, 0.5, 1, 1, 1]\n[limits]")), "each must be 1 or -1");
    has(model_error(changed(kTable, "speed_deg", "speed")), "limits.speed_deg': it is missing");
    has(model_error(std::string(kTable) + "[more]\nx = 1\n"), "key 'more': there is no such key");
}

TEST(RobotModel, FramesAreToldInEveryForm) {
    std::map<std::string, double> v;
    machine::add_frame("f", {geom::from_euler_zyx(0.3, -0.2, 2.5), {100, -20, 3}}, v);
    EXPECT_NEAR(v["f_a"], 0.3 / kDegree, 1e-8);
    EXPECT_NEAR(v["f_b"], -0.2 / kDegree, 1e-8);
    EXPECT_NEAR(v["f_c"], 2.5 / kDegree, 1e-8);
    EXPECT_EQ(v["f_y"], -20);
    EXPECT_EQ(v["f_my"], -0.02);
    const double angle = std::sqrt(v["f_rx"] * v["f_rx"] + v["f_ry"] * v["f_ry"] + v["f_rz"] * v["f_rz"]);
    EXPECT_NEAR(std::cos(angle / 2), v["f_q1"], 1e-8);
    EXPECT_NEAR(std::sin(angle / 2) * v["f_rx"] / angle, v["f_q2"], 1e-8);
}
