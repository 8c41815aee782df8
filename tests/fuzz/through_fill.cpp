// Regions that are nearly sound, through `fill`: paths that pass their own checks, or refused.
#include "base/error.hpp"
#include "fill/fill.hpp"
#include "fill/hollow/hollow.hpp"
#include "polygon/loops.hpp"
#include "wire/planar.hpp"

#include "message.hpp"

#include <filum/stream.pb.h>

#include <cstdlib>

namespace {

constexpr double kBead = 0.4;    // mm
constexpr double kLargest = 1e4; // squares of a bead: what is larger takes too long here, and nothing else

void rectangle(filum::proto::Loops& to, double x0, double y0, double x1, double y1, bool hole) {
    const double xs[] = {x0, x1, x1, x0}, ys[] = {y0, y0, y1, y1};
    if (to.start_size() == 0) to.add_start(0);
    for (int i = 0; i < 4; ++i) {
        to.add_x(xs[hole ? 3 - i : i]);
        to.add_y(ys[hole ? 3 - i : i]);
    }
    to.add_start(static_cast<std::uint32_t>(to.x_size()));
}

// A plate with a hole, two walls and an area of infill.
filum::proto::Region plate() {
    filum::proto::Region m;
    m.set_z(0.2);
    m.set_height(0.2);
    m.set_area(80);
    rectangle(*m.mutable_loops(), 0, 0, 10, 9, false);
    rectangle(*m.mutable_loops(), 4, 3, 6, 8, true);
    m.set_inradius(2);
    m.set_walls(2);
    auto* area = m.add_areas();
    area->set_kind(static_cast<filum::proto::AreaKind>(1));
    area->set_spacing(2);
    rectangle(*area->mutable_loops(), 1, 1, 9, 2.5, false);
    return m;
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    return filum::fuzz::mutate(data, size, most, seed, plate());
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace filum;
    const stream::RawFrame raw{stream::Tag::region, {reinterpret_cast<const char*>(data), size}};
    try {
        const auto region = wire::region(raw);
        if (polygon::signed_area(region.loops) > kLargest * kBead * kBead) return 0;
        Notes notes;
        fill::Options options;
        options.bead_width = kBead;
        wire::paths(wire::frame(region.walls > 0 ? fill::hollow::fill(region, {.bead_width = kBead}, notes)
                                                 : fill::fill(region, options, notes)));
    } catch (const Error& e) {
        if (e.exit() != Exit::bad_input) std::abort();
    }
    return 0;
}
