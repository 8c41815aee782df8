#include "app/report/report.hpp"

#include "app/peek/text.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "figures/meanings.hpp"
#include "report/page.hpp"
#include "stream/reader.hpp"
#include "stream/sink.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace filum::app::report {

namespace {

using filum::report::Content;

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::vector<std::vector<std::string>> rows(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw Error(Exit::io, "cannot read '" + file + "'");
    std::vector<std::vector<std::string>> out;
    for (std::string line; std::getline(in, line);) {
        std::istringstream cells(line);
        out.emplace_back();
        for (std::string cell; std::getline(cells, cell, '\t');) out.back().push_back(cell);
    }
    if (out.empty()) throw Error(Exit::truncated, "cannot use '" + file + "': it is empty");
    return out;
}

// The cells of a table in the columns `heads`, row by row.  Throws Error if a column is missing.
std::vector<std::vector<std::string>> table(const std::string& file, const std::vector<std::string>& heads) {
    auto all = rows(file);
    std::vector<std::size_t> at;
    for (const std::string& head : heads) {
        const auto found = std::find(all[0].begin(), all[0].end(), head);
        if (found == all[0].end())
            throw Error(Exit::bad_input, "cannot use '" + file + "': it has no column '" + head + "'");
        at.push_back(static_cast<std::size_t>(found - all[0].begin()));
    }
    std::vector<std::vector<std::string>> out;
    for (std::size_t r = 1; r < all.size(); ++r) {
        out.emplace_back();
        for (const std::size_t k : at) out.back().push_back(k < all[r].size() ? all[r][k] : "");
    }
    return out;
}

void add_collisions(Content& to, const std::string& file) {
    for (const auto& row : table(file, {"meets", "with", "clearance", "x", "y", "z", "layer"}))
        to.spots.push_back({"collision", row[1] + " meets " + row[0] + ", " + row[2] + " mm", parse_number(row[3], "x"),
                            parse_number(row[4], "y"), parse_number(row[5], "z"),
                            static_cast<std::int64_t>(parse_number(row[6], "layer"))});
}

void add_history(Content& to, const stream::Header& header) {
    for (const stream::Run& run : header.history) {
        to.made.push_back({run.program, {}});
        for (const stream::Setting& s : run.settings)
            to.made.back().settings.push_back({s.name, s.value, s.changed ? "changed" : ""});
    }
    to.script = peek::script(header, false);
}

void add_machine(Content& to, const machine::Profile& p) {
    const auto size = [](double lo, double hi) { return fixed_text(hi - lo, 1); };
    to.machine = p.name + ": " + p.about + "; reaches " + size(p.bed.x_min, p.bed.x_max) + " x " +
                 size(p.bed.y_min, p.bed.y_max) + " x " + size(p.bed.z_min, p.bed.z_max) + " mm";
}

// Adds the content of a payload frame to the page.
void add_frame(Content& to, const stream::RawFrame& f, const machine::Profile& profile) {
    if (f.tag == stream::Tag::span) add(to, wire::span(f), &profile);
    if (f.tag == stream::Tag::paths) add(to, wire::paths(f), &profile);
    if (f.tag == stream::Tag::region) add(to, wire::region(f));
    if (f.tag == stream::Tag::layer) add(to, wire::layer(f));
    if (f.tag == stream::Tag::surface) add(to, wire::sheet(f));
}

Content content(const std::string& file, const machine::Profile& profile) {
    stream::Reader reader(file, stream::Payload::unknown);
    Content out;
    const auto& history = reader.header().history;
    const bool named = file != "-" && !file.starts_with("/dev/");
    out.name = named ? file_name(file) : history.empty() ? "standard input" : "out of " + history.back().program;
    out.payload = stream::name(reader.header().payload);
    Notes notes;
    while (auto f = reader.next()) {
        if (f->tag == stream::Tag::note)
            notes.push_back(stream::parse_note(f->body));
        else if (f->tag == stream::Tag::fact) {
            const Fact fact = stream::parse_fact(f->body);
            out.figures.push_back({fact.stage + " says", fact.name, fixed_text(fact.value, 4), fact.unit});
        } else
            add_frame(out, *f, profile);
    }
    add(out, notes);
    for (const Note& n : summed(notes))
        out.figures.push_back({"notes: " + std::string(name(grade(n))), n.stage, line(n), ""});
    add_history(out, reader.header());
    add_machine(out, profile);
    return out;
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    const machine::Profile profile = machine::load_profile(o.machine);
    std::vector<Content> contents;
    contents.push_back(content(io.input, profile));
    Content& first = contents.front();
    if (!o.title.empty()) first.name = o.title;
    for (const std::string* file : {&o.regions, &o.surface}) {
        if (file->empty()) continue;
        stream::Reader reader(*file, file == &o.regions ? stream::Payload::regions : stream::Payload::surface);
        while (auto f = reader.next())
            if (!stream::is_remark(f->tag)) add_frame(first, *f, profile);
    }
    if (!o.figures.empty()) {
        decltype(first.figures) measured;
        for (const auto& row : table(o.figures, {"key", "value", "unit"})) {
            const auto at = figures::spoken(row[0], !o.surface.empty());
            if (!at.name.empty()) measured.push_back({at.group, at.name, row[1], row[2]});
        }
        first.figures.insert(first.figures.begin(), measured.begin(), measured.end());
    }
    if (!o.collisions.empty()) add_collisions(first, o.collisions);
    if (!o.beside.empty()) contents.push_back(content(o.beside, profile));
    stream::Sink out(io.output, stream::Sink::Content::text);
    out.write(filum::report::page(contents));
    out.commit();
}

} // namespace filum::app::report
