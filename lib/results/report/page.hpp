// Writes a report as one self-contained page, which opens from disk without network.
#pragma once

#include "report/content.hpp"

#include <span>
#include <string>

namespace filum::report {

// An HTML page that shows one content, or two side by side. Equal contents give equal bytes.
std::string page(std::span<const Content> contents);

} // namespace filum::report
