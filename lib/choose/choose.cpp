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

constexpr double kRough = 2;               // spacings and radii of the rough patch, of those asked for
constexpr double kSmall = 25;              // spacings square: smaller patches are not laid roughly
constexpr double kStable[] = {2e-3, 1e-4}; // of the area: to what coverage is measured, roughly and at last
constexpr double kFine = 0.75;             // of the sides asked for: a mean edge below is made longer
const std::map<Algorithm, std::size_t> kPromising{
    {Algorithm::fina, 4}, {Algorithm::fexa, 2}, {Algorithm::ortheo, 2}, {Algorithm::field, 2}}; // others: 1

// A patch to lay candidates on, by these options.
struct Ground {
    Sheet sheet;
    std::vector<Vec3> pull;
    surfpath::Options plan;
    double stable; // to what coverage is measured
};

Ground rough(const Sheet& sheet, const Options& o, double area) {
    Ground out{{}, {}, o.plan, kStable[0]};
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
        } catch (const Error&) { // of CGAL: then on the patch as it is
        }
    out.pull = pulls(out.sheet);
    return out;
}

Criteria lay(const Ground& ground, const Candidate& candidate) {
    Sheet sheet{ground.sheet.surface, {}, {}, ground.sheet.sources};
    if (candidate.algorithm == Algorithm::field) sheet.fields = ground.sheet.fields;
    put(sheet, ground.pull, candidate.seed);
    surfpath::Options plan = ground.plan;
    plan.algorithm = candidate.algorithm;
    const auto flange = surfpath::flange(sheet, plan);
    if (flange) plan = surfpath::on_flange(*flange, std::move(plan));
    const Sheet& on = flange ? flange->sheet : sheet;
    metrics::surface::Fibres fibres;
    surfpath::plan::Laying laying;
    laying.width = plan.spacing;
    for (const auto& span : surfpath::plan::spans(on.surface, surfpath::plan_paths(on, plan), laying))
        metrics::surface::add(fibres, span);
    return measure(fibres, ground.sheet, plan.spacing, ground.stable);
}

// What part of the work a round is, about: estimates, on the rough patch, as asked.
struct Round {
    double from, to;
};
constexpr Round kEstimating{0, 0.05}, kTrying{0.05, 0.3}, kLaying{0.3, 1};

// Counts the trials of a round that are done.
class Far {
  public:
    Far(const Options& o, const Round& round, std::size_t trials) : tell_(o.far), round_(round), trials_(trials) {}
    void step() {
        const std::lock_guard lock(one_);
        const double share = static_cast<double>(++done_) / static_cast<double>(trials_);
        if (tell_) tell_(round_.from + share * (round_.to - round_.from));
    }

  private:
    const std::function<void(double)>& tell_;
    Round round_;
    std::size_t trials_, done_ = 0;
    std::mutex one_;
};

// Does `work` for the trials of these numbers; what it throws is why they failed.
template <class Work>
void each(std::vector<Trial>& trials, const std::vector<std::size_t>& which, Far& far, int threads, const Work& work) {
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

// The trials that are worth laying roughly.
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

void finals(std::vector<Trial>& trials, std::vector<std::size_t> left, const Ground& ground, const Options& o,
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
        Far far(o, kLaying, now.size());
        each(trials, now, far, threads, [&](Trial& t) {
            t.found = lay(ground, t.candidate);
            t.score = score(*t.found, o.weights, o.plan.cut_length);
        });
        for (const std::size_t i : now) found += trials[i].found ? 1 : 0;
    }
}

std::vector<Candidate> by_hand(const Options& o) {
    Seed given;
    given.kind = Seed::Kind::given;
    return {{o.plan.algorithm, given}};
}

} // namespace

Choice choose(Sheet& sheet, const Options& o, int threads, Notes& notes) {
    Choice out;
    out.area = surface::area(sheet.surface);
    out.rings_bound = surfpath::rings::reach(sheet.surface, o.plan.spacing, o.plan.least_radius).share();
    const bool rings = o.plan.algorithm == Algorithm::geo_fiso || o.plan.algorithm == Algorithm::geo_contour;
    if (o.by_hand && rings && sheet.sources.empty()) sheet.sources = sources(sheet, {}, {});
    const Ground ground{sheet, pulls(sheet), o.plan, kStable[1]};
    for (const Candidate& c : o.by_hand ? by_hand(o) : candidates(sheet, ground.pull))
        out.trials.push_back({c, std::nan(""), {}, {}, 0, 0, {}});
    const Ground small = o.by_hand ? Ground{} : rough(sheet, o, out.area);
    std::vector<std::size_t> all(out.trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    Far estimated(o, kEstimating, all.size());
    each(out.trials, all, estimated, threads, [&](Trial& t) {
        if (t.candidate.seed.kind != Seed::Kind::given) t.estimate = estimate(small.sheet, small.pull, t.candidate);
    });
    const auto some = promising(out.trials);
    Far tried(o, kTrying, some.size());
    each(out.trials, some, tried, threads, [&](Trial& t) {
        t.rough = lay(small, t.candidate);
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
