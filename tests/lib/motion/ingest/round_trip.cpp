// What postproc writes comes back within its decimals, for every profile that writes G-code.
#include "postproc/about.hpp"
#include "postproc/measure.hpp"
#include "postproc/program.hpp"
#include "read.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

using namespace filum;
using toolpath::Role;
using toolpath::Span;

namespace {

// Three strokes on two layers: beads of changing width, a lift, a jog, travels.
std::vector<Span> sample_path(bool leans, geom::Vec2 from) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0, 1);
    std::vector<Span> out;
    const auto place = [&](double x, double y, double z) { return geom::Vec3{from.x + x, from.y + y, z}; };
    geom::Vec3 at = place(0, 0, 0.2);
    const auto add = [&](Role role, std::uint32_t stroke, std::uint32_t layer, std::vector<geom::Vec3> points) {
        Span s;
        s.role = role;
        s.stroke = stroke;
        s.layer = layer;
        points.insert(points.begin(), at);
        s.points = points;
        if (toolpath::extrudes(role)) {
            s.height = {0.2};
            for (std::size_t i = 0; i < points.size(); ++i)
                s.width.push_back(role == Role::lift ? 0.4 : 0.35 + 0.1 * any(random));
            if (role == Role::lift) s.width = {0.4};
        }
        if (leans)
            for (const auto& p : points) {
                const geom::Vec3 lean{0.2 * std::sin(p.x / 9), 0.2 * std::cos(p.y / 9), 1};
                s.normals.push_back((1 / norm(lean)) * lean);
            }
        at = points.back();
        out.push_back(s);
    };
    const auto walk = [&](double z) {
        std::vector<geom::Vec3> points;
        for (int k = 1; k <= 60; ++k) points.push_back(place(0.5 * k * any(random), 25 * any(random), z));
        return points;
    };
    add(Role::bead, 0, 0, walk(0.2));
    add(Role::travel, 1, 0, {place(20, 20, 0.2)});
    add(Role::bead, 1, 0, walk(0.2));
    add(Role::lift, 1, 1, {{at.x, at.y, 0.4}});
    add(Role::bead, 1, 1, walk(0.4));
    add(Role::travel, 2, 1, {place(5, 24, 0.4)});
    add(Role::bead, 2, 1, walk(0.4));
    return out;
}

std::string written(const machine::Profile& p, const std::vector<Span>& spans) {
    postproc::Measure measure(p, postproc::Place::as_is);
    for (const Span& s : spans) measure.add(s);
    while (measure.again())
        for (const Span& s : spans) measure.add(s);
    const auto first_pass = measure.end();
    std::string out;
    const auto to = postproc::writer(p, first_pass, measure.program_shift(), [&](std::string_view t) { out += t; });
    to->begin(postproc::about(p, first_pass, {}, {}));
    const auto walk = postproc::walker(
        p, measure.walk_shift(), [&](auto steps) { to->add(steps); }, measure.joins());
    for (const Span& s : spans) walk->add(measure.turned(s));
    walk->end();
    to->end({});
    return out;
}

// How far a point is from the beads of a path.
double off(const geom::Vec3& p, const std::vector<Span>& spans) {
    double least = 1e9;
    for (const Span& s : spans)
        for (std::size_t i = 0; toolpath::fills(s.role) && i + 1 < s.points.size(); ++i) {
            const geom::Vec3 a = s.points[i], way = s.points[i + 1] - a;
            const double t = std::clamp(dot(p - a, way) / std::max(dot(way, way), 1e-12), 0.0, 1.0);
            least = std::min(least, distance(p, a + t * way));
        }
    return least;
}

} // namespace

class RoundTrip : public testing::TestWithParam<std::string> {};

