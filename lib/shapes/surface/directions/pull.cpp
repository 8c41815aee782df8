#include "surface/directions/pull.hpp"

#include "base/error.hpp"
#include "surface/directions/rosy.hpp"

#include <algorithm>

namespace filum::surface::directions {

namespace {

constexpr double kFull = 0.9;  // share of the area below the load that gives full trust
constexpr double kLeast = 0.2; // trust of directions where there is almost no load

struct LoadCase {
    const surface::Field* d = nullptr;
    const surface::Field* s = nullptr; // none: the length of the vector
};

const surface::Field* find(const surface::Sheet& sheet, const std::string& name, std::uint32_t components) {
    for (const auto& f : sheet.fields) {
        if (f.name != name) continue;
        if (f.components != components)
            throw Error(Exit::bad_input,
                        "cannot use field '" + name + "': it contains no " + (components == 3 ? "vectors" : "numbers"));
        return &f;
    }
    return nullptr;
}

std::vector<LoadCase> cases_of(const surface::Sheet& sheet, const PullOptions& o) {
    if (!o.field.empty()) {
        if (const auto* f = find(sheet, o.field, 3)) return {{f, nullptr}};
        throw Error(Exit::usage, "cannot use --field: the surface has no field '" + o.field + "'; see 'peek --text'");
    }
    std::vector<LoadCase> out;
    if (o.by == PullOptions::Basis::shape) return out;
    const auto add = [&](const std::string& name) {
        const LoadCase c{find(sheet, "stress." + name + ".d1", 3), find(sheet, "stress." + name + ".s1", 1)};
        if (c.d == nullptr)
            throw Error(Exit::usage, "cannot use case '" + name + "': the surface has no field 'stress." + name +
                                         ".d1'; use 'stressfield'");
        out.push_back(c);
    };
    for (const auto& name : o.cases) add(name);
    for (const auto& f : sheet.fields)
        if (o.cases.empty() && f.name.starts_with("stress.") && f.name.ends_with(".d1"))
            add(f.name.substr(7, f.name.size() - 10));
    if (out.empty() && o.by == PullOptions::Basis::stress)
        throw Error(Exit::usage, "cannot divide by stress: the surface has no field 'stress.CASE.d1'; use "
                                 "'stressfield', --field or --by shape");
    return out;
}

// The tension of a case at a vertex: its tangential direction times the load, (0, 0, 0) if there is none.
Vec3 pulled(const LoadCase& c, std::size_t v, const Vec3& n) {
    const Vec3 d = c.d->vector(v);
    const double length = norm(d), s = c.s != nullptr ? c.s->values[v] : length;
    if (!std::isfinite(length) || !std::isfinite(s) || !(length > 0) || !(s > 0)) return {};
    const Vec3 flat = 1 / length * (d - dot(d, n) * n);
    return s * norm(flat) * flat; // of length s (d . p)^2
}

} // namespace

Pull pull(const surface::Sheet& sheet, const Cells& cells, const PullOptions& options) {
    const auto cases = cases_of(sheet, options);
    const std::size_t n = sheet.surface.vertices.size();
    Pull out{std::vector<Vec3>(n), std::vector<double>(n, 0), std::vector<double>(n, 0)};
    std::vector<std::pair<double, double>> loads;
    for (std::size_t v = 0; v < n; ++v) {
        for (const LoadCase& c : cases) {
            const Vec3 d = pulled(c, v, cells.normal[v]);
            if (const double load = norm(d); load > out.load[v]) {
                out.load[v] = load;
                out.along[v] = 1 / load * d;
            }
        }
        loads.emplace_back(out.load[v], cells.area[v]);
    }
    const double most = std::max_element(loads.begin(), loads.end())->first;
    const double usual = percentile(std::move(loads), kFull), full = usual > 0 ? usual : most;
    for (std::size_t v = 0; v < n && full > 0; ++v) out.trust[v] = std::min(1.0, out.load[v] / full);
    return out;
}

void smooth(Pull& p, const Cells& cells, double length) {
    if (std::none_of(p.trust.begin(), p.trust.end(), [](double t) { return t > 0; })) return;
    std::vector<Complex> given(p.load.size());
    for (std::size_t v = 0; v < given.size(); ++v) given[v] = doubled(p.along[v], cells.normal[v]);
    const auto z = Smoother(cells, length).smoothed(given, p.trust);
    for (std::size_t v = 0; v < p.load.size(); ++v) {
        const double sure = std::abs(z[v]);
        p.along[v] = sure > 1e-6 ? direction(z[v], cells.normal[v]) : Vec3{};
        p.trust[v] = sure > 1e-6 ? std::min(1.0, sure) * std::max(kLeast, p.trust[v]) : 0;
    }
}

} // namespace filum::surface::directions
