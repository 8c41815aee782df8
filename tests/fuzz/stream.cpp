// Any bytes as a stream: read to the end, every frame taken for what it says it is, and shown.
#include "app/peek/text.hpp"
#include "base/error.hpp"
#include "stream/reader.hpp"

#include <sys/mman.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    static const int file = ::memfd_create("input", 0);
    if (::ftruncate(file, 0) != 0 || ::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) return 0;
    try {
        stream::Reader reader("/proc/self/fd/" + std::to_string(file), stream::Payload::unknown);
        app::peek::json(reader.header());
        app::peek::script(reader.header(), true);
        app::peek::Summary summary;
        while (const auto frame = reader.next()) {
            const auto record = app::peek::record(*frame);
            app::peek::text(record, 6);
            app::peek::json(record);
            app::peek::add(summary, *frame, record);
        }
        app::peek::text(summary);
        app::peek::json(summary);
    } catch (const Error&) { // the one way out that is right
    }
    return 0;
}
