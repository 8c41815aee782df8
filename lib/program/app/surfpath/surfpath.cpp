#include "app/surfpath/surfpath.hpp"

#include "base/density.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "cli/progress.hpp"
#include "geom/angle.hpp"
#include "machine/profile.hpp"
#include "parallel/parallel.hpp"
#include "surfpath/outside.hpp"
#include "surfpath/plan/least_strokes.hpp"
#include "surfpath/rings/reach.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <algorithm>
#include <mutex>
#include <optional>

namespace filum::app::surfpath {

namespace {

using filum::surfpath::Algorithm;
using geom::Vec3;

using filum::surfpath::Flange;

filum::surfpath::Plan plan_sheet(const surface::Sheet& sheet, const Flange* flange, const Options& o,
                                 Algorithm algorithm) {
    filum::surfpath::Options asked = flange ? filum::surfpath::on_flange(*flange, o.plan) : o.plan;
    asked.algorithm = algorithm;
    asked.offset = o.laying.offset;
    check_density(surface::area(sheet.surface), asked.spacing, Exit::usage, "--spacing");
    filum::surfpath::Plan out;
    const auto lines = [&] {
        out = o.planner(sheet, asked);
        if (flange) filum::surfpath::thread(sheet.surface, out);
        filum::surfpath::finish(sheet.surface, out, asked);
        filum::surfpath::plan::report_cuts_bound(sheet.surface, {asked.spacing, asked.cut_length, flange == nullptr},
                                                 out);
    };
    std::optional<filum::surfpath::rings::RingBound>
        reach; // does not depend on the lines, so it is computed in parallel
    const auto bound = [&] {
        reach = filum::surfpath::rings::ring_bound(sheet.surface, asked.spacing, asked.least_radius);
    };
    parallel::for_chunks(filum::surfpath::runs_round(algorithm) ? 2 : 1, 1, 0, [&](std::size_t i, std::size_t) {
        if (i == 0)
            lines();
        else
            bound();
    });
    if (reach) filum::surfpath::rings::report_ring_bound(*reach, out);
    if (flange) filum::surfpath::report_trims(*flange, o.plan.turn_outside, out);
    return out;
}

// Adds flanges to the surfaces that rows fill; these flanges take the sheets.  Other sheets stay as they are.
std::vector<std::optional<Flange>> flanges(const Options& o, const filum::surfpath::Algorithms& algorithms,
                                           std::vector<surface::Sheet>& sheets) {
    std::vector<std::optional<Flange>> out(sheets.size());
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        if (!algorithms[k]) continue;
        filum::surfpath::Options asked = o.plan;
        asked.algorithm = *algorithms[k];
        out[k] = filum::surfpath::flange(sheets[k], asked);
        if (out[k]) std::swap(sheets[k], out[k]->sheet);
    }
    return out;
}

// The table (TSV) of places where material outside the parts must be trimmed: a line for each place.
std::string trim_table(std::span<const filum::surfpath::Plan> plans, std::span<const std::optional<Flange>> flanges) {
    std::size_t strokes = 0;
    std::string out = "stroke\talong\tx\ty\tz\n";
    for (std::size_t k = 0; k < plans.size(); ++k) {
        if (flanges[k]) out += trim_lines(plans[k], flanges[k]->part, strokes);
        strokes += plans[k].strokes.size();
    }
    return out;
}

// The names of all sources that `field` can follow, as "a, b and c".
std::string known_sources() {
    std::string out;
    const std::size_t n = std::size(filum::surfpath::field::kNamedWeights);
    for (std::size_t i = 0; i < n; ++i)
        out += std::string(i == 0 ? "" : i + 1 < n ? ", " : " and ") + filum::surfpath::field::kNamedWeights[i].name;
    return out;
}

// The mix of directions that `field` follows; only the angle if --follow is not given.
filum::surfpath::field::DirectionMix followed(const Options& o) {
    using filum::surfpath::field::kNamedWeights;
    using filum::surfpath::field::NamedWeight;
    filum::surfpath::field::DirectionMix out;
    out.turn = geom::radians(o.angle_deg);
    out.reference = reference(o.reference);
    for (const auto& [name, weight] : parse_weights(o.follow, "--follow")) {
        const auto* source = std::find_if(std::begin(kNamedWeights), std::end(kNamedWeights),
                                          [&wanted = name](const NamedWeight& known) { return wanted == known.name; });
        if (source == std::end(kNamedWeights))
            throw Error(Exit::usage, "cannot follow '" + name + "'; --follow knows " + known_sources());
        out.*source->weight = weight;
    }
    if (o.follow.empty() && (o.angle_deg != 0 || o.reference != "X")) out.angle = 1;
    return out;
}

// Warns of options of algorithms that no patch uses.
void tell_idle(const filum::surfpath::Algorithms& algorithms, const cli::Io& io) {
    const auto used = [&](Algorithm a) {
        return std::find(algorithms.begin(), algorithms.end(), a) != algorithms.end();
    };
    const auto idle = [&](const std::vector<const char*>& options, const char* of) {
        for (const char* option : options) io.idle(option, std::string("no surface is filled by ") + of);
    };
    if (!used(Algorithm::ortheo)) idle({"d-iso", "min-spacing"}, "ortheo");
    const bool by_distance = used(Algorithm::fina) || used(Algorithm::fexa) || used(Algorithm::ortheo);
    if (!by_distance && !used(Algorithm::field)) idle({"turns"}, "fina, fexa, ortheo or field");
    if (!used(Algorithm::field) && !used(Algorithm::hybrid)) idle({"cut-length"}, "field or hybrid");
    if (std::none_of(algorithms.begin(), algorithms.end(),
                     [](const auto& a) { return a && filum::surfpath::has_rows(*a); }))
        idle({"turn-outside", "trim-list"}, "rows: fina, fexa, ortheo or field");
    if (!used(Algorithm::field)) idle({"follow", "angle", "reference", "keep"}, "field");
    if (!by_distance) idle({"plane"}, "fina, fexa or ortheo");
    const bool rings = used(Algorithm::geo_fiso) || used(Algorithm::geo_contour);
    if (!rings) idle({"t-dist"}, "geo-fiso or geo-contour");
    if (!rings && !used(Algorithm::geo_spiral)) idle({"n-thresh"}, "geo-fiso, geo-contour or geo-spiral");
}

} // namespace

