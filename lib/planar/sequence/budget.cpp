#include "sequence/budget.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

namespace filum::sequence {

std::uint64_t budget(const std::string& text) {
    const bool seconds = !text.empty() && text.back() == 's';
    const double number = parse_number(seconds ? text.substr(0, text.size() - 1) : text, "--budget");
    const double steps = number * (seconds ? static_cast<double>(kStepsPerSecond) : 1e6);
    if (!(steps >= 0 && steps <= 1e12))
        throw Error(Exit::usage, "cannot use '" + text + "' as --budget: it must be from 0 to 1000000 (millions of " +
                                     "steps) or 0s .. 3333s");
    return static_cast<std::uint64_t>(steps);
}

} // namespace filum::sequence
