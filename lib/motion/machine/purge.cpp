#include "machine/purge.hpp"

#include "machine/profile.hpp"
#include "machine/reader.hpp"

#include <array>

namespace filum::machine {

void read_purge(Document& doc, const Bed& bed, bool rotary, Purge& p) {
    doc.number("purge.volume", p.volume, {0, 1e6});
    doc.number("purge.speed", p.speed, {1e-6, 1e6});
    std::array<double, 2> place{p.place.x, p.place.y};
    doc.list("purge.place", place, {-1e4, 1e4});
    p.place = {place[0], place[1]};
    doc.number("purge.height", p.height, {0, 1e4});
    doc.text("purge.wait", p.wait);
    doc.text("purge.after", p.after);
    if (p.volume == 0) return;
    if (rotary) doc.fail("purge.volume", "tools are purged on machines with three axes only; use the codes of change");
    const bool within = p.place.x >= bed.x_min && p.place.x <= bed.x_max && p.place.y >= bed.y_min &&
                        p.place.y <= bed.y_max && p.height <= bed.z_max;
    if (!within) doc.fail("purge.place", "it lies outside of bed");
}

} // namespace filum::machine
