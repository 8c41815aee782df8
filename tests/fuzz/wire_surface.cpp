// Any bytes as a surface message: refused, or the same after another trip.
#include "base/error.hpp"
#include "wire/surface.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    const stream::RawFrame raw{stream::Tag::surface, {reinterpret_cast<const char*>(data), size}};
    try {
        const auto once = wire::frame(wire::sheet(raw));
        if (wire::frame(wire::sheet(once)).body != once.body) std::abort();
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input) std::abort();
    }
    return 0;
}
