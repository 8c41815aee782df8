// Programs with fibre: codes of the head, on every kind of machine, and the job's figures.
#include "base/error.hpp"
#include "fibre.hpp"
#include "postproc/job.hpp"
#include "postproc/measure.hpp"
#include "postproc/writer.hpp"

#include <sstream>

namespace filum::postproc {
namespace {

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) out.push_back(line);
    return out;
}

std::string program(const machine::Profile& p, const std::vector<Span>& spans) {
    Measure measure(p, Place::as_is);
    for (const Span& s : spans) measure.add(s);
    while (measure.again())
        for (const Span& s : spans) measure.add(s);
    const auto first_pass = measure.end();
    std::string out;
    const auto to = writer(p, first_pass, measure.program_shift(), [&](std::string_view t) { out += t; });
    to->begin({});
    const auto w = walker(p, measure.walk_shift(), [&](auto steps) { to->add(steps); });
    for (const Span& s : spans) w->add(s);
    w->end();
    to->end({});
    return out;
}

TEST(Fibre, TheProgramChangesToolsPrimesAnchorsAndDragsTheTail) {
    Span plastic{Role::bead, 0, 0, 0, {{0, 0, 0.2}, {20, 0, 0.2}}, {0.4}, {0.2}, {}};
    auto p = profile("[format]\nviewer_comments = false\n[travel]\nlift = 2\n");
    const auto text = lines(program(p, {plastic, travel({20, 0, 0.2}, {0, 5, 0.2}), fibre({{0, 5, 0.2}, {100, 5, 0.2}}),
                                        travel({100, 5, 0.2}, {0, 9, 0.2}),
                                        Span{Role::bead, 2, 0, 0, {{0, 9, 0.2}, {9, 9, 0.2}}, {0.4}, {0.2}, {}}}));
    const std::vector<std::string> wanted{"G90",
                                          "M83",
                                          "G1 Z5.2 F600",
                                          "G0 X0 Y0 F9000",
                                          "G1 Z0.2 F600",
                                          "G1 X20 E0.6652 F1500", // plastic
                                          "G1 E-0.8 F2100",
                                          "G1 Z2.2 F600",
                                          "T1", // up, then the tool
                                          "G0 X0 Y5 Z2.2 F9000",
                                          "G1 E7 F180",
                                          "G1 Z0.2 F600",
                                          "LAY", // pushed in the air
                                          "G1 X5 E5 F18",
                                          "WAIT",
                                          "G1 X55 F600",
                                          "CUT",
                                          "G1 X100 F300",
                                          "LAID", // laid
                                          "G1 Z2.2 F600",
                                          "T0",
                                          "G0 X0 Y9 Z2.2 F9000",
                                          "G1 Z0.2 F600",
                                          "G1 E0.8 F2100",
                                          "G1 X9 E0.29934 F1500",
                                          ";end of program, 14 moves"};
    EXPECT_EQ(text, wanted);
}

TEST(Fibre, AnAbsoluteExtruderIsSetToNothingAtAChangeAndBehindThePush) {
    const auto p = profile("tool = 0\n[format]\nviewer_comments = false\n",
                           "kind = \"filament\"\ndiameter = 1.75\nletter = \"B\"\nmode = \"absolute\"\n");
    Span s = fibre({{0, 5, 0.2}, {100, 5, 0.2}});
    s.tool = 0;
    const auto text = lines(program(p, {s}));
    const std::vector<std::string> wanted{
        "G90",         "G92 B0",       "G1 Z5.2 F600", "G0 X0 Y5 F9000", "G1 B7 F180",
        "G92 B0",      "G1 Z0.2 F600", "LAY",          "G1 X5 B5 F18",   "WAIT",
        "G1 X55 F600", "CUT",          "G1 X100 F300", "LAID",           ";end of program, 6 moves"};
    EXPECT_EQ(text, wanted);
}

