// Programs of machines with rotary axes, read back and driven by forward kinematics, follow the toolpath.
#include "postproc/about.hpp"
#include "postproc/measure.hpp"
#include "postproc/program.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <sstream>

using namespace filum;
using geom::Vec3;
using toolpath::Role;
using toolpath::Span;

namespace {

using std::numbers::pi;

// Rows over a dome of radius 60, the tool upright to it, joined by travels that rise along the normals.
std::vector<Span> dome(int rows, double most, int half = 30) {
    std::vector<Span> out;
    const auto at = [&](double x, double y) {
        const double r = 60, z = std::sqrt(r * r - x * x - y * y);
        return std::pair{Vec3{x, y, z - 40}, Vec3{x / r, y / r, z / r}};
    };
    for (int j = 0; j < rows; ++j) {
        Span s{Role::bead, static_cast<std::uint32_t>(j), 0, 0, {}, {1.0}, {0.2}, {}};
        for (int i = 0; i <= 2 * half; ++i) {
            const auto [p, n] = at(most * (i / static_cast<double>(half) - 1), 3.0 * (j - (rows - 1) / 2.0));
            s.points.push_back(p);
            s.normals.push_back(n);
        }
        if (!out.empty()) {
            const Vec3 a = out.back().points.back(), na = out.back().normals.back();
            const Vec3 b = s.points.front(), nb = s.normals.front();
            out.push_back({Role::travel, s.stroke, 0, 0, {a, a + 5 * na, b + 5 * nb, b}, {}, {}, {na, na, nb, nb}});
        }
        out.push_back(std::move(s));
    }
    return out;
}

machine::Profile profile(const std::string& kinematics) {
    return machine::parse_profile("name = \"test\"\n[bed]\nx = [-300, 300]\ny = [-300, 300]\nz = [-300, 400]\n"
                                  "[extrusion]\nkind = \"filament\"\ndiameter = 1.75\non = \"M7\"\noff = \"M9\"\n"
                                  "[feeds]\nbead = 20\nfirst_layer = 20\n[kinematics]\n" +
                                      kinematics + "[format]\nxyz_decimals = 4\nf_decimals = 3\n",
                                  "test.toml");
}

std::string program(const machine::Profile& p, const std::vector<Span>& spans, postproc::Place place,
                    geom::Vec2* shift = nullptr, double* seconds = nullptr) {
    postproc::Measure measure(p, place);
    for (const Span& s : spans) measure.add(s);
    while (measure.again())
        for (const Span& s : spans) measure.add(s);
    const auto first_pass = measure.end();
    if (shift) *shift = measure.walk_shift();
    if (seconds) *seconds = first_pass.seconds;
    std::string out;
    postproc::Program program(p, first_pass, measure.program_shift(), [&](std::string_view text) { out += text; });
    Notes notes;
    Facts facts;
    postproc::add_efforts(p, first_pass, "postproc", notes, facts);
    program.begin(postproc::about(p, first_pass, postproc::summary(p, first_pass, {}, notes, facts), notes));
    const auto walk = postproc::walker(p, measure.walk_shift(), [&](auto steps) { program.add(steps); });
    for (const Span& s : spans) walk->add(s);
    walk->end();
    program.end(postproc::history({}, notes, facts));
    return out;
}

struct Line {
    std::map<char, double> words; // of axes: as they stand behind it
    bool laying = false, rapid = false, moved = false;
};

// Lines with G0 or G1, with the axes that they leave out filled in.
std::vector<Line> read(const std::string& text) {
    std::vector<Line> out;
    std::istringstream in(text);
    std::string line, word;
    Line now;
    while (std::getline(in, line)) {
        line = line.substr(0, line.find(';'));
        if (line == "M7" || line == "M9") now.laying = line == "M7";
        if (line.rfind("G0 ", 0) != 0 && line.rfind("G1 ", 0) != 0) continue;
        now.rapid = line[1] == '0';
        now.words.erase('F');
        now.words.erase('E');
        now.moved = false;
        std::istringstream words(line);
        while (words >> word)
            if (word[0] != 'G') {
                now.words[word[0]] = std::stod(word.substr(1));
                now.moved = now.moved || (word[0] != 'F' && word[0] != 'E');
            }
        if (now.moved) out.push_back(now);
    }
    return out;
}

kinematics::Joints joints(const machine::MultiAxis& a, const Line& l) {
    const double degree = pi / 180;
    const double y = a.chain.carrier == kinematics::Carrier::polar ? 0 : l.words.at('Y');
    return {
        {l.words.at('X'), y, l.words.at('Z')}, l.words.at(a.tilt_letter) * degree, l.words.at(a.turn_letter) * degree};
}

double to_line(const Vec3& p, const std::vector<Span>& spans, const Vec3& shift) {
    double least = 1e9;
    for (const Span& s : spans) {
        if (s.role == Role::travel) continue;
        for (std::size_t i = 0; i + 1 < s.points.size(); ++i) {
            const Vec3 a = s.points[i] + shift, d = s.points[i + 1] - s.points[i];
            const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
            least = std::min(least, distance(p, a + t * d));
        }
    }
    return least;
}

const char* const kMachines[] = {
    "carrier = \"table-table\"\ntilt_letter = \"A\"\ntilt_about = \"x\"\ntilt_point_y = 5\ntilt_point_z = -20\n"
    "turn_point_x = 3\n",
    "carrier = \"table-table\"\ntilt_letter = \"B\"\ntilt_about = \"-y\"\nturn_reversed = true\n",
    "carrier = \"head-table\"\ntilt_letter = \"B\"\ntip_to_tilt_z = 100\ntip_to_tilt_x = 2\n",
    "carrier = \"head-head\"\ntilt_letter = \"B\"\ntip_to_tilt_z = 80\ntilt_to_turn_x = 4\n",
    "carrier = \"polar\"\ntilt_letter = \"B\"\ntip_to_tilt_z = 90\n",
};

// Seven loops round the pole, one above the other.
Span loops_round_the_pole() {
    Span loops{Role::bead, 0, 0, 0, {}, {1.0}, {0.2}, {}};
    for (int i = 0; i <= 7 * 90; ++i) {
        const double h = 2 * pi * i / 90, tilt = 0.5;
        const Vec3 n{std::sin(tilt) * std::cos(h), std::sin(tilt) * std::sin(h), std::cos(tilt)};
        loops.points.push_back(20 * n + Vec3{0, 0, 0.3 * h});
        loops.normals.push_back(n);
    }
    return loops;
}

} // namespace

