// What a program says, read by another reader, is the toolpath again: places, order, material.
#include "interpreter.hpp"
#include "sample.hpp"

#include "toolpath/path.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

using namespace filum;

namespace {

const char* const kMarked = "kind = \"filament\"\ndiameter = 1.75\non = \"M7\"\noff = \"M9\"\n";
const char* const kAbsolute = "kind = \"filament\"\ndiameter = 1.75\nmode = \"absolute\"\n";
const char* const kAxis = "kind = \"filament\"\ndiameter = 1.75\nmode = \"absolute\"\nletter = \"A\"\n";
const char* const kPlunger = "kind = \"plunger\"\ndiameter = 14.5\n";
const double kFilamentArea = std::numbers::pi * 1.75 * 1.75 / 4;

long um(double v) { return std::lround(v * 1000); }

using Place = std::array<long, 3>;
using Strokes = std::vector<std::vector<Place>>;

// um: that a place is off which is not moved to, and the rounding of both.
constexpr double kNear = 3;
double apart(const Place& a, const Place& b) {
    return std::hypot(static_cast<double>(a[0] - b[0]), static_cast<double>(a[1] - b[1]),
                      static_cast<double>(a[2] - b[2]));
}

// A stroke too short to be seen has one place, or none that shows.
Strokes visible(Strokes strokes) {
    const auto seen = [](const auto& s) {
        return std::any_of(s.begin(), s.end(), [&](const Place& p) { return apart(p, s.front()) > kNear; });
    };
    std::erase_if(strokes, [&](const auto& s) { return !seen(s); });
    return strokes;
}

// The same strokes, but that places nearer to each other than any move may be need not be among those moved to.
bool alike(const Strokes& given, const Strokes& moved) {
    if (given.size() != moved.size()) return false;
    for (std::size_t s = 0; s < given.size(); ++s) {
        std::size_t k = 0;
        if (given[s].front() != moved[s].front() || given[s].back() != moved[s].back()) return false;
        for (const Place& p : given[s]) {
            if (k + 1 < moved[s].size() && p == moved[s][k + 1]) ++k;
            const bool near =
                apart(p, moved[s][k]) <= kNear || (k + 1 < moved[s].size() && apart(p, moved[s][k + 1]) <= kNear);
            if (!near) return false;
        }
        if (k + 1 != moved[s].size()) return false; // a place that was not given
    }
    return true;
}

// The places of a toolpath's strokes as the last decimal shows them, equal neighbours once.
Strokes places(const std::vector<sample::Span>& spans, geom::Vec2 shift) {
    Strokes out;
    bool broken = true;
    for (const auto& s : spans) {
        if (s.role == toolpath::Role::travel) {
            broken = true;
            continue;
        }
        if (broken) out.emplace_back();
        broken = false;
        for (const auto& p : s.points) {
            const Place q{um(p.x + shift.x), um(p.y + shift.y), um(p.z)};
            if (out.back().empty() || out.back().back() != q) out.back().push_back(q);
        }
    }
    return visible(out);
}

// The same from a program whose strokes begin with M7 and end with M9.
Strokes places(const interpreter::Program& program) {
    Strokes out;
    for (const auto& m : program.moves) {
        if (m.stroke == 0) continue;
        EXPECT_FALSE(m.rapid);
        const auto stroke = static_cast<std::size_t>(m.stroke);
        if (stroke > out.size()) out.resize(stroke), out.back() = {{um(m.from.x), um(m.from.y), um(m.from.z)}};
        if (m.xy() > 0 || m.to.z != m.from.z) out.back().push_back({um(m.to.x), um(m.to.y), um(m.to.z)});
    }
    return visible(out);
}

// What was laid in all: every retraction is given back, so the sum is the bead.
double laid(const interpreter::Program& program) {
    double sum = 0;
    for (const auto& m : program.moves) sum += m.de;
    return sum;
}

} // namespace

TEST(ParseBack, PlacesAreTheToolpathsRounded) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto spans = sample::random_toolpath(seed);
        const auto w = sample::write(sample::profile(kMarked), spans);
        EXPECT_TRUE(alike(places(spans, w.shift), places(interpreter::read(w.text)))) << "seed " << seed;
    }
}

TEST(ParseBack, MaterialIsExactInEveryMode) {
    struct Case {
        const char* extrusion;
        char letter;
        double area, unit;
    };
    const Case cases[] = {{sample::kFilament, 'E', kFilamentArea, 1e-5},
                          {kAbsolute, 'E', kFilamentArea, 1e-5},
                          {kAxis, 'A', kFilamentArea, 1e-5},
                          {kPlunger, 'E', std::numbers::pi * 14.5 * 14.5 / 4, 1e-5},
                          {"kind = \"volume\"\n", 'E', 1, 1e-5}};
    for (const auto& c : cases)
        for (unsigned seed = 1; seed <= 10; ++seed) {
            const auto spans = sample::random_toolpath(seed);
            const auto program = interpreter::read(sample::write(sample::profile(c.extrusion), spans).text, c.letter);
            const double wanted = sample::volume(spans) / c.area;
            EXPECT_NEAR(laid(program), wanted, 0.51 * c.unit + 1e-9) << c.extrusion << " seed " << seed;
        }
}

TEST(ParseBack, AbsoluteAndRelativeLayTheSameMoveByMove) {
    const auto spans = sample::random_toolpath(7, 12);
    const auto a = interpreter::read(sample::write(sample::profile(sample::kFilament), spans).text);
    const auto b = interpreter::read(sample::write(sample::profile(kAbsolute), spans).text);
    ASSERT_EQ(a.moves.size(), b.moves.size());
    for (std::size_t i = 0; i < a.moves.size(); ++i) EXPECT_NEAR(a.moves[i].de, b.moves[i].de, 1e-9) << a.moves[i].line;
}

