// The stages of the planar chain that take part only where somebody asks for what they do.
#pragma once

#include "app/filum/route.hpp"
#include "app/filum/stage.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

bool by_wish(const Stage& stage);

// Leaves out the stages that nobody asks for, by an option of their own or by --vase.  Returns those options that
// have no effect in a vase, as --infill.
std::vector<std::string> keep_wished(const std::vector<std::string>& words, Request& request,
                                     std::vector<Stage>& stages);

} // namespace filum::app::filum
