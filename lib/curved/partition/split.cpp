#include "partition/split.hpp"
#include "partition/flood.hpp"

#include "partition/lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace filum::partition {

namespace {

using surface::Triangle;

constexpr double kNearest = 0.02; // share of an edge: borders cross it no nearer to a vertex

// One vertex per fan: per half-edge the number of its tail, and per new vertex the old one.
struct FanVertices {
    std::vector<std::uint32_t> tail, from;
};

FanVertices fans(const std::vector<std::uint32_t>& old_tail, const std::vector<std::uint32_t>& twin) {
    FanVertices out{std::vector<std::uint32_t>(twin.size(), kNone), {}};
    const auto give = [&](std::uint32_t h, bool back) { // the number to the rest of the fan, on one side of h
        const std::uint32_t first = h;
        for (;;) {
            out.tail[h] = static_cast<std::uint32_t>(out.from.size());
            const std::uint32_t over = back ? twin[h] : twin[surface::prev(h)];
            if (over == kNone) return;
            h = back ? surface::next(over) : over;
            if (h == first) return;
        }
    };
    for (std::uint32_t h = 0; h < twin.size(); ++h) {
        if (out.tail[h] != kNone) continue;
        give(h, true);
        give(h, false);
        out.from.push_back(old_tail[h]);
    }
    return out;
}

class Splitter {
  public:
    Splitter(const Sheet& sheet, const Cells& cells, const Borders& borders)
        : old_(sheet), cells_(cells), borders_(borders), vertices_(sheet.surface.vertices), fields_(sheet.fields) {}

    void add(std::uint32_t t) {
        const Triangle& c = old_.surface.triangles[t];
        const auto patch = [&](std::size_t k) { return borders_.patch[c[k % 3]]; };
        old_triangle_ = t;
        if (patch(0) == patch(1) && patch(1) == patch(2)) return put(c[0], c[1], c[2], patch(0));
        for (std::size_t k = 0; k < 3; ++k)
            if (patch(k + 1) == patch(k + 2)) return add_two(c[k], c[(k + 1) % 3], c[(k + 2) % 3]);
        add_three(c);
    }

    Parts take() {
        Parts out;
        out.patch = std::move(patch_);
        std::vector<std::uint32_t> twin = joined_sides();
        out.sheet.surface = surface::assemble(std::move(vertices_), std::move(triangles_), std::move(twin));
        out.sheet.fields = std::move(fields_);
        out.sheet.faces = std::move(faces_);
        return out;
    }

  private:
    void put(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t patch) {
        triangles_.push_back({a, b, c});
        patch_.push_back(patch);
        if (!old_.faces.empty()) faces_.push_back(old_.faces[old_triangle_]);
    }

    // Adds a quadrilateral, split along its shorter diagonal.
    void put(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t patch) {
        if (distance(vertices_[a], vertices_[c]) <= distance(vertices_[b], vertices_[d])) {
            put(a, b, c, patch);
            put(a, c, d, patch);
        } else {
            put(b, c, d, patch);
            put(b, d, a, patch);
        }
    }

    void add_two(std::uint32_t alone, std::uint32_t b, std::uint32_t c) {
        const std::uint32_t ab = place(alone, b), ca = place(alone, c);
        put(alone, ab, ca, borders_.patch[alone]);
        put(ab, b, c, ca, borders_.patch[b]);
    }

    void add_three(const Triangle& c) {
        const std::uint32_t m[3] = {place(c[0], c[1]), place(c[1], c[2]), place(c[2], c[0])};
        const std::uint32_t half = between(m[0], m[1], 0.5);
        between(half, m[2], 1.0 / 3);
        replace_by_last(half); // it was only an intermediate step
        for (std::size_t k = 0; k < 3; ++k) put(c[k], m[k], half, m[(k + 2) % 3], borders_.patch[c[k]]);
    }

    void replace_by_last(std::uint32_t v) {
        vertices_[v] = vertices_.back();
        vertices_.pop_back();
        for (auto& f : fields_) {
            const std::size_t n = f.components, last = f.values.size() - n;
            for (std::size_t k = 0; k < n; ++k) f.values[n * v + k] = f.values[last + k];
            f.values.resize(last);
        }
    }

