// A robot's program from spans, for tests.
#pragma once

#include "postproc/about.hpp"
#include "postproc/measure.hpp"
#include "postproc/writer.hpp"

#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace robots {

using namespace filum;

inline std::vector<toolpath::Span> arc() {
    toolpath::Span s{toolpath::Role::bead, 0, 0, 0, {}, {1.0}, {0.2}, {}};
    for (int i = 0; i <= 40; ++i) {
        const double a = std::numbers::pi * (i / 40.0 - 0.5) * 0.8;
        s.points.push_back({30 * std::sin(a), 0.2 * i, 30 * std::cos(a)});
        s.normals.push_back({std::sin(a), 0, std::cos(a)});
    }
    return {s};
}

struct Asked {
    std::string dialect = "krl", extrusion = "kind = \"filament\"\ndiameter = 1.75\nmode = \"absolute\"\n";
    std::string model = "irb4600-60-205", base = "1200, 0, 500, 90, 0, 0", start = "0, 4, 16, 0, 70, 0";
    std::string kinematics = "", robot = "", tables = ""; // more keys
};

inline machine::Profile robot_profile(const Asked& a) {
    return machine::parse_profile(
        "name = \"robot\"\n[bed]\nx = [-500, 500]\ny = [-500, 500]\nz = [-500, 500]\n[extrusion]\n" + a.extrusion +
            "[feeds]\nbead = 20\nfirst_layer = 20\n[kinematics]\ncarrier = \"frame\"\nangle_decimals = 6\n" +
            a.kinematics + "[robot]\nmodel = \"" + a.model + "\"\nbase = [" + a.base +
            "]\ntool = [0, 0, 150, 0, 0, 0]\nstart = [" + a.start + "]\n" + a.robot + "[format]\ndialect = \"" +
            a.dialect + "\"\nxyz_decimals = 5\n" + a.tables,
        "robot.toml");
}

struct Written {
    std::string text;
    std::map<std::string, std::string> modules;
    postproc::FirstPass first_pass;
    Notes notes;
    Facts facts;
};

inline Written written(const Asked& asked, const std::vector<toolpath::Span>& spans) {
    const auto p = robot_profile(asked);
    postproc::Measure measure(p, postproc::Place::as_is);
    do
        for (const auto& s : spans) measure.add(s);
    while (measure.again());
    Written out;
    out.first_pass = measure.end();
    postproc::add_efforts(p, out.first_pass, "test", out.notes, out.facts);
    const auto writer = postproc::writer(
        p, out.first_pass, {}, [&](std::string_view text) { out.text += text; },
        [&](const std::string& name) { return [&to = out.modules[name]](std::string_view text) { to += text; }; });
    writer->begin(postproc::about(p, out.first_pass, {}, {}));
    const auto walk = postproc::walker(p, {}, [&](auto steps) { writer->add(steps); });
    for (const auto& s : spans) walk->add(s);
    walk->end();
    writer->end({});
    return out;
}

inline std::string robot_program(const Asked& asked) { return written(asked, arc()).text; }

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) out.push_back(line);
    return out;
}

} // namespace robots
