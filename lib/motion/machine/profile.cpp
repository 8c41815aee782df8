#include "machine/profile.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"
#include "machine/read_features.hpp"
#include "machine/read_material.hpp"
#include "machine/read_preset.hpp"
#include "machine/reader.hpp"
#include "machine/template.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace filum::machine {

namespace {

constexpr double kMostAcceleration = 1e7; // mm/s2

std::string fingerprint(std::string_view text) { // FNV-1a, 64 bits
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    std::string out;
    for (int shift = 60; shift >= 0; shift -= 4) out += "0123456789abcdef"[(hash >> shift) & 15];
    return out;
}

bool is_name(std::string_view text) {
    return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '_' ||
               c == '-';
    });
}

void read_bed(Document& doc, Bed& bed) {
    for (const char* key : {"bed.x", "bed.y", "bed.z"}) doc.require(key);
    const auto axis = [&doc](const std::string& key, double& lo, double& hi) {
        doc.pair(key, lo, hi, {-1e5, 1e5});
        if (lo >= hi) doc.fail(key, "the first number must be below the second");
    };
    axis("bed.x", bed.x_min, bed.x_max);
    axis("bed.y", bed.y_min, bed.y_max);
    axis("bed.z", bed.z_min, bed.z_max);
    doc.number("bed.z_offset", bed.z_offset, {-100, 100});
}

void read_head(Document& doc, Head& head) {
    doc.number("head.flat_radius", head.flat_radius, above_zero(100));
    double degrees = geom::degrees(head.cone_angle);
    doc.number("head.cone_angle_deg", degrees, {0, 179});
    head.cone_angle = geom::radians(degrees);
    doc.number("head.cone_height", head.cone_height, {0, 1000});
    doc.pair("head.carriage", head.carriage_x, head.carriage_y, {0, 10000});
    doc.number("head.gantry_height", head.gantry_height, {0, kInf, true});
    if (head.gantry_height < head.cone_height) doc.fail("head.gantry_height", "it must not be below cone_height");
    doc.flag("head.none", head.none);
}

void read_planner(Document& doc, Motion& m) {
    std::string controller = "marlin";
    doc.choice("motion.controller", controller, {"marlin", "klipper", "reprapfirmware", "linuxcnc"});
    m.controller = controller == "klipper"          ? Controller::klipper
                   : controller == "reprapfirmware" ? Controller::reprapfirmware
                   : controller == "linuxcnc"       ? Controller::linuxcnc
                                                    : Controller::marlin;
    doc.number("motion.acceleration_z", m.acceleration_z, above_zero(kInf));
    doc.number("motion.extruder_corner_speed", m.extruder_corner_speed, above_zero(kInf));
    doc.number("motion.minimum_cruise_ratio", m.minimum_cruise_ratio, {0, 0.99});
    doc.number("motion.arc_resolution", m.arc_resolution, {1e-3, 100});
    doc.whole("motion.look_ahead", m.look_ahead, 0, 1000);
    doc.number("motion.moves_per_second", m.moves_per_second, above_zero(kInf));
}

void read_motion(Document& doc, Profile& p) {
    Motion& m = p.motion;
    read_planner(doc, m);
    doc.number("motion.max_speed", m.max_speed, above_zero(1e5));
    doc.number("motion.max_speed_z", m.max_speed_z, above_zero(1e5));
    doc.number("motion.acceleration", m.acceleration, above_zero(kMostAcceleration));
    doc.number("motion.travel_acceleration", m.travel_acceleration, above_zero(kMostAcceleration));
    doc.number("motion.corner_speed", m.corner_speed, above_zero(1e5));
}

