// A record holds all that its frame says, for any fields of the messages.
#include "wire/record.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <filum/stream.pb.h> // the list of all fields
#include <google/protobuf/text_format.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

namespace filum::wire {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

// Frames of every kind in which nothing is empty or zero, but where it has to be.
polygon::Loops holed(double at) {
    polygon::Loops out;
    out.add(std::vector<geom::Vec2>{{at, at}, {at + 1.5, at}, {at + 1.5, at + 1.25}, {at, at + 1.25}});
    out.add(std::vector<geom::Vec2>{{at + 0.1, at + 0.1}, {at + 0.1, at + 0.3}, {at + 0.3, at + 0.1}});
    return out;
}

stream::RawFrame region_frame() {
    polygon::Region r;
    r.id = 3;
    r.layer = 4;
    r.z = 5.5;
    r.height = 0.25;
    r.loops = holed(10);
    r.area = 1.875;
    r.parent = 1;
    r.below = {{7, 0.75, 0.125, true}, {8, 0.5, 0.0625, false}};
    r.unsupported = 0.375;
    r.stroke = 9;
    r.join = Join::beside;
    r.inradius = 0.6;
    r.areas = {{polygon::AreaKind::sparse, r.loops, 0.5, 3, polygon::InfillPattern::wave}};
    r.walls = 2;
    return frame(r);
}

stream::RawFrame paths_frame() {
    toolpath::RegionPaths p;
    p.region = 3;
    p.layer = 4;
    p.z = 5.5;
    p.height = 0.25;
    p.area = 1.875;
    p.stroke = 9;
    p.join = Join::vertical;
    p.curves = {{true, {{1, 2}, {3, 4}, {5, 6}}, {0.4}}, {false, {{7, 8}, {9, 10}}, {0.3, 0.35}}};
    p.curves[0].feature = {toolpath::Feature::wall, toolpath::Feature::infill, toolpath::Feature::top};
    p.curves[0].over_air = {35, 0, 100};
    p.unplaced = 0.015;
    p.stacked = {{{11, 12}, {13, 14}, {15, 16}}};
    return frame(p);
}

stream::RawFrame span_frame() {
    toolpath::Span s{toolpath::Role::jog, 1, 2, 3, {{4, 5, 6.5}, {7, 8, 6.5}}, {0.4, 0.45}, {0.2}, {}, 5};
    s.normals = {{0, 0, 1}, {0, 0.6, 0.8}};
    return frame(s);
}

stream::RawFrame surface_frame() {
    surface::Sheet s;
    s.surface = surface::assemble({{0, 0, 0.1}, {1, 0, 0.2}, {0, 1, 0.3}, {1, 1, 0.5}}, {{0, 1, 2}, {2, 1, 3}},
                                  {surface::kNone, 3, surface::kNone, 1, surface::kNone, surface::kNone});
    s.fields = {{"distance", {0, 1.5, 2.5, std::numeric_limits<double>::infinity()}, 1},
                {"stress.x.d1", {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0}, 3}};
    s.isolines = {{0.5, false, {{0.5, 0, 0}, {0, 0.5, 0}}, {0}},
                  {0.7, true, {{0.5, 0, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}}, {0, 0, 1}}};
    s.sources = {{2, 3}, {{1, {0.5, 0.5, 0.15}, {1, 1, 0.5}}}};
    s.name = "A.1";
    s.faces = {7, 8};
    s.algorithm = "geo-fiso";
    return frame(s);
}

std::vector<stream::RawFrame> frames() {
    const polygon::Layer layer{2, 0.75, 0.25, 0.625, holed(3)};
    const Note note{NoteCode::contour_gap_closed, 1.5, 3, 2, 4.5, 5.5, std::nan(""), "d", "p", "slice"};
    const Fact fact{"sequence", "strokes", 21, "strokes"};
    return {frame(layer),
            region_frame(),
            paths_frame(),
            span_frame(),
            surface_frame(),
            {stream::Tag::note, stream::serialise(note)},
            {stream::Tag::fact, stream::serialise(fact)}};
}

// What `entry` is called for: every entry, and every column under its name, of a record and all within it.
struct Walk {
    std::set<std::string> names;
    std::multiset<std::string> values;
    void operator()(const Record& r) {
        names.insert(r.kind);
        for (const Entry& e : r.entries) {
            names.insert(e.name);
            if (const auto* v = std::get_if<double>(&e.value)) values.insert(shortest_text(*v));
            if (const auto* v = std::get_if<std::int64_t>(&e.value)) values.insert(std::to_string(*v));
            if (const auto* v = std::get_if<Word>(&e.value)) values.insert(v->text);
            if (const auto* table = std::get_if<Table>(&e.value))
                for (const Column& c : *table) {
                    names.insert(c.name);
                    for (const double v : c.values) values.insert(shortest_text(v));
                }
            if (const auto* inner = std::get_if<std::vector<Record>>(&e.value))
                for (const Record& one : *inner) (*this)(one);
        }
    }
};

// Parsed by hand, not by record().
std::unique_ptr<proto::Frame> message(const stream::RawFrame& raw) {
    auto out = std::make_unique<proto::Frame>();
    const auto* field = out->GetDescriptor()->FindFieldByNumber(static_cast<int>(raw.tag));
    EXPECT_TRUE(out->GetReflection()->MutableMessage(out.get(), field)->ParseFromString(raw.body));
    return out;
}

// Every value that is set in a message and those within it, as protobuf prints it.
void each_value(const Message& m, const std::function<void(const FieldDescriptor&, std::string)>& take) {
    std::vector<const FieldDescriptor*> set;
    const auto* r = m.GetReflection();
    r->ListFields(m, &set);
    for (const auto* f : set) {
        const bool many = f->is_repeated();
        for (int i = 0; i < (many ? r->FieldSize(m, f) : 1); ++i) {
            if (f->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
                each_value(many ? r->GetRepeatedMessage(m, f, i) : r->GetMessage(m, f), take);
                continue;
            }
            std::string text;
            google::protobuf::TextFormat::PrintFieldValueToString(m, f, many ? i : -1, &text);
            take(*f, text);
        }
    }
}

TEST(Record, HoldsEveryValueOfItsFrame) {
    for (const auto& raw : frames()) {
        Walk found;
        found(record(raw));
        each_value(*message(raw), [&](const FieldDescriptor& f, std::string text) {
            if (f.name() == "start" || f.full_name() == "filum.proto.Field.components") return; // how things are cut
            if (f.cpp_type() == FieldDescriptor::CPPTYPE_STRING) text = text.substr(1, text.size() - 2);
            if (f.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) text = shortest_text(std::stod(text));
            if (f.cpp_type() == FieldDescriptor::CPPTYPE_BOOL) text = text == "true" ? "yes" : "no";
            if (f.cpp_type() == FieldDescriptor::CPPTYPE_ENUM && f.is_repeated()) // columns hold numbers
                text = std::to_string(f.enum_type()->FindValueByName(text)->number());
            if (f.cpp_type() == FieldDescriptor::CPPTYPE_ENUM)
                for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            const auto at = found.values.find(text);
            if (f.full_name() == "filum.proto.Field.name") {
                EXPECT_TRUE(found.names.contains(text) || found.names.contains(text + ".x")) << text;
            } else if (at == found.values.end()) {
                ADD_FAILURE() << f.full_name() << " " << text << " is lost";
            } else {
                found.values.erase(at); // each only once
            }
        });
    }
}

// The names of all fields in a message and those within it.
void each_field(const Descriptor* d, const std::function<void(const FieldDescriptor&)>& take) {
    for (int i = 0; i < d->field_count(); ++i) {
        take(*d->field(i));
        if (d->field(i)->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) each_field(d->field(i)->message_type(), take);
    }
}

// A field that is new in a message must be in frames() above; then this says whether records show it.
TEST(Record, NamesEveryFieldOfItsMessage) {
    const std::map<std::string, std::string> shown_as{
        {"filum.proto.Loops.start", "loop"},        {"filum.proto.Isolines.start", "isoline"},
        {"filum.proto.Surface.corner", "a"},        {"filum.proto.Surface.across", "ab"},
        {"filum.proto.Surface.fields", "distance"}, {"filum.proto.Field.name", "distance"},
        {"filum.proto.Field.value", "distance"},    {"filum.proto.Field.components", "stress.x.d1.z"}};
    for (const auto& raw : frames()) {
        Walk found;
        found(record(raw));
        const auto* kind = proto::Frame::descriptor()->FindFieldByNumber(static_cast<int>(raw.tag));
        EXPECT_TRUE(found.names.contains(kind->name()));
        each_field(kind->message_type(), [&](const FieldDescriptor& f) {
            const auto other = shown_as.find(f.full_name());
            const std::string name = other == shown_as.end() ? f.name() : other->second;
            EXPECT_TRUE(found.names.contains(name)) << f.full_name() << " is not shown";
        });
    }
}

const Entry& entry(const Record& r, const std::string& name) {
    for (const Entry& e : r.entries)
        if (e.name == name) return e;
    throw Error(Exit::failure, "no entry " + name);
}

std::vector<std::string> columns(const Entry& e) {
    std::vector<std::string> out;
    for (const Column& c : std::get<Table>(e.value)) out.push_back(c.name + " " + c.unit);
    return out;
}

TEST(Record, HasUnitsAndPutsValuesFirstThenTablesThenRecords) {
    const Record r = record(region_frame());
    std::vector<std::string> order;
    for (const Entry& e : r.entries) order.push_back(e.name + " " + e.unit);
    EXPECT_EQ(order, (std::vector<std::string>{
                         "id ",     "layer ",   "z mm",        "height mm", "area mm2", "parent ", "unsupported mm2",
                         "stroke ", "join ",    "inradius mm", "walls ",    "purpose ", "brim ",   "body ",
                         "tool ",   "width mm", "layers ",     "skipped ",  "loops ",   "below ",  "areas "}));
    EXPECT_TRUE(std::get<Word>(entry(r, "join").value).named);
    const auto& loops = std::get<std::vector<Record>>(entry(r, "loops").value);
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_EQ(loops[1].kind, "loop");
    EXPECT_EQ(columns(entry(loops[1], "points")), (std::vector<std::string>{"x mm", "y mm"}));
    EXPECT_EQ(std::get<Table>(entry(loops[1], "points").value)[1].values, (std::vector<double>{10.1, 10.3, 10.1}));
    const auto& below = std::get<std::vector<Record>>(entry(r, "below").value);
    ASSERT_EQ(below.size(), 2U);
    EXPECT_EQ(std::get<Word>(entry(below[0], "link").value).text, "yes");
}

// z is one for all on the wire and stands in every row; a height for all stands beside them.
TEST(Record, SpreadsWhatIsOneForAllPoints) {
    const Record r = record(span_frame());
    EXPECT_EQ(columns(entry(r, "points")),
              (std::vector<std::string>{"x mm", "y mm", "z mm", "width mm", "nx ", "ny ", "nz "}));
    EXPECT_EQ(std::get<Table>(entry(r, "points").value)[2].values, (std::vector<double>{6.5, 6.5}));
    EXPECT_EQ(std::get<double>(entry(r, "height").value), 0.2);
}

TEST(Record, CutsIsolinesAndSplitsVectors) {
    const Record r = record(surface_frame());
    EXPECT_EQ(columns(entry(r, "points")),
              (std::vector<std::string>{"x mm", "y mm", "z mm", "distance ", "stress.x.d1.x ", "stress.x.d1.y ",
                                        "stress.x.d1.z "}));
    EXPECT_EQ(std::get<Table>(entry(r, "points").value)[5].values, (std::vector<double>{0, 1, 0, 0}));
    EXPECT_EQ(columns(entry(r, "triangles")),
              (std::vector<std::string>{"a ", "b ", "c ", "ab ", "bc ", "ca ", "face "}));
    EXPECT_EQ(std::get<Table>(entry(r, "triangles").value)[4].values, (std::vector<double>{4, 0}));
    const auto& lines = std::get<std::vector<Record>>(entry(r, "isolines").value);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(std::get<double>(entry(lines[1], "level").value), 0.7);
    EXPECT_EQ(std::get<Word>(entry(lines[1], "closed").value).text, "yes");
    EXPECT_EQ(std::get<Table>(entry(lines[1], "points").value)[3].values, (std::vector<double>{0, 0, 1}));
    const auto& sources = std::get<std::vector<Record>>(entry(r, "sources").value);
    ASSERT_EQ(sources.size(), 1U);
    EXPECT_EQ(std::get<Table>(entry(sources[0], "vertices").value)[0].values, (std::vector<double>{2, 3}));
    EXPECT_EQ(std::get<Table>(entry(sources[0], "lines").value).size(), 7U);
}

TEST(Record, WhatIsMissingIsAnEmptyList) {
    surface::Sheet s;
    s.surface = surface::assemble({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}},
                                  {surface::kNone, surface::kNone, surface::kNone});
    const Record r = record(frame(s));
    EXPECT_TRUE(std::get<std::vector<Record>>(entry(r, "sources").value).empty());
    EXPECT_TRUE(std::get<std::vector<Record>>(entry(r, "isolines").value).empty());
}

TEST(Record, RefusesWhatReadersRefuse) {
    for (auto raw : frames()) {
        raw.body.resize(raw.body.size() - 1);
        EXPECT_THROW(record(raw), Error);
    }
    EXPECT_THROW(record({stream::Tag::header, ""}), Error);
}

} // namespace
} // namespace filum::wire
