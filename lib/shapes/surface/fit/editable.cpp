#include "surface/fit/editable.hpp"

#include <algorithm>

namespace filum::surface::fit {

namespace {

// cosine between normals: after two turns of more than 60 degrees a triangle could be turned over
constexpr double kTurned = 0.5;
constexpr double kThin = 0.05; // height over longest side: of a triangle with an angle below 6 degrees

void join(Editable& m, std::uint32_t h, std::uint32_t g) {
    if (h != kNone) m.twin[h] = g;
    if (g != kNone) m.twin[g] = h;
}

// Sets the half-edge of `v` from which its fan starts: h, or the one at its rim, if it has one.
void set_out(Editable& m, std::uint32_t v, std::uint32_t h) {
    m.out[v] = h;
    for (std::uint32_t k = h; m.twin[k] != kNone;) {
        k = next(m.twin[k]);
        m.out[v] = k;
        if (k == h) return;
    }
}

std::uint32_t add_triangle(Editable& m) {
    m.triangles.push_back({kNone, kNone, kNone});
    m.twin.insert(m.twin.end(), 3, kNone);
    m.line.insert(m.line.end(), 3, 0);
    return static_cast<std::uint32_t>(m.triangles.size() - 1);
}

// The twin of a half-edge and whether it is part of a line, to be set where its triangle has changed.
struct SideState {
    std::uint32_t beyond;
    char line;
};

SideState side(const Editable& m, std::uint32_t h) { return {m.twin[h], m.line[h]}; }

void set(Editable& m, std::uint32_t h, const SideState& to) {
    join(m, h, to.beyond);
    if (to.beyond == kNone) m.twin[h] = kNone;
    m.line[h] = to.line;
}

bool alike(const Vec3& before, const Vec3& now) { return dot(before, now) > kTurned * norm(before) * norm(now); }

} // namespace

Corners corners(const Editable& m, const Triangle& t) { return {m.at[t[0]], m.at[t[1]], m.at[t[2]]}; }

Vec3 upright(const Corners& c) { return cross(c[1] - c[0], c[2] - c[0]); }

double flatness(const Corners& c) {
    const double longest = std::max({distance(c[0], c[1]), distance(c[1], c[2]), distance(c[2], c[0])});
    return norm(upright(c)) / (longest * longest);
}

bool may_lie(const Editable& m, const Triangle& t, const Corners& now, const Vec3& before, double was) {
    if (!(flatness(now) >= std::min(kThin, was))) return false;
    const Vec3 n = upright(now);
    bool known = false;
    for (const std::uint32_t v : t) {
        if (!(norm(m.up[v]) > 0)) continue;
        if (!alike(m.up[v], n)) return false;
        known = true;
    }
    return known || alike(before, n);
}

bool may_move(const Editable& m, std::uint32_t v, const Vec3& to, std::uint32_t but) {
    double thinnest = kThin;
    each_leaving(m, v,
                 [&](std::uint32_t h) { thinnest = std::min(thinnest, flatness(corners(m, m.triangles[h / 3]))); });
    bool may = true;
    each_leaving(m, v, [&](std::uint32_t h) {
        if (!may || m.head(h) == but || m.apex(h) == but) return;
        Triangle t{v, m.head(h), m.apex(h)};
        Corners now = corners(m, t);
        const Vec3 before = upright(now);
        now[0] = to;
        if (but != kNone) t[0] = but;
        may = may_lie(m, t, now, before, thinnest);
    });
    return may;
}

std::uint32_t split(Editable& m, std::uint32_t h) {
    const std::uint32_t a = m.tail(h), b = m.head(h), c = m.apex(h), g = m.twin[h];
    const auto v = static_cast<std::uint32_t>(m.at.size());
    const char line = m.line[h];
    Vec3 up = upright(corners(m, m.triangles[h / 3]));
    if (g != kNone) up = line != 0 ? Vec3{} : up + upright(corners(m, m.triangles[g / 3]));
    m.at.push_back(0.5 * (m.at[a] + m.at[b]));
    m.size.push_back((m.size[a] + m.size[b]) / 2);
    m.kind.push_back(line != 0 ? VertexKind::on_line : VertexKind::free);
    m.up.push_back(up);
    m.out.push_back(kNone);
    // a b c becomes a v c, and v b c is added.
    const std::uint32_t far = add_triangle(m), hn = next(h);
    const SideState bc = side(m, hn);
    m.triangles[far] = {v, b, c};
    m.triangles[h / 3][hn % 3] = v;
    set(m, 3 * far + 1, bc);
    set(m, hn, {3 * far + 2, 0});
    m.line[3 * far + 2] = 0;
    set(m, 3 * far, {kNone, line});
    if (g != kNone) { // b a d becomes v a d, and b v d is added
        const std::uint32_t d = m.apex(g), other = add_triangle(m), gp = prev(g);
        const SideState db = side(m, gp);
        m.triangles[other] = {b, v, d};
        m.triangles[g / 3][g % 3] = v;
        set(m, 3 * other + 2, db);
        set(m, gp, {3 * other + 1, 0});
        m.line[3 * other + 1] = 0;
        set(m, 3 * other, {3 * far, line});
        m.line[3 * far] = line;
        set_out(m, d, gp);
    }
    set_out(m, v, 3 * far);
    set_out(m, a, h);
    set_out(m, b, 3 * far + 1);
    set_out(m, c, 3 * far + 2);
    return v;
}

bool joins_cleanly(const Editable& m, std::uint32_t h) {
    const std::uint32_t a = m.tail(h), b = m.head(h), g = m.twin[h];
    if (m.kind[a] == VertexKind::fixed || (m.kind[a] == VertexKind::on_line && m.line[h] == 0)) return false;
    const bool rim_a = m.twin[m.out[a]] == kNone, rim_b = m.twin[m.out[b]] == kNone;
    if (rim_a && rim_b && g != kNone) return false;
    for (const std::uint32_t t : {h, g}) { // the two other sides of each triangle become one
        if (t == kNone) continue;
        if (m.twin[next(t)] == kNone && m.twin[prev(t)] == kNone) return false;
        if (m.line[next(t)] != 0 && m.line[prev(t)] != 0) return false;
    }
    // The only common neighbours must be the third corners of the triangles at h.
    std::vector<std::uint32_t> around;
    const auto neighbours = [&](std::uint32_t v) {
        std::vector<std::uint32_t> out;
        each_leaving(m, v, [&](std::uint32_t k) {
            out.push_back(m.head(k));
            out.push_back(m.apex(k));
        });
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    };
    const auto of_a = neighbours(a), of_b = neighbours(b);
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(around));
    return around.size() == (g == kNone ? 1U : 2U) && of_a.size() + of_b.size() > 2 * around.size() + 2;
}

