#include "app/peek/summary.hpp"

#include <algorithm>

namespace filum::app::peek {

namespace {

// Whether other records already include the areas and places of this one, so that they would count twice.
bool counts_again(const Record& record) {
    return record.kind == "overlap" || record.kind == "sources" || record.kind == "rim";
}

void add_table(Summary& s, const std::string& name, const Table& table) {
    if (name == "points" && !table.empty()) s.points += table.front().values.size();
    for (const auto& column : table) {
        if (column.unit != "mm") continue;
        Range& range = s.ranges[column.name];
        for (const double v : column.values) range.add(v);
    }
}

void add_index(Summary& s, const Record& record, const std::string& name, std::int64_t v) {
    if (name == "layer" || (record.kind == "layer" && name == "index")) s.layers = std::max(s.layers, v + 1);
    if (name == "stroke") s.strokes = std::max(s.strokes, v + 1);
}

void add_record(Summary& s, const Record& record) {
    ++s.records[record.kind];
    if (counts_again(record)) return;
    for (const auto& [name, unit, value] : record.entries) {
        if (const auto* number = std::get_if<double>(&value)) {
            if (unit == "mm") s.ranges[name].add(*number);
            if (unit == "mm2") s.areas[name] += *number;
        } else if (const auto* index = std::get_if<std::int64_t>(&value)) {
            add_index(s, record, name, *index);
        } else if (const auto* word = std::get_if<Word>(&value)) {
            if (word->named) ++s.named[name + " " + word->text];
        } else if (const auto* table = std::get_if<Table>(&value)) {
            add_table(s, name, *table);
        } else {
            for (const Record& inner : std::get<std::vector<Record>>(value)) add_record(s, inner);
        }
    }
}

void add_note(Summary& s, const Note& note) {
    const auto same = [&](const Note& sum) { return same_kind(sum, note); };
    if (const auto sum = std::find_if(s.notes.begin(), s.notes.end(), same); sum != s.notes.end())
        filum::add(*sum, note);
    else
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