std::string key_of(std::string name) {
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

void read_feeds(Document& doc, Profile& p) {
    const Motion& m = p.motion;
    const auto feed = [&](const std::string& key, double& out, double max, const char* name) {
        doc.number(key, out, {0.01, 1e5});
        if (out > max) doc.fail(key, "it must not be above " + std::string(name) + ", " + shortest_text(max));
    };
    feed("feeds.bead", p.feeds.bead, m.max_speed, "motion.max_speed");
    for (std::size_t f = 1; f < toolpath::kFeatures; ++f)
        feed(std::string("feeds.") + key_of(toolpath::kFeatureNames[f]), p.feeds.feature[f], m.max_speed,
             "motion.max_speed");
    feed("feeds.first_layer", p.feeds.first_layer, m.max_speed, "motion.max_speed");
    feed("feeds.first_layer_infill", p.feeds.first_layer_infill, m.max_speed, "motion.max_speed");
    doc.number("feeds.first_layer_share", p.feeds.first_layer_share, {0, 10});
    doc.flag("feeds.first_layer_exact", p.feeds.first_layer_exact);
    doc.number("feeds.rise", p.feeds.rise, {0, 1000});
    feed("feeds.lift", p.feeds.lift, m.max_speed, "motion.max_speed");
    feed("feeds.jog", p.feeds.jog, m.max_speed, "motion.max_speed");
    feed("feeds.connector", p.feeds.connector, m.max_speed, "motion.max_speed");
    feed("feeds.travel", p.feeds.travel, m.max_speed, "motion.max_speed");
    feed("feeds.z", p.feeds.z, m.max_speed_z, "motion.max_speed_z");
}

void read_format(Document& doc, Format& f) {
    doc.whole("format.xyz_decimals", f.xyz_decimals, 2, 6);
    doc.whole("format.e_decimals", f.e_decimals, 3, 8);
    doc.whole("format.f_decimals", f.f_decimals, 0, 3);
    std::string comments = "semicolon", line_end = "lf";
    std::string dialect = "gcode";
    doc.choice("format.dialect", dialect, {"gcode", "krl", "rapid", "urscript"});
    f.dialect = dialect == "krl"        ? Dialect::krl
                : dialect == "rapid"    ? Dialect::rapid
                : dialect == "urscript" ? Dialect::urscript
                                        : Dialect::gcode;
    doc.choice("format.comments", comments, {"semicolon", "parentheses", "exclamation", "hash"});
    f.comments = comments == "semicolon"     ? CommentStyle::semicolon
                 : comments == "parentheses" ? CommentStyle::parentheses
                 : comments == "exclamation" ? CommentStyle::exclamation
                                             : CommentStyle::hash;
    doc.choice("format.line_end", line_end, {"lf", "crlf"});
    f.crlf = line_end == "crlf";
    doc.flag("format.viewer_comments", f.viewer_comments);
    doc.choice("format.travel_code", f.travel_code, {"G0", "G1"});
    doc.flag("format.arcs", f.arcs);
    std::string objects = "none";
    doc.choice("format.objects", objects, {"none", "exclude_object", "m486"});
    f.objects = objects == "m486"             ? Objects::m486
                : objects == "exclude_object" ? Objects::exclude_object
                                              : Objects::none;
}

// Checks that a machine has a robot's language if and only if it has tool frames.
void check_robot(const Document& doc, const Profile& p) {
    const bool frames = p.axes.chain.carrier == kinematics::Carrier::frame;
    if (frames != (p.format.dialect != Dialect::gcode))
        doc.fail("format.dialect", "krl, rapid and urscript go with kinematics.carrier \"frame\", and it with them");
    if (p.format.dialect == Dialect::urscript && p.extrusion.feeding != Feeding::valve)
        doc.fail("extrusion.kind", "URScript knows no extruder axis: use a valve");
    if (p.format.dialect != Dialect::rapid && !p.extrusion.on_trigger.empty())
        doc.fail("extrusion.on_trigger", "only RAPID has triggers: use on and off");
}

// Checks that the speeds of the fibre are within the machine's.  A fibre head that is not tool 0 also needs codes to
// change to it.
void check_fibre(const Document& doc, const Profile& p) {
    const Fibre& f = p.fibre;
    if (!f.active()) return;
    const std::pair<const char*, double> speeds[] = {
        {"fibre.anchor_feed", f.anchor_feed}, {"fibre.feed", f.feed}, {"fibre.tail_feed", f.tail_feed}};
    for (const auto& [key, speed] : speeds)
        if (speed > p.motion.max_speed)
            doc.fail(key, "it must not be above motion.max_speed, " + shortest_text(p.motion.max_speed));
    if (f.tool != 0 && change_codes(p, static_cast<std::uint32_t>(f.tool)).empty())
        doc.fail("tools.change", "a fibre head beside tool 0 needs the codes that change tools");
}

// Checks the placeholders of texts.
void check_codes(const Document& doc, const Profile& p,
                 std::initializer_list<std::pair<const char*, const std::string*>> texts) {
    Values own = p.values;
    if (p.axes.chain.carrier == kinematics::Carrier::frame) add_robot(p.robot, own);
    for (const auto& [key, text] : texts) {
        const auto fault = check_template(*text, own);
        if (!fault.why.empty()) doc.fail_in_text(key, fault.why, fault.line);
    }
}

void read_templates(Document& doc, Profile& p) {
    for (const auto& [name, value] : p.values) {
        if (!is_name(name) || name.find_first_of(".-") != std::string::npos)
            doc.fail("values." + name, "a name is made of letters, digits and '_'");
        const auto& known = known_placeholders();
        if (std::find(known.begin(), known.end(), name) != known.end())
            doc.fail("values." + name, "the name is taken; every program knows it");
    }
    doc.text("templates.start", p.templates.start);
    doc.text("templates.layer", p.templates.layer);
    doc.text("templates.first_layer", p.templates.first_layer);
    doc.text("templates.upper_layers", p.templates.upper_layers);
    doc.text("templates.end", p.templates.end);
    doc.text("templates.pause", p.templates.pause);
    doc.text("templates.progress", p.templates.progress);
    check_codes(doc, p,
                {{"templates.start", &p.templates.start},
                 {"features.set_acceleration", &p.features.set_acceleration},
                 {"features.set_fan", &p.features.set_fan},
                 {"templates.layer", &p.templates.layer},
                 {"templates.first_layer", &p.templates.first_layer},
                 {"templates.upper_layers", &p.templates.upper_layers},
                 {"templates.end", &p.templates.end},
                 {"templates.pause", &p.templates.pause},
                 {"templates.progress", &p.templates.progress},
                 {"extrusion.on", &p.extrusion.on},
                 {"extrusion.off", &p.extrusion.off},
                 {"tools.change", &p.tools.change},
                 {"purge.wait", &p.purge.wait},
                 {"purge.after", &p.purge.after},
                 {"fibre.cut", &p.fibre.cut},
                 {"fibre.tension", &p.fibre.tension},
                 {"fibre.on", &p.fibre.on},
                 {"fibre.off", &p.fibre.off},
                 {"robot.module_file", &p.robot.module_file},
                 {"robot.module_start", &p.robot.module_start},
                 {"robot.module_end", &p.robot.module_end},
                 {"robot.module_load", &p.robot.module_load},
                 {"robot.module_call", &p.robot.module_call},
                 {"robot.module_unload", &p.robot.module_unload}});
}

// Reads a section [tool.N] over a copy of the whole profile.
void read_own_tool(Document& doc, const std::string& name, Profile& p) {
    const bool letters = p.extrusion.letter == 'E';
    const bool relative = p.extrusion.relative;
    const Feeding feeding = p.extrusion.feeding;
    read_head(doc, p.head);
    read_extrusion(doc, p.extrusion);
    if (p.extrusion.relative != relative || (p.extrusion.letter == 'E') != letters)
        doc.fail("extrusion.mode", "all tools count alike, on one extruder axis");
    const bool measured = p.extrusion.feeding == Feeding::filament || p.extrusion.feeding == Feeding::plunger;
    if (measured && p.extrusion.feeding != feeding && !doc.has("extrusion.diameter"))
        doc.fail("extrusion.diameter", "it is missing");
    check_robot(doc, p);
    read_limits(doc, p.limits);
    read_feeds(doc, p);
    read_travel(doc, p.travel);
    doc.numbers("values", p.values);
    read_purge(doc, p.bed, p.axes.active(), p.purge);
    doc.text("change", p.change);
    std::array<double, 3> offset{};
    doc.list("offset", offset, {-1e4, 1e4});
    p.offset = {offset[0], offset[1], offset[2]};
    std::array<double, 3> mount = offset;
    doc.list("mount", mount, {-1e4, 1e4});
    p.mount = {mount[0], mount[1], mount[2]};
    p.mounted = doc.has("mount") || p.offset != geom::Vec3{};
    const auto& a = p.axes;
    if (p.offset != geom::Vec3{} && a.active() && a.numbers == Numbers::tip)
        doc.fail("offset", "the controller knows the tip: give the offset to its tool table");
    if (p.offset != geom::Vec3{} && a.chain.carrier == kinematics::Carrier::frame)
        doc.fail("offset", "a robot's tool has a frame");
    p.axes.chain.tip_to_tilt = p.axes.chain.tip_to_tilt - p.offset;
    if (a.chain.carrier == kinematics::Carrier::frame) read_tool_frame(doc, p.robot);
    check_codes(doc, p,
                {{"change", &p.change},
                 {"extrusion.on", &p.extrusion.on},
                 {"extrusion.off", &p.extrusion.off},
                 {"purge.wait", &p.purge.wait},
                 {"purge.after", &p.purge.after}});
    if (name != "0" && p.change.empty() && p.tools.change.empty())
        doc.fail("change", "a tool beside tool 0 needs the codes that take it: this, or tools.change");
}

// Reads all sections [tool.N].  Also sets retraction to 0 for each tool with a valve, as a valve takes nothing back.
void read_own_tools(Document& doc, Profile& p) {
    const auto settle = [](Profile& one) {
        if (one.extrusion.feeding == Feeding::valve) one.travel.retract = one.travel.extra = 0;
    };
    std::map<std::uint32_t, std::shared_ptr<const Profile>> own;
    for (const auto& name : doc.tables("tool")) {
        const bool number = name.find_first_not_of("0123456789") == std::string::npos;
        if (!number || name.size() > 3 || (name.size() > 1 && name[0] == '0'))
            doc.fail("tool." + name, "a tool has a number, 0 to 999, as [tool.1]");
        Profile one = p;
        doc.enter("tool." + name);
        read_own_tool(doc, name, one);
        doc.leave();
        settle(one);
        own[static_cast<std::uint32_t>(std::stoul(name))] = std::make_shared<const Profile>(std::move(one));
    }
    settle(p);
    p.own = std::move(own);
}

} // namespace