void collapse(Editable& m, std::uint32_t h) {
    const std::uint32_t a = m.tail(h), b = m.head(h), g = m.twin[h];
    std::vector<std::uint32_t> fan;
    each_leaving(m, a, [&](std::uint32_t k) { fan.push_back(k); });
    for (const std::uint32_t k : fan) m.triangles[k / 3][k % 3] = b;
    std::uint32_t leaves_b = kNone;
    for (const std::uint32_t t : {h, g}) {
        if (t == kNone) continue;
        const std::uint32_t apex = m.apex(t), x = m.twin[next(t)], y = m.twin[prev(t)];
        const char line = m.line[next(t)] != 0 || m.line[prev(t)] != 0;
        m.triangles[t / 3] = {kNone, kNone, kNone};
        for (const std::uint32_t k : {x, y}) {
            if (k == kNone) continue;
            m.twin[k] = k == x ? y : x;
            m.line[k] = line;
        }
        const std::uint32_t stays = x != kNone ? x : y;
        const bool from_apex = m.tail(stays) == apex;
        set_out(m, apex, from_apex ? stays : next(stays));
        leaves_b = from_apex ? next(stays) : stays;
    }
    m.out[a] = kNone;
    set_out(m, b, leaves_b);
}

bool flippable(const Editable& m, std::uint32_t h) {
    const std::uint32_t g = m.twin[h];
    if (g == kNone || m.line[h] != 0) return false;
    const std::uint32_t a = m.tail(h), b = m.head(h), c = m.apex(h), d = m.apex(g);
    bool joined = c == d;
    each_leaving(m, c, [&](std::uint32_t k) { joined = joined || m.head(k) == d || m.apex(k) == d; });
    if (joined) return false;
    const Corners one{m.at[a], m.at[b], m.at[c]}, other{m.at[b], m.at[a], m.at[d]};
    const Vec3 before = upright(one) + upright(other);
    const double was = std::min(flatness(one), flatness(other));
    const Triangle left{c, a, d}, right{d, b, c};
    return may_lie(m, left, corners(m, left), before, was) && may_lie(m, right, corners(m, right), before, was);
}

void flip(Editable& m, std::uint32_t h) {
    const std::uint32_t g = m.twin[h], t = h / 3, u = g / 3;
    const std::uint32_t a = m.tail(h), b = m.head(h), c = m.apex(h), d = m.apex(g);
    const SideState bc = side(m, next(h)), ca = side(m, prev(h)), ad = side(m, next(g)), db = side(m, prev(g));
    m.triangles[t] = {c, a, d};
    m.triangles[u] = {d, b, c};
    set(m, 3 * t, ca);
    set(m, 3 * t + 1, ad);
    set(m, 3 * u, db);
    set(m, 3 * u + 1, bc);
    set(m, 3 * t + 2, {3 * u + 2, 0});
    m.line[3 * u + 2] = 0;
    set_out(m, c, 3 * t);
    set_out(m, a, 3 * t + 1);
    set_out(m, d, 3 * u);
    set_out(m, b, 3 * u + 1);
}

Surface compact(const Editable& m) {
    std::vector<std::uint32_t> vertex(m.at.size(), kNone), triangle(m.triangles.size(), kNone);
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t t = 0; t < m.triangles.size(); ++t) {
        if (m.triangles[t][0] == kNone) continue;
        triangle[t] = static_cast<std::uint32_t>(triangles.size());
        Triangle now{};
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& v = vertex[m.triangles[t][k]];
            if (v == kNone) {
                v = static_cast<std::uint32_t>(vertices.size());
                vertices.push_back(m.at[m.triangles[t][k]]);
            }
            now[k] = v;
        }
        triangles.push_back(now);
    }
    std::vector<std::uint32_t> twin(3 * triangles.size(), kNone);
    for (std::uint32_t h = 0; h < m.twin.size(); ++h)
        if (!m.gone(h) && m.twin[h] != kNone)
            twin[3 * triangle[h / 3] + h % 3] = 3 * triangle[m.twin[h] / 3] + m.twin[h] % 3;
    return assemble(std::move(vertices), std::move(triangles), std::move(twin));
}

} // namespace filum::surface::fit
