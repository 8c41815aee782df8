#include "mesh/sheets.hpp"

#include "geom/disjoint_sets.hpp"
#include "mesh/formats.hpp"
#include "mesh/sides.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>

namespace filum::mesh {

namespace {

constexpr std::size_t kLargeFan = 12; // from this number of triangles round a vertex on, they are sorted
constexpr double kSameAngle = 1e-6; // rad: two triangles on an edge with a smaller angle between them lie on each other

// The triangles round one vertex, each as its next and its previous vertex.
struct Corner {
    std::uint32_t next, last;
};

// True if the triangles form one fan in which no side occurs twice; also true for no triangles. Two triangles that come
// from the same vertex are no fan, as the walk could enter a ring without its first triangle.
bool is_fan(std::span<Corner> around) {
    if (around.empty()) return true;
    const bool large = around.size() > kLargeFan;
    if (large)
        std::sort(around.begin(), around.end(), [](const Corner& a, const Corner& b) { return a.next < b.next; });
    const auto from = [&](std::uint32_t v) {
        const auto first =
            large ? std::partition_point(around.begin(), around.end(), [&](const Corner& c) { return c.next < v; })
                  : around.begin();
        const auto found = std::find_if(first, large && first != around.end() ? first + 1 : around.end(),
                                        [&](const Corner& c) { return c.next == v; });
        return found != around.end() && found->next == v ? found : around.end();
    };
    for (auto a = around.begin(); a != around.end(); ++a)
        if (from(a->next) != a) return false;
    std::size_t passed = 1;
    auto at = from(around[0].last);
    for (; at != around.end() && at != around.begin(); at = from(at->last))
        if (++passed > around.size()) return false;
    return at == around.end() || passed == around.size();
}

// True if every vertex has one fan, so that nothing needs to be split.
bool is_plain(const Mesh& mesh) {
    std::vector<std::uint32_t> start(mesh.vertices.size() + 2, 0);
    std::vector<Corner> corners(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t) ++start[v + 2];
    for (std::size_t v = 2; v < start.size(); ++v) start[v] += start[v - 1];
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) corners[start[t[k] + 1]++] = {t[(k + 1) % 3], t[(k + 2) % 3]};
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (!is_fan({corners.data() + start[v], corners.data() + start[v + 1]})) return false;
    return true;
}

// The three vertices, lowest first, and whether sorting them reversed the orientation.
struct Face {
    std::array<std::uint32_t, 3> corners{};
    bool turned = false;
    std::uint32_t triangle = 0;
};

// All triangles, ordered by corners, then by number.
std::vector<Face> faces_of(const Mesh& mesh) {
    std::vector<Face> out(mesh.triangles.size());
    for (std::uint32_t t = 0; t < out.size(); ++t) {
        auto c = mesh.triangles[t];
        bool turned = false;
        const auto order = [&](std::size_t i, std::size_t j) {
            if (c[i] < c[j]) return;
            std::swap(c[i], c[j]);
            turned = !turned;
        };
        order(0, 1);
        order(1, 2);
        order(0, 1);
        out[t] = {c, turned, t};
    }
    std::sort(out.begin(), out.end(), [](const Face& a, const Face& b) {
        return a.corners != b.corners ? a.corners < b.corners : a.triangle < b.triangle;
    });
    return out;
}

// Calls visit(copies) for the triangles with the same three corners.
template <class Visit>
void each_face(const std::vector<Face>& faces, const Visit& visit) {
    for (std::size_t i = 0, j = 0; i < faces.size(); i = j) {
        while (j < faces.size() && faces[j].corners == faces[i].corners) ++j;
        visit(std::span(faces.data() + i, j - i));
    }
}

void keep_triangles(Mesh& mesh, const std::vector<char>& keep) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (keep[t] == 0) continue;
        mesh.triangles[count] = mesh.triangles[t];
        if (!mesh.faces.empty()) mesh.faces[count] = mesh.faces[t];
        ++count;
    }
    mesh.triangles.resize(count);
    if (!mesh.faces.empty()) mesh.faces.resize(count);
}

Note none_yet(NoteCode code) {
    Note n = note(code);
    n.count = 0;
    return n;
}

void count(Note& n, const Mesh& mesh, std::uint32_t triangle) {
    const Triangle& t = mesh.triangles[triangle];
    if (n.count == 0) {
        n.x = mesh.vertices[t[0]].x;
        n.y = mesh.vertices[t[0]].y;
    }
    n.amount += area(mesh, t);
    ++n.count;
}

