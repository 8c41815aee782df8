#include "postproc/options.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"

namespace filum::postproc {

machine::Profile profile_for(const Options& o) {
    auto out = machine::load_profile(o.machine, o.set);
    out.fibre.omit_short = o.short_strokes == Short::drop;
    auto merging = machine::standard_merging();
    if (!o.path_tolerance.empty()) merging.planar = merging.surface = o.path_tolerance.front();
    if (!o.axis_tolerance.empty()) merging.axis = geom::radians(o.axis_tolerance.front());
    machine::merge_moves(out, merging);
    if (o.flatten && out.axes.active())
        throw Error(Exit::usage, "--flatten is for machines that hold the nozzle upright: '" + out.name +
                                     "' leans it; leave it out, or name another machine");
    if (!o.axis_tolerance.empty() && !out.axes.active())
        throw Error(Exit::usage, "--axis-tolerance is for machines with rotary axes: '" + out.name +
                                     "' holds the nozzle upright; leave it out, or name another machine");
    return out;
}

} // namespace filum::postproc