TEST(ParseBack, EachMoveHasItsOwnMaterialWithinOneUnit) {
    // no move here is too short to be seen, so none hands material on
    std::vector<sample::Span> spans{{toolpath::Role::bead, 0, 0, 0, {{0, 0, 0.2}}, {}, {0.2}}};
    for (int i = 1; i < 2000; ++i) spans[0].points.push_back({0.0137 * i, 3 * std::sin(0.01 * i), 0.2});
    for (int i = 0; i < 2000; ++i) spans[0].width.push_back(0.4 + 0.2 * std::sin(0.1 * i));
    const auto program = interpreter::read(sample::write(sample::profile(sample::kFilament), spans).text);
    std::size_t i = 0;
    for (const auto& m : program.moves) {
        if (m.de <= 0) continue;
        EXPECT_NEAR(m.de, toolpath::volume(spans[0], i++) / kFilamentArea, 1.01e-5);
    }
    EXPECT_EQ(i, 1999u);
}

TEST(ParseBack, ManyTinyMovesLoseNothing) {
    // 0.3 um each: none shows by itself
    std::vector<sample::Span> spans{{toolpath::Role::bead, 0, 0, 0, {}, {0.4}, {0.2}}};
    for (int i = 0; i <= 100000; ++i) spans[0].points.push_back({0.0003 * i, 0, 0.2});
    const auto program = interpreter::read(sample::write(sample::profile(sample::kFilament), spans).text);
    EXPECT_NEAR(laid(program), 30 * 0.08 / kFilamentArea, 0.51e-5);
    EXPECT_GT(program.moves.size(), 24000u); // four of them to a move
    EXPECT_LT(program.moves.size(), 25010u);
    for (const auto& m : program.moves) EXPECT_FALSE(m.de > 0 && m.xy() > 0 && m.xy() < 0.001 - 1e-9) << m.line;
}

TEST(ParseBack, NothingWithoutMaterialAndNothingTakenBackWithinAStroke) {
    for (unsigned seed = 30; seed < 40; ++seed) {
        const auto spans = sample::random_toolpath(seed, 3);
        const auto w = sample::write(sample::profile(kMarked, "[travel]\nretract = 1.5\n"), spans);
        std::size_t retractions = 0;
        double dry = 0; // mm in one run without material
        for (const auto& m : interpreter::read(w.text).moves) {
            if (m.de < 0) {
                EXPECT_NEAR(m.de, -1.5, 1e-9);
                EXPECT_EQ(m.xy(), 0);
                EXPECT_EQ(m.stroke, 0);
                ++retractions;
            }
            dry = m.stroke == 0 || m.de > 0 ? 0 : dry + m.xy();
            EXPECT_LT(dry, 0.003) << m.line; // a move may be too short for a unit of material
        }
        EXPECT_EQ(retractions, 2u);
    }
}

TEST(ParseBack, WordsStandOnlyWhereTheyChange) {
    const auto program =
        interpreter::read(sample::write(sample::profile(sample::kFilament), sample::random_toolpath(3)).text);
    double feed = -1;
    for (const auto& m : program.moves) {
        if (std::isnan(m.from.x)) continue; // on the way to the first place
        EXPECT_EQ(m.line.find(" X") != std::string::npos, !(m.from.x == m.to.x)) << m.line;
        EXPECT_EQ(m.line.find(" Y") != std::string::npos, !(m.from.y == m.to.y)) << m.line;
        EXPECT_EQ(m.line.find(" Z") != std::string::npos, !(m.from.z == m.to.z)) << m.line;
        EXPECT_EQ(m.line.find(" F") != std::string::npos, m.feed != feed) << m.line;
        feed = m.feed;
    }
}

TEST(ParseBack, AValveOpensAndClosesOncePerStroke) {
    const auto spans = sample::random_toolpath(5, 7);
    const auto w = sample::write(sample::profile("kind = \"valve\"\non = \"M760\\nG4 P50\"\noff = \"M761\"\n"), spans);
    const auto program = interpreter::read(w.text, '?'); // no letter: any extruder word is an error
    std::vector<std::string> codes;
    for (const auto& c : program.other)
        if (c == "M760" || c == "M761") codes.push_back(c);
    ASSERT_EQ(codes.size(), 14u);
    for (std::size_t i = 0; i < codes.size(); ++i) EXPECT_EQ(codes[i], i % 2 == 0 ? "M760" : "M761");
}

TEST(ParseBack, ThePartIsCentredByWholeMicrometres) {
    const auto spans = sample::random_toolpath(11);
    const auto p = sample::profile(kMarked);
    const auto centred = sample::write(p, spans);
    EXPECT_NEAR((centred.first_pass.low[0].value + centred.first_pass.high[0].value) / 2 + centred.shift.x, 200, 1e-3);
    EXPECT_NEAR((centred.first_pass.low[1].value + centred.first_pass.high[1].value) / 2 + centred.shift.y, 200, 1e-3);
    EXPECT_NEAR(centred.shift.x * 1000, std::round(centred.shift.x * 1000), 1e-6);
    auto moved = spans;
    for (auto& s : moved)
        for (auto& q : s.points) {
            q.x += 100;
            q.y += 100;
        }
    const auto kept = sample::write(p, moved, postproc::Place::as_is);
    EXPECT_EQ(kept.shift, (geom::Vec2{0, 0}));
    EXPECT_TRUE(alike(places(moved, {0, 0}), places(interpreter::read(kept.text))));
}
