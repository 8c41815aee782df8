#include "base/json.hpp"
#include "app/peek/text.hpp"
#include "base/number.hpp"

#include <cmath>

namespace filum::app::peek {

namespace {

std::string number(double v) { return std::isfinite(v) ? shortest_text(v) : "null"; }

// Appends "name":value to an object; a comma comes before each member except the first.
void member(std::string& out, const std::string& name, const std::string& value) {
    if (out.back() != '{') out += ',';
    out += json_text(name) + ":" + value;
}

// The array "[f(a),f(b),...]" of all items a, b, ...
template <class Range, class F>
std::string array(const Range& all, const F& f) {
    std::string out = "[";
    for (const auto& one : all) {
        if (out.size() > 1) out += ',';
        out += f(one);
    }
    return out + "]";
}

std::string numbers(const std::vector<double>& values) {
    return array(values, [](double v) { return number(v); });
}

std::string records(const std::vector<Record>& all) {
    return array(all, [](const Record& r) { return json(r); });
}

std::string objects(const std::vector<stream::Object>& all) {
    return array(all, [](const stream::Object& object) {
        std::string one = "{";
        member(one, "name", json_text(object.name));
        member(one, "x", numbers(object.x));
        member(one, "y", numbers(object.y));
        member(one, "height", number(object.height));
        return one + "}";
    });
}

std::string table_members(const Table& table) {
    std::string out = "{";
    for (const auto& column : table) member(out, column.name, numbers(column.values));
    return out + "}";
}

} // namespace

std::string json(const Record& record) {
    std::string out = "{";
    member(out, "kind", json_text(record.kind));
    for (const auto& [name, unit, value] : record.entries) {
        if (const auto* v = std::get_if<double>(&value))
            member(out, name, number(*v));
        else if (const auto* i = std::get_if<std::int64_t>(&value))
            member(out, name, std::to_string(*i));
        else if (const auto* word = std::get_if<Word>(&value))
            member(out, name, json_text(word->text));
        else if (const auto* table = std::get_if<Table>(&value))
            member(out, name, table_members(*table));
        else
            member(out, name, records(std::get<std::vector<Record>>(value)));
    }
    return out + "}";
}

std::string json(const stream::Header& header) {
    const auto runs = array(header.history, [](const auto& run) {
        std::string settings = "{", one = "{";
        for (const auto& s : run.settings) member(settings, s.name, json_text(s.value));
        member(one, "program", json_text(run.program));
        member(one, "version", json_text(run.version));
        member(one, "settings", settings + "}");
        member(one, "parents", array(run.parents, [](auto p) { return std::to_string(p); }));
        if (!run.objects.empty()) member(one, "objects", objects(run.objects));
        return one + "}";
    });
    std::string out = "{";
    member(out, "payload", json_text(stream::name(header.payload)));
    member(out, "units", "\"mm\"");
    member(out, "history", runs);
    return out + "}";
}

std::string json(const Summary& s) {
    std::string kinds = "{", ranges = "{", areas = "{", named = "{", out = "{";
    for (const auto& [kind, count] : s.records) member(kinds, kind, std::to_string(count));
    for (const auto& [name, count] : s.named) member(named, name, std::to_string(count));
    for (const auto& [name, sum] : s.areas) member(areas, name, number(sum));
    for (const auto& [name, r] : s.ranges) member(ranges, name, "[" + number(r.lo) + "," + number(r.hi) + "]");
    const auto notes = array(s.notes, [](const Note& n) {
        std::string one = "{";
        member(one, "stage", json_text(n.stage));
        member(one, "code", json_text(code_name(n)));
        member(one, "grade", json_text(name(grade(n))));
        member(one, "what", json_text(sentence(n)));
        member(one, "amount", number(n.amount));
        member(one, "unit", json_text(unit(n)));
        member(one, "count", std::to_string(n.count));
        return one + "}";
    });
    const auto facts = array(s.facts, [](const Fact& f) {
        std::string one = "{";
        member(one, "stage", json_text(f.stage));
        member(one, "name", json_text(f.name));
        member(one, "value", number(f.value));
        member(one, "unit", json_text(f.unit));
        return one + "}";
    });
    member(out, "records", kinds + "}");
    member(out, "points", std::to_string(s.points));
    member(out, "layers", std::to_string(s.layers));
    member(out, "strokes", std::to_string(s.strokes));
    member(out, "named", named + "}");
    member(out, "areas", areas + "}");
    member(out, "ranges", ranges + "}");
    member(out, "facts", facts);
    member(out, "notes", notes);
    return out + "}";
}

} // namespace filum::app::peek
