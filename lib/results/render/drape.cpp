#include "render/drape.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "parallel/parallel.hpp"
#include "render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::render {

namespace {

using geom::Vec2;
using geom::Vec3;

const Rgb kPaper = oklch(0.985, 0.003, 250);

// The start or end of a stretch of path without a break.
struct End {
    Vec3 at, normal; // normal: 0 if unknown
    bool start = false;
};

std::vector<End> ends(const Scene& scene) {
    std::vector<End> out;
    bool open = false;
    End last;
    const auto end = [](const toolpath::Span& s, std::size_t i, bool start) {
        return End{s.points[i], s.normals.empty() ? Vec3{} : s.normals[i], start};
    };
    for (const auto& s : scene.spans) {
        const bool bead = toolpath::extrudes(s.role);
        if (open && (!bead || !(s.points.front() == last.at))) {
            out.push_back(last);
            open = false;
        }
        if (bead && !open) {
            out.push_back(end(s, 0, true));
            open = true;
        }
        last = end(s, s.points.size() - 1, false);
    }
    if (open) out.push_back(last);
    return out;
}

// A picture under construction: the page, and what the middle of each pixel shows.
struct MapPicture {
    Canvas& page;
    const Scene& scene;
    const DrapeView& view;
    Plan plan;
    int fine; // samples along each side of a pixel
    Raster raster;
    Image image;
    std::vector<Sight> sight;

    MapPicture(Canvas& c, const Scene& s, const DrapeView& v, const Plan& p)
        : page(c), scene(s), view(v), plan(p),
          fine(std::clamp(static_cast<int>(std::ceil(std::sqrt(v.samples))), 1, 16)), raster(s.sheet->surface, p, fine),
          image(p.width, p.height), sight(static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height)) {}
    [[nodiscard]] Sight& at(int x, int y) {
        return sight[static_cast<std::size_t>(y) * static_cast<std::size_t>(plan.width) + static_cast<std::size_t>(x)];
    }
    // True if the surface does not hide this place (see Plan::place). False outside the picture.
    [[nodiscard]] bool seen(Vec3 place, double slack) {
        if (!(place.x >= 0 && place.y >= 0 && place.x < plan.width && place.y < plan.height)) return false;
        const Sight& s = at(static_cast<int>(place.x), static_cast<int>(place.y));
        return s.triangle == surface::kNone || place.z >= s.height - slack;
    }
};

void paint_band(MapPicture& c, const Paint& paint, int band) {
    const Sights sights = c.raster.band(band);
    const int top = band * c.raster.rows(), f = c.fine;
    for (int y = 0; y < sights.rows / f; ++y) {
        for (int x = 0; x < c.plan.width; ++x) {
            Rgb sum;
            for (int k = 0; k < f * f; ++k) {
                const int i = x * f + k % f, j = y * f + k / f;
                const auto t = sights.at(i, j).triangle;
                sum = sum + (t == surface::kNone ? kPaper : paint.at(t, c.raster.shares(t, i, top * f + j)));
            }
            c.at(x, top + y) = sights.at(x * f + f / 2, y * f + f / 2);
            c.image.set(x, top + y, (1.0F / static_cast<float>(f * f)) * sum);
        }
    }
}

// Draws lines along the vectors, one in the middle of each square of pixels. The longest vector fills its square.
void draw_arrows(MapPicture& c, const surface::Field& field) {
    const int step = std::max(8, c.plan.height / 60);
    double longest = 0;
    for (std::size_t v = 0; v < field.values.size() / 3; ++v)
        if (const double l = norm(field.vector(v)); std::isfinite(l)) longest = std::max(longest, l);
    if (longest == 0) return;
    for (int y = step / 2; y < c.plan.height; y += step) {
        for (int x = step / 2; x < c.plan.width; x += step) {
            const Sight s = c.at(x, y);
            if (s.triangle == surface::kNone) continue;
            const auto& t = c.scene.sheet->surface.triangles[s.triangle];
            // The vector of the corner with the largest share: directions without an arrow cannot be interpolated.
            const Vec3 share = c.raster.shares(s.triangle, x * c.fine + c.fine / 2, y * c.fine + c.fine / 2);
            const auto v = t[share.x >= share.y && share.x >= share.z ? 0 : (share.y >= share.z ? 1 : 2)];
            const Vec3 d = (0.45 * step / longest) * field.vector(v);
            const Vec2 along{dot(d, c.plan.right), -dot(d, c.plan.up)}, at{x + 0.5, y + 0.5};
            const Rgb under = c.image.get(x, y);
            const bool dark = 0.2126F * under.r + 0.7152F * under.g + 0.0722F * under.b < 0.14F;
            const Rgb ink = dark ? Rgb{0.85F, 0.85F, 0.85F} : oklch(0.22, 0.03, 260);
            if (std::isfinite(along.x) && std::isfinite(along.y))
                c.page.line(at - along, at + along, {std::max(1.0, step / 10.0), ink, 0.9});
        }
    }
}

