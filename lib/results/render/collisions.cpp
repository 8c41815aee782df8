#include "render/collisions.hpp"

#include "base/error.hpp"
#include "render/camera.hpp"
#include "render/tubes.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace filum::render {

namespace {

using geom::Vec3;

constexpr int kRound = 48;             // corners of a circle
constexpr std::size_t kMostDots = 500; // places that are drawn as dots
constexpr double kFarthest = 1e7;      // largest absolute number that the list may hold, mm

// A coordinate system at the tip; z points up the tool.
struct Pose {
    Vec3 tip, x, y, z;
    [[nodiscard]] Vec3 operator()(double u, double v, double w) const { return tip + u * x + v * y + w * z; }
    [[nodiscard]] Vec3 polar(double r, double turn, double w) const {
        return (*this)(r * std::cos(turn), r * std::sin(turn), w);
    }
};

Pose pose(const Meeting& m) {
    const Vec3 other = std::abs(m.axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 x = unit(other - dot(other, m.axis) * m.axis);
    return {m.tip, x, cross(m.axis, x), m.axis};
}

double turn_of(int k, int of = kRound) { return 2 * std::numbers::pi * k / of; }

std::uint32_t add_point(mesh::Mesh& to, const Vec3& p) {
    to.vertices.push_back(p);
    return static_cast<std::uint32_t>(to.vertices.size() - 1);
}

void add_square(mesh::Mesh& to, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const std::uint32_t p = add_point(to, a), q = add_point(to, b), r = add_point(to, c), s = add_point(to, d);
    to.triangles.push_back({p, q, r});
    to.triangles.push_back({p, r, s});
}

void add_bar(mesh::Mesh& to, const Vec3& a, const Vec3& b, double radius) {
    const Vec3 way = unit(b - a), other = std::abs(way.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = radius * unit(cross(way, other)), v = radius * unit(cross(way, u));
    const std::array<Vec3, 4> off{u + v, v - u, -1 * u - v, u - v};
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 &p = off[k], &q = off[(k + 1) % 4];
        add_square(to, a + p, a + q, b + q, b + p);
    }
}

void add_ball(mesh::Mesh& to, const Vec3& at, double radius) {
    constexpr int kRows = 8, kSides = 16;
    const auto point = [&](int i, int j) {
        const double low = std::numbers::pi * i / kRows;
        return at + radius * Vec3{std::sin(low) * std::cos(turn_of(j, kSides)),
                                  std::sin(low) * std::sin(turn_of(j, kSides)), std::cos(low)};
    };
    for (int i = 0; i < kRows; ++i)
        for (int j = 0; j < kSides; ++j)
            add_square(to, point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
}

mesh::Mesh nozzle(const Pose& at, const machine::Head& head) {
    mesh::Mesh out;
    const double flat = head.flat_radius, wide = head.cone_radius(head.cone_height), high = head.cone_height;
    for (int k = 0; k < kRound; ++k) {
        const double a = turn_of(k), b = turn_of(k + 1);
        add_square(out, at.polar(flat, a, 0), at.polar(flat, b, 0), at.polar(wide, b, high), at.polar(wide, a, high));
        add_square(out, at.tip, at.tip, at.polar(flat, b, 0), at.polar(flat, a, 0));
    }
    return out;
}

// Adds the edges of a box around the axis as bars, with a grid over its underside.
void add_box(mesh::Mesh& to, const Pose& at, double x, double y, double low, double high, double bar) {
    constexpr int kGrid = 4;
    for (int k = 0; k <= kGrid; ++k) {
        const double s = 2.0 * k / kGrid - 1;
        add_bar(to, at(s * x, -y, low), at(s * x, y, low), bar);
        add_bar(to, at(-x, s * y, low), at(x, s * y, low), bar);
    }
    for (const double s : {-1.0, 1.0}) {
        add_bar(to, at(s * x, -y, high), at(s * x, y, high), bar);
        add_bar(to, at(-x, s * y, high), at(x, s * y, high), bar);
        for (const double t : {-1.0, 1.0}) add_bar(to, at(s * x, t * y, low), at(s * x, t * y, high), bar);
    }
}

void add_column(mesh::Mesh& to, const Pose& at, double radius, double low, double high, double bar) {
    for (int k = 0; k < kRound; ++k) {
        for (const double w : {low, high})
            add_bar(to, at.polar(radius, turn_of(k), w), at.polar(radius, turn_of(k + 1), w), bar);
        if (k % 6 == 0) add_bar(to, at.polar(radius, turn_of(k), low), at.polar(radius, turn_of(k), high), bar);
        if (k % 6 == 0 && k < kRound / 2)
            add_bar(to, at.polar(radius, turn_of(k), low), at.polar(-radius, turn_of(k), low), bar);
    }
}

bool leans(const Pose& at) { return at.z.z < 1 - 1e-9; }

// Half the size, in mm, of the part of the head that a picture should show.
double size_of(const Meeting& m, const machine::Head& head) {
    const double nozzle = std::max(head.cone_height, head.cone_radius(head.cone_height));
    const double carriage = std::hypot(head.carriage_x, head.carriage_y) / 2;
    double out = m.with == "nozzle" || !(carriage > 0) ? nozzle : std::max(nozzle, carriage);
    if (m.with == "gantry" && std::isfinite(head.gantry_height)) out = std::max(out, head.gantry_height);
    return std::clamp(out, 1.0, 1000.0);
}

mesh::Mesh body(const Pose& at, const Meeting& m, const machine::Head& head) {
    mesh::Mesh out;
    const double size = size_of(m, head), bar = 0.008 * size, low = head.cone_height;
    const double x = head.carriage_x / 2, y = head.carriage_y / 2, high = low + 0.6 * std::min(size, std::max(x, y));
    if (x > 0 && y > 0 && leans(at)) add_column(out, at, std::hypot(x, y), low, high, bar);
    if (x > 0 && y > 0 && !leans(at)) add_box(out, at, x, y, low, high, bar);
    if (m.with == "gantry") add_box(out, at, 2 * size, 2 * size, head.gantry_height, head.gantry_height, bar);
    return out;
}

// Points on the head that a picture should show.
std::vector<Vec3> sights(const Pose& at, const Meeting& m, const machine::Head& head) {
    std::vector<Vec3> out;
    const double hair = 1e-3 * size_of(m, head);
    for (const double share : {0.1, 0.4, 0.8})
        for (int k = 0; k < 16; ++k) {
            const double w = share * head.cone_height;
            out.push_back(at.polar(head.cone_radius(w) + hair, turn_of(k, 16), w));
        }
    if (m.with == "nozzle") return out;
    for (int k = 0; k < 32; ++k)
        out.push_back(at.polar(std::hypot(head.carriage_x, head.carriage_y) / 2, turn_of(k, 32), head.cone_height));
    return out;
}

// The direction from which most of `points` are visible; ties: the first.
Vec3 free_side(const Tubes& tubes, const std::vector<Vec3>& points) {
    Vec3 best{1, -1.5, 0.9};
    int most = -1;
    for (const double up : {0.35, 0.8})
        for (int k = 0; k < 16; ++k) {
            const Vec3 from = unit({std::cos(turn_of(k + 13, 16)), std::sin(turn_of(k + 13, 16)), up});
            int seen = 0;
            for (const Vec3& p : points) seen += tubes.blocked(p - tubes.centre(), from, INFINITY) ? 0 : 1;
            if (seen > most) {
                most = seen;
                best = from;
            }
        }
    return best;
}

// Keeps only the beads before point `last`.
void end_at(Scene& scene, std::uint64_t last) {
    std::uint64_t before = 0;
    for (auto& span : scene.spans) {
        const std::uint64_t points = span.points.size();
        if (before + points > last + 1) {
            const std::size_t keep = last + 1 > before ? last + 1 - before : 0;
            span.points.resize(keep);
            if (span.width.size() > 1) span.width.resize(keep);
            if (span.height.size() > 1) span.height.resize(keep);
            if (!span.normals.empty()) span.normals.resize(keep);
        }
        before += points;
    }
    std::erase_if(scene.spans, [](const auto& s) { return s.points.size() < 2; });
}

double number(std::string_view text, bool& good) {
    double out = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    good = good && error == std::errc{} && end == text.data() + text.size() && std::abs(out) <= kFarthest;
    return out;
}

std::vector<std::string_view> cells(std::string_view line) {
    std::vector<std::string_view> out;
    if (line.ends_with('\r')) line.remove_suffix(1);
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find('\t', at), line.size());
        out.push_back(line.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

constexpr std::string_view kColumns = "\tlayer\tstroke\tmove\tmeets\twith\tclearance\tx\ty\tz\ti\tj\tk";

} // namespace

Meetings read_meetings(std::string_view text, const std::string& name) {
    const auto fail = [&](const std::string& why) {
        throw Error(Exit::bad_input, "cannot draw the collisions in " + name + ": " + why);
    };
    Meetings out;
    std::size_t lines = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto cell = cells(line);
        if (++lines == 1) {
            out.points = cell[0] == "point";
            if ((!out.points && cell[0] != "line") || line.substr(cell[0].size(), kColumns.size()) != kColumns)
                fail("it is no list of 'collide --places'");
            continue;
        }
        bool good = cell.size() == 13;
        Meeting m;
        if (good) {
            m.with = cell[5];
            m.source = static_cast<std::uint64_t>(std::max(0.0, number(cell[0], good)));
            m.clearance = number(cell[6], good);
            m.tip = {number(cell[7], good), number(cell[8], good), number(cell[9], good)};
            m.axis = {number(cell[10], good), number(cell[11], good), number(cell[12], good)};
            good = good && std::abs(norm(m.axis) - 1) < 1e-3;
        }
        if (!good) fail("line " + std::to_string(lines) + " is no place");
        m.axis = unit(m.axis);
        out.all.push_back(m);
    }
    if (out.all.empty()) fail("it names no place; the head meets nothing");
    return out;
}

void draw_collisions(Canvas& page, Scene scene, const Meetings& places, const machine::Head& head, ColourBy by,
                     const View& view, int threads) {
    const Meeting& worst = *std::min_element(places.all.begin(), places.all.end(),
                                             [](const auto& a, const auto& b) { return a.clearance < b.clearance; });
    if (places.points) end_at(scene, worst.source);
    const Tint colours = tint(scene, by, nullptr);
    const Pose at = pose(worst);
    const double size = size_of(worst, head);
    scene.meshes.push_back({nozzle(at, head), oklch(0.72, 0.07, 70)});
    scene.meshes.push_back({body(at, worst, head), oklch(0.45, 0.05, 260)});
    View shown = view;
    if (norm(view.from) == 0) shown.from = free_side(Tubes(scene, colours, false, threads), sights(at, worst, head));
    const auto draw = [&](Canvas& cell, const ViewDirection& look) {
        View v = shown;
        const bool close = look.name != "all";
        if (close) v.around = ViewSphere{at(0, 0, 0.35 * size), 1.1 * size};
        Scene with = scene;
        const double dot = (close ? 0.02 : 0.025) * size;
        mesh::Mesh dots, place;
        for (std::size_t k = 0; k < places.all.size(); k += places.all.size() / kMostDots + 1)
            add_ball(dots, places.all[k].tip, dot);
        add_ball(place, worst.tip, 2.5 * dot);
        with.meshes.push_back({dots, oklch(0.72, 0.17, 60)});
        with.meshes.push_back({place, oklch(0.55, 0.24, 27)});
        draw_perspective(cell, with, colours, v, threads);
    };
    contact_sheet(page, {{"all", shown.from}, {"close by", shown.from}}, draw);
}

} // namespace filum::render
