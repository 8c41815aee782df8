#include "baselines/kipping2022/kipping2022.hpp"

#include "base/error.hpp"
#include "baselines/kipping2022/ortheo.hpp"
#include "baselines/kipping2022/rings.hpp"
#include "baselines/kipping2022/rows.hpp"
#include "baselines/kipping2022/spiral.hpp"

#include <cmath>
#include <stdexcept>

namespace filum::baselines::kipping2022 {

namespace {

surfpath::plan::Plan run(const surface::Sheet& sheet, const Options& o) {
    using surfpath::Algorithm;
    switch (o.algorithm) {
    case Algorithm::fina:
        return fina(sheet, o);
    case Algorithm::fexa:
        return fexa(sheet, o);
    case Algorithm::ortheo:
        return ortheo(sheet, o);
    case Algorithm::geo_fiso:
        return geo_fiso(sheet, o);
    case Algorithm::geo_contour:
        return geo_contour(sheet, o);
    case Algorithm::geo_spiral:
        return geo_spiral(sheet, o);
    case Algorithm::field:
    case Algorithm::hybrid:
        throw Error(Exit::usage, "the paper of 2022 has no algorithm " + std::string(surfpath::name(o.algorithm)) +
                                     "; surfpath has it");
    }
    throw std::logic_error("no such algorithm");
}

} // namespace

Options settled(Options o) {
    if (!(o.resample > 0)) o.resample = o.spacing / 4;
    if (!(o.iso > 0)) o.iso = o.spacing;
    if (!(o.least_spacing > 0)) o.least_spacing = 0.4 * o.spacing;
    if (!(o.reach > 0)) o.reach = 1.2 * o.spacing;
    if (o.run <= 0) o.run = static_cast<std::int64_t>(std::ceil(o.spacing / o.resample - 1e-9));
    if (o.resample < o.spacing / 1000)
        throw Error(Exit::usage, "--resample must be at least a thousandth of the spacing");
    if (o.window % 2 == 0) throw Error(Exit::usage, "--savgol-window must be odd");
    if (o.window > 1 && o.degree >= o.window)
        throw Error(Exit::usage, "--savgol-degree must be less than --savgol-window");
    return o;
}

surfpath::plan::Plan plan(const surface::Sheet& sheet, const Options& options) {
    const Options o = settled(options);
    if (o.plane && !(norm(o.plane->normal) > 0))
        throw Error(Exit::usage, "the normal of --plane must not be (0, 0, 0); give NX,NY,NZ,D");
    surfpath::plan::Plan out = run(sheet, o);
    if (out.strokes.empty())
        throw Error(Exit::usage, "there is no path: every line is shorter than a step of it; lower --resample");
    const Facts given = {{"", "resample", o.resample, "mm"},
                         {"", "savgol-window", static_cast<double>(o.window), "points"},
                         {"", "savgol-degree", static_cast<double>(o.degree), ""}};
    out.facts.insert(out.facts.end(), given.begin(), given.end());
    return out;
}

} // namespace filum::baselines::kipping2022