TEST(Fibre, AToolpathOfMoreToolsThanTheMachineHasIsRefused) {
    const auto p = machine::parse_profile("name = \"t\"\n[bed]\nx = [0, 400]\ny = [0, 400]\nz = [0, 400]\n"
                                          "[extrusion]\nkind = \"filament\"\ndiameter = 1.75\n",
                                          "t.toml");
    EXPECT_THROW((void)measured(p, {fibre({{0, 0, 0}, {60, 0, 0}})}), Error);
}

// On a dome, the tool upright to it: the arc length counts along the tip's path, in both forms of numbers.
std::vector<Span> dome() {
    const auto at = [](double x, double y) {
        const double r = 60, z = std::sqrt(r * r - x * x - y * y);
        return std::pair{Vec3{x, y, z}, Vec3{x / r, y / r, z / r}};
    };
    std::vector<Span> out;
    for (const double most : {25.0, 30.0, 12.0, 28.0}) { // the third one is too short
        Span s = fibre({}, static_cast<std::uint32_t>(out.size()));
        for (int i = 0; i <= 50; ++i) {
            const auto [p, n] = at(most * (i / 25.0 - 1), 3.0 * static_cast<double>(out.size()));
            s.points.push_back(p);
            s.normals.push_back(n);
        }
        if (!out.empty()) {
            const Vec3 a = out.back().points.back(), na = out.back().normals.back();
            const Vec3 b = s.points.front(), nb = s.normals.front();
            Span t = travel(a, b);
            t.points = {a, a + 5 * na, b + 5 * nb, b};
            t.normals = {na, na, nb, nb};
            out.push_back(t);
        }
        out.push_back(s);
    }
    return out;
}

constexpr const char* kTrunnion = "[kinematics]\ncarrier = \"table-table\"\ntilt_letter = \"A\"\ntilt_about = \"x\"\n"
                                  "tilt_point_y = 20\ntcp_on = \"M428\"\n";

TEST(Fibre, OnMachinesWithRotaryAxesTheTipIsWhatCounts) {
    for (const char* numbers : {"numbers = \"tip\"\n", "numbers = \"joints\"\n"}) {
        const auto p = profile("anchor_feed = 0.4\n" + std::string(kTrunnion) + numbers);
        const auto spans = dome();
        const auto seen = walk(p, spans);
        ASSERT_EQ(seen.strokes.size(), 3U);
        ASSERT_EQ(seen.omitted.size(), 1U);
        for (std::size_t k = 0; k < 3; ++k)
            expect_rules(p, seen.strokes[k], length(spans[k == 2 ? 6 : 2 * k].points), 0.02);
        std::size_t over = 0; // moves 5 mm over the stroke that is left out, whose y is 9 on the dome
        for (const Step& s : seen.steps) {
            if (s.act != Act::travel && s.act != Act::extrude) continue;
            const Vec3 tip = kinematics::forward(p.axes.chain, {s.axes, s.tilt, s.turn}).tip;
            EXPECT_FALSE(std::abs(tip.y - 9) < 0.01 && norm(tip) < 61);
            over += std::abs(tip.y - 9.75) < 0.01 && std::abs(norm(tip) - 65) < 0.01 ? 1 : 0;
        }
        EXPECT_GE(over, 50U);
    }
}

TEST(Fibre, ToolsChangeAboveThePartAndOutsideOfItsFrame) {
    auto spans = dome();
    spans.erase(spans.begin() + 3, spans.begin() + 5);
    Span plastic = spans[0];
    plastic.tool = 0;
    spans[0] = plastic;
    const auto p = profile(std::string(kTrunnion) + "numbers = \"tip\"\ntcp_off = \"M429\"\n");
    const std::string text = program(p, {spans[0], spans[1], spans[2]});
    const auto change = text.find("G94\nM429\nT1\nM428\nG93\nG0 X");
    ASSERT_NE(change, std::string::npos) << text;
    const auto line = text.substr(text.find("G0 X", change), 60);
    for (const char* word : {" Y", " Z", " A", " C"}) EXPECT_NE(line.find(word), std::string::npos) << line;
}

