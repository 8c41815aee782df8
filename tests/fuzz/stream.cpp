// Any bytes as a stream: read to the end, every frame taken for what it says it is, and shown.
#include "base/error.hpp"
#include "show/text.hpp"
#include "stream/reader.hpp"

#include <sys/mman.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    static const int file = ::memfd_create("input", 0);
    if (::ftruncate(file, 0) != 0 || ::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) return 0;
    try {
        stream::Reader reader("/proc/self/fd/" + std::to_string(file), stream::Payload::unknown);
        show::json(reader.header());
        show::script(reader.header(), true);
        show::Summary summary;
        while (const auto frame = reader.next()) {
            const auto record = show::record(*frame);
            show::text(record, 6);
            show::json(record);
            show::add(summary, *frame, record);
        }
        show::text(summary);
        show::json(summary);
    } catch (const Error&) { // the one way out that is right
    }
    return 0;
}