// Draws the line from a to b, mm, where the surface does not hide it.
void draw_in_space(MapPicture& c, Vec3 a, Vec3 b, double width, Rgb colour) {
    const double slack = 2 / c.plan.scale;
    a = c.plan.place(a);
    b = c.plan.place(b);
    const double pieces = std::clamp(std::ceil(geom::distance(a.xy(), b.xy()) / 3), 1.0, 8192.0);
    const auto at = [&](double k) { return a + k / pieces * (b - a); };
    double from = 0; // of the stretch that is seen without a break
    for (double k = 0; k <= pieces; ++k) {
        if (k < pieces && c.seen(at(k + 0.5), slack)) continue;
        if (k > from) c.page.line(at(from).xy(), at(k).xy(), {width, colour});
        from = k + 1;
    }
}

constexpr double kLoose = 0.3; // share of the bead width that loose beads are drawn with, so that they look different

// Draws what does not lie on the surface: turns beyond its rims, beads away from it, and moves without material.
void draw_loose(MapPicture& c, const SurfaceBeads& laid) {
    const double thread = std::clamp(c.plan.height / 700.0, 1.0, 4.0);
    for (const Stroke& s : laid.loose)
        draw_in_space(c, s.a, s.b, std::max(thread, kLoose * c.plan.scale * (s.half_a + s.half_b)),
                      from_srgb8(s.colour));
    for (const auto& s : c.scene.spans)
        for (std::size_t i = 0; i + 1 < s.points.size() && !toolpath::extrudes(s.role); ++i)
            draw_in_space(c, s.points[i], s.points[i + 1], thread, role_colour(toolpath::Role::travel));
}

void draw_ends(MapPicture& c, double width) {
    const auto all = ends(c.scene);
    const double most = 0.008 * c.plan.height + 4; // pixels; dots are smaller if many of them would hide the path
    const double crowd = std::sqrt(0.01 * c.plan.width * c.plan.height / static_cast<double>(all.size() + 1));
    const double size = std::clamp(1.1 * width * c.plan.scale, 4.0, std::max(4.0, std::min(most, crowd)));
    const double slack = std::max(2 / c.plan.scale, 0.3 * width);
    for (const bool start : {false, true}) {
        for (const End& e : all) {
            const Vec3 p = c.plan.place(e.at);
            if (e.start != start || dot(e.normal, c.plan.towards) < 0 || !c.seen(p, slack)) continue;
            c.page.line(p.xy(), p.xy(), {size + std::max(2.0, 0.35 * size), {1, 1, 1}});
            c.page.line(p.xy(), p.xy(), {size, mark_colour(start ? Mark::Kind::start : Mark::Kind::end)});
        }
    }
}

void draw_key(MapPicture& c, const Tint& tint, const Show& show, const SurfaceBeads& laid, double bare) {
    Key key(c.page);
    if (!show.around.empty()) key.clear(kPaper);
    key.ruler(c.plan.scale);
    // No share here: `metrics` measures the length beside the surface, and the picture draws whole segments.
    if (!laid.loose.empty()) key.text("thin: not on the surface");
    if (!show.by.empty()) {
        const Scale s = scale_of(find_field(*c.scene.sheet, show.by, 0));
        const char* unit = show.by == "distance" ? "mm" : (show.by.starts_with("stress.") ? "MPa" : "");
        key.ramp({show.by, s.lo, s.hi, unit, s.below, s.above});
    }
    for (std::size_t i = 0; i < c.scene.patches.size() && show.by.empty() && c.scene.patches.size() > 1; ++i)
        key.swatch(patch_colour(i), c.scene.patches[i]);
    if (const std::string share = "void " + fixed_text(100 * bare, 1) + "%"; show.voids && share == "void 0%")
        key.text(share); // nothing in the picture has that colour
    else if (show.voids)
        key.swatch(void_colour(), share);
    if (show.overlap) key.swatch(overlap_colour(), "overlap");
    if (c.scene.spans.empty()) return;
    add_legend(key, tint);
    key.swatch(mark_colour(Mark::Kind::start), "beginning");
    key.swatch(mark_colour(Mark::Kind::end), "end");
}

