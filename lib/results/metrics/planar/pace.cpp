#include "metrics/planar/pace.hpp"

#include "base/error.hpp"
#include "geom/polyline.hpp"
#include "machine/reading.hpp"
#include "postproc/measure.hpp"

#include <cmath>
#include <limits>

namespace filum::metrics::planar {

namespace {

using toolpath::Span;

// How moves are merged for the measurement. Those of a program are merged already. But arcs and moves of rotary axes
// were read as several chords, which are joined again. They are off by the reader's tolerance and the program's
// decimals. Half of a tolerance is kept for rounding.
machine::Merging merging(const machine::Profile& p, bool as_written) {
    machine::Merging out = machine::standard_merging();
    if (!as_written) return out;
    if (!p.axes.active() && !p.format.arcs) return {};
    out.planar = out.surface = 2 * (machine::kReadChord + std::pow(10.0, -p.format.xyz_decimals));
    return out;
}

// The profile with all limits removed that would stop the measurement with an error.
machine::Profile lenient(machine::Profile p, bool as_written) {
    constexpr double endless = std::numeric_limits<double>::infinity();
    p.limits.section = endless;
    p.fibre.omit_short = true;
    p.fibre.most_path = endless;
    p.fibre.spool = 0;
    if (p.tools.change.empty()) p.tools.change = "\n";
    if (as_written) p.axes.chord = endless; // the program has all poses between which the axes move straight
    machine::merge_moves(p, merging(p, as_written));
    for (auto& [number, one] : p.own) {
        machine::Profile copy = *one;
        copy.limits.section = endless;
        copy.axes.chord = p.axes.chord;
        one = std::make_shared<const machine::Profile>(std::move(copy));
    }
    return p;
}

} // namespace

Pace::Pace(const machine::Profile& profile, bool as_written)
    : profile_(lenient(profile, as_written)), as_written_(as_written), surveyor_(profile_) {
    if (!profile_.axes.active()) walker_ = postproc::walker(profile_, {}, [this](auto steps) { surveyor_.add(steps); });
}

// Ends a stroke of fibre.
void Pace::close() {
    if (open_ && profile_.fibre.lays(tool_)) {
        ToolShare& tool = tools_[tool_];
        tool.fibre = true;
        ++tool.cuts;
        tool.too_short += fibre_ < profile_.fibre.least_path - 1e-3 ? 1 : 0;
    }
    open_ = false;
    fibre_ = 0;
}

void Pace::count(const Span& span) {
    const double length = geom::length(span.points);
    if (!toolpath::extrudes(span.role)) {
        close();
        if (begun_) tools_[span.tool].travel += length;
        return;
    }
    if (span.tool != tool_) close();
    tool_ = span.tool;
    ToolShare& tool = tools_[tool_];
    tool.strokes += open_ ? 0 : 1;
    open_ = begun_ = true;
    tool.laid += length;
    fibre_ += length;
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) tool.volume += toolpath::volume(span, i);
}

void Pace::add(const Span& span) {
    count(span);
    if (!walker_) {
        if (profile_.axes.active()) kept_.push_back(span);
        return;
    }
    try {
        walker_->add(span);
    } catch (const Error& e) { // the spans are not connected
        why_ = e.what();
        walker_.reset();
    }
}

postproc::FirstPass Pace::first_pass() {
    if (walker_) {
        walker_->end();
        return surveyor_.end();
    }
    // How far rotary axes turn depends on the place, and a program has its own.
    if (as_written_) {
        try {
            return first_pass(postproc::Place::as_is);
        } catch (const Error&) { // it was written for a machine of another size
        }
    }
    return first_pass(postproc::Place::center);
}

postproc::FirstPass Pace::first_pass(postproc::Place place) {
    postproc::Measure measure(profile_, place);
    do
        for (const Span& span : kept_) measure.add(span);
    while (measure.again());
    return measure.end();
}

double Pace::seconds() {
    close();
    if (!begun_) return 0;
    if (!why_.empty()) return -1;
    try {
        const auto found = first_pass();
        for (const auto& [number, totals] : found.tools) {
            tools_[number].print_seconds = totals.print_seconds;
            tools_[number].travel_seconds = totals.travel_seconds;
        }
        return found.seconds;
    } catch (const Error& e) {
        why_ = e.what();
        return -1;
    }
}

} // namespace filum::metrics::planar
