#include "wire/planar.hpp"

#include "base/density.hpp"
#include "geom/polyline.hpp"
#include "polygon/stack.hpp"
#include "wire/checks.hpp"
#include "wire/features.hpp"
#include "wire/owner.hpp"

#include "filum/stream.pb.h"

#include <cmath>

namespace filum::wire {

namespace {

using google::protobuf::RepeatedField;
using stream::RawFrame;
using stream::Tag;

template <class Message>
Message parse(const RawFrame& frame, Tag tag, const char* what) {
    if (frame.tag != tag) bad_frame(what, "it is of another kind");
    Message m;
    if (!m.ParseFromArray(frame.body.data(), static_cast<int>(frame.body.size()))) bad_frame(what, "malformed");
    return m;
}

template <class Message>
RawFrame raw(Tag tag, const Message& m) {
    if (m.ByteSizeLong() > stream::kMaxFrame)
        throw Error(Exit::failure, "cannot write a frame of more than 64 MiB; a single layer is too large");
    return {tag, m.SerializeAsString()};
}

std::vector<geom::Vec2> plane_points(const RepeatedField<double>& x, const RepeatedField<double>& y, const char* what) {
    if (x.size() != y.size()) bad_frame(what, "x and y differ in number");
    std::vector<geom::Vec2> out(static_cast<std::size_t>(x.size()));
    bool fine = true;
    for (int i = 0; i < x.size(); ++i) {
        out[static_cast<std::size_t>(i)] = {x[i], y[i]};
        fine = fine && usable(x[i]) && usable(y[i]);
    }
    if (!fine) bad_frame(what, "a coordinate is not a number or beyond 1e8 mm");
    return out;
}

polygon::Loops loops(const proto::Loops& m, const char* what) {
    polygon::Loops out;
    out.points = plane_points(m.x(), m.y(), what);
    if (m.start_size() == 0) {
        if (!out.points.empty()) bad_frame(what, "loop offsets are missing");
        return out;
    }
    out.start.assign(m.start().begin(), m.start().end());
    if (out.start.front() != 0 || out.start.back() != out.points.size())
        bad_frame(what, "loop offsets do not fit the points");
    for (std::size_t i = 1; i < out.start.size(); ++i)
        if (out.start[i] < out.start[i - 1] || out.start[i] - out.start[i - 1] < 3)
            bad_frame(what, "a loop has fewer than three points");
    return out;
}

// The loops of an area. Throws Error(bad_input) unless outer loops are counter-clockwise, holes clockwise, and none
// cross.
polygon::Loops area_loops(const proto::Loops& m, const char* outline) {
    polygon::Loops out = loops(m, "region");
    if (const std::string fault = polygon::fault(out); !fault.empty())
        bad_frame("region", std::string(outline) + ": " + fault);
    return out;
}

void put_loops(proto::Loops& m, const polygon::Loops& loops) {
    m.mutable_x()->Reserve(static_cast<int>(loops.points.size()));
    m.mutable_y()->Reserve(static_cast<int>(loops.points.size()));
    for (const auto p : loops.points) {
        m.mutable_x()->AddAlreadyReserved(p.x);
        m.mutable_y()->AddAlreadyReserved(p.y);
    }
    m.mutable_start()->Add(loops.start.begin(), loops.start.end());
}

// An array of positive numbers up to kMaxBead, one per point or one for all points. Throws Error(bad_input) for others.
std::vector<double> per_point(const RepeatedField<double>& v, std::size_t n, const char* what, const char* name) {
    const auto size = static_cast<std::size_t>(v.size());
    if (size != 1 && size != n)
        bad_frame(what, std::string(name) + " must have one entry for all points, or one per point");
    for (const double value : v)
        if (!(value > 0 && value <= kMaxBead))
            bad_frame(what, std::string(name) + " is not between 0 and 10 m, as of a bead");
    return {v.begin(), v.end()};
}

void put_numbers(RepeatedField<double>& to, const std::vector<double>& from) { to.Add(from.begin(), from.end()); }

// Throws Error(bad_input) if the beads of a region are too long. Time and memory of later stages grow with the number
// of squares of the mean bead width along them.
void check_beads(const toolpath::RegionPaths& paths) {
    double length = 0, area = 0;
    for (const auto& c : paths.curves)
        for (std::size_t i = c.closed ? 0 : 1, n = c.points.size(); i < n; ++i) {
            const std::size_t before = i == 0 ? n - 1 : i - 1;
            const double l = geom::distance(c.points[before], c.points[i]);
            length += l;
            area += l * c.width_at(i);
        }
    if (length * length > kMostSquares * area)
        bad_frame("paths", "its beads hold more than 10 million squares of their width");
    double stacked = 0;
    for (const auto& line : paths.stacked) stacked += geom::length(line);
    if (stacked > kLongestSpan) bad_frame("paths", "its middle lines of walls are longer than 10 km");
}

Join join(int value, const char* what) {
    if (value < 0 || value > 2) bad_frame(what, "unknown join");
    return static_cast<Join>(value);
}

polygon::Area area(const proto::Area& m) {
    if (m.kind() < 0 || m.kind() > 4) bad_frame("region", "unknown kind of area");
    if (m.pattern() < 0 || m.pattern() > 2) bad_frame("region", "unknown pattern");
    polygon::Area out{static_cast<polygon::AreaKind>(m.kind()),
                      area_loops(m.loops(), "the outline of an area"),
                      m.direction(),
                      m.spacing(),
                      static_cast<polygon::InfillPattern>(m.pattern()),
                      m.gap(),
                      m.walls(),
                      m.width(),
                      m.solid()};
    if (!usable(out.direction)) bad_frame("region", "a direction is not a number");
    const bool sparse = out.kind == polygon::AreaKind::sparse;
    if (!usable(out.spacing) || out.spacing < 0 || (sparse && out.spacing == 0))
        bad_frame("region", "the spacing of an area is not positive");
    if (!usable(out.gap) || out.gap < 0) bad_frame("region", "the gap of an area is negative");
    if (!is_size(out.width) || !is_size(out.solid) || (out.kind == polygon::AreaKind::zone && out.width == 0))
        bad_frame("region", "the width of the beads of an area is not positive");
    return out;
}

void put_area(proto::Area& m, const polygon::Area& area) {
    m.set_kind(static_cast<proto::AreaKind>(area.kind));
    put_loops(*m.mutable_loops(), area.loops);
    m.set_direction(area.direction);
    m.set_spacing(area.spacing);
    m.set_pattern(static_cast<proto::Pattern>(area.pattern));
    m.set_gap(area.gap);
    m.set_walls(area.walls);
    m.set_width(area.width);
    m.set_solid(area.solid);
}

} // namespace

polygon::Layer layer(const RawFrame& frame) {
    const auto m = parse<proto::Layer>(frame, Tag::layer, "layer");
    check_height(m.z(), m.height(), "layer");
    if (!usable(m.plane())) bad_frame("layer", "its plane is not a number");
    polygon::Layer out{m.index(), m.z(), m.height(), m.plane(), loops(m.contours(), "layer")};
    read_owner(m, out, "layer");
    return out;
}

RawFrame frame(const polygon::Layer& layer) {
    proto::Layer m;
    m.set_index(layer.index);
    m.set_z(layer.z);
    m.set_height(layer.height);
    m.set_plane(layer.plane);
    put_loops(*m.mutable_contours(), layer.contours);
    put_owner(layer, m);
    return raw(Tag::layer, m);
}

polygon::Region region(const RawFrame& frame) {
    const auto m = parse<proto::Region>(frame, Tag::region, "region");
    check_height(m.z(), m.height(), "region");
    polygon::Region out;
    out.id = m.id();
    out.layer = m.layer();
    out.z = m.z();
    out.height = m.height();
    out.loops = area_loops(m.loops(), "its outline");
    if (out.loops.empty()) bad_frame("region", "it has no outline");
    out.area = m.area();
    out.parent = m.parent();
    out.unsupported = m.unsupported();
    out.stroke = m.stroke();
    out.join = join(m.join(), "region");
    out.inradius = m.inradius();
    out.box = polygon::bounds(out.loops[0]);
    if (!(out.area > 0) || !std::isfinite(out.area)) bad_frame("region", "its area is not positive");
    if (!is_size(out.unsupported) || !is_size(out.inradius))
        bad_frame("region", "its unsupported area or its inradius is negative or not a number");
    for (const auto& o : m.below()) {
        if (!is_size(o.area()) || !is_size(o.inradius())) bad_frame("region", "an overlap is negative or not a number");
        out.below.push_back({o.below(), o.area(), o.inradius(), o.link()});
    }
    for (const auto& a : m.areas()) out.areas.push_back(area(a));
    out.walls = m.walls();
    if (m.purpose() < 0 || m.purpose() > 2) bad_frame("region", "unknown purpose");
    out.is = static_cast<polygon::RegionClass>(m.purpose());
    out.brim = m.has_brim() ? m.brim() : -1;
    read_owner(m, out, "region");
    return out;
}

RawFrame frame(const polygon::Region& region) {
    proto::Region m;
    m.set_id(region.id);
    m.set_layer(region.layer);
    m.set_z(region.z);
    m.set_height(region.height);
    put_loops(*m.mutable_loops(), region.loops);
    m.set_area(region.area);
    m.set_parent(region.parent);
    for (const auto& o : region.below) {
        auto* b = m.add_below();
        b->set_below(o.below);
        b->set_area(o.area);
        b->set_inradius(o.inradius);
        b->set_link(o.link);
    }
    m.set_unsupported(region.unsupported);
    m.set_stroke(region.stroke);
    m.set_join(static_cast<proto::Join>(region.join));
    m.set_inradius(region.inradius);
    for (const auto& a : region.areas) put_area(*m.add_areas(), a);
    m.set_walls(region.walls);
    m.set_purpose(static_cast<proto::RegionClass>(region.is));
    m.set_brim(region.brim);
    put_owner(region, m);
    return raw(Tag::region, m);
}

toolpath::RegionPaths paths(const RawFrame& frame) {
    const auto m = parse<proto::RegionPaths>(frame, Tag::paths, "paths");
    check_height(m.z(), m.height(), "paths");
    toolpath::RegionPaths out;
    out.region = m.region();
    out.layer = m.layer();
    out.z = m.z();
    out.height = m.height();
    out.area = m.area();
    out.stroke = m.stroke();
    out.join = join(m.join(), "paths");
    out.unplaced = m.unplaced();
    if (!is_size(out.area) || !is_size(out.unplaced)) bad_frame("paths", "an area is negative or not a number");
    out.curves.reserve(static_cast<std::size_t>(m.curves_size()));
    for (const auto& c : m.curves()) {
        toolpath::Curve curve{c.closed(), plane_points(c.x(), c.y(), "paths"), {}, {}};
        if (curve.points.size() < 2) bad_frame("paths", "a curve has fewer than two points");
        curve.width = per_point(c.width(), curve.points.size(), "paths", "width");
        curve.feature = features(c, curve.points.size());
        curve.over_air = over_air(c, curve.points.size());
        out.curves.push_back(std::move(curve));
    }
    for (const auto& line : m.stacked()) {
        out.stacked.push_back(plane_points(line.x(), line.y(), "paths"));
        if (out.stacked.back().size() < 2) bad_frame("paths", "a line has fewer than two points");
    }
    check_beads(out);
    read_owner(m, out, "paths");
    return out;
}

RawFrame frame(const toolpath::RegionPaths& paths) {
    proto::RegionPaths m;
    m.set_region(paths.region);
    m.set_layer(paths.layer);
    m.set_z(paths.z);
    m.set_height(paths.height);
    m.set_area(paths.area);
    m.set_stroke(paths.stroke);
    m.set_join(static_cast<proto::Join>(paths.join));
    m.set_unplaced(paths.unplaced);
    put_owner(paths, m);
    for (const auto& curve : paths.curves) {
        auto* c = m.add_curves();
        c->set_closed(curve.closed);
        c->mutable_x()->Reserve(static_cast<int>(curve.points.size()));
        c->mutable_y()->Reserve(static_cast<int>(curve.points.size()));
        for (const auto p : curve.points) {
            c->mutable_x()->AddAlreadyReserved(p.x);
            c->mutable_y()->AddAlreadyReserved(p.y);
        }
        put_numbers(*c->mutable_width(), curve.width);
        for (const auto f : curve.feature) c->add_feature(static_cast<proto::Feature>(f));
        c->mutable_over_air()->Add(curve.over_air.begin(), curve.over_air.end());
    }
    for (const auto& line : paths.stacked) {
        auto* l = m.add_stacked();
        for (const auto p : line) {
            l->add_x(p.x);
            l->add_y(p.y);
        }
    }
    return raw(Tag::paths, m);
}

namespace {

std::vector<geom::Vec3> normals(const proto::Span& m, std::size_t points) {
    const auto n = static_cast<std::size_t>(m.nx_size());
    if (static_cast<std::size_t>(m.ny_size()) != n || static_cast<std::size_t>(m.nz_size()) != n)
        bad_frame("span", "the parts of its normals differ in number");
    if (n != 0 && n != points) bad_frame("span", "normals must be none, or one per point");
    std::vector<geom::Vec3> out(n);
    for (std::size_t i = 0; i < n; ++i) {
        const int k = static_cast<int>(i);
        out[i] = {m.nx(k), m.ny(k), m.nz(k)};
        if (!(std::abs(geom::dot(out[i], out[i]) - 1) <= 1e-6)) bad_frame("span", "a normal has not length 1");
    }
    return out;
}

} // namespace

toolpath::Span span(const RawFrame& frame) {
    const auto m = parse<proto::Span>(frame, Tag::span, "span");
    if (m.role() < 0 || m.role() > 5) bad_frame("span", "unknown role");
    toolpath::Span out;
    out.role = static_cast<toolpath::Role>(m.role());
    out.stroke = m.stroke();
    out.layer = m.layer();
    out.region = m.region();
    const auto xy = plane_points(m.x(), m.y(), "span");
    if (xy.size() < 2) bad_frame("span", "it has fewer than two points");
    const auto zs = static_cast<std::size_t>(m.z_size());
    if (zs != 1 && zs != xy.size()) bad_frame("span", "z must be one for all points, or one per point");
    out.points.reserve(xy.size());
    for (std::size_t i = 0; i < xy.size(); ++i) {
        const double z = m.z(static_cast<int>(zs == 1 ? 0 : i));
        if (!usable(z)) bad_frame("span", "a coordinate is not a number or beyond 1e8 mm");
        out.points.push_back({xy[i].x, xy[i].y, z});
    }
    if (toolpath::extrudes(out.role)) {
        if (geom::length(out.points) > kLongestSpan) bad_frame("span", "its beads are longer than 10 km");
        out.width = per_point(m.width(), xy.size(), "span", "width");
        out.height = per_point(m.height(), xy.size(), "span", "height");
    } else if (m.width_size() + m.height_size() > 0) {
        bad_frame("span", "a travel has a bead");
    }
    out.normals = normals(m, xy.size());
    read_owner(m, out, "span");
    if (m.retraction() < 0 || m.retraction() > 2) bad_frame("span", "unknown retraction");
    out.retraction = static_cast<toolpath::Retraction>(m.retraction());
    out.feature = feature(m.feature(), "span");
    out.over_air = percent_over_air(m.over_air(), "span");
    return out;
}

RawFrame frame(const toolpath::Span& span) {
    proto::Span m;
    m.set_role(static_cast<proto::Role>(span.role));
    m.set_stroke(span.stroke);
    m.set_layer(span.layer);
    m.set_region(span.region);
    put_owner(span, m);
    m.set_retraction(static_cast<proto::Retraction>(span.retraction));
    m.set_feature(static_cast<proto::Feature>(span.feature));
    m.set_over_air(span.over_air);
    const auto n = static_cast<int>(span.points.size());
    m.mutable_x()->Reserve(n);
    m.mutable_y()->Reserve(n);
    bool level = true;
    for (const auto& p : span.points) {
        m.mutable_x()->AddAlreadyReserved(p.x);
        m.mutable_y()->AddAlreadyReserved(p.y);
        level = level && p.z == span.points.front().z;
    }
    if (level && n > 0)
        m.add_z(span.points.front().z);
    else
        for (const auto& p : span.points) m.add_z(p.z);
    put_numbers(*m.mutable_width(), span.width);
    put_numbers(*m.mutable_height(), span.height);
    for (const auto& v : span.normals) {
        m.add_nx(v.x);
        m.add_ny(v.y);
        m.add_nz(v.z);
    }
    return raw(Tag::span, m);
}

} // namespace filum::wire