// Numbers are the joints: wherever the axes are on their straight way, the tip lies on a bead.
TEST(Tilted, JointsBringTheTipAlongTheBeads) {
    const auto spans = dome(5, 35); // the middle row passes the pole
    for (const char* machine : kMachines) {
        const auto p = profile(std::string(machine) + "orientation_deg = 1\n");
        geom::Vec2 shift;
        const auto lines = read(program(p, spans, postproc::Place::center, &shift));
        ASSERT_GT(lines.size(), 240U);
        double off = 0, lean = 0;
        std::size_t laid = 0;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            if (!lines[i].laying) continue;
            ++laid;
            const auto a = joints(p.axes, lines[i - 1]), b = joints(p.axes, lines[i]);
            for (double f = 0.125; f <= 1; f += 0.125) {
                const kinematics::Joints here{a.xyz + f * (b.xyz - a.xyz), a.tilt + f * (b.tilt - a.tilt),
                                              a.turn + f * (b.turn - a.turn)};
                const auto pose = kinematics::forward(p.axes.chain, here);
                off = std::max(off, to_line(pose.tip, spans, {shift.x, shift.y, 0}));
                const Vec3 normal = 1.0 / 60 * (pose.tip - Vec3{shift.x, shift.y, -40});
                lean = std::max(lean, geom::angle(pose.axis, normal));
            }
        }
        EXPECT_GE(laid, 240U);
        EXPECT_LE(off, 0.005) << machine;
        EXPECT_LE(lean, 1.05 * pi / 180) << machine;
    }
}

// Where the toolpath's own points are far apart, the tool still stays along the straight way between their normals.
TEST(Tilted, FewPointsDoNotMakeTheToolLean) {
    const auto spans = dome(5, 35, 3); // 11 mm and up to 15 degrees a move
    for (const char* machine : kMachines)
        for (const char* numbers : {"", "numbers = \"tip\"\ntcp_on = \"M428\"\n"}) {
            const bool polar = std::string(machine).find("polar") != std::string::npos;
            if (polar) continue; // its axis lies on the radius, not on the way between two
            const auto p = profile(std::string(machine) + numbers + "orientation_deg = 1\n");
            const auto lines = read(program(p, spans, postproc::Place::as_is));
            double lean = 0;
            for (std::size_t i = 1; i < lines.size(); ++i) {
                if (!lines[i].laying) continue;
                const auto a = joints(p.axes, lines[i - 1]), b = joints(p.axes, lines[i]);
                for (double f = 0.125; f <= 1; f += 0.125) {
                    kinematics::Joints here{a.xyz + f * (b.xyz - a.xyz), a.tilt + f * (b.tilt - a.tilt),
                                            a.turn + f * (b.turn - a.turn)};
                    auto pose = kinematics::forward(p.axes.chain, here);
                    if (*numbers != '\0') pose.tip = here.xyz;
                    double least = 1e9; // to the axis that the nearest way asks for
                    Vec3 want;
                    for (const Span& s : spans)
                        for (std::size_t k = 0; s.role == Role::bead && k + 1 < s.points.size(); ++k) {
                            const Vec3 d = s.points[k + 1] - s.points[k];
                            const double t = std::clamp(dot(pose.tip - s.points[k], d) / dot(d, d), 0.0, 1.0);
                            const double off = distance(pose.tip, s.points[k] + t * d);
                            if (off < least) {
                                least = off;
                                want = (1 - t) * s.normals[k] + t * s.normals[k + 1];
                            }
                        }
                    lean = std::max(lean, geom::angle(pose.axis, want));
                }
            }
            EXPECT_LE(lean, 1.05 * pi / 180) << machine << numbers;
        }
}

