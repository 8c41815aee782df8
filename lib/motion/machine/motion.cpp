#include "machine/motion.hpp"

#include "machine/look_ahead.hpp"
#include "machine/parabolic.hpp"

#include <cmath>

namespace filum::machine {

std::unique_ptr<Planner> planner(const Profile& p) {
    const bool extruder_turns = p.extrusion.feeding != Feeding::valve && p.extrusion.letter != 'E';
    if (p.motion.controller == Controller::linuxcnc && (p.axes.active() || extruder_turns))
        return std::make_unique<Parabolic>(p);
    return std::make_unique<LookAhead>(p);
}

void Clock::pause(double seconds) {
    (void)planner_->total(); // the machine stops
    paused_ += seconds;
}

double stop_to_stop(double length, double speed, double acceleration) {
    if (!(length > 0)) return 0;
    if (speed * speed >= length * acceleration) return 2 * std::sqrt(length / acceleration);
    return length / speed + (std::isfinite(acceleration) ? speed / acceleration : 0);
}

} // namespace filum::machine
