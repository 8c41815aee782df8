// Toolpaths and programs for the tests.
#pragma once

#include "machine/profile.hpp"
#include "postproc/about.hpp"
#include "postproc/program.hpp"

#include <random>
#include <string>
#include <vector>

namespace sample {

using filum::geom::Vec3;
using filum::toolpath::Role;
using filum::toolpath::Span;

inline const char* const kFilament = "kind = \"filament\"\ndiameter = 1.75\n";

// A profile by its text's [extrusion] and [format]; the bed is 400 mm wide, nothing is limited.
inline filum::machine::Profile profile(const std::string& extrusion = kFilament, const std::string& rest = "") {
    return filum::machine::parse_profile(
        "name = \"test\"\n[bed]\nx = [0, 400]\ny = [0, 400]\nz = [0, 400]\n[extrusion]\n" + extrusion +
            "[templates]\nend = \"M84\"\n" + rest,
        "test.toml");
}

// Strokes of linked spans of all roles: long and short moves, some of them far below the last decimal, some of no
// length, some straight up; widths and heights vary along them.
inline std::vector<Span> random_toolpath(unsigned seed, std::size_t strokes = 6) {
    std::mt19937 gen(seed);
    const auto uniform = [&gen](double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(gen()) / 4294967296.0);
    };
    std::vector<Span> out;
    Vec3 at{uniform(-50, 50), uniform(-50, 50), 0.2};
    for (std::size_t s = 0; s < strokes; ++s) {
        if (s > 0) {
            const Vec3 to{uniform(-50, 50), uniform(-50, 50), at.z};
            out.push_back({Role::travel, static_cast<std::uint32_t>(s), 0, 0, {at, to}, {}, {}});
            at = to;
        }
        const auto spans = 1 + gen() % 4;
        for (unsigned k = 0; k < spans; ++k) {
            const auto role = static_cast<Role>(gen() % 4);
            Span span{role, static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(at.z / 0.2 - 0.5), 0, {at}, {},
                      {}};
            const auto n = 1 + gen() % 60;
            for (unsigned i = 0; i < n; ++i) {
                const double step = std::pow(10.0, uniform(-5, 1));
                const auto kind = gen() % 12;
                if (kind == 0)
                    at.z += 0.2;
                else if (kind > 1) {
                    at.x += uniform(-step, step);
                    at.y += uniform(-step, step);
                }
                span.points.push_back(at);
            }
            for (std::size_t i = 0; i < span.points.size(); ++i) span.width.push_back(uniform(0.2, 0.8));
            span.height = {uniform(0.1, 0.3)};
            out.push_back(span);
        }
    }
    return out;
}

struct Written {
    std::string text;
    filum::postproc::FirstPass first_pass;
    filum::geom::Vec2 shift;
};

inline Written write(const filum::machine::Profile& p, const std::vector<Span>& spans,
                     filum::postproc::Place place = filum::postproc::Place::center) {
    using namespace filum::postproc;
    Surveyor surveyor(p);
    Walk measure(p, [&](auto steps) { surveyor.add(steps); });
    for (const auto& s : spans) measure.add(s);
    measure.end();
    Written out;
    out.first_pass = surveyor.end();
    out.shift = placement(out.first_pass, p.bed, place);
    check_limits(out.first_pass, p, out.shift);
    Program program(p, out.first_pass, out.shift, [&](std::string_view t) { out.text += t; });
    program.begin(about(p, out.first_pass, {}, {}));
    Walk walk(p, [&](auto steps) { program.add(steps); });
    for (const auto& s : spans) walk.add(s);
    walk.end();
    program.end(history({{"link3d", {}}, {"postproc", {{"machine", p.name}}}}, {}, {}));
    return out;
}

inline double volume(const std::vector<Span>& spans) {
    double sum = 0;
    for (const auto& s : spans)
        for (std::size_t i = 0; filum::toolpath::extrudes(s.role) && i + 1 < s.points.size(); ++i)
            sum += filum::toolpath::volume(s, i);
    return sum;
}

} // namespace sample
