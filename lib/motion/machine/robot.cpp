#include "machine/robot.hpp"

#include "geom/angle.hpp"
#include "machine/reader.hpp"

#include <cmath>
#include <limits>

namespace filum::machine {

namespace {

using geom::Frame;
using geom::kDegree;
using kinematics::kAxes;
using Range = Document::Range;

constexpr double kFarFrame = 1e5;    // mm, degrees
constexpr double kMostSingular = 45; // degrees

// Reads [x, y, z, a, b, c]: mm, and degrees about z, the new y, and the new x, as in KUKA's frames.  False: no such
// key.
bool read_frame(Document& doc, const std::string& key, Frame& out) {
    std::array<double, 6> v{};
    if (!doc.list(key, v, {-kFarFrame, kFarFrame})) return false;
    out = {geom::from_euler_zyx(v[3] * kDegree, v[4] * kDegree, v[5] * kDegree), {v[0], v[1], v[2]}};
    return true;
}

void modules(Document& doc, Robot& r) {
    doc.whole("robot.module_moves", r.module_moves, 0, 100000000);
    doc.text("robot.module_file", r.module_file);
    doc.text("robot.module_start", r.module_start);
    doc.text("robot.module_end", r.module_end);
    doc.text("robot.module_load", r.module_load);
    doc.text("robot.module_call", r.module_call);
    doc.text("robot.module_unload", r.module_unload);
    if (r.module_moves == 0) return;
    if (r.module_moves < 100) doc.fail("robot.module_moves", "it must be 0, for one module, or at least 100");
    for (const auto& [key, text] : {std::pair{"robot.module_file", &r.module_file},
                                    {"robot.module_start", &r.module_start},
                                    {"robot.module_end", &r.module_end},
                                    {"robot.module_call", &r.module_call}})
        if (text->empty()) doc.fail(key, "programs of several modules need it");
    if (r.module_file.find_first_of("/\\\n") != std::string::npos ||
        r.module_file.find("{module}") == std::string::npos)
        doc.fail("robot.module_file", "it must be the name of a file, with {module} in it and no folder");
}

void check_start(const Document& doc, const Robot& r) {
    if (!r.arm) return;
    for (std::size_t k = 0; k < kAxes; ++k) {
        const auto& axis = r.arm->axes[k];
        if (r.start[k] < axis.min || r.start[k] > axis.max)
            doc.fail("robot.start", "axis " + std::to_string(k + 1) + " of '" + r.model + "' does not reach there");
    }
}

} // namespace

void read_robot(Document& doc, const std::string& file, bool frames, Robot& r) {
    if (!frames) return;
    for (const char* key : {"robot.base", "robot.tool", "robot.start"}) doc.require(key);
    read_frame(doc, "robot.base", r.base);
    read_frame(doc, "robot.tool", r.tool);
    doc.list("robot.start", r.start, {-3600, 3600});
    for (double& q : r.start) q *= kDegree;
    double singular = 5;
    doc.number("robot.singular_deg", singular, {0, kMostSingular});
    r.singular = singular * kDegree;
    modules(doc, r);
    RobotLinks links;
    doc.text("robot.model", r.model);
    doc.text("robot.base_link", links.base);
    doc.text("robot.flange_link", links.flange);
    if (!r.model.empty()) r.arm = load_robot(r.model, file, links);
    check_start(doc, r);
}

void read_tool_frame(Document& doc, Robot& r) { read_frame(doc, "frame", r.tool); }

kinematics::Arm table_robot(std::string_view text, const std::string& file) {
    Document doc(text, file, "", "robot model");
    std::string name, about, source;
    doc.require("name");
    doc.text("name", name);
    doc.text("about", about);
    doc.text("source", source);
    std::array<double, kAxes> a{}, d{}, alpha{}, theta{}, sign, min{}, max{}, speed{};
    sign.fill(1);
    for (const char* key : {"dh.a", "dh.d", "dh.alpha_deg", "limits.min_deg", "limits.max_deg", "limits.speed_deg"})
        doc.require(key);
    doc.list("dh.a", a, {-kFarFrame, kFarFrame});
    doc.list("dh.d", d, {-kFarFrame, kFarFrame});
    doc.list("dh.alpha_deg", alpha, {-360, 360});
    doc.list("dh.theta_deg", theta, {-360, 360});
    doc.list("dh.sign", sign, {-1, 1});
    constexpr double endless = std::numeric_limits<double>::infinity();
    doc.list("limits.min_deg", min, {-endless, endless});
    doc.list("limits.max_deg", max, {-endless, endless});
    doc.list("limits.speed_deg", speed, {0, 1e5, true});
    Frame flange;
    read_frame(doc, "flange", flange);
    std::array<kinematics::DhRow, kAxes> rows;
    std::array<kinematics::Axis, kAxes> limits;
    for (std::size_t k = 0; k < kAxes; ++k) {
        if (sign[k] != 1 && sign[k] != -1) doc.fail("dh.sign", "each must be 1 or -1");
        if (!(min[k] < max[k])) doc.fail("limits.min_deg", "each must be below that of max_deg");
        rows[k] = {a[k], d[k], alpha[k] * kDegree, theta[k] * kDegree, sign[k]};
        limits[k].min = min[k] * kDegree;
        limits[k].max = max[k] * kDegree;
        limits[k].speed = speed[k] * kDegree;
    }
    doc.finish();
    return kinematics::arm(rows, limits, flange);
}

void add_frame(const std::string& name, const Frame& f, std::map<std::string, double>& to) {
    const auto angles = geom::euler_zyx(f.turn);
    const auto q = geom::quaternion(f.turn);
    const auto v = geom::rotation_vector(f.turn);
    const double place[] = {f.origin.x, f.origin.y, f.origin.z};
    // Numbers are rounded to the decimals of templates, so that a right angle is exact.
    const auto rounded = [](double x) { return std::round(x * 1e9) / 1e9 + 0.0; };
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string xyz(1, "xyz"[k]), abc(1, "abc"[k]);
        to[name + "_" + xyz] = rounded(place[k]);
        to[name + "_" + abc] = rounded(angles[k] / kDegree);
        to[name + "_m" + xyz] = rounded(place[k] / 1000);
        to[name + "_r" + xyz] = rounded(v[k]);
    }
    for (std::size_t k = 0; k < 4; ++k) to[name + "_q" + std::to_string(k + 1)] = rounded(q[k]);
}

void add_robot(const Robot& r, std::map<std::string, double>& to) {
    add_frame("base", r.base, to);
    add_frame("tool", r.tool, to);
    for (std::size_t k = 0; k < kAxes; ++k) {
        to["start_" + std::to_string(k + 1)] = std::round(r.start[k] / kDegree * 1e9) / 1e9 + 0.0;
        to["start_r" + std::to_string(k + 1)] = std::round(r.start[k] * 1e9) / 1e9 + 0.0;
    }
    to["module"] = 1;
}

} // namespace filum::machine
