#include "postproc/tilted.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "machine/feed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace filum::postproc {

namespace {

using kinematics::Joints;
using kinematics::Pose;

constexpr double kTouch = 1e-6;        // mm; spans that meet are written from the same number
constexpr double kApproach = 5;        // mm above its place from where the first stroke is sought
constexpr int kSweeps = 30;            // over a stroke, until rotary axes can follow
constexpr std::uint32_t kParts = 4096; // of a move, at most
constexpr double kDegree = std::numbers::pi / 180;

std::string text(const Vec3& p) {
    return "x " + fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) + ", z " + fixed_text(p.z, 3);
}

Pose pose(const toolpath::Span& span, std::size_t i, const Vec3& shift) {
    return {span.points[i] + shift, span.normals.empty() ? Vec3{0, 0, 1} : span.normals[i]};
}

} // namespace

TiltedWalk::TiltedWalk(const machine::Profile& profile, Vec2 shift, Steps out)
    : profile_(&profile), tip_(profile), shift_{shift.x, shift.y, 0}, out_(std::move(out)) {
    tip_.motion.max_speed_z = std::numeric_limits<double>::infinity();
}

void TiltedWalk::put(const Step& step) {
    buffer_.push_back(step);
    if (buffer_.size() < 1024) return;
    out_(buffer_);
    buffer_.clear();
}

void TiltedWalk::end() {
    finish_stroke();
    if (!buffer_.empty()) out_(buffer_);
    buffer_.clear();
}

void TiltedWalk::go(const Pose& pose, const Leg& leg) {
    poses_.push_back(pose);
    legs_.push_back(leg);
}

// The first stroke is sought along the tool axis, from wherever the start template left the tool.
void TiltedWalk::approach(const toolpath::Span& first) {
    const Pose p = pose(first, 0, shift_);
    const Leg leg{Act::travel, Role::travel, first.layer, profile_->feeds.travel, 0, 0, 0, first.tool};
    go({p.tip + std::max(profile_->travel.lift, kApproach) * p.axis, p.axis}, leg);
    go(p, leg);
}

void TiltedWalk::travel(const toolpath::Span& span) {
    if (!started()) return; // there is nothing to leave
    finish_stroke();
    const Leg leg{Act::travel, Role::travel, span.layer, profile_->feeds.travel, 0, 0, 0, span.tool};
    if (!span.normals.empty()) {
        for (std::size_t i = 0; i < span.points.size(); ++i) go(pose(span, i, shift_), leg);
        return;
    }
    double clear = top_;
    for (const Vec3& p : span.points) clear = std::max(clear, p.z + shift_.z);
    clear += profile_->travel.lift;
    const Vec3 up{0, 0, 1};
    go(pose(span, 0, shift_), leg);
    for (const Vec3& p : span.points) go({{p.x + shift_.x, p.y + shift_.y, clear}, up}, leg);
    go(pose(span, span.points.size() - 1, shift_), leg);
}

void TiltedWalk::extrude(const toolpath::Span& span) {
    if (poses_.empty()) approach(span);
    if (!laid_) landing_ = poses_.size() - 1;
    const auto from = pose(span, 0, shift_);
    if (kinematics::angle(poses_.back().axis, from.axis) > kTouch) // the tool turns where it stands
        go(from,
           {laid_ ? Act::extrude : Act::travel, span.role, span.layer, profile_->feeds.travel, 0, 0, 0, span.tool});
    Act first = before();
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        if (distance(span.points[i], span.points[i + 1]) == 0) continue;
        const Laying how = laying(tip_, span, i);
        go(pose(span, i + 1, shift_),
           {Act::extrude, span.role, span.layer, how.feed, toolpath::volume(span, i),
            (span.width_at(i) + span.width_at(i + 1)) / 2, (span.height_at(i) + span.height_at(i + 1)) / 2, span.tool,
            how.fed, how.halt, std::exchange(first, Act::extrude)});
        top_ = std::max(top_, poses_.back().tip.z);
    }
    laid_ = true;
}

void TiltedWalk::check(const kinematics::Track& track) const {
    const auto& a = profile_->axes;
    if (track.stuck < poses_.size())
        throw Error(Exit::failure, "cannot reach " + text(poses_[track.stuck].tip) + " on '" + profile_->name +
                                       "': " + track.why + "; turn the part, or break the stroke there");
    if (a.chain.carrier != kinematics::Carrier::frame && track.off > a.orientation * (1 + 1e-6) + 1e-6)
        throw Error(Exit::failure, "cannot keep the tool's axis at " + text(poses_[track.off_at].tip) +
                                       ": it leans by " + fixed_text(track.off / kDegree, 2) +
                                       " degrees; raise kinematics.orientation_deg");
}

