#include "postproc/about.hpp"

#include "base/number.hpp"
#include "geom/angle.hpp"
#include "postproc/digits.hpp"
#include "postproc/job.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

constexpr std::size_t kWidth = 100;

void pipeline(const std::vector<Stage>& stages, std::vector<std::string>& lines) {
    if (stages.empty()) return;
    lines.push_back(" made by");
    for (std::size_t i = 0; i < stages.size(); ++i) {
        std::string text = " - " + stages[i].program;
        for (const auto& [name, value] : stages[i].settings)
            if (!value.empty()) text += " --" + name + "=" + value;
        if (i + 1 < stages.size()) text += " |";
        for (auto& line : wrapped(text, kWidth, "     ")) lines.push_back(std::move(line));
    }
}

// The rotary axes at rest: the numbers of joints depend on their place.
std::string pivots(const kinematics::Chain& c) {
    using kinematics::Carrier;
    const auto text = [](const Vec3& p) {
        return fixed_text(p.x, 3) + ", " + fixed_text(p.y, 3) + ", " + fixed_text(p.z, 3);
    };
    std::string out = " at rest [mm]:";
    if (c.carrier != Carrier::head_head) out += " turn axis through " + text(c.turn_point) + ";";
    if (c.carrier == Carrier::table_table) out += " tilt axis through " + text(c.tilt_point);
    if (c.carrier != Carrier::table_table) out += " tilt axis off the tip by " + text(c.tip_to_tilt);
    if (c.carrier == Carrier::head_head) out += "; turn axis off the tilt axis by " + text(c.tilt_to_turn);
    return out;
}

// A frame as a robot's language writes it.
std::string frames(machine::Dialect dialect) {
    switch (dialect) {
    case machine::Dialect::krl:
        return "X Y Z mm in the BASE, A B C degrees about z, the new y, the new x";
    case machine::Dialect::rapid:
        return "mm in the work object, unit quaternion from its real part on";
    case machine::Dialect::urscript:
        return "m, rotation vector in rad";
    case machine::Dialect::gcode:
        break;
    }
    return "";
}

std::string frame(const geom::Frame& f) {
    const auto turn = geom::euler_zyx(f.turn);
    std::string out;
    for (const double v :
         {f.origin.x, f.origin.y, f.origin.z, geom::degrees(turn[0]), geom::degrees(turn[1]), geom::degrees(turn[2])})
        out += (out.empty() ? "" : ", ") + fixed_text(v, 3);
    return out;
}

std::vector<std::string> robot(const machine::Profile& profile) {
    const machine::Robot& r = profile.robot;
    return {" axes: those of a robot, which works them out; " +
                (r.arm ? "checked for '" + r.model + "'" : std::string("of an unknown model, not checked")),
            " numbers: tool frames in the part's frame, z out of the nozzle; " + frames(profile.format.dialect),
            " part in the robot's base [mm, degrees about z, y, x]: " + frame(r.base),
            " nozzle in the flange's frame: " + frame(r.tool)};
}

// The frame of the program's numbers: the same words mean different places on different machines.
std::vector<std::string> axes(const machine::Profile& profile) {
    const auto& a = profile.axes;
    if (!a.active()) return {};
    if (a.chain.carrier == kinematics::Carrier::frame) return robot(profile);
    const char* carriers[] = {"", "turn axis on tilt axis, both under the part", "tilting head, turning table",
                              "tilting head on a turning one", "tilting head, turning table, X the radius"};
    const auto& u = a.chain.tilt_axis;
    std::string chain = std::string(a.chain.carrier == kinematics::Carrier::polar ? " axes: X Z " : " axes: X Y Z ") +
                        a.tilt_letter + " (tilt, about " + (u.x + u.y < 0 ? "-" : "") + (u.x != 0 ? "x" : "y") + ") " +
                        a.turn_letter + " (turn, about " + (a.chain.turn_sign < 0 ? "-z): " : "z): ") +
                        carriers[static_cast<std::size_t>(a.chain.carrier)];
    std::string numbers = a.numbers == machine::Numbers::tip
                              ? " numbers: X Y Z is the tip in the part's frame; the controller works out the axes"
                          : a.chain.carrier == kinematics::Carrier::polar
                              ? " numbers: X Z is where the axes stand, X from the turn axis; Y does not exist"
                              : " numbers: X Y Z is where the axes stand; the controller must not correct for tilt";
    std::string feed = a.feed_word == machine::FeedWord::inverse   ? "1 / minutes of the move"
                       : a.feed_word == machine::FeedWord::seconds ? "seconds of the move"
                                                                   : "mm/min of X Y Z, degrees/min without";
    return {chain, pivots(a.chain), numbers, " feed: F is " + feed};
}

