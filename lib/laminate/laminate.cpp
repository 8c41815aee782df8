#include "laminate/laminate.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"
#include "metrics/surface/map_figures.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/raise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::laminate {

namespace {

using metrics::surface::Spread;

constexpr double kFinest = 1; // spacings: sides of the triangles that plies are raised on, as those of stripes

std::string named(std::size_t k) { return "ply " + std::to_string(k + 1); }

// What lies below each ply on its side, mm.
std::vector<double> below(std::span<const Ply> plies) {
    std::vector<double> out;
    double height[2] = {0, 0};
    for (const Ply& p : plies) {
        out.push_back(height[p.under ? 1 : 0]);
        height[p.under ? 1 : 0] += p.height;
    }
    return out;
}

// Of the plies that run like ply k, each lies another share of half a spacing beside the first.
double shift(std::span<const Ply> plies, std::size_t k) {
    const auto like = [&](const Ply& p) { return std::fmod(std::abs(p.angle - plies[k].angle), 180) == 0; };
    const auto n = std::count_if(plies.begin(), plies.end(), like);
    const auto before = std::count_if(plies.begin(), plies.begin() + static_cast<std::ptrdiff_t>(k), like);
    return static_cast<double>(before) / static_cast<double>(n);
}

void note(Notes& notes, const std::string& what, double amount, const char* unit, const Vec3& at) {
    notes.push_back({"", what, amount, unit, 1, -1, at.x, at.y, at.z});
}

struct Made {
    Laid laid;
    Notes notes;
};

Made make(const Surface& base, std::span<const Ply> plies, std::size_t k, double height, const Options& o) {
    const Ply& ply = plies[k];
    auto up = surface::curve::raised(base, height);
    surfpath::Options how;
    how.algorithm = surfpath::Algorithm::field;
    how.spacing = ply.spacing;
    how.least_radius = o.least_radius;
    how.strict = o.strict;
    how.follow.angle = 1;
    how.follow.turn = geom::radians(ply.under ? -ply.angle : ply.angle); // the back is seen mirrored
    how.follow.reference = o.reference;
    how.keep = o.keep;
    how.shift = o.stagger ? shift(plies, k) : 0;
    surface::Sheet sheet{std::move(up.surface), {}, {}};
    Made out;
    auto plan = surfpath::plan(sheet, how);
    surfpath::finish(sheet.surface, plan, how);
    out.laid = {std::move(sheet.surface), std::move(plan), how.follow.turn};
    out.notes.swap(out.laid.plan.notes);
    if (up.folded > 0)
        note(out.notes, "ground folds: a groove is narrower than the plies", up.folded, "mm2", up.folded_at);
    if (up.blocked > 0) note(out.notes, "no room for the ply", up.blocked, "mm2", up.blocked_at);
    for (Note& n : out.notes) n.layer = static_cast<std::int64_t>(k);
    return out;
}

void add_ply_facts(const Laminate& l, std::size_t k, Facts& to) {
    const std::string name = "ply." + std::to_string(k + 1) + ".";
    const auto found = metrics::surface::ply_spread(l.map, k);
    const auto fact = [&](const char* what, double value, const char* unit) {
        to.push_back({"", name + what, value, unit});
    };
    double length = 0;
    for (const auto& stroke : l.plies[k].plan.strokes)
        for (const auto& piece : stroke.pieces) length += surface::curve::length(piece.line);
    const auto strokes = l.plies[k].plan.strokes.size();
    fact("cuts", strokes == 0 ? 0 : static_cast<double>(strokes - 1), "");
    fact("length", length, "mm");
    fact("bare", found.bare, "");
    fact("twice", found.twice, "");
    fact("thrice", found.thrice, "");
    fact("gap", found.gap, "mm");
    fact("asked", geom::degrees(l.plies[k].turn), "deg");
    fact("angle-median", found.off_median, "deg");
    fact("angle-mean", found.off_mean, "deg");
    fact("angle-within", found.within, "");
}

void add_facts(std::span<const Ply> plies, const Vec3& reference, Laminate& l) {
    double nominal = 0;
    for (const Ply& p : plies) nominal += p.height;
    const auto fact = [&](const char* what, double value, const char* unit) {
        l.facts.push_back({"", what, value, unit});
    };
    const Spread t = spread_of(l.map, l.map.thickness), even = spread_of(l.map, l.map.even);
    fact("plies", static_cast<double>(plies.size()), "");
    fact("thickness-nominal", nominal, "mm");
    fact("thickness-mean", t.mean, "mm");
    fact("thickness-least", t.least, "mm");
    fact("thickness-low", t.low, "mm");
    fact("thickness-high", t.high, "mm");
    fact("thickness-most", t.most, "mm");
    fact("even-least", even.least, "mm");
    fact("even-most", even.most, "mm");
    fact("reference-x", reference.x, "");
    fact("reference-y", reference.y, "");
    fact("reference-z", reference.z, "");
    for (std::size_t k = 0; k < plies.size(); ++k) add_ply_facts(l, k, l.facts);
}

// What lies where, by the toolpath itself.
metrics::surface::Map map(const Surface& base, std::span<const Ply> plies, const Options& o, const Laminate& l,
                          int threads) {
    std::vector<toolpath::Span> spans;
    add_spans(l, plies, o, 0, spans);
    metrics::surface::Fibres fibres;
    for (const auto& span : spans) metrics::surface::add(fibres, span);
    std::vector<metrics::surface::Bed> beds;
    for (std::size_t k = 0; k < l.plies.size(); ++k)
        beds.push_back({static_cast<std::uint32_t>(k), l.plies[k].ground, {o.reference, l.plies[k].turn}});
    return metrics::surface::map(base, fibres, beds, threads);
}

void tell_symmetry(std::span<const Ply> plies, Laminate& l) {
    const Symmetry found = symmetry(plies);
    l.facts.push_back({"", "unsymmetric", static_cast<double>(found.unlike), ""});
    l.facts.push_back({"", "unbalanced", static_cast<double>(found.unequal), ""});
    const auto tell = [&](const char* what, std::size_t amount, std::int64_t ply) {
        Note n{"", what, static_cast<double>(amount), "plies"};
        n.layer = ply;
        if (amount > 0) l.notes.push_back(n);
    };
    tell("stack is not symmetric: it will warp", found.unlike, static_cast<std::int64_t>(found.first));
    tell("stack is not balanced: more plies one way than the other", found.unequal, -1);
}

} // namespace

