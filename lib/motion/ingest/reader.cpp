#include "ingest/reader.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "ingest/arc.hpp"
#include "ingest/axes.hpp"
#include "ingest/codes.hpp"
#include "ingest/flow.hpp"
#include "ingest/layers.hpp"
#include "ingest/line.hpp"
#include "ingest/material.hpp"
#include "ingest/modes.hpp"
#include "ingest/origin.hpp"
#include "ingest/remarks.hpp"
#include "ingest/tally.hpp"
#include "machine/codes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace filum::ingest {

namespace {

using machine::AxisNumbers;
using machine::Feeding;
using machine::Profile;

constexpr double kPushed = 1e-6; // extruder units: smaller moves are rounding
constexpr double kAlong = 1e-6;  // mm: a shorter move counts as standing
// Higher tool numbers are codes for the firmware, such as T255 and T1000 of Bambu Lab's printers.
constexpr std::uint32_t kMostTools = 254;

class Reader {
  public:
    Reader(std::string_view program, const std::string& name, const Profile& profile, const Options& options,
           const Beads::Emit& emit)
        : text_(program), name_(name), p_(profile), o_(options), traits_(traits_of(program)),
          layers_(traits_, options.bead.size() == 2 ? options.bead[1] : 0), modes_(profile),
          tools_(machine::tool_lines(profile)), beads_(profile.axes.active(), emit), axes_(profile) {
        if (o_.bead.size() == 2) width_ = o_.bead[0];
    }

    ReadResult follow() {
        while (!text_.empty()) {
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            line(text_.substr(0, end));
            text_.remove_prefix(std::min(end + 1, text_.size()));
        }
        return result();
    }

  private:
    // What SAVE_GCODE_STATE and M120 store.
    struct State {
        Modes modes;
        AxisNumbers at{};
    };

    [[noreturn]] void fail(const std::string& why) const {
        throw Error(Exit::bad_input,
                    "cannot follow the program in " + name_ + ": line " + std::to_string(number_) + " " + why);
    }

    void line(std::string_view text) {
        ++number_;
        const machine::CodeLine line(text);
        if (!line.comment().empty()) remark(remark_in(line.comment(), traits_));
        const std::string_view code = line.code();
        if (code.empty() || code == "%") return;
        condition_.line(text);
        if (is_label(code)) {
            if (controls_flow(code)) fail(kRepeats);
            return void(++out_.ignored);
        }
        if (special(code)) return void(++out_.ignored);
        machine::split(code, words_);
        if (words_.own) return own_command(code);
        if (words_.words.empty()) return void(++out_.no_code);
        if (machine::lacks_code(words_)) fail(words_.fault);
        words();
    }

    void remark(const Remark& r) {
        layers_.take(r);
        if (r.width) width_ = *r.width;
        if (r.feature) feature_ = *r.feature;
        if (r.role) role_ = *r.role;
    }

    // Follows those of the firmware's own commands that matter, and counts all of them.
    void own_command(std::string_view code) {
        if (controls_flow(code)) fail(kRepeats);
        condition_.command(code);
        ++out_.ignored;
        const OwnCommand own(code);
        const std::string name = own.value("NAME");
        if (own.is("SAVE_GCODE_STATE")) states_.insert_or_assign(name, State{modes_, axes_.at});
        if (own.is("RESTORE_GCODE_STATE"))
            if (const auto at = states_.find(name); at != states_.end()) restore(at->second, own.value("MOVE") == "1");
        if (own.is("SET_GCODE_OFFSET") && laid_ && (own.shifts("X") || own.shifts("Y")))
            fail("moves the coordinates in use by SET_GCODE_OFFSET, which is not followed");
        if (!own.is("ACTIVATE_EXTRUDER")) return;
        const std::string extruder = own.value("EXTRUDER");
        if (!extruder.starts_with("extruder")) return;
        take(
            static_cast<std::uint32_t>(std::max(0, std::atoi(extruder.c_str() + std::string_view("extruder").size()))));
    }

    // Goes back to a state, and to its place if `moves`.
    void restore(const State& state, bool moves) {
        modes_ = state.modes;
        if (!moves) return;
        modes_.motion = 0;
        go(state.at, {});
        modes_.motion = state.modes.motion;
    }

