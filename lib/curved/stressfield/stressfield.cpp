#include "stressfield/stressfield.hpp"

#include "base/error.hpp"
#include "parallel/parallel.hpp"
#include "stressfield/principal.hpp"
#include "stressfield/stencil.hpp"
#include "stressfield/triangle.hpp"

namespace filum::stressfield {

namespace {

const double kOut = std::sqrt(0.5); // sine of 45 degrees

// The stress at a vertex.
struct VertexStress {
    bool known = false;
    PrincipalAxes axes;
    std::optional<Vec3> tangent;
};

std::vector<double> areas(const Surface& s) {
    std::vector<double> out(s.vertices.size());
    for (const auto& t : s.triangles) {
        const Vec3 a = s.vertices[t[0]];
        const double share = norm(cross(s.vertices[t[1]] - a, s.vertices[t[2]] - a)) / 6;
        for (const auto v : t) out[v] += share;
    }
    return out;
}

VertexStress place(const Stencils& stencils, std::size_t v, const Case& c, const Vec3& normal, bool tangent) {
    VertexStress out;
    const std::uint32_t begin = stencils.start[v], end = stencils.start[v + 1];
    if (begin == end) return out;
    Tensor t{};
    Principal given{};
    for (std::uint32_t k = begin; k < end; ++k) {
        const double w = stencils.weight[k];
        if (w == 0) continue;
        const std::uint32_t i = stencils.sample[k];
        const Tensor own = c.tensors.empty() ? about(c.directions[i], c.principals[i]) : c.tensors[i];
        for (std::size_t j = 0; j < 6; ++j) t[j] += w * own[j];
        if (c.tensors.empty())
            for (std::size_t j = 0; j < 3; ++j) given[j] += w * c.principals[i][j];
    }
    for (const double part : t)
        if (!std::isfinite(part)) return out; // a node without a value
    out.known = true;
    out.axes = principal_axes(t);
    if (tangent) out.tangent = in_plane_axis(t, normal);
    if (!c.tensors.empty()) return out;
    out.axes.values[0] = given[0];
    const bool all = std::isfinite(given[1]) && std::isfinite(given[2]);
    for (std::size_t j = 1; j < 3; ++j) out.axes.values[j] = all ? given[j] : kInfinity;
    if (all) std::sort(out.axes.values.rbegin(), out.axes.values.rend());
    return out;
}

struct Fields {
    surface::Field s[3], d;
};

Fields fields_of(const std::string& name, const std::vector<VertexStress>& places, double least, bool tangent) {
    const std::size_t n = places.size();
    Fields out;
    for (int j = 0; j < 3; ++j) {
        out.s[j] = {"stress." + name + ".s" + std::to_string(j + 1), std::vector<double>(n, kInfinity), 1};
        for (std::size_t v = 0; v < n; ++v)
            if (places[v].known) out.s[j].values[v] = places[v].axes.values[static_cast<std::size_t>(j)];
    }
    out.d = {"stress." + name + ".d1", std::vector<double>(3 * n, kInfinity), 3};
    for (std::size_t v = 0; v < n; ++v) {
        const auto& direction = tangent ? places[v].tangent : places[v].axes.first;
        if (!places[v].known || !direction || std::abs(places[v].axes.values[0]) < least) continue;
        const Vec3 d = signed_direction(*direction);
        out.d.values[3 * v] = d.x;
        out.d.values[3 * v + 1] = d.y;
        out.d.values[3 * v + 2] = d.z;
    }
    return out;
}

// Number and area of vertices; the place of the worst.
struct Tally {
    std::uint64_t count = 0;
    double area = 0, worst = -1;
    Vec3 at{std::nan(""), std::nan(""), std::nan("")};
    void add(double share, double badness, const Vec3& p) {
        ++count;
        area += share;
        if (badness > worst) {
            worst = badness;
            at = p;
        }
    }
    void note(Notes& notes, NoteCode code, double amount, const std::string& load_case) const {
        if (count > 0) notes.push_back({code, amount, count, -1, at.x, at.y, at.z, load_case});
    }
};

// Vertices where the greatest principal stress has a direction that is nearer to the normal than to the surface.
Tally leaning(const Surface& s, const std::vector<double>& area, const std::vector<VertexStress>& places,
              const surface::Field& directions, const std::vector<Vec3>& normal) {
    Tally out;
    for (std::size_t v = 0; v < places.size(); ++v) {
        const auto& first = places[v].axes.first;
        const double lean = first ? std::abs(dot(*first, normal[v])) : 0;
        if (lean > kOut && std::isfinite(directions.vector(v).x)) out.add(area[v], lean, s.vertices[v]);
    }
    return out;
}

void add_case(surface::Sheet& sheet, const Case& c, const Stencils& stencils, const std::vector<Vec3>& normal,
              const Options& options, int threads, Notes& notes, Facts& facts) {
    const Surface& s = sheet.surface;
    std::vector<VertexStress> places(s.vertices.size());
    parallel::for_chunks(places.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) places[v] = place(stencils, v, c, normal[v], options.tangent);
    });
    const auto area = areas(s);
    Tally unknown, all;
    double greatest = 0;
    for (std::size_t v = 0; v < places.size(); ++v) {
        all.add(area[v], 0, s.vertices[v]);
        if (!places[v].known)
            unknown.add(area[v], stencils.gap[v], s.vertices[v]);
        else
            greatest = std::max(greatest, std::abs(places[v].axes.values[0]));
    }
    if (unknown.count == places.size())
        throw Error(Exit::bad_input, "cannot use the stresses of case '" + c.name +
                                         "': they give none to any vertex of the surface; check --unit and --reach");
    Fields fields = fields_of(c.name, places, options.mask * greatest, options.tangent);
    const Tally out = leaning(s, area, places, fields.d, normal);
    unknown.note(notes, NoteCode::stress_unknown, unknown.area, c.name);
    const double share = out.area / all.area;
    if (!options.tangent) out.note(notes, NoteCode::stress_across, 100 * share, c.name);
    facts.push_back({"", "stress." + c.name + ".greatest", greatest, "MPa"});
    facts.push_back({"", "stress." + c.name + ".out-of-surface", share, ""});
    facts.push_back({"", "stress." + c.name + ".unknown", static_cast<double>(unknown.count), "vertices"});
    for (auto& f : fields.s) sheet.fields.push_back(std::move(f));
    sheet.fields.push_back(std::move(fields.d));
}

} // namespace

