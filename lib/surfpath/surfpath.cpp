#include "surfpath/surfpath.hpp"

#include "base/error.hpp"
#include "surfpath/fexa.hpp"
#include "surfpath/fina.hpp"
#include "surfpath/geo_contour.hpp"
#include "surfpath/geo_fiso.hpp"
#include "surfpath/geo_spiral.hpp"
#include "surfpath/ortheo.hpp"

namespace filum::surfpath {

Plan plan(const surface::Sheet& sheet, const Options& options) {
    if (options.algorithm == "fexa") return fexa(sheet, options);
    if (options.algorithm == "geo-spiral") return geo_spiral(sheet, options);
    if (options.algorithm == "fina") return fina(sheet, options);
    if (options.algorithm == "geo-contour") return geo_contour(sheet, options);
    if (options.algorithm == "geo-fiso") return geo_fiso(sheet, options);
    if (options.algorithm == "ortheo") return ortheo(sheet, options);
    throw Error(Exit::usage, "cannot plan by '" + options.algorithm + "' yet");
}

} // namespace filum::surfpath
