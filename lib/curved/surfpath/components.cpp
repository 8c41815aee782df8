#include "surfpath/components.hpp"

#include "base/error.hpp"
#include "parallel/parallel.hpp"
#include "surface/components.hpp"
#include "surfpath/fexa.hpp"
#include "surfpath/plan/nearest_order.hpp"

#include <algorithm>
#include <exception>
#include <string_view>
#include <tuple>

namespace filum::surfpath {

namespace {

using surface::Component;

// for these facts the greatest value counts; others are summed
constexpr std::string_view kGreatest[] = {"tightest-bend", "spacing-change", "seam-lanes", "seam-length"};

auto in_order(const Vec3& p) { return std::tuple(p.x, p.y, p.z); }

// Sorts components by their smallest vertex (x, y, z), so that the result does not depend on the order of triangles.
void sort_by_place(std::vector<Component>& parts) {
    struct Key {
        Vec3 least, greatest;
        std::uint32_t part;
    };
    std::vector<Key> keys;
    for (std::uint32_t k = 0; k < parts.size(); ++k) {
        const auto& vertices = parts[k].sheet.surface.vertices;
        const auto [least, greatest] = std::minmax_element(
            vertices.begin(), vertices.end(), [](const Vec3& a, const Vec3& b) { return in_order(a) < in_order(b); });
        keys.push_back({*least, *greatest, k});
    }
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
        return std::tuple(in_order(a.least), in_order(a.greatest), a.part) <
               std::tuple(in_order(b.least), in_order(b.greatest), b.part);
    });
    std::vector<Component> out;
    out.reserve(keys.size());
    for (const Key& key : keys) out.push_back(std::move(parts[key.part]));
    parts = std::move(out);
}

bool needs_source(Algorithm a) { return a == Algorithm::fina || a == Algorithm::ortheo || a == Algorithm::geo_spiral; }

Plan left_out(const Component& part, const std::string& why) {
    const Surface& s = part.sheet.surface;
    const Vec3& p = s.vertices.front();
    Plan out;
    out.notes.push_back({NoteCode::component_dropped, surface::area(s), 1, -1, p.x, p.y, p.z, why});
    return out;
}

struct ComponentPlan {
    Plan plan;
    std::exception_ptr failed; // set if planning failed and the component is left out
};

ComponentPlan planned(const Component& part, const Options& o, const Planner& plan) {
    try {
        ComponentPlan out{plan(part.sheet, o), nullptr};
        for (Stroke& stroke : out.plan.strokes)
            for (Section& piece : stroke.sections)
                for (Place& p : piece.line.places) p.triangle = part.triangles[p.triangle];
        return out;
    } catch (const Error& e) {
        if (e.exit() == Exit::usage) throw;
        return {left_out(part, e.what()), std::current_exception()};
    }
}

void add_up(const Fact& fact, Facts& to) {
    const auto it = std::find_if(to.begin(), to.end(), [&](const Fact& f) { return f.name == fact.name; });
    if (it == to.end())
        to.push_back(fact);
    else if (std::find(std::begin(kGreatest), std::end(kGreatest), fact.name) != std::end(kGreatest))
        it->value = std::max(it->value, fact.value);
    else
        it->value += fact.value;
}

// Reverses the order and the direction of all strokes. Every place keeps its triangle.
void reverse(std::vector<Stroke>& strokes) {
    std::reverse(strokes.begin(), strokes.end());
    for (Stroke& stroke : strokes) {
        std::reverse(stroke.sections.begin(), stroke.sections.end());
        for (Section& piece : stroke.sections) std::reverse(piece.line.places.begin(), piece.line.places.end());
    }
}

Plan together(std::vector<Plan> plans) {
    Plan out;
    for (Plan& plan : plans) {
        for (const Fact& fact : plan.facts) add_up(fact, out.facts);
        std::move(plan.notes.begin(), plan.notes.end(), std::back_inserter(out.notes));
        out.births.insert(out.births.end(), plan.births.begin(), plan.births.end());
    }
    std::erase_if(plans, [](const Plan& plan) { return plan.strokes.empty(); });
    std::vector<plan::EndPoints> ends;
    ends.reserve(plans.size());
    for (const Plan& plan : plans)
        ends.push_back({plan.strokes.front().sections.front().line.places.front().point,
                        plan.strokes.back().sections.back().line.places.back().point});
    for (const plan::Visit& visit : plan::nearest_order(ends)) {
        auto& strokes = plans[visit.row].strokes;
        if (visit.reversed) reverse(strokes);
        std::move(strokes.begin(), strokes.end(), std::back_inserter(out.strokes));
    }
    for (Fact& fact : out.facts)
        if (fact.name == "cuts") fact.value = out.strokes.empty() ? 0 : static_cast<double>(out.strokes.size() - 1);
    if (plans.size() > 1)
        out.notes.push_back({NoteCode::component_cut, static_cast<double>(plans.size() - 1), plans.size() - 1});
    return out;
}

} // namespace

Plan each_component(const surface::Sheet& sheet, const Options& options, const Planner& plan) {
    auto parts = surface::components(sheet);
    sort_by_place(parts);
    // components without a source are left out
    const bool sourceless = needs_source(options.algorithm) && !sheet.sources.empty();
    Options common = options;
    if (options.algorithm == Algorithm::fexa) common.plane = plane_of(sheet.surface, sheet.sources);
    common.beyond.clear();
    std::vector<ComponentPlan> all(parts.size());
    parallel::for_chunks(parts.size(), 1, 0, [&](std::size_t k, std::size_t) {
        if (sourceless && parts[k].sheet.sources.empty()) {
            all[k].plan = left_out(parts[k], "no source lies on it");
            return;
        }
        Options own = common;
        if (!options.beyond.empty())
            for (const std::uint32_t t : parts[k].triangles) own.beyond.push_back(options.beyond[t]);
        all[k] = planned(parts[k], own, plan);
    });
    std::vector<Plan> plans;
    std::size_t failed = 0;
    for (ComponentPlan& one : all) {
        failed += one.failed ? 1 : 0;
        plans.push_back(std::move(one.plan));
    }
    if (failed > 0 && std::all_of(plans.begin(), plans.end(), [](const Plan& p) { return p.strokes.empty(); }))
        std::rethrow_exception(std::find_if(all.begin(), all.end(), [](const ComponentPlan& one) {
                                   return one.failed != nullptr;
                               })->failed);
    return together(std::move(plans));
}

} // namespace filum::surfpath
