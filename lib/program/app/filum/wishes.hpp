// The optional stages of the planar chain: those that run only if the user asks for them.
#pragma once

#include "app/filum/distribute.hpp"
#include "app/filum/stage.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// Whether the stage is optional (kByWish).
bool by_wish(const Stage& stage);

// Removes the optional stages that the words do not ask for, from `stages` and from request.arguments.  A stage is
// asked for by its name or by an option that no other stage has; `vase` is asked for by --vase or its name, and
// replaces `skins`.  Returns the given options that have no effect in a vase, such as --infill.
std::vector<std::string> keep_wished(const std::vector<std::string>& words, Request& request,
                                     std::vector<Stage>& stages);

} // namespace filum::app::filum