// The largest distance of the program from the toolpath.
std::string merged(const machine::Profile& profile) {
    const auto& m = profile.merging;
    std::string out = " path: moves merged within " + shortest_text(m.planar) + " mm of the toolpath";
    if (!profile.axes.active() && m.surface != m.planar)
        out += ", " + shortest_text(m.surface) + " mm where it leans the tool";
    if (profile.axes.active())
        out += ", where it leans the tool " + shortest_text(m.surface) + " mm and " +
               shortest_text(geom::degrees(m.axis)) + " degrees";
    return out;
}

void totals(const machine::Profile& profile, const FirstPass& s, std::vector<std::string>& lines) {
    const auto& e = profile.extrusion;
    const MaterialUse material = used(profile, s);
    const bool filament = e.feeding == machine::Feeding::filament;
    lines.push_back("TIME:" + std::to_string(static_cast<long long>(std::ceil(std::min(s.seconds, 1e15)))));
    lines.push_back(" estimated printing time (normal mode) = " + duration(s.seconds));
    if (filament) lines.push_back(" filament used [mm] = " + fixed_text(material.units, 2));
    if (e.feeding == machine::Feeding::plunger)
        lines.push_back(" plunger travel [mm] = " + fixed_text(material.units, 4));
    lines.push_back(std::string(filament ? " filament used" : " material") +
                    " [cm3] = " + fixed_text(material.volume / 1000, 3));
    if (const double money = cost(profile, s); money > 0)
        lines.push_back(" total filament cost = " + fixed_text(money, 2));
    lines.push_back(" layers = " + std::to_string(s.layers) + ", strokes = " + std::to_string(s.strokes));
    std::string path = " path [mm] = " + fixed_text(s.path_len, 1);
    const std::pair<Role, const char*> roles[] = {
        {Role::lift, "lifts"}, {Role::jog, "jogs"}, {Role::connector, "connectors"}, {Role::travel, "travel"}};
    for (const auto& [role, name] : roles)
        if (const double l = s.role_len[static_cast<std::size_t>(role)]; l > 0)
            path += std::string(", ") + name + " " + fixed_text(l, 1);
    lines.push_back(path);
    for (auto& line : job_lines(profile, s)) lines.push_back(std::move(line));
}

double fact(const Facts& facts, const std::string& stage, const std::string& name) {
    double out = -1;
    for (const Fact& f : facts)
        if (f.stage == stage && f.name == name) out = f.value;
    return out;
}

std::string counted(std::uint64_t n, const std::string& what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

// The lower bound on strokes that `sequence` proved, or -1.  An assembled job has no such bound, as each bound holds
// for only one of its toolpaths.
double least_strokes(const Facts& facts) {
    const auto bounds = [](const Fact& f) { return f.stage == "sequence" && f.name == "lower-bound"; };
    if (std::count_if(facts.begin(), facts.end(), bounds) > 1 || fact(facts, "assemble", "toolpaths") > 1) return -1;
    return fact(facts, "sequence", "lower-bound");
}

// The strokes of the finished program, and their lower bound for the part.
std::string strokes(const FirstPass& s, const Facts& facts) {
    std::string out = counted(s.strokes, "stroke");
    const double bound = least_strokes(facts);
    const auto made = static_cast<double>(s.strokes);
    if (bound == made)
        out += " (proven the fewest)";
    else if (bound >= 0 && bound < made)
        out += " (at least " + fixed_text(bound, 0) + (bound == 1 ? " is" : " are") + " needed)";
    return out + "; " + counted(s.strokes > 0 ? s.strokes - 1 : 0, "stop");
}

std::string material(const machine::Profile& profile, const FirstPass& s) {
    const MaterialUse used = postproc::used(profile, s);
    std::string out = "prints in " + duration(s.seconds) + "; " + fixed_text(used.volume / 1000, 2) + " cm3";
    if (profile.extrusion.feeding == machine::Feeding::filament)
        out += ", " + fixed_text(used.units / 1000, 2) + " m of filament";
    if (profile.extrusion.density > 0)
        out += ", " + fixed_text(used.volume / 1000 * profile.extrusion.density, 2) + " g";
    if (const std::string money = fixed_text(cost(profile, s), 2); money != "0") out += ", material for " + money;
    double fibre = 0;
    for (const auto& [number, tool] : s.tools) fibre += tool.fibre_len;
    if (fibre > 0) out += ", " + fixed_text(fibre / 1000, 2) + " m of fibre";
    return out;
}

// The edges of beads are within a hundredth of a millimetre of the outline, so lengths of 1 mm or more are rounded to a
// tenth.  The height is a sum of layers.
std::string size(const machine::Profile& profile, const FirstPass& s, Vec2 shift) {
    const auto length = [](double mm) { return fixed_text(mm, mm < 1 ? 2 : 1); };
    std::string out = length(s.part_size.x) + " x " + length(s.part_size.y) + " x " + fixed_text(s.part_size.z, 2) +
                      " mm in " + counted(s.layers, "layer");
    if (profile.axes.active()) return out;
    const std::array<double, 2> by{shift.x, shift.y};
    for (const std::size_t k : {0U, 1U})
        out += std::string(k == 0 ? "; on the bed x " : ", y ") + fixed_text(s.part_low[k] + by[k], 1) + " to " +
               fixed_text(s.part_high[k] + by[k], 1);
    return out;
}

// Adds the notes from that grade on: one line per kind of note, wrapped.
void remarks(const Notes& notes, Grade least, std::vector<std::string>& lines) {
    for (const Note& n : summed(notes)) {
        if (grade(n) < least) continue;
        const std::string text = " note: " + std::string(name(grade(n))) + ": " + n.stage + ": " + line(n);
        for (auto& part : wrapped(text, kWidth, "     ")) lines.push_back(std::move(part));
    }
}

} // namespace