std::vector<Vec3> normals(const Surface& s) {
    std::vector<Vec3> out(s.vertices.size());
    for (const auto& t : s.triangles) {
        const Vec3 a = s.vertices[t[0]];
        const Vec3 n = cross(s.vertices[t[1]] - a, s.vertices[t[2]] - a);
        for (const auto v : t) out[v] = out[v] + n;
    }
    for (auto& n : out) {
        const double length = norm(n);
        n = length > 0 ? (1 / length) * n : Vec3{0, 0, 1}; // 0 where the surface folds back on itself
    }
    return out;
}

void add(surface::Sheet& sheet, const Samples& samples, const Options& options, int threads, Notes& notes,
         Facts& facts) {
    for (const Case& c : samples.cases)
        for (const auto& f : sheet.fields)
            if (f.name.starts_with("stress." + c.name + "."))
                throw Error(Exit::usage, "cannot add case '" + c.name +
                                             "': the surface has stresses of that name; give another --case");
    const Stencils stencils = samples.elements.empty() ? in_cloud(sheet.surface, samples.points, options.reach, threads)
                                                       : in_mesh(sheet.surface, samples, options.reach, threads);
    const auto normal = normals(sheet.surface);
    for (const Case& c : samples.cases) add_case(sheet, c, stencils, normal, options, threads, notes, facts);
}

void add(std::span<surface::Sheet> sheets, const Samples& samples, const Options& options, int threads, Notes& notes,
         Facts& facts) {
    if (sheets.empty()) throw Error(Exit::bad_input, "cannot place stresses: the stream holds no surface");
    if (sheets.size() == 1) return add(sheets[0], samples, options, threads, notes, facts);
    for (std::size_t k = 0; k < sheets.size(); ++k) {
        const std::string name = sheets[k].name.empty() ? std::to_string(k + 1) : sheets[k].name;
        Notes own;
        Facts found;
        try {
            add(sheets[k], samples, options, threads, own, found);
        } catch (const Error& e) {
            throw Error(e.exit(), "patch '" + name + "': " + e.what());
        }
        for (Note& note : own) {
            note.patch = name;
            notes.push_back(std::move(note));
        }
        for (Fact& fact : found) {
            fact.name = "patch." + name + "." + fact.name;
            facts.push_back(std::move(fact));
        }
    }
}

} // namespace filum::stressfield
