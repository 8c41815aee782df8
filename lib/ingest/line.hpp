// One line of a program, its words sorted by what they mean on that machine.
#pragma once

#include "ingest/arc.hpp"
#include "machine/codes.hpp"

#include <array>
#include <optional>
#include <vector>

namespace filum::ingest {

struct Line {
    machine::AxisNumbers numbers{}; // mm, degrees; where `has`
    std::array<bool, 5> has{};      // an axis with a number
    std::array<bool, 5> named{};    // an axis with a number or without
    std::optional<double> extruder; // mm, of the word
    int extruder_decimals = 0;
    ArcWords arc;
    std::vector<double> g, m;
    std::optional<double> tool, d, l, p, s;
    char foreign_axis = 0; // a letter of an axis that the machine has not: A B C U V W
    char first = 0;        // the letter of the first word behind the line number

    [[nodiscard]] bool places() const;
    [[nodiscard]] bool moves() const { return places() || extruder || foreign_axis != 0; }
};

// `counts`: the machine has an extruder word.  Inches become mm.
Line sorted(const machine::Words& words, const machine::Profile& profile, char extruder, bool counts, double unit);

} // namespace filum::ingest
