// Paths that are nearly sound, through `link3d`: spans that pass their own checks, or refused.
#include "base/error.hpp"
#include "link3d/linker.hpp"
#include "wire/planar.hpp"

#include "message.hpp"

#include <filum/stream.pb.h>

#include <cstdlib>

namespace {

// A spiral of straight beads, closed.
filum::proto::RegionPaths spiral() {
    filum::proto::RegionPaths m;
    m.set_z(0.2);
    m.set_height(0.2);
    m.set_area(16);
    auto* c = m.add_curves();
    c->set_closed(true);
    for (const auto& [x, y] : {std::pair{0.2, 0.2},
                               {3.8, 0.2},
                               {3.8, 3.8},
                               {0.2, 3.8},
                               {0.2, 1.0},
                               {3.0, 1.0},
                               {3.0, 3.0},
                               {1.0, 3.0},
                               {1.0, 1.8},
                               {0.6, 1.8}}) {
        c->add_x(x);
        c->add_y(y);
    }
    c->add_width(0.4);
    return m;
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    return filum::fuzz::mutate(data, size, most, seed, spiral());
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    const stream::RawFrame raw{stream::Tag::paths, {reinterpret_cast<const char*>(data), size}};
    try {
        const auto first = wire::paths(raw);
        auto second = first; // on the next layer, to be climbed to
        second.layer = first.layer + 1;
        second.z = first.z + first.height;
        second.join = Join::vertical;
        Notes notes;
        link3d::Linker linker{link3d::Options{}};
        const auto emit = [](const toolpath::Span& span) { wire::span(wire::frame(span)); };
        linker.add(first, emit, notes);
        linker.add(second, emit, notes);
        linker.finish(emit, notes);
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input) std::abort();
    }
    return 0;
}
