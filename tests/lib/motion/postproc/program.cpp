// Breaks, feeds, limits, comments and templates of a program.
#include "interpreter.hpp"
#include "sample.hpp"

#include "base/error.hpp"
#include "postproc/digits.hpp"

#include <gtest/gtest.h>

using namespace filum;
using sample::Role;
using sample::Span;

namespace {

std::string error_of(const auto& work, Exit exit) {
    try {
        work();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), exit) << e.what();
        return e.what();
    }
    ADD_FAILURE() << "no error";
    return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Two strokes on one layer, then one on the next.
std::vector<Span> three_strokes() {
    const geom::Vec3 a{0, 0, 0.2}, b{10, 0, 0.2}, c{10, 20, 0.2}, d{0, 20, 0.2}, e{0, 20, 0.4}, f{5, 20, 0.4};
    return {{Role::bead, 0, 0, 0, {a, b}, {0.4}, {0.2}},
            {Role::travel, 1, 0, 1, {b, c}, {}, {}},
            {Role::bead, 1, 0, 1, {c, d}, {0.4}, {0.2}},
            {Role::travel, 2, 1, 2, {d, e}, {}, {}},
            {Role::connector, 2, 1, 2, {e, f}, {0.4}, {0.2}}};
}

} // namespace

TEST(Program, ABreakRetractsLiftsMovesAndComesBack) {
    const auto p =
        sample::profile(sample::kFilament, "[travel]\nlift = 1\nretract = 2\nretract_speed = 20\nextra = 0.5\n");
    const auto program = interpreter::read(sample::write(p, three_strokes()).text);
    std::vector<std::string> lines;
    for (const auto& m : program.moves) lines.push_back(m.line);
    const std::vector<std::string> wanted = {
        "G1 Z5.2 F600", "G0 X195 Y190 F9000", "G1 Z0.2 F600", "G1 X205 E0.3326 F1500", "G1 E-2 F1200",
        "G1 Z1.2 F600", "G0 Y210 F9000",      "G1 Z0.2 F600", "G1 E2.5 F1200",         "G1 X195 E0.3326 F1500",
        "G1 E-2 F1200", "G1 Z1.4 F600",       "G1 Z0.4",      "G1 E2.5 F1200",         "G1 X200 E0.1663"};
    EXPECT_EQ(lines, wanted);
}

