#include "link3d/options.hpp"

namespace filum::link3d {

Connect connect_named(std::string_view name) {
    return name == "outside" ? Connect::outside : name == "inside" ? Connect::inside : Connect::stop;
}

Strand strand_named(std::string_view name) { return name == "carried" ? Strand::carried : Strand::free; }

Seam seam_named(std::string_view name) { return name == "inside" ? Seam::inside : Seam::nearest; }

Lift lift_named(std::string_view name) {
    return name == "ramp" ? Lift::ramp : name == "helical" ? Lift::helical : Lift::plain;
}

Interlace interlace_named(std::string_view name) {
    return name == "alternate" ? Interlace::alternate
           : name == "golden"  ? Interlace::golden
           : name == "random"  ? Interlace::random
                               : Interlace::none;
}

} // namespace filum::link3d
