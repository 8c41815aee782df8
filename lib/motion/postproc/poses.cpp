#include "postproc/poses.hpp"

#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

using kinematics::Joints;
using kinematics::Pose;

constexpr std::uint32_t kParts = 4096; // most parts of a move
constexpr double kSameFeed = 1.05;     // largest ratio of the feeds of legs that are merged

// The largest error of the tip from rounding to the last decimals, mm.
double rounding(const machine::Profile& profile, const Joints& at) {
    const double linear = std::pow(10.0, -profile.format.xyz_decimals) / 2;
    const auto& a = profile.axes;
    if (a.chain.carrier == kinematics::Carrier::frame || a.numbers == machine::Numbers::tip)
        return std::sqrt(3.0) * linear;
    const double angular = std::pow(10.0, -a.angle_decimals) / 2 * geom::kDegree;
    const auto& c = a.chain;
    const double arm = norm(at.xyz) + norm(c.tip_to_tilt) + norm(c.tilt_to_turn);
    return std::sqrt(3.0) * linear + 2 * angular * arm;
}

Joints middle(const Joints& a, const Joints& b, double f) {
    return {a.xyz + f * (b.xyz - a.xyz), a.tilt + f * (b.tilt - a.tilt), a.turn + f * (b.turn - a.turn)};
}

// The number of parts into which the move to pose i is divided.  While the axes move straight in each part, the tip
// keeps to its line.
std::uint32_t parts(const machine::Profile& profile, const Motion& m, std::size_t i) {
    const auto& a = profile.axes;
    const Joints &from = m.joints[i - 1], &to = m.joints[i];
    const Vec3 &begin = m.poses[i - 1].tip, &tip = m.poses[i].tip;
    const auto at = [&](double f) { return kinematics::between(a.chain, begin, from, tip, to, f); };
    const double chord = std::max(a.chord - rounding(profile, to), a.chord / 2);
    std::uint32_t parts = 1;
    // The tip is farthest off in the middle of a part.  Halving the parts leaves a quarter of that distance.
    for (; parts < kParts; parts *= 2) {
        double off = 0;
        Joints l = at(0);
        for (std::uint32_t k = 0; k < parts; ++k) {
            const Joints r = at((k + 1.0) / parts);
            const double f = (k + 0.5) / parts;
            const Vec3 there = kinematics::forward(a.chain, middle(l, r, 0.5)).tip;
            off = std::max(off, distance(there, begin + f * (tip - begin)));
            l = r;
        }
        if (off <= chord) break;
    }
    return parts;
}

// Part k of n equal parts of a leg.
Leg part_of(const Leg& leg, std::uint32_t k, std::uint32_t n) {
    Leg out = leg;
    out.volume /= n;
    out.fed /= n;
    if (k > 1) out.before = Act::extrude;
    out.halt = leg.halt && k == n;
    return out;
}

// The poses of one stroke, for merging.
class StrokePoses {
  public:
    StrokePoses(const machine::Profile& profile, const Motion& motion, std::size_t stay, std::size_t landing)
        : p_(profile), m_(motion), frames_(profile.axes.chain.carrier == kinematics::Carrier::frame),
          tips_(frames_ || profile.axes.numbers == machine::Numbers::tip), at_(motion.poses.size(), 0),
          stays_(motion.poses.size(), 0) {
        const auto& chain = p_.axes.chain;
        for (std::size_t i = 0; i < m_.poses.size(); ++i) {
            if (i > 0) at_[i] = at_[i - 1] + distance(m_.poses[i - 1].tip, m_.poses[i].tip);
            const Joints& j = m_.joints[i];
            axes_.push_back(frames_ ? m_.poses[i].axis : kinematics::tool_axis(chain, j.tilt, j.turn));
        }
        for (std::size_t k = 0; k <= stay && k < stays_.size(); ++k) stays_[k] = 1;
        if (landing < stays_.size()) stays_[landing] = 1;
    }

    // True if one move may replace the moves from pose i to pose j.
    bool fits(std::uint32_t i, std::uint32_t j) {
        const Leg& first = m_.legs[i + 1];
        const double most = tolerance(j, first.surface);
        const double length = at_[j] - at_[i];
        if (!(most > 0) || !(length > 0) || !same_kind(i, j) || !same_section(i, j)) return false;
        double off = 0;
        for (std::uint32_t k = i; k < j; ++k) {
            const double f = (at_[k] - at_[i]) / length, g = (at_[k + 1] - at_[i]) / length;
            if (k > i && !near(i, j, f, m_.poses[k].tip, axes_[k], most, off)) return false;
            const Vec3 tip = 0.5 * (m_.poses[k].tip + m_.poses[k + 1].tip), axis = axes_[k] + axes_[k + 1];
            if (!near(i, j, (f + g) / 2, tip, axis, most, off)) return false;
        }
        off_ = std::max(off_, off);
        return true;
    }
    [[nodiscard]] double off() const { return off_; }

  private:
    [[nodiscard]] double tolerance(std::uint32_t at, bool surface) const {
        const double whole = surface ? p_.merging.surface : p_.merging.planar;
        return std::max(whole - rounding(p_, m_.joints[at]), whole / 2);
    }

    // True if tip and axis at share `f` of the move from i to j are within the tolerances of `tip` and `axis`.
    bool near(std::uint32_t i, std::uint32_t j, double f, const Vec3& tip, const Vec3& axis, double most, double& off) {
        Pose now;
        if (frames_)
            now = {m_.poses[i].tip, axes_[i] + f * (axes_[j] - axes_[i])};
        else if (tips_) {
            const Joints there = middle(m_.joints[i], m_.joints[j], f);
            now.axis = kinematics::tool_axis(p_.axes.chain, there.tilt, there.turn);
        } else {
            now = kinematics::forward(p_.axes.chain, middle(m_.joints[i], m_.joints[j], f));
        }
        if (tips_) now.tip = m_.poses[i].tip + f * (m_.poses[j].tip - m_.poses[i].tip);
        const double away = distance(now.tip, tip);
        off = std::max(off, away);
        return away <= most && geom::angle(now.axis, axis) <= p_.merging.axis + kTouch;
    }

