#include "wire/planar.hpp"
#include "app/metrics/parts.hpp"
#include "metrics/planar/pace.hpp"

namespace filum::app::metrics {

namespace {

std::vector<polygon::Region> outlines(const std::string& file) {
    std::vector<polygon::Region> out;
    if (!file.empty())
        cli::read_all(file, stream::Payload::regions,
                      [&](const stream::RawFrame& f) { out.push_back(wire::region(f)); });
    return out;
}

} // namespace

filum::figures::Figures planar(const filum::metrics::planar::Options& given, const cli::Io& io) {
    filum::metrics::planar::Options options = given;
    const auto profile = machine::load_profile(options.machine, options.set);
    if (profile.extrusion.feeding == machine::Feeding::filament) options.filament_diameter = profile.extrusion.diameter;
    if (profile.extrusion.density > 0) options.density = profile.extrusion.density;
    options.fibre_density = profile.fibre.density;
    if (options.pores && options.regions.empty())
        throw Error(Exit::usage, "cannot measure pores without outlines; name them by --regions");
    const auto regions = outlines(options.regions);
    filum::metrics::planar::Input input;
    filum::metrics::planar::Beads beads;
    beads.marks = filum::metrics::planar::layer_marks(regions);
    beads.layers = filum::metrics::planar::high_regions(regions);
    stream::Reader reader(io.input, stream::Payload::unknown);
    const auto payload = reader.header().payload;
    if (payload != stream::Payload::toolpath && payload != stream::Payload::paths)
        throw Error(Exit::bad_input, "cannot measure " + reader.name() + ": it carries " +
                                         std::string(stream::name(payload)) + ", not Toolpath or Paths");
    const auto& history = reader.header().history;
    const bool from_program = !history.empty() && history.back().program == "ingest";
    filum::metrics::planar::Pace pace(profile, from_program);
    input.whole_program = payload == stream::Payload::toolpath;
    bool level = true; // all beads are flat, none lies on a curved surface
    while (auto f = reader.next()) {
        if (f->tag == stream::Tag::note) input.notes.push_back(stream::parse_note(f->body));
        if (f->tag == stream::Tag::fact) input.facts.push_back(stream::parse_fact(f->body));
        if (f->tag == stream::Tag::paths) {
            const auto paths = wire::paths(*f);
            input.claimed_unplaced += paths.unplaced;
            filum::metrics::planar::add(beads, paths);
        } else if (f->tag == stream::Tag::span) {
            const auto span = wire::span(*f);
            if (!span.normals.empty()) level = false;
            filum::metrics::planar::add(beads, span);
            filum::metrics::planar::follow(input.statistics, span);
            pace.add(span);
        }
    }
    input.seconds = pace.seconds();
    if (!pace.why().empty())
        input.notes.push_back({.code = NoteCode::time_unknown, .detail = pace.why(), .stage = io.program});
    input.tools = pace.tools();
    filum::metrics::planar::check_pixel(beads, regions, options.pixel);
    const auto layers = filum::metrics::planar::measure_layers(beads, regions, options.pixel, io.threads);
    if (level) input.air = filum::metrics::planar::measure_air(beads, options.pixel, io.threads);
    if (options.pores) input.pores = filum::metrics::planar::measure_pores(beads, regions, layers, io.threads);
    auto measured = filum::metrics::planar::report(input, beads, regions, layers, options, io.threads);
    if (!options.per_region.empty()) cli::write_text(options.per_region, filum::metrics::planar::region_table(layers));
    if (!options.per_layer.empty())
        cli::write_text(options.per_layer, filum::metrics::planar::layer_table(layers, input.pores));
    if (input.pores && !options.per_pore.empty())
        cli::write_text(options.per_pore, filum::metrics::planar::pore_table(*input.pores));
    return measured;
}

} // namespace filum::app::metrics
