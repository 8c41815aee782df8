// Tool frames in three languages: read back they are the places and tool axes of the toolpath.
#include "postproc/robot.hpp"

#include "base/error.hpp"
#include "postproc/about.hpp"
#include "postproc/measure.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <regex>

using namespace filum;
using geom::Vec3;
using postproc::Orientation;

namespace {

using std::numbers::pi;

Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return c * v + s * cross(axis, v) + (1 - c) * dot(axis, v) * axis;
}

struct Random {
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
    const Vec3 y1 = turned(y0, z0, a), x2 = turned(turned(x0, z0, a), y1, b);
    const auto all = [&](const Vec3& v) { return turned(turned(turned(v, z0, a), y1, b), x2, c); };
    return {all(x0), all(y0), all(z0)};
}

Orientation from_vector(const std::array<double, 3>& v) {
    const Vec3 r{v[0], v[1], v[2]};
    const double angle = norm(r);
    const Vec3 axis = angle > 0 ? 1 / angle * r : Vec3{0, 0, 1};
    return {turned({1, 0, 0}, axis, angle), turned({0, 1, 0}, axis, angle), turned({0, 0, 1}, axis, angle)};
}

std::vector<toolpath::Span> arc() {
    toolpath::Span s{toolpath::Role::bead, 0, 0, 0, {}, {1.0}, {0.2}, {}};
    for (int i = 0; i <= 40; ++i) {
        const double a = pi * (i / 40.0 - 0.5) * 0.8;
        s.points.push_back({30 * std::sin(a), 0.2 * i, 30 * std::cos(a)});
        s.normals.push_back({std::sin(a), 0, std::cos(a)});
    }
    return {s};
}

std::string program(const std::string& dialect, const std::string& comments, const std::string& extrusion) {
    const auto p = machine::parse_profile(
        "name = \"robot\"\n[bed]\nx = [-500, 500]\ny = [-500, 500]\nz = [-500, 500]\n[extrusion]\n" + extrusion +
            "[feeds]\nbead = 20\nfirst_layer = 20\n[kinematics]\ncarrier = \"frame\"\nangle_decimals = 6\n[format]\n"
            "dialect = \"" +
            dialect + "\"\ncomments = \"" + comments + "\"\nxyz_decimals = 5\n",
        "robot.toml");
    postproc::Measure measure(p, postproc::Place::as_is);
    do
        for (const auto& s : arc()) measure.add(s);
    while (measure.again());
    const auto survey = measure.end();
    std::string out;
    const auto writer = postproc::writer(p, survey, {}, [&](std::string_view text) { out += text; });
    writer->begin(postproc::about(p, survey, {}, {}, {}));
    const auto walk = postproc::walker(p, {}, [&](auto steps) { writer->add(steps); });
    for (const auto& s : arc()) walk->add(s);
    walk->end();
    writer->end();
    return out;
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

// Two frames to approach, 40 of the beads, one to leave.
void expect_arc(const std::vector<std::pair<Vec3, Orientation>>& frames) {
    const auto want = arc()[0];
    ASSERT_EQ(frames.size(), 43U);
    for (std::size_t i = 0; i < 40; ++i) {
        const auto& [tip, o] = frames[2 + i];
        EXPECT_LT(distance(tip, want.points[1 + i]), 1e-4);
        EXPECT_LT(distance(o.z, -1.0 * want.normals[1 + i]), 1e-5); // z out of the nozzle
        EXPECT_GT(o.x.x, 0);
        EXPECT_NEAR(o.x.y, 0, 1e-5);
    }
}

} // namespace

TEST(robot, orientations_come_back_from_every_form) {
    Random random;
    for (int i = 0; i < 500; ++i) {
        Vec3 axis = random.unit(), heading = random.unit();
        if (i % 10 == 0) axis = i % 20 == 0 ? Vec3{0, 0, 1} : Vec3{0, 0, -1};
        if (i % 10 == 1) axis = {0, 1, 0}, heading = {0, 0, i % 20 == 1 ? 1.0 : -1.0}; // x straight up or down
        if (norm(cross(axis, heading)) < 0.05) continue;
        const auto o = postproc::orientation(axis, heading);
        EXPECT_LT(distance(cross(o.x, o.y), o.z), 1e-12);
        EXPECT_LT(distance(o.z, -1.0 * axis), 1e-12);
        EXPECT_GT(dot(o.x, heading), 0);
        expect_same(from_quaternion(postproc::quaternion(o)), o);
        EXPECT_GE(postproc::quaternion(o)[0], 0);
        const auto [a, b, c] = postproc::euler_zyx(o);
        expect_same(from_euler(a, b, c), o);
        expect_same(from_vector(postproc::rotation_vector(o)), o, 1e-6);
    }
}

TEST(robot, krl_says_places_angles_and_the_extruder) {
    const auto text = program("krl", "semicolon", "kind = \"filament\"\ndiameter = 1.75\nmode = \"absolute\"\n");
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
    double length = 0;
    const auto want = arc()[0].points;
    for (std::size_t i = 1; i < want.size(); ++i) length += distance(want[i - 1], want[i]);
    EXPECT_NEAR(fed, length * 0.2 / (pi * 1.75 * 1.75 / 4), 1e-4);
}

TEST(robot, rapid_says_places_and_quaternions) {
    const auto text = program("rapid", "exclamation", "kind = \"valve\"\non = \"SetDO d,1;\"\noff = \"SetDO d,0;\"\n");
    std::vector<std::pair<Vec3, Orientation>> frames;
    for (const auto& n : numbers(text, "MoveL [[")) {
        ASSERT_GE(n.size(), 7U);
        frames.push_back({{n[0], n[1], n[2]}, from_quaternion({n[3], n[4], n[5], n[6]})});
    }
    expect_arc(frames);
    EXPECT_LT(text.find("SetDO d,1;"), text.find("SetDO d,0;"));
}

TEST(robot, urscript_says_metres_and_rotation_vectors) {
    const auto text = program("urscript", "hash", "kind = \"valve\"\non = \"a()\"\noff = \"b()\"\n");
    std::vector<std::pair<Vec3, Orientation>> frames;
    for (const auto& n : numbers(text, "movel(p[")) {
        ASSERT_EQ(n.size(), 9U);
        frames.push_back({1000.0 * Vec3{n[0], n[1], n[2]}, from_vector({n[3], n[4], n[5]})});
        EXPECT_NEAR(n[7], frames.size() <= 2 || frames.size() == 43 ? 0.15 : 0.02, 1e-3); // m/s: travels and beads
    }
    expect_arc(frames);
    EXPECT_THROW(program("urscript", "hash", "kind = \"filament\"\ndiameter = 1.75\n"), Error);
    EXPECT_THROW(program("gcode", "hash", "kind = \"filament\"\ndiameter = 1.75\n"), Error);
}
