#include "wire/record.hpp"

#include "wire/checks.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include "filum/stream.pb.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

namespace filum::wire {

namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// How a field is shown, by its name. An array that is not listed becomes a table of its own, so nothing is left out.
struct Meaning {
    std::string_view message; // name of the message; "" for any
    std::string_view field, unit;
    // of an array: the table that it is a column of; of messages: the table that they are columns of
    std::string_view table = {};
    std::string_view columns = {}; // of an array: columns that take its entries in turn
    bool beside = false;           // of an array: a single entry stands beside the table, not in every row
};

constexpr std::array kMeanings = {
    Meaning{"", "x", "mm", "points"},
    Meaning{"", "y", "mm", "points"},
    Meaning{"", "z", "mm", "points"},
    Meaning{"", "width", "mm", "points", "", true},
    Meaning{"", "height", "mm", "points", "", true},
    Meaning{"", "nx", "", "points"},
    Meaning{"", "ny", "", "points"},
    Meaning{"", "nz", "", "points"},
    Meaning{"Surface", "fields", "", "points"},
    Meaning{"Isolines", "triangle", "", "points"},
    Meaning{"Surface", "corner", "", "triangles", "a,b,c"},
    Meaning{"Surface", "across", "", "triangles", "ab,bc,ca"},
    Meaning{"Surface", "face", "", "triangles"},
    Meaning{"Sources", "vertex", "", "vertices"},
    Meaning{"Sources", "triangle", "", "lines"},
    Meaning{"Sources", "ax", "mm", "lines"},
    Meaning{"Sources", "ay", "mm", "lines"},
    Meaning{"Sources", "az", "mm", "lines"},
    Meaning{"Sources", "bx", "mm", "lines"},
    Meaning{"Sources", "by", "mm", "lines"},
    Meaning{"Sources", "bz", "mm", "lines"},
    Meaning{"", "plane", "mm"},
    Meaning{"", "inradius", "mm"},
    Meaning{"", "level", "mm"},
    Meaning{"", "area", "mm2"},
    Meaning{"", "unsupported", "mm2"},
    Meaning{"", "unplaced", "mm2"},
    Meaning{"", "spacing", "mm"},
    Meaning{"", "direction", "rad"},
};

Meaning meaning(const FieldDescriptor& f) {
    for (const Meaning& m : kMeanings)
        if (m.field == f.name() && (m.message.empty() || m.message == f.containing_type()->name())) return m;
    return {"", f.name(), ""};
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

// The kind of a record of message `m`: "loop" for Loops, "curve" for Curve.
std::string part_kind(const Message& m) {
    std::string name = lower(m.GetDescriptor()->name());
    if (name.ends_with('s')) name.pop_back();
    return name;
}

const FieldDescriptor* offsets(const Message& m) { return m.GetDescriptor()->FindFieldByName("start"); }

// The number at index `i` of an array, or the value of a single field if `i` is none.
double number(const Message& m, const FieldDescriptor* f, std::optional<int> i) {
    const auto* r = m.GetReflection();
    switch (f->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
        return i ? r->GetRepeatedDouble(m, f, *i) : r->GetDouble(m, f);
    case FieldDescriptor::CPPTYPE_UINT32:
        return i ? r->GetRepeatedUInt32(m, f, *i) : r->GetUInt32(m, f);
    case FieldDescriptor::CPPTYPE_UINT64:
        return static_cast<double>(i ? r->GetRepeatedUInt64(m, f, *i) : r->GetUInt64(m, f));
    case FieldDescriptor::CPPTYPE_INT64:
        return static_cast<double>(i ? r->GetRepeatedInt64(m, f, *i) : r->GetInt64(m, f));
    case FieldDescriptor::CPPTYPE_BOOL:
        return (i ? r->GetRepeatedBool(m, f, *i) : r->GetBool(m, f)) ? 1 : 0;
    case FieldDescriptor::CPPTYPE_ENUM:
        return i ? r->GetRepeatedEnumValue(m, f, *i) : r->GetEnumValue(m, f);
    default:
        throw Error(Exit::failure, "internal error: no way to show '" + f->full_name() + "'");
    }
}

Entry entry(const Message& m, const FieldDescriptor* f, std::optional<int> i) {
    Entry out{f->name(), std::string(meaning(*f).unit), {}};
    const auto* r = m.GetReflection();
    switch (f->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
        out.value = number(m, f, i);
        break;
    case FieldDescriptor::CPPTYPE_BOOL:
        out.value = Word{number(m, f, i) != 0 ? "yes" : "no"};
        break;
    case FieldDescriptor::CPPTYPE_STRING:
        out.value = Word{i ? r->GetRepeatedString(m, f, *i) : r->GetString(m, f)};
        break;
    case FieldDescriptor::CPPTYPE_ENUM:
        out.value = Word{lower((i ? r->GetRepeatedEnum(m, f, *i) : r->GetEnum(m, f))->name()), true};
        break;
    case FieldDescriptor::CPPTYPE_INT64:
        out.value = i ? r->GetRepeatedInt64(m, f, *i) : r->GetInt64(m, f);
        break;
    case FieldDescriptor::CPPTYPE_UINT64:
        out.value = static_cast<std::int64_t>(i ? r->GetRepeatedUInt64(m, f, *i) : r->GetUInt64(m, f));
        break;
    default:
        out.value = static_cast<std::int64_t>(number(m, f, i));
    }
    return out;
}

// A record under construction, with its kinds of entries separated.
struct Parts {
    std::vector<Entry> values, tables, lists;
};

void add_column(Parts& to, const Meaning& what, const std::string& name, std::vector<double> values) {
    if (values.empty()) return;
    const std::string in(what.table.empty() ? what.field : what.table);
    auto at = std::find_if(to.tables.begin(), to.tables.end(), [&](const Entry& e) { return e.name == in; });
    if (at == to.tables.end()) at = to.tables.insert(at, {in, "", Table{}});
    auto& table = std::get<Table>(at->value);
    const std::size_t rows = table.empty() ? values.size() : table.front().values.size();
    if (values.size() == 1 && what.beside) return to.values.push_back({name, std::string(what.unit), values[0]});
    if (values.size() == 1) values.resize(rows, values[0]);
    table.push_back({name, std::string(what.unit), std::move(values)});
}

// Adds the entries [from, to) of an array as one column, or as several if its meaning names them.
void add_array(Parts& parts, const Message& m, const FieldDescriptor* f, int from, int to) {
    const Meaning what = meaning(*f);
    std::vector<double> all;
    for (int i = from; i < to; ++i) all.push_back(number(m, f, i));
    if (what.columns.empty()) return add_column(parts, what, f->name(), std::move(all));
    const auto n = static_cast<std::size_t>(std::count(what.columns.begin(), what.columns.end(), ',')) + 1;
    std::string_view names = what.columns;
    for (std::size_t c = 0; c < n; ++c) {
        std::vector<double> column;
        for (std::size_t i = c; i < all.size(); i += n) column.push_back(all[i]);
        const std::size_t end = std::min(names.find(','), names.size());
        add_column(parts, what, std::string(names.substr(0, end)), std::move(column));
        names.remove_prefix(std::min(end + 1, names.size()));
    }
}

// Adds a message Field as a column named after it, or as one column for each of its components.
void add_field(Parts& parts, const Meaning& what, const proto::Field& field) {
    const std::size_t n = std::max(1U, field.components());
    for (std::size_t c = 0; c < n; ++c) {
        std::vector<double> column;
        for (std::size_t i = c; i < static_cast<std::size_t>(field.value_size()); i += n)
            column.push_back(field.value(static_cast<int>(i)));
        add_column(parts, what, n == 1 ? field.name() : field.name() + "." + "xyz"[c % 3], std::move(column));
    }
}

Record joined(std::string kind, Parts parts) {
    Record out{std::move(kind), std::move(parts.values)};
    for (auto* more : {&parts.tables, &parts.lists})
        std::move(more->begin(), more->end(), std::back_inserter(out.entries));
    return out;
}

// Splits a message with offsets into one record per part. Arrays of points are split at the offsets, and other arrays
// have one entry per part.
std::vector<Record> cut(const Message& m, const FieldDescriptor* start) {
    const auto* r = m.GetReflection();
    std::vector<Record> out;
    for (int k = 0; k + 1 < r->FieldSize(m, start); ++k) {
        const auto from = static_cast<int>(r->GetRepeatedUInt32(m, start, k));
        const auto to = static_cast<int>(r->GetRepeatedUInt32(m, start, k + 1));
        Parts parts;
        for (int i = 0; i < m.GetDescriptor()->field_count(); ++i) {
            const auto* f = m.GetDescriptor()->field(i);
            if (f == start) continue;
            if (meaning(*f).table.empty())
                parts.values.push_back(entry(m, f, k));
            else
                add_array(parts, m, f, from, to);
        }
        out.push_back(joined(part_kind(m), std::move(parts)));
    }
    return out;
}

Record whole(const Message& m, const std::string& kind);

void add_messages(Parts& parts, const Message& m, const FieldDescriptor* f) {
    const auto* r = m.GetReflection();
    const Meaning what = meaning(*f);
    std::vector<Record> list;
    for (int i = 0; f->is_repeated() && i < r->FieldSize(m, f); ++i) {
        const Message& one = r->GetRepeatedMessage(m, f, i);
        if (what.table.empty())
            list.push_back(whole(one, part_kind(one)));
        else
            add_field(parts, what, dynamic_cast<const proto::Field&>(one));
    }
    if (!f->is_repeated() && r->HasField(m, f)) {
        const Message& one = r->GetMessage(m, f);
        if (const auto* start = offsets(one))
            list = cut(one, start);
        else
            list.push_back(whole(one, f->name()));
    }
    if (what.table.empty()) parts.lists.push_back({f->name(), "", std::move(list)});
}

Record whole(const Message& m, const std::string& kind) {
    Parts parts;
    for (int i = 0; i < m.GetDescriptor()->field_count(); ++i) {
        const auto* f = m.GetDescriptor()->field(i);
        if (f->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE)
            add_messages(parts, m, f);
        else if (f->is_repeated())
            add_array(parts, m, f, 0, m.GetReflection()->FieldSize(m, f));
        else
            parts.values.push_back(entry(m, f, {}));
    }
    return joined(kind, std::move(parts));
}

// Throws Error(bad_input) as the reader of frames of this kind does.
void check(const stream::RawFrame& frame) {
    switch (frame.tag) {
    case stream::Tag::note:
        return void(stream::parse_note(frame.body));
    case stream::Tag::fact:
        return void(stream::parse_fact(frame.body));
    case stream::Tag::layer:
        return void(layer(frame));
    case stream::Tag::region:
        return void(region(frame));
    case stream::Tag::paths:
        return void(paths(frame));
    case stream::Tag::span:
        return void(span(frame));
    case stream::Tag::surface:
        return void(sheet(frame));
    case stream::Tag::header:
    case stream::Tag::end:
        throw Error(Exit::failure, "internal error: header and end of a stream are no payload");
    }
}

} // namespace

Record record(const stream::RawFrame& frame) {
    check(frame);
    proto::Frame any;
    const auto* field = any.GetDescriptor()->FindFieldByNumber(static_cast<int>(frame.tag));
    Message* m = any.GetReflection()->MutableMessage(&any, field);
    if (!m->ParseFromString(frame.body)) bad_frame(field->name(), "malformed");
    return whole(*m, field->name());
}

} // namespace filum::wire
