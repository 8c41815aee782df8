#include "postproc/first_pass.hpp"

#include "postproc/preset_job.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"
#include "postproc/wipe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace filum::postproc {

namespace {

constexpr double kUnlimited = 1e6; // value for templates where there is no limit

std::array<double, 3> coordinates(Vec3 p) { return {p.x, p.y, p.z}; }

std::string place(std::uint32_t layer, Vec3 p) {
    return "on layer " + std::to_string(layer) + " at x " + fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) + ", z " +
           fixed_text(p.z, 3);
}

} // namespace

Surveyor::Surveyor(const machine::Profile& profile, machine::Pauses pauses) : profile_(&profile), clock_(profile) {
    first_pass_.pauses = std::move(pauses);
    first_pass_.timeline = {{0}, {0}};
    for (auto& e : first_pass_.low) e.value = kInfinity;
    for (auto& e : first_pass_.high) e.value = -kInfinity;
    first_pass_.part_low.fill(kInfinity);
    first_pass_.part_high.fill(-kInfinity);
}

void Surveyor::check_section(const Step& step, double length) const {
    const machine::Profile& own = machine::of_tool(*profile_, step.tool);
    const machine::Limits& most = own.limits;
    constexpr double slack = 1e-9;
    if (step.width < most.narrowest * (1 - slack) || step.width > most.widest * (1 + slack))
        throw Error(Exit::failure, "cannot print " + place(step.layer, step.to) + ": a bead " +
                                       fixed_text(step.width, 4) + " mm wide, and tool " + std::to_string(step.tool) +
                                       " of '" + profile_->name + "' lays " + fixed_text(most.narrowest, 4) + " to " +
                                       fixed_text(most.widest, 4) + " mm; use another width or another tool");
    const double section = step.volume / length * own.extrusion.flow;
    if (section <= most.section * (1 + slack)) return;
    throw Error(Exit::failure, "cannot print " + place(step.layer, step.to) + ": a bead of " + fixed_text(section, 4) +
                                   " mm2 is above the " + fixed_text(most.section, 4) + " mm2 that '" + profile_->name +
                                   "' allows; use narrower beads, thinner layers or a larger nozzle");
}

// Visits the extreme points of an arc in x and y.
void Surveyor::visit_arc(const Step& step) {
    const Vec2 arm = at_.xy() - step.centre;
    const double radius = norm(arm), begin = std::atan2(arm.y, arm.x);
    constexpr double quarter = std::numbers::pi / 2;
    const double low = std::min(begin, begin + step.sweep), high = std::max(begin, begin + step.sweep);
    for (double k = std::ceil(low / quarter); k * quarter < high; ++k) {
        Step out = step;
        out.to.x = step.centre.x + radius * std::cos(k * quarter);
        out.to.y = step.centre.y + radius * std::sin(k * quarter);
        visit(out, true);
    }
}

void Surveyor::visit(const Step& step, bool extruding) {
    const Vec3 carried = profile_->axes.active() ? step.axes : step.to - machine::of_tool(*profile_, step.tool).offset;
    const auto c = coordinates(step.to), axes = coordinates(carried);
    for (std::size_t k = 0; k < 3; ++k) {
        if (axes[k] < first_pass_.low[k].value) first_pass_.low[k] = {axes[k], step.to, step.layer};
        if (axes[k] > first_pass_.high[k].value) first_pass_.high[k] = {axes[k], step.to, step.layer};
        if (!extruding) continue;
        first_pass_.part_low[k] = std::min(first_pass_.part_low[k], c[k]);
        first_pass_.part_high[k] = std::max(first_pass_.part_high[k], c[k]);
    }
    if (!extruding || profile_->preset == nullptr) return;
    if (step.layer == 0) first_pass_.first_layer.add(step.to.xy(), step.width / 2);
    first_pass_.footprint.add(step.to.xy(), step.width / 2);
}

// Charges the time since the last charge to the tool in use: as printing within a stroke, else as travel.
void Surveyor::spend() {
    const double now = clock_.total(), time = now - std::exchange(spent_, now);
    Timeline& line = first_pass_.timeline;
    if (const double nominal = nominal_.seconds(); nominal > line.nominal.back()) {
        line.nominal.push_back(nominal);
        line.seconds.push_back(now);
    } else {
        line.seconds.back() = now;
    }
    if (!(time > 0)) return;
    auto& tool = first_pass_.tools[tool_];
    (open_ ? tool.print_seconds : tool.travel_seconds) += time;
}