TEST(Fibre, RobotsStandStillWhereTheyCut) {
    const std::string frame =
        "[kinematics]\ncarrier = \"frame\"\n[robot]\nbase = [800, 0, 400, 0, 0, 0]\ntool = [0, 0, 100, 0, 0, "
        "0]\nstart = [0, -90, 90, 0, 90, 0]\n[format]\ndialect = \"";
    const std::pair<std::string, std::string> halts[] = {{"krl", "}"}, {"rapid", "fine,tFilum\\WObj:=wFilum;"}};
    for (const auto& [dialect, end] : halts) {
        const auto text = lines(program(profile("prime_speed = 2\n" + frame + dialect + "\"\n",
                                                "kind = \"filament\"\ndiameter = 1.75\nmode = \"absolute\"\n"),
                                        {fibre({{0, 5, 0.2}, {40, 5, 0.2}, {100, 5, 0.2}})}));
        const auto cut = std::find(text.begin(), text.end(), "CUT");
        ASSERT_NE(cut, text.end());
        EXPECT_TRUE((cut - 1)->ends_with(end)) << *(cut - 1);
        EXPECT_NE((cut - 1)->find("55"), std::string::npos);
        EXPECT_FALSE((cut - 2)->ends_with(end)); // there is nothing to wait for at x = 40
        const auto wait = std::find(text.begin(), text.end(), "WAIT");
        ASSERT_LT(wait, cut);
        EXPECT_TRUE((wait - 1)->ends_with(end)) << *(wait - 1);
    }
}

TEST(Fibre, TheJobIsToldToolByTool) {
    auto p = profile("density = 1.5\n");
    Span plastic{Role::bead, 0, 0, 0, {{0, 0, 0}, {20, 0, 0}}, {0.5}, {0.2}, {}};
    const FirstPass s = measured(p, {plastic, travel({20, 0, 0}, {0, 5, 0}), fibre({{0, 5, 0}, {100, 5, 0}})});
    const auto figures = job(p, s);
    const auto of = [&](const std::string& group, const std::string& name) {
        for (const auto& f : figures)
            if (f.group == group && f.name == name)
                return std::holds_alternative<double>(f.value) ? std::get<double>(f.value)
                                                               : static_cast<double>(std::get<std::uint64_t>(f.value));
        return std::nan("");
    };
    EXPECT_EQ(of("tool 0", "laid"), 20);
    EXPECT_EQ(of("tool 0", "cuts"), 0);
    EXPECT_NEAR(of("tool 0", "material"), 2, 1e-9);
    EXPECT_TRUE(std::isnan(of("tool 0", "mass"))); // its density is not known
    EXPECT_TRUE(std::isnan(of("job", "mass")));
    EXPECT_EQ(of("tool 1 (fibre)", "laid"), 100);
    EXPECT_EQ(of("tool 1 (fibre)", "cuts"), 1);
    EXPECT_EQ(of("tool 1 (fibre)", "fibre used"), 107);
    EXPECT_NEAR(of("tool 1 (fibre)", "material"), 20, 1e-9);
    EXPECT_NEAR(of("tool 1 (fibre)", "mass"), 0.03, 1e-9);
    EXPECT_EQ(of("job", "laid"), 120);
    // 5 mm at 0.3 mm/s, 50 at 10, 45 at 5, a pause of 1 s; speeding up and slowing down takes little
    EXPECT_NEAR(of("tool 1 (fibre)", "print time"), 5 / 0.3 + 5 + 9 + 1, 0.1);
    const double times = of("job", "print time") + of("job", "travel time");
    EXPECT_NEAR(times, s.seconds, 1e-9);
    EXPECT_EQ(job_lines(p, s).size(), 3U);
}

} // namespace
} // namespace filum::postproc