    std::uint32_t between(std::uint32_t a, std::uint32_t b, double share) {
        vertices_.push_back(vertices_[a] + share * (vertices_[b] - vertices_[a]));
        for (auto& f : fields_) append_between(f, a, b, share);
        return static_cast<std::uint32_t>(vertices_.size() - 1);
    }

    // The vertex where the border crosses the edge.
    std::uint32_t place(std::uint32_t a, std::uint32_t b) {
        if (a > b) std::swap(a, b);
        const auto [at, fresh] = on_edge_.emplace(std::pair{a, b}, kNone);
        if (fresh) {
            const auto side = std::lower_bound(
                cells_.sides.begin(), cells_.sides.end(), std::pair{a, b},
                [](const CellBorder& s, const auto& e) { return s.a != e.first ? s.a < e.first : s.b < e.second; });
            const double share = borders_.at[static_cast<std::size_t>(side - cells_.sides.begin())];
            at->second = between(a, b, std::clamp(share, kNearest, 1 - kNearest));
        }
        return at->second;
    }

    [[nodiscard]] std::vector<std::uint32_t> joined_sides() const {
        std::vector<std::uint32_t> twin(3 * triangles_.size(), kNone);
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open;
        for (std::uint32_t h = 0; h < twin.size(); ++h) {
            const auto& t = triangles_[h / 3];
            const std::uint32_t a = t[h % 3], b = t[(h + 1) % 3];
            if (const auto other = open.find({b, a}); other != open.end()) {
                twin[h] = other->second;
                twin[other->second] = h;
                open.erase(other);
            } else {
                open.emplace(std::pair{a, b}, h);
            }
        }
        return twin;
    }

    const Sheet& old_;
    const Cells& cells_;
    const Borders& borders_;
    std::uint32_t old_triangle_ = 0;
    std::vector<Vec3> vertices_;
    std::vector<surface::Field> fields_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> patch_, faces_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> on_edge_;
};

} // namespace

Sheet take(const Sheet& sheet, std::span<const std::uint32_t> triangles, std::span<const char> apart) {
    const Surface& s = sheet.surface;
    std::vector<std::uint32_t> here(s.triangles.size(), kNone), tail(3 * triangles.size()), twin(tail.size(), kNone);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) here[triangles[i]] = i;
    for (std::uint32_t h = 0; h < tail.size(); ++h) {
        const std::uint32_t old = 3 * triangles[h / 3] + h % 3, over = s.twin[old];
        tail[h] = s.tail(old);
        if (over == kNone || here[over / 3] == kNone) continue;
        if (!apart.empty() && (apart[old] != 0 || apart[over] != 0)) continue;
        twin[h] = 3 * here[over / 3] + over % 3;
    }
    const FanVertices f = fans(tail, twin);
    std::vector<Triangle> corners(triangles.size());
    for (std::uint32_t h = 0; h < tail.size(); ++h) corners[h / 3][h % 3] = f.tail[h];
    std::vector<Vec3> vertices;
    for (const std::uint32_t v : f.from) vertices.push_back(s.vertices[v]);
    Sheet out;
    out.surface = surface::assemble(std::move(vertices), std::move(corners), std::move(twin));
    for (const auto& field : sheet.fields) out.fields.push_back(surface::picked(field, f.from));
    if (!sheet.faces.empty())
        for (const std::uint32_t t : triangles) out.faces.push_back(sheet.faces[t]);
    return out;
}

Parts split(const Sheet& sheet, const Cells& cells, const Borders& borders) {
    Splitter splitter(sheet, cells, borders);
    for (std::uint32_t t = 0; t < sheet.surface.triangles.size(); ++t) splitter.add(t);
    return splitter.take();
}

std::vector<std::uint32_t> pieces(const Parts& parts) {
    const Surface& s = parts.sheet.surface;
    return flood(s, [&](std::uint32_t h) { return parts.patch[s.twin[h] / 3] == parts.patch[h / 3]; });
}

} // namespace filum::partition
