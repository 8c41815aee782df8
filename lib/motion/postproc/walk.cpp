#include "postproc/walk.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/polyline.hpp"
#include "postproc/throughput.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filum::postproc {

namespace {

double highest(const toolpath::Span& span) {
    double z = span.points.front().z;
    for (const auto& p : span.points) z = std::max(z, p.z);
    return z;
}

double length(const toolpath::Span& span) { return geom::length(span.points); }

} // namespace

void Joins::add(const toolpath::Span& span) {
    if (!toolpath::extrudes(span.role) || toolpath::fills(span.role)) return;
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        const geom::Segment s{span.points[i].xy(), span.points[i + 1].xy()};
        if (s.a == s.b) continue;
        const std::uint64_t above = std::uint64_t{span.layer} + 1; // wider, so that the highest number has one above
        for (std::uint64_t layer = std::max(span.layer, 1U) - 1; layer <= above; ++layer)
            of_layer[static_cast<std::uint32_t>(layer)].push_back(s);
    }
}

std::span<const geom::Segment> Joins::near(std::uint32_t layer) const {
    const auto found = of_layer.find(layer);
    return found == of_layer.end() ? std::span<const geom::Segment>{} : found->second;
}

Walk::Walk(const machine::Profile& profile, Steps out, const Joins* joins)
    : profile_(&profile), steps_(std::make_unique<Throughput>(profile, std::move(out))), joins_(joins) {}

Walk::~Walk() = default;

void Walk::put(const Step& step) { steps_->add(step); }

Walker::Laying Walker::laying(const machine::Profile& profile, std::uint32_t tool, const machine::ExtrudingMove& move,
                              bool last) const {
    if (!profile.fibre.lays(tool)) return {machine::bead_feed(machine::of_tool(profile, tool), move), 0, false};
    return {machine::fibre_feed(profile, move, how_.feed), how_.fed * move.length, halt_ && last};
}

toolpath::Tolerance tolerance(const machine::Profile& p, const toolpath::Span& span) {
    toolpath::Tolerance out;
    out.path = span.normals.empty() ? p.merging.planar : p.merging.surface;
    out.grid = std::pow(10.0, -p.format.xyz_decimals);
    out.arcs = p.format.arcs && !p.axes.active();
    if (p.motion.controller == machine::Controller::klipper) out.chord = p.motion.arc_resolution;
    return out;
}

Act Walker::before() const {
    return how_.before == machine::Event::cut       ? Act::cut
           : how_.before == machine::Event::tension ? Act::tension
                                                    : Act::extrude;
}

toolpath::MergeResult merged(const machine::Profile& profile, const toolpath::Span& span, const Joins* joins) {
    const auto others = joins != nullptr ? joins->near(span.layer) : std::span<const geom::Segment>{};
    return toolpath::merge(span, tolerance(profile, span), others);
}

void Walker::add(const toolpath::Span& span, const toolpath::MergeResult* merged) {
    how_ = {};
    halt_ = false;
    merged_ = merged;
    lay(span);
    merged_ = nullptr;
}

void Walker::add_fibre(const toolpath::Span& span, const machine::Stretch& how, bool halt) {
    how_ = how;
    halt_ = halt;
    lay(span);
}

void Walker::lay(const toolpath::Span& span) {
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
    if (open_) put({.act = Act::close, .layer = static_cast<std::uint32_t>(layer_), .to = at_, .tool = tool_});
    if (open_ && own().travel.above > at_.z) { // before the codes of the end move the nozzle
        at_.z = own().travel.above;
        put({.act = Act::climb,
             .role = Role::travel,
             .layer = static_cast<std::uint32_t>(layer_),
             .to = at_,
             .feed = own().feeds.z,
             .tool = tool_});
    }
    open_ = false;
    steps_->end();
    efforts_.slowed = steps_->slowed();
}

