#include "postproc/carry.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

using geom::Frame;
using geom::kDegree;
using kinematics::FollowFailure;
using kinematics::Hindrance;
using machine::Spin;

constexpr double kLeastAcross = 0.05; // least length of a unit vector's part across the tool axis for a heading
constexpr double kSlower = 1.001;     // a move counts as slowed if it takes longer by this factor

Frame tip(const kinematics::Pose& pose, const Vec3& heading) {
    return {geom::rotation_of(-1.0 * pose.axis, heading), pose.tip};
}

std::string degrees_of(double rad) { return fixed_text(rad / kDegree, 2) + " degrees"; }

std::string place_of(const Vec3& p) {
    return "x " + fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) + ", z " + fixed_text(p.z, 3);
}

} // namespace

Carrier::Carrier(const machine::Profile& profile) : profile_(&profile) {
    const machine::Robot& r = profile.robot;
    if (!r.arm) return;
    efforts_.known = true;
    carried_.arm = *r.arm;
    carried_.tool = r.tool;
    carried_.round = profile.axes.spin == Spin::free;
    carried_.singular = r.singular;
    before_.posture = r.start;
    if (profile.axes.spin == Spin::free)
        heading_ = (geom::inverse(r.base) * kinematics::forward(carried_.arm, r.start) * r.tool).turn.x;
}

