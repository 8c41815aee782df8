#include "show/record.hpp"

#include "base/error.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <span>

namespace filum::show {

namespace {

constexpr const char* kJoins[] = {"start", "vertical", "beside"};
constexpr const char* kRoles[] = {"bead", "lift", "jog", "connector", "travel", "hairpin"};

std::int64_t whole(std::uint64_t v) { return static_cast<std::int64_t>(v); }

Table columns(std::span<const geom::Vec2> points) {
    std::vector<double> x, y;
    for (const auto p : points) x.push_back(p.x), y.push_back(p.y);
    return {{"x", std::move(x)}, {"y", std::move(y)}};
}

// Adds `values` as a column if there is one per point, else as a number.
void add_values(Record& record, Table& table, const char* name, const std::vector<double>& values) {
    if (values.size() == 1)
        record.fields.emplace_back(name, values[0]);
    else if (!values.empty())
        table.emplace_back(name, values);
}

std::vector<Record> loops(const polygon::Loops& loops) {
    std::vector<Record> out;
    for (std::size_t i = 0; i < loops.size(); ++i) out.push_back({"loop", {{"points", columns(loops[i])}}});
    return out;
}

Record record(const polygon::Layer& l) {
    return {"layer",
            {{"index", whole(l.index)},
             {"z", l.z},
             {"height", l.height},
             {"plane", l.plane},
             {"contours", loops(l.contours)}}};
}

Record record(const polygon::Region& r) {
    std::vector<Record> below;
    for (const auto& o : r.below)
        below.push_back({"overlap", {{"below", whole(o.below)}, {"area", o.area}, {"inradius", o.inradius}}});
    return {"region",
            {{"id", whole(r.id)},
             {"layer", whole(r.layer)},
             {"z", r.z},
             {"height", r.height},
             {"area", r.area},
             {"unsupported", r.unsupported},
             {"parent", r.parent},
             {"stroke", whole(r.stroke)},
             {"join", kJoins[static_cast<std::size_t>(r.join)]},
             {"below", std::move(below)},
             {"loops", loops(r.loops)}}};
}

Record record(const toolpath::Curve& c) {
    Record out{"curve", {{"closed", c.closed ? "yes" : "no"}}};
    Table table = columns(c.points);
    add_values(out, table, "width", c.width);
    out.fields.emplace_back("points", std::move(table));
    return out;
}

Record record(const toolpath::RegionPaths& p) {
    std::vector<Record> curves;
    for (const auto& c : p.curves) curves.push_back(record(c));
    Record out{"paths",
               {{"region", whole(p.region)},
                {"layer", whole(p.layer)},
                {"z", p.z},
                {"height", p.height},
                {"area", p.area},
                {"unplaced", p.unplaced},
                {"stroke", whole(p.stroke)},
                {"join", kJoins[static_cast<std::size_t>(p.join)]},
                {"curves", std::move(curves)}}};
    std::vector<Record> stacked;
    for (const auto& line : p.stacked) stacked.push_back({"line", {{"points", columns(line)}}});
    if (!stacked.empty()) out.fields.emplace_back("stacked", std::move(stacked));
    return out;
}

Record record(const toolpath::Span& s) {
    Record out{"span",
               {{"role", kRoles[static_cast<std::size_t>(s.role)]},
                {"stroke", whole(s.stroke)},
                {"layer", whole(s.layer)},
                {"region", whole(s.region)}}};
    if (s.tool != 0) out.fields.emplace_back("tool", whole(s.tool));
    std::vector<double> x, y, z;
    for (const auto& p : s.points) x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
    Table table{{"x", std::move(x)}, {"y", std::move(y)}, {"z", std::move(z)}};
    add_values(out, table, "width", s.width);
    add_values(out, table, "height", s.height);
    if (!s.normals.empty()) {
        std::vector<double> nx, ny, nz;
        for (const auto& v : s.normals) nx.push_back(v.x), ny.push_back(v.y), nz.push_back(v.z);
        table.emplace_back("nx", std::move(nx)), table.emplace_back("ny", std::move(ny));
        table.emplace_back("nz", std::move(nz));
    }
    out.fields.emplace_back("points", std::move(table));
    return out;
}

Table columns(std::span<const geom::Vec3> points) {
    std::vector<double> x, y, z;
    for (const auto& p : points) x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
    return {{"x", std::move(x)}, {"y", std::move(y)}, {"z", std::move(z)}};
}

Record record(const surface::Surface& s, const surface::Rim& rim) {
    return {"rim",
            {{"component", whole(rim.component)},
             {"outer", rim.outer ? "yes" : "no"},
             {"sides", whole(rim.sides.size())},
             {"length", surface::rim_length(s, rim)}}};
}

Record record(const surface::Isoline& line) {
    return {"isoline",
            {{"level", line.level}, {"closed", line.closed ? "yes" : "no"}, {"points", columns(line.points)}}};
}

// A column, or three, named as their axes.
void add_field(Table& table, const surface::Field& f) {
    for (std::uint32_t c = 0; c < f.components; ++c) {
        std::vector<double> column;
        for (std::size_t i = c; i < f.values.size(); i += f.components) column.push_back(f.values[i]);
        table.emplace_back(f.components == 1 ? f.name : f.name + "." + "xyz"[c], std::move(column));
    }
}

// Vertices with their fields as columns.
Record record(const surface::Sheet& sheet) {
    const surface::Surface& s = sheet.surface;
    std::vector<Record> rims, lines;
    for (const auto& rim : s.rims) rims.push_back(record(s, rim));
    for (const auto& line : sheet.isolines) lines.push_back(record(line));
    Table table = columns(s.vertices);
    for (const auto& f : sheet.fields) add_field(table, f);
    std::vector<double> a, b, c;
    for (const auto& t : s.triangles) a.push_back(t[0]), b.push_back(t[1]), c.push_back(t[2]);
    Table triangles{{"a", std::move(a)}, {"b", std::move(b)}, {"c", std::move(c)}};
    if (!sheet.faces.empty())
        triangles.emplace_back("face", std::vector<double>(sheet.faces.begin(), sheet.faces.end()));
    return {"surface",
            {{"name", sheet.name},
             {"algorithm", sheet.algorithm},
             {"components", whole(s.components)},
             {"area", surface::area(s)},
             {"points", std::move(table)},
             {"triangles", std::move(triangles)},
             {"rims", std::move(rims)},
             {"isolines", std::move(lines)}}};
}

Record record(const Note& n) {
    Record out{"note",
               {{"stage", n.stage},
                {"what", n.what},
                {"amount", n.amount},
                {"unit", n.unit},
                {"count", whole(n.count)},
                {"layer", n.layer},
                {"x", n.x},
                {"y", n.y}}};
    if (std::isfinite(n.z)) out.fields.push_back({"z", n.z});
    return out;
}

Record record(const Fact& f) {
    return {"fact", {{"stage", f.stage}, {"name", f.name}, {"value", f.value}, {"unit", f.unit}}};
}

} // namespace

Record record(const stream::RawFrame& frame) {
    switch (frame.tag) {
    case stream::Tag::note:
        return record(stream::parse_note(frame.body));
    case stream::Tag::fact:
        return record(stream::parse_fact(frame.body));
    case stream::Tag::layer:
        return record(wire::layer(frame));
    case stream::Tag::region:
        return record(wire::region(frame));
    case stream::Tag::paths:
        return record(wire::paths(frame));
    case stream::Tag::span:
        return record(wire::span(frame));
    case stream::Tag::surface:
        return record(wire::sheet(frame));
    case stream::Tag::header:
    case stream::Tag::end:
        break;
    }
    throw Error(Exit::failure, "internal error: no record for frames with the tag " +
                                   std::to_string(static_cast<std::uint32_t>(frame.tag)));
}

} // namespace filum::show
