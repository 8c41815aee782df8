#include "assemble/assemble.hpp"

#include <algorithm>

namespace filum::assemble {

using geom::Vec3;

void Job::begin() {
    first_ = next_, fresh_ = true;
    ++begun_count_;
}

std::vector<toolpath::Span> Job::add(toolpath::Span span) {
    std::vector<toolpath::Span> out;
    span.stroke += first_;
    next_ = std::max(next_, span.stroke + 1);
    if (!o_.tools.empty())
        span.tool = static_cast<std::uint32_t>(o_.tools[std::min(begun_count_, o_.tools.size()) - 1]);
    if (span.points.empty()) return out;
    const Vec3 up{0, 0, 1};
    const Vec3 axis = span.normals.empty() ? up : span.normals.front();
    if (fresh_ && begun_) {
        toolpath::Span travel{toolpath::Role::travel, span.stroke, span.layer, span.region, {}, {}, {}, {}};
        travel.tool = span.tool;
        const Vec3& to = span.points.front();
        travel.points = {at_, at_ + o_.lift * axis_, to + o_.lift * axis, to};
        if (!(axis_ == up && axis == up)) travel.normals = {axis_, axis_, axis, axis};
        out.push_back(std::move(travel));
    }
    fresh_ = false, begun_ = true;
    at_ = span.points.back();
    axis_ = span.normals.empty() ? up : span.normals.back();
    out.push_back(std::move(span));
    return out;
}

} // namespace filum::assemble
