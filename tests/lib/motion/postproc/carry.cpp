// Errors name the place, the axis and the amount that a robot cannot reach; moves that it can only do slowly are slow.
#include "base/error.hpp"
#include "geom/angle.hpp"
#include "robots.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

using namespace filum;
using namespace robots;

namespace {

using geom::kDegree;
using geom::Vec3;

// A table of the IRB 4600 with other limits and speeds, as a file.
class Model {
  public:
    explicit Model(const std::string& min, const std::string& max, const std::string& speed)
        : path_(std::filesystem::temp_directory_path() / ("filum-robot-" + std::to_string(::getpid()) + ".toml")) {
        std::ofstream(path_) << "name = \"t\"\n[dh]\na = [175, 900, 175, 0, 0, 0]\nd = [495, 0, 0, 960, 0, 135]\n"
                                "alpha_deg = [-90, 0, -90, 90, -90, 0]\ntheta_deg = [0, -90, 0, 0, 0, 180]\n[limits]\n"
                             << "min_deg = [" << min << "]\nmax_deg = [" << max << "]\nspeed_deg = [" << speed << "]\n";
    }
    ~Model() { std::filesystem::remove(path_); }
    [[nodiscard]] std::string name() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

constexpr const char *kMin = "-180, -90, -180, -400, -125, -400", *kMax = "180, 150, 75, 400, 120, 400",
                     *kFast = "175, 175, 175, 250, 250, 360";

// A bead along y at z = 0, upright.
std::vector<toolpath::Span> along_y(double from, double to) {
    toolpath::Span s{toolpath::Role::bead, 0, 0, 0, {}, {1.0}, {0.2}, {}};
    for (int i = 0; i <= 100; ++i) s.points.push_back({0, from + (to - from) * i / 100, 0});
    return {s};
}

std::string refusal(const Asked& asked, const std::vector<toolpath::Span>& spans) {
    try {
        (void)written(asked, spans);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::failure);
        return e.what();
    }
    ADD_FAILURE() << "not refused";
    return "";
}

// x, y, z of a message.
Vec3 place_in(const std::string& message) {
    std::smatch m;
    const std::regex place("x (-?[0-9.]+), y (-?[0-9.]+), z (-?[0-9.]+)");
    if (!std::regex_search(message, m, place)) return {1e9, 1e9, 1e9};
    return {std::stod(m[1]), std::stod(m[2]), std::stod(m[3])};
}

const Note* note_of(const Written& w, const std::string& what) {
    for (const Note& n : w.notes)
        if (code_name(n).find(what) != std::string::npos) return &n;
    return nullptr;
}

double fact_of(const Written& w, const std::string& name) {
    for (const Fact& f : w.facts)
        if (f.name == name) return f.value;
    return std::nan("");
}

} // namespace

TEST(Carry, WhatIsOutOfReachSaysWhereAndByHowMuch) {
    Asked asked;
    asked.base = "2000, 0, 500, 0, 0, 0";
    // The flange is 150 above the tip, the wrist 135 above that; axis 2 stands at 175, 495; arms of 900 and 975.8.
    const double reach = 900 + std::hypot(960, 175), up = 500 + 285 - 495;
    const double farthest = std::sqrt(std::pow(std::sqrt(reach * reach - up * up) + 175, 2) - 2000.0 * 2000.0);
    const auto said = refusal(asked, along_y(0, 500));
    EXPECT_NE(said.find("stroke 1, layer 0, a bead, point "), std::string::npos) << said;
    EXPECT_NE(said.find("out of reach: the arm is too short"), std::string::npos) << said;
    EXPECT_GE(place_in(said).y, farthest) << said;
    EXPECT_LE(place_in(said).y, farthest + 5) << said;
}

TEST(Carry, ALimitSaysWhichAxis) {
    const Model model("-10, -90, -180, -400, -125, -400", "10, 150, 75, 400, 120, 400", kFast);
    Asked asked;
    asked.model = model.name();
    asked.base = "1200, 0, 500, 0, 0, 0";
    for (const char* spin : {"fixed", "free"}) {
        asked.kinematics = std::string("spin = \"") + spin + "\"\n";
        const auto said = refusal(asked, along_y(0, 400));
        EXPECT_NE(said.find("axis 1 would be "), std::string::npos) << said;
        EXPECT_NE(said.find("a bead, point "), std::string::npos) << said;
        EXPECT_NEAR(place_in(said).y, 1200 * std::tan(10 * kDegree), 4.1) << said;
    }
}

