#include "toolpath/assembly.hpp"

#include <algorithm>

namespace filum::toolpath {

using geom::Vec3;

namespace {

const Vec3 kUp{0, 0, 1};

// Spans without axes stay so if the tool stays upright.
void place(Span& span, const geom::Affine& map) {
    geom::Affine turn = map;
    std::fill(std::begin(turn.t), std::end(turn.t), 0);
    if (span.normals.empty() && turn(kUp) != kUp) span.normals.assign(span.points.size(), kUp);
    for (Vec3& p : span.points) p = map(p);
    for (Vec3& n : span.normals) n = turn(n);
}

Vec3 axis(const Span& span, std::size_t i) { return span.normals.empty() ? kUp : span.normals[i]; }

} // namespace

void Assembly::begin() {
    first_ = next_;
    fresh_ = true;
    ++begun_count_;
}

Span Assembly::travel(const Span& to) const {
    Span out{Role::travel, to.stroke, to.layer, to.region, {}, {}, {}, {}, to.tool};
    const Vec3 end = to.points.front(), end_axis = axis(to, 0);
    const Vec3 from = at_ + o_.lift * axis_, into = end + o_.lift * end_axis;
    if (axis_ == kUp && end_axis == kUp) {
        out.points = {at_, from, into, end};
        return out;
    }
    const double clear = std::max({top_ + o_.lift, from.z, into.z});
    out.points = {at_, from, from, {from.x, from.y, clear}, {into.x, into.y, clear}, into, into, end};
    out.normals = {axis_, axis_, kUp, kUp, kUp, kUp, end_axis, end_axis};
    return out;
}

std::vector<Span> Assembly::add(Span span) {
    std::vector<Span> out;
    span.stroke += first_;
    next_ = std::max(next_, span.stroke + 1);
    if (!o_.tools.empty())
        span.tool = static_cast<std::uint32_t>(o_.tools[std::min(begun_count_, o_.tools.size()) - 1]);
    if (span.points.empty()) return out;
    place(span, o_.place);
    if (fresh_ && begun_) out.push_back(travel(span));
    fresh_ = false;
    begun_ = true;
    at_ = span.points.back();
    axis_ = axis(span, span.points.size() - 1);
    for (const Vec3& p : span.points)
        if (extrudes(span.role)) top_ = std::max(top_, p.z);
    out.push_back(std::move(span));
    return out;
}

} // namespace filum::toolpath
