// Any bytes as a file of a slicer's settings, in lines, JSON, a program or a project: settings, or refused.
#include "app/filum/slicer_file.hpp"
#include "app/filum/slicer_project.hpp"
#include "base/error.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace {

// A file in memory that is read by its name.
const int memory = memfd_create("settings", 0);
const std::string name = "/proc/self/fd/" + std::to_string(memory);

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    if (ftruncate(memory, 0) != 0 || pwrite(memory, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
    try {
        for (const auto& s : app::filum::slicer_file(name).settings)
            if (s.key.empty()) std::abort();
        app::filum::project_bodies(name);
        app::filum::project_codes(name, 1, 0.2);
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input && e.exit() != Exit::truncated) std::abort();
    }
    return 0;
}