void TiltedWalk::finish_stroke() {
    if (poses_.empty()) return;
    const auto& a = profile_->axes;
    const auto track = kinematics::track(a.chain, poses_, at_, a.orientation, a.limits);
    check(track);
    head();
    auto seconds = durations(track.joints);
    if (const auto i = exchange(); i < seconds.size()) seconds[i] = 0; // nobody knows whence the tool comes
    emit(track.joints, seconds);
    at_ = track.joints.back();
    poses_.clear(), legs_.clear();
    laid_ = false;
}

// Where a robot's tool points its x axis: along x of the part, or along the path, each as far as it lies across the
// tool axis; where it hardly does, as before.
void TiltedWalk::head() {
    headings_.assign(poses_.size(), heading_);
    if (profile_->axes.chain.carrier != kinematics::Carrier::frame) return;
    constexpr double least = 0.05; // of a unit vector's part across
    for (std::size_t i = 0; i < poses_.size(); ++i) {
        const std::size_t a = i > 0 ? i - 1 : 0, b = i + 1 < poses_.size() ? i + 1 : i;
        const Vec3 way = poses_[b].tip - poses_[a].tip;
        const bool follow = profile_->axes.spin == machine::Spin::follow && norm(way) > 0;
        Vec3 to = follow ? 1 / norm(way) * way : profile_->axes.spin == machine::Spin::fixed ? Vec3{1, 0, 0} : heading_;
        const Vec3& axis = poses_[i].axis;
        Vec3 across = to - dot(to, axis) * axis;
        if (norm(across) < least) across = heading_ - dot(heading_, axis) * axis;
        if (norm(across) < least)
            across = std::abs(axis.x) < 0.9 ? Vec3{1, 0, 0} - axis.x * axis : Vec3{0, 1, 0} - axis.y * axis;
        headings_[i] = heading_ = 1 / norm(across) * across;
    }
}

// Per leg; the very first takes none: nobody knows whence it comes.
std::vector<double> TiltedWalk::durations(const std::vector<Joints>& j) const {
    const auto& a = profile_->axes;
    const bool robot = a.chain.carrier == kinematics::Carrier::frame;
    std::vector<double> out(j.size(), 0);
    if (layer_ >= 0) // the axes stand where the last stroke left them
        out[0] =
            std::max({distance(at_.xyz, j[0].xyz) / profile_->feeds.travel,
                      std::abs(j[0].tilt - at_.tilt) / a.tilt_speed, std::abs(j[0].turn - at_.turn) / a.turn_speed});
    for (std::size_t i = 1; i < j.size(); ++i)
        out[i] = std::max({distance(poses_[i - 1].tip, poses_[i].tip) / legs_[i].feed,
                           distance(j[i - 1].xyz, j[i].xyz) / profile_->motion.max_speed,
                           robot ? 0 : std::abs(j[i].xyz.z - j[i - 1].xyz.z) / profile_->motion.max_speed_z,
                           std::abs(j[i].tilt - j[i - 1].tilt) / a.tilt_speed,
                           std::abs(j[i].turn - j[i - 1].turn) / a.turn_speed, swing(i)});
    // Where a rotary axis changes its speed too fast, the faster of both moves takes longer.
    const auto ease = [&](std::size_t i, double before, double after, double acceleration) {
        const double change = std::abs(after / out[i + 1] - before / out[i]);
        const double can = acceleration * (out[i] + out[i + 1]) / 2;
        if (change <= can) return;
        double& slow = std::abs(after) / out[i + 1] > std::abs(before) / out[i] ? out[i + 1] : out[i];
        slow *= std::min(change / can, 1.3);
    };
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (std::size_t i = 1; i + 1 < j.size(); ++i) {
            if (!(out[i] > 0) || !(out[i + 1] > 0)) continue;
            ease(i, j[i].tilt - j[i - 1].tilt, j[i + 1].tilt - j[i].tilt, a.tilt_acceleration);
            ease(i, j[i].turn - j[i - 1].turn, j[i + 1].turn - j[i].turn, a.turn_acceleration);
        }
    return out;
}

