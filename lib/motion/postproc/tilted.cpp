#include "postproc/tilted.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"
#include "machine/feed.hpp"
#include "postproc/approach.hpp"
#include "postproc/poses.hpp"
#include "postproc/throughput.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace filum::postproc {

namespace {

using geom::kDegree;
using kinematics::Joints;
using kinematics::Pose;

constexpr int kSweeps = 30; // most passes over a stroke to slow it down for the rotary axes
// rad: largest change of the tool axis between two poses.  Near upright the limit is the profile's orientation, but at
// least kFineAxisStep.
constexpr double kAxisStep = 5 * kDegree, kFineAxisStep = 0.25 * kDegree;
constexpr double kOpposite = 179 * kDegree; // above it the axes are opposite, and no shortest way is defined

std::string text(const Vec3& p) {
    return "x " + fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) + ", z " + fixed_text(p.z, 3);
}

Pose pose(const toolpath::Span& span, std::size_t i, const Vec3& shift) {
    return {span.points[i] + shift, span.normals.empty() ? Vec3{0, 0, 1} : span.normals[i]};
}

// The direction at share `f` of the way from `a` to `b`, along the great circle.
Vec3 slerp(const Vec3& a, const Vec3& b, double f) {
    const double whole = geom::angle(a, b), s = std::sin(whole);
    return s > 1e-12 ? std::sin((1 - f) * whole) / s * a + std::sin(f * whole) / s * b : b;
}

} // namespace

TiltedWalk::TiltedWalk(const machine::Profile& profile, Vec2 shift, Steps out)
    : profile_(&profile), tip_(profile), shift_{shift.x, shift.y, 0}, out_(std::move(out)), carrier_(profile) {
    tip_.motion.max_speed_z = kInfinity;
}

void TiltedWalk::put(const Step& step) {
    buffer_.push_back(step);
    if (buffer_.size() < 1024) return;
    out_(buffer_);
    buffer_.clear();
}

void TiltedWalk::end() {
    if (!stroke_.poses.empty()) retreat();
    finish_stroke();
    if (!buffer_.empty()) out_(buffer_);
    buffer_.clear();
}

void TiltedWalk::go(const Pose& pose, const Leg& leg) {
    const auto add = [this](const Pose& p, const Leg& l) {
        stroke_.poses.push_back(p);
        stroke_.legs.push_back(l);
    };
    Leg rest = leg;
    double done = 0;
    for (const double f : cuts(pose)) {
        const Pose from = stroke_.poses.back();
        const double g = done < 1 ? (f - done) / (1 - done) : 0; // share of the rest of the way
        Leg part = rest;
        part.volume = (f - done) * leg.volume;
        part.fed = (f - done) * leg.fed;
        part.halt = false;
        add({from.tip + g * (pose.tip - from.tip), slerp(from.axis, pose.axis, g)}, part);
        done = f;
        rest.before = Act::extrude;
    }
    if (done > 0) {
        rest.volume = (1 - done) * leg.volume;
        rest.fed = (1 - done) * leg.fed;
    }
    add(pose, rest);
}

// The shares of the way to `pose`, ascending, where more poses are needed.  Between poses the axes move straight, so
// the tool leans where its axis changes much, most of all near upright.  Where the tip crosses the axis of a polar
// machine, the share is there twice: the machine turns on the spot.
std::vector<double> TiltedWalk::cuts(const Pose& pose) const {
    std::vector<double> out;
    const auto& a = profile_->axes;
    if (stroke_.poses.empty() || a.chain.carrier == kinematics::Carrier::frame) return out;
    const Vec3 &from = stroke_.poses.back().axis, &to = pose.axis;
    const double change = geom::angle(from, to);
    if (change > kFineAxisStep && change < kOpposite) {
        const double upright = std::acos(std::clamp(std::max(from.z, to.z), -1.0, 1.0));
        const double fine = std::max(a.orientation, kFineAxisStep);
        const int n =
            static_cast<int>(std::ceil(change / (upright < 10 * fine ? std::min(fine, kAxisStep) : kAxisStep) - 1e-9));
        for (int k = 1; k < n; ++k) out.push_back(k / static_cast<double>(n));
    }
    if (const double f = over_axis(pose); f > 0) {
        out.insert(std::upper_bound(out.begin(), out.end(), f), 2, f);
    }
    return out;
}

