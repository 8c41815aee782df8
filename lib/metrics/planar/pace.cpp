#include "metrics/planar/pace.hpp"

#include "geom/polyline.hpp"
#include "machine/feed.hpp"

#include <algorithm>
#include <utility>

namespace filum::metrics::planar {

using geom::Vec3;
using toolpath::Span;

// The time since the last charge goes to the tool in use: for printing within a stroke, else for travel.
void Pace::charge() {
    const double now = clock_.total(), time = now - std::exchange(charged_, now);
    if (!(time > 0)) return;
    ToolShare& tool = tools_[tool_];
    (open_ ? tool.print_seconds : tool.travel_seconds) += time;
}

void Pace::go(Vec3 to, double feed) {
    clock_.move(to - at_, feed, false);
    at_ = to;
}

void Pace::travel(const Span& span) {
    double top = top_;
    for (const Vec3& p : span.points) top = std::max(top, p.z);
    if (open_) charge();
    open_ = false;
    const auto& t = profile_.travel;
    const bool plain = geom::length(span.points) < t.min_length && !risen_ && !lays_fibre() && span.tool == tool_;
    if (!plain) {
        if (!risen_ && !lays_fibre()) {
            clock_.pause(t.retract / t.retract_speed);
            retracted_.insert(tool_);
        }
        risen_ = true;
        const double clear = std::min(top + t.lift, profile_.bed.z_max);
        if (clear > at_.z) go({at_.x, at_.y, clear}, profile_.feeds.z);
    }
    for (const Vec3& p : span.points) go(plain ? p : Vec3{p.x, p.y, at_.z}, profile_.feeds.travel);
    tools_[span.tool].travel += geom::length(span.points);
}

// Comes to the start of a span; of a stroke, if none is open.
void Pace::begin(const Span& span) {
    const Vec3 from = span.points.front();
    if (!begun_) at_ = from, begun_ = true;
    tool_ = span.tool;
    go({from.x, from.y, at_.z}, profile_.feeds.travel);
    if (!open_ && lays_fibre()) clock_.pause(profile_.fibre.prime / profile_.fibre.prime_speed);
    go(from, profile_.feeds.z);
    if (open_) return;
    const auto& t = profile_.travel;
    if (retracted_.erase(tool_) > 0) clock_.pause((t.retract + t.extra) / t.retract_speed);
    charge();
    open_ = true, risen_ = false;
    ++tools_[tool_].strokes;
}

void Pace::extrude(const Span& span) {
    begin(span);
    ToolShare& tool = tools_[tool_];
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        clock_.move(span.points[i + 1] - span.points[i], machine::bead_feed(profile_, span, i), true);
        top_ = std::max({top_, span.points[i].z, span.points[i + 1].z});
        tool.laid += distance(span.points[i], span.points[i + 1]);
        tool.volume += toolpath::volume(span, i);
    }
    at_ = span.points.back();
}

// The whole stroke, now that its length is known.
void Pace::lay_fibre() {
    if (fibre_.empty()) return;
    const auto& f = profile_.fibre;
    double whole = 0;
    for (const Span& span : fibre_) whole += geom::length(span.points);
    const bool laid = whole >= f.cut_to_nozzle && whole <= f.most_path;
    const auto all =
        laid ? machine::stretches(f, whole) : std::vector<machine::Stretch>{{0, whole, f.feed, 0, machine::Event::cut}};
    std::size_t k = 0;
    double s = 0; // arc length so far
    const auto pause = [&] {
        const auto event = all[k].before;
        if (event != machine::Event::none) clock_.pause(event == machine::Event::cut ? f.cut_dwell : f.tension_dwell);
    };
    for (const Span& span : fibre_) {
        begin(span);
        if (&span == &fibre_.front()) pause();
        ToolShare& tool = tools_[tool_];
        for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
            const Vec3 way = span.points[i + 1] - span.points[i];
            const double l = norm(way), begun = s;
            const auto move = [&](double to) {
                if (l > 0) clock_.move((to - s) / l * way, machine::fibre_feed(profile_, span, i, all[k].feed), true);
                s = to;
            };
            while (k + 1 < all.size() && all[k].to < begun + l) {
                move(std::max(s, all[k].to));
                ++k;
                pause();
            }
            move(begun + l);
            top_ = std::max({top_, span.points[i].z, span.points[i + 1].z});
            tool.laid += l;
            tool.volume += toolpath::volume(span, i);
        }
        at_ = span.points.back();
    }
    ToolShare& tool = tools_[tool_];
    tool.fibre = true;
    ++tool.cuts;
    tool.too_short += whole < f.least_path - 1e-3 ? 1 : 0;
    fibre_.clear();
    charge();
    open_ = false;
}

void Pace::add(const Span& span) {
    const bool extrudes = toolpath::extrudes(span.role), fibre = extrudes && profile_.fibre.lays(span.tool);
    if (!fibre) lay_fibre();
    if (extrudes && begun_ && fibre_.empty() && !risen_ &&
        span.tool != tool_) { // changed without a travel: on the spot
        Span still{toolpath::Role::travel, 0, 0, 0, {at_, at_}, {}, {}, {}};
        still.tool = span.tool;
        travel(still);
    }
    if (fibre) {
        fibre_.push_back(span);
    } else if (extrudes) {
        extrude(span);
    } else if (begun_) {
        travel(span);
    }
}

double Pace::seconds() {
    lay_fibre();
    charge();
    return clock_.total();
}

} // namespace filum::metrics::planar
