// Layers that are nearly sound, through `regions`: regions that pass their own checks, or refused.
#include "base/error.hpp"
#include "polygon/loops.hpp"
#include "regions/regions.hpp"
#include "wire/planar.hpp"

#include "message.hpp"

#include <filum/stream.pb.h>

#include <cstdlib>

namespace {

filum::proto::Layer ring() {
    filum::proto::Layer m;
    m.set_z(0.2);
    m.set_height(0.2);
    m.set_plane(0.1);
    auto& to = *m.mutable_contours();
    to.add_start(0);
    for (const double side : {5.0, -2.0}) {
        const double xs[] = {-side, side, side, -side}, ys[] = {-5, -5, 5, 5};
        for (int i = 0; i < 4; ++i) {
            to.add_x(xs[i]);
            to.add_y(side < 0 ? ys[i] / 2 : ys[i]);
        }
        to.add_start(static_cast<std::uint32_t>(to.x_size()));
    }
    return m;
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    return filum::fuzz::mutate(data, size, most, seed, ring());
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    const stream::RawFrame raw{stream::Tag::layer, {reinterpret_cast<const char*>(data), size}};
    try {
        Notes notes;
        const auto layer = wire::layer(raw);
        auto made = regions::regions(layer, {}, notes);
        regions::Air air;
        regions::lay_on(made, {false, made}, {}, air);
        for (const auto& region : made) wire::region(wire::frame(region));
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input) std::abort();
    }
    return 0;
}
