#include "render/paint.hpp"

#include "base/error.hpp"
#include "render/camera.hpp"
#include "surface/curve/line.hpp"

#include <algorithm>
#include <cmath>

namespace filum::render {

namespace {

using geom::Vec3;

constexpr double kCrease = 0.8;                 // cosine of the angle between normals from which an edge looks sharp
constexpr std::uint32_t kIsoline = 0, kRim = 1; // layers of the lines
// Share of their width that beads are drawn with, so that a field is visible between them.
constexpr double kSlim = 0.35;
constexpr Rgb kBack{0.50F, 0.55F, 0.68F}; // factor for the back: darker and bluish
constexpr Rgb kLineInk{0.020F, 0.022F, 0.030F};

Vec3 blend(const std::vector<Vec3>& v, const mesh::Triangle& t, Vec3 shares) {
    return shares.x * v[t[0]] + shares.y * v[t[1]] + shares.z * v[t[2]];
}

} // namespace

Rgb void_colour() { return oklch(0.60, 0.23, 25); }
Rgb overlap_colour() { return oklch(0.30, 0.10, 275); }
Rgb unknown_colour() { return oklch(0.70, 0, 0); }
Rgb patch_colour(std::size_t patch) { return mix(distinct(patch), {0.66F, 0.66F, 0.655F}, 0.3F); }

const surface::Field& find_field(const surface::Sheet& sheet, const std::string& name, std::uint32_t components) {
    std::string all;
    for (const auto& f : sheet.fields) {
        if (components != 0 && f.components != components) continue;
        if (f.name == name) return f;
        all += (all.empty() ? "" : ", ") + f.name;
    }
    const std::string kind = components == 3 ? "field of vectors" : "field";
    throw Error(Exit::usage,
                "cannot show '" + name + "': the surface has no such " + kind + (all.empty() ? "" : "; it has " + all));
}

double amount(const surface::Field& field, std::size_t vertex) {
    return field.components == 3 ? norm(field.vector(vertex)) : field.values[vertex];
}

Scale scale_of(const surface::Field& field) {
    std::vector<double> v;
    for (std::size_t i = 0; i < field.values.size() / field.components; ++i)
        if (const double a = amount(field, i); std::isfinite(a)) v.push_back(a);
    if (v.empty()) return {&field, 0, 0, false, false};
    std::sort(v.begin(), v.end());
    const double low = v[v.size() / 100], high = v[v.size() - 1 - v.size() / 100];
    if (v.back() - v.front() <= 1.25 * (high - low)) return {&field, v.front(), v.back(), false, false};
    return {&field, low, high, low > v.front(), high < v.back()};
}

Paint::Paint(const Scene& scene, const SurfaceBeads& laid, const Show& show, const Plan& plan)
    : scene_(&scene), sheet_(&*scene.sheet), laid_(&laid), show_(show), plan_(plan),
      lamp_(unit(plan.towards + 0.45 * plan.up - 0.35 * plan.right)),
      normal_(surface::curve::vertex_normals(scene.sheet->surface)), lines_({}) {
    if (!show.by.empty()) scale_ = scale_of(find_field(*sheet_, show.by, 0));
    if (!show.by.empty() && !show.voids) slim_ = kSlim;
    draw_lines();
}

void Paint::draw_lines() {
    const auto& s = sheet_->surface;
    const double pixel = 1 / plan_.scale;
    std::vector<Stroke> all;
    const auto add = [&](Vec3 a, Vec3 b, std::uint32_t triangle, double half, std::uint32_t layer) {
        const Vec3 p = plan_.place(a), q = plan_.place(b);
        if (std::max(p.x, q.x) < -2 || std::min(p.x, q.x) > plan_.width + 2) return;
        if (std::max(p.y, q.y) < -2 || std::min(p.y, q.y) > plan_.height + 2) return;
        all.push_back({a, b, surface::normal(s, triangle), half, half, 2 * half, 0, layer, {}});
    };
    for (const auto& rim : s.rims)
        for (const auto h : rim.sides) add(s.vertices[s.tail(h)], s.vertices[s.head(h)], h / 3, 1.1 * pixel, kRim);
    for (const auto& line : sheet_->isolines)
        for (std::size_t i = 0; i < line.triangles.size(); ++i)
            add(line.points[i], line.points[(i + 1) % line.points.size()], line.triangles[i], 0.6 * pixel, kIsoline);
    lines_ = Strokes(std::move(all));
}

Rgb Paint::ground(std::uint32_t triangle, Vec3 shares) const {
    constexpr Rgb kGround{0.66F, 0.66F, 0.655F};
    if (scale_.field == nullptr) return scene_->patches.size() > 1 ? patch_colour(scene_->patch[triangle]) : kGround;
    const auto& t = sheet_->surface.triangles[triangle];
    const double v = shares.x * amount(*scale_.field, t[0]) + shares.y * amount(*scale_.field, t[1]) +
                     shares.z * amount(*scale_.field, t[2]);
    if (!std::isfinite(v)) return unknown_colour();
    return ramp(scale_.hi > scale_.lo ? (v - scale_.lo) / (scale_.hi - scale_.lo) : 0.5);
}

// The colour of a bead. Its section looks round if there are enough pixels to show it; `normal` is bent accordingly.
Rgb Paint::on_bead(const Cover& c, Vec3& normal) const {
    const double pixels = slim_ * plan_.scale * (c.stroke->half_a + c.stroke->half_b);
    const double strength = std::clamp((pixels - 1.5) / 4, 0.0, 1.0), off2 = c.off * c.off;
    if (c.off > 0) normal = unit(normal + (0.75 * strength * off2) * unit(c.outwards));
    Rgb colour = static_cast<float>(1 - 0.45 * strength * off2 * off2) * from_srgb8(c.stroke->colour);
    if (c.twice && show_.overlap) colour = mix(colour, overlap_colour(), 0.85F);
    if (show_.centres && pixels >= 6 && c.off < std::min(0.11, 2 / pixels)) colour = mix(colour, {1, 1, 1}, 0.7F);
    return colour;
}

Rgb Paint::at(std::uint32_t triangle, Vec3 shares) const {
    const auto& s = sheet_->surface;
    const auto& t = s.triangles[triangle];
    const Vec3 flat = surface::normal(s, triangle), p = blend(s.vertices, t, shares);
    const double facing = dot(flat, plan_.towards) < 0 ? -1 : 1; // -1 if the back of the triangle is seen
    const bool back = (facing < 0) != laid_->behind;
    Vec3 n{};
    for (const auto& [v, share] : {std::pair{t[0], shares.x}, {t[1], shares.y}, {t[2], shares.z}})
        n = n + share * (dot(normal_[v], flat) < kCrease ? flat : normal_[v]);
    n = facing * unit(n);
    Rgb colour = ground(triangle, shares);
    const bool on_dark = 0.2126F * colour.r + 0.7152F * colour.g + 0.0722F * colour.b < 0.2F;
    const Cover line = lines_.at(p, flat);
    if (back) colour = colour * kBack;
    Cover c = laid_->beads.at(p, facing * flat);
    c.off /= slim_;
    if (c.off <= 1 && c.stroke != nullptr)
        colour = on_bead(c, n);
    else if (show_.voids && !back)
        colour = void_colour();
    const auto light = static_cast<float>(0.40 + 0.66 * std::max(0.0, dot(n, lamp_)));
    colour = light * colour;
    if (line.stroke == nullptr) return colour;
    if (line.stroke->layer == kRim) return mix(colour, kLineInk, 0.85F);
    if (!laid_->beads.empty()) return colour;
    return on_dark ? mix(colour, {1, 1, 1}, 0.6F) : mix(colour, kLineInk, 0.7F);
}

} // namespace filum::render
