#include "metrics/pace.hpp"

#include "machine/feed.hpp"

#include <algorithm>

namespace filum::metrics {

using geom::Vec3;

void Pace::go(Vec3 to, double feed) {
    clock_.move(to - at_, feed, false);
    at_ = to;
}

void Pace::travel(const toolpath::Span& span) {
    double length = 0, top = top_;
    for (std::size_t i = 0; i < span.points.size(); ++i) {
        if (i > 0) length += geom::distance(span.points[i - 1], span.points[i]);
        top = std::max(top, span.points[i].z);
    }
    const auto& t = profile_.travel;
    const bool plain = length < t.min_length && !retracted_;
    if (!plain) {
        if (!retracted_) clock_.pause(t.retract / t.retract_speed);
        retracted_ = true;
        const double clear = std::min(top + t.lift, profile_.bed.z_max);
        if (clear > at_.z) go({at_.x, at_.y, clear}, profile_.feeds.z);
    }
    for (const Vec3& p : span.points) go(plain ? p : Vec3{p.x, p.y, at_.z}, profile_.feeds.travel);
}

void Pace::extrude(const toolpath::Span& span) {
    const Vec3 from = span.points.front();
    if (!begun_) at_ = from, begun_ = true;
    go({from.x, from.y, at_.z}, profile_.feeds.travel);
    go(from, profile_.feeds.z);
    if (retracted_) clock_.pause((profile_.travel.retract + profile_.travel.extra) / profile_.travel.retract_speed);
    retracted_ = false;
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        clock_.move(span.points[i + 1] - span.points[i], machine::bead_feed(profile_, span, i), true);
        top_ = std::max({top_, span.points[i].z, span.points[i + 1].z});
    }
    at_ = span.points.back();
}

void Pace::add(const toolpath::Span& span) {
    if (toolpath::extrudes(span.role))
        extrude(span);
    else if (begun_)
        travel(span);
}

double Pace::seconds() { return clock_.total(); }

} // namespace filum::metrics