// Numbers are the tip: X Y Z are the toolpath's own, the rotary words those of the other program.
TEST(Tilted, TipNumbersAreTheToolpath) {
    const auto spans = dome(3, 30);
    const auto p = profile(std::string(kMachines[0]) + "numbers = \"tip\"\ntcp_on = \"M428\"\ntcp_off = \"M429\"\n");
    const std::string text = program(p, spans, postproc::Place::as_is);
    EXPECT_LT(text.find("\nM428\n"), text.find("\nG93\n"));
    EXPECT_LT(text.find("\nG94\n"), text.find("\nM429\n"));
    EXPECT_NE(text.find("tip in the part's frame"), std::string::npos);
    std::size_t k = 0;
    std::vector<Vec3> want;
    for (const Span& s : spans)
        if (s.role == Role::bead) want.insert(want.end(), s.points.begin() + 1, s.points.end());
    for (const Line& l : read(text)) {
        if (!l.laying) continue;
        ASSERT_LT(k, want.size());
        EXPECT_LT(distance(Vec3{l.words.at('X'), l.words.at('Y'), l.words.at('Z')}, want[k]), 1e-4);
        ++k;
    }
    EXPECT_EQ(k, want.size());
}

// F says how long each move takes: the tip's feed where the axes can follow, slower where they cannot.
TEST(Tilted, FeedsKeepTheSpeedsOfAllAxes) {
    const auto spans = dome(3, 40);
    const auto p = profile(std::string(kMachines[0]) + "tilt_speed_deg = 20\nturn_speed_deg = 15\n"
                                                       "turn_acceleration_deg = 300\norientation_deg = 0.5\n");
    double seconds = 0, sum = 0;
    const auto lines = read(program(p, spans, postproc::Place::center, nullptr, &seconds));
    std::size_t slowed = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].rapid) continue;
        ASSERT_TRUE(lines[i].words.contains('F')); // inverse time needs one on every line
        const double t = 60 / lines[i].words.at('F');
        sum += t;
        const auto a = joints(p.axes, lines[i - 1]), b = joints(p.axes, lines[i]);
        EXPECT_LE(std::abs(b.tilt - a.tilt) / t, 20.1 * pi / 180);
        EXPECT_LE(std::abs(b.turn - a.turn) / t, 15.1 * pi / 180);
        const auto from = kinematics::forward(p.axes.chain, a).tip, to = kinematics::forward(p.axes.chain, b).tip;
        if (!lines[i].laying) continue;
        EXPECT_LE(distance(from, to) / t, 20.2);
        slowed += distance(from, to) / t < 15 ? 1 : 0;
    }
    EXPECT_GT(slowed, 0U);
    EXPECT_NEAR(sum, seconds, 0.02 * seconds);
}

// A head that carries the tool must not scrape along the face on its way to where the machine parks.
TEST(Tilted, TheToolLeavesTheLastStrokeAlongItsAxis) {
    const Vec3 n{-0.6, 0, 0.8};
    Span side{Role::bead, 0, 0, 0, {{-30, 0, 5}, {-10, 0, 5}}, {1.0}, {0.2}, {n, n}};
    for (const char* machine : kMachines) {
        const auto p = profile(machine);
        const auto lines = read(program(p, {side}, postproc::Place::as_is));
        std::size_t last = 0;
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (lines[i].laying) last = i;
        ASSERT_LT(last + 1, lines.size()) << machine;
        const auto pose = kinematics::forward(p.axes.chain, joints(p.axes, lines.back()));
        const Vec3 way = pose.tip - side.points.back();
        EXPECT_GE(norm(way), p.travel.lift - 1e-3) << machine;
        EXPECT_NEAR(dot(way, n), norm(way), 1e-3) << machine;
        EXPECT_LT(geom::angle(pose.axis, n), 1e-4) << machine;
    }
}

