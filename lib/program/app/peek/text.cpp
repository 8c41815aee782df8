#include "app/peek/text.hpp"

#include "base/number.hpp"
#include "base/printable.hpp"

#include <cmath>

namespace filum::app::peek {

namespace {

void append_number(std::string& out, double v, int decimals) {
    if (std::isfinite(v))
        append_fixed(out, v, decimals);
    else
        out += std::isnan(v) ? "nan" : v > 0 ? "inf" : "-inf";
}

void append_table(std::string& out, const Table& table, const std::string& indent, int decimals) {
    const std::size_t rows = table.empty() ? 0 : table.front().values.size();
    for (std::size_t r = 0; r < rows; ++r) {
        out += indent;
        for (std::size_t c = 0; c < table.size(); ++c) {
            if (c > 0) out += ' ';
            append_number(out, table[c].values[r], decimals);
        }
        out += '\n';
    }
}

void append_record(std::string& out, const Record& record, const std::string& indent, int decimals) {
    out += indent + record.kind;
    for (const auto& [name, unit, value] : record.entries) {
        if (const auto* number = std::get_if<double>(&value)) {
            out += " " + name + " ";
            append_number(out, *number, decimals);
        } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
            out += " " + name + " " + std::to_string(*whole);
        } else if (const auto* word = std::get_if<Word>(&value)) {
            const std::string text = printable(word->text);
            const bool plain = text.find(' ') == std::string::npos && !text.empty();
            out += " " + name + " " + (plain ? text : "'" + text + "'");
        } else if (const auto* table = std::get_if<Table>(&value)) {
            out += " " + name;
            for (const auto& column : *table) out += (&column == table->data() ? " " : ",") + column.name;
            out += " " + std::to_string(table->empty() ? 0 : table->front().values.size());
        } else {
            out += " " + name + " " + std::to_string(std::get<std::vector<Record>>(value).size());
        }
    }
    out += '\n';
    for (const auto& entry : record.entries) {
        if (const auto* table = std::get_if<Table>(&entry.value)) append_table(out, *table, indent + "  ", decimals);
        if (const auto* inner = std::get_if<std::vector<Record>>(&entry.value))
            for (const Record& r : *inner) append_record(out, r, indent + "  ", decimals);
    }
}

std::string line(const std::string& name, const std::string& value) {
    std::string out = printable(name);
    out.resize(std::max<std::size_t>(out.size() + 1, 14), ' ');
    return out + printable(value) + "\n";
}

} // namespace

std::string text(const stream::Header& header) {
    std::string out = line("payload", std::string(stream::name(header.payload))) + line("units", "mm");
    for (std::size_t i = 0; i < header.history.size(); ++i) {
        const auto& run = header.history[i];
        std::string what = run.program + " " + run.version;
        if (!run.parents.empty()) what += " after";
        for (const auto parent : run.parents) what += " " + std::to_string(parent);
        out += line("run " + std::to_string(i), what);
        for (const auto& s : run.settings)
            out += std::string(14, ' ') + printable(s.name + " = " + s.value) +
                   (s.changed ? "  (not the default)" : "") + "\n";
        for (const auto& object : run.objects)
            out += std::string(14, ' ') + "object " + printable(object.name) + " of " +
                   std::to_string(object.x.size()) + " corners, " + fixed_text(object.height, 4) + " mm high\n";
    }
    return out;
}

std::string text(const Record& record, int decimals) {
    std::string out;
    append_record(out, record, "", decimals);
    return out;
}

std::string text(const Summary& s) {
    std::string out;
    for (const auto& [kind, count] : s.records) out += line(kind, std::to_string(count));
    out += line("points", std::to_string(s.points));
    if (s.layers > 0) out += line("layers", std::to_string(s.layers));
    if (s.strokes > 0) out += line("strokes", std::to_string(s.strokes));
    for (const auto& [name, count] : s.named) out += line(name, std::to_string(count));
    for (const auto& [name, sum] : s.areas) out += line(name, fixed_text(sum, 4) + " mm2");
    for (const auto& [name, range] : s.ranges)
        if (!range.empty()) out += line(name, fixed_text(range.lo, 4) + " to " + fixed_text(range.hi, 4) + " mm");
    for (const Fact& f : s.facts)
        out +=
            line("fact", f.stage + ": " + f.name + " " + fixed_text(f.value, 4) + (f.unit.empty() ? "" : " " + f.unit));
    for (const Note& n : s.notes)
        out += line("note", n.stage + ": " + std::string(name(grade(n))) + ": " + filum::line(n));
    return out;
}

} // namespace filum::app::peek
