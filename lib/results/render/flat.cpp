#include "render/flat.hpp"

#include "base/number.hpp"
#include "geom/segment.hpp"
#include "parallel/parallel.hpp"
#include "render/key.hpp"
#include "render/layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace filum::render {

namespace {

using geom::Vec2;

constexpr int kBand = 16; // rows of pixels that are drawn at once

struct Frame {
    Vec2 middle;
    double scale = 1; // pixels per mm
    Vec2 half;        // half the size of the picture, pixels
    [[nodiscard]] Vec2 to_pixel(Vec2 p) const {
        return {half.x + (p.x - middle.x) * scale, half.y - (p.y - middle.y) * scale};
    }
};

Frame frame(const geom::Box2& box, const std::vector<double>& around, int width, int height) {
    Frame f;
    f.half = {width / 2.0, height / 2.0};
    if (!around.empty()) {
        f.middle = {around[0], around[1]};
        f.scale = std::min(f.half.x, f.half.y) / around[3];
        return f;
    }
    if (box.empty()) return f;
    f.middle = geom::lerp(box.lo, box.hi, 0.5);
    const double w = std::max(box.hi.x - box.lo.x, 1e-6), h = std::max(box.hi.y - box.lo.y, 1e-6);
    f.scale = std::min(0.94 * width / w, 0.90 * height / h);
    return f;
}

// The number of the layer and the height of its top.
std::string title(const Scene& scene) {
    if (scene.spans.empty() && scene.outlines.empty()) return "";
    double z = -std::numeric_limits<double>::infinity();
    for (const toolpath::Span& s : scene.spans)
        if (fills(s.role))
            for (const geom::Vec3& p : s.points) z = std::max(z, p.z);
    if (!std::isfinite(z) && !scene.outlines.empty()) z = scene.outlines.front().z;
    const std::uint32_t layer = scene.spans.empty() ? scene.outlines.front().layer : scene.spans.front().layer;
    return "layer " + std::to_string(layer) + (std::isfinite(z) ? ", z " + fixed_text(z, 2) + " mm" : "");
}

// What a sample shows.
struct Sample {
    double along = 0;       // mm of path up to the nearest bead's point
    float ratio2 = 2;       // (distance to the middle of the bead / half its width) squared; above 1: no bead
    std::uint32_t bead = 0; // index of the nearest bead
    bool twice = false;     // whether another stretch of path covers it too
    bool inside = false;    // whether it lies inside the outlines
};

struct SampledBead { // in samples
    Vec2 a, b;
    double half = 0;
};

struct Band {
    int columns = 0, rows = 0; // size in samples
    std::vector<Sample> sample;
    Sample& at(int x, int y) {
        return sample[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
    }
};

void lay(Band& band, const SampledBead& p, std::uint32_t index, const std::vector<FlatBead>& beads, double near) {
    const int x0 = std::max(0, static_cast<int>(std::ceil(std::min(p.a.x, p.b.x) - p.half - 0.5)));
    const int y0 = std::max(0, static_cast<int>(std::ceil(std::min(p.a.y, p.b.y) - p.half - 0.5)));
    const int x1 = static_cast<int>(std::min(band.columns - 1.0, std::max(p.a.x, p.b.x) + p.half));
    const int y1 = static_cast<int>(std::min(band.rows - 1.0, std::max(p.a.y, p.b.y) + p.half));
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const Vec2 q{x + 0.5, y + 0.5};
            const double t = geom::nearest_parameter(p.a, p.b, q);
            const auto r2 = static_cast<float>(geom::norm2(q - geom::lerp(p.a, p.b, t)) / (p.half * p.half));
            if (r2 > 1) continue;
            Sample& s = band.at(x, y);
            const double along = beads[index].along + t * geom::distance(beads[index].a, beads[index].b);
            if (s.ratio2 <= 1 && std::abs(along - s.along) > near) s.twice = true;
            if (r2 < s.ratio2) {
                s.ratio2 = r2;
                s.bead = index;
                s.along = along;
            }
        }
    }
}

// Marks the samples inside the outlines, by the even-odd rule along each row.
void flood(Band& band, const Scene& scene, const Frame& f, double first_row, int per_pixel) {
    std::vector<double> x;
    for (int row = 0; row < band.rows; ++row) {
        const double y = first_row + row + 0.5;
        x.clear();
        for (const Outline& o : scene.outlines) {
            for (std::size_t i = 0; i < o.loops.size(); ++i) {
                const auto loop = o.loops[i];
                for (std::size_t k = 0, j = loop.size() - 1; k < loop.size(); j = k++) {
                    const Vec2 a = per_pixel * f.to_pixel(loop[j]), b = per_pixel * f.to_pixel(loop[k]);
                    if ((a.y > y) != (b.y > y)) x.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
                }
            }
        }
        std::sort(x.begin(), x.end());
        for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
            const int from =
                static_cast<int>(std::clamp(std::ceil(x[i] - 0.5), 0.0, static_cast<double>(band.columns)));
            const int to =
                static_cast<int>(std::clamp(std::ceil(x[i + 1] - 0.5), 0.0, static_cast<double>(band.columns)));
            for (int c = from; c < to; ++c) band.at(c, row).inside = true;
        }
    }
}

