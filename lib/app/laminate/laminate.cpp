#include "app/laminate/laminate.hpp"

#include "app/surfpath/surfpath.hpp"
#include "base/error.hpp"
#include "cli/output.hpp"
#include "surfpath/patches.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <fstream>
#include <sstream>

namespace filum::app::laminate {

namespace {

using filum::laminate::Laminate;
using filum::laminate::Ply;

std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::stringstream out;
    if (!in || !(out << in.rdbuf()))
        throw Error(Exit::io, "cannot read '" + file + "': no such file, or it is empty; see --table");
    return out.str();
}

std::vector<Ply> asked(const Options& o) {
    Ply like = o.like;
    like.tool = static_cast<std::uint32_t>(o.tool);
    return o.table.empty() ? filum::laminate::plies_of(o.plies, like, o.symmetric)
                           : filum::laminate::plies_of_table(text_of(o.table), o.table, like, o.symmetric);
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

// Of several surfaces each tells its own name.
void gather(Laminate& made, const std::string& patch, cli::Whole& all) {
    for (Note& n : made.notes) {
        n.what += patch.empty() ? "" : " on patch " + patch;
        all.notes.push_back(std::move(n));
    }
    for (Fact& f : made.facts) {
        f.name = (patch.empty() ? "" : "patch." + patch + ".") + f.name;
        all.facts.push_back(std::move(f));
    }
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    const auto plies = asked(o);
    filum::laminate::Options how = o.how;
    how.reference = surfpath::reference(o.reference);
    std::vector<surface::Sheet> sheets, maps;
    const auto before = cli::read_all(io.input, stream::Payload::surface,
                                      [&](const stream::RawFrame& frame) { sheets.push_back(wire::sheet(frame)); });
    if (sheets.empty()) throw Error(Exit::bad_input, "cannot lay plies: the stream holds no surface");
    cli::Whole found;
    std::vector<toolpath::Span> spans;
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        Laminate made = filum::laminate::laminate(sheets[k], plies, how, io.threads);
        filum::laminate::add_spans(made, plies, how, 0, spans);
        gather(made, sheets.size() > 1 ? filum::surfpath::spoken(sheets, k) : "", found);
        if (!o.map.empty()) maps.push_back(metrics::surface::sheet_of(made.map, sheets[k].name));
    }
    auto header = cli::header(io, stream::Payload::toolpath, {&before.header});
    header.expected = spans.size();
    std::vector<stream::RawFrame> frames;
    for (const auto& span : spans) frames.push_back(wire::frame(span));
    cli::write_all(io, header, before, found.notes, found.facts, frames);
    if (!o.map.empty()) write_map(o.map, io, before.header, maps);
}

} // namespace filum::app::laminate