// The share of the way to `pose` where the tip crosses the axis of a polar machine; 0 if it does not.
double TiltedWalk::over_axis(const Pose& pose) const {
    const auto& chain = profile_->axes.chain;
    if (chain.carrier != kinematics::Carrier::polar || stroke_.poses.empty()) return 0;
    const Vec2 a = stroke_.poses.back().tip.xy() - chain.turn_point.xy(),
               d = pose.tip.xy() - stroke_.poses.back().tip.xy();
    const double f = dot(d, d) > 0 ? -dot(a, d) / dot(d, d) : 0;
    return f > 0 && f < 1 && norm(a + f * d) < kinematics::kOnAxis ? f : 0;
}

// Approaches the first stroke along the tool axis.
void TiltedWalk::approach(const toolpath::Span& first) {
    const Pose p = pose(first, 0, shift_);
    const Leg leg{Act::travel, Role::travel, first.layer, own().feeds.travel, 0, 0, 0, first.tool};
    go({p.tip + std::max(own().travel.lift, kApproach) * p.axis, p.axis}, leg);
    go(p, leg);
}

// Leaves the last stroke along the tool axis before the end template moves the tool.  A straight move from there could
// scrape along the part.
void TiltedWalk::retreat() {
    const Pose last = stroke_.poses.back();
    const Leg& laid = stroke_.legs.back();
    const Leg leg{Act::travel, Role::travel, laid.layer, own().feeds.travel, 0, 0, 0, laid.tool};
    finish_stroke();
    ended_ = true;
    go(last, leg);
    go({last.tip + std::max(own().travel.lift, kApproach) * last.axis, last.axis}, leg);
}

void TiltedWalk::travel(const toolpath::Span& span) {
    if (!started()) return; // no stroke was printed yet
    finish_stroke();
    const Leg leg{Act::travel, Role::travel, span.layer, own().feeds.travel, 0, 0, 0, span.tool};
    if (!span.normals.empty()) {
        for (std::size_t i = 0; i < span.points.size(); ++i) go(pose(span, i, shift_), leg);
        return;
    }
    double clear = top_;
    for (const Vec3& p : span.points) clear = std::max(clear, p.z + shift_.z);
    clear += own().travel.lift;
    const Vec3 up{0, 0, 1};
    go(pose(span, 0, shift_), leg);
    for (const Vec3& p : span.points) go({{p.x + shift_.x, p.y + shift_.y, clear}, up}, leg);
    go(pose(span, span.points.size() - 1, shift_), leg);
}

void TiltedWalk::extrude(const toolpath::Span& span) {
    if (stroke_.poses.empty()) approach(span);
    if (!laid_) landing_ = stroke_.poses.size() - 1;
    const auto from = pose(span, 0, shift_);
    if (geom::angle(stroke_.poses.back().axis, from.axis) > kTouch) // the tool turns on the spot
        go(from, {laid_ ? Act::extrude : Act::travel, span.role, span.layer, own().feeds.travel, 0, 0, 0, span.tool, 0,
                  false, Act::extrude, true, !span.normals.empty(), span.feature});
    Act first = before();
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        if (distance(span.points[i], span.points[i + 1]) == 0) continue;
        machine::ExtrudingMove bead = machine::extruding_move(span, i);
        bead.volume *= profile_->features[span.feature].flow;
        const Laying how = laying(tip_, span.tool, bead, i + 2 == span.points.size());
        go(pose(span, i + 1, shift_),
           {Act::extrude, span.role, span.layer, how.feed, bead.volume, (span.width_at(i) + span.width_at(i + 1)) / 2,
            (span.height_at(i) + span.height_at(i + 1)) / 2, span.tool, how.fed, how.halt,
            std::exchange(first, Act::extrude), true, !span.normals.empty(), span.feature});
        top_ = std::max(top_, stroke_.poses.back().tip.z);
    }
    laid_ = true;
}

void TiltedWalk::check(const kinematics::Track& track) const {
    const auto& a = profile_->axes;
    if (track.stuck < stroke_.poses.size())
        throw Error(Exit::failure, "cannot reach " + text(stroke_.poses[track.stuck].tip) + " on '" + profile_->name +
                                       "': " + track.why + "; turn the part, or break the stroke there");
    if (a.chain.carrier != kinematics::Carrier::frame && track.off > a.orientation * (1 + 1e-6) + 1e-6)
        throw Error(Exit::failure, "cannot keep the tool's axis at " + text(stroke_.poses[track.off_at].tip) +
                                       ": it leans by " + fixed_text(track.off / kDegree, 2) +
                                       " degrees; raise kinematics.orientation_deg");
}