    [[nodiscard]] bool same_kind(std::uint32_t i, std::uint32_t j) const {
        const Leg& a = m_.legs[i + 1];
        double slow = a.feed, fast = a.feed;
        for (std::uint32_t k = i + 1; k <= j; ++k) {
            const Leg& b = m_.legs[k];
            if (b.act != a.act || b.role != a.role || b.feature != a.feature || b.layer != a.layer ||
                b.tool != a.tool || !b.straight || b.surface != a.surface)
                return false;
            if (k > i + 1 && (b.before != Act::extrude || stays_[k - 1] != 0 || m_.legs[k - 1].halt)) return false;
            slow = std::min(slow, b.feed);
            fast = std::max(fast, b.feed);
        }
        return fast <= kSameFeed * slow;
    }

    [[nodiscard]] bool same_section(std::uint32_t i, std::uint32_t j) const {
        constexpr double share = toolpath::Tolerance{}.section;
        double volume = 0;
        for (std::uint32_t k = i + 1; k <= j; ++k) volume += m_.legs[k].volume;
        const double mean = volume / (at_[j] - at_[i]);
        // A bead along a shorter chord is thicker.
        if (volume > 0 && at_[j] - at_[i] > (1 + share) * distance(m_.poses[i].tip, m_.poses[j].tip)) return false;
        bool pointwise = true, so_far = true;
        double laid = 0;
        for (std::uint32_t k = i + 1; k <= j; ++k) {
            const double step = at_[k] - at_[k - 1], section = step > 0 ? m_.legs[k].volume / step : mean;
            pointwise = pointwise && std::abs(section - mean) <= share * section + kTouch;
            laid += m_.legs[k].volume;
            so_far = so_far && std::abs(laid - mean * (at_[k] - at_[i])) <= share * section * m_.legs[k].width + kTouch;
        }
        return pointwise || so_far;
    }

    const machine::Profile& p_;
    const Motion& m_;
    bool frames_, tips_;
    std::vector<double> at_; // mm, arc length of the tip's path
    std::vector<std::uint8_t> stays_;
    std::vector<Vec3> axes_;
    double off_ = 0;
};

// The legs (i, j] merged to one.
Leg whole(const Motion& m, std::uint32_t i, std::uint32_t j) {
    Leg out = m.legs[i + 1];
    double length = 0, width = 0, height = 0;
    out.volume = out.fed = 0;
    for (std::uint32_t k = i + 1; k <= j; ++k) {
        const Leg& leg = m.legs[k];
        const double l = distance(m.poses[k - 1].tip, m.poses[k].tip);
        length += l;
        width += l * leg.width;
        height += l * leg.height;
        out.volume += leg.volume;
        out.fed += leg.fed;
        out.feed = std::min(out.feed, leg.feed);
    }
    if (length > 0) {
        out.width = width / length;
        out.height = height / length;
    }
    out.halt = m.legs[j].halt;
    return out;
}

} // namespace

Motion refined(const machine::Profile& p, Motion m, std::size_t stay, std::size_t& landing) {
    const auto& a = p.axes;
    if (a.chain.carrier == kinematics::Carrier::frame || a.numbers == machine::Numbers::tip) return m;
    Motion out;
    std::vector<std::size_t> moved(m.poses.size());
    for (std::size_t i = 0; i < m.poses.size(); ++i) {
        const bool lies = i > 0 && (stay == 0 || i > stay) && m.legs[i].straight;
        const std::uint32_t n = lies ? parts(p, m, i) : 1;
        for (std::uint32_t k = 1; k < n; ++k) {
            const double f = k / static_cast<double>(n);
            const Vec3 &begin = m.poses[i - 1].tip, &tip = m.poses[i].tip;
            out.joints.push_back(kinematics::between(a.chain, begin, m.joints[i - 1], tip, m.joints[i], f));
            out.poses.push_back({begin + f * (tip - begin),
                                 kinematics::tool_axis(a.chain, out.joints.back().tilt, out.joints.back().turn)});
            out.legs.push_back(part_of(m.legs[i], k, n));
        }
        moved[i] = out.poses.size();
        out.poses.push_back(m.poses[i]);
        out.joints.push_back(m.joints[i]);
        out.legs.push_back(part_of(m.legs[i], n, n));
    }
    landing = landing < moved.size() ? moved[landing] : out.poses.size();
    return out;
}

Motion fewer(const machine::Profile& p, Motion m, std::size_t stay, std::size_t& landing, double& off) {
    if (m.poses.size() < 3 || (p.merging.planar <= 0 && p.merging.surface <= 0)) return m;
    StrokePoses stroke_poses(p, m, stay, landing);
    const auto kept = toolpath::greedy_steps(static_cast<std::uint32_t>(m.poses.size()),
                                             [&](std::uint32_t i, std::uint32_t j) { return stroke_poses.fits(i, j); });
    Motion out;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        out.poses.push_back(m.poses[kept[k]]);
        out.joints.push_back(m.joints[kept[k]]);
        out.legs.push_back(k == 0 ? m.legs[0] : whole(m, kept[k - 1], kept[k]));
    }
    landing = static_cast<std::size_t>(std::lower_bound(kept.begin(), kept.end(), landing) - kept.begin());
    off = std::max(off, stroke_poses.off());
    return out;
}

} // namespace filum::postproc
