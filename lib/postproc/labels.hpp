// Which of several parts on the bed a program is at, as firmware wants to be told so that one of them can be left out.
#pragma once

#include "geom/vec.hpp"
#include "machine/profile.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

using geom::Vec2;

// A part on the bed.
struct Labelled {
    std::string name;
    std::vector<Vec2> outline; // convex, counter-clockwise, mm, in the toolpath's frame
};

// The same parts with names that are safe in a program: letters, digits, '-' and '_', no name twice.
std::vector<Labelled> with_plain_names(std::vector<Labelled> parts);

// The part that `at` lies in, or the nearest; of several as near the first.  Precondition: there is one.
std::size_t part_at(const std::vector<Labelled>& parts, Vec2 at);

// Lines of a program, in the words of `how`: that there are these parts, moved by `shift`; that one begins (the first
// time so: with its name), that it ends.
std::vector<std::string> define_parts(machine::Objects how, const std::vector<Labelled>& parts, Vec2 shift);
std::vector<std::string> begin_part(machine::Objects how, const std::vector<Labelled>& parts, std::size_t part,
                                    bool first);
std::string end_part(machine::Objects how, const std::vector<Labelled>& parts, std::size_t part);

} // namespace filum::postproc
