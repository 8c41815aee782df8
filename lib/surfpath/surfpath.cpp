#include "surfpath/surfpath.hpp"

#include "base/error.hpp"
#include "surfpath/bare.hpp"
#include "surfpath/fexa.hpp"
#include "surfpath/fina.hpp"
#include "surfpath/geo_contour.hpp"
#include "surfpath/geo_fiso.hpp"
#include "surfpath/geo_spiral.hpp"
#include "surfpath/ortheo.hpp"

namespace filum::surfpath {

namespace {

Plan lines(const surface::Sheet& sheet, const Options& options) {
    if (options.algorithm == "fexa") return fexa(sheet, options);
    if (options.algorithm == "geo-spiral") return geo_spiral(sheet, options);
    if (options.algorithm == "fina") return fina(sheet, options);
    if (options.algorithm == "geo-contour") return geo_contour(sheet, options);
    if (options.algorithm == "geo-fiso") return geo_fiso(sheet, options);
    if (options.algorithm == "ortheo") return ortheo(sheet, options);
    throw Error(Exit::usage, "unknown algorithm '" + options.algorithm + "'");
}

} // namespace

Plan plan(const surface::Sheet& sheet, const Options& options) {
    Plan out = lines(sheet, options);
    tell_bare(sheet.surface, out, options.spacing);
    return out;
}

} // namespace filum::surfpath