// How long a robot needs to turn the tool on the way to pose i.
double TiltedWalk::swing(std::size_t i) const {
    if (profile_->axes.chain.carrier != kinematics::Carrier::frame) return 0;
    return kinematics::angle(poses_[i - 1].axis, poses_[i].axis) / profile_->axes.tilt_speed;
}

// The leg of this stroke before which the tool is changed: behind the first one of a travel, which leads away from the
// part.  None: poses_.size().
std::size_t TiltedWalk::exchange() const {
    if (legs_.back().tool == tool_) return poses_.size();
    return layer_ < 0 ? 0 : std::min<std::size_t>(2, landing_);
}

void TiltedWalk::emit(const std::vector<Joints>& joints, const std::vector<double>& seconds) {
    bool open = false;
    const auto mark = [&](Act act, std::size_t i, std::size_t at) {
        const bool tip = profile_->axes.numbers == machine::Numbers::tip;
        put({.act = act,
             .role = legs_[i].role,
             .layer = legs_[i].layer,
             .to = tip ? poses_[at].tip : joints[at].xyz,
             .height = legs_[i].height,
             .axes = joints[at].xyz,
             .tool = tool_});
    };
    const std::size_t change = exchange();
    if (layer_ >= 0 && !profile_->fibre.lays(tool_)) {
        mark(Act::retract, 0, 0);
        retracted_.insert(tool_);
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Leg& leg = legs_[i];
        const std::size_t last = i > 0 ? i - 1 : 0;
        if (i == change) tool_ = leg.tool, mark(Act::tool, i, last);
        if (laid_ && i == landing_ && profile_->fibre.lays(tool_)) mark(Act::push, i, last);
        if (leg.act == Act::extrude) {
            if (static_cast<std::int64_t>(leg.layer) != layer_) mark(Act::layer, i, i);
            if (!open && retracted_.erase(tool_) > 0) mark(Act::prime, i, last);
            if (!open) mark(Act::open, i, last);
            open = true, layer_ = leg.layer;
        }
        if (leg.before != Act::extrude) mark(leg.before, i, last);
        move(leg, i, joints, seconds[i]);
    }
    if (open) mark(Act::close, joints.size() - 1, joints.size() - 1);
}

void TiltedWalk::move(const Leg& leg, std::size_t i, const std::vector<Joints>& joints, double seconds) {
    const auto& a = profile_->axes;
    const Joints &to = joints[i], &from = i > 0 ? joints[i - 1] : to;
    const Vec3 &tip = poses_[i].tip, &begin = i > 0 ? poses_[i - 1].tip : tip;
    const auto between = [&](double f) {
        return kinematics::place(a.chain, begin + f * (tip - begin), from.tilt + f * (to.tilt - from.tilt),
                                 from.turn + f * (to.turn - from.turn));
    };
    std::uint32_t parts = 1;
    // The tip strays most in the middle of a part; by a quarter when parts are halved.
    for (; a.numbers == machine::Numbers::joints && i > 0 && seconds > 0 && parts < kParts; parts *= 2) {
        double off = 0;
        for (std::uint32_t k = 0; k < parts; ++k) {
            const Joints l = between(k / static_cast<double>(parts)), r = between((k + 1.0) / parts);
            const double middle = (k + 0.5) / parts;
            const Joints m{0.5 * (l.xyz + r.xyz), (l.tilt + r.tilt) / 2, (l.turn + r.turn) / 2};
            off = std::max(off, distance(kinematics::forward(a.chain, m).tip, begin + middle * (tip - begin)));
        }
        if (off <= a.chord) break;
    }
    for (std::uint32_t k = 1; k <= parts; ++k) {
        const double f = k == parts ? 1 : k / static_cast<double>(parts);
        const Joints here = k == parts ? to : between(f);
        put({.act = leg.act,
             .role = leg.role,
             .layer = leg.layer,
             .to = a.numbers == machine::Numbers::tip ? begin + f * (tip - begin) : here.xyz,
             .feed = leg.feed,
             .volume = leg.volume / parts,
             .width = leg.width,
             .height = leg.height,
             .tilt = here.tilt,
             .turn = here.turn,
             .length = distance(begin, tip) / parts,
             .seconds = seconds / parts,
             .axes = here.xyz,
             .axis = poses_[i].axis,
             .heading = headings_[i],
             .tool = tool_,
             .fed = leg.fed / parts,
             .halt = leg.halt && k == parts});
    }
}

} // namespace filum::postproc