// Adds the time of a move.  With rotary axes the program gives the duration, from which the planner gets its feed.  A
// robot's moves are assumed to take exactly that long.
void Surveyor::spend_move(const Step& step, const Vec3& d) {
    const bool rotary = profile_->axes.active(), fibre = profile_->fibre.lays(step.tool);
    if (profile_->axes.chain.carrier == kinematics::Carrier::frame) return clock_.pause(step.seconds);
    machine::PlannedMove m{.step = d,
                           .feed = step.feed,
                           .extruding = step.act == Act::extrude,
                           .acceleration = profile_->features.acceleration(step.feature, step.layer)};
    m.extruded = fibre ? step.fed : step.volume * profile_->extrusion.per_mm3();
    if (step.sweep != 0) {
        m.sweep = step.sweep;
        m.arm = at_.xy() - step.centre;
    }
    if (rotary) {
        if (!placed_ || !(step.seconds > 0)) return; // the start position is unknown
        m.tilt = step.tilt - tilt_;
        m.turn = step.turn - turn_;
        const double way = norm(d);
        m.feed = (way > 0 ? way : std::max(std::abs(m.tilt), std::abs(m.turn))) / step.seconds;
    }
    clock_.move(m);
}

void Surveyor::move(const Step& step) {
    const bool rotary = profile_->axes.active(), fibre = profile_->fibre.lays(step.tool);
    const Vec3 d = placed_ ? step.to - at_ : Vec3{}; // before the first move the position is unknown
    const double length = rotary            ? step.length
                          : step.sweep != 0 ? std::abs(step.sweep) * geom::distance(at_.xy(), step.centre)
                                            : geom::norm(d);
    const bool extruding = step.act == Act::extrude;
    if (extruding && step.volume > 0 && !fibre) check_section(step, length);
    spend_move(step, d);
    if (step.sweep != 0) visit_arc(step);
    visit(step, extruding);
    auto& tool = first_pass_.tools[step.tool];
    (extruding ? first_pass_.path_len : first_pass_.travel_len) += length;
    (extruding ? tool.path_len : tool.travel_len) += length;
    first_pass_.role_len[static_cast<std::size_t>(extruding ? step.role : Role::travel)] += length;
    tool.volume += step.volume;
    if (fibre)
        tool.fibre_len += extruding ? length : 0;
    else
        first_pass_.volume += step.volume;
    first_pass_.moves += length > 0 ? 1 : 0;
    first_pass_.laying += extruding ? 1 : 0;
    at_ = step.to;
    tilt_ = step.tilt;
    turn_ = step.turn;
    tool_ = step.tool;
    placed_ = true;
}

double FirstPass::layer_seconds(std::size_t n) const {
    if (n >= layers_begin.size()) return 0;
    const double end = n + 1 < layers_begin.size() ? timeline.seconds_at(layers_begin[n + 1]) : timeline.total();
    return end - timeline.seconds_at(layers_begin[n]);
}

void Surveyor::reach_layer(const Step& step) {
    first_pass_.layers_begin.push_back(nominal_.seconds());
    first_pass_.layers = std::max(first_pass_.layers, step.layer + 1);
    PauseTotals& w = first_pass_.waits;
    const std::uint64_t due = first_pass_.pauses.before(step.layer, step.to.z, step.height);
    if (due > w.count) {
        w.within += open_ ? 1 : 0;
        w.count = due;
    } else if (due < w.count && w.late++ == 0) {
        w.late_layer = step.layer;
    }
}

void Surveyor::add(std::span<const Step> steps) {
    const auto& f = profile_->fibre;
    for (const Step& step : steps) {
        nominal_.add(step);
        const auto& t = machine::of_tool(*profile_, step.tool).travel;
        switch (step.act) {
        case Act::layer:
            reach_layer(step);
            break;
        case Act::open:
            if (first_pass_.strokes++ == 0) {
                first_pass_.start = step.to;
                first_pass_.first_tool = step.tool;
            }
            ++first_pass_.tools[step.tool].strokes;
            visit(step, true);
            spend();
            open_ = true;
            break;
        case Act::close:
            spend();
            open_ = false;
            break;
        case Act::retract:
            clock_.pause(retract_seconds(*profile_, step.tool));
            break;
        case Act::prime:
            clock_.pause(machine::stop_to_stop(t.retract + t.extra, t.prime_speed > 0 ? t.prime_speed : t.retract_speed,
                                               t.retract_acceleration));
            break;
        case Act::tool:
            spend();
            placed_ = false; // its position is unknown
            break;
        case Act::purge:
            clock_.pause(step.volume / machine::of_tool(*profile_, step.tool).purge.speed);
            first_pass_.tools[step.tool].volume += step.volume;
            first_pass_.volume += step.volume;
            break;
        case Act::push:
            clock_.pause(f.prime / f.prime_speed);
            first_pass_.tools[step.tool].fibre_len += f.prime;
            break;
        case Act::tension:
            clock_.pause(f.tension_dwell);
            break;
        case Act::cut:
            clock_.pause(f.cut_dwell);
            ++first_pass_.tools[step.tool].cuts;
            break;
        case Act::omit:
            omit(step);
            break;
        case Act::stand: // its start and its duration are unknown
            visit(step, false);
            at_ = step.to;
            placed_ = true;
            break;
        case Act::travel:
        case Act::climb:
        case Act::extrude:
            move(step);
            break;
        }
    }
}