void add_waits(const FirstPass& first_pass, Notes& notes) {
    const PauseTotals& w = first_pass.waits;
    if (w.within > 0) notes.push_back({NoteCode::pause_in_stroke, static_cast<double>(w.within), w.within});
    if (w.late > 0)
        notes.push_back({NoteCode::layer_after_pause, static_cast<double>(w.late), w.late,
                         static_cast<std::int64_t>(w.late_layer)});
}

void add_efforts(const machine::Profile& profile, const FirstPass& first_pass, const std::string& stage, Notes& notes,
                 Facts& facts) {
    const auto& a = profile.axes;
    const Efforts& e = first_pass.efforts;
    facts.push_back({stage, "moves", static_cast<double>(first_pass.moves), ""});
    facts.push_back(
        {stage, "segments-merged", static_cast<double>(e.given - std::min(e.given, first_pass.laying)), ""});
    facts.push_back({stage, "largest-merge", e.off, "mm"});
    facts.push_back({stage, "moves-slowed", static_cast<double>(e.slowed), ""});
    constexpr double told = 0.01; // degrees; smaller angles are not reported
    if (!a.active() && geom::degrees(e.lean) > told)
        notes.push_back({NoteCode::nozzle_upright, geom::degrees(e.lean), 1, -1, e.lean_at.x, e.lean_at.y});
    if (a.chain.carrier == kinematics::Carrier::frame) return add_arm_efforts(profile, e.arm, stage, notes, facts);
    if (!a.active()) return;
    const auto degrees = [](double rad) { return geom::degrees(rad); };
    facts.push_back({stage, "unwinds", static_cast<double>(e.unwinds), ""});
    facts.push_back({stage, "largest-lean", degrees(e.lean), "deg"});
    if (e.unwinds > 0)
        notes.push_back({NoteCode::stroke_unwound, static_cast<double>(e.unwinds), e.unwinds,
                         static_cast<std::int64_t>(e.unwind_layer), e.unwind.x, e.unwind.y});
    if (e.unwinds_in_turns > 0)
        notes.push_back(
            {NoteCode::stroke_unwound_in_turn, static_cast<double>(e.unwinds_in_turns), e.unwinds_in_turns});
    if (degrees(e.clipped) > told)
        notes.push_back({NoteCode::tool_leans_for_limits, degrees(e.clipped), 1, -1, e.clipped_at.x, e.clipped_at.y});
    if (a.chain.carrier == kinematics::Carrier::polar && degrees(e.lean) > told)
        notes.push_back({NoteCode::tool_leans_sideways, degrees(e.lean), 1, -1, e.lean_at.x, e.lean_at.y});
}

std::vector<std::string> summary(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift,
                                 const Notes& notes, const Facts& facts) {
    std::vector<std::string> out{strokes(first_pass, facts), material(profile, first_pass),
                                 size(profile, first_pass, shift)};
    if (std::ranges::all_of(summed(notes), [](const Note& n) { return grade(n) == Grade::harmless; }))
        out.emplace_back("nothing hangs, nothing was left out");
    return out;
}

std::vector<std::string> about(const machine::Profile& profile, const FirstPass& first_pass,
                               const std::vector<std::string>& summary, const Notes& notes) {
    std::vector<std::string> lines;
    lines.push_back(" filum program for '" + profile.name + "', whole only if its last line says \"end of program\"");
    for (const auto& line : summary)
        for (auto& part : wrapped(" " + line, kWidth, "     ")) lines.push_back(std::move(part));
    remarks(notes, Grade::look, lines);
    for (auto& line : axes(profile)) lines.push_back(std::move(line));
    lines.push_back(merged(profile));
    if (!first_pass.placed.empty()) lines.push_back(" " + first_pass.placed);
    totals(profile, first_pass, lines);
    return lines;
}

std::vector<std::string> history(const std::vector<Stage>& stages, const Notes& notes, const Facts& facts) {
    std::vector<std::string> lines;
    pipeline(stages, lines);
    remarks(notes, Grade::harmless, lines);
    for (const Fact& f : facts) {
        const std::string value = fixed_text(f.value, 4) + (f.unit.empty() ? "" : " " + f.unit);
        for (auto& line : wrapped(" " + f.stage + ": " + f.name + " = " + value, kWidth, "     "))
            lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace filum::postproc