// Retracts, rises unless the travel has normals and keeps the tool, and changes the tool.
void Walk::leave(const toolpath::Span& span) {
    const auto mark = [&](Act act) {
        put({.act = act, .role = Role::travel, .layer = span.layer, .to = at_, .tool = tool_});
    };
    if (!profile_->fibre.lays(tool_) && !risen_) {
        mark(Act::retract);
        retracted_.insert(tool_);
    }
    risen_ = true;
    const bool follows = !span.normals.empty() && span.tool == tool_;
    const double over = std::max(std::max(top_, highest(span)) + own().travel.lift, own().travel.above);
    const double clear = follows ? at_.z : std::min(over, profile_->bed.z_max);
    if (clear > at_.z) {
        at_.z = clear;
        put({.act = Act::climb,
             .role = Role::travel,
             .layer = span.layer,
             .to = at_,
             .feed = own().feeds.z,
             .tool = tool_});
    }
    if (span.tool == tool_) return;
    tool_ = span.tool;
    mark(Act::tool);
    purge(span.layer, at_);
}

// Purges the tool in use if the profile asks for it.  The tip comes from the height of `over` and goes back there, and
// the material is taken back.
void Walk::purge(std::uint32_t layer, const Vec3& over) {
    if (own().purge.volume == 0 || profile_->fibre.lays(tool_)) return;
    put({.act = Act::purge,
         .role = Role::travel,
         .layer = layer,
         .to = over,
         .volume = own().purge.volume,
         .tool = tool_,
         .halt = retracted_.contains(tool_)});
    retracted_.insert(tool_);
}

void Walk::travel(const toolpath::Span& span) {
    if (!started()) { // nothing was printed yet; begin_stroke() approaches the first stroke
        if (!span.normals.empty()) lead_in_ = span.points;
        return;
    }
    if (open_) put({.act = Act::close, .layer = span.layer, .to = at_, .tool = tool_});
    open_ = false;
    const bool other = span.tool != tool_, changes = other || profile_->fibre.lays(tool_);
    const bool plain = length(span) < own().travel.min_length && !risen_ && !changes;
    if (!plain) leave(span);
    const bool follows = !span.normals.empty();
    for (std::size_t i = 1; i < span.points.size(); ++i) {
        const Vec3 to = span.points[i];
        // the position of another tool is unknown, so it comes from above
        if (!follows || (other && i == 1)) go(plain ? to : Vec3{to.x, to.y, at_.z}, span);
        if (follows) go(to, span);
    }
}

// Moves straight to a place.  A travel with normals rises and falls no faster than the z axis allows.
void Walk::go(const Vec3& to, const toolpath::Span& travel) {
    const Vec3 way = to - at_;
    const double rise = std::abs(way.z), most = own().feeds.travel, slow = own().feeds.z;
    const bool slows = !travel.normals.empty() && rise * most > slow * norm(way);
    put({.act = slows && way.xy() == geom::Vec2{} ? Act::climb : Act::travel,
         .role = Role::travel,
         .layer = travel.layer,
         .to = to,
         .feed = slows ? slow * norm(way) / rise : most,
         .tool = tool_});
    at_ = to;
}

void Walk::begin_stroke(const toolpath::Span& span) {
    const Vec3 start = span.points.front();
    Vec3 to = layer_ < 0 && !lead_in_.empty() ? lead_in_.front() : start;
    const auto go = [&](Act act, Vec3 where, double feed) {
        put({.act = act, .role = Role::travel, .layer = span.layer, .to = where, .feed = feed, .tool = tool_});
    };
    if (layer_ < 0) { // the first stroke is approached from above
        if (profile_->templates.primed && tool_ == span.tool && !profile_->fibre.lays(tool_)) {
            go(Act::retract, to, 0); // otherwise the nozzle oozes on the way from the purge line
            retracted_.insert(tool_);
        }
        const bool changes = std::exchange(tool_, span.tool) != span.tool;
        if (changes) go(Act::tool, to, 0);
        const double over = std::max(to.z + std::max(own().travel.lift, kApproach), own().travel.above);
        const double clear = std::min(over, profile_->bed.z_max);
        if (changes) purge(span.layer, {to.x, to.y, clear});
        go(Act::climb, {to.x, to.y, clear}, own().feeds.z);
        go(Act::travel, {to.x, to.y, clear}, own().feeds.travel);
        if (to != start) go(Act::climb, to, own().feeds.z);
        for (std::size_t i = 1; i < lead_in_.size(); ++i) go(Act::travel, lead_in_[i], own().feeds.z);
        to = start;
    }
    at_ = to;
    if (profile_->fibre.lays(tool_)) go(Act::push, to, 0); // into the air
    go(Act::climb, to, own().feeds.z);
    if (retracted_.erase(tool_) > 0) go(Act::prime, to, 0);
    put({.act = Act::open, .role = span.role, .layer = span.layer, .to = to, .tool = tool_});
    risen_ = false;
    open_ = true;
    run_ = 0;
}

