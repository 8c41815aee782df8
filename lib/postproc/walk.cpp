#include "postproc/walk.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "machine/feed.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

constexpr std::size_t kBatch = 1024;
constexpr double kApproach = 5; // mm above its place from where the first stroke is sought: clear of clips and fixtures
constexpr double kTouch = 1e-6; // mm; spans that meet are written from the same number

double highest(const toolpath::Span& span) {
    double z = span.points.front().z;
    for (const auto& p : span.points) z = std::max(z, p.z);
    return z;
}

double length(const toolpath::Span& span) {
    double sum = 0;
    for (std::size_t i = 1; i < span.points.size(); ++i) sum += distance(span.points[i - 1], span.points[i]);
    return sum;
}

} // namespace

Walk::Walk(const machine::Profile& profile, Steps out) : profile_(&profile), out_(std::move(out)) {
    buffer_.reserve(kBatch);
}

void Walk::put(const Step& step) {
    buffer_.push_back(step);
    if (buffer_.size() == kBatch) flush();
}

void Walk::flush() {
    if (!buffer_.empty()) out_(buffer_);
    buffer_.clear();
}

void Walker::add(const toolpath::Span& span) {
    const Vec3 from = span.points.front();
    if (started_ && distance(from, path_) > kTouch)
        throw Error(Exit::bad_input, "cannot follow the toolpath: a span of layer " + std::to_string(span.layer) +
                                         " begins at " + fixed_text(from.x, 3) + "," + fixed_text(from.y, 3) + "," +
                                         fixed_text(from.z, 3) + ", " + fixed_text(distance(from, path_), 4) +
                                         " mm from where the one before ended");
    if (toolpath::extrudes(span.role))
        extrude(span);
    else
        travel(span);
    path_ = span.points.back();
    started_ = true;
}

void Walk::end() {
    if (open_) put({.act = Act::close, .layer = static_cast<std::uint32_t>(layer_), .to = at_});
    open_ = false;
    flush();
}

void Walk::travel(const toolpath::Span& span) {
    if (!started()) return; // there is nothing to leave; the first stroke is sought from wherever the nozzle is
    const auto& t = profile_->travel;
    const auto go = [&](Act act, Vec3 to, double feed) {
        put({.act = act, .role = Role::travel, .layer = span.layer, .to = to, .feed = feed});
        at_ = to;
    };
    if (open_) put({.act = Act::close, .layer = span.layer, .to = at_});
    open_ = false;
    if (length(span) < t.min_length && !retracted_) {
        for (std::size_t i = 1; i < span.points.size(); ++i) go(Act::travel, span.points[i], profile_->feeds.travel);
        return;
    }
    if (!retracted_) put({.act = Act::retract, .role = Role::travel, .layer = span.layer, .to = at_});
    retracted_ = true;
    if (!span.normals.empty()) return follow(span);
    const double clear = std::min(std::max(top_, highest(span)) + t.lift, profile_->bed.z_max);
    if (clear > at_.z) go(Act::climb, {at_.x, at_.y, clear}, profile_->feeds.z);
    for (std::size_t i = 1; i < span.points.size(); ++i)
        go(Act::travel, {span.points[i].x, span.points[i].y, at_.z}, profile_->feeds.travel);
}

// Its z is kept, at no more than the z axis can do.
void Walk::follow(const toolpath::Span& span) {
    for (std::size_t i = 1; i < span.points.size(); ++i) {
        const Vec3 to = span.points[i], d = to - at_;
        const bool upright = d.x == 0 && d.y == 0;
        const double rise = std::abs(d.z), most = profile_->feeds.travel;
        const double feed = rise * most > profile_->feeds.z * norm(d) ? profile_->feeds.z * norm(d) / rise : most;
        put({.act = upright ? Act::climb : Act::travel,
             .role = Role::travel,
             .layer = span.layer,
             .to = to,
             .feed = feed});
        at_ = to;
    }
}

void Walk::begin_stroke(const toolpath::Span& span) {
    const Vec3 to = span.points.front();
    const auto go = [&](Act act, Vec3 where, double feed) {
        put({.act = act, .role = Role::travel, .layer = span.layer, .to = where, .feed = feed});
    };
    if (layer_ < 0) { // the first of all: from above, wherever the start template left the nozzle
        const double clear = std::min(to.z + std::max(profile_->travel.lift, kApproach), profile_->bed.z_max);
        go(Act::climb, {to.x, to.y, clear}, profile_->feeds.z);
        go(Act::travel, {to.x, to.y, clear}, profile_->feeds.travel);
    }
    at_ = to;
    go(Act::climb, to, profile_->feeds.z);
    if (retracted_) put({.act = Act::prime, .role = Role::travel, .layer = span.layer, .to = to});
    put({.act = Act::open, .role = span.role, .layer = span.layer, .to = to});
    retracted_ = false;
    open_ = true;
}

void Walk::extrude(const toolpath::Span& span) {
    const bool other_layer = static_cast<std::int64_t>(span.layer) != layer_;
    const double z = other_layer ? highest(span) : 0;
    if (other_layer)
        put({.act = Act::layer,
             .role = span.role,
             .layer = span.layer,
             .to = {at_.x, at_.y, z},
             .height = span.height_at(0)});
    if (!open_) begin_stroke(span);
    layer_ = span.layer;
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        const Vec3 a = span.points[i], b = span.points[i + 1];
        if (distance(a, b) == 0) continue;
        const double volume = toolpath::volume(span, i);
        put({.act = Act::extrude,
             .role = span.role,
             .layer = span.layer,
             .to = b,
             .feed = machine::bead_feed(*profile_, span, i),
             .volume = volume,
             .width = (span.width_at(i) + span.width_at(i + 1)) / 2,
             .height = (span.height_at(i) + span.height_at(i + 1)) / 2});
        top_ = std::max(top_, b.z);
    }
    at_ = span.points.back();
    top_ = std::max(top_, span.points.front().z);
}

} // namespace filum::postproc