Laminate laminate(const surface::Sheet& sheet, std::span<const Ply> plies, const Options& o, int threads) {
    double finest = std::numeric_limits<double>::infinity();
    bool back = false;
    for (const Ply& p : plies) {
        finest = std::min(finest, p.spacing);
        back = back || p.under;
    }
    const Surface base = surface::finer(sheet.surface, kFinest * finest).surface;
    const Surface other = back ? surface::curve::turned_over(base) : Surface{};
    const auto heights = below(plies);
    std::vector<Made> made(plies.size());
    parallel::for_chunks(plies.size(), 1, threads, [&](std::size_t k, std::size_t) {
        try {
            made[k] = make(plies[k].under ? other : base, plies, k, heights[k], o);
        } catch (const Error& e) {
            throw Error(e.exit(), named(k) + ": " + e.what());
        }
    });
    Laminate out;
    for (Made& m : made) {
        out.plies.push_back(std::move(m.laid));
        out.notes.insert(out.notes.end(), m.notes.begin(), m.notes.end());
    }
    out.map = map(base, plies, o, out, threads);
    tell_symmetry(plies, out);
    add_facts(plies, o.reference, out);
    return out;
}

void add_spans(const Laminate& l, std::span<const Ply> plies, const Options& o, std::uint32_t layer,
               std::vector<toolpath::Span>& out) {
    for (std::size_t k = 0; k < l.plies.size(); ++k) {
        const std::uint32_t stroke = out.empty() ? 0 : out.back().stroke + 1;
        const auto begin = out.size();
        surfpath::Laying laying{
            plies[k].spacing, plies[k].height, o.lift, 0, layer + static_cast<std::uint32_t>(k), stroke};
        surfpath::add_spans(l.plies[k].ground, l.plies[k].plan, laying, out);
        for (std::size_t i = begin; i < out.size(); ++i) out[i].tool = plies[k].tool;
    }
}

} // namespace filum::laminate
