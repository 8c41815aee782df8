// Spans that are nearly sound, through what `metrics` measures of them.
#include "base/error.hpp"
#include "metrics/planar/air.hpp"
#include "metrics/planar/layers.hpp"
#include "metrics/planar/report.hpp"
#include "wire/planar.hpp"

#include "message.hpp"

#include <filum/stream.pb.h>

#include <cstdlib>

namespace {

filum::proto::Span zigzag() {
    filum::proto::Span m;
    for (int i = 0; i < 8; ++i) {
        m.add_x(i / 2 % 2 == 0 ? (i % 2) * 5.0 : 5.0 - (i % 2) * 5.0);
        m.add_y(0.4 * (i / 2));
        m.add_z(0.2);
        m.add_width(0.4);
    }
    m.add_height(0.2);
    return m;
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    return filum::fuzz::mutate(data, size, most, seed, zigzag());
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    namespace planar = metrics::planar;
    const stream::RawFrame raw{stream::Tag::span, {reinterpret_cast<const char*>(data), size}};
    try {
        auto span = wire::span(raw);
        planar::Beads beads;
        planar::Input input;
        for (int k = 0; k < 2; ++k) {
            planar::add(beads, span);
            planar::follow(input.statistics, span);
            ++span.layer;
        }
        const auto layers = planar::measure_layers(beads, {}, 0, 1);
        input.air = planar::measure_air(beads, 0, 1);
        planar::report(input, beads, {}, layers, {}, 1);
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input) std::abort();
    }
    return 0;
}
