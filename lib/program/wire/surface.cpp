#include "wire/surface.hpp"

#include "wire/checks.hpp"

#include "filum/stream.pb.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace filum::wire {

namespace {

using google::protobuf::RepeatedField;
using surface::kNone;

[[noreturn]] void bad_surface(const std::string& why) { bad_frame("surface", why); }

std::vector<geom::Vec3> space_points(const RepeatedField<double>& x, const RepeatedField<double>& y,
                                     const RepeatedField<double>& z) {
    if (x.size() != y.size() || x.size() != z.size()) bad_surface("x, y and z differ in number");
    std::vector<geom::Vec3> out(static_cast<std::size_t>(x.size()));
    bool fine = true;
    for (int i = 0; i < x.size(); ++i) {
        out[static_cast<std::size_t>(i)] = {x[i], y[i], z[i]};
        fine = fine && usable(x[i]) && usable(y[i]) && usable(z[i]);
    }
    if (!fine) bad_surface("a coordinate is not a number or beyond 1e8 mm");
    return out;
}

void put_points(std::span<const geom::Vec3> from, RepeatedField<double>& x, RepeatedField<double>& y,
                RepeatedField<double>& z) {
    for (RepeatedField<double>* field : {&x, &y, &z}) field->Reserve(field->size() + static_cast<int>(from.size()));
    for (const auto& p : from) {
        x.Add(p.x);
        y.Add(p.y);
        z.Add(p.z);
    }
}

surface::Surface connected(const proto::Surface& m) {
    const auto sides = static_cast<std::size_t>(m.corner_size());
    if (sides % 3 != 0) bad_surface("the corners are not three per triangle");
    std::vector<surface::Triangle> triangles(sides / 3);
    for (std::size_t i = 0; i < sides; ++i) triangles[i / 3][i % 3] = m.corner(static_cast<int>(i));
    std::vector<std::uint32_t> twin(m.across().begin(), m.across().end());
    for (auto& h : twin) h = h == 0 ? kNone : h - 1;
    try {
        return surface::assemble(space_points(m.x(), m.y(), m.z()), std::move(triangles), std::move(twin));
    } catch (const Error& e) {
        if (std::string(e.what()).starts_with("cannot")) throw;
        bad_surface(e.what());
    }
}

surface::Field field(const proto::Field& m, std::size_t vertices) {
    surface::Field out{m.name(), {m.value().begin(), m.value().end()}, std::max(1U, m.components())};
    if (out.components != 1 && out.components != 3) bad_surface("the values of a field must be numbers or vectors");
    if (out.values.size() != vertices * out.components) bad_surface("a field has not one value per vertex");
    if (std::any_of(out.values.begin(), out.values.end(), [](double v) { return std::isnan(v); }))
        bad_surface("a field's value is not a number");
    return out;
}

std::vector<surface::Isoline> isolines(const proto::Isolines& m, std::size_t triangles) {
    const auto all = space_points(m.x(), m.y(), m.z());
    const int n = m.level_size();
    if (m.closed_size() != n || (n > 0 && m.start_size() != n + 1) ||
        static_cast<std::size_t>(m.triangle_size()) != all.size())
        bad_surface("the arrays of its isolines differ in length");
    if (n == 0) {
        if (!all.empty() || m.start_size() > 1) bad_surface("isoline offsets are missing");
        return {};
    }
    if (m.start(0) != 0 || m.start(n) != all.size()) bad_surface("isoline offsets do not fit the points");
    std::vector<surface::Isoline> out(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        const std::uint32_t from = m.start(i), to = m.start(i + 1);
        if (to > all.size() || from > to || to - from < 2) bad_surface("an isoline has fewer than two points");
        if (!std::isfinite(m.level(i))) bad_surface("a level is not a number");
        auto& line = out[static_cast<std::size_t>(i)];
        line.level = m.level(i);
        line.closed = m.closed(i);
        line.points.assign(all.begin() + from, all.begin() + to);
        line.triangles.assign(m.triangle().begin() + static_cast<int>(from),
                              m.triangle().begin() + static_cast<int>(to));
        if (!line.closed) line.triangles.pop_back();
        for (const auto t : line.triangles)
            if (t >= triangles) bad_surface("an isoline crosses no triangle of the surface");
    }
    return out;
}

// Checks a name, because names become parts of file names and words of tables. Throws Error(bad_input).
std::string word(const std::string& text, const char* what) {
    const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-'; };
    if (text.size() > 64 || !std::all_of(text.begin(), text.end(), plain))
        bad_surface(std::string(what) + " is not a word of at most 64 letters, digits and '._-'");
    return text;
}

std::vector<std::uint32_t> faces(const proto::Surface& m, std::size_t triangles) {
    if (m.face_size() != 0 && static_cast<std::size_t>(m.face_size()) != triangles)
        bad_surface("it has not one face per triangle");
    return {m.face().begin(), m.face().end()};
}

surface::Sources sources(const proto::Sources& m, std::size_t vertices, std::size_t triangles) {
    surface::Sources out{{m.vertex().begin(), m.vertex().end()}, {}};
    const auto a = space_points(m.ax(), m.ay(), m.az()), b = space_points(m.bx(), m.by(), m.bz());
    const auto n = static_cast<std::size_t>(m.triangle_size());
    if (a.size() != n || b.size() != n) bad_surface("the arrays of its sources differ in length");
    for (std::size_t i = 0; i < n; ++i) out.segments.push_back({m.triangle(static_cast<int>(i)), a[i], b[i]});
    for (const auto v : out.vertices)
        if (v >= vertices) bad_surface("a source is no vertex of the surface");
    for (const auto& s : out.segments)
        if (s.triangle >= triangles) bad_surface("a source lies in no triangle of the surface");
    return out;
}

void put_sources(proto::Sources& m, const surface::Sources& sources) {
    m.mutable_vertex()->Add(sources.vertices.begin(), sources.vertices.end());
    for (const auto& s : sources.segments) {
        m.add_triangle(s.triangle);
        m.add_ax(s.a.x);
        m.add_ay(s.a.y);
        m.add_az(s.a.z);
        m.add_bx(s.b.x);
        m.add_by(s.b.y);
        m.add_bz(s.b.z);
    }
}

void put_isolines(proto::Isolines& m, const std::vector<surface::Isoline>& lines) {
    if (lines.empty()) return;
    m.add_start(0);
    for (const auto& line : lines) {
        m.add_level(line.level);
        m.add_closed(line.closed);
        put_points(line.points, *m.mutable_x(), *m.mutable_y(), *m.mutable_z());
        m.mutable_triangle()->Add(line.triangles.begin(), line.triangles.end());
        if (!line.closed) m.add_triangle(line.triangles.back());
        m.add_start(static_cast<std::uint32_t>(m.x_size()));
    }
}

} // namespace

