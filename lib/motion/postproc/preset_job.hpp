// The job as the macros of a slicer's profile see it.
#pragma once

#include "postproc/first_pass.hpp"
#include "preset/program.hpp"

#include <memory>

namespace filum::postproc {

// The G-code of the slicer's profile for the job of `first_pass`, moved by `shift`; null for a machine without one.
// Temperatures in the machine's [values] override those of the preset.  Throws as preset::Program does.
std::unique_ptr<preset::Program> preset_program(const machine::Profile& profile, const FirstPass& first_pass,
                                                Vec2 shift);

// Throws Error(failure) if the beads leave the bed's outline.
void check_outline(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift);

} // namespace filum::postproc
