#include "postproc/wipe.hpp"

#include "machine/motion.hpp"

#include <algorithm>

namespace filum::postproc {

bool wipes(const machine::Profile& profile, const machine::Travel& travel) {
    return travel.wipe > 0 && travel.retract > 0 && travel.retract_codes.empty() && !profile.axes.active();
}

double wipe_feed(const machine::Travel& travel, const machine::Feeds& feeds, double length) {
    const double taken = travel.retract * (1 - travel.before_wipe);
    return taken > 0 ? std::min(feeds.travel, length * travel.retract_speed / taken) : feeds.travel;
}

double retract_seconds(const machine::Profile& profile, std::uint32_t tool) {
    const machine::Profile& own = machine::of_tool(profile, tool);
    const machine::Travel& t = own.travel;
    if (!wipes(profile, t)) return machine::stop_to_stop(t.retract, t.retract_speed, t.retract_acceleration);
    return machine::stop_to_stop(t.retract * t.before_wipe, t.retract_speed, t.retract_acceleration) +
           t.wipe / wipe_feed(t, own.feeds, t.wipe);
}

void WipePath::clear() {
    places_.clear();
    length_ = 0;
}

void WipePath::add(const Vec3& from, const Vec3& to, double keep) {
    if (places_.empty() || places_.back() != from) {
        clear();
        places_.push_back(from);
    }
    places_.push_back(to);
    length_ += geom::distance(from, to);
    while (places_.size() > 2 && length_ - geom::distance(places_[0], places_[1]) >= keep) {
        length_ -= geom::distance(places_[0], places_[1]);
        places_.pop_front();
    }
}

std::vector<Vec3> WipePath::back(double most) const {
    std::vector<Vec3> out;
    double left = most;
    for (std::size_t i = places_.size(); i-- > 1 && left > 0;) {
        const Vec3 from = places_[i], to = places_[i - 1];
        const double length = geom::distance(from, to);
        if (from.z != to.z) break;
        if (length > 0) out.push_back(length <= left ? to : from + (left / length) * (to - from));
        left -= length;
    }
    return out;
}

} // namespace filum::postproc