void TiltedWalk::note(const kinematics::Track& track, std::span<const kinematics::Lifting> places) {
    const auto& poses = stroke_.poses;
    for (std::size_t k = 1; k < track.pieces.size(); ++k) {
        const std::size_t at = track.pieces[k].first;
        const bool flying = places[at] == kinematics::Lifting::air;
        if (at < landing_) landing_ += flying ? Lifts::kFromAir : Lifts::kFromPart;
        if (flying) continue;
        if (profile_->fibre.lays(stroke_.legs[at].tool))
            throw Error(Exit::failure, "cannot go on at " + text(poses[at].tip) + " on '" + profile_->name +
                                           "': the axes must unwind, and a stroke of fibre cannot be lifted; break the "
                                           "stroke there");
        if (efforts_.unwinds++ == 0) {
            efforts_.unwind = poses[at].tip;
            efforts_.unwind_layer = stroke_.legs[at].layer;
        }
        efforts_.unwinds_in_turns += places[at] == kinematics::Lifting::turn ? 1 : 0;
    }
    if (track.off > efforts_.lean) {
        efforts_.lean = track.off;
        efforts_.lean_at = poses[track.off_at].tip;
    }
    if (track.clipped > efforts_.clipped) {
        efforts_.clipped = track.clipped;
        efforts_.clipped_at = poses[track.clipped_at].tip;
    }
}

void TiltedWalk::finish_stroke() {
    if (stroke_.poses.empty()) return;
    const machine::Profile& next = machine::of_tool(*profile_, stroke_.legs.back().tool); // for the tool that prints
    const auto& a = next.axes;
    const auto places = liftings(stroke_.legs, layer_ < 0);
    const auto track = kinematics::track(a.chain, stroke_.poses, at_, a.orientation, a.limits, places);
    check(track);
    if (a.chain.carrier != kinematics::Carrier::frame) note(track, places);
    const double lift = own().travel.lift;
    stroke_ = lifted(next, std::move(stroke_), track, places, std::max(lift, kApproach), top_ + lift);
    // Legs before the change belong to the last tool, whose tip is at another place.
    const std::size_t change = exchange(), stay = change < stroke_.poses.size() ? change : 0;
    for (std::size_t i = 0; i < stay; ++i)
        stroke_.joints[i] =
            kinematics::place(own().axes.chain, stroke_.poses[i].tip, stroke_.joints[i].tilt, stroke_.joints[i].turn);
    for (const Leg& leg : stroke_.legs) efforts_.given += leg.act == Act::extrude ? 1 : 0;
    stroke_ = fewer(next, refined(next, std::move(stroke_), stay, landing_), stay, landing_, efforts_.off);
    if (layer_ < 0) {
        std::size_t added = 0;
        stroke_ = approached(next, std::move(stroke_), added);
        landing_ += added;
    }
    auto seconds = durations();
    if (a.chain.carrier == kinematics::Carrier::frame) {
        headings_ = carrier_.headings(stroke_);
        carrier_.carry(stroke_, exchange(), seconds, headings_);
        efforts_.arm = carrier_.efforts();
    } else {
        headings_.assign(stroke_.poses.size(), {1, 0, 0});
    }
    if (const auto i = exchange(); i < seconds.size()) seconds[i] = 0; // the tool's start position is unknown
    emit(seconds);
    at_ = stroke_.joints.back();
    stroke_ = {};
    laid_ = false;
}

// The duration of each leg, s; 0 for the very first, as its start position is unknown.
std::vector<double> TiltedWalk::durations() {
    const auto& j = stroke_.joints;
    const auto& a = profile_->axes;
    const bool robot = a.chain.carrier == kinematics::Carrier::frame;
    std::vector<double> out(j.size(), 0);
    if (layer_ >= 0) // the axes are where the last stroke ended
        out[0] =
            std::max({distance(at_.xyz, j[0].xyz) / own().feeds.travel, std::abs(j[0].tilt - at_.tilt) / a.tilt_speed,
                      std::abs(j[0].turn - at_.turn) / a.turn_speed});
    for (std::size_t i = 1; i < j.size(); ++i)
        out[i] = std::max({distance(stroke_.poses[i - 1].tip, stroke_.poses[i].tip) / stroke_.legs[i].feed,
                           distance(j[i - 1].xyz, j[i].xyz) / profile_->motion.max_speed,
                           robot ? 0 : std::abs(j[i].xyz.z - j[i - 1].xyz.z) / profile_->motion.max_speed_z,
                           std::abs(j[i].tilt - j[i - 1].tilt) / a.tilt_speed,
                           std::abs(j[i].turn - j[i - 1].turn) / a.turn_speed, swing(i), kLeastSeconds});
    // If a rotary axis changes its speed too fast, the faster of the two moves becomes slower.
    bool eased = true;
    const auto ease = [&](std::size_t i, double before, double after, double acceleration) {
        const double change = std::abs(after / out[i + 1] - before / out[i]);
        const double can = acceleration * (out[i] + out[i + 1]) / 2;
        if (change <= can) return;
        eased = true;
        double& slow = std::abs(after) / out[i + 1] > std::abs(before) / out[i] ? out[i + 1] : out[i];
        slow *= std::min(change / can, 1.3);
    };
    for (int sweep = 0; sweep < kSweeps && std::exchange(eased, false); ++sweep)
        for (std::size_t i = 1; i + 1 < j.size(); ++i) {
            if (!(out[i] > 0) || !(out[i + 1] > 0)) continue;
            ease(i, j[i].tilt - j[i - 1].tilt, j[i + 1].tilt - j[i].tilt, a.tilt_acceleration);
            ease(i, j[i].turn - j[i - 1].turn, j[i + 1].turn - j[i].turn, a.turn_acceleration);
        }
    efforts_.slowed += slow_down(out, pace(*profile_));
    return out;
}

