// metrics - measures a finished toolpath, or the curves of a fill
// reads:  Toolpath or Paths
// writes: text
// memory: the toolpath at 20 bytes per segment, and the outlines
#include "cli/command.hpp"
#include "metrics/pace.hpp"
#include "metrics/report.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

constexpr const char* kDescription =
    "Counts and measures what a toolpath is, from its moves alone: strokes, stops, breaks and joins, lengths, print "
    "time and material, crossings, bead widths and directions, sharp turns, how far apart neighbouring layers begin. "
    "With --regions also what it fills: coverage, what lies outside, what is laid where there is material already, the "
    "worst layer and region. No stage's own claim is used, but what the stages before said they dropped or repaired is "
    "listed at the end. The output of fill can be measured, too: each curve counts as printed by itself.\n\n"
    "A stop is a way of more than 0.05 mm in XY without extruding; a stroke ends at a stop, or where the nozzle rises "
    "by more than two layers without extruding. A bead is a straight stretch with round ends, as wide as its "
    "cross-section divided by the height of the layer that its z falls into. Shares are of the outlines' area: "
    "coverage is what lies under beads, outside are beads over no outline (connectors, too), overfill is the sum of "
    "length times width less the area under beads. Crossings are pairs of moves of one layer that properly cross and "
    "do not follow each other.\n\n"
    "Sharp turns follow the authors of the Connected Fermat Spirals: the path cuts a disc of one bead width's radius "
    "in two, and the turn is sharp where the smaller part is below 0.3 of the disc. Areas are swept by rows with exact "
    "ends: their spacing shows in the fourth digit or so. The print time is by trapezoidal speeds with look-ahead.\n\n"
    "--pores is for scaffolds: porosity by extruded volume, by covered area, and 1 - width / spacing of an endless "
    "lattice; strands and their spacing; pore size, the largest circle in each window of a layer and the ones that "
    "cross it; and throats, the largest balls that fall straight through, or roll between two strands.";

cli::Spec spec(metrics::Options& o) {
    using cli::Option;
    return {
        .name = "metrics",
        .synopsis = "measure a finished toolpath, or the curves of a fill",
        .description = kDescription,
        .in = cli::reads(stream::Payload::unknown),
        .out = cli::text("a table, TSV or JSON"),
        .memory = "the toolpath at 20 bytes per segment, and the outlines",
        .options =
            {Option{"regions", &o.regions, "FILE", "the Regions stream that should be filled"}.not_a_setting(),
             Option{"format", &o.format, "", "how to write the figures"}.one_of({"table", "tsv", "json"}),
             Option{"per-region", &o.per_region, "FILE", "also a line per region, as TSV"}.not_a_setting(),
             Option{"per-layer", &o.per_layer, "FILE", "also a line per layer, as TSV"}.not_a_setting(),
             {"pores", &o.pores, "", "measure the pores of a scaffold, too; needs --regions"},
             Option{"pixel", &o.pixel, "MM", "spacing of the rows; 0: a sixteenth of the bead width"}.at_least(0),
             Option{"turn-samples", &o.turn_samples, "N", "places tested for sharp turns"}.at_least(1).at_most(1e8),
             Option{"machine", &o.machine, "NAME|FILE", "machine profile of the print time"}.not_a_setting(),
             {"set", &o.set, "KEY=VALUE,...", "change keys of the profile, as feeds.bead=40"},
             Option{"density", &o.density, "G/CM3", "density of the material"}.above(0)},
        .examples =
            {{"slice part.stl | regions > part.regions; sequence part.regions | fill | link3d | metrics --regions "
              "part.regions",
              "all figures of a part"},
             {"slice part.stl | regions > part.regions; sequence part.regions | fill | metrics --regions part.regions "
              "--per-region part.tsv --format json",
              "how well the fill fills, region by region"}},
        .see_also = {"fill", "link3d", "render"}};
}

std::vector<polygon::Region> outlines(const std::string& file) {
    std::vector<polygon::Region> out;
    if (!file.empty())
        cli::read_all(file, stream::Payload::regions,
                      [&](const stream::RawFrame& f) { out.push_back(wire::region(f)); });
    return out;
}

void write(const std::string& file, const std::string& text) {
    stream::Sink out(file, stream::Sink::Content::text);
    out.write(text);
    out.commit();
}

void run(const metrics::Options& given, const cli::Io& io) {
    metrics::Options options = given;
    const auto profile = machine::load_profile(options.machine, options.set);
    if (profile.extrusion.feeding == machine::Feeding::filament) options.filament_diameter = profile.extrusion.diameter;
    if (options.pores && options.regions.empty())
        throw Error(Exit::usage, "cannot measure pores without outlines; name them by --regions");
    const auto regions = outlines(options.regions);
    metrics::Input input;
    metrics::Beads beads;
    beads.marks = metrics::layer_marks(regions);
    stream::Reader reader(io.input, stream::Payload::unknown);
    const auto payload = reader.header().payload;
    if (payload != stream::Payload::toolpath && payload != stream::Payload::paths)
        throw Error(Exit::bad_input, "cannot measure " + reader.name() + ": it carries " +
                                         std::string(stream::name(payload)) + ", not Toolpath or Paths");
    metrics::Pace pace(profile);
    input.whole_program = payload == stream::Payload::toolpath;
    while (auto f = reader.next()) {
        if (f->tag == stream::Tag::note) input.notes.push_back(stream::parse_note(f->body));
        if (f->tag == stream::Tag::fact) input.facts.push_back(stream::parse_fact(f->body));
        if (f->tag == stream::Tag::paths) {
            const auto paths = wire::paths(*f);
            input.claimed_unplaced += paths.unplaced;
            metrics::add(beads, paths);
        } else if (f->tag == stream::Tag::span) {
            const auto span = wire::span(*f);
            metrics::add(beads, span);
            metrics::follow(input.course, span);
            pace.add(span);
        }
    }
    input.seconds = pace.seconds();
    const auto layers = metrics::measure_layers(beads, regions, options.pixel, io.threads);
    if (options.pores) input.pores = metrics::measure_pores(beads, regions, layers, io.threads);
    const auto measured = metrics::report(input, beads, regions, layers, options, io.threads);
    if (!options.per_region.empty()) write(options.per_region, metrics::region_table(layers));
    if (!options.per_layer.empty()) write(options.per_layer, metrics::layer_table(layers, input.pores));
    write(io.output, figures::text(measured, figures::format_named(options.format)));
}

} // namespace

int main(int argc, char** argv) { return cli::main<metrics::Options>(argc, argv, spec, run); }
