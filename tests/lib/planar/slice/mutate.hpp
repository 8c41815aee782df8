// Meshes damaged by rule, as exporters, repair tools and people damage them; each kind with a strength from 0 to 1.
#pragma once

#include "../../shapes/mesh/shapes.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mutate {

using filum::mesh::Mesh;
using filum::mesh::Triangle;
using filum::mesh::Vec3;

// Random numbers that are the same everywhere (splitmix64).
struct Dice {
    std::uint64_t state = 1;
    std::uint64_t next() {
        std::uint64_t z = state += 0x9e3779b97f4a7c15ULL;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; } // in [0, 1)
    double around(double r) { return r * (2 * unit() - 1); }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
    Vec3 shift(double r) {
        const double x = around(r), y = around(r), z = around(r);
        return {x, y, z};
    }
};

inline void shuffle(std::vector<Triangle>& t, Dice& dice) {
    for (std::size_t i = t.size(); i > 1; --i) std::swap(t[i - 1], t[dice.below(i)]);
}

// Vertices with the same coordinates as one, as a reader leaves them.
inline Mesh welded(const Mesh& m) {
    std::map<std::array<double, 3>, std::uint32_t> at;
    Mesh out;
    for (const Triangle& t : m.triangles) {
        Triangle u{};
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 v = m.vertices[t[k]];
            const auto [it, fresh] =
                at.try_emplace({v.x + 0.0, v.y + 0.0, v.z + 0.0}, static_cast<std::uint32_t>(out.vertices.size()));
            if (fresh) out.vertices.push_back(v);
            u[k] = it->second;
        }
        if (u[0] != u[1] && u[1] != u[2] && u[2] != u[0]) out.triangles.push_back(u);
    }
    return out;
}

inline Mesh soup(const Mesh& m) { // no vertex is shared
    Mesh out;
    for (const Triangle& t : m.triangles) {
        const auto i = static_cast<std::uint32_t>(out.vertices.size());
        for (const auto v : t) out.vertices.push_back(m.vertices[v]);
        out.triangles.push_back({i, i + 1, i + 2});
    }
    return out;
}

inline Vec3 middle(const Mesh& m, const Triangle& t) {
    return 1.0 / 3 * (m.vertices[t[0]] + m.vertices[t[1]] + m.vertices[t[2]]);
}

inline double size_of(const Mesh& m) { // the longest side of its box
    Vec3 lo = m.vertices[0], hi = lo;
    for (const Vec3& v : m.vertices) {
        lo = {std::min(lo.x, v.x), std::min(lo.y, v.y), std::min(lo.z, v.z)};
        hi = {std::max(hi.x, v.x), std::max(hi.y, v.y), std::max(hi.z, v.z)};
    }
    return std::max({hi.x - lo.x, hi.y - lo.y, hi.z - lo.z});
}

inline Mesh scaled_about(Mesh m, double s) {
    Vec3 c;
    for (const Vec3& v : m.vertices) c = c + 1.0 / static_cast<double>(m.vertices.size()) * v;
    for (Vec3& v : m.vertices) v = c + s * (v - c);
    return m;
}

// Every triangle in four; `some`: only some, so that neighbours have T-junctions.
inline Mesh split(const Mesh& m, Dice& dice, double share) {
    Mesh out = m;
    out.triangles.clear();
    for (const Triangle& t : m.triangles) {
        if (dice.unit() >= share) {
            out.triangles.push_back(t);
            continue;
        }
        std::uint32_t mid[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 a = m.vertices[std::min(t[k], t[(k + 1) % 3])], b = m.vertices[std::max(t[k], t[(k + 1) % 3])];
            mid[k] = static_cast<std::uint32_t>(out.vertices.size());
            out.vertices.push_back(0.5 * (a + b));
        }
        out.triangles.push_back({t[0], mid[0], mid[2]});
        out.triangles.push_back({mid[0], t[1], mid[1]});
        out.triangles.push_back({mid[2], mid[1], t[2]});
        out.triangles.push_back({mid[0], mid[1], mid[2]});
    }
    return out;
}

// Each of the triangles for which `pick` says so is given to `change`.
inline Mesh without(Mesh m, const std::function<bool(const Triangle&)>& pick) {
    std::erase_if(m.triangles, pick);
    return m;
}

