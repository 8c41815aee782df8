#include "geodesic/sides.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>

namespace filum::geodesic {

namespace {

using surface::kNone;

constexpr double kOn = 1e-7;    // longest sides of the triangle: a point nearer to a line lies on it
constexpr double kMixed = 0.01; // largest share of the lines that may be mixed

// Whether p-q and a line, all in the plane with this normal, cross properly.
bool crosses(const Vec3& normal, const Vec3& p, const Vec3& q, const Segment& line) {
    const auto side = [&](const Vec3& from, const Vec3& to, const Vec3& at) {
        return dot(normal, cross(to - from, at - from));
    };
    return side(p, q, line.a) * side(p, q, line.b) < 0 && side(line.a, line.b, p) * side(line.a, line.b, q) < 0;
}

// Whether a line of the triangle other than `own` is between the points.
bool apart(const std::vector<Segment>& lines, std::uint32_t triangle, const Vec3& normal, const Vec3& p, const Vec3& q,
           const Segment* own = nullptr) {
    auto it = std::lower_bound(lines.begin(), lines.end(), triangle,
                               [](const Segment& s, std::uint32_t t) { return s.triangle < t; });
    for (; it != lines.end() && it->triangle == triangle; ++it)
        if (&*it != own && crosses(normal, p, q, *it)) return true;
    return false;
}

class SideSolver {
  public:
    SideSolver(const Surface& s, const Sources& sources) : surface_(s), sources_(sources), blocked_(s.twin.size(), 0) {
        out_.of.assign(s.vertices.size(), 1);
        for (const std::uint32_t v : sources.vertices) out_.of[v] = 0;
        for (const Segment& line : sources.segments) block(line);
        out_.lines = sources.segments;
        std::stable_sort(out_.lines.begin(), out_.lines.end(),
                         [](const Segment& a, const Segment& b) { return a.triangle < b.triangle; });
    }

    Sides run() {
        flood();
        vote();
        for (std::size_t v = 0; v < out_.of.size(); ++v)
            if (region_[v] != kNone) out_.of[v] = balance_[region_[v]] < 0 ? -1 : 1;
        count_mixed();
        leave_out_components();
        return std::move(out_);
    }

  private:
    // Marks vertices on the line, and edges at which it ends, which are the edges that it crosses.
    void block(const Segment& line) {
        double longest = 0;
        for (std::uint32_t h = 3 * line.triangle; h < 3 * line.triangle + 3; ++h)
            longest = std::max(longest, distance(tail(h), tail(surface::next(h))));
        const double on = kOn * longest;
        for (std::uint32_t h = 3 * line.triangle; h < 3 * line.triangle + 3; ++h) {
            if (off(line.a, line.b, tail(h)) <= on) out_.of[surface_.tail(h)] = 0;
            for (const Vec3& p : {line.a, line.b}) {
                if (off(tail(h), tail(surface::next(h)), p) > on) continue;
                blocked_[h] = 1;
                if (surface_.twin[h] != kNone) blocked_[surface_.twin[h]] = 1;
            }
        }
    }

    [[nodiscard]] const Vec3& tail(std::uint32_t h) const { return surface_.vertices[surface_.tail(h)]; }

    static double off(const Vec3& a, const Vec3& b, const Vec3& p) {
        const Vec3 d = b - a;
        const double l2 = dot(d, d), t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
        return distance(a + t * d, p);
    }

    void flood() {
        region_.assign(surface_.vertices.size(), kNone);
        std::vector<std::uint32_t> pending;
        const auto take = [&](std::uint32_t v, std::uint32_t region) {
            if (region_[v] != kNone || out_.of[v] == 0) return;
            region_[v] = region;
            pending.push_back(v);
        };
        for (std::uint32_t first = 0; first < region_.size(); ++first) {
            if (region_[first] != kNone || out_.of[first] == 0) continue;
            const auto region = static_cast<std::uint32_t>(balance_.size());
            balance_.push_back(0);
            for (take(first, region); !pending.empty();) {
                const std::uint32_t v = pending.back();
                pending.pop_back();
                each_outgoing(surface_, v, [&](std::uint32_t h) {
                    if (blocked_[h] == 0) take(surface_.head(h), region);
                    if (const std::uint32_t back = surface::prev(h); blocked_[back] == 0)
                        take(surface_.tail(back), region); // at a rim no half-edge leads to that vertex
                });
            }
        }
    }

    // Calls visit(vertex, length, whether it is on the left) for each line's corners that see its middle.
    template <class Visit>
    void each_beside(const Visit& visit) const {
        for (const Segment& line : out_.lines) {
            const Vec3 up = surface::normal(surface_, line.triangle), left = cross(up, line.b - line.a);
            for (const std::uint32_t v : surface_.triangles[line.triangle]) {
                const Vec3 &p = surface_.vertices[v], middle = 0.5 * (line.a + line.b);
                const double away = dot(p - line.a, left), in_line = kOn * norm(left) * distance(p, line.a);
                if (region_[v] == kNone || std::abs(away) <= in_line) continue;
                if (!apart(out_.lines, line.triangle, up, p, middle, &line))
                    visit(v, distance(line.a, line.b), away > 0);
            }
        }
    }

    void vote() {
        each_beside(
            [&](std::uint32_t v, double length, bool left) { balance_[region_[v]] += left ? length : -length; });
    }

    void count_mixed() {
        for (const Segment& line : sources_.segments) out_.length += distance(line.a, line.b);
        each_beside([&](std::uint32_t v, double length, bool left) {
            if (left != (out_.of[v] > 0)) out_.mixed += length / 2;
        });
    }

    void leave_out_components() {
        std::vector<char> has(surface_.components, 0);
        for (const Segment& line : sources_.segments) has[surface_.component[line.triangle]] = 1;
        for (const std::uint32_t v : sources_.vertices) has[surface_.component[surface_.outgoing[v] / 3]] = 1;
        for (std::size_t v = 0; v < out_.of.size(); ++v)
            if (has[surface_.component[surface_.outgoing[v] / 3]] == 0) out_.of[v] = 0;
    }

    const Surface& surface_;
    const Sources& sources_;
    std::vector<char> blocked_;         // per half-edge: a line crosses it
    std::vector<std::uint32_t> region_; // per vertex
    // per region: mm of lines that have it on their left, minus mm of those that have it on their right
    std::vector<double> balance_;
    Sides out_;
};

} // namespace

Sides sides(const Surface& surface, const Sources& sources) { return SideSolver(surface, sources).run(); }

int Sides::at(const Surface& s, std::uint32_t triangle, const Vec3& p) const {
    const Vec3 up = surface::normal(s, triangle);
    for (const std::uint32_t v : s.triangles[triangle])
        if (of[v] != 0 && !apart(lines, triangle, up, p, s.vertices[v])) return of[v];
    return 0;
}

void check(const Sides& sides, const std::string& use) {
    if (!(sides.length > 0))
        throw Error(Exit::usage, "cannot use " + use +
                                     ": the sources are points, which have no sides; name a plane, a "
                                     "line or a mesh");
    if (sides.mixed > kMixed * sides.length)
        throw Error(Exit::usage, "cannot use " + use + ": the sources do not separate the surface into two sides (" +
                                     fixed_text(sides.mixed, 3) + " of " + fixed_text(sides.length, 3) +
                                     " mm do not); let lines end at rims, and not cross");
}

} // namespace filum::geodesic
