#include "collision/beads.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace filum::collision {

bool BeadGrowth::add(Move move, double width, double height) {
    const double length = distance(move.from.tip, move.to.tip);
    if (length == 0 && move.from.axis == move.to.axis && move.from.side == move.to.side) return false;
    if (width > 0) fresh_ = width + 2 * heads_.of(move.tool).flat_radius;
    while (!ends_.empty() && ends_.front() <= way_ - fresh_) ends_.pop_front();
    move.before = static_cast<std::uint32_t>(beads.size() - ends_.size());
    moves.push_back(move);
    way_ += length;
    if (width > 0 && length > 0) {
        beads.push_back(bead(move.from, move.to, width, height, static_cast<std::uint32_t>(beads.size())));
        ends_.push_back(way_);
    }
    return true;
}

namespace {

ToolFrame beside(const ToolFrame& s, const Vec3& shift) {
    ToolFrame out = s;
    out.tip = s.tip + shift.x * s.side + shift.y * cross(s.axis, s.side) + shift.z * s.axis;
    return out;
}

} // namespace

void add_idle(const Heads& heads, std::vector<Move>& moves) {
    if (heads.mount.empty()) return;
    std::set<std::uint32_t> used;
    for (const Move& m : moves) used.insert(m.tool);
    const std::size_t own = moves.size();
    for (const std::uint32_t tool : used)
        for (const Heads::Idle& idle : heads.beside(tool)) {
            if (!used.contains(idle.tool)) continue;
            for (std::size_t i = 0; i < own; ++i) {
                Move m = moves[i];
                if (m.tool != tool || m.from.side == Vec3{} || m.to.side == Vec3{}) continue;
                m.from = beside(m.from, idle.shift);
                m.to = beside(m.to, idle.shift);
                m.tool = idle.tool;
                moves.push_back(m);
            }
        }
}

ToolFrame MoveReader::stance(const toolpath::Span& span, std::size_t i) const {
    ToolFrame out{span.points[i], {0, 0, 1}, {1, 0, 0}};
    if (!span.normals.empty()) out.axis = span.normals[i];
    const bool goes_on = !toolpath::extrudes(span.role) && at_.side != Vec3{} && out.axis == Vec3{0, 0, 1};
    if (machine_.rotary || !(span.normals.empty() || goes_on)) out.side = {};
    return out;
}

void MoveReader::go(const ToolFrame& to, const toolpath::Span& span, double width, double height) {
    Move move{at_, to, 0, points_, span.layer, span.stroke, !toolpath::extrudes(span.role), span.tool};
    if (move.from.side == Vec3{} || to.side == Vec3{}) move.from.side = move.to.side = {};
    growth.add(move, width, height);
    at_ = to;
}

void MoveReader::add(const toolpath::Span& span) {
    const bool lays = toolpath::extrudes(span.role);
    if (!started_ && lays) at_ = stance(span, 0);
    started_ = started_ || lays;
    if (!started_) { // there is no place to leave yet
        points_ += static_cast<std::uint32_t>(span.points.size());
        return;
    }
    if (!lays && span.normals.empty()) return travel(span);
    go(stance(span, 0), span, 0, 0);
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        ++points_;
        const bool some = toolpath::volume(span, i) > 0;
        go(stance(span, i + 1), span, some ? (span.width_at(i) + span.width_at(i + 1)) / 2 : 0,
           some ? (span.height_at(i) + span.height_at(i + 1)) / 2 : 0);
        if (some) top_ = std::max({top_, span.points[i].z, span.points[i + 1].z});
    }
    ++points_;
}

void MoveReader::travel(const toolpath::Span& span) {
    double length = 0, clear = top_;
    for (std::size_t i = 0; i < span.points.size(); ++i) {
        clear = std::max(clear, span.points[i].z);
        if (i > 0) length += distance(span.points[i - 1], span.points[i]);
    }
    clear += machine_.lift;
    const bool rises = length >= machine_.min_length;
    go(stance(span, 0), span, 0, 0);
    for (std::size_t i = 0; i < span.points.size(); ++i, ++points_) {
        ToolFrame over = stance(span, i);
        if (rises) over.tip.z = clear;
        go(over, span, 0, 0);
    }
    go(stance(span, span.points.size() - 1), span, 0, 0);
}

} // namespace filum::collision
