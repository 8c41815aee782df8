// Any bytes as a program, in text, binary G-code or a project: a toolpath that holds what its counts say, or an Error.
#include "base/error.hpp"
#include "ingest/container.hpp"
#include "ingest/reader.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    std::string kept;
    Notes notes;
    double volume = 0;
    try {
        const auto text = ingest::program_in(bytes, "fuzz", 0, kept, notes);
        ingest::Options options;
        options.start_code = size % 2 == 1;
        const auto found = ingest::read(text, "fuzz", {}, options, [&](const toolpath::Span& span) {
            if (span.points.size() < 2) std::abort();
            for (std::size_t i = 0; i + 1 < span.points.size(); ++i) volume += toolpath::volume(span, i);
        });
        if (!(std::abs(volume - found.counts.volume) <= 1e-6 * found.counts.volume + 1e-9)) std::abort();
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input && e.exit() != Exit::truncated) std::abort();
    }
    return 0;
}
