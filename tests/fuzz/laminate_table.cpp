// Any bytes as a table of plies: plies, or refused.
#include "base/error.hpp"
#include "laminate/stack.hpp"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    try {
        const auto plies =
            laminate::plies_of_table({reinterpret_cast<const char*>(data), size}, "fuzz", {}, size % 2 == 1);
        if (plies.empty()) std::abort();
        for (const auto& p : plies)
            if (!std::isfinite(p.angle) || !(p.spacing > 0) || !(p.height > 0)) std::abort();
        laminate::symmetry(plies);
        laminate::through(plies);
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input) std::abort();
    }
    return 0;
}
