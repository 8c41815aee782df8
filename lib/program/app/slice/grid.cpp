#include "app/slice/grid.hpp"

#include "app/slice/sizes.hpp"
#include "base/error.hpp"
#include "plate/grid.hpp"

namespace filum::app::slice {

namespace {

plate::Grid grid_of(const Options& o) {
    if (o.wells != 0 && !o.grid.empty())
        throw Error(Exit::usage, "cannot use --wells and --grid together: a plate of wells is a grid; leave one out");
    if (o.wells == 0) return plate::parse_grid(o.grid, o.pitch);
    if (!o.pitch.empty()) throw Error(Exit::usage, "cannot use --pitch with --wells: a plate has its own");
    return plate::well_plate(o.wells);
}

} // namespace

std::vector<cli::Option> plate_options(Options& o) {
    using cli::Option;
    return {
        Option{"machine", &o.machine, "NAME|FILE",
               "machine profile; a part larger than its bed is refused, and several parts are placed on its bed "
               "(default: marlin's)"}
            .not_a_setting(),
        Option{"set", &o.set, "KEY=VALUE,...", "changes keys of the profile, such as bed.x=[0,300]"}.not_a_setting(),
        Option{
            "body", &o.body, "FILE:tool=N",
            "a body of the part that another tool prints, as core.stl:tool=1 or core.stl:tool=1,width=0.6,height=0.4; "
            "several times for several; later ones are cut from earlier ones"}
            .repeated()
            .not_a_setting(),
        Option{"plate", &o.plate, "N", "plate of a slicer's project, counted from 1"}.within(1, 1000),
        Option{"copies", &o.copies, "N", "number of copies of each part"}.within(1, 10000),
        Option{"wells", &o.wells, "N",
               "make the part in each well of a plate of 6, 12, 24, 48 or 96 wells, whose middle is that of the bed, "
               "or --center; postproc --wall-height keeps travels above the walls"}
            .within(0, 96),
        Option{"grid", &o.grid, "CxR", "make the part in each place of a grid: columns x rows, as 4x3"},
        Option{"pitch", &o.pitch, "MM|X,Y", "from place to place of the grid"}.within(0.1, 1e4).when("grid/wells"),
        Option{"in-wells", &o.in_wells, "A1,B3",
               "only in these places: rows are letters from the back, columns numbers"}
            .when("grid/wells"),
        Option{"apart", &o.apart, "MM", "distance between several parts; default: as the head needs"}
            .numbers(1)
            .within(0.1, 1000)
            .a_limit(),
    };
}

std::size_t copies(const Options& o, std::size_t inputs) {
    if (!in_grid(o)) return static_cast<std::size_t>(o.copies);
    if (o.copies > 1)
        throw Error(Exit::usage,
                    "cannot use --copies in a grid: the part is made in each place; name some by --in-wells");
    const plate::Grid grid = grid_of(o);
    const std::size_t places = plate::wells_named(grid, o.in_wells).size();
    if (inputs != 1 && inputs != places)
        throw Error(Exit::usage, "cannot put " + std::to_string(inputs) + " parts into " + std::to_string(places) +
                                     " places: give one part for all, or as many parts as places");
    return inputs == 1 ? places : 1;
}

std::vector<plate::Place> in_places(const std::vector<BedPart>& parts, const Options& o,
                                    std::vector<std::string>& names) {
    const plate::Grid grid = grid_of(o);
    const auto where = plate::wells_named(grid, o.in_wells);
    std::vector<plate::Place> out;
    for (const BedPart& part : parts) {
        const geom::Vec3 size = part.box.hi - part.box.lo;
        if ((grid.columns > 1 && size.x > grid.pitch.x) || (grid.rows > 1 && size.y > grid.pitch.y))
            throw Error(Exit::bad_input, "cannot place '" + part.name + "': it is " + size_text(size.xy()) +
                                             ", and the places are " + size_text(grid.pitch) +
                                             " apart; scale the part, or give a larger --pitch");
        for (std::size_t k = 0; k < part.at.size(); ++k) {
            const Vec2 box = 0.5 * (part.box.lo.xy() + part.box.hi.xy());
            names[out.size()] = part.name + "_" + plate::well_name(grid, where[out.size()]);
            out.push_back({plate::middle(grid, where[out.size()]) - box, 0});
        }
    }
    return out;
}

} // namespace filum::app::slice
