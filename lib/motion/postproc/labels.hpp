// Labels of the parts on a bed, in a program.  Firmware needs them to skip one part of several while it prints.
#pragma once

#include "geom/vec.hpp"
#include "machine/profile.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

using geom::Vec2;

// A part on the bed.
struct LabelledPart {
    std::string name;
    std::vector<Vec2> outline; // convex, counter-clockwise, mm, in the toolpath's frame
};

// The same parts with names that are safe in a program: letters, digits, '-' and '_', and no name twice.
std::vector<LabelledPart> with_plain_names(std::vector<LabelledPart> parts);

// The index of the part that `at` lies in, or else of the nearest; the first of equals.  `parts` must not be empty.
std::size_t part_at(const std::vector<LabelledPart>& parts, Vec2 at);

// Lines of a program in the language `how`: define_parts declares the parts, moved by `shift`; begin_part and end_part
// mark where a part begins and ends.  With `first`, begin_part gives the part's name, too.
std::vector<std::string> define_parts(machine::Objects how, const std::vector<LabelledPart>& parts, Vec2 shift);
std::vector<std::string> begin_part(machine::Objects how, const std::vector<LabelledPart>& parts, std::size_t part,
                                    bool first);
std::string end_part(machine::Objects how, const std::vector<LabelledPart>& parts, std::size_t part);

} // namespace filum::postproc