TEST(Carry, ASlowAxisMakesBeadsSlowAndThatIsTold) {
    const Model model(kMin, kMax, "0.2, 175, 175, 250, 250, 360");
    Asked fast, slow;
    fast.base = slow.base = "1200, 0, 500, 0, 0, 0";
    slow.model = model.name();
    const auto path = along_y(-100, 100);
    const auto a = written(fast, path), b = written(slow, path);
    EXPECT_EQ(note_of(a, "beads-slowed"), nullptr);
    EXPECT_EQ(fact_of(a, "slowest-share-of-feed"), 1);
    const Note* note = note_of(b, "beads-slowed");
    ASSERT_NE(note, nullptr);
    EXPECT_NEAR(note->amount, 200, 1e-6);
    EXPECT_EQ(note->count, 100U);
    EXPECT_EQ(fact_of(b, "axis-of-slowest"), 1);
    // Axis 1 turns by 2 atan(100 / 1200) at 0.2 degrees/s; 20 mm/s would take 10 s.
    const double seconds = 2 * std::atan(100.0 / 1200) / (0.2 * kDegree);
    EXPECT_NEAR(b.first_pass.seconds - a.first_pass.seconds, seconds - 10, 0.5);
    EXPECT_NEAR(fact_of(b, "slowest-share-of-feed"), 0.2 * kDegree * 1200 / 20, 0.01);
    // and the program says so: the feeds of its lines take that long
    double feed = 0, all = 0;
    Vec3 at{};
    bool began = false;
    for (const auto& line : lines_of(b.text)) {
        if (line.starts_with("$VEL.CP=")) feed = 1000 * std::stod(line.substr(8));
        std::smatch m;
        if (!std::regex_search(line, m, std::regex("LIN \\{X (\\S+),Y (\\S+),Z ([^,]+),"))) continue;
        const Vec3 to{std::stod(m[1]), std::stod(m[2]), std::stod(m[3])};
        if (began && to.z == 0) all += distance(at, to) / feed;
        began = true;
        at = to;
    }
    EXPECT_NEAR(all, seconds, 0.01 * seconds);
}

TEST(Carry, ASingularityIsToldNearAndRefusedWithin) {
    // The arc leans the tool along the fore arm, which lies level: axes 4 and 6 in line.
    Asked asked;
    asked.base = "1200, 0, 500, 0, 0, 0";
    const auto said = refusal(asked, arc());
    EXPECT_NE(said.find("leads through a singularity, where axis "), std::string::npos) << said;
    EXPECT_NE(said.find("spin=free"), std::string::npos) << said;
    EXPECT_LT(place_in(said).x, 0) << said; // it leans away from the robot there
    asked.base = "1200, 60, 500, 0, 0, 0";  // beside it
    asked.kinematics = "spin = \"free\"\n";
    const auto w = written(asked, arc());
    EXPECT_LT(fact_of(w, "nearest-singularity"), 15);
    EXPECT_EQ(note_of(w, "singularity") != nullptr, fact_of(w, "nearest-singularity") < 5);
}

TEST(Carry, WithoutAModelNothingIsCheckedAndThatIsTold) {
    Asked asked;
    asked.model = "";
    asked.base = "9000, 0, 500, 0, 0, 0";
    const auto w = written(asked, arc());
    ASSERT_NE(note_of(w, "robot-unchecked"), nullptr);
    EXPECT_TRUE(std::isnan(fact_of(w, "nearest-singularity")));
    EXPECT_NE(w.text.find("PTP {X "), std::string::npos);
    EXPECT_EQ(w.text.find(",S "), std::string::npos); // unknown
    asked.dialect = "rapid";
    EXPECT_NE(written(asked, arc()).text.find("MoveJ [["), std::string::npos);
    asked.dialect = "urscript";
    asked.extrusion = "kind = \"valve\"\non = \"a()\"\noff = \"b()\"\n";
    EXPECT_NE(written(asked, arc()).text.find("movej(pose_trans(filum_part,p["), std::string::npos);
}

TEST(Carry, StrokesGoOnFromWhereTheLastOneEnded) {
    // Many short strokes all over a plate: for any way of the axes, each program's frames stand in one way.
    Asked asked;
    asked.base = "1200, 0, 500, 0, 0, 0";
    asked.kinematics = "spin = \"free\"\n";
    std::vector<toolpath::Span> spans;
    for (int k = 0; k < 12; ++k) {
        toolpath::Span s = along_y(0, 30)[0];
        for (Vec3& p : s.points) {
            p.x += 40.0 * (k % 4) - 60;
            p.y += 100.0 * (k / 4) - 100;
        }
        if (k > 0) {
            toolpath::Span travel{
                toolpath::Role::travel, 0, 0, 0, {spans.back().points.back(), s.points[0]}, {0}, {0}, {}};
            spans.push_back(travel);
        }
        spans.push_back(s);
    }
    const auto w = written(asked, spans);
    EXPECT_EQ(w.first_pass.strokes, 12U);
    EXPECT_EQ(note_of(w, "robot-other-posture"), nullptr);
    EXPECT_GT(fact_of(w, "least-room-of-an-axis"), 10);
    EXPECT_GT(fact_of(w, "nearest-singularity"), 5);
    EXPECT_EQ(fact_of(w, "largest-spin"), 0);
}
