// The first stroke of machines with rotary axes: Z alone, then what turns, high up, then down along the tool; as the
// program's text has it, and as collide follows it.
#include "collision/program.hpp"
#include "geom/angle.hpp"
#include "machine/profile.hpp"
#include "postproc/measure.hpp"
#include "postproc/program.hpp"

#include <gtest/gtest.h>

using namespace filum;
using geom::Vec3;

namespace {

std::string first_program(const machine::Profile& p, const std::vector<toolpath::Span>& spans) {
    postproc::Measure measure(p, postproc::Place::center);
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

// A bead along a slope, leaning towards `turn` (degrees about z).
toolpath::Span slope(double lean_deg, double turn_deg) {
    const double lean = lean_deg * geom::kDegree, turn = turn_deg * geom::kDegree;
    const Vec3 axis{std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean)};
    toolpath::Span s{toolpath::Role::bead, 0, 0, 0, {}, {0.5}, {0.2}, {}};
    for (int i = 0; i <= 20; ++i) {
        s.points.push_back(Vec3{10, 0, 20} + static_cast<double>(i) * Vec3{-std::sin(turn), std::cos(turn), 0});
        s.normals.push_back(axis);
    }
    return s;
}

} // namespace

TEST(Approach, EveryRotaryProfileComesFromAboveAlongTheTool) {
    for (const auto& name : machine::profile_names()) {
        auto p = machine::load_profile(name);
        if (!p.axes.active() || p.axes.chain.carrier == kinematics::Carrier::frame) continue;
        ASSERT_TRUE(p.axes.start) << name;
        const bool polar = p.axes.chain.carrier == kinematics::Carrier::polar;
        const std::string text = first_program(p, {slope(polar ? 0 : 40, 130)});
        const auto read = collision::read_program(text, name, p, {0.5, 0.2, {}});
        ASSERT_FALSE(read.moves.empty()) << name;
        std::size_t first = 0;
        while (first < read.moves.size() && read.moves[first].travel) ++first;
        ASSERT_LT(first, read.moves.size()) << name;
        const Vec3 place = read.moves[first].from.tip, up = read.moves[first].from.axis;
        // The last millimetres lead along the tool, which does not turn any more.
        const auto& last = read.moves[first - 1];
        EXPECT_LT(distance(last.from.axis, last.to.axis), 1e-6) << name;
        EXPECT_LT(norm(cross(last.from.tip - place, up)), 0.02) << name;
        EXPECT_GT(dot(last.from.tip - place, up), 1) << name;
        // All moves that turn the tool are where the machine's Z is at the start's height or the approach's.
        double turned = 0;
        for (std::size_t i = 0; i < first; ++i) {
            const auto& m = read.moves[i];
            const double by = geom::angle(m.from.axis, m.to.axis);
            turned += by;
            EXPECT_TRUE(by < 1e-6 || distance(m.from.tip, place) > 50) << name << " line " << m.source;
        }
        EXPECT_NEAR(turned, (polar ? 0 : 40) * geom::kDegree, 0.1) << name;
    }
}

TEST(Approach, WithoutAStartNothingIsTakenForKnown) {
    auto p = machine::load_profile("linuxcnc-head-table");
    const auto with = collision::read_program(first_program(p, {slope(30, 0)}), "p", p, {0.5, 0.2, {}});
    p.axes.start.reset();
    const auto without = collision::read_program(first_program(p, {slope(30, 0)}), "p", p, {0.5, 0.2, {}});
    EXPECT_EQ(with.unknown, 0U);
    EXPECT_GT(without.unknown, 0U);
}
