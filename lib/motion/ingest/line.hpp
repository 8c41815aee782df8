// One line of a program, with its words sorted by their meaning on the machine.
#pragma once

#include "ingest/arc.hpp"
#include "machine/codes.hpp"

#include <array>
#include <optional>
#include <vector>

namespace filum::ingest {

struct Line {
    machine::AxisNumbers numbers{}; // mm, degrees; valid where `has` is set
    std::array<bool, 5> has{};      // the axis has a number
    std::array<bool, 5> named{};    // the axis is on the line, with or without a number
    std::optional<double> extruder; // mm, value of the extruder word
    int extruder_decimals = 0;
    ArcWords arc;
    std::vector<double> g, m;
    std::optional<double> tool, d, l, p, s;
    char foreign_axis = 0;       // letter of an axis that the machine lacks: A B C U V W
    bool extruder_named = false; // with or without a number
    char first = 0;              // letter of the first word after the line number

    [[nodiscard]] bool places() const;
    // Whether it names an axis or the extruder without a number, as "X#1" with a parameter does.
    [[nodiscard]] bool names() const;
    [[nodiscard]] bool moves() const { return places() || extruder || foreign_axis != 0; }
};

// Sorts the words of a line.  `counts`: the machine has an extruder word.  `unit`: mm per unit of length.
Line sorted(const machine::Words& words, const machine::Profile& profile, char extruder, bool counts, double unit);

} // namespace filum::ingest
