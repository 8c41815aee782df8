#include "ingest/codes.hpp"

#include <cmath>

namespace filum::ingest {

namespace {

bool within(double v, double low, double high) { return v >= low - 1e-3 && v <= high + 1e-3; }

// Codes that change later moves and are not followed, with any other words on their line.
const char* what_is_not_followed(double g) {
    struct Range {
        double from, to;
        const char* what;
    };
    constexpr Range kRanges[] = {
        {2.1, 2.9, "a curve"},
        {3.1, 3.9, "a curve"},
        {6.1, 6.9, "a curve"},
        {7, 7, "the diameter mode of a lathe"},
        {7.1, 7.1, "cylindrical interpolation"},
        {12.1, 12.1, "polar interpolation"},
        {16, 16, "polar coordinates"},
        {41, 42.1, "the compensation of a cutter's radius"},
        {43.4, 43.5, "the control of the tool's tip"},
        {51, 51.2, "scaled or mirrored coordinates"},
        {54.1, 54.9, "further work coordinates"},
        {65, 66.1, "a macro"},
        {68, 68.4, "turned coordinates"},
        {92.3, 92.3, "the origin of an earlier G92"},
        {70, 70, "inches, or a cycle of a lathe"},
        {107, 107, "cylindrical interpolation"},
        {112, 112, "polar interpolation"},
        {234, 234, "the control of the tool's tip"},
        {700, 700, "inches"},
    };
    for (const Range& r : kRanges)
        if (within(g, r.from, r.to)) return r.what;
    return nullptr;
}

// Codes that are a curve or a cycle if their line has an axis, and harmless otherwise: on some printers G5 and G80 to
// G89 start a calibration.
const char* cycle(double g) {
    if (within(g, 5, 6)) return "a curve";
    if (within(g, 33, 33.1)) return "a move that keeps up with a spindle";
    if (within(g, 50, 50)) return "new coordinates of a lathe";
    if (within(g, 60, 60)) return "a move from one side";
    if (within(g, 61, 61)) return "the way back to a stored place";
    if (within(g, 71, 76) || within(g, 81, 89)) return "a cycle of drilling or threading";
    return nullptr;
}

bool is_modal(double g) {
    return within(g, 15, 21) || within(g, 40, 50) || within(g, 61, 64) || within(g, 67, 69) || within(g, 80, 80) ||
           within(g, 90, 91.1) || within(g, 93, 99);
}

} // namespace

Code code_of(double g, const LineWords& line) {
    if (const char* why = what_is_not_followed(g)) return {Action::not_followed, why};
    if (const char* why = cycle(g); why != nullptr && line.places) return {Action::not_followed, why};
    if (within(g, 43.1, 43.2)) return {Action::command}; // the tool's length, by the axis words of the line
    const auto is = [g](double code) { return within(g, code, code); };
    if (is(0) || is(1) || is(2) || is(3)) return {Action::move};
    if (is(28) || is(30) || is(161) || is(162)) return {Action::home};
    if (within(g, 38.2, 38.5)) return {Action::probe};
    if (is(92)) return {Action::zero};
    if (is(92.1) || is(92.2)) return {Action::native};
    if (is(52)) return {Action::local};
    if (is(53)) return {Action::machine};
    if (within(g, 54, 59.3)) return {Action::work_system};
    if (is(10) || (is(22) && line.machinekit)) return {line.offsets ? Action::work_offset : Action::retract};
    if (is(11) || (is(23) && line.machinekit)) return {Action::give};
    return {is_modal(g) ? Action::modal : Action::command};
}

} // namespace filum::ingest
