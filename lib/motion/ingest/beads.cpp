#include "ingest/beads.hpp"

#include <algorithm>
#include <cmath>

namespace filum::ingest {

namespace {

using toolpath::Retraction;
using toolpath::Role;
using toolpath::Span;

constexpr double kStopWay = 0.05, kAside = 0.5; // mm
constexpr double kLayers = 2.01;                // layer heights that a stroke may climb without a bead
constexpr double kStanding = 1e-6;              // mm

Span span_of(const std::vector<Place>& places, bool leans) {
    Span out;
    for (const Place& p : places) {
        out.points.push_back(p.tip);
        if (leans) out.normals.push_back(p.axis);
    }
    return out;
}

bool alike(const DepositedBead& a, const DepositedBead& b) {
    return a.height == b.height && a.layer == b.layer && a.tool == b.tool && a.role == b.role && a.feature == b.feature;
}

} // namespace

void Beads::stand(const Place& at) { at_ = at; }

void Beads::go(const Place& to, bool takes) {
    if (begun_) {
        close_run();
        if (gap_.empty()) gap_.push_back(at_);
        gap_.push_back(to);
        const double way = distance(at_.tip.xy(), to.tip.xy());
        gap_way_ += way;
        if (way > kStanding && !takes) taking_ = false;
    }
    at_ = to;
}

void Beads::take_back(double volume) {
    owed_ += volume;
    if (!begun_) return;
    close_run();
    if (gap_.empty()) gap_.push_back(at_);
    if (!taking_) ++retractions_;
    taken_ = taking_ = true;
}

void Beads::push(double volume) {
    const double given = std::min(owed_, volume);
    owed_ -= given;
    if (begun_) counts_.still += volume - given;
    taking_ = false;
}

void Beads::begin_run(const DepositedBead& what) {
    run_ = {};
    run_.role = what.role;
    run_.feature = what.feature;
    run_.stroke = static_cast<std::uint32_t>(counts_.strokes - 1);
    run_.layer = what.layer;
    run_.tool = what.tool;
    run_.points = {at_.tip};
    if (leans_) run_.normals = {at_.axis};
    bead_ = what;
    bead_.volume = 0;
    length_ = 0;
}

void Beads::lay(const Place& to, const DepositedBead& what) {
    close_gap(what);
    const double length = distance(at_.tip, to.tip);
    const double low = (what.volume - what.unsure) / length, high = (what.volume + what.unsure) / length;
    const bool goes_on = !run_.points.empty() && alike(what, bead_) && low <= most_ && high >= least_;
    if (!goes_on) {
        close_run();
        begin_run(what);
        least_ = low;
        most_ = high;
    }
    least_ = std::max(least_, low);
    most_ = std::min(most_, high);
    run_.points.push_back(to.tip);
    if (leans_) run_.normals.push_back(to.axis);
    bead_.volume += what.volume;
    length_ += length;
    counts_.volume += what.volume;
    counts_.extruded += length;
    at_ = to;
}

void Beads::close_run() {
    if (run_.points.empty()) return;
    run_.width = {bead_.volume / length_ / bead_.height};
    run_.height = {bead_.height};
    emit_(run_);
    run_ = {};
}

// Emits the gap between the last bead and the next, if there is one.
void Beads::close_gap(const DepositedBead& next) {
    if (!begun_) {
        begun_ = true;
        counts_.strokes = 1;
        return;
    }
    if (gap_.empty()) return;
    const Vec3 from = gap_.front().tip, to = at_.tip;
    const double up = to.z - from.z, limit = kLayers * std::min(next.height, bead_.height);
    const bool breaks = distance(from.xy(), to.xy()) > kAside || taken_ || std::abs(up) > limit;
    if (gap_.size() < 2) gap_.push_back(gap_.front());
    Span span = span_of(gap_, leans_);
    span.layer = next.layer;
    span.tool = next.tool;
    const bool lifts = gap_way_ <= kStopWay && !taken_ && up > 0 && up <= limit;
    span.role = lifts ? Role::lift : Role::travel;
    if (lifts)
        span.width = {bead_.volume / length_ / bead_.height}, span.height = {next.height};
    else
        span.retraction = taken_ ? Retraction::taken : Retraction::none;
    counts_.stops += gap_way_ > kStopWay || taken_ ? 1 : 0;
    counts_.travels += gap_way_ > kAside ? 1 : 0;
    counts_.travelled += gap_way_;
    counts_.retractions += retractions_;
    counts_.strokes += breaks ? 1 : 0;
    span.stroke = static_cast<std::uint32_t>(counts_.strokes - 1);
    if (gap_way_ > kStanding || taken_ || up != 0) emit_(span);
    gap_.clear();
    gap_way_ = 0;
    retractions_ = 0;
    taken_ = taking_ = false;
}

Counts Beads::finish() {
    close_run();
    return counts_;
}

} // namespace filum::ingest