// Adds the move of a bead from `from`.  While the speed of the stroke rises evenly with time, the move is divided where
// an eighth of that time has passed; each piece has the mean speed of its eighth.
void Walk::put_bead(const Step& step, const Vec3& from) {
    constexpr int kPieces = 8;
    const double whole = step.feed * own().feeds.rise / 2; // mm until the full speed
    if (run_ >= whole || step.sweep != 0 || !(step.length > 0)) {
        run_ += step.length;
        return put(step);
    }
    double done = 0; // mm of this move
    for (int k = 1; k <= kPieces + 1 && done < step.length; ++k) {
        const bool full = k > kPieces;
        const double end = full ? step.length : whole * k * k / (kPieces * kPieces) - run_;
        if (end <= done) continue;
        const double share = std::min(end, step.length) / step.length;
        Step piece = step;
        const double part = share - done / step.length;
        piece.to = share < 1 ? from + share * (step.to - from) : step.to;
        piece.length *= part;
        piece.volume *= part;
        piece.fed *= part;
        piece.halt = step.halt && share >= 1;
        if (!full) piece.feed *= (k - 0.5) / kPieces;
        put(piece);
        done = share * step.length;
    }
    run_ += step.length;
}

// Begins the span's layer and stroke, if they are new, and does what comes before its first bead.
void Walk::begin_span(const toolpath::Span& span) {
    if (static_cast<std::int64_t>(span.layer) != layer_)
        put({.act = Act::layer,
             .role = span.role,
             .layer = span.layer,
             .to = {at_.x, at_.y, highest(span)},
             .height = span.height_at(0),
             .tool = tool_});
    if (!open_) begin_stroke(span);
    if (before() != Act::extrude) put({.act = before(), .layer = span.layer, .to = at_, .tool = tool_});
    layer_ = span.layer;
}

void Walk::extrude(const toolpath::Span& span) {
    begin_span(span);
    toolpath::MergeResult own_moves;
    if (known() == nullptr) own_moves = merged(*profile_, span, joins_);
    const toolpath::MergeResult& moves = known() != nullptr ? *known() : own_moves;
    efforts_.given += span.points.size() - 1;
    efforts_.off = std::max(efforts_.off, moves.off);
    double z = span.points.front().z;
    Vec3 from = span.points.front();
    for (const toolpath::Move& m : moves.moves) {
        if (m.length == 0) continue;
        const bool last = &m == &moves.moves.back();
        const double volume = m.volume * profile_->features[span.feature].flow;
        const machine::ExtrudingMove move{span.role, span.layer,   m.length,     std::abs(m.to.z - z),
                                          volume,    span.feature, span.over_air};
        const Laying how = laying(*profile_, tool_, move, last);
        const Step bead{.act = Act::extrude,
                        .role = span.role,
                        .feature = span.feature,
                        .layer = span.layer,
                        .to = m.to,
                        .feed = how.feed,
                        .volume = volume,
                        .width = m.width,
                        .height = m.height,
                        .over_air = span.over_air,
                        .length = m.length,
                        .tool = tool_,
                        .fed = how.fed,
                        .halt = how.halt,
                        .sweep = m.sweep,
                        .centre = m.centre};
        if (own().feeds.rise > 0)
            put_bead(bead, from);
        else
            put(bead);
        from = m.to;
        z = m.to.z;
        top_ = std::max(top_, z);
    }
    at_ = span.points.back();
    top_ = std::max(top_, span.points.front().z);
}

} // namespace filum::postproc