TEST_P(RoundTrip, ComesBack) {
    machine::Profile p = machine::load_profile(GetParam());
    if (p.axes.chain.carrier == kinematics::Carrier::frame) GTEST_SKIP() << "a robot's language";
    const bool leans = p.axes.active() && p.axes.chain.carrier != kinematics::Carrier::polar;
    const auto spans = sample_path(leans, p.bed.centre() - geom::Vec2{15, 12});
    const std::string text = written(p, spans);
    ingest::Options options;
    if (p.extrusion.feeding == machine::Feeding::valve) options.bead = {0.4, 0.2};
    const auto back = ingested::read(text, options, p);
    EXPECT_EQ(back.found.counts.strokes, 3u);
    EXPECT_EQ(back.found.counts.stops, 2u);
    const double grid = std::pow(10.0, -p.format.xyz_decimals), chord = leans ? p.axes.chord : 0;
    EXPECT_NEAR(ingested::length(back.spans), ingested::length(spans), 0.001 * ingested::length(spans));
    const bool valve = p.extrusion.feeding == machine::Feeding::valve;
    const double volume = ingested::volume(spans);
    EXPECT_NEAR(ingested::volume(back.spans), volume, (valve ? 0.05 : 0.001) * volume);
    const double shift_free = grid + chord + 0.003;
    // the part may stand elsewhere on a machine with rotary axes: move it back by its first point
    const geom::Vec3 by =
        p.axes.active() ? spans.front().points.front() - back.spans.front().points.front() : geom::Vec3{};
    double worst = 0;
    for (const Span& s : back.spans)
        for (std::size_t i = 0; toolpath::fills(s.role) && i < s.points.size(); ++i)
            worst = std::max(worst, off(s.points[i] + by, spans));
    EXPECT_LE(worst, (p.axes.active() ? 2 : 1) * shift_free);
    double there = 0;
    std::vector<Span> moved = back.spans;
    for (Span& s : moved)
        for (auto& q : s.points) q = q + by;
    for (const Span& s : spans)
        for (std::size_t i = 0; toolpath::fills(s.role) && i < s.points.size(); ++i)
            there = std::max(there, off(s.points[i], moved));
    EXPECT_LE(there, (p.axes.active() ? 2 : 1) * shift_free);
    for (const Span& s : back.spans) EXPECT_EQ(s.normals.size(), p.axes.active() ? s.points.size() : 0);
}

namespace {

// One stroke on one level after the other: pieces of every role and feature, each from where the one before ended.
std::vector<Span> pieces_of_every_kind(std::mt19937& random, geom::Vec2 from) {
    constexpr std::array kRoles{Role::bead, Role::bead, Role::jog, Role::connector, Role::lift, Role::hairpin};
    std::uniform_real_distribution<double> any(0, 1);
    std::vector<Span> out;
    geom::Vec3 at{from.x, from.y, 0.2};
    for (int i = 0; i < 120; ++i) {
        Span s;
        s.role = kRoles[random() % kRoles.size()];
        s.feature = static_cast<toolpath::Feature>(random() % toolpath::kFeatures);
        s.layer = static_cast<std::uint32_t>(std::lround(at.z / 0.2)) - 1;
        s.points = {at};
        const double rise = s.role == Role::lift ? 0.2 : 0;
        for (int k = 1; k <= 5; ++k)
            s.points.push_back({from.x + 25 * any(random), from.y + 20 * any(random), at.z + rise * k / 5});
        s.height = {0.2};
        s.width = {0.3 + 0.2 * any(random)};
        at = s.points.back();
        out.push_back(s);
    }
    return out;
}

std::map<std::pair<Role, toolpath::Feature>, std::pair<double, double>> sums(const std::vector<Span>& spans) {
    std::map<std::pair<Role, toolpath::Feature>, std::pair<double, double>> out; // mm, mm3
    for (const Span& s : spans)
        for (std::size_t i = 0; toolpath::extrudes(s.role) && i + 1 < s.points.size(); ++i) {
            auto& [length, volume] = out[{s.role, s.feature}];
            length += distance(s.points[i], s.points[i + 1]);
            volume += toolpath::volume(s, i);
        }
    return out;
}

} // namespace

// Perimeters are no lifts, gap fill is no jog, supports are no connectors, though viewers know them by the same names.
TEST_P(RoundTrip, RolesAndFeaturesComeBack) {
    machine::Profile p = machine::load_profile(GetParam());
    if (p.axes.chain.carrier == kinematics::Carrier::frame) GTEST_SKIP() << "a robot's language";
    std::mt19937 random(7);
    for (int trial = 0; trial < 3; ++trial) {
        const auto spans = pieces_of_every_kind(random, p.bed.centre() - geom::Vec2{12, 10});
        ingest::Options options;
        if (p.extrusion.feeding == machine::Feeding::valve) options.bead = {0.4, 0.2};
        const auto wanted = sums(spans), got = sums(ingested::read(written(p, spans), options, p).spans);
        constexpr double kShare = 0.005;
        for (const auto& [kind, sum] : wanted) {
            const auto found = got.find(kind);
            ASSERT_NE(found, got.end()) << toolpath::kRoleNames[static_cast<std::size_t>(kind.first)] << " "
                                        << toolpath::kFeatureNames[static_cast<std::size_t>(kind.second)];
            EXPECT_NEAR(found->second.first, sum.first, kShare * sum.first);
            if (p.extrusion.feeding != machine::Feeding::valve) {
                EXPECT_NEAR(found->second.second, sum.second, kShare * sum.second);
            }
        }
        EXPECT_EQ(got.size(), wanted.size());
    }
}

INSTANTIATE_TEST_SUITE_P(Profiles, RoundTrip, testing::ValuesIn(machine::profile_names()), [](const auto& info) {
    std::string name = info.param;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
});