// If every triangle occurs equally often in both orientations, keeps one of each.
bool leave_one_side(Mesh& mesh, const std::vector<Face>& faces, Notes& notes) {
    bool all = true;
    each_face(faces, [&](std::span<const Face> copies) {
        const auto turned = std::count_if(copies.begin(), copies.end(), [](const Face& f) { return f.turned; });
        all = all && 2 * static_cast<std::size_t>(turned) == copies.size();
    });
    if (!all) return false;
    Note n = none_yet(NoteCode::triangle_two_sided);
    std::vector<char> keep(mesh.triangles.size(), 0);
    each_face(faces, [&](std::span<const Face> copies) { keep[copies[0].triangle] = 1; });
    for (std::uint32_t t = 0; t < keep.size(); ++t)
        if (keep[t] == 0) count(n, mesh, t);
    keep_triangles(mesh, keep);
    notes.push_back(std::move(n));
    return true;
}

// A triangle on an edge, and its angle round the edge.
struct Spoke {
    double angle = 0;
    HalfEdge edge{};
};

// Pairs the sides on one edge.
class Hub {
  public:
    Hub(const Mesh& mesh, std::vector<std::uint32_t>& mate) : mesh_(mesh), mate_(mate) {}

    void pair(std::span<const HalfEdge> sides) {
        measure(sides);
        put_in_order();
        match_opposite();
        match_rest();
    }

  private:
    // Computes the angle of each triangle round the edge, relative to the first one. Angles are seen against the
    // direction from the low vertex to the high one.
    void measure(std::span<const HalfEdge> sides) {
        const Vec3 a = mesh_.vertices[sides[0].low()], d = mesh_.vertices[sides[0].high()] - a;
        const Vec3 axis = 1 / norm(d) * d;
        spokes_.clear();
        Vec3 x, y;
        for (const HalfEdge& s : sides) {
            const Triangle& t = mesh_.triangles[s.side / 3];
            const Vec3 p = mesh_.vertices[t[(s.side + 2) % 3]] - a;
            const Vec3 u = p - dot(p, axis) * axis;
            if (!(norm(x) > 0) && norm(u) > 0) {
                x = 1 / norm(u) * u;
                y = cross(axis, x);
            }
            const double angle = std::atan2(dot(u, y), dot(u, x));
            spokes_.push_back({angle < -kSameAngle ? angle + 2 * std::numbers::pi : angle, s});
        }
    }

    static bool same(const Spoke& s, const Spoke& t) {
        const double d = std::abs(s.angle - t.angle);
        return d <= kSameAngle || 2 * std::numbers::pi - d <= kSameAngle;
    }

    // Sorts by falling angle: through the solid behind a triangle that runs from low to high. At equal angles those
    // that end there come first, so that no pair lies on itself; then by number.
    void put_in_order() {
        std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& s, const Spoke& t) {
            return s.angle != t.angle ? s.angle > t.angle : s.edge.side < t.edge.side;
        });
        for (std::size_t i = 0, j = 0; i < spokes_.size(); i = j) {
            for (j = i + 1; j < spokes_.size() && same(spokes_[i], spokes_[j]);) ++j;
            for (std::size_t k = i; k < j; ++k) spokes_[k].angle = spokes_[i].angle;
            std::sort(spokes_.begin() + static_cast<std::ptrdiff_t>(i),
                      spokes_.begin() + static_cast<std::ptrdiff_t>(j), [](const Spoke& s, const Spoke& t) {
                          return s.edge.falls != t.edge.falls ? s.edge.falls : s.edge.side < t.edge.side;
                      });
        }
    }

    void join(const Spoke& s, const Spoke& t) {
        mate_[s.edge.side] = t.edge.side;
        mate_[t.edge.side] = s.edge.side;
    }
    [[nodiscard]] bool free(const Spoke& s) const { return mate_[s.edge.side] == kNoSide; }

    // Pairs the sides like parentheses, twice round the edge.  Of copies, the first is paired first.
    void match_opposite() {
        struct Copies {
            std::vector<const Spoke*> all; // all spokes at one angle
            std::size_t next = 0;
        };
        std::vector<Copies> open;
        for (int round = 0; round < 2; ++round)
            for (const Spoke& s : spokes_) {
                if (!free(s) || (round > 0 && !s.edge.falls)) continue;
                if (!s.edge.falls) {
                    if (open.empty() || open.back().all[0]->angle != s.angle) open.emplace_back();
                    open.back().all.push_back(&s);
                } else if (!open.empty() && !same(*open.back().all[0], s)) {
                    Copies& last = open.back();
                    join(*last.all[last.next++], s);
                    if (last.next == last.all.size()) open.pop_back();
                }
            }
    }

    // Pairs the rest, whose sides run in one direction or lie on each other.  One triangle of each pair is flipped.
    void match_rest() {
        std::vector<const Spoke*> rest;
        for (const Spoke& s : spokes_)
            if (free(s)) rest.push_back(&s);
        for (std::size_t i = 0, j = rest.size(); i + 1 < j && !same(*rest[i], *rest[j - 1]); ++i)
            join(*rest[i], *rest[--j]);
    }

    const Mesh& mesh_;
    std::vector<std::uint32_t>& mate_;
    std::vector<Spoke> spokes_;
};

