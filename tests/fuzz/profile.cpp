// Any text as a machine profile: a profile or an Error, never anything else.
#include "machine/profile.hpp"
#include "base/error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // the first byte says how much of the rest is `--set`
    const std::size_t cut = size == 0 ? 0 : 1 + std::min<std::size_t>(data[0] % 64, size - 1);
    const auto* text = reinterpret_cast<const char*>(data);
    const std::string set(text + (size == 0 ? 0 : 1), cut == 0 ? 0 : cut - 1);
    try {
        const auto profile = filum::machine::parse_profile({text + cut, size - cut}, "fuzz.toml", set);
        if (!(profile.bed.x_min < profile.bed.x_max) || !(profile.extrusion.per_mm3() > 0)) std::abort();
        if (const auto& fibre = profile.fibre; fibre.active()) {
            const double length = fibre.cut_to_nozzle + 100;
            const auto parts = filum::machine::stretches(fibre, length);
            if (parts.empty() || parts.front().from != 0 || parts.back().to != length) std::abort();
            if (parts.back().before != filum::machine::Event::cut) std::abort();
        }
    } catch (const filum::Error& e) {
        if (e.exit() != filum::Exit::bad_input && e.exit() != filum::Exit::usage) std::abort();
    }
    return 0;
}
