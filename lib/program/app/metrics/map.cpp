#include "app/metrics/parts.hpp"

#include "cli/output.hpp"
#include "geom/angle.hpp"
#include "metrics/surface/load.hpp"
#include "metrics/surface/map_figures.hpp"
#include "metrics/surface/map_sheet.hpp"
#include "render/vtp.hpp"
#include "stream/frame.hpp"
#include "surface/curve/transfer.hpp"
#include "wire/surface.hpp"

#include <algorithm>

namespace filum::app::metrics {

namespace {

using filum::metrics::surface::Bed;
using filum::metrics::surface::RequestedDirection;

const double* fact(const Facts& facts, const std::string& name) {
    const auto it = std::find_if(facts.begin(), facts.end(),
                                 [&](const Fact& f) { return f.stage == "laminate" && f.name == name; });
    return it == facts.end() ? nullptr : &it->value;
}

const surface::Field* field(const surface::Sheet& sheet, const std::string& name, std::uint32_t components) {
    for (const auto& f : sheet.fields)
        if (f.name == name && f.components == components) return &f;
    return nullptr;
}

// The requested direction of ply k, counted from 0.
RequestedDirection requested_direction(const surface::Sheet& sheet, const Facts& facts, std::size_t k) {
    const double* angle = fact(facts, "ply." + std::to_string(k + 1) + ".asked");
    const double *x = fact(facts, "reference-x"), *y = fact(facts, "reference-y"), *z = fact(facts, "reference-z");
    if (angle != nullptr && x != nullptr && y != nullptr && z != nullptr)
        return {{*x, *y, *z}, geom::radians(*angle), nullptr};
    if (const auto* given = field(sheet, "direction", 3)) return {{}, 0, given};
    const auto cases = filum::metrics::surface::load_cases(sheet);
    return {{}, 0, cases.empty() ? nullptr : cases.front().d1};
}

// The surface with triangles whose sides are about `width` (a bead's width, mm) long, with the fields that the map
// needs.
surface::Sheet finer(const surface::Sheet& given, double width) {
    surface::Sheet out{surface::finer(given.surface, width).surface, {}, {}};
    std::vector<surface::Field> kept;
    std::copy_if(given.fields.begin(), given.fields.end(), std::back_inserter(kept), [](const surface::Field& f) {
        return f.name == "direction" || f.name.ends_with(".edge") || f.name.ends_with(".d1");
    });
    out.fields = surface::curve::transferred(given.surface, kept, out.surface);
    out.name = given.name;
    return out;
}

// Writes the map of `base`. Streams have fewer points where all of them would not fit.
void write(const std::string& file, const cli::Io& io, const cli::WholeInput& ground, const cli::WholeInput& path,
           const surface::Surface& base, surface::Sheet map) {
    if (file.ends_with(".vtp")) {
        render::Scene scene;
        scene.sheet = std::move(map);
        cli::write_text(file, render::vtp(scene));
        return;
    }
    auto header = cli::header(io, stream::Payload::surface, {&ground.header, &path.header});
    header.expected = 1;
    cli::Io there = io;
    there.output = file;
    cli::Output out(there, header);
    out.write(wire::frame(filum::metrics::surface::within_size(std::move(map), base, stream::kMaxFrame)));
    out.close();
}

} // namespace

filum::figures::Figures mapped(const Options& options, const cli::Io& io, const surface::Sheet& given,
                               const cli::WholeInput& ground, const filum::metrics::surface::Fibres& fibres,
                               const cli::WholeInput& path) {
    if (fibres.all.empty()) throw Error(Exit::failure, "cannot write '" + options.map + "': no path is laid");
    const double width = filum::metrics::surface::median_width(fibres);
    const surface::Sheet sheet = finer(given, width);
    auto beds = filum::metrics::surface::beds(sheet.surface, fibres, io.threads);
    for (std::size_t k = 0; k < beds.size(); ++k) {
        beds[k].asked = requested_direction(sheet, path.facts, k);
        if (const auto* edge = field(sheet, "ply-" + std::to_string(k + 1) + ".edge", 1)) beds[k].edge = edge->values;
    }
    const auto map = filum::metrics::surface::map(sheet.surface, fibres, beds, io.threads);
    write(options.map, io, ground, path, given.surface, filum::metrics::surface::sheet_of(map, sheet.name));
    return filum::metrics::surface::map_figures(map);
}

} // namespace filum::app::metrics
