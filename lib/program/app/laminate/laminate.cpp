#include "app/laminate/laminate.hpp"

#include "app/surfpath/surfpath.hpp"
#include "base/density.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "geodesic/lines.hpp"
#include "machine/profile.hpp"
#include "metrics/surface/map_sheet.hpp"
#include "stream/frame.hpp"
#include "surfpath/patches.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace filum::app::laminate {

namespace {

using filum::laminate::Laminate;
using filum::laminate::Ply;

std::string text_of(const std::string& file, const std::string& named_by) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream out;
    if (!in || !(out << in.rdbuf()))
        throw Error(Exit::io, "cannot read '" + file + "': no such file, or it is empty; see " + named_by);
    return out.str();
}

std::vector<Ply> asked(const Options& o) {
    Ply like = o.like;
    like.tool = static_cast<std::uint32_t>(o.tool);
    return o.table.empty() ? filum::laminate::plies_of(o.plies, like, o.symmetric)
                           : filum::laminate::plies_of_table(text_of(o.table, "--table"), o.table, like, o.symmetric);
}

void write_map(const std::string& file, const cli::Io& io, const stream::Header& before,
               std::span<const surface::Sheet> sheets) {
    auto header = cli::header(io, stream::Payload::surface, {&before});
    header.expected = sheets.size();
    cli::Io there = io;
    there.output = file;
    cli::Output out(there, header);
    for (const auto& sheet : sheets) out.write(wire::frame(sheet));
    out.close();
}

void add_trims(const Laminate& made, std::size_t stroke, std::string& to) {
    for (std::size_t k = 0; k < made.plies.size(); ++k) {
        const auto& ply = made.plies[k];
        if (ply.part != surface::kNone)
            to += surfpath::trim_lines(ply.plan, ply.part, stroke, std::to_string(k) + "\t");
        stroke += ply.plan.strokes.size();
    }
}

// Adds the notes and facts of one surface to those of all.  They get the name of the surface (`patch`).
void gather(Laminate& made, const std::string& patch, cli::WholeInput& all) {
    for (Note& n : made.notes) {
        n.patch = patch;
        all.notes.push_back(std::move(n));
    }
    for (Fact& f : made.facts) {
        f.name = (patch.empty() ? "" : "patch." + patch + ".") + f.name;
        all.facts.push_back(std::move(f));
    }
}

} // namespace

double ramp(const std::string& words) {
    if (words.empty()) return 0;
    const auto colon = words.find(':');
    const double rise = parse_number(std::string_view(words).substr(0, colon), "--ramp");
    const double run =
        colon == std::string::npos ? 0 : parse_number(std::string_view(words).substr(colon + 1), "--ramp");
    if (!(rise > 0 && run > 0 && std::isfinite(run / rise)))
        throw Error(Exit::usage, "cannot use --ramp '" + words + "'; say height and length, as 1:20");
    return run / rise;
}

filum::laminate::Area within(const std::string& word) {
    constexpr std::string_view kFaces = "faces:";
    filum::laminate::Area out;
    if (!word.starts_with(kFaces)) {
        out.curves = geodesic::read_lines(text_of(word, "column 'within' of --table"), "'" + word + "'");
        for (const auto& curve : out.curves)
            if (curve.size() < 3)
                throw Error(Exit::bad_input,
                            "cannot use '" + word + "': a curve around a ply has three points or more");
        return out;
    }
    for (std::size_t at = kFaces.size(); at <= word.size();) {
        const std::size_t end = std::min(word.find(',', at), word.size());
        const double face = parse_number(std::string_view(word).substr(at, end - at), "faces");
        if (!(face >= 1 && face <= 1e9 && face == std::floor(face)))
            throw Error(Exit::usage, "cannot use '" + word + "': faces are numbers from 1, as faces:3,4");
        out.faces.push_back(static_cast<std::uint32_t>(face));
        at = end + 1;
    }
    return out;
}

void run(const Options& o, const cli::Io& io) {
    const auto plies = asked(o);
    filum::laminate::Options how = o.how;
    how.reference = surfpath::reference(o.reference);
    how.ramp = ramp(o.ramp);
    for (const Ply& ply : plies)
        if (!ply.within.empty() && !how.areas.contains(ply.within)) how.areas[ply.within] = within(ply.within);
    if (how.areas.empty()) io.idle("ramp", "every ply lies everywhere; see column 'within' of --table");
    if (!o.machine.empty())
        machine::allow_outside(machine::load_profile(o.machine), how.turn_outside, "--turn-outside");
    std::vector<surface::Sheet> sheets, maps;
    const auto before = cli::read_all(io.input, stream::Payload::surface,
                                      [&](const stream::RawFrame& frame) { sheets.push_back(wire::sheet(frame)); });
    if (sheets.empty()) throw Error(Exit::bad_input, "cannot lay plies: the stream holds no surface");
    cli::WholeInput found;
    std::vector<toolpath::Span> spans;
    std::string trims = "ply\tstroke\talong\tx\ty\tz\n";
    cli::Progress progress(io, sheets.size() * plies.size());
    how.done = [&] { progress.step(); };
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        const std::size_t stroke = spans.empty() ? 0 : spans.back().stroke + 1;
        for (const Ply& ply : plies)
            check_density(surface::area(sheets[k].surface), ply.spacing, Exit::usage, "the --spacing of a ply");
        Laminate made = filum::laminate::laminate(sheets[k], plies, how, io.threads);
        filum::laminate::add_spans(made, plies, how, 0, spans);
        add_trims(made, stroke, trims);
        gather(made, sheets.size() > 1 ? filum::surfpath::label(sheets, k) : "", found);
        if (!o.map.empty())
            maps.push_back(metrics::surface::within_size(metrics::surface::sheet_of(made.map, sheets[k].name),
                                                         sheets[k].surface, stream::kMaxFrame));
    }
    auto header = cli::header(io, stream::Payload::toolpath, {&before.header});
    header.expected = spans.size();
    std::vector<stream::RawFrame> frames;
    frames.reserve(spans.size());
    for (const auto& span : spans) frames.push_back(wire::frame(span));
    cli::write_all(io, header, before, found.notes, found.facts, frames);
    if (!o.trim_list.empty()) cli::write_text(o.trim_list, trims);
    if (!o.map.empty()) write_map(o.map, io, before.header, maps);
}

} // namespace filum::app::laminate