surface::Sheet sheet(const stream::RawFrame& frame) {
    if (frame.tag != stream::Tag::surface) bad_surface("it is of another kind");
    proto::Surface m;
    if (!m.ParseFromArray(frame.body.data(), static_cast<int>(frame.body.size()))) bad_surface("malformed");
    surface::Sheet out;
    out.surface = connected(m);
    for (const auto& f : m.fields()) out.fields.push_back(field(f, out.surface.vertices.size()));
    out.isolines = isolines(m.isolines(), out.surface.triangles.size());
    out.sources = sources(m.sources(), out.surface.vertices.size(), out.surface.triangles.size());
    out.name = word(m.name(), "its name");
    out.algorithm = word(m.algorithm(), "its algorithm");
    out.faces = faces(m, out.surface.triangles.size());
    if (!out.isolines.empty() && out.fields.empty()) bad_surface("it has isolines of no field");
    return out;
}

stream::RawFrame frame(const surface::Sheet& sheet) {
    proto::Surface m;
    put_points(sheet.surface.vertices, *m.mutable_x(), *m.mutable_y(), *m.mutable_z());
    for (const auto& t : sheet.surface.triangles) m.mutable_corner()->Add(t.begin(), t.end());
    m.mutable_across()->Reserve(static_cast<int>(sheet.surface.twin.size()));
    for (const auto h : sheet.surface.twin) m.mutable_across()->AddAlreadyReserved(h == kNone ? 0 : h + 1);
    for (const auto& f : sheet.fields) {
        auto* to = m.add_fields();
        to->set_name(f.name);
        to->mutable_value()->Add(f.values.begin(), f.values.end());
        if (f.components != 1) to->set_components(f.components);
    }
    if (!sheet.sources.empty()) put_sources(*m.mutable_sources(), sheet.sources);
    put_isolines(*m.mutable_isolines(), sheet.isolines);
    m.set_name(sheet.name);
    m.set_algorithm(sheet.algorithm);
    m.mutable_face()->Add(sheet.faces.begin(), sheet.faces.end());
    if (m.ByteSizeLong() > stream::kMaxFrame)
        throw Error(Exit::failure, "cannot write a surface of more than 64 MiB; remesh it coarser, or ask for fewer "
                                   "isolines");
    return {stream::Tag::surface, m.SerializeAsString()};
}

} // namespace filum::wire
