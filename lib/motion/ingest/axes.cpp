#include "ingest/axes.hpp"

#include "geom/angle.hpp"
#include "kinematics/chain.hpp"
#include "machine/reading.hpp"

namespace filum::ingest {

namespace {

using geom::kDegree;
using machine::AxisNumbers;

constexpr double kLeanOff = 0.2 * kDegree; // rad: most deviation of a piece that turns
constexpr int kMostHalvings = 16;          // halvings of such a move

} // namespace

Axes::Axes(const machine::Profile& profile) : p_(&profile) {
    if (p_->axes.start) stand(*p_->axes.start);
    tip_ = !p_->axes.active() || (p_->axes.numbers == machine::Numbers::tip && p_->axes.tcp_on.empty());
}

void Axes::stand(const kinematics::Joints& j) {
    const bool tips = p_->axes.numbers == machine::Numbers::tip && p_->axes.tcp_on.empty();
    const Vec3 xyz = tips ? kinematics::forward(p_->axes.chain, j).tip : j.xyz;
    at = {xyz.x, xyz.y, xyz.z, j.tilt / kDegree, j.turn / kDegree};
}

void Axes::mean_tip(bool tip) {
    if (tip != tip_) {
        const auto j = machine::joints_of(*p_, tool_, at, tip_);
        const auto& chain = machine::of_tool(*p_, tool_).axes.chain;
        const Vec3 now = tip ? kinematics::forward(chain, j).tip : j.xyz;
        at[0] = now.x;
        at[1] = now.y;
        at[2] = now.z;
    }
    tip_ = tip;
}

Place Axes::place(const AxisNumbers& a) const {
    if (!p_->axes.active()) return {Vec3{a[0], a[1], a[2]} + machine::of_tool(*p_, tool_).offset};
    const auto pose =
        kinematics::forward(machine::of_tool(*p_, tool_).axes.chain, machine::joints_of(*p_, tool_, a, tip_));
    return {tip_ ? Vec3{a[0], a[1], a[2]} : pose.tip, pose.axis};
}

void Axes::part(const AxisNumbers& to, double share, int depth, const PieceVisitor& piece) {
    const Place a = place(at), b = place(to);
    if ((at[3] != to[3] || at[4] != to[4]) && depth < kMostHalvings) {
        AxisNumbers middle{};
        for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = (at[k] + to[k]) / 2;
        const Place m = place(middle);
        const Vec3 axis = a.axis + b.axis;
        const bool near = distance(m.tip, 0.5 * (a.tip + b.tip)) <= machine::kReadChord &&
                          geom::angle(m.axis, axis) <= kLeanOff && geom::angle(a.axis, b.axis) <= 10 * kLeanOff;
        if (!near) {
            part(middle, share / 2, depth + 1, piece);
            part(to, share / 2, depth + 1, piece);
            return;
        }
    }
    piece(a, b, share);
    at = to;
}

} // namespace filum::ingest