struct Ink {
    Rgb paper = oklch(0.985, 0.003, 250), empty = oklch(0.60, 0.21, 25), solid = oklch(0.78, 0.07, 235);
    bool centres = true, beads = true;
};

Rgb ink_at(const Sample& s, const std::vector<Rgb>& colour, const Ink& ink) {
    if (s.ratio2 > 1) return !s.inside ? ink.paper : (ink.beads ? ink.empty : ink.solid);
    const float round = std::sqrt(1 - s.ratio2);
    Rgb c = (0.50F + 0.55F * round) * colour[s.bead];
    if (s.twice) c = 0.62F * c;
    if (ink.centres && s.ratio2 < 0.014F) c = mix(c, {1, 1, 1}, 0.75F);
    return c;
}

// The beads and the area inside the outlines as pixels.
Image raster(const Scene& scene, const Tint& tint, const FlatView& view, const FlatLayer& layer, const Frame& f,
             int width, int height, int threads) {
    const int per_pixel = std::max(2, static_cast<int>(std::ceil(std::sqrt(view.samples))));
    std::vector<Rgb> colour;
    std::vector<SampledBead> pens;
    const double from = layer.beads.empty() ? 0 : layer.beads.front().along;
    double begin = from;
    for (std::size_t k = 0; k < layer.beads.size(); ++k) {
        const FlatBead& b = layer.beads[k];
        if (b.point == 0) begin = b.along;
        colour.push_back(from_srgb8(render::colour(tint, scene, b.span, b.point, b.along - begin)));
        pens.push_back({per_pixel * f.to_pixel(b.a), per_pixel * f.to_pixel(b.b), per_pixel * f.scale * b.width / 2});
    }
    const auto bands = static_cast<std::size_t>((height + kBand - 1) / kBand);
    std::vector<std::vector<std::uint32_t>> in_band(bands);
    for (std::uint32_t k = 0; k < pens.size(); ++k) {
        const double lo = std::min(pens[k].a.y, pens[k].b.y) - pens[k].half,
                     hi = std::max(pens[k].a.y, pens[k].b.y) + pens[k].half;
        const double last = static_cast<double>(bands) - 1, high = kBand * per_pixel;
        for (auto b = static_cast<std::size_t>(std::clamp(std::floor(lo / high), 0.0, last));
             b <= static_cast<std::size_t>(std::clamp(hi / high, 0.0, last)); ++b)
            in_band[b].push_back(k);
    }
    Ink ink;
    ink.centres = view.centres && layer.width * f.scale >= 5;
    ink.beads = !layer.beads.empty();
    Image out(width, height);
    parallel::for_chunks(bands, 1, threads, [&](std::size_t b, std::size_t) {
        Band band;
        band.columns = width * per_pixel;
        band.rows = kBand * per_pixel;
        band.sample.resize(static_cast<std::size_t>(band.columns) * static_cast<std::size_t>(band.rows));
        const double first_row = static_cast<double>(b) * band.rows;
        flood(band, scene, f, first_row, per_pixel);
        for (const auto k : in_band[b]) {
            SampledBead p = pens[k];
            p.a.y -= first_row;
            p.b.y -= first_row;
            lay(band, p, k, layer.beads, 3 * layer.width);
        }
        for (int y = 0; y < kBand && static_cast<int>(b) * kBand + y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                Rgb sum;
                for (int k = 0; k < per_pixel * per_pixel; ++k)
                    sum = sum +
                          ink_at(band.at(x * per_pixel + k % per_pixel, y * per_pixel + k / per_pixel), colour, ink);
                out.set(x, static_cast<int>(b) * kBand + y, (1.0F / static_cast<float>(per_pixel * per_pixel)) * sum);
            }
        }
    });
    return out;
}

std::vector<Vec2> pixels(std::span<const Vec2> points, const Frame& f) {
    std::vector<Vec2> out;
    for (const Vec2 p : points) out.push_back(f.to_pixel(p));
    return out;
}