// Per side, the side that it is joined to, or kNoSide on a rim.
std::vector<std::uint32_t> mates_of(const Mesh& mesh, const std::vector<HalfEdge>& sides) {
    std::vector<std::uint32_t> mate(sides.size(), kNoSide);
    Hub hub(mesh, mate);
    each_edge(sides, [&](std::size_t i, std::size_t j) {
        if (j - i > 1) hub.pair({sides.data() + i, j - i});
    });
    return mate;
}

// The sheets, numbered by their first triangles.
struct Sheets {
    std::vector<std::uint32_t> of; // per triangle
    std::vector<char> open;        // per sheet: it has a rim
};
Sheets sheets_of(const std::vector<std::uint32_t>& mate) {
    geom::DisjointSets sets(mate.size() / 3);
    for (std::uint32_t s = 0; s < mate.size(); ++s)
        if (mate[s] != kNoSide) sets.unite(s / 3, mate[s] / 3);
    Sheets out;
    out.open.assign(sets.number(out.of), 0);
    for (std::uint32_t s = 0; s < mate.size(); ++s)
        if (mate[s] == kNoSide) out.open[out.of[s / 3]] = 1;
    return out;
}

// Per sheet, whether an earlier sheet contains it; see part_sheets.
std::vector<char> repeated(const Sheets& sheets, const std::vector<Face>& faces) {
    std::vector<std::uint32_t> face(sheets.of.size()); // per triangle: its index in `faces`
    for (std::uint32_t f = 0; f < faces.size(); ++f) face[faces[f].triangle] = f;
    std::vector<std::vector<std::uint32_t>> members(sheets.open.size());
    for (std::uint32_t t = 0; t < sheets.of.size(); ++t) members[sheets.of[t]].push_back(t);
    std::vector<char> out(sheets.open.size(), 0);
    std::vector<std::uint32_t> first(faces.size()); // per face: the index of its first copy
    for (std::uint32_t f = 1; f < faces.size(); ++f)
        first[f] = faces[f].corners == faces[f - 1].corners ? first[f - 1] : f;
    // true if another sheet that is kept has a copy of a triangle; sees few copies, as the first ones are kept
    const auto there = [&](std::uint32_t t) {
        const Face& self = faces[face[t]];
        const std::uint32_t self_sheet = sheets.of[t];
        for (std::uint32_t f = first[face[t]]; f < faces.size() && faces[f].corners == self.corners; ++f) {
            const std::uint32_t other = sheets.of[faces[f].triangle];
            const bool fits = sheets.open[self_sheet] != 0 || faces[f].turned == self.turned;
            const bool kept =
                out[other] == 0 && (other < self_sheet || (sheets.open[self_sheet] != 0 && sheets.open[other] == 0));
            if (fits && kept && other != self_sheet) return true;
        }
        return false;
    };
    for (std::uint32_t s = 0; s < out.size(); ++s)
        out[s] = std::all_of(members[s].begin(), members[s].end(), there) ? 1 : 0;
    return out;
}

// Per sheet, whether it bounds a solid by itself, except for cracks: its area vectors cancel out.
std::vector<char> nearly_closed(const Mesh& mesh, const Sheets& sheets) {
    std::vector<Vec3> sum(sheets.open.size());
    std::vector<double> size(sheets.open.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& tri = mesh.triangles[t];
        const Vec3 a = mesh.vertices[tri[0]];
        const Vec3 n = cross(mesh.vertices[tri[1]] - a, mesh.vertices[tri[2]] - a);
        sum[sheets.of[t]] = sum[sheets.of[t]] + n;
        size[sheets.of[t]] += norm(n);
    }
    std::vector<char> out(sum.size());
    for (std::size_t s = 0; s < out.size(); ++s) out[s] = norm(sum[s]) <= kOpenShare * size[s] ? 1 : 0;
    return out;
}

