#include "stressfield/elements.hpp"

#include <algorithm>

namespace filum::stressfield {

namespace {

using Face = std::vector<std::uint8_t>; // corners, then the middles of its sides if it has any

struct ElementForm {
    std::size_t corners = 0, nodes = 0;
    bool solid = true;
    std::vector<Face> faces;
    double corner = 0, edge = 0, upright = 0; // weights of the middle; `upright`: of the last three edges of a wedge
};

using Edges = std::vector<std::array<std::uint8_t, 2>>;

// Adds the midpoints of edges to a shape and its faces.
ElementForm with_middles(ElementForm form, const Edges& edges) {
    form.nodes = form.corners + edges.size();
    for (Face& face : form.faces) {
        const std::size_t n = face.size();
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t e = 0; e < edges.size(); ++e) {
                const auto a = face[k], b = face[(k + 1) % n];
                if ((edges[e][0] == a && edges[e][1] == b) || (edges[e][0] == b && edges[e][1] == a))
                    face.push_back(static_cast<std::uint8_t>(form.corners + e));
            }
    }
    return form;
}

// By Shape. Weights of the middle are the shape functions of serendipity elements (Zienkiewicz & Taylor).
const std::vector<ElementForm>& forms() {
    static const std::vector<ElementForm> all = [] {
        const ElementForm tet{4, 4, true, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, 0.25};
        const ElementForm hex{
            8, 8, true, {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}, 0.125};
        const ElementForm wedge{6, 6, true, {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}, 1.0 / 6};
        const ElementForm pyramid{5, 5, true, {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, 0.2};
        const ElementForm triangle{3, 3, false, {{0, 1, 2}}}, quad{4, 4, false, {{0, 1, 2, 3}}};
        const Edges of_tet = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
        const Edges of_hex = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                              {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
        const Edges of_wedge = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
        ElementForm tet10 = with_middles(tet, of_tet), hex20 = with_middles(hex, of_hex);
        ElementForm wedge15 = with_middles(wedge, of_wedge);
        tet10.corner = -1.0 / 8;
        tet10.edge = 1.0 / 4;
        hex20.corner = -1.0 / 4;
        hex20.edge = 1.0 / 4;
        wedge15.corner = -2.0 / 9;
        wedge15.edge = 2.0 / 9;
        wedge15.upright = 1.0 / 3;
        return std::vector<ElementForm>{tet,
                                        tet10,
                                        hex,
                                        hex20,
                                        wedge,
                                        wedge15,
                                        pyramid,
                                        triangle,
                                        with_middles(triangle, {{0, 1}, {1, 2}, {2, 0}}),
                                        quad,
                                        with_middles(quad, {{0, 1}, {1, 2}, {2, 3}, {3, 0}})};
    }();
    return all;
}

const ElementForm& form_of(Shape shape) { return forms()[static_cast<std::size_t>(shape)]; }

// Two triangles, divided at the corner of least index.
void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::vector<Triangle>& out) {
    if (std::min(a, c) < std::min(b, d)) {
        out.push_back({a, b, c});
        out.push_back({a, c, d});
    } else {
        out.push_back({b, c, d});
        out.push_back({b, d, a});
    }
}

void add_face(std::span<const std::uint32_t> n, const Face& face, bool middles, std::vector<Triangle>& out) {
    const std::size_t sides = middles ? face.size() / 2 : face.size();
    const auto corner = [&](std::size_t k) { return n[face[k % sides]]; };
    const auto middle = [&](std::size_t k) { return n[face[sides + k % sides]]; };
    if (middles)
        for (std::size_t k = 0; k < sides; ++k) out.push_back({corner(k), middle(k), middle(k + sides - 1)});
    if (sides == 4 && middles) add_quad(middle(0), middle(1), middle(2), middle(3), out);
    if (sides == 4 && !middles) add_quad(corner(0), corner(1), corner(2), corner(3), out);
    if (sides == 3 && middles) out.push_back({middle(0), middle(1), middle(2)});
    if (sides == 3 && !middles) out.push_back({corner(0), corner(1), corner(2)});
}

// A face of a solid element: its corners, sorted; a three-sided one has a placeholder last.
struct Side {
    std::array<std::uint32_t, 4> corners;
    std::uint32_t element;
    std::uint8_t face;
};

std::array<std::uint32_t, 4> corners_of(std::span<const std::uint32_t> n, const Face& face, bool middles) {
    std::array<std::uint32_t, 4> out;
    out.fill(~std::uint32_t{0});
    const std::size_t sides = middles ? face.size() / 2 : face.size();
    for (std::size_t k = 0; k < sides; ++k) out[k] = n[face[k]];
    std::sort(out.begin(), out.end());
    return out;
}

// Calls visit(side) for every face of a solid element.
template <class Visit>
void each_side(const Samples& samples, const Visit& visit) {
    for (std::uint32_t e = 0; e < samples.elements.size(); ++e) {
        const ElementForm& form = form_of(samples.elements[e].shape);
        if (!form.solid) continue;
        const auto n = nodes_of(samples, samples.elements[e]);
        for (std::uint8_t f = 0; f < form.faces.size(); ++f)
            visit(Side{corners_of(n, form.faces[f], form.nodes > form.corners), e, f});
    }
}

// Groups the faces by their first corner: those of node i are in [start[i], start[i + 1]).
void group(const Samples& samples, std::vector<Side>& sides, std::vector<std::uint32_t>& start) {
    start.assign(samples.points.size() + 1, 0);
    each_side(samples, [&](const Side& s) { ++start[s.corners[0] + 1]; });
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    sides.resize(start.back());
    std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
    each_side(samples, [&](const Side& s) { sides[at[s.corners[0]]++] = s; });
}

Vec3 mean(const Samples& s, std::span<const std::uint32_t> nodes) {
    Vec3 out;
    for (const auto i : nodes) out = out + s.points[i];
    return (1 / static_cast<double>(nodes.size())) * out;
}

void add_outer(const Samples& s, const Side& side, Skin& out) {
    const Element& element = s.elements[side.element];
    const ElementForm& form = form_of(element.shape);
    const auto n = nodes_of(s, element);
    const std::size_t first = out.triangles.size();
    add_face(n, form.faces[side.face], form.nodes > form.corners, out.triangles);
    const Vec3 inside = mean(s, n.first(form.corners));
    for (std::size_t t = first; t < out.triangles.size(); ++t) {
        Triangle& tri = out.triangles[t];
        const Vec3 a = s.points[tri[0]], b = s.points[tri[1]], c = s.points[tri[2]];
        if (dot(cross(b - a, c - a), a - inside) < 0) std::swap(tri[1], tri[2]);
    }
}

} // namespace

std::size_t node_count(Shape shape) { return form_of(shape).nodes; }

bool is_solid(Shape shape) { return form_of(shape).solid; }

void triangles_of(const Samples& samples, const Element& element, std::vector<Triangle>& out) {
    const ElementForm& form = form_of(element.shape);
    for (const Face& face : form.faces) add_face(nodes_of(samples, element), face, form.nodes > form.corners, out);
}

void middle_weights(Shape shape, std::vector<double>& out) {
    const ElementForm& form = form_of(shape);
    out.assign(form.nodes, form.edge);
    std::fill_n(out.begin(), form.corners, form.corner);
    if (form.upright != 0) std::fill(out.end() - 3, out.end(), form.upright);
}

Skin skin(const Samples& samples) {
    std::vector<Side> sides;
    std::vector<std::uint32_t> start;
    group(samples, sides, start);
    Skin out;
    for (std::size_t i = 0; i < samples.points.size(); ++i)
        for (std::uint32_t a = start[i]; a < start[i + 1]; ++a) {
            bool alone = true;
            for (std::uint32_t b = start[i]; alone && b < start[i + 1]; ++b)
                alone = a == b || sides[a].corners != sides[b].corners;
            if (alone) add_outer(samples, sides[a], out);
        }
    out.shell.assign(out.triangles.size(), false);
    for (const Element& e : samples.elements)
        if (!is_solid(e.shape)) triangles_of(samples, e, out.triangles);
    out.shell.resize(out.triangles.size(), true);
    return out;
}

} // namespace filum::stressfield
