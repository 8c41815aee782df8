#include "postproc/timeline.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

double Nominal::add(const Step& step) {
    if (step.act == Act::tool) placed_ = false; // its position is unknown
    if (step.act != Act::travel && step.act != Act::climb && step.act != Act::extrude) return sum_;
    if (step.seconds > 0) {
        sum_ += step.seconds;
    } else if (placed_ && step.feed > 0) {
        const double radius = step.sweep != 0 ? geom::distance(at_.xy(), step.centre) : 0;
        sum_ += (step.sweep != 0 ? std::abs(step.sweep) * radius : distance(step.to, at_)) / step.feed;
    }
    at_ = step.to;
    placed_ = true;
    return sum_;
}

double Timeline::seconds_at(double t) const {
    const auto above = std::upper_bound(nominal.begin(), nominal.end(), t);
    if (above == nominal.begin()) return 0;
    if (above == nominal.end()) return total();
    const auto i = static_cast<std::size_t>(above - nominal.begin());
    const double share = (t - nominal[i - 1]) / (nominal[i] - nominal[i - 1]);
    return seconds[i - 1] + share * (seconds[i] - seconds[i - 1]);
}

} // namespace filum::postproc