std::vector<Vec3> Carrier::headings(const Motion& stroke) {
    std::vector<Vec3> out(stroke.poses.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::size_t a = i > 0 ? i - 1 : 0, b = i + 1 < out.size() ? i + 1 : i;
        const Vec3 &up = stroke.poses[i].axis, way = stroke.poses[b].tip - stroke.poses[a].tip;
        Vec3 to = heading_;
        if (profile_->axes.spin == Spin::fixed) to = {1, 0, 0};
        if (profile_->axes.spin == Spin::follow && norm(way) > 0) to = 1 / norm(way) * way;
        Vec3 across = to - dot(to, up) * up;
        if (norm(across) < kLeastAcross) across = heading_ - dot(heading_, up) * up;
        if (norm(across) < kLeastAcross) across = cross(up, std::abs(up.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
        out[i] = heading_ = 1 / norm(across) * across;
    }
    return out;
}

void Carrier::carry(const Motion& stroke, std::size_t change, std::vector<double>& seconds,
                    std::vector<Vec3>& headings) {
    const std::size_t n = stroke.poses.size();
    jointly_ = {stroke_ == 0 ? 0 : kNone, change < n ? change : kNone};
    ++stroke_;
    if (!efforts_.known) return;
    if (change > 0) part(stroke, 0, std::min(change, n), seconds, headings);
    tool_ = stroke.legs.back().tool;
    if (change < n) part(stroke, change, n, seconds, headings);
}

const kinematics::Posture* Carrier::posture(std::size_t i) const {
    if (!efforts_.known || !jointly(i)) return nullptr;
    // The joint moves of the last stroke are the last ones of stood_, in their order.
    return i == jointly_[0] && jointly_[1] != kNone && jointly_[1] != i ? &stood_[stood_.size() - 2] : &stood_.back();
}

// Moves the arm along the poses [begin, end), which one tool reaches.
void Carrier::part(const Motion& stroke, std::size_t begin, std::size_t end, std::vector<double>& seconds,
                   std::vector<Vec3>& headings) {
    carried_.tool = machine::of_tool(*profile_, tool_).robot.tool;
    before_.joint = jointly(begin);
    // The first move starts where the last stroke ended, unless it is a joint move.
    const std::size_t ahead = before_.joint ? 0 : 1;
    std::vector<kinematics::TimedFrame> stands(ahead, {last_, 0});
    for (std::size_t i = begin; i < end; ++i)
        stands.push_back({profile_->robot.base * tip(stroke.poses[i], headings[i]), seconds[i]});
    auto f = kinematics::follow(carried_, stands, before_);
    f.forget(ahead);
    if (f.hindrance.trouble != FollowFailure::none) {
        f.hindrance.stand += begin;
        refuse(f.hindrance, stroke);
    }
    if (before_.joint) {
        if (stood_.empty())
            efforts_.other_way = !(kinematics::configuration(carried_.arm, f.postures.front()) ==
                                   kinematics::configuration(carried_.arm, before_.posture));
        stood_.push_back(f.postures.front());
    }
    count(f, stroke, begin, seconds);
    for (std::size_t i = begin; i < end; ++i) {
        const Frame wanted = tip(stroke.poses[i], headings[i]);
        headings[i] = kinematics::spun(wanted, f.spin[i - begin]).turn.x;
        efforts_.spin = std::max(efforts_.spin, std::abs(f.spin[i - begin]));
        seconds[i] = std::max(seconds[i], f.needed[i - begin]);
    }
    before_.posture = f.postures.back();
    heading_ = headings[end - 1];
    last_ = profile_->robot.base * tip(stroke.poses[end - 1], heading_);
}

void Carrier::count(const kinematics::FollowResult& f, const Motion& stroke, std::size_t begin,
                    std::span<const double> seconds) {
    ArmEfforts& e = efforts_;
    if (f.room < e.room) {
        e.room = f.room;
        e.room_axis = f.room_axis;
        e.room_at = stroke.poses[begin + f.room_at].tip;
    }
    e.uneasy += f.nearest.angle < carried_.singular ? 1 : 0;
    if (f.nearest.angle < e.nearest.angle) {
        e.nearest = f.nearest;
        e.nearest_at = stroke.poses[begin + f.nearest_at].tip;
        e.nearest_layer = stroke.legs[begin + f.nearest_at].layer;
    }
    for (std::size_t k = 0; k < f.needed.size(); ++k) {
        const std::size_t i = begin + k;
        if (i == 0 || stroke.legs[i].act != Act::extrude || !(f.needed[k] > seconds[i] * kSlower)) continue;
        const double length = distance(stroke.poses[i - 1].tip, stroke.poses[i].tip);
        e.slowed += length;
        ++e.slow_moves;
        if (length == 0 || seconds[i] / f.needed[k] >= e.slowest) continue;
        e.slowest = seconds[i] / f.needed[k];
        e.slow_axis = f.axis[k];
        e.slowest_at = stroke.poses[i].tip;
        e.slowest_layer = stroke.legs[i].layer;
    }
}

void Carrier::refuse(const Hindrance& h, const Motion& stroke) const {
    const std::string axis = "axis " + std::to_string(h.axis + 1);
    std::string why = "out of reach";
    if (h.trouble == FollowFailure::reach && h.amount > 0)
        why += (h.axis == 0 ? ": too near to axis 1 by " : ": the arm is too short, or folds too little, by ") +
               fixed_text(h.amount, 1) + " mm";
    else if (h.trouble == FollowFailure::reach && h.axis == 4)
        why += " for the wrist";
    if (h.trouble == FollowFailure::limit) why = axis + " would be " + degrees_of(h.amount) + " beyond its limit";
    if (h.trouble == FollowFailure::jump)
        why = "the way there leads through a singularity, where " + axis +
              (h.amount > kDegree ? " would turn by " + degrees_of(h.amount) + " at once" : " changes its side");
    const auto& leg = stroke.legs[h.stand];
    throw Error(Exit::failure,
                "cannot reach " + place_of(stroke.poses[h.stand].tip) + " on '" + profile_->name + "' (stroke " +
                    std::to_string(stroke_) + ", layer " + std::to_string(leg.layer) + ", " +
                    (leg.act == Act::extrude ? "a bead" : "a travel") + ", point " + std::to_string(h.stand) +
                    "): " + why + "; move the part by robot.base, change robot.start or robot.tool" +
                    (profile_->axes.spin == Spin::free ? "" : ", or let a round tool turn by kinematics.spin=free"));
}

void add_arm_efforts(const machine::Profile& profile, const ArmEfforts& e, const std::string& stage, Notes& notes,
                     Facts& facts) {
    if (!e.known) {
        notes.push_back({NoteCode::robot_unchecked, 1, 1});
        return;
    }
    if (std::isfinite(e.room)) { // infinite if no axis has limits
        facts.push_back({stage, "least-room-of-an-axis", e.room / kDegree, "deg"});
        facts.push_back({stage, "axis-of-least-room", static_cast<double>(e.room_axis + 1), ""});
    }
    facts.push_back({stage, "nearest-singularity", e.nearest.angle / kDegree, "deg"});
    facts.push_back({stage, "slowest-share-of-feed", e.slowest, ""});
    if (e.slow_moves > 0) facts.push_back({stage, "axis-of-slowest", static_cast<double>(e.slow_axis + 1), ""});
    facts.push_back({stage, "largest-spin", e.spin / kDegree, "deg"});
    if (e.nearest.angle < profile.robot.singular)
        notes.push_back({NoteCode::robot_near_singularity, e.nearest.angle / kDegree, e.uneasy,
                         static_cast<std::int64_t>(e.nearest_layer), e.nearest_at.x, e.nearest_at.y, std::nan(""),
                         kinematics::kSingularNames[static_cast<std::size_t>(e.nearest.which)]});
    if (e.slow_moves > 0)
        notes.push_back({NoteCode::beads_slowed, e.slowed, e.slow_moves, static_cast<std::int64_t>(e.slowest_layer),
                         e.slowest_at.x, e.slowest_at.y});
    if (e.other_way) notes.push_back({NoteCode::robot_other_posture, 1, 1});
}

} // namespace filum::postproc
