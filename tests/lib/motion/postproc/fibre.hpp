// A fibre head to test with, and what the steps of a fibre stroke say.
#pragma once

#include "kinematics/chain.hpp"
#include "machine/profile.hpp"
#include "postproc/fibre.hpp"
#include "postproc/measure.hpp"

#include <gtest/gtest.h>

namespace filum::postproc {

using toolpath::Span;

constexpr double kCut = 45;

inline machine::Profile profile(const std::string& rest = "", const std::string& extrusion = "") {
    return machine::parse_profile(
        "name = \"test\"\n[bed]\nx = [-400, 400]\ny = [-400, 400]\nz = [-300, 400]\n[extrusion]\n" +
            (extrusion.empty() ? "kind = \"filament\"\ndiameter = 1.75\n" : extrusion) +
            "[tools]\nchange = \"T{tool_no}\"\n[fibre]\ncut_to_nozzle = 45\ncut = \"CUT\"\nprime = 7\n"
            "tension = \"WAIT\"\ntension_dwell = 1\non = \"LAY\"\noff = \"LAID\"\n" +
            rest,
        "test.toml");
}

inline Span fibre(std::vector<Vec3> points, std::uint32_t stroke = 0) {
    Span out{Role::bead, stroke, 0, 0, std::move(points), {1.0}, {0.2}, {}};
    out.tool = 1;
    return out;
}

inline Span travel(Vec3 from, Vec3 to) { return {Role::travel, 0, 0, 0, {from, to}, {}, {}, {}}; }

inline double length(const std::vector<Vec3>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
    return sum;
}

// What the steps say of a fibre stroke, told from the places of the tip alone.
struct Stroke {
    double length = 0, tail = 0, fed = 0, fed_after = 0, slow = 0;
    int cuts = 0, pauses = 0, pushes = 0;
};

struct Observation {
    std::vector<Step> steps;
    std::vector<Stroke> strokes;
    std::vector<Step> omitted;
};

inline Observation walk(const machine::Profile& p, const std::vector<Span>& spans) {
    Observation out;
    const auto w = walker(p, {}, [&](auto steps) { out.steps.insert(out.steps.end(), steps.begin(), steps.end()); });
    for (const Span& s : spans) w->add(s);
    w->end();
    Stroke now;
    Vec3 at;
    for (const Step& s : out.steps) {
        const Vec3 tip = p.axes.active() ? kinematics::forward(p.axes.chain, {s.axes, s.tilt, s.turn}).tip : s.to;
        if (s.act == Act::push) ++now.pushes;
        if (s.act == Act::cut) {
            ++now.cuts;
            now.tail = 0;
        }
        if (s.act == Act::tension) ++now.pauses;
        if (s.act == Act::omit) out.omitted.push_back(s);
        if (s.act == Act::extrude) {
            const double l = distance(at, tip);
            now.length += l;
            now.tail += l;
            now.fed += s.fed;
            if (now.cuts > 0) now.fed_after += s.fed;
            if (s.feed <= p.fibre.anchor_feed * (1 + 1e-9)) now.slow += l;
        }
        if (s.act == Act::close) {
            if (p.fibre.lays(s.tool)) out.strokes.push_back(now);
            now = {};
        }
        if (s.act == Act::travel || s.act == Act::climb || s.act == Act::extrude) at = tip;
    }
    return out;
}

// As postproc reads them, where they are.
inline FirstPass measured(const machine::Profile& p, const std::vector<Span>& spans) {
    Measure measure(p, Place::as_is);
    do
        for (const Span& s : spans) measure.add(s);
    while (measure.again());
    return measure.end();
}

inline void expect_rules(const machine::Profile& p, const Stroke& s, double length, double tolerance = 1e-3) {
    EXPECT_NEAR(s.length, length, tolerance);
    EXPECT_EQ(s.cuts, 1);
    EXPECT_NEAR(s.tail, std::min(kCut, s.length), 2e-3 + tolerance);
    EXPECT_EQ(s.fed_after, 0);
    const double anchored = std::min(p.fibre.anchor, std::max(0.0, length - kCut));
    EXPECT_NEAR(s.slow, anchored, 2e-3 + tolerance);
    EXPECT_NEAR(s.fed, p.fibre.ratio * (p.fibre.push ? length - kCut : anchored), 2e-3 + tolerance);
    EXPECT_EQ(s.pushes, 1);
}

} // namespace filum::postproc
