// Stacks of regions, the toolpaths made of them, and what holds for every toolpath.
#pragma once

#include "../../crossings.hpp"
#include "curves.hpp"
#include "link3d/linker.hpp"

#include <gtest/gtest.h>

#include <map>

namespace filum::link3d::test {

using geom::Vec3;
using toolpath::RegionPaths;
using toolpath::Role;
using toolpath::Span;

inline constexpr double kHeight = 0.2;

struct Result {
    std::vector<Span> spans;
    Notes notes;
    Counts counts;
};

inline Result link(const std::vector<RegionPaths>& regions, const Options& options = {}) {
    Result r;
    Linker linker(options);
    const auto emit = [&](const Span& s) { r.spans.push_back(s); };
    for (const auto& region : regions) linker.add(region, emit, r.notes);
    linker.finish(emit, r.notes);
    r.counts = linker.counts();
    return r;
}

inline RegionPaths region(std::uint32_t id, std::uint32_t layer, Join join, std::vector<Curve> curves) {
    RegionPaths r;
    r.region = id;
    r.layer = layer;
    r.z = kHeight * (layer + 1);
    r.height = kHeight;
    r.area = 1;
    r.join = join;
    r.curves = std::move(curves);
    return r;
}

// A column: one region per layer, each climbing from the one below.
inline std::vector<RegionPaths> column(const std::vector<std::vector<Curve>>& layers) {
    std::vector<RegionPaths> out;
    for (std::uint32_t i = 0; i < layers.size(); ++i)
        out.push_back(region(i, i, i == 0 ? Join::start : Join::vertical, layers[i]));
    return out;
}

inline double volume(const Result& r, bool beads_only) {
    double v = 0;
    for (const auto& s : r.spans)
        for (std::size_t i = 0; i + 1 < s.points.size(); ++i)
            if (!beads_only || s.role == Role::bead) v += toolpath::volume(s, i);
    return v;
}

// Pairs of extruded segments of one height that cross.
inline std::size_t crossings(const std::vector<Span>& spans) {
    std::map<double, std::vector<geom::Segment>> at;
    for (const auto& s : spans)
        for (std::size_t i = 0; i + 1 < s.points.size(); ++i)
            if (toolpath::extrudes(s.role) && s.points[i].z == s.points[i + 1].z)
                at[s.points[i].z].push_back({s.points[i].xy(), s.points[i + 1].xy()});
    std::size_t n = 0;
    for (const auto& [z, line] : at) n += filum::test::crossing_pairs_of(line);
    return n;
}

// What holds for every toolpath.
inline void check(const std::vector<RegionPaths>& regions, const Result& r) {
    std::uint64_t reasons = 0; // every stroke more than planned has one in a note
    for (const Note& n : r.notes)
        if (code_name(n).starts_with("join-") || code_name(n).starts_with("break-") ||
            n.code == NoteCode::connector_impossible)
            reasons += n.count;
    EXPECT_EQ(reasons, r.counts.broken + r.counts.parted);
    EXPECT_LE(r.counts.strokes, r.counts.planned + reasons);
    std::uint64_t breaks = 0;
    std::map<Role, std::uint64_t> spans;
    for (std::size_t i = 0; i < r.spans.size(); ++i) {
        const Span& s = r.spans[i];
        ++spans[s.role];
        ASSERT_GE(s.points.size(), 2U);
        EXPECT_EQ(s.stroke, breaks) << "strokes are numbered in order";
        if (s.role == Role::travel) ++breaks;
        if (i > 0) {
            EXPECT_EQ(s.points.front(), r.spans[i - 1].points.back()) << "spans chain";
        }
        for (std::size_t k = 0; k + 1 < s.points.size(); ++k)
            if (s.role != Role::travel) {
                EXPECT_GE(s.points[k + 1].z, s.points[k].z) << "a stroke never goes down";
            }
    }
    std::size_t curves = 0;
    for (const auto& region : regions) {
        std::vector<Curve> printed;
        for (const auto& s : r.spans) {
            if (s.role != Role::bead || s.region != region.region) continue;
            printed.push_back({false, {}, {kWidth}});
            for (const auto& p : s.points) printed.back().points.push_back(p.xy());
        }
        const SegmentIndex index(printed);
        std::size_t missing = 0;
        for (const auto& c : region.curves)
            for (const auto p : c.points) missing += index.nearest(p, 0.3 * kWidth) ? 0 : 1; // beside lanes they move
        EXPECT_LE(missing, region.curves.size()) << "every point is printed, except for one in a gap";
        curves += region.curves.size();
    }
    EXPECT_EQ(spans[Role::bead], curves);
    EXPECT_LE(spans[Role::lift], r.counts.lifts); // a ramp may begin on the spot
    EXPECT_GE(spans[Role::lift], r.counts.lifts - r.counts.ramps);
    EXPECT_EQ(spans[Role::connector], r.counts.connectors);
    EXPECT_EQ(spans[Role::travel], r.counts.breaks);
    if (curves > 0) {
        EXPECT_EQ(r.counts.strokes, r.counts.breaks + 1);
    }
    EXPECT_EQ(r.counts.lifts + r.counts.jogs + r.counts.strands + r.counts.connectors + r.counts.breaks +
                  (curves > 0 ? 1 : 0),
              curves);
    EXPECT_EQ(crossings(r.spans), 0U);
}

} // namespace filum::link3d::test
