#include "surfpath/patches.hpp"

#include "base/error.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>

namespace filum::surfpath {

namespace {

Note unplanned(const surface::Sheet& sheet) {
    Note out{.code = NoteCode::patch_unplanned, .amount = surface::area(sheet.surface)};
    const geom::Vec3& p = sheet.surface.vertices.front();
    out.x = p.x;
    out.y = p.y;
    out.z = p.z;
    return out;
}

// Plans patch `k`; errors name it.
plan::Plan plan_patch(const std::function<plan::Plan(std::size_t)>& plan, std::size_t k, const std::string& name) {
    try {
        return plan(k);
    } catch (const Error& e) {
        throw Error(e.exit(), "patch '" + name + "': " + e.what());
    }
}

} // namespace

std::string label(std::span<const surface::Sheet> sheets, std::size_t k) {
    return sheets[k].name.empty() ? std::to_string(k + 1) : sheets[k].name;
}

Algorithms algorithms(std::span<const surface::Sheet> sheets, std::optional<Algorithm> asked) {
    if (sheets.empty()) throw Error(Exit::bad_input, "cannot lay a path: the stream holds no surface");
    if (asked) return Algorithms(sheets.size(), asked);
    Algorithms out;
    for (const auto& s : sheets) {
        out.push_back(algorithm(s.algorithm));
        if (!out.back() && !s.algorithm.empty())
            throw Error(Exit::usage, "unknown algorithm '" + s.algorithm + "' in the stream");
    }
    const bool none = std::none_of(out.begin(), out.end(), [](const auto& a) { return a.has_value(); });
    if (none) out.assign(out.size(), Algorithm::geo_fiso);
    return out;
}

Patches each_patch(std::span<const surface::Sheet> sheets, const Algorithms& algorithms, int threads,
                   const std::function<plan::Plan(std::size_t)>& plan) {
    const bool several = sheets.size() > 1;
    Patches out;
    out.plans.resize(sheets.size());
    parallel::for_chunks(sheets.size(), 1, threads, [&](std::size_t k, std::size_t) {
        if (!algorithms[k])
            out.plans[k].notes.push_back(unplanned(sheets[k]));
        else
            out.plans[k] = several ? plan_patch(plan, k, label(sheets, k)) : plan(k);
    });
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        for (Note& note : out.plans[k].notes) {
            if (several) note.patch = label(sheets, k);
            out.notes.push_back(std::move(note));
        }
        for (Fact& fact : out.plans[k].facts) {
            if (several) fact.name = "patch." + label(sheets, k) + "." + fact.name;
            out.facts.push_back(std::move(fact));
        }
        out.plans[k].notes.clear();
        out.plans[k].facts.clear();
    }
    return out;
}

std::vector<toolpath::Span> spans(std::span<const surface::Sheet> sheets, std::span<const plan::Plan> plans,
                                  const plan::SpanOptions& options) {
    std::vector<toolpath::Span> out;
    plan::SpanOptions now = options;
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        plan::add_spans(sheets[k].surface, plans[k], now, out);
        now.stroke += static_cast<std::uint32_t>(plans[k].strokes.size());
    }
    return out;
}

} // namespace filum::surfpath