Merging standard_merging() { return {0.01, 0.02, geom::radians(0.5)}; }

Profile parse_profile(std::string_view text, const std::string& file, const std::string& set) {
    const ProfileText own{std::string(text), file};
    return parse_profile({&own, 1}, set);
}

Profile parse_profile(std::span<const ProfileText> texts, const std::string& set) {
    const std::string& file = texts[0].file;
    Document doc(texts[0].text, file, set);
    std::string all = texts[0].text, base;
    for (const ProfileText& more : texts.subspan(1)) {
        doc.add_base(more.text, more.file);
        all += more.text;
    }
    Profile p;
    p.fingerprint = fingerprint(all);
    doc.text("base", base);
    if (!base.empty() && texts.size() == 1) doc.fail("base", "its text is not given");
    doc.require("name");
    doc.text("name", p.name);
    if (!is_name(p.name)) doc.fail("name", "it must be letters, digits, '.', '_', '-', at most 64");
    doc.text("about", p.about);
    read_bed(doc, p.bed);
    read_head(doc, p.head);
    read_extrusion(doc, p.extrusion);
    read_limits(doc, p.limits);
    read_motion(doc, p);
    read_feeds(doc, p);
    read_features(doc, p.motion.controller, kMostAcceleration, p.features);
    read_cooling(doc, p.cooling);
    read_overhang(doc, p.overhang);
    if (p.cooling.active() && p.features.set_fan.empty())
        doc.fail("cooling.most", "features.set_fan must say by which code, with {fan_speed}");
    read_travel(doc, p.travel);
    read_multi_axis(doc, p.axes);
    p.axes.limits.radius_min = p.bed.x_min;
    if (p.axes.start) {
        const geom::Vec3& s = p.axes.start->xyz;
        if (s.x < p.bed.x_min || s.x > p.bed.x_max || s.y < p.bed.y_min || s.y > p.bed.y_max || s.z < p.bed.z_min ||
            s.z > p.bed.z_max)
            doc.fail("kinematics.start", "it lies outside of bed");
    }
    read_robot(doc, file, p.axes.chain.carrier == kinematics::Carrier::frame, p.robot);
    if (p.axes.active() && (p.extrusion.letter == p.axes.tilt_letter || p.extrusion.letter == p.axes.turn_letter))
        doc.fail("extrusion.letter", "it is a rotary axis' letter");
    read_tools(doc, p.tools);
    read_purge(doc, p.bed, p.axes.active(), p.purge);
    read_fibre(doc, p.fibre);
    read_format(doc, p.format);
    check_robot(doc, p);
    doc.numbers("values", p.values);
    if (const auto found = p.values.find("tolerance"); found != p.values.end()) p.motion.blend = found->second;
    read_templates(doc, p);
    read_preset(doc, p);
    read_own_tools(doc, p);
    check_fibre(doc, p);
    doc.finish();
    return p;
}

} // namespace filum::machine