// What a damaged mesh ought to be printed as: the part before; the part before, if it has no hollows and no arms;
// that with its faces where they now are; two of it.
enum class Meant { as_before, as_before_if_round, as_it_is, twice };

struct Kind {
    const char* name;
    // strength s in [0, 1]; the caller welds the result
    Mesh (*make)(const Mesh& m, double s, Dice& dice);
    Meant meant = Meant::as_before;
    bool destroys = false; // so that nobody can tell any more what is solid, if strong
};

// 1 um to 0.05 mm
inline double small(double s) { return 0.001 * std::pow(50, s); }

inline const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = {
        {"as it was", [](const Mesh& m, double, Dice&) { return m; }},
        {"doubled", [](const Mesh& m, double, Dice&) { return shapes::together(m, m); }},
        {"doubled, shuffled",
         [](const Mesh& m, double, Dice& d) {
             Mesh out = shapes::together(m, m);
             shuffle(out.triangles, d);
             return out;
         }},
        {"every triangle twice in a row",
         [](const Mesh& m, double, Dice&) {
             Mesh out = m;
             out.triangles.clear();
             for (const Triangle& t : m.triangles) out.triangles.insert(out.triangles.end(), 2, t);
             return out;
         }},
        {"tripled, shuffled",
         [](const Mesh& m, double, Dice& d) {
             Mesh out = shapes::together(shapes::together(m, m), m);
             shuffle(out.triangles, d);
             return out;
         }},
        {"inverted copy", [](const Mesh& m, double, Dice&) { return shapes::together(m, shapes::inverted(m)); }},
        {"two-sided, shuffled",
         [](const Mesh& m, double, Dice& d) {
             Mesh out = shapes::together(m, shapes::inverted(m));
             shuffle(out.triangles, d);
             return out;
         }},
        {"copy moved a little",
         [](const Mesh& m, double s, Dice& d) { return shapes::together(m, shapes::moved(m, d.shift(small(s)))); }},
        {"inverted copy moved a little",
         [](const Mesh& m, double s, Dice& d) {
             return shapes::together(m, shapes::inverted(shapes::moved(m, d.shift(small(s)))));
         }},
        {"copy of other triangles", [](const Mesh& m, double, Dice& d) { return shapes::together(m, split(m, d, 1)); }},
        {"inverted copy of other triangles",
         [](const Mesh& m, double, Dice& d) { return shapes::together(m, shapes::inverted(split(m, d, 1))); }},
        {"copy with every vertex moved a little",
         [](const Mesh& m, double s, Dice& d) {
             Mesh c = m;
             for (Vec3& v : c.vertices) v = v + d.shift(small(s));
             return shapes::together(m, c);
         }},
        {"smaller copy inside",
         [](const Mesh& m, double s, Dice&) { return shapes::together(m, scaled_about(m, 0.2 + 0.5 * s)); },
         Meant::as_before_if_round},
        {"some triangles twice",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = m;
             for (const Triangle& t : m.triangles)
                 if (d.unit() < 0.5 * s) out.triangles.push_back(t);
             shuffle(out.triangles, d);
             return out;
         }},
        {"some triangles two-sided",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = m;
             for (const Triangle& t : m.triangles)
                 if (d.unit() < 0.5 * s) out.triangles.push_back({t[1], t[0], t[2]});
             shuffle(out.triangles, d);
             return out;
         }},
        {"inside out", [](const Mesh& m, double, Dice&) { return shapes::inverted(m); }},
        {"some flipped",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = m;
             for (Triangle& t : out.triangles)
                 if (d.unit() < 0.5 * s) std::swap(t[0], t[1]);
             return out;
         }},
        {"torn corners, small",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = soup(m);
             for (Vec3& v : out.vertices) v = v + d.shift(small(s));
             return out;
         }},
        {"torn corners",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = soup(m);
             for (Vec3& v : out.vertices) v = v + d.shift(0.05 * size_of(m) * s);
             return out;
         },
         Meant::as_before, true},
        {"torn and some flipped",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = soup(m);
             for (Vec3& v : out.vertices) v = v + d.shift(small(s));
             for (Triangle& t : out.triangles)
                 if (d.unit() < 0.3 * s) std::swap(t[0], t[1]);
             return out;
         }},
        {"shrunk triangles",
         [](const Mesh& m, double s, Dice&) {
             Mesh out = soup(m);
             for (const Triangle& t : out.triangles) {
                 const Vec3 c = middle(out, t);
                 for (const auto v : t) out.vertices[v] = c + (1 - 0.2 * s) * (out.vertices[v] - c);
             }
             return out;
         },
         Meant::as_before, true},
        {"triangles moved",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = soup(m);
             for (const Triangle& t : out.triangles) {
                 const Vec3 by = d.shift(small(s));
                 for (const auto v : t) out.vertices[v] = out.vertices[v] + by;
             }
             return out;
         }},
        {"jitter",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = m;
             for (Vec3& v : out.vertices) v = v + d.shift(0.01 * size_of(m) * s);
             return out;
         },
         Meant::as_it_is},
        {"some triangles gone",
         [](const Mesh& m, double s, Dice& d) {
             return without(m, [&](const Triangle&) { return d.unit() < 0.3 * s; });
         },
         Meant::as_before, true},
        {"a patch gone",
         [](const Mesh& m, double s, Dice& d) {
             const Vec3 at = m.vertices[d.below(m.vertices.size())];
             const double r = 0.6 * s * size_of(m);
             return without(m, [&](const Triangle& t) { return distance(middle(m, t), at) < r; });
         },
         Meant::as_before, true},
        {"cut off",
         [](const Mesh& m, double s, Dice& d) {
             Vec3 n = d.shift(1);
             n = 1 / norm(n) * n;
             std::vector<double> h;
             for (const Vec3& v : m.vertices) h.push_back(dot(n, v));
             std::sort(h.begin(), h.end());
             const double limit = h[static_cast<std::size_t>((1 - 0.6 * s) * static_cast<double>(h.size() - 1))];
             return without(m, [&](const Triangle& t) { return dot(n, middle(m, t)) > limit; });
         },
         Meant::as_before, true},
        {"T-junctions", [](const Mesh& m, double, Dice& d) { return split(m, d, 0.5); }},
        {"degenerate triangles",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = m;
             for (const Triangle& t : m.triangles)
                 if (d.unit() < 0.5 * s) {
                     const auto v = static_cast<std::uint32_t>(out.vertices.size());
                     out.vertices.push_back(0.5 * (m.vertices[t[0]] + m.vertices[t[1]]));
                     out.triangles.push_back({t[0], t[1], v});
                     if (d.unit() < 0.5) out.triangles.push_back({t[1], t[0], v});
                 }
             return out;
         }},
        {"vertices rounded",
         [](const Mesh& m, double s, Dice&) {
             Mesh out = m;
             const double g = 0.02 * size_of(m) * s + 1e-6;
             for (Vec3& v : out.vertices)
                 v = {std::round(v.x / g) * g, std::round(v.y / g) * g, std::round(v.z / g) * g};
             return out;
         },
         Meant::as_it_is},
        {"far away in single precision",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = m;
             const double far = std::pow(10, 3 + 4 * s);
             const Vec3 by{d.unit() < 0.5 ? far : -far, far * d.unit(), 0};
             for (Vec3& v : out.vertices) {
                 v = v + by;
                 v = {static_cast<double>(static_cast<float>(v.x)), static_cast<double>(static_cast<float>(v.y)),
                      static_cast<double>(static_cast<float>(v.z))};
             }
             return out;
         }},
        {"rubbish beside and inside",
         [](const Mesh& m, double s, Dice& d) {
             Mesh out = m;
             const double size = size_of(m);
             for (int i = 0; i < 1 + static_cast<int>(40 * s); ++i) {
                 const Vec3 at = m.vertices[d.below(m.vertices.size())] + d.shift(0.2 * size);
                 const auto v = static_cast<std::uint32_t>(out.vertices.size());
                 for (int k = 0; k < 3; ++k) out.vertices.push_back(at + d.shift(0.1 * size));
                 out.triangles.push_back({v, v + 1, v + 2});
             }
             return out;
         },
         Meant::as_before, true},
        {"twice side by side",
         [](const Mesh& m, double, Dice&) {
             return shapes::together(m, shapes::moved(m, {1.5 * size_of(m), 0, 0}));
         },
         Meant::twice},
    };
    return all;
}

} // namespace mutate
