#include "partition/partition.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"
#include "partition/lines.hpp"
#include "partition/relax.hpp"
#include "partition/split.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace filum::partition {

namespace {

constexpr double kLeastArea = 0.01; // share of the surface
constexpr double kDetail = 0.02;    // square roots of its area
// percentile, by area, of the load that counts as its maximum, since peaks are not reliable
constexpr double kPeak = 0.99;

std::vector<std::uint32_t> all_triangles(const Sheet& sheet) {
    std::vector<std::uint32_t> out(sheet.surface.triangles.size());
    std::iota(out.begin(), out.end(), 0U);
    return out;
}

// The connected pieces of patches, which can be merged.
class PieceMerger {
  public:
    explicit PieceMerger(const Parts& parts) : s_(parts.sheet.surface), of_(pieces(parts)) {
        for (std::uint32_t t = 0; t < of_.size(); ++t) {
            if (of_[t] >= area_.size()) {
                area_.push_back(0);
                facing_.emplace_back();
                patch_.push_back(parts.patch[t]);
            }
            area_[of_[t]] += surface::area(s_, t);
            facing_[of_[t]] = facing_[of_[t]] + surface::area(s_, t) * surface::normal(s_, t);
        }
        into_.assign(area_.size(), kNone);
    }

    // Merges pieces of less area, the smallest first, with the neighbour with the longest border that may_take() them.
    void join_small(double least_area) {
        std::vector<std::map<std::uint32_t, double>> border = borders(); // mm, to neighbours
        std::set<std::pair<double, std::uint32_t>> small;
        for (std::uint32_t p = 0; p < area_.size(); ++p)
            if (area_[p] < least_area) small.emplace(area_[p], p);
        while (!small.empty()) {
            const std::uint32_t p = small.begin()->second;
            small.erase(small.begin());
            std::uint32_t to = kNone;
            for (const auto& [q, length] : border[p])
                if (may_take(facing_[q], area_[q], facing_[p], area_[p]) && (to == kNone || length > border[p][to]))
                    to = q;
            if (to == kNone) continue;
            small.erase({area_[to], to});
            area_[to] += area_[p];
            facing_[to] = facing_[to] + facing_[p];
            into_[p] = to;
            for (const auto& [q, length] : border[p]) {
                border[q].erase(p);
                if (q != to) {
                    border[q][to] += length;
                    border[to][q] += length;
                }
            }
            if (area_[to] < least_area) small.emplace(area_[to], to);
        }
    }

    // A remaining piece; triangles in their order.
    struct MergedPiece {
        double area = 0;
        std::uint32_t patch = 0;
        std::vector<std::uint32_t> triangles;
    };
    [[nodiscard]] std::vector<MergedPiece> take() const {
        std::vector<MergedPiece> out(area_.size());
        for (std::uint32_t p = 0; p < out.size(); ++p) {
            out[p].area = area_[p];
            out[p].patch = patch_[p];
        }
        for (std::uint32_t t = 0; t < of_.size(); ++t) {
            std::uint32_t p = of_[t];
            while (into_[p] != kNone) p = into_[p];
            out[p].triangles.push_back(t);
        }
        std::erase_if(out, [](const MergedPiece& p) { return p.triangles.empty(); });
        return out;
    }

  private:
    [[nodiscard]] std::vector<std::map<std::uint32_t, double>> borders() const {
        std::vector<std::map<std::uint32_t, double>> out(area_.size());
        for (std::uint32_t h = 0; h < s_.twin.size(); ++h)
            if (s_.twin[h] != kNone && of_[h / 3] != of_[s_.twin[h] / 3])
                out[of_[h / 3]][of_[s_.twin[h] / 3]] += surface::side_length(s_, h);
        return out;
    }

    const Surface& s_;
    std::vector<std::uint32_t> of_;           // per triangle: its piece
    std::vector<double> area_;                // per piece
    std::vector<Vec3> facing_;                // per piece: sum of the normals weighted by area
    std::vector<std::uint32_t> patch_, into_; // per piece; into_: the piece with which it was merged, or kNone
};

// The total of what is left out for one reason.
struct DroppedArea {
    NoteCode code;
    double area = 0;
    std::size_t count = 0;
    Vec3 at{};
    double most = 0;

    void add(const Surface& s, const PieceMerger::MergedPiece& piece) {
        area += piece.area;
        ++count;
        if (piece.area <= most) return;
        most = piece.area;
        const auto& c = s.triangles[piece.triangles[piece.triangles.size() / 2]];
        at = 1.0 / 3 * (s.vertices[c[0]] + s.vertices[c[1]] + s.vertices[c[2]]);
    }
    void note(Notes& notes) const {
        if (count > 0) notes.push_back({.code = code, .amount = area, .count = count, .x = at.x, .y = at.y});
    }
};

// Keeps the loaded part, bounded by the isoline of the smoothed load at the mask's level.
void leave_unloaded(Sheet& sheet, const Options& o, double detail, double least_area, Notes& notes) {
    const Cells c = cells(sheet.surface);
    const Pull p = pull(sheet, c, o.pull);
    std::vector<std::pair<double, double>> loads;
    for (std::size_t v = 0; v < c.area.size(); ++v) loads.emplace_back(p.load[v], c.area[v]);
    const double level = o.mask * percentile(std::move(loads), kPeak);
    if (!(level > 0)) throw Error(Exit::usage, "cannot use --mask: the surface has no load; see 'stressfield'");
    const Parts parts = split(sheet, c, above(p.load, level, c, detail));
    PieceMerger pieces(parts);
    pieces.join_small(least_area);
    DroppedArea left{NoteCode::unloaded_dropped};
    std::vector<std::uint32_t> kept;
    for (const auto& piece : pieces.take()) {
        if (piece.patch == 0)
            left.add(parts.sheet.surface, piece);
        else
            kept.insert(kept.end(), piece.triangles.begin(), piece.triangles.end());
    }
    left.note(notes);
    if (kept.empty()) throw Error(Exit::usage, "cannot use --mask: no part of the surface is loaded that much");
    std::sort(kept.begin(), kept.end());
    sheet = take(parts.sheet, kept);
}

// The connected pieces of patches; small ones are merged or left out.
std::vector<Sheet> gathered(const Parts& parts, double least_area, Notes& notes) {
    PieceMerger pieces(parts);
    pieces.join_small(least_area);
    DroppedArea left{NoteCode::face_too_small};
    auto all = pieces.take();
    std::erase_if(all, [&](const PieceMerger::MergedPiece& p) {
        if (p.area < least_area) left.add(parts.sheet.surface, p);
        return p.area < least_area;
    });
    left.note(notes);
    if (all.empty())
        throw Error(Exit::usage, "cannot use --min-area: no patch reaches " + fixed_text(least_area, 1) +
                                     " mm2; choose a smaller one");
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.area > b.area; });
    std::vector<Sheet> out;
    out.reserve(all.size());
    for (const auto& piece : all) out.push_back(take(parts.sheet, piece.triangles));
    return out;
}

