// Tools with sections of their own: their programs, read back, hold their codes, places, feeds and limits, and no
// other's.
#include "base/error.hpp"
#include "machine/profile.hpp"
#include "postproc/measure.hpp"
#include "postproc/program.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <sstream>

using namespace filum;
using geom::Vec3;

namespace {

const std::string kBed = "name = \"two\"\n[bed]\nx = [-200, 200]\ny = [-200, 200]\nz = [-200, 200]\n";
const std::string kValves = "[extrusion]\nkind = \"valve\"\non = \"OPEN 0\"\noff = \"SHUT 0\"\n[feeds]\nbead = 10\n"
                            "first_layer = 10\n[travel]\nlift = 1\nretract = 0\n";
const std::string kOwn =
    "[tool.0]\nchange = \"TAKE 0\"\n[tool.1]\nchange = \"TAKE 1\"\noffset = [30, -2, 1.5]\n"
    "extrusion.on = \"OPEN 1\"\nextrusion.off = \"SHUT 1\"\nfeeds.first_layer = 5\nfeeds.bead = 5\n"
    "limits.width = [0.1, 0.6]\n";

toolpath::Span line_of(std::uint32_t tool, Vec3 from, Vec3 to, double width = 0.5) {
    return {toolpath::Role::bead, 0, 0, 0, {from, to}, {width}, {0.2}, {}, tool};
}

toolpath::Span way_of(std::uint32_t tool, Vec3 from, Vec3 to) {
    return {toolpath::Role::travel, 0, 0, 0, {from, to}, {}, {}, {}, tool};
}

std::vector<toolpath::Span> both(double width = 0.5) {
    const Vec3 a{0, 0, 0.2}, b{20, 0, 0.2}, c{0, 5, 0.2}, d{20, 5, 0.2}, e{0, 9, 0.2}, f{20, 9, 0.2};
    return {line_of(0, a, b), way_of(1, b, c), line_of(1, c, d, width), way_of(0, d, e), line_of(0, e, f)};
}

std::string two_tools(const std::string& profile, const std::vector<toolpath::Span>& spans) {
    const auto p = machine::parse_profile(profile, "two.toml");
    postproc::Measure measure(p, postproc::Place::as_is);
    do
        for (const auto& s : spans) measure.add(s);
    while (measure.again());
    const auto first_pass = measure.end();
    std::string out;
    const auto writer = postproc::writer(p, first_pass, measure.program_shift(), [&](auto text) { out += text; });
    writer->begin({});
    const auto walk = postproc::walker(p, measure.walk_shift(), [&](auto steps) { writer->add(steps); });
    for (const auto& s : spans) walk->add(s);
    walk->end();
    writer->end({});
    return out;
}

// What each tool does: the numbers of its moves while its valve is open, and which codes came while it was in use.
struct Observation {
    std::map<int, std::vector<std::array<double, 4>>> laid; // x, y, z, f
    std::map<int, std::vector<std::string>> codes;
};

Observation read_tools(const std::string& program) {
    Observation out;
    std::istringstream text(program);
    std::array<double, 4> at{};
    int tool = 0;
    bool open = false;
    for (std::string line; std::getline(text, line);) {
        if (line.rfind("TAKE ", 0) == 0) tool = line[5] - '0';
        if (line.rfind("OPEN", 0) == 0 || line.rfind("SHUT", 0) == 0) {
            out.codes[tool].push_back(line);
            open = line[0] == 'O';
        }
        if (line.rfind("G0 ", 0) != 0 && line.rfind("G1 ", 0) != 0) continue;
        std::istringstream words(line.substr(3));
        for (std::string w; words >> w;) {
            const auto k = std::string("XYZF").find(w[0]);
            if (k != std::string::npos) at[k] = std::stod(w.substr(1));
        }
        if (open) out.laid[tool].push_back(at);
    }
    return out;
}

} // namespace

TEST(Tools, OfThreeAxesHaveCodesOffsetsAndFeedsOfTheirOwn) {
    const auto seen = read_tools(two_tools(kBed + kValves + kOwn, both()));
    EXPECT_EQ(seen.codes.at(0), (std::vector<std::string>{"OPEN 0", "SHUT 0", "OPEN 0", "SHUT 0"}));
    EXPECT_EQ(seen.codes.at(1), (std::vector<std::string>{"OPEN 1", "SHUT 1"}));
    ASSERT_EQ(seen.laid.at(0).size(), 2U);
    ASSERT_EQ(seen.laid.at(1).size(), 1U);
    EXPECT_EQ(seen.laid.at(0)[0], (std::array<double, 4>{20, 0, 0.2, 600}));
    // The numbers are those of tool 0's tip; tool 1's is 30, -2, 1.5 from there.
    const auto& own = seen.laid.at(1)[0];
    EXPECT_NEAR(own[0], 20 - 30, 1e-9);
    EXPECT_NEAR(own[1], 5 + 2, 1e-9);
    EXPECT_NEAR(own[2], 0.2 - 1.5, 1e-9);
    EXPECT_EQ(own[3], 300);
}