TEST(Program, FeaturesHaveFlowAccelerationAndFanOfTheirOwn) {
    using toolpath::Feature;
    std::vector<Span> spans;
    geom::Vec3 at{0, 0, 0.2};
    const std::pair<Feature, std::uint32_t> beads[] = {
        {Feature::wall, 0}, {Feature::bridge, 0}, {Feature::wall, 1}, {Feature::bridge, 1}, {Feature::wall, 1}};
    for (const auto& [feature, layer] : beads) {
        const geom::Vec3 to{at.x + 10, at.y, 0.2 + 0.2 * layer};
        if (to.z != at.z) at.z = to.z;
        Span bead{Role::bead, 0, layer, layer, {at, to}, {0.4}, {0.2}};
        bead.feature = feature;
        if (!spans.empty() && spans.back().points.back().z != at.z) spans.back().points.back().z = at.z;
        spans.push_back(bead);
        at = to;
    }
    const char* const rules = "upper_layers = \"M105 S{fan}\"\n[features.bridge]\nflow = 1.5\nacceleration = 500\nfan "
                              "= 200\n[values]\nfan = 99\n";
    const std::string text = sample::write(sample::profile(sample::kFilament, rules), spans).text;
    std::vector<std::string> told;
    for (std::size_t from = 0, end = 0; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
        if (const auto line = text.substr(from, end - from); line.starts_with("M204") || line.starts_with("M106"))
            told.push_back(line);
    const std::vector<std::string> wanted{"M204 P1500", "M204 P500",  "M204 P1500", "M204 P500",
                                          "M106 S200",  "M204 P1500", "M106 S99"};
    EXPECT_EQ(told, wanted); // no fan below the second layer
    std::vector<double> laid;
    for (const auto& m : interpreter::read(text).moves)
        if (m.de > 0 && m.xy() > 1) laid.push_back(m.de);
    ASSERT_EQ(laid.size(), 5U);
    EXPECT_NEAR(laid[3] / laid[4], 1.5, 1e-3);
    // what begins and ends slowly takes longer
    const auto plain = sample::write(sample::profile(sample::kFilament), spans);
    const auto slow = sample::write(sample::profile(sample::kFilament, "[features.wall]\nacceleration = 100\n"), spans);
    EXPECT_GT(slow.first_pass.seconds, plain.first_pass.seconds + 0.1);
}

TEST(Program, CodesOfFeaturesNeedToBeKnown) {
    const std::string linuxcnc = "[motion]\ncontroller = \"linuxcnc\"\n";
    EXPECT_TRUE(has(
        error_of([&] { sample::profile(sample::kFilament, linuxcnc + "[features.wall]\nfan = 1\n"); }, Exit::bad_input),
        "set_fan"));
    EXPECT_TRUE(has(error_of([&] { sample::profile(sample::kFilament, "[features.wal]\nfan = 1\n"); }, Exit::bad_input),
                    "wal"));
    const auto own = sample::profile(sample::kFilament, linuxcnc + "[features]\nset_fan = \"M7 Q{fan_speed}\"\n"
                                                                   "[features.wall]\nfan = 1\n");
    EXPECT_EQ(own.features[toolpath::Feature::wall].fan, 1);
}

TEST(Program, ATravelRisesAboveAllThatIsPrinted) {
    auto spans = three_strokes();
    spans[2].points = {{10, 20, 0.2}, {10, 20, 30}, {0, 20, 30}}; // a tower
    spans[3].points = {{0, 20, 30}, {5, 5, 0.4}};
    spans[4].points = {{5, 5, 0.4}, {5, 6, 0.4}};
    const auto p = sample::profile(sample::kFilament, "[travel]\nlift = 1\n");
    const auto program = interpreter::read(sample::write(p, spans).text);
    for (const auto& m : program.moves)
        if (m.rapid && m.from.z > 6) {
            EXPECT_EQ(m.to.z, 31) << m.line;
        }
    const auto top = sample::profile(sample::kFilament, "[travel]\nlift = 390\n"); // the machine ends at 400
    for (const auto& m : interpreter::read(sample::write(top, spans).text).moves) EXPECT_LE(m.to.z, 400);
}

// Up, on a slope, along and down: each move at no more than the z axis can do.
TEST(Program, ATravelWithNormalsGoesWhereItsPointsAre) {
    auto spans = three_strokes();
    ASSERT_EQ(spans[1].role, toolpath::Role::travel);
    const geom::Vec3 a = spans[1].points.front(), b = spans[1].points.back();
    spans[1].points = {a, a + geom::Vec3{0, 0, 2}, {a.x + 3, a.y + 4, 14.2}, {b.x, b.y, 14.2}, b};
    spans[1].normals.assign(5, {0, 0, 1});
    const auto p = sample::profile(sample::kFilament, "[travel]\nlift = 1\nretract = 2\n");
    const auto program = interpreter::read(sample::write(p, spans).text);
    ASSERT_GT(program.moves.size(), 4U);
    const auto before = program.moves[4].from; // 0 to 2: to the first stroke; 3: the stroke
    std::vector<geom::Vec3> way;
    for (std::size_t i = 4; i < program.moves.size(); ++i) {
        const auto& m = program.moves[i];
        if (m.de > 0) break;
        if (m.to.z == m.from.z && m.xy() == 0) continue; // the retraction
        way.push_back({m.to.x - before.x, m.to.y - before.y, m.to.z});
        const double rise = std::abs(m.to.z - m.from.z), length = std::hypot(m.xy(), rise);
        EXPECT_LE(m.feed / 60 * rise / length, 10 + 1e-3) << m.line;
    }
    ASSERT_EQ(way.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const geom::Vec3 want = spans[1].points[i + 1];
        EXPECT_NEAR(way[i].x, want.x - a.x, 1e-3);
        EXPECT_NEAR(way[i].y, want.y - a.y, 1e-3);
        EXPECT_NEAR(way[i].z, want.z, 1e-3);
    }
}

TEST(Program, AShortTravelNeitherLiftsNorRetracts) {
    const auto p = sample::profile(sample::kFilament, "[travel]\nmin_length = 30\n");
    for (const auto& m : interpreter::read(sample::write(p, three_strokes()).text).moves) EXPECT_GE(m.de, 0);
}

TEST(Program, FeedsFollowRoleAndFirstLayerAndLimits) {
    std::vector<Span> spans{{Role::bead, 0, 0, 0, {{0, 0, 0.2}, {10, 0, 0.2}}, {0.4}, {0.2}}};
    const auto add = [&](Role role, geom::Vec3 to, double width) {
        spans.push_back({role, 0, 3, 0, {spans.back().points.back(), to}, {width}, {0.2}});
    };
    add(Role::bead, {20, 0, 0.2}, 0.4);
    add(Role::jog, {30, 0, 0.2}, 0.4);
    add(Role::lift, {40, 0, 0.4}, 0.4);
    add(Role::connector, {50, 0, 0.4}, 0.4);
    add(Role::bead, {60, 0, 0.4}, 0.9); // 0.18 mm2, so 5 mm3/s allow 27.7 mm/s
    add(Role::lift, {60, 0, 0.6}, 0.4); // straight up: lays nothing
    add(Role::lift, {61, 0, 1.6}, 0.4); // steep: 4 mm/s along z
    const auto p =
        sample::profile(sample::kFilament, "[feeds]\nbead = 50\nfirst_layer = 11\njog = 45\nlift = 22\nconnector = 9\n"
                                           "z = 4\n[motion]\nmax_speed_z = 4\n[limits]\nflow = 5\n");
    std::vector<double> feeds;
    for (const auto& m : interpreter::read(sample::write(p, spans).text).moves)
        if (m.de > 0) feeds.push_back(m.feed / 60);
    EXPECT_EQ(feeds, (std::vector<double>{11, 50, 45, 22, 9, 27, 5}));
}

TEST(Program, ABeadAboveTheLimitIsAnErrorWithItsPlace) {
    auto spans = three_strokes();
    spans[4].width = {4};
    const auto p = sample::profile(sample::kFilament, "[limits]\nsection = 0.64\n");
    const auto what = error_of([&] { (void)sample::write(p, spans); }, Exit::failure);
    EXPECT_TRUE(has(what, "on layer 1 at x 5, y 20, z 0.4") && has(what, "0.8 mm2")) << what;
    EXPECT_NO_THROW((void)sample::write(p, three_strokes()));
}

TEST(Program, APlaceOffTheBedIsAnErrorWithItsPlace) {
    auto spans = three_strokes();
    const auto p = sample::profile(sample::kFilament);
    spans[2].points[1].x = spans[3].points[0].x = -500;
    EXPECT_TRUE(has(error_of([&] { (void)sample::write(p, spans); }, Exit::failure), "on layer 0 at x -55"));
    spans = three_strokes();
    EXPECT_NO_THROW((void)sample::write(p, spans, postproc::Place::as_is));
    for (auto& s : spans)
        for (auto& q : s.points) q.x -= 0.5;
    const auto what = error_of([&] { (void)sample::write(p, spans, postproc::Place::as_is); }, Exit::failure);
    EXPECT_TRUE(has(what, "at x -0.5, y 0, z ")) << what;
    spans = three_strokes();
    spans[4].points[1].z = 401;
    EXPECT_TRUE(has(error_of([&] { (void)sample::write(p, spans); }, Exit::failure), "reaches z 0 to 400"));
}

TEST(Program, MoreMaterialThanNumbersHoldIsAnError) {
    auto spans = three_strokes();
    spans[2].width = {1e8};
    spans[2].height = {1e8};
    const auto p = sample::profile("kind = \"volume\"\n");
    EXPECT_TRUE(has(error_of([&] { (void)sample::write(p, spans); }, Exit::failure), "cannot count the material"));
}

TEST(Program, ABrokenChainOfSpansIsBadInput) {
    auto spans = three_strokes();
    spans[2].points[0].x += 0.01;
    EXPECT_TRUE(has(error_of([&] { (void)sample::write(sample::profile(sample::kFilament), spans); }, Exit::bad_input),
                    "a span of layer 0 begins at 10.01,20,0.2, 0.01 mm from where"));
    EXPECT_TRUE(has(error_of([&] { (void)sample::write(sample::profile(sample::kFilament), {}); }, Exit::bad_input),
                    "no bead"));
}

TEST(Program, TemplatesAreFilledIn) {
    auto p = sample::profile(
        sample::kFilament,
        "layer = \"; l {layer} z {z} h {height}\\nM117 {layer}\"\n"
        "start = \"M140 S{bed}\\nG4 P{time}\\n;{x_min} {x_max} {layers} {{x}}\"\n[values]\nbed = 61.5\n");
    const auto w = sample::write(p, three_strokes());
    EXPECT_TRUE(has(w.text, "M140 S61.5\n")) << w.text;
    EXPECT_TRUE(has(w.text, ";195 205 2 {x}\n"));
    EXPECT_TRUE(has(w.text, "; l 1 z 0.4 h 0.2\nM117 1\n"));
    EXPECT_TRUE(has(w.text, ";LAYER_CHANGE\n;LAYER:1\n;Z:0.4\n;HEIGHT:0.2\n"));
    EXPECT_TRUE(has(w.text, ";TYPE:Support material\n"));
    EXPECT_TRUE(has(w.text, ";WIDTH:0.4\n"));
    EXPECT_TRUE(w.text.ends_with("\n;end of program, 11 moves\n"));
    EXPECT_NE(w.text.find("\nM84\n; made by\n"), std::string::npos) << w.text.substr(w.text.size() - 100);
}

// Extruder words hold the material of turns and joins; viewers need no comment for each of them. The codes of a valve
// do not, so there every width is written.
TEST(Program, WidthsThatLastForLessThanABeadAreNotWrittenWhereTheExtruderCounts) {
    const geom::Vec3 a{0, 0, 0.2}, b{10, 0, 0.2}, c{10, 0.15, 0.2}, d{9.85, 0.15, 0.2}, e{0, 0.15, 0.2}, f{0, 5, 0.2};
    const std::vector<Span> spans{{Role::bead, 0, 0, 0, {a, b, c, d, e}, {0.4, 0.4, 0.6, 0.4, 0.4}, {0.2}},
                                  {Role::bead, 0, 0, 0, {e, f}, {0.6}, {0.2}}};
    const auto widths = [&](const std::string& extrusion) {
        const std::string text = sample::write(sample::profile(extrusion), spans).text;
        std::vector<std::string> out;
        for (std::size_t at = text.find(";WIDTH:"); at != std::string::npos; at = text.find(";WIDTH:", at + 1))
            out.push_back(text.substr(at + 7, text.find('\n', at) - at - 7));
        return out;
    };
    EXPECT_EQ(widths(sample::kFilament), (std::vector<std::string>{"0.4", "0.6"}));
    EXPECT_EQ(widths("kind = \"valve\"\non = \"M106\"\noff = \"M107\"\n"),
              (std::vector<std::string>{"0.4", "0.5", "0.4", "0.6"}));
}

TEST(Program, LineEndsAndCommentsFollowTheFormat) {
    const auto p = sample::profile(sample::kFilament, "[format]\nline_end = \"crlf\"\ncomments = \"parentheses\"\n");
    const auto text = sample::write(p, three_strokes()).text;
    EXPECT_EQ(text.find(';'), std::string::npos);
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') {
            EXPECT_EQ(text[i - 1], '\r');
        }
}