void Surveyor::omit(const Step& step) {
    OmittedMoves& o = first_pass_.omitted;
    if (o.count == 0 || step.length < o.shortest) {
        o.shortest = step.length;
        o.at = step.to;
        o.layer = step.layer;
    }
    o.longest = std::max(o.longest, step.length);
    o.length += step.length;
    ++o.count;
}

void Surveyor::check_fibre() const {
    const auto& f = profile_->fibre;
    const OmittedMoves& o = first_pass_.omitted;
    if (o.count > 0 && !f.omit_short)
        throw Error(Exit::failure,
                    "cannot lay " + std::to_string(o.count) + (o.count > 1 ? " fibre strokes" : " fibre stroke") +
                        " below the " + fixed_text(f.least_path, 3) + " mm of fibre.least_path: the shortest, " +
                        fixed_text(o.shortest, 3) + " mm, begins " + place(o.layer, o.at) +
                        " of the toolpath; join or lengthen them before postproc, or leave them out by --short drop");
    double used = 0;
    for (const auto& [number, tool] : first_pass_.tools) used += tool.fibre_len;
    if (f.spool > 0 && used > f.spool)
        throw Error(Exit::failure, "cannot lay " + fixed_text(used, 1) + " mm of fibre: '" + profile_->name + "' has " +
                                       fixed_text(f.spool, 1) +
                                       " mm on its spool; divide the job, or raise fibre.spool");
}

FirstPass Surveyor::end() {
    check_fibre();
    if (first_pass_.strokes == 0 || !(first_pass_.path_len > 0))
        throw Error(Exit::bad_input, "cannot write a program: the toolpath lays no bead");
    first_pass_.seconds = clock_.total();
    spend();
    for (auto& [number, tool] : first_pass_.tools) tool.fibre = profile_->fibre.lays(number);
    return first_pass_;
}

MaterialUse used(const machine::Profile& profile, const FirstPass& first_pass) {
    MaterialUse out;
    for (const auto& [number, tool] : first_pass.tools) {
        if (tool.fibre) continue;
        const auto& e = machine::of_tool(profile, number).extrusion;
        out.volume += tool.volume * e.flow;
        out.units += e.feeding == machine::Feeding::valve ? 0 : tool.volume * e.per_mm3();
    }
    return out;
}

Vec2 placement(const FirstPass& first_pass, const machine::Bed& bed, Place where) {
    if (where == Place::as_is) return {0, 0};
    const auto um = [](double v) { return std::round(v * 1000) / 1000; };
    const Vec2 centre = bed.centre();
    return {um(centre.x - (first_pass.low[0].value + first_pass.high[0].value) / 2),
            um(centre.y - (first_pass.low[1].value + first_pass.high[1].value) / 2)};
}

void check_limits(const FirstPass& first_pass, const machine::Profile& profile, Vec2 shift) {
    const auto& bed = profile.bed;
    const std::array<double, 3> moved{shift.x, shift.y, bed.z_offset}, lo{bed.x_min, bed.y_min, bed.z_min},
        hi{bed.x_max, bed.y_max, bed.z_max};
    const auto refuse = [&](const Extreme& e, std::size_t k) {
        const Vec3 p{e.at.x + shift.x, e.at.y + shift.y, e.at.z + bed.z_offset};
        const char* axis = k == 0 ? "x" : k == 1 ? "y" : "z";
        throw Error(Exit::failure, "cannot print " + place(e.layer, p) + ": '" + profile.name + "' reaches " + axis +
                                       " " + fixed_text(lo[k], 3) + " to " + fixed_text(hi[k], 3) +
                                       ", and the toolpath is " +
                                       fixed_text(first_pass.high[k].value - first_pass.low[k].value, 3) + " mm in " +
                                       axis + "; move, turn or scale the part");
    };
    for (std::size_t k = 0; k < 3; ++k) {
        if (first_pass.low[k].value + moved[k] < lo[k] - 5e-4) refuse(first_pass.low[k], k);
        if (first_pass.high[k].value + moved[k] > hi[k] + 5e-4) refuse(first_pass.high[k], k);
    }
    check_outline(profile, first_pass, shift);
    if (!(used(profile, first_pass).units * std::pow(10.0, profile.format.e_decimals) < 4e18))
        throw Error(Exit::failure, "cannot count the material: " + fixed_text(first_pass.volume, 0) +
                                       " mm3 is more than the extruder's numbers hold; are the bead widths right?");
}