    // Applies a line that the profile defines.  False if it does not define it.
    bool special(std::string_view code) {
        if (p_.name.empty()) return false;
        if (!tools_.empty())
            if (const auto result = tools_.find(std::string(code)); result != tools_.end()) {
                take(result->second);
                return true;
            }
        const auto is = [&](const std::string& other) {
            return !other.empty() && code == machine::trimmed(std::string_view(other).substr(0, other.find('\n')));
        };
        const auto& e = machine::of_tool(p_, axes_.tool()).extrusion;
        const auto& a = p_.axes;
        const bool opens = is(e.on) || (p_.fibre.active() && is(p_.fibre.on));
        const bool closes = is(e.off) || (p_.fibre.active() && is(p_.fibre.off));
        if (opens || closes) modes_.open = opens;
        const bool tips = a.active() && a.numbers == machine::Numbers::tip;
        const bool tip_begins = tips && is(a.tcp_on), tip_ends = tips && is(a.tcp_off);
        if (tip_begins || tip_ends) axes_.mean_tip(tip_begins);
        return opens || closes || tip_begins || tip_ends;
    }

    void take(std::uint32_t tool) {
        if (tool <= kMostTools) axes_.take(tool);
    }

    // --- codes ---
    void words() {
        for (const machine::Word& w : words_.words)
            if (w.letter == 'G' && (w.value == 20 || w.value == 21)) modes_.inches(w.value == 20);
        const bool counts = machine::of_tool(p_, axes_.tool()).extrusion.feeding != Feeding::valve;
        const char extruder = p_.name.empty() ? traits_.extruder : p_.extrusion.letter;
        const Line line = sorted(words_, p_, extruder, counts, modes_.unit());
        if (line.tool && *line.tool >= 0 && (line.first == 'T' || std::ranges::count(line.m, 6) > 0))
            take(static_cast<std::uint32_t>(*line.tool));
        for (const double m : line.m) m_code(m, line);
        if (machine::is_command(words_)) return void(++out_.ignored);
        bool moves = line.m.empty() && line.first != 'T', in_machine = false;
        for (const double g : line.g) moves = g_code(g, line, moves, in_machine);
        if (!moves || !(line.moves() || line.names() || says_motion(line))) return void(++out_.ignored);
        if (*words_.fault != 0) fail(words_.fault);
        // Marlin reads such a number up to the second point.  Beads before the first layer are dropped, with a note.
        const bool drops = !layers_.begun() && !o_.start_code;
        if (words_.cut && !(traits_.marlin && drops)) fail("holds a number with two points");
        if (condition_.holds()) fail("moves only if a condition of the firmware is true, which is not followed");
        if (line.foreign_axis != 0)
            fail(std::string("moves the axis ") + line.foreign_axis +
                 ", which is not followed; name its machine by --machine");
        go(target(line, in_machine), line);
    }

    [[nodiscard]] static bool says_motion(const Line& line) {
        return std::ranges::any_of(line.g, [](double g) { return g >= 0 && g <= 3; });
    }

    // Follows one code.  Returns whether the line still moves: a code that owns the line's words ends that.
    bool g_code(double g, const Line& line, bool moves, bool& in_machine) {
        const bool offsets = line.l && (*line.l == 2 || *line.l == 20);
        const Code code = code_of(g, {line.places(), offsets, traits_.machinekit});
        switch (code.action) {
        case Action::modal:
            modes_.modal(g);
            return moves;
        case Action::machine:
            in_machine = true;
            return moves;
        case Action::work_system:
            use_system(g);
            return moves;
        case Action::move:
            modes_.motion = static_cast<int>(g);
            return true;
        case Action::probe:
            ++out_.probes;
            modes_.motion = 1;
            return true;
        case Action::not_followed:
            fail("asks for G" + shortest_text(g) + ", " + code.why + ", which is not followed");
        case Action::retract:
        case Action::give:
            if (!line.p && !line.s && !line.l) firmware_retraction(code.action == Action::retract);
            return false;
        case Action::home:
        case Action::zero:
        case Action::native:
        case Action::local:
        case Action::work_offset:
            origin(code.action, line);
            return false;
        case Action::command:
            return false;
        }
        return moves;
    }