// Writes the names of several surfaces, each at its pixel nearest to the middle of its visible part. A name is left out
// if the visible part is too small for it.
void draw_names(MapPicture& c) {
    struct VisiblePatch {
        double x = 0, y = 0, count = 0, least = std::numeric_limits<double>::infinity();
        Vec2 at;
    };
    if (c.scene.patches.size() < 2) return;
    std::vector<VisiblePatch> visible(c.scene.patches.size());
    const auto each = [&](const auto& visit) {
        for (int y = 0; y < c.plan.height; ++y)
            for (int x = 0; x < c.plan.width; ++x)
                if (const auto t = c.at(x, y).triangle; t != surface::kNone) visit(visible[c.scene.patch[t]], x, y);
    };
    each([](VisiblePatch& s, int x, int y) {
        s.x += x;
        s.y += y;
        ++s.count;
    });
    each([](VisiblePatch& s, int x, int y) {
        const double off = std::hypot(x - s.x / s.count, y - s.y / s.count);
        if (off < s.least) s.least = off, s.at = {x + 0.5, y + 0.5};
    });
    const double size = std::clamp(c.plan.height / 40.0, 8.0, 40.0);
    for (std::size_t i = 0; i < visible.size(); ++i) {
        const double wide = c.page.text_width(size, c.scene.patches[i]);
        if (visible[i].count > 1.5 * wide * size)
            c.page.text({visible[i].at.x - wide / 2, visible[i].at.y + size / 2}, size, c.scene.patches[i],
                        oklch(0.25, 0.02, 260));
    }
}

// The mean tool axis of the beads, or, without axes, the mean normal of the surface. Returns `otherwise` if the
// directions cancel out.
Vec3 face(const Scene& scene, Vec3 otherwise) {
    Vec3 sum{};
    double total = 0;
    for (const auto& s : scene.spans) {
        for (std::size_t i = 0; i + 1 < s.points.size() && !s.normals.empty() && toolpath::extrudes(s.role); ++i) {
            const double l = geom::distance(s.points[i], s.points[i + 1]);
            sum = sum + l * s.normals[i];
            total += l;
        }
    }
    const auto& surface = scene.sheet->surface;
    for (std::uint32_t t = 0; t < surface.triangles.size() && total == 0; ++t) {
        const auto& c = surface.triangles[t];
        sum = sum + 0.5 * cross(surface.vertices[c[1]] - surface.vertices[c[0]],
                                surface.vertices[c[2]] - surface.vertices[c[0]]);
    }
    if (total == 0) total = surface::area(surface);
    return norm(sum) > 0.1 * total ? sum : otherwise;
}

// The plan of the picture for `look`.
Plan plan_of(const Scene& scene, const ViewDirection& look, const std::vector<Vec3>& points, int width, int height) {
    if (!look.face) return lay_out(points, look.from, upwards(look.from), width, height);
    const Vec3 normal = unit(face(scene, look.from)), above = upwards(normal), right = unit(cross(above, normal));
    return lay_out(points, normal + look.aside * right + look.above * cross(normal, right), above, width, height);
}

// Throws Error(bad_input) if a point is so far away that floating point cannot resolve pixels.
void check_place(const std::vector<Vec3>& points) {
    constexpr double kFar = 1e10; // mm
    for (const Vec3& p : points)
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFar)
            throw Error(Exit::bad_input, "cannot draw what lies 10000 km from the origin; move it near");
}

// The points that must fit into the picture: all of them, or the corners of the cube in the ball of --around.
std::vector<Vec3> shown_points(const Scene& scene, const Show& show) {
    std::vector<Vec3> out = scene.sheet->surface.vertices;
    for (const auto& s : scene.spans) out.insert(out.end(), s.points.begin(), s.points.end());
    check_place(out);
    if (const auto& a = show.around; !a.empty()) {
        const double r = a[3] / std::sqrt(3);
        return {{a[0] - r, a[1] - r, a[2] - r}, {a[0] + r, a[1] - r, a[2] - r}, {a[0] - r, a[1] + r, a[2] - r},
                {a[0] + r, a[1] + r, a[2] - r}, {a[0] - r, a[1] - r, a[2] + r}, {a[0] + r, a[1] - r, a[2] + r},
                {a[0] - r, a[1] + r, a[2] + r}, {a[0] + r, a[1] + r, a[2] + r}};
    }
    return out;
}

} // namespace

void draw_draped(Canvas& page, const Scene& scene, const Tint& tint, const DrapeView& view, int threads) {
    const SurfaceBeads laid = surface_beads(scene, tint);
    const double bare = view.show.voids ? uncovered(scene.sheet->surface, laid) : 0;
    double width = 0;
    for (const auto& s : scene.spans)
        if (toolpath::extrudes(s.role)) width = std::max(width, s.width_at(0));
    const std::vector<Vec3> points = shown_points(scene, view.show);
    contact_sheet(page, view.looks, [&](Canvas& cell, const ViewDirection& look) {
        MapPicture c(cell, scene, view, plan_of(scene, look, points, cell.width(), cell.height()));
        const Paint paint(scene, laid, view.show, c.plan);
        parallel::for_chunks(static_cast<std::size_t>(c.raster.bands()), 1, threads,
                             [&](std::size_t b, std::size_t) { paint_band(c, paint, static_cast<int>(b)); });
        cell.image(c.image);
        if (!view.show.arrows.empty()) draw_arrows(c, find_field(*scene.sheet, view.show.arrows, 3));
        if (view.show.by.empty() && scene.spans.empty()) draw_names(c);
        draw_loose(c, laid);
        draw_ends(c, width);
        draw_key(c, tint, view.show, laid, bare);
    });
}

} // namespace filum::render
