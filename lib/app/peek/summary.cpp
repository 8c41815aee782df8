#include "app/peek/summary.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace filum::app::peek {

namespace {

template <std::size_t N>
bool among(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 6> kRanges{"x", "y", "z", "width", "height", "plane"};
constexpr std::array<std::string_view, 3> kAreas{"area", "unplaced", "unsupported"};

void add_number(Summary& s, const std::string& name, double v) {
    if (among(kRanges, name)) s.ranges[name].add(v);
    if (among(kAreas, name)) s.areas[name] += v;
}

void add_index(Summary& s, const Record& record, const std::string& name, std::int64_t v) {
    if (name == "layer" || (record.kind == "layer" && name == "index")) s.layers = std::max(s.layers, v + 1);
    if (name == "stroke") s.strokes = std::max(s.strokes, v + 1);
}

void add_record(Summary& s, const Record& record) {
    ++s.records[record.kind];
    if (record.kind == "overlap") return; // its area counts the same surface again
    for (const auto& [name, value] : record.fields) {
        if (const auto* number = std::get_if<double>(&value))
            add_number(s, name, *number);
        else if (const auto* index = std::get_if<std::int64_t>(&value))
            add_index(s, record, name, *index);
        else if (const auto* word = std::get_if<std::string>(&value)) {
            if (name == "role" || name == "join") ++s.named[name + " " + *word];
        } else if (const auto* table = std::get_if<Table>(&value)) {
            if (name == "points" && !table->empty()) s.points += table->front().second.size();
            for (const auto& [column, numbers] : *table) {
                if (!among(kRanges, column)) continue;
                Range& range = s.ranges[column];
                for (const double v : numbers) range.add(v);
            }
        } else {
            for (const Record& inner : std::get<std::vector<Record>>(value)) add_record(s, inner);
        }
    }
}

void add_note(Summary& s, const Note& note) {
    for (Note& sum : s.notes) {
        if (sum.stage != note.stage || sum.what != note.what || sum.unit != note.unit) continue;
        sum.amount += note.amount;
        sum.count += note.count;
        return;
    }
    s.notes.push_back(note);
}

} // namespace

void add(Summary& s, const stream::RawFrame& frame, const Record& record) {
    if (frame.tag == stream::Tag::note)
        add_note(s, stream::parse_note(frame.body));
    else if (frame.tag == stream::Tag::fact)
        s.facts.push_back(stream::parse_fact(frame.body));
    else
        add_record(s, record);
}

} // namespace filum::app::peek