    void m_code(double m, const Line& line) {
        if (m == 82 || m == 83) modes_.extruder_is(m == 83);
        if (m == 200 && line.d) volumetric_ = *line.d > 0;
        if (m == 221 && line.s && *line.s > 0) flow_ = *line.s / 100;
        if (m == 605 && line.s && *line.s >= 2)
            fail("asks for M605, several heads that do the same, which is not followed");
        // With a file's name in quotes, M98 runs a macro of the firmware. M808 L is a loop of Marlin.
        if ((m == 97 || m == 98 || m == 198) && line.p) fail(kRepeats);
        if (m == 808 && line.l) fail(kRepeats);
        if (m == 120) pushed_.push_back({modes_, axes_.at}); // of RepRapFirmware; harmless with Marlin's meaning
        if (m == 121 && !pushed_.empty()) {
            restore(pushed_.back(), false);
            pushed_.pop_back();
        }
        if (m == 128)
            fail("asks for M128, the control of the tool's tip, which is not followed; name its machine by --machine");
    }

    // --- places ---
    [[nodiscard]] AxisNumbers target(const Line& line, bool in_machine) const {
        AxisNumbers to = axes_.at;
        for (std::size_t k = 0; k < to.size(); ++k) {
            if (!line.has[k]) continue;
            const double v = line.numbers[k];
            to[k] = in_machine ? v : modes_.relative ? axes_.at[k] + v : v + origin_.of(k);
        }
        return to;
    }

    void use_system(double g) {
        const std::size_t system =
            g < 59.05 ? static_cast<std::size_t>(g - 54) : 5 + static_cast<std::size_t>(std::lround((g - 59) * 10));
        if (system >= Origin::kSystems || system == origin_.in_use()) return;
        if (laid_ && !(origin_.is_set(system) && origin_.is_set(origin_.in_use())))
            fail("goes over to the coordinates of G" + shortest_text(g) +
                 ", and the program does not tell where they begin");
        origin_.use(system);
    }

    // Applies a code that changes the origin of coordinates. A program does not state the machine's home, so after it
    // beads start at a new position.
    void origin(Action action, const Line& line) {
        const bool all = std::ranges::none_of(line.named, [](bool b) { return b; });
        const auto p = static_cast<std::size_t>(std::clamp(line.p.value_or(0), 0.0, double{Origin::kSystems}));
        const std::size_t system = p == 0 ? origin_.in_use() : p - 1;
        if (action == Action::native) origin_.forget_names();
        if (action == Action::zero && line.extruder) modes_.extruder = *line.extruder;
        const bool by_place = action == Action::work_offset && *line.l == 20;
        if (action == Action::work_offset && line.places() && !by_place && system == origin_.in_use() &&
            !origin_.is_set(system)) {
            if (laid_) fail("moves the coordinates in use by G10, and the program does not tell where they were");
            ++out_.origins;
        }
        for (std::size_t k = 0; k < line.has.size(); ++k) {
            if (action == Action::home && k < 3 && (all || line.named[k])) {
                axes_.at[k] = 0;
                origin_.home(k);
            }
            if (!line.has[k]) continue;
            const double v = line.numbers[k];
            if (action == Action::zero) origin_.name(k, axes_.at[k], v);
            if (action == Action::local) origin_.local(k, v);
            if (action == Action::work_offset && by_place) origin_.work_name(system, k, axes_.at[k], v);
            if (action == Action::work_offset && !by_place) origin_.work(system, k, v);
        }
    }

    void firmware_retraction(bool takes) {
        if (takes && layers_.begun()) beads_.take_back(0);
    }

