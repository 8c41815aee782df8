#include "laminate/laminate.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"
#include "laminate/edges.hpp"
#include "laminate/rims.hpp"
#include "metrics/surface/map_figures.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/locate.hpp"
#include "surface/curve/raise.hpp"
#include "surface/remesh.hpp"
#include "surfpath/outside.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>

namespace filum::laminate {

namespace {

using metrics::surface::Spread;

constexpr double kFinest = 1; // spacings: sides of the triangles on which plies are raised, as for stripes

bool runs_like(const Ply& a, const Ply& b) { return std::fmod(std::abs(a.angle - b.angle), 180) == 0; }

// The number of plies with the same direction and place as this one.
auto running_like(std::span<const Ply> plies, const Ply& ply) {
    return std::count_if(plies.begin(), plies.end(), [&](const Ply& p) { return runs_like(p, ply); });
}

// Groups of plies that must be planned one after the other: if staggered, plies of one direction need the births of
// those before.
std::vector<std::vector<std::size_t>> planning_groups(std::span<const Ply> plies, bool stagger) {
    std::vector<std::vector<std::size_t>> out;
    for (std::size_t k = 0; k < plies.size(); ++k) {
        const auto same = std::find_if(out.begin(), out.end(), [&](const auto& group) {
            return stagger && runs_like(plies[group.front()], plies[k]);
        });
        (same == out.end() ? out.emplace_back() : *same).push_back(k);
    }
    return out;
}

auto before(std::span<const Ply> plies, std::size_t k) { return running_like(plies.first(k), plies[k]); }

// Plies that run like ply k are displaced from each other by equal shares of a spacing.
double shift(std::span<const Ply> plies, std::size_t k) {
    return static_cast<double>(before(plies, k)) / static_cast<double>(running_like(plies, plies[k]));
}

void note(Notes& notes, NoteCode code, double amount, const Vec3& at) {
    notes.push_back({code, amount, 1, -1, at.x, at.y, at.z});
}

struct PlyResult {
    PlacedPly placed;
    Notes notes;
};

// The common data of all plies.
struct LaminateJob {
    std::span<const Ply> plies;
    const Options& options;
    BaseSurface base;
    Surface back; // the base reversed, if plies lie on its back
    std::vector<Edge> edges;
    std::vector<std::vector<double>> heights; // below each ply, per vertex
    std::vector<RimBeads> rims;               // per ply
    Notes notes;

    LaminateJob(const surface::Sheet& sheet, std::span<const Ply> all, const Options& o) : plies(all), options(o) {
        double finest = std::numeric_limits<double>::infinity();
        for (const Ply& p : plies) finest = std::min(finest, p.spacing);
        auto finer = surface::finer(sheet.surface, kFinest * finest);
        for (const std::uint32_t t : finer.parent)
            if (!sheet.faces.empty()) base.faces.push_back(sheet.faces[t]);
        base.surface = std::move(finer.surface);
        if (std::any_of(plies.begin(), plies.end(), [](const Ply& p) { return p.under; }))
            back = surface::curve::turned_over(base.surface);
        for (std::size_t k = 0; k < plies.size(); ++k) add_edge(k);
        if (o.ramp > 0) make_ramps(base.surface, plies, o.ramp, edges, notes);
        heights = heights_below(plies, edges, base.surface.vertices.size(), o.ramp);
        rims = rim_beads(plies.size(), o.rim_beads, o.width_change);
    }