// The time that a robot needs to turn the tool on the way to pose i, s.
double TiltedWalk::swing(std::size_t i) const {
    if (profile_->axes.chain.carrier != kinematics::Carrier::frame) return 0;
    return geom::angle(stroke_.poses[i - 1].axis, stroke_.poses[i].axis) / profile_->axes.tilt_speed;
}

// The leg of this stroke before which the tool is changed: after the legs that lead away from the part.  No change:
// stroke_.poses.size().
std::size_t TiltedWalk::exchange() const {
    if (stroke_.legs.back().tool == tool_) return stroke_.poses.size();
    return layer_ < 0 ? 0 : std::min<std::size_t>(2, landing_);
}

void TiltedWalk::emit(const std::vector<double>& seconds) {
    const auto& joints = stroke_.joints;
    bool open = false;
    const auto mark = [&](Act act, std::size_t i, std::size_t at) {
        const bool tip = profile_->axes.numbers == machine::Numbers::tip;
        put({.act = act,
             .role = stroke_.legs[i].role,
             .layer = stroke_.legs[i].layer,
             .to = tip ? stroke_.poses[at].tip : joints[at].xyz,
             .height = stroke_.legs[i].height,
             .axes = joints[at].xyz,
             .tool = tool_});
    };
    const std::size_t change = exchange();
    if (layer_ >= 0 && !ended_ && !profile_->fibre.lays(tool_)) {
        mark(Act::retract, 0, 0);
        retracted_.insert(tool_);
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Leg& leg = stroke_.legs[i];
        const std::size_t last = i > 0 ? i - 1 : 0;
        if (i == change) {
            tool_ = leg.tool;
            mark(Act::tool, i, last);
        }
        if (laid_ && i == landing_ && profile_->fibre.lays(tool_)) mark(Act::push, i, last);
        if (leg.act == Act::extrude) {
            if (static_cast<std::int64_t>(leg.layer) != layer_) mark(Act::layer, i, i);
            if (!open && retracted_.erase(tool_) > 0) mark(Act::prime, i, last);
            if (!open) mark(Act::open, i, last);
            open = true;
            layer_ = leg.layer;
        } else if (open) { // the stroke breaks to unwind the axes
            mark(Act::close, i - 1, i - 1);
            mark(Act::retract, i, i - 1);
            retracted_.insert(tool_);
            open = false;
        }
        if (leg.before != Act::extrude) mark(leg.before, i, last);
        move(i, seconds[i]);
    }
    if (open) mark(Act::close, joints.size() - 1, joints.size() - 1);
}

void TiltedWalk::move(std::size_t i, double seconds) {
    const auto& a = own().axes;
    const Leg& leg = stroke_.legs[i];
    const Joints& to = stroke_.joints[i];
    const Vec3 &tip = stroke_.poses[i].tip, &begin = i > 0 ? stroke_.poses[i - 1].tip : tip;
    const Vec3 off = own().offset; // the positions of the axes are those of tool 0's tip
    const bool jointly = a.chain.carrier == kinematics::Carrier::frame && carrier_.jointly(i);
    put({.act = jointly ? Act::stand : leg.act,
         .role = leg.role,
         .feature = leg.feature,
         .layer = leg.layer,
         .to = a.numbers == machine::Numbers::tip ? tip : to.xyz - off,
         .feed = leg.feed,
         .volume = leg.volume,
         .width = leg.width,
         .height = leg.height,
         .tilt = to.tilt,
         .turn = to.turn,
         .length = distance(begin, tip),
         .seconds = seconds,
         .axes = to.xyz - off,
         .axis = stroke_.poses[i].axis,
         .heading = headings_[i],
         .tool = tool_,
         .fed = leg.fed,
         .halt = leg.halt,
         .posture = jointly ? carrier_.posture(i) : nullptr});
}

} // namespace filum::postproc
