#include "link3d/options.hpp"

namespace filum::link3d {

Options named(Options o, const Names& names) {
    const auto is = [](const std::string& name, const char* other) { return name == other; };
    o.connect = is(names.connect, "outside")  ? Connect::outside
                : is(names.connect, "inside") ? Connect::inside
                                              : Connect::stop;
    o.strand = is(names.strand, "carried") ? Strand::carried : Strand::free;
    o.seam = is(names.seam, "inside") ? Seam::inside : Seam::nearest;
    o.lift = is(names.lift, "ramp") ? Lift::ramp : is(names.lift, "helical") ? Lift::helical : Lift::plain;
    o.interlace = is(names.interlace, "alternate") ? Interlace::alternate
                  : is(names.interlace, "golden")  ? Interlace::golden
                  : is(names.interlace, "random")  ? Interlace::random
                                                   : Interlace::none;
    return o;
}

} // namespace filum::link3d
