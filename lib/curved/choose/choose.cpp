#include "choose/choose.hpp"

#include "base/error.hpp"
#include "geodesic/measure.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/transfer.hpp"
#include "surface/remesh.hpp"
#include "surfpath/outside.hpp"
#include "surfpath/rings/reach.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>

namespace filum::choose {

namespace {

using surfpath::Algorithm;

constexpr double kRough = 2;  // factor of spacing and radius on the rough patch
constexpr double kSmall = 25; // spacings squared: no rough round on smaller patches
// shares of the area: accuracy of the coverage, in the rough and in the final round
constexpr double kStable[] = {2e-3, 1e-4};
constexpr double kFine = 0.75; // sides of the rough patch: a shorter mean edge is lengthened
const std::map<Algorithm, std::size_t> kPromising{
    {Algorithm::fina, 4}, {Algorithm::fexa, 2}, {Algorithm::ortheo, 2}, {Algorithm::field, 2}}; // others: 1

// A patch to plan candidates on, with the options for it.
struct TrialPatch {
    Sheet sheet;
    std::vector<Vec3> pull;
    surfpath::Options plan;
    double stable; // accuracy of the coverage
};

TrialPatch rough(const Sheet& sheet, const Options& o, double area) {
    TrialPatch out{{}, {}, o.plan, kStable[0]};
    const double scale = area < kSmall * kSmall * o.plan.spacing * o.plan.spacing ? 1 : kRough;
    out.plan.spacing *= scale;
    out.plan.least_radius *= scale;
    out.plan.turn_outside *= scale;
    const double edge = out.plan.spacing;
    out.sheet = sheet;
    if (surface::mean_edge(sheet.surface) < kFine * edge) try {
            Notes unsaid;
            Sheet coarse{surface::remesh(sheet.surface, edge, unsaid), {}, {}};
            coarse.fields = surface::curve::transferred(sheet.surface, sheet.fields, coarse.surface);
            out.sheet = std::move(coarse);
        } catch (const Error&) { // of CGAL; then the patch is used as it is
        }
    out.pull = pulls(out.sheet);
    return out;
}

Criteria plan_and_measure(const TrialPatch& ground, const Candidate& candidate) {
    Sheet sheet{ground.sheet.surface, {}, {}, ground.sheet.sources};
    if (candidate.algorithm == Algorithm::field) sheet.fields = ground.sheet.fields;
    put(sheet, ground.pull, candidate.seed);
    surfpath::Options plan = ground.plan;
    plan.algorithm = candidate.algorithm;
    const auto flange = surfpath::flange(sheet, plan);
    if (flange) plan = surfpath::on_flange(*flange, std::move(plan));
    const Sheet& on = flange ? flange->sheet : sheet;
    metrics::surface::Fibres fibres;
    surfpath::plan::SpanOptions laying;
    laying.width = plan.spacing;
    surfpath::Plan path = surfpath::plan_paths(on, plan);
    surfpath::leave_out_short(path, plan.min_length);
    for (const auto& span : surfpath::plan::spans(on.surface, path, laying)) metrics::surface::add(fibres, span);
    return measure(fibres, ground.sheet, plan.spacing, plan.least_radius, ground.stable);
}

// The approximate part of the work that a round takes: estimates, rough paths, final paths.
struct RoundShare {
    double from, to;
};
constexpr RoundShare kEstimating{0, 0.05}, kTrying{0.05, 0.3}, kLaying{0.3, 1};

// Reports progress by the number of finished trials of a round.
class ProgressCounter {
  public:
    ProgressCounter(const Options& o, const RoundShare& round, std::size_t trials)
        : report_(o.far), round_(round), trials_(trials) {}
    void step() {
        const std::lock_guard lock(one_);
        const double share = static_cast<double>(++done_) / static_cast<double>(trials_);
        if (report_) report_(round_.from + share * (round_.to - round_.from));
    }