// Splits non-manifold vertices. A fan gets its own copy of the vertex if it is closed, or if one of its edges there has
// more than two triangles. Open fans keep sharing the vertex, as the gap between them may be a hole to fill. Sheets
// that are nearly closed by themselves need no other sheets, so each gets a copy for its open fans.
void part_vertices(Mesh& mesh, const std::vector<HalfEdge>& sides, const std::vector<std::uint32_t>& mate) {
    const Sheets sheets = sheets_of(mate);
    const std::vector<char> whole = nearly_closed(mesh, sheets);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> own; // shared by the open fans of a sheet
    geom::DisjointSets corners(mate.size());
    for (std::uint32_t s = 0; s < mate.size(); ++s) {
        const std::uint32_t o = mate[s];
        if (o == kNoSide || o < s) continue;
        const std::uint32_t s1 = 3 * (s / 3) + (s + 1) % 3, o1 = 3 * (o / 3) + (o + 1) % 3;
        const auto vertex = [&](std::uint32_t c) { return mesh.triangles[c / 3][c % 3]; };
        const bool same_way = vertex(s) == vertex(o);
        corners.unite(s, same_way ? o : o1);
        corners.unite(s1, same_way ? o1 : o);
    }
    std::vector<char> crowded(mesh.vertices.size(), 0);
    each_edge(sides, [&](std::size_t i, std::size_t j) {
        if (j - i > 2 || (j - i == 2 && mate[sides[i].side] == kNoSide))
            crowded[sides[i].low()] = crowded[sides[i].high()] = 1;
    });
    std::vector<char> open(mate.size(), 0); // per fan: it is open
    for (std::uint32_t s = 0; s < mate.size(); ++s)
        if (mate[s] == kNoSide) open[corners.root(s)] = open[corners.root(3 * (s / 3) + (s + 1) % 3)] = 1;
    std::vector<char> taken(mesh.vertices.size(), 0);
    std::vector<std::uint32_t> to(mate.size()), shared(mesh.vertices.size(), kNoSide);
    for (std::uint32_t c = 0; c < mate.size(); ++c) {
        const std::uint32_t v = mesh.triangles[c / 3][c % 3], sheet = sheets.of[c / 3];
        if (corners.root(c) != c) {
            to[c] = to[corners.root(c)];
            continue;
        }
        std::uint32_t alone = kNoSide;
        const bool may_share = open[c] != 0 && crowded[v] == 0;
        std::uint32_t& with = !may_share          ? alone
                              : whole[sheet] != 0 ? own.try_emplace({v, sheet}, kNoSide).first->second
                                                  : shared[v];
        if (with == kNoSide) {
            with = taken[v] == 0 ? v : static_cast<std::uint32_t>(mesh.vertices.size());
            if (taken[v] != 0) mesh.vertices.push_back(Vec3(mesh.vertices[v]));
            taken[v] = 1;
        }
        to[c] = with;
    }
    for (std::uint32_t c = 0; c < mate.size(); ++c) mesh.triangles[c / 3][c % 3] = to[c];
}

} // namespace

bool part_sheets(Mesh& mesh, Notes& notes) {
    if (is_plain(mesh)) return false;
    std::vector<Face> faces = faces_of(mesh);
    const bool two_sided = leave_one_side(mesh, faces, notes);
    if (two_sided) {
        if (is_plain(mesh)) return true;
        faces = faces_of(mesh);
    }
    auto sides = half_edges(mesh);
    auto mate = mates_of(mesh, sides);
    const Sheets sheets = sheets_of(mate);
    const std::vector<char> repeat = repeated(sheets, faces);
    if (std::find(repeat.begin(), repeat.end(), 1) != repeat.end()) {
        Note n = none_yet(NoteCode::triangle_repeated);
        std::vector<char> keep(mesh.triangles.size(), 1);
        for (std::uint32_t t = 0; t < keep.size(); ++t) {
            if (repeat[sheets.of[t]] == 0) continue;
            keep[t] = 0;
            count(n, mesh, t);
        }
        keep_triangles(mesh, keep);
        notes.push_back(std::move(n));
        sides = half_edges(mesh);
        mate = mates_of(mesh, sides);
    }
    part_vertices(mesh, sides, mate);
    return two_sided;
}

} // namespace filum::mesh