// Draws the same as lines and areas. Consecutive beads with the same colour and width (to 0.01 mm) become one line;
// beads beyond the page are left out.
void draw_beads(Canvas& page, const Scene& scene, const Tint& tint, const FlatView& view, const FlatLayer& layer,
                const Frame& f) {
    const Ink ink;
    for (const Outline& o : scene.outlines)
        for (std::size_t i = 0; i < o.loops.size(); ++i) page.loop(pixels(o.loops[i], f));
    page.fill(layer.beads.empty() ? ink.solid : ink.empty);
    std::vector<Vec2> line;
    Pen pen, centre{0.08 * layer.width * f.scale, {1, 1, 1}, 0.7};
    std::vector<std::vector<Vec2>> centres;
    const auto end = [&] {
        if (line.size() > 1) page.polyline(line, false, pen);
        if (line.size() > 1 && view.centres) centres.push_back(line);
        line.clear();
    };
    double begin = 0;
    for (const FlatBead& b : layer.beads) {
        if (b.point == 0) begin = b.along;
        const Rgb colour = from_srgb8(render::colour(tint, scene, b.span, b.point, b.along - begin));
        const double width = f.scale * std::max(0.01, std::round(b.width * 100) / 100);
        const Vec2 from = f.to_pixel(b.a), to = f.to_pixel(b.b);
        const bool beyond = std::max(from.x, to.x) < -width || std::min(from.x, to.x) > page.width() + width ||
                            std::max(from.y, to.y) < -width || std::min(from.y, to.y) > page.height() + width;
        if (beyond || line.empty() || !(line.back() == from) || width != pen.width || hex(colour) != hex(pen.colour))
            end();
        if (beyond) continue;
        if (line.empty()) line.push_back(from);
        line.push_back(to);
        pen = {width, colour};
    }
    end();
    for (const auto& c : centres) page.polyline(c, false, centre);
}

void draw_outlines(Canvas& page, const Scene& scene, const Frame& f) {
    const Pen pen{std::clamp(page.height() / 600.0, 1.0, 3.0), oklch(0.25, 0.02, 260), 0.8};
    for (const Outline& o : scene.outlines)
        for (std::size_t i = 0; i < o.loops.size(); ++i) page.polyline(pixels(o.loops[i], f), true, pen);
}

void draw_marks(Canvas& page, const FlatLayer& layer, const Frame& f) {
    const double size = std::clamp(0.9 * layer.width * f.scale, 4.0, 0.016 * page.height() + 4);
    for (const auto kind : {Mark::Kind::lift, Mark::Kind::end, Mark::Kind::start}) {
        for (const Mark& m : layer.marks) {
            if (m.kind != kind) continue;
            const Vec2 p = f.to_pixel(m.at);
            const double rim = std::max(2.0, 0.35 * size);
            // A lift ends where a stroke begins, so it shows as a ring around that dot and its white rim.
            const double wide = kind == Mark::Kind::lift ? size + 3 * rim : size;
            page.line(p, p, {wide + rim, {1, 1, 1}});
            page.line(p, p, {wide, mark_colour(kind)});
        }
    }
}

} // namespace

double flat_scale(const Scene& scene, const FlatView& view, int width, int height) {
    return frame(flatten(scene).box, view.around, width, height).scale;
}

void draw_flat(Canvas& page, const Scene& scene, const Tint& tint, const FlatView& view, int threads) {
    const FlatLayer layer = flatten(scene);
    const Frame f = frame(layer.box, view.around, page.width(), page.height());
    if (page.vector())
        draw_beads(page, scene, tint, view, layer, f);
    else
        page.image(raster(scene, tint, view, layer, f, page.width(), page.height(), threads));
    draw_outlines(page, scene, f);
    const Pen travel{.width = 1.2,
                     .colour = role_colour(toolpath::Role::travel),
                     .alpha = 0.7,
                     .dash = page.vector() ? layer.width * f.scale : 0};
    for (const FlatBead& t : layer.travels)
        if (view.travels) page.line(f.to_pixel(t.a), f.to_pixel(t.b), travel);
    draw_marks(page, layer, f);
    Key key(page);
    if (!view.around.empty()) key.clear(Ink{}.paper);
    key.ruler(f.scale);
    key.text(title(scene));
    add_legend(key, tint);
    if (!scene.outlines.empty() && !layer.beads.empty()) key.swatch(Ink{}.empty, "not covered");
    constexpr std::pair<Mark::Kind, const char*> kMarks[] = {
        {Mark::Kind::start, "beginning"}, {Mark::Kind::end, "end"}, {Mark::Kind::lift, "lift"}};
    for (const auto& [kind, name] : kMarks)
        if (std::ranges::any_of(layer.marks, [k = kind](const Mark& m) { return m.kind == k; }))
            key.swatch(mark_colour(kind), name);
}

} // namespace filum::render