  private:
    const std::function<void(double)>& report_;
    RoundShare round_;
    std::size_t trials_, done_ = 0;
    std::mutex one_;
};

// Runs `work` for the trials with these numbers; an exception becomes the reason of their failure.
template <class Work>
void each(std::vector<Trial>& trials, const std::vector<std::size_t>& which, ProgressCounter& far, int threads,
          const Work& work) {
    parallel::for_chunks(which.size(), 1, threads, [&](std::size_t k, std::size_t) {
        Trial& trial = trials[which[k]];
        try {
            work(trial);
        } catch (const std::exception& e) {
            trial.failed = e.what();
        }
        far.step();
    });
}

// The trials worth planning on the rough patch.
std::vector<std::size_t> promising(const std::vector<Trial>& trials) {
    std::vector<std::size_t> order(trials.size()), out;
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto worth = [&](std::size_t i) { return std::isnan(trials[i].estimate) ? 0 : trials[i].estimate; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return worth(a) > worth(b); });
    std::map<Algorithm, std::size_t> taken;
    for (const std::size_t i : order) {
        const Candidate& c = trials[i].candidate;
        if (!trials[i].failed.empty() || c.seed.kind == Seed::Kind::given) continue;
        const auto most = kPromising.find(c.algorithm);
        if (taken[c.algorithm]++ < (most == kPromising.end() ? 1 : most->second)) out.push_back(i);
    }
    return out;
}

void finals(std::vector<Trial>& trials, std::vector<std::size_t> left, const TrialPatch& ground, const Options& o,
            int threads) {
    std::erase_if(left, [&](std::size_t i) { return !trials[i].rough; });
    std::sort(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
        return trials[a].rough_score > trials[b].rough_score ||
               (trials[a].rough_score == trials[b].rough_score && a < b);
    });
    std::vector<std::size_t> now;
    for (std::size_t i = 0; i < trials.size(); ++i)
        if (trials[i].candidate.seed.kind == Seed::Kind::given) now.push_back(i);
    for (std::size_t next = 0, found = 0; found == 0 && (next < left.size() || !now.empty()); now.clear()) {
        for (std::int64_t k = 0; k < o.finals && next < left.size(); ++k) now.push_back(left[next++]);
        ProgressCounter far(o, kLaying, now.size());
        each(trials, now, far, threads, [&](Trial& t) {
            t.found = plan_and_measure(ground, t.candidate);
            t.score = score(*t.found, o.weights, o.plan.cut_length);
        });
        for (const std::size_t i : now) found += trials[i].found ? 1 : 0;
    }
}

// What is tried: candidates of all algorithms, or of those that are asked for.
std::vector<Candidate> tried(const Sheet& sheet, const std::vector<Vec3>& pull, const Options& o) {
    if (o.by_hand) {
        Seed given;
        given.kind = Seed::Kind::given;
        return {{o.plan.algorithm, given}};
    }
    auto out = candidates(sheet, pull);
    if (!o.among.empty())
        std::erase_if(out, [&](const Candidate& c) {
            return std::find(o.among.begin(), o.among.end(), c.algorithm) == o.among.end();
        });
    if (out.empty())
        throw Error(Exit::failure, "cannot propose a path: the surface has no candidate of the algorithms asked for");
    return out;
}

} // namespace

Choice choose(Sheet& sheet, const Options& o, int threads, Notes& notes) {
    Choice out;
    out.area = surface::area(sheet.surface);
    out.rings_bound = surfpath::rings::ring_bound(sheet.surface, o.plan.spacing, o.plan.least_radius).share();
    const bool rings = o.plan.algorithm == Algorithm::geo_fiso || o.plan.algorithm == Algorithm::geo_contour;
    if (o.by_hand && rings && sheet.sources.empty()) sheet.sources = sources(sheet, {}, {});
    const TrialPatch ground{sheet, pulls(sheet), o.plan, kStable[1]};
    for (const Candidate& c : tried(sheet, ground.pull, o)) out.trials.push_back({c, std::nan(""), {}, {}, 0, 0, {}});
    const TrialPatch small = o.by_hand ? TrialPatch{} : rough(sheet, o, out.area);
    std::vector<std::size_t> all(out.trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    ProgressCounter estimated(o, kEstimating, all.size());
    each(out.trials, all, estimated, threads, [&](Trial& t) {
        if (t.candidate.seed.kind != Seed::Kind::given) t.estimate = estimate(small.sheet, small.pull, t.candidate);
    });
    const auto some = promising(out.trials);
    ProgressCounter laid_roughly(o, kTrying, some.size());
    each(out.trials, some, laid_roughly, threads, [&](Trial& t) {
        t.rough = plan_and_measure(small, t.candidate);
        t.rough_score = score(*t.rough, o.weights, o.plan.cut_length);
    });
    finals(out.trials, some, ground, o, threads);
    for (std::size_t i = 0; i < out.trials.size(); ++i)
        if (out.trials[i].found && (out.best == kNothing || out.trials[i].score > out.trials[out.best].score))
            out.best = i;
    sheet.isolines.clear();
    if (out.best == kNothing) {
        sheet.algorithm.clear();
        const Vec3& p = sheet.surface.vertices.front();
        notes.push_back({.code = NoteCode::no_path_found, .amount = out.area, .x = p.x, .y = p.y, .z = p.z});
        return out;
    }
    const Candidate& best = out.trials[out.best].candidate;
    sheet.algorithm = surfpath::name(best.algorithm);
    put(sheet, ground.pull, best.seed);
    if (!sheet.sources.empty()) geodesic::measure(sheet, surface::Sources(sheet.sources), {}, notes);
    return out;
}

} // namespace filum::choose