// The far side of a long part, turned up, is higher than the part.
TEST(Tilted, TheEndTemplateDoesNotLeadBackIntoWhatIsTurnedUp) {
    auto p = profile(kMachines[0]);
    p.templates.end = "G0 Z{z_park}\n";
    Span side{Role::bead, 0, 0, 0, {{-10, -150, 5}, {10, -150, 5}}, {1.0}, {0.2}, {{0, -1, 0}, {0, -1, 0}}};
    double top = 0; // of the z axis
    for (const Line& l : read(program(p, {side}, postproc::Place::as_is)))
        if (l.laying) top = std::max(top, l.words.at('Z'));
    EXPECT_GT(top, 100);
    for (const auto numbers : {machine::Numbers::joints, machine::Numbers::tip}) {
        p.axes.numbers = numbers;
        p.axes.tcp_on = "M428";
        p.axes.tcp_off = "M429";
        EXPECT_GE(read(program(p, {side}, postproc::Place::as_is)).back().words.at('Z'), top + 10 - 1e-3);
    }
}

// One loop after the other round the pole: a turn axis of two turns must unwind in the air, tip and tool kept below.
TEST(Tilted, AStrokeThatCannotGoOnIsBrokenToUnwind) {
    const Span loops = loops_round_the_pole();
    const std::string limits = "turn_deg = [-370, 370]\n";
    for (const char* machine : kMachines) {
        const auto p = profile(machine + limits);
        const std::string text = program(p, {loops}, postproc::Place::as_is);
        EXPECT_NE(text.find("postproc: unwinds = 3"), std::string::npos) << machine; // seven turns on two
        double farthest = 0, lean = 0;
        std::size_t strokes = 0, turned_low = 0;
        auto lines = read(text);
        for (std::size_t i = 1; i < lines.size(); ++i) {
            const auto a = joints(p.axes, lines[i - 1]), b = joints(p.axes, lines[i]);
            EXPECT_LE(std::abs(b.turn), 370.1 * pi / 180);
            strokes += lines[i].laying && !lines[i - 1].laying ? 1 : 0;
            const auto pose = kinematics::forward(p.axes.chain, b);
            if (lines[i].laying) {
                farthest = std::max(farthest, to_line(pose.tip, {loops}, {}));
                lean = std::max(lean, std::abs(geom::angle(pose.axis, {0, 0, 1}) - 0.5));
            } else if (std::abs(b.turn - a.turn) > 1) { // unwinding: upright, above all that was laid
                turned_low += pose.tip.z < 20 * std::cos(0.5) + 0.3 * 14 * pi ? 1 : 0;
                EXPECT_LT(geom::angle(pose.axis, {0, 0, 1}), 1e-4);
            }
        }
        EXPECT_EQ(strokes, 4U);
        EXPECT_EQ(turned_low, 0U);
        EXPECT_LE(farthest, 0.002);
        EXPECT_LE(lean, 1e-4);
    }
}

// Lifting would tear a fibre off: the job must break it where it can be cut.
TEST(Tilted, AFibreIsNotLiftedToUnwind) {
    Span loops = loops_round_the_pole();
    loops.tool = 1;
    const auto p = profile(std::string(kMachines[0]) + "turn_deg = [-370, 370]\n[tools]\nchange = \"T{tool_no}\"\n" +
                           "[fibre]\ncut_to_nozzle = 45\ncut = \"CUT\"\n");
    try {
        program(p, {loops}, postproc::Place::as_is);
        ADD_FAILURE() << "it was laid";
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::failure);
        EXPECT_NE(std::string(e.what()).find("a stroke of fibre cannot be lifted"), std::string::npos) << e.what();
    }
}

TEST(Tilted, WhatTheAxesCannotReachIsNamed) {
    const auto spans = dome(2, 40);
    const auto refused = [&](const std::string& more, const char* word) {
        const auto p = profile(std::string(kMachines[0]) + more);
        try {
            program(p, spans, postproc::Place::center);
            ADD_FAILURE() << more;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::failure);
            EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    refused("tilt_deg = [-20, 20]\n", "tilt axis");
    refused("turn_deg = [0, 10]\n", "turn axis");
    EXPECT_THROW(profile("carrier = \"table-table\"\ntilt_letter = \"C\"\n"), Error);
    EXPECT_THROW(profile("carrier = \"table-table\"\nnumbers = \"tip\"\n"), Error);
    EXPECT_THROW(profile("carrier = \"table-table\"\ntilt_deg = [3, 3]\n"), Error);
}
