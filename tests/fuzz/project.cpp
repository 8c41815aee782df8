// Any bytes as the files of a slicer's project beside its models: bodies, plates and ranges, or not understood.
#include "mesh/project.hpp"
#include "base/error.hpp"
#include "mesh/paint.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        mesh::Project project;
        if (size % 2 == 0)
            mesh::read_prusa_project(text, project);
        else
            mesh::read_bambu_project(text, project);
        for (const auto& [object, ranges] : project.triangles)
            for (const auto& r : ranges)
                if (r.body >= project.bodies.size() || project.of_triangle(object, r.first) > project.bodies.size())
                    if (project.of_triangle(object, r.first) != mesh::Project::kNone) std::abort();
        mesh::each_painted(text.substr(0, 4000), {}, [](auto, const auto&) {});
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input) std::abort();
    }
    return 0;
}