geom::Segment purge_line(const machine::Bed& bed, Vec2 low, Vec2 high) {
    constexpr double inset = 2, longest = 60, clear = 5; // mm
    const Vec2 a{bed.x_min + inset, bed.y_min + inset}, c{bed.x_max - inset, bed.y_max - inset};
    const double x = std::min(longest, c.x - a.x), y = std::min(longest, c.y - a.y);
    const geom::Segment along[] = {
        {a, {a.x + x, a.y}}, {a, {a.x, a.y + y}}, {{a.x, c.y}, {a.x + x, c.y}}, {{c.x, a.y}, {c.x, a.y + y}}};
    for (const geom::Segment& s : along) {
        const bool beside = s.b.x + clear < low.x || s.a.x - clear > high.x;
        const bool before = s.b.y + clear < low.y || s.a.y - clear > high.y;
        if (x > 0 && y > 0 && (beside || before)) return s;
    }
    return {{bed.x_min, bed.y_min}, {bed.x_min, bed.y_min}};
}

std::map<std::string, double> placeholders(const FirstPass& s, const machine::Profile& profile, Vec2 shift) {
    const auto& bed = profile.bed;
    std::map<std::string, double> out = profile.values;
    const auto add = [&out](const char* name, double value) { out[name] = value; };
    add("x_min", s.part_low[0] + shift.x);
    add("x_max", s.part_high[0] + shift.x);
    add("y_min", s.part_low[1] + shift.y);
    add("y_max", s.part_high[1] + shift.y);
    add("z_min", s.part_low[2]);
    add("z_max", s.part_high[2]);
    add("x_start", s.start.x + shift.x);
    add("y_start", s.start.y + shift.y);
    add("z_start", s.start.z);
    add("bed_x_min", bed.x_min);
    add("bed_x_max", bed.x_max);
    add("bed_y_min", bed.y_min);
    add("bed_y_max", bed.y_max);
    add("bed_z_max", bed.z_max);
    // A tilted part may be higher than the part is while all axes are at 0.
    const double top = profile.axes.active() ? std::max(s.part_high[2], s.high[2].value) : s.part_high[2];
    add("z_park", std::min(std::max(top + 10, profile.travel.above), bed.z_max));
    add("percent", 0);
    add("minutes_left", std::ceil(s.seconds / 60));
    add("layer", 0);
    add("layers", s.layers);
    add("z", s.start.z);
    add("height", s.start.z);
    add("path_len", s.path_len);
    add("travel_len", s.travel_len);
    add("time", s.seconds);
    add("strokes", static_cast<double>(s.strokes));
    const MaterialUse material = used(profile, s);
    add("material_mm3", material.volume);
    add("material_e", material.units);
    if (profile.axes.chain.carrier == kinematics::Carrier::frame) machine::add_robot(profile.robot, out);
    add("travel_feed", profile.feeds.travel * 60);
    add("z_feed", profile.feeds.z * 60);
    const auto& f = profile.fibre;
    add("tool_no", profile.tools.first);
    add("cut_dwell", f.cut_dwell);
    add("cut_dwell_ms", f.cut_dwell * 1000);
    add("tension_dwell", f.tension_dwell);
    add("tension_dwell_ms", f.tension_dwell * 1000);
    const auto purge = purge_line(bed, {s.part_low[0] + shift.x, s.part_low[1] + shift.y},
                                  {s.part_high[0] + shift.x, s.part_high[1] + shift.y});
    add("purge_x", purge.a.x);
    add("purge_y", purge.a.y);
    add("purge_x_end", purge.b.x);
    add("purge_y_end", purge.b.y);
    const auto& a = profile.axes; // kUnlimited stands for an axis without limit
    const auto degrees = [&](const char* name, double rad) { add(name, std::min(geom::degrees(rad), kUnlimited)); };
    degrees("tilt_axis_speed", a.tilt_speed);
    degrees("turn_axis_speed", a.turn_speed);
    degrees("tilt_axis_acceleration", a.tilt_acceleration);
    degrees("turn_axis_acceleration", a.turn_acceleration);
    degrees("tilt_axis_jump", a.tilt_corner_speed);
    degrees("turn_axis_jump", a.turn_corner_speed);
    return out;
}

} // namespace filum::postproc