TEST(Tools, OfRotaryAxesLikewise) {
    const std::string axes = "[kinematics]\ncarrier = \"head-table\"\ntilt_about = \"y\"\ntilt_deg = [-90, 90]\n"
                             "tip_to_tilt_z = 50\nnumbers = \"joints\"\nfeed_word = \"per-minute\"\n";
    const auto seen = read_tools(two_tools(kBed + kValves + axes + kOwn, both()));
    EXPECT_EQ(seen.codes.at(0), (std::vector<std::string>{"OPEN 0", "SHUT 0", "OPEN 0", "SHUT 0"}));
    EXPECT_EQ(seen.codes.at(1), (std::vector<std::string>{"OPEN 1", "SHUT 1"}));
    const auto &first = seen.laid.at(0).back(), &own = seen.laid.at(1).back();
    EXPECT_NEAR(first[0], 20, 1e-3);
    EXPECT_NEAR(own[0], 20 - 30, 1e-3); // upright: the head is moved by the offset
    EXPECT_NEAR(own[2], 0.2 - 1.5, 1e-3);
    // Leaning by 40 degrees: the offset turns with the head.  Where the tip of tool 1 is for the axes' numbers, worked
    // out anew: tool 0's tip is 50 below the tilt axis, tool 1's as far as the offset from there.
    const double lean = 40 * std::numbers::pi / 180;
    auto spans = both();
    for (auto& s : spans)
        if (s.role == toolpath::Role::bead) s.normals.assign(s.points.size(), {std::sin(lean), 0, std::cos(lean)});
    const auto leaning = read_tools(two_tools(kBed + kValves + axes + kOwn, spans));
    const auto tip_of = [&](const std::array<double, 4>& at, const Vec3& offset) {
        const Vec3 arm = offset - Vec3{0, 0, 50}; // from the tilt axis, which is at `at` and 50 above
        return Vec3{at[0] + std::cos(lean) * arm.x + std::sin(lean) * arm.z, at[1] + arm.y,
                    at[2] + 50 - std::sin(lean) * arm.x + std::cos(lean) * arm.z};
    };
    EXPECT_LT(distance(tip_of(leaning.laid.at(0).back(), {}), {20, 9, 0.2}), 2e-3);
    EXPECT_LT(distance(tip_of(leaning.laid.at(1).back(), {30, -2, 1.5}), {20, 5, 0.2}), 2e-3);
}

TEST(Tools, LayNoBeadThatTheirNozzleDoesNot) {
    EXPECT_NO_THROW(two_tools(kBed + kValves + kOwn, both(0.6)));
    try {
        (void)two_tools(kBed + kValves + kOwn, both(0.8));
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("a bead 0.8 mm wide, and tool 1 of 'two' lays 0.1 to 0.6 mm"),
                  std::string::npos)
            << e.what();
    }
}

TEST(Tools, TheInkredibleOpensTheValveOfTheHeadInUse) {
    auto spans = both();
    std::istringstream text([&] {
        const auto p = machine::load_profile("cellink-inkredible");
        std::string out;
        postproc::Measure measure(p, postproc::Place::center);
        do
            for (const auto& s : spans) measure.add(s);
        while (measure.again());
        const auto first_pass = measure.end();
        const auto writer = postproc::writer(p, first_pass, measure.program_shift(), [&](auto t) { out += t; });
        writer->begin({});
        const auto walk = postproc::walker(p, measure.walk_shift(), [&](auto steps) { writer->add(steps); });
        for (const auto& s : spans) walk->add(s);
        walk->end();
        writer->end({});
        return out;
    }());
    std::string codes;
    for (std::string line; std::getline(text, line);)
        if (line.rfind("M75", 0) == 0 || line.rfind("M76", 0) == 0) codes += line + " ";
    EXPECT_EQ(codes, "M750 M751 M760 M761 M752 M762 M763 M751 M760 M761 ");
}

TEST(Tools, ThatAreNotThereAreTold) {
    const auto fails = [](const std::string& profile, const std::vector<toolpath::Span>& spans,
                          const std::string& part) {
        try {
            (void)two_tools(profile, spans);
            FAIL() << part;
        } catch (const Error& e) {
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
        }
    };
    fails(kBed + kValves, both(), "cannot take tool 1");
    fails(kBed + kValves + "[tool.x]\nchange = \"T\"\n", both(), "a tool has a number");
    fails(kBed + kValves + "[tool.1]\nchange = \"T\"\nbed.x = [0, 1]\n", both(), "there is no such key");
    fails(kBed + kValves + "[tool.1]\nchange = \"T {nothing}\"\n", both(), "unknown placeholder '{nothing}'");
    fails(kBed + kValves + "[tool.1]\nextrusion.on = \"O\"\n", both(), "needs the codes that take it");
}
