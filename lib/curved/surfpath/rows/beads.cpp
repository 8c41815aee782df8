#include "surfpath/rows/beads.hpp"

#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace filum::surfpath::rows {

BeadMap::BeadMap(const Surface& s, const std::vector<Line>& lines, const lanes::Lanes& lanes)
    : s_(s), apart_(rules::kFineGrain * lanes.spacing()), cuts_(lines.size()), cell_(lanes.spacing()) {
    std::vector<Vec3> points;
    for (std::uint32_t l = 0; l < lines.size(); ++l) {
        length_.push_back(surface::curve::length(lines[l]));
        closed_.push_back(lines[l].closed ? 1 : 0);
        first_.push_back(static_cast<std::uint32_t>(beads_.size()));
        const auto n = static_cast<std::size_t>(std::ceil(length_[l] / apart_));
        for (std::size_t i = 0; i < n; ++i) {
            const double arc = length_[l] * static_cast<double>(i) / static_cast<double>(n);
            const Place p = lanes.at(l, arc);
            beads_.push_back({l, arc, p.point, surface::normal(s, p.triangle)});
            points.push_back(p.point);
        }
    }
    first_.push_back(static_cast<std::uint32_t>(beads_.size()));
    cut_beads_.assign(beads_.size(), 0);
    grid_ = geom::PointGrid<Vec3>(points, cell_);
}

double BeadMap::off(std::uint32_t line, double a, double b) const {
    return std::abs(closed_[line] != 0 ? std::remainder(a - b, length_[line]) : a - b);
}

bool BeadMap::whole(std::uint32_t line, double at, double half, double margin) const {
    return std::all_of(cuts_[line].begin(), cuts_[line].end(),
                       [&](const CutStretch& c) { return off(line, at, c.at) >= half + c.half + margin; });
}

void BeadMap::cut(std::uint32_t line, double at, double half) {
    cuts_[line].push_back({at, half});
    for (std::uint32_t i = first_[line]; i < first_[line + 1]; ++i)
        if (off(line, beads_[i].arc, at) < half) cut_beads_[i] = 1;
}

void BeadMap::add(const Line& line) {
    AddedLine& more = added_.emplace_back();
    for (const Place& p : surface::curve::resampled(line, apart_).places) {
        more.beads.push_back({surface::kNone, 0, p.point, surface::normal(s_, p.triangle)});
        more.box.add(p.point);
    }
}

Surroundings BeadMap::around(const surface::curve::Chart& chart, double reach) const {
    Surroundings out{chart, {}, {}};
    const auto seen = [&](const BeadPoint& bead) {
        return distance(bead.point, chart.origin) < reach && dot(bead.normal, chart.normal) > 0;
    };
    grid_.near(chart.origin, static_cast<std::int64_t>(std::ceil(reach / cell_)), [&](std::uint32_t i) {
        const BeadPoint& bead = beads_[i];
        if (cut_beads_[i] == 0 && seen(bead)) out.beads.push_back({bead.line, bead.arc, chart.to(bead.point)});
    });
    std::sort(out.beads.begin(), out.beads.end(),
              [](const Surroundings::LinePoint& a, const Surroundings::LinePoint& b) {
                  return a.line != b.line ? a.line < b.line : a.arc < b.arc;
              });
    for (const AddedLine& line : added_) {
        if (geom::distance(line.box, chart.origin) > reach) continue;
        for (const BeadPoint& bead : line.beads)
            if (seen(bead)) out.added.push_back(chart.to(bead.point));
    }
    return out;
}

std::vector<BeadPoint> BeadMap::neighbours(std::uint32_t but, const Vec3& p, const Vec3& normal, double reach) const {
    std::map<std::uint32_t, BeadPoint> nearest;
    grid_.near(p, static_cast<std::int64_t>(std::ceil(reach / cell_)), [&](std::uint32_t i) {
        const BeadPoint& bead = beads_[i];
        if (bead.line == but || distance(bead.point, p) > reach || !(dot(normal, bead.normal) > 0)) return;
        const auto [to, first] = nearest.emplace(bead.line, bead);
        if (!first && distance(bead.point, p) < distance(to->second.point, p)) to->second = bead;
    });
    std::vector<BeadPoint> out;
    out.reserve(nearest.size());
    for (const auto& [line, bead] : nearest) out.push_back(bead);
    return out;
}

} // namespace filum::surfpath::rows