TEST(Digits, UnitsHaveNoTrailingZerosAndNoExponent) {
    const auto text = [](std::int64_t v, int d) {
        std::string out;
        postproc::append_units(out, v, d);
        return out;
    };
    EXPECT_EQ(text(12500, 3), "12.5");
    EXPECT_EQ(text(-500, 3), "-0.5");
    EXPECT_EQ(text(1, 5), "0.00001");
    EXPECT_EQ(text(0, 5), "0");
    EXPECT_EQ(text(-1200, 2), "-12");
    EXPECT_EQ(text(7, 0), "7");
    EXPECT_EQ(text(1000000000000000, 5), "10000000000");
}

TEST(Digits, CommentsCannotBecomeCode) {
    std::string out;
    postproc::append_comment(out, "a\nG28\r)(x", machine::CommentStyle::parentheses);
    EXPECT_EQ(out, "(a\\nG28\\r][x)");
    out.clear();
    postproc::append_comment(out, "a\nG28 (x)", machine::CommentStyle::semicolon);
    EXPECT_EQ(out, ";a\\nG28 (x)");
}

TEST(Digits, LongLinesAreWrapped) {
    const std::string text = " - fill" + std::string(300, 'x') + " --a=1 --b=2";
    std::string joined;
    for (const auto& l : postproc::wrapped(text, 100, "  ")) {
        EXPECT_LE(l.size(), 100u);
        joined += l;
    }
    std::erase(joined, ' ');
    std::string wanted = text;
    std::erase(wanted, ' ');
    EXPECT_EQ(joined, wanted);
}

TEST(Digits, Durations) {
    EXPECT_EQ(postproc::duration(0), "0s");
    EXPECT_EQ(postproc::duration(59.2), "1m 0s");
    EXPECT_EQ(postproc::duration(90061), "1d 1h 1m 1s");
}
