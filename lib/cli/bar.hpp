// A line that tells how far a program is.
#pragma once

#include <cstdint>
#include <string>

namespace filum::cli {

// "NAME [####   ]  40 %"; with nothing expected "NAME: DONE", with nothing done either "NAME".
std::string bar(const std::string& name, std::uint64_t done, std::uint64_t expected);

} // namespace filum::cli
