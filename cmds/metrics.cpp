// metrics - measures a toolpath, or the curves of a fill
// reads:  Toolpath or Paths
// writes: text
// memory: the toolpath at 20 bytes per segment, and the outlines
#include "base/number.hpp"
#include "cli/command.hpp"
#include "metrics/layers.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

struct Options {
    std::string regions;
    std::string per_region;
    double pixel = 0;
};

cli::Spec spec(Options& o) {
    return {
        .name = "metrics",
        .synopsis = "measure a toolpath, or the curves of a fill",
        .description = "Measures.",
        .in = cli::reads(stream::Payload::unknown),
        .out = cli::text("a table"),
        .memory = "the toolpath at 20 bytes per segment, and the outlines",
        .options = {cli::Option{"regions", &o.regions, "FILE", "the Regions that should be filled"}.not_a_setting(),
                    cli::Option{"per-region", &o.per_region, "FILE", "also write a line per region to this file"}
                        .not_a_setting(),
                    cli::Option{"pixel", &o.pixel, "MM",
                                "spacing of the rows that areas are swept by, 0 for a sixteenth of the bead width"}
                        .at_least(0)},
        .examples = {
            {"slice part.stl | regions > part.regions; sequence part.regions | fill | metrics --regions part.regions",
             "how well the fill fills"}}};
}

std::string region_line(const metrics::RegionFigures& r) {
    const double a = r.cover.area > 0 ? r.cover.area : 1;
    std::string out = std::to_string(r.layer) + "\t" + std::to_string(r.region) + "\t" + std::to_string(r.curves) +
                      "\t" + std::to_string(r.segments);
    for (const double v : {r.length, r.cover.area, metrics::coverage(r.cover), r.cover.outside() / a,
                           r.cover.overfill() / a, r.cover.unplaced()})
        out += "\t" + fixed_text(v, 4);
    return out + "\t" + std::to_string(r.crossings) + "\t" + fixed_text(r.at.x, 3) + "," + fixed_text(r.at.y, 3) + "\n";
}

void run(const Options& options, const cli::Io& io) {
    std::vector<polygon::Region> regions;
    if (!options.regions.empty())
        cli::read_all(options.regions, stream::Payload::regions,
                      [&](const stream::RawFrame& f) { regions.push_back(wire::region(f)); });
    metrics::Beads beads;
    beads.marks = metrics::layer_marks(regions);
    stream::Reader reader(io.input, stream::Payload::unknown);
    const bool paths = reader.header().payload == stream::Payload::paths;
    if (!paths && reader.header().payload != stream::Payload::toolpath)
        throw Error(Exit::bad_input, "cannot measure " + reader.name() + ": it carries " +
                                         std::string(stream::name(reader.header().payload)) +
                                         ", not Toolpath or Paths");
    while (auto f = reader.next()) {
        if (f->tag == stream::Tag::note) continue;
        if (paths)
            metrics::add(beads, wire::paths(*f));
        else
            metrics::add(beads, wire::span(*f));
    }
    const auto layers = metrics::measure_layers(beads, regions, options.pixel, io.threads);
    metrics::Cover all;
    std::size_t crossings = 0, count = 0, one = 0;
    std::vector<double> share;
    double worst = 2, worst_layer = 2;
    const metrics::RegionFigures* worst_region = nullptr;
    std::uint32_t worst_index = 0;
    std::string table = "layer\tregion\tcurves\tsegments\tlength_mm\tarea_mm2\tcoverage\toutside\toverfill\tunplaced_"
                        "mm2\tcrossings\tat\n";
    for (const auto& l : layers) {
        all.area += l.cover.area, all.covered += l.cover.covered, all.united += l.cover.united,
            all.deposited += l.cover.deposited;
        crossings += l.crossings;
        if (l.cover.area > 1 && coverage(l.cover) < worst_layer) worst_layer = coverage(l.cover), worst_index = l.layer;
        for (const auto& r : l.regions) {
            table += region_line(r);
            if (!r.known) continue;
            ++count, one += r.curves == 1 ? 1 : 0;
            share.push_back(coverage(r.cover));
            if (share.back() < worst) worst = share.back(), worst_region = &r;
        }
    }
    std::sort(share.begin(), share.end());
    double mean = 0;
    for (const double s : share) mean += s / static_cast<double>(share.size());
    std::string text;
    const auto line = [&](const char* name, const std::string& value) {
        text += std::string(name) + "\t" + value + "\n";
    };
    line("regions", std::to_string(count));
    line("regions with one curve", std::to_string(one));
    line("crossings", std::to_string(crossings));
    const double a = all.area > 0 ? all.area : 1;
    line("area mm2", fixed_text(all.area, 3));
    line("coverage", fixed_text(coverage(all), 5));
    line("outside", fixed_text(all.outside() / a, 5));
    line("overfill", fixed_text(all.overfill() / a, 5));
    line("unplaced mm2", fixed_text(all.unplaced(), 3));
    if (!share.empty()) {
        line("coverage of regions, mean", fixed_text(mean, 5));
        line("coverage of regions, p5", fixed_text(share[share.size() / 20], 5));
        const auto above = [&](double v) {
            return std::to_string(share.end() - std::lower_bound(share.begin(), share.end(), v));
        };
        line("regions covered >= 0.98", above(0.98));
        line("regions covered >= 0.99", above(0.99));
        line("worst region", std::to_string(worst_region->region) + " on layer " + std::to_string(worst_region->layer) +
                                 ": " + fixed_text(worst, 5));
    }
    if (worst_layer < 2) line("worst layer", std::to_string(worst_index) + ": " + fixed_text(worst_layer, 5));
    stream::Sink out(io.output, stream::Sink::Content::text);
    out.write(text);
    if (!options.per_region.empty()) {
        stream::Sink file(options.per_region, stream::Sink::Content::text);
        file.write(table);
        file.commit();
    }
    out.commit();
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