  private:
    void add_edge(std::size_t k) {
        for (std::size_t j = 0; j < k; ++j)
            if (plies[j].within == plies[k].within) { // the same area
                edges.push_back(edges[j]);
                return;
            }
        const auto found = options.areas.find(plies[k].within);
        try {
            edges.push_back(found == options.areas.end() ? Edge{}
                                                         : edge_of(base, found->second, plies[k].spacing / 2, notes));
        } catch (const Error& e) {
            throw Error(e.exit(), ply_name(k) + ": " + e.what());
        }
    }
};

surfpath::Options planned(const LaminateJob& job, std::size_t k) {
    const Ply& ply = job.plies[k];
    const Options& o = job.options;
    surfpath::Options how;
    how.algorithm = surfpath::Algorithm::field;
    how.spacing = ply.spacing;
    how.least_radius = o.least_radius;
    how.turns = o.turns;
    how.rim_beads = job.rims[k].count;
    how.rim_bead_width = job.rims[k].width;
    how.width_change = o.width_change;
    how.strict = o.strict;
    how.max_tight = o.max_tight;
    how.min_length = o.min_length;
    how.follow.angle = 1;
    how.follow.turn = geom::radians(ply.under ? -ply.angle : ply.angle); // the back is seen mirrored
    how.follow.reference = o.reference;
    how.keep = o.keep;
    how.shift = o.stagger ? shift(job.plies, k) : 0;
    how.backwards = o.stagger && before(job.plies, k) % 2 == 1;
    how.turn_outside = o.turn_outside;
    return how;
}

constexpr const char* kEdge = "edge"; // name of the field that carries a ply's edge to a flange

// Cuts the part outside the ply's edge off a flange's sheet; none if no part of the flange is left.
std::optional<surfpath::Flange> cut_off(surfpath::Flange whole, Notes& notes) {
    const Surface& s = whole.sheet.surface;
    const Edge& edge = whole.sheet.fields.front().values;
    Surface left = surface::cut(s, edge, notes);
    const surface::curve::Locator near(s);
    surfpath::Flange out;
    out.least = whole.least;
    out.least_at = whole.least_at;
    std::copy_if(whole.lids.begin(), whole.lids.end(), std::back_inserter(out.lids),
                 [&](const surface::Lid& lid) { return edge[lid.vertex] < 0; });
    for (std::uint32_t t = 0; t < left.triangles.size(); ++t) { // in their order: the part's come first
        const auto& [a, b, c] = left.triangles[t];
        const auto at = near.nearest(1.0 / 3 * (left.vertices[a] + left.vertices[b] + left.vertices[c])).triangle;
        out.part += at < whole.part ? 1 : 0;
        out.far.push_back(whole.far[at]);
    }
    if (out.part == left.triangles.size()) return std::nullopt;
    out.sheet.surface = std::move(left);
    return out;
}

// The sheet of a ply: its ground inside its edge, and a flange at the ground's rims if requested.
std::optional<surfpath::Flange> flange(const Surface& ground, const Edge& edge, const surfpath::Options& how,
                                       Notes& notes) {
    surface::Sheet sheet{ground, {}, {}};
    if (!edge.empty()) sheet.fields = {{kEdge, edge}};
    auto out = surfpath::flange(sheet, how);
    if (out && !edge.empty()) out = cut_off(std::move(*out), notes);
    return out;
}

// Plans the ply on its ground.
void plan_ply(const surfpath::Options& how, PlyResult& out) {
    PlacedPly& to = out.placed;
    const auto outside = flange(to.ground, to.edge, how, out.notes);
    surface::Sheet sheet;
    if (outside)
        sheet = outside->sheet;
    else
        sheet.surface = to.edge.empty() ? to.ground : surface::cut(to.ground, to.edge, out.notes);
    const auto asked = outside ? surfpath::on_flange(*outside, how) : how;
    to.plan = surfpath::plan_paths(sheet, asked);
    if (outside) surfpath::thread(sheet.surface, to.plan);
    surfpath::finish(sheet.surface, to.plan, asked);
    if (outside) {
        to.part = outside->part;
        surfpath::report_trims(*outside, how.turn_outside, to.plan);
    }
    to.sheet = std::move(sheet.surface);
    if (how.turn_outside > 0 && !to.edge.empty()) out.notes.push_back({NoteCode::ply_turns_inside, 1});
}

// `born`: places of births on the plies below with the same direction.
PlyResult make(const LaminateJob& job, std::size_t k, std::vector<Vec3> born) {
    PlyResult out;
    auto up = surface::curve::raised(job.plies[k].under ? job.back : job.base.surface, job.heights[k]);
    auto how = planned(job, k);
    how.births_apart = std::move(born);
    out.placed.edge = job.edges[k];
    out.placed.ground = std::move(up.surface);
    out.placed.turn = how.follow.turn;
    plan_ply(how, out);
    auto& told = out.placed.plan.notes;
    out.notes.insert(out.notes.end(), told.begin(), told.end());
    told.clear();
    if (up.folded > 0) note(out.notes, NoteCode::ground_folds, up.folded, up.folded_at);
    if (up.blocked > 0) note(out.notes, NoteCode::ply_no_room, up.blocked, up.blocked_at);
    for (Note& n : out.notes) n.layer = static_cast<std::int64_t>(k);
    return out;
}

std::vector<PlyResult> plan_all(const LaminateJob& job, int threads) {
    const Options& o = job.options;
    std::vector<PlyResult> out(job.plies.size());
    std::mutex telling;
    const auto turns = planning_groups(job.plies, o.stagger);
    parallel::for_chunks(turns.size(), 1, threads, [&](std::size_t i, std::size_t) {
        std::vector<Vec3> born;
        for (const std::size_t k : turns[i]) {
            try {
                out[k] = make(job, k, born);
            } catch (const Error& e) {
                throw Error(e.exit(), ply_name(k) + ": " + e.what());
            }
            const auto& more = out[k].placed.plan.births;
            born.insert(born.end(), more.begin(), more.end());
            const std::lock_guard lock(telling);
            if (o.done) o.done();
        }
    });
    return out;
}

double area_within(const metrics::surface::Map& map, std::size_t k) {
    double sum = 0;
    for (std::size_t v = 0; v < map.area.size(); ++v) sum += map.area[v] * map.plies[k].inside[v];
    return sum;
}

void add_ply_facts(const Laminate& l, std::size_t k, Facts& to) {
    const std::string name = "ply." + std::to_string(k + 1) + ".";
    const auto found = metrics::surface::ply_spread(l.map, k);
    const auto fact = [&](const char* what, double value, const char* unit) {
        to.push_back({"", name + what, value, unit});
    };
    double length = 0;
    for (const auto& stroke : l.plies[k].plan.strokes)
        for (const auto& piece : stroke.sections) length += surface::curve::length(piece.line);
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
    for (const Fact& f : l.plies[k].plan.facts)
        if (f.name == "trims" || f.name == "outside" || f.name == "upright")
            fact(f.name.c_str(), f.value, f.unit.c_str());
    if (!l.plies[k].edge.empty()) fact("area", area_within(l.map, k), "mm2");
}

void add_facts(std::span<const Ply> plies, const Vec3& reference, Laminate& l) {
    double nominal = 0; // exact if all plies cover everything
    for (const Ply& p : plies) nominal += p.height;
    if (std::any_of(l.plies.begin(), l.plies.end(), [](const PlacedPly& p) { return !p.edge.empty(); }))
        nominal = spread_of(l.map, l.map.nominal).mean;
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

// The map of the laminate, computed from the toolpath itself.
metrics::surface::Map map(const Surface& base, std::span<const Ply> plies, const Options& o, const Laminate& l,
                          int threads) {
    std::vector<toolpath::Span> spans;
    add_spans(l, plies, o, 0, spans);
    metrics::surface::Fibres fibres;
    for (const auto& span : spans) metrics::surface::add(fibres, span);
    std::vector<metrics::surface::Bed> beds;
    for (std::size_t k = 0; k < l.plies.size(); ++k)
        beds.push_back({static_cast<std::uint32_t>(k),
                        l.plies[k].ground,
                        {o.reference, l.plies[k].turn, nullptr},
                        l.plies[k].edge});
    return metrics::surface::map(base, fibres, beds, threads);
}

void tell_symmetry(std::span<const Ply> plies, Laminate& l) {
    const Symmetry found = symmetry(plies);
    l.facts.push_back({"", "unsymmetric", static_cast<double>(found.unlike), ""});
    l.facts.push_back({"", "unbalanced", static_cast<double>(found.unequal), ""});
    const auto tell = [&](NoteCode code, std::size_t amount, std::int64_t ply) {
        Note n{code, static_cast<double>(amount)};
        n.layer = ply;
        if (amount > 0) l.notes.push_back(n);
    };
    tell(NoteCode::stack_unsymmetric, found.unlike, static_cast<std::int64_t>(found.first));
    tell(NoteCode::stack_unbalanced, found.unequal, -1);
}

} // namespace

Laminate laminate(const surface::Sheet& sheet, std::span<const Ply> plies, const Options& o, int threads) {
    const LaminateJob job(sheet, plies, o);
    auto made = plan_all(job, threads);
    Laminate out;
    out.notes = job.notes;
    for (PlyResult& m : made) {
        out.plies.push_back(std::move(m.placed));
        out.notes.insert(out.notes.end(), m.notes.begin(), m.notes.end());
    }
    out.map = map(job.base.surface, plies, o, out, threads);
    tell_symmetry(plies, out);
    add_facts(plies, o.reference, out);
    return out;
}

void add_spans(const Laminate& l, std::span<const Ply> plies, const Options& o, std::uint32_t layer,
               std::vector<toolpath::Span>& out) {
    for (std::size_t k = 0; k < l.plies.size(); ++k) {
        const std::uint32_t stroke = out.empty() ? 0 : out.back().stroke + 1;
        const auto begin = out.size();
        surfpath::plan::SpanOptions laying{
            plies[k].spacing, plies[k].height, o.lift, 0, layer + static_cast<std::uint32_t>(k), stroke};
        surfpath::plan::add_spans(l.plies[k].sheet, l.plies[k].plan, laying, out);
        for (std::size_t i = begin; i < out.size(); ++i) out[i].tool = plies[k].tool;
    }
}

} // namespace filum::laminate
