#include "app/metrics/parts.hpp"

#include "cli/output.hpp"
#include "figures/records.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

namespace filum::app::metrics {

namespace {

// Refuses options that have a meaning for layers only.  Throws Error(usage).
void refuse(const filum::metrics::planar::Options& o) {
    for (const auto& [name, given] : {std::pair{"--regions", !o.regions.empty()},
                                      {"--per-region", !o.per_region.empty()},
                                      {"--per-layer", !o.per_layer.empty()},
                                      {"--pores", o.pores}})
        if (given)
            throw Error(Exit::usage,
                        "cannot use '" + std::string(name) + "' with --surface: it tells of layers; leave one out");
}

} // namespace

filum::figures::Figures curved(const Options& options, const cli::Io& io) {
    refuse(options.plane);
    surface::Sheet sheet;
    std::size_t surfaces = 0;
    const auto ground = cli::read_all(options.surface, stream::Payload::surface, [&](const stream::RawFrame& f) {
        sheet = wire::sheet(f);
        ++surfaces;
    });
    if (surfaces != 1)
        throw Error(Exit::bad_input, "cannot measure on '" + options.surface + "': it holds " +
                                         std::to_string(surfaces) + " surfaces, not one");
    filum::metrics::surface::Fibres fibres;
    const auto path = cli::read_all(io.input, stream::Payload::toolpath, [&](const stream::RawFrame& f) {
        filum::metrics::surface::add(fibres, wire::span(f));
    });
    auto found = filum::metrics::surface::measure(fibres, sheet, options.curved, !options.voids.empty(), io.threads);
    if (!options.voids.empty()) {
        if (!found.distance) throw Error(Exit::failure, "cannot write '" + options.voids + "': no path is laid");
        auto header = cli::header(io, stream::Payload::surface, {&ground.header, &path.header});
        header.expected = 1;
        cli::Io there = io;
        there.output = options.voids;
        cli::Output voids(there, header);
        voids.write(wire::frame(*found.distance));
        voids.close();
    }
    if (!options.map.empty()) {
        auto more = mapped(options, io, sheet, ground, fibres, path);
        found.figures.insert(found.figures.end(), more.begin(), more.end());
    }
    filum::figures::add_records(path.notes, path.facts, found.figures);
    return std::move(found.figures);
}

} // namespace filum::app::metrics