    // --- material ---
    void go(const AxisNumbers& to, const Line& line) {
        if (modes_.motion < 0) fail("moves before any G0 or G1");
        const double by = line.extruder ? modes_.pushed(*line.extruder) : 0;
        extruder_decimals_ = line.extruder_decimals;
        ++out_.moves;
        const Vec3 begin{axes_.at[0], axes_.at[1], axes_.at[2]}, end{to[0], to[1], to[2]};
        std::vector<Vec3> points{end};
        if (modes_.motion >= 2) {
            ++out_.arcs;
            if (modes_.plane != 17) fail("is an arc outside the XY plane, which is not followed");
            ArcWords arc = line.arc;
            arc.clockwise = modes_.motion == 2;
            arc.from_begin = modes_.relative_centres;
            points = arc_points(begin, end, arc, o_.arc_tolerance);
            if (points.empty()) fail("is an arc without a proper centre");
        }
        double whole = 0;
        for (std::size_t i = 0; i < points.size(); ++i) whole += distance(i == 0 ? begin : points[i - 1], points[i]);
        for (const Vec3& p : points) {
            const Vec3 here{axes_.at[0], axes_.at[1], axes_.at[2]};
            const double share = whole > 0 ? distance(here, p) / whole : 1;
            axes_.move({p.x, p.y, p.z, to[3], to[4]}, [&](const Place& a, const Place& b, double part) {
                move(a, b, by * share * part, share * part);
            });
        }
    }

    [[nodiscard]] double unit() const { return unit_volume(p_, axes_.tool(), o_.filament, traits_, volumetric_); }

    void move(const Place& a, const Place& b, double by, double share) {
        const bool planar = !p_.axes.active();
        const double way = planar ? distance(a.tip.xy(), b.tip.xy()) : distance(a.tip, b.tip);
        const bool valve = modes_.open && modes_.motion >= 1;
        const double volume = by * unit();
        if ((by > kPushed || valve) && way > kAlong) return lay(a, b, volume, valve, share);
        if (by < -kPushed) beads_.take_back(-volume);
        if (by > kPushed) beads_.push(volume);
        if (distance(a.tip, b.tip) > 0) beads_.go(b, by < -kPushed);
    }

    void lay(const Place& a, const Place& b, double volume, bool valve, double share) {
        const double way = distance(a.tip, b.tip);
        if (!layers_.begun() && !o_.start_code) {
            out_.purged += way;
            ++out_.purged_moves;
            return;
        }
        layers_.bead(a.tip.z, b.tip.z);
        const double height = layers_.height(), decimal = std::pow(10.0, -extruder_decimals_);
        if (!(height > 0)) fail("lays a bead of unknown height; give --bead");
        if (valve && !(width_ > 0)) fail("lays a bead of unknown width; give --bead");
        const double laid = valve ? width_ * height * way : volume, unsure = valve ? 0 : decimal * unit() * share;
        if (!laid_) beads_.stand(a);
        laid_ = true;
        if (!valve) out_.flow_off += std::abs(flow_ - 1) * volume;
        beads_.lay(b, {laid, unsure, height, layers_.index(), axes_.tool(), role_, feature_});
    }

    ReadResult result() {
        const Counts counts = beads_.finish();
        if (!laid_)
            throw Error(Exit::bad_input,
                        "cannot find a bead in the program " + name_ +
                            "; is it G-code that extrudes, and the machine the right one? See --machine");
        return {counts, notes_of(out_, counts), facts_of(out_, counts)};
    }

    std::string_view text_;
    const std::string& name_;
    const Profile& p_;
    const Options& o_;
    ProgramTraits traits_;
    Layers layers_;
    Modes modes_;
    std::map<std::string, std::uint32_t> tools_;
    Beads beads_;
    Axes axes_;
    Origin origin_;
    machine::Words words_;
    Tally out_;
    std::map<std::string, State> states_; // by name, of Klipper
    std::vector<State> pushed_;           // by M120
    Condition condition_;
    double width_ = 0, flow_ = 1; // width in mm; flow of M221
    toolpath::Feature feature_ = toolpath::Feature::none;
    toolpath::Role role_ = toolpath::Role::bead;
    std::uint64_t number_ = 0;  // number of the line, from 1
    int extruder_decimals_ = 0; // of the line's extruder word
    bool volumetric_ = false, laid_ = false;
};

} // namespace

ReadResult read(std::string_view program, const std::string& name, const machine::Profile& profile,
                const Options& options, const Beads::Emit& emit) {
    return Reader(program, name, profile, options, emit).follow();
}

} // namespace filum::ingest