std::vector<cli::Option> line_options(Options& o) {
    using cli::Option;
    return {
        Option{"spacing", &o.plan.spacing, "MM", "between neighbouring lines"}
            .within(0.001, 1000)
            .same_as({"choose.spacing"}),
        Option{"min-radius", &o.plan.least_radius, "MM", "minimum radius of turns, where there is room"}
            .within(0, 1e5)
            .same_as({"choose.min-radius"}),
        Option{"strict", &o.plan.strict, "",
               "refuse (exit 1) a path if more than --max-tight of it turns tighter than --min-radius"}
            .a_limit(),
        Option{"max-tight", &o.plan.max_tight, "SHARE", "share of the length that may turn tighter than --min-radius"}
            .within(0, 1)
            .when("strict")
            .a_limit(),
        Option{"min-length", &o.plan.min_length, "MM", "pieces of fibre shorter than this are left out"}
            .within(0, 1e6)
            .a_limit()};
}

std::vector<cli::Option> bead_options(Options& o) {
    using cli::Option;
    return {Option{"layer-height", &o.laying.height, "MM", "height of the bead, along the normals"}.within(0.001, 100),
            Option{"ply", &o.ply, "N", "number of this ply, its layer in the toolpath"}.within(0, 1e6),
            Option{"offset", &o.laying.offset, "MM", "height of the plies below, along the normals"}.within(0, 1e4),
            Option{"lift", &o.laying.lift, "MM", "how high the tool travels"}.within(0, 1e4).a_limit()};
}

