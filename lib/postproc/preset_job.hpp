// The job as the macros of a slicer's profile may ask for it.
#pragma once

#include "postproc/first_pass.hpp"
#include "preset/program.hpp"

#include <memory>

namespace filum::postproc {

// The profile's G-code for the job of `first_pass`, moved by `shift`; null for a machine without a slicer's profile.
// [values] of the machine that name temperatures win over the preset's.  Throws as preset::Program.
std::unique_ptr<preset::Program> preset_program(const machine::Profile& profile, const FirstPass& first_pass,
                                                Vec2 shift);

// Throws Error(failure) if the beads leave the bed's outline.
void check_outline(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift);

} // namespace filum::postproc