void note_lost(const Sheet& sheet, Notes& notes) {
    const auto gone = [&](NoteCode code, std::size_t count) {
        if (count > 0) notes.push_back({.code = code, .count = count});
    };
    gone(NoteCode::isoline_dropped, sheet.isolines.size());
    gone(NoteCode::source_dropped, sheet.sources.vertices.size() + sheet.sources.segments.size());
}

// The sheet with its triangles separated along seams.
Sheet opened(const Sheet& sheet, const std::vector<std::vector<Vec3>>& lines, const SeamOptions& options,
             Notes& notes) {
    Sheet out = sheet;
    std::vector<char> drawn(sheet.surface.twin.size(), 0);
    const double near = surface::mean_edge(sheet.surface);
    for (const auto& line : lines)
        if (const double off = draw(out, drawn, line); off > near)
            notes.push_back({.code = NoteCode::seam_moved, .amount = off});
    const auto others = seams(out, options);
    std::transform(drawn.begin(), drawn.end(), others.begin(), drawn.begin(), [](char a, char b) { return a | b; });
    return take(out, all_triangles(out), drawn);
}

} // namespace

std::vector<Sheet> divide(Sheet sheet, const Options& o, int threads, Notes& notes) {
    const double size = surface::area(sheet.surface);
    const double detail = o.detail > 0 ? o.detail : kDetail * std::sqrt(size);
    Limits limits = o.limits;
    if (limits.least_area == 0) limits.least_area = kLeastArea * size;
    SeamOptions at = o.seams;
    at.least_area = limits.least_area;
    at.detail_area = detail * detail;
    Sheet open = opened(sheet, o.lines, at, notes);
    if (o.mask > 0) leave_unloaded(open, o, detail, limits.least_area, notes);
    const Cells c = cells(open.surface);
    Pull p = pull(open, c, o.pull);
    smooth(p, c, detail);
    const Borders borders = relax(merge(c, p, limits), c, p, detail, threads);
    auto out = gathered(split(open, c, borders), limits.least_area, notes);
    if (const auto n = static_cast<std::int64_t>(out.size()), asked = limits.patches; asked > 0 && n != asked)
        notes.push_back({.code = n > asked ? NoteCode::patches_more : NoteCode::patches_fewer,
                         .amount = 0,
                         .count = static_cast<std::uint64_t>(std::abs(n - asked))});
    if (out.size() == 1 && o.lines.empty() && out[0].surface.triangles.size() == sheet.surface.triangles.size()) {
        out[0] = std::move(sheet);
        return out;
    }
    note_lost(sheet, notes);
    return out;
}

PatchFigures figures(const Sheet& patch, const PullOptions& options) {
    const Cells c = cells(patch.surface);
    const Pull p = pull(patch, c, options);
    Proxy mean;
    for (std::size_t v = 0; v < c.area.size(); ++v) mean = joined(mean, proxy(c, p, v));
    PatchFigures out{.area = c.total, .pulled = mean.weight > 0};
    std::vector<std::pair<double, double>> angles, bends;
    double sum = 0;
    for (std::size_t v = 0; v < c.area.size(); ++v) {
        const double angle = angle_from(mean, c.normal[v], p.along[v]), weight = c.area[v] * p.trust[v];
        angles.emplace_back(angle, weight);
        sum += weight * std::cos(angle);
        bends.emplace_back(bend_from(mean, c.normal[v]), c.area[v]);
    }
    if (out.pulled) out.coherence = sum / mean.weight;
    out.angle = percentile(std::move(angles), 0.95);
    out.bend = percentile(std::move(bends), 0.95);
    return out;
}

Facts facts(const std::vector<Sheet>& patches, const PullOptions& options) {
    Facts out{{"", "patches", static_cast<double>(patches.size()), ""}, {"", "area", 0, "mm2"}};
    for (const Sheet& p : patches) {
        const PatchFigures f = figures(p, options);
        const std::string name = "patch." + p.name + ".";
        out[1].value += f.area;
        out.push_back({"", name + "area", f.area, "mm2"});
        if (f.pulled) {
            out.push_back({"", name + "coherence", f.coherence, ""});
            out.push_back({"", name + "angle", geom::degrees(f.angle), "deg"});
        }
        out.push_back({"", name + "bend", geom::degrees(f.bend), "deg"});
    }
    return out;
}

} // namespace filum::partition