geom::Vec3 reference(const std::string& words) {
    for (const auto& [name, axis] :
         {std::pair("X", Vec3{1, 0, 0}), std::pair("Y", Vec3{0, 1, 0}), std::pair("Z", Vec3{0, 0, 1})})
        if (words == name) return axis;
    std::vector<double> xyz;
    for (std::size_t at = 0; at <= words.size();) {
        const std::size_t end = std::min(words.find(',', at), words.size());
        xyz.push_back(parse_number(std::string_view(words).substr(at, end - at), "--reference"));
        at = end + 1;
    }
    if (xyz.size() != 3 || !std::isfinite(norm(Vec3{xyz[0], xyz[1], xyz[2]})) ||
        !(norm(Vec3{xyz[0], xyz[1], xyz[2]}) > 0))
        throw Error(Exit::usage, "cannot use --reference '" + words + "'; say X, Y, Z or three numbers, as 1,0,0.5");
    return {xyz[0], xyz[1], xyz[2]};
}

std::string trim_lines(const filum::surfpath::Plan& plan, std::uint32_t part, std::size_t stroke,
                       const std::string& before) {
    std::string out;
    for (const auto& t : filum::surfpath::trims(plan, part).all)
        out += before + std::to_string(stroke + t.stroke) + "\t" + fixed_text(t.way, 3) + "\t" + fixed_text(t.at.x, 3) +
               "\t" + fixed_text(t.at.y, 3) + "\t" + fixed_text(t.at.z, 3) + "\n";
    return out;
}

void run(const Options& o, const cli::Io& io) {
    if (!o.machine.empty())
        machine::allow_outside(machine::load_profile(o.machine), o.plan.turn_outside, "--turn-outside");
    Options asked = o;
    asked.plan.follow = followed(o);
    std::vector<surface::Sheet> sheets;
    auto whole = cli::read_all(io.input, stream::Payload::surface,
                               [&](const stream::RawFrame& frame) { sheets.push_back(wire::sheet(frame)); });
    const auto algorithms = filum::surfpath::algorithms(sheets, filum::surfpath::algorithm(o.algorithm));
    tell_idle(algorithms, io);
    if (std::all_of(sheets.begin(), sheets.end(), [](const auto& sheet) { return sheet.surface.rims.empty(); }))
        for (const char* option : {"turn-outside", "trim-list"}) io.idle(option, "no surface has a rim");
    const auto outside = flanges(o, algorithms, sheets);
    std::optional<cli::Progress> progress; // progress counts surfaces, so a single one has none
    if (sheets.size() > 1) progress.emplace(io, sheets.size());
    std::mutex telling;
    auto patches = filum::surfpath::each_patch(sheets, algorithms, io.threads, [&](std::size_t k) {
        auto plan = plan_sheet(sheets[k], outside[k] ? &*outside[k] : nullptr, asked, *algorithms[k]);
        const std::lock_guard lock(telling);
        if (progress) progress->step();
        return plan;
    });
    filum::surfpath::plan::SpanOptions laying = o.laying;
    laying.width = o.plan.spacing;
    laying.layer = static_cast<std::uint32_t>(o.ply);
    const auto spans = filum::surfpath::spans(sheets, patches.plans, laying);
    cli::Io self = io; // its settings get the algorithms that were used
    for (auto& s : self.settings)
        if (s.name == "algorithm" && sheets.size() == 1) {
            s.value = name(*algorithms[0]);
            s.changed = algorithms != filum::surfpath::algorithms(sheets, {});
        }
    whole.header.expected = spans.size();
    std::vector<stream::RawFrame> frames;
    frames.reserve(spans.size());
    for (const auto& span : spans) frames.push_back(wire::frame(span));
    if (!o.trim_list.empty()) cli::write_text(o.trim_list, trim_table(patches.plans, outside));
    cli::write_all(io, cli::header(self, stream::Payload::toolpath, {&whole.header}), whole, patches.notes,
                   patches.facts, frames);
}

} // namespace filum::app::surfpath
