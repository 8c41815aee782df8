// Any bytes as lines of points on a surface: lines of finite points, or refused.
#include "base/error.hpp"
#include "geodesic/lines.hpp"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    try {
        for (const auto& line : geodesic::read_lines({reinterpret_cast<const char*>(data), size}, "fuzz")) {
            if (line.empty()) std::abort();
            for (const auto& p : line)
                if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) std::abort();
        }
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input && e.exit() != Exit::truncated) std::abort();
    }
    return 0;
}
