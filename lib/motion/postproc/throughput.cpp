#include "postproc/throughput.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filum::postproc {

namespace {

constexpr std::size_t kHandedOn = 1024; // steps in a batch
constexpr std::size_t kUsualAhead = 16; // moves, if the profile has no look_ahead

double seconds_of(const Step& step) { return step.feed > 0 ? step.length / step.feed : 0; }

} // namespace

Pace pace(const machine::Profile& profile) {
    const auto& m = profile.motion;
    if (!std::isfinite(m.moves_per_second)) return {};
    const std::size_t n = m.look_ahead > 0 ? static_cast<std::size_t>(m.look_ahead) : kUsualAhead;
    return {n, static_cast<double>(n) / m.moves_per_second};
}

std::vector<double> slowdowns(std::span<const double> seconds, const Pace& pace) {
    std::vector<double> out(seconds.size(), 1), at(1, 0);
    for (const double s : seconds) at.push_back(at.back() + s);
    for (std::size_t first = 0; first + pace.moves <= seconds.size(); ++first) {
        const double sum = at[first + pace.moves] - at[first];
        if (sum >= pace.seconds || !(sum > 0)) continue;
        for (std::size_t k = first; k < first + pace.moves; ++k) out[k] = std::max(out[k], pace.seconds / sum);
    }
    return out;
}

std::uint64_t slow_down(std::span<double> seconds, const Pace& pace) {
    const auto factors = slowdowns(seconds, pace);
    std::uint64_t slowed = 0;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        seconds[i] *= factors[i];
        slowed += factors[i] > 1 ? 1 : 0;
    }
    return slowed;
}

Throughput::Throughput(const machine::Profile& profile, Steps out) : pace_(pace(profile)), out_(std::move(out)) {
    steps_.reserve(kHandedOn);
}

void Throughput::add(const Step& step) {
    steps_.push_back(step);
    if (steps_.size() >= kHandedOn + pace_.moves) release(false);
}

void Throughput::end() { release(true); }

// Sets the factors of the moves among the steps [first, last), between which there are only layer marks.
void Throughput::settle(std::size_t first, std::size_t last) {
    if (last - first < pace_.moves) return; // no group of moves
    std::vector<std::size_t> moves;
    std::vector<double> seconds;
    for (std::size_t i = first; i < last; ++i)
        if (steps_[i].act == Act::extrude) {
            moves.push_back(i);
            seconds.push_back(seconds_of(steps_[i]));
        }
    const auto factors = slowdowns(seconds, pace_);
    for (std::size_t k = 0; k < moves.size(); ++k) factors_[moves[k]] = std::max(factors_[moves[k]], factors[k]);
}

// Hands steps on, except the last ones, which may form a group with later moves.
void Throughput::release(bool all) {
    std::size_t ready = steps_.size();
    if (pace_.seconds > 0) {
        factors_.resize(steps_.size(), 1);
        std::size_t first = 0, laid = 0;
        for (std::size_t i = 0; i <= steps_.size(); ++i) {
            const bool ends = i == steps_.size();
            if (!ends && (steps_[i].act == Act::extrude || steps_[i].act == Act::layer)) continue;
            settle(first, i);
            if (!ends) first = i + 1;
        }
        while (!all && ready > first && laid + 1 < pace_.moves) laid += steps_[--ready].act == Act::extrude ? 1 : 0;
    }
    for (std::size_t i = 0; i < std::min(ready, factors_.size()); ++i) {
        if (!(factors_[i] > 1)) continue;
        const double feed = steps_[i].feed / factors_[i];
        steps_[i].feed = feed >= 1 ? std::floor(feed) : feed;
        ++slowed_;
    }
    if (ready > 0) out_(std::span(steps_).first(ready));
    steps_.erase(steps_.begin(), steps_.begin() + static_cast<long>(ready));
    factors_.erase(factors_.begin(), factors_.begin() + static_cast<long>(std::min(ready, factors_.size())));
}

} // namespace filum::postproc
