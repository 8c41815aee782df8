#include "ingest/reader.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"
#include "ingest/arc.hpp"
#include "ingest/layers.hpp"
#include "ingest/modes.hpp"
#include "ingest/remarks.hpp"
#include "kinematics/chain.hpp"
#include "machine/codes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace filum::ingest {

namespace {

using geom::kDegree;
using machine::AxisNumbers;
using machine::Feeding;
using machine::Profile;

constexpr double kInch = 25.4;                                // mm
constexpr double kPushed = 1e-6;                              // extruder units: less is rounding
constexpr double kAlong = 1e-6;                               // mm in XY: less is no way
constexpr double kChordOff = 0.002, kLeanOff = 0.2 * kDegree; // mm, rad: of what turns
constexpr int kMostHalvings = 16;                             // of a move that turns
constexpr double kUsualDiameter = 1.75;                       // mm
constexpr std::uint32_t kMostTools = 1000;

class Reader {
  public:
    Reader(std::string_view program, const std::string& name, const Profile& profile, const Options& options,
           const Beads::Emit& emit)
        : text_(program), name_(name), p_(profile), o_(options), told_(told_by(program)),
          layers_(told_, options.bead.size() == 2 ? options.bead[1] : 0), modes_(profile),
          tools_(machine::tool_lines(profile)), beads_(profile.axes.active(), emit) {
        if (o_.bead.size() == 2) width_ = o_.bead[0];
        if (p_.axes.start) stand(*p_.axes.start);
        tip_ = !p_.axes.active() || (p_.axes.numbers == machine::Numbers::tip && p_.axes.tcp_on.empty());
    }

    Found follow() {
        while (!text_.empty()) {
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            line(text_.substr(0, end));
            text_.remove_prefix(std::min(end + 1, text_.size()));
        }
        return found();
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(Exit::bad_input,
                    "cannot follow the program in " + name_ + ": line " + std::to_string(number_) + " " + why);
    }

    void line(std::string_view text) {
        ++number_;
        const machine::CodeLine line(text);
        if (!line.comment().empty()) remark(remark_in(line.comment(), told_));
        const std::string_view code = line.code();
        if (code.empty() || code == "%") return;
        if (special(code)) return void(++ignored_);
        machine::split(code, words_);
        if (*words_.fault != 0) fail(words_.fault);
        if (words_.own) return own_command(code);
        words();
    }

    void remark(const Remark& r) {
        layers_.take(r);
        if (r.width) width_ = *r.width;
        if (r.feature) feature_ = *r.feature;
        if (r.role) role_ = *r.role;
    }

    // Klipper's, of which one matters.
    void own_command(std::string_view code) {
        ++ignored_;
        constexpr std::string_view takes = "ACTIVATE_EXTRUDER EXTRUDER=extruder";
        if (!code.starts_with(takes)) return;
        const std::string number(code.substr(takes.size()));
        take(number.empty() ? 0 : static_cast<std::uint32_t>(std::max(0, std::atoi(number.c_str()))));
    }

    // Lines that the profile itself gives a meaning.
    bool special(std::string_view code) {
        if (p_.name.empty()) return false;
        if (!tools_.empty())
            if (const auto found = tools_.find(std::string(code)); found != tools_.end()) {
                take(found->second);
                return true;
            }
        const auto is = [&](const std::string& other) {
            return !other.empty() && code == machine::trimmed(std::string_view(other).substr(0, other.find('\n')));
        };
        const auto& e = machine::of_tool(p_, tool_).extrusion;
        const auto& a = p_.axes;
        const bool opens = is(e.on) || (p_.fibre.active() && is(p_.fibre.on));
        const bool closes = is(e.off) || (p_.fibre.active() && is(p_.fibre.off));
        if (opens || closes) modes_.open = opens;
        const bool tips = a.active() && a.numbers == machine::Numbers::tip;
        const bool tip_begins = tips && is(a.tcp_on), tip_ends = tips && is(a.tcp_off);
        if (tip_begins || tip_ends) switch_to(tip_begins);
        return opens || closes || tip_begins || tip_ends;
    }

    void take(std::uint32_t tool) {
        if (tool > kMostTools) return;
        tool_ = tool;
    }

    // --- places ---
    void stand(const kinematics::Joints& j) {
        const bool tips = p_.axes.numbers == machine::Numbers::tip && p_.axes.tcp_on.empty();
        const Vec3 at = tips ? kinematics::forward(p_.axes.chain, j).tip : j.xyz;
        at_ = {at.x, at.y, at.z, j.tilt / kDegree, j.turn / kDegree};
    }

    // The numbers get another meaning; the tool stays where it is.
    void switch_to(bool tip) {
        if (tip != tip_) {
            const auto j = machine::joints_of(p_, tool_, at_, tip_);
            const auto& chain = machine::of_tool(p_, tool_).axes.chain;
            const Vec3 now = tip ? kinematics::forward(chain, j).tip : j.xyz;
            at_[0] = now.x;
            at_[1] = now.y;
            at_[2] = now.z;
        }
        tip_ = tip;
    }

    [[nodiscard]] Place place(const AxisNumbers& a) const {
        if (!p_.axes.active()) return {Vec3{a[0], a[1], a[2]} + machine::of_tool(p_, tool_).offset};
        const auto pose =
            kinematics::forward(machine::of_tool(p_, tool_).axes.chain, machine::joints_of(p_, tool_, a, tip_));
        return {tip_ ? Vec3{a[0], a[1], a[2]} : pose.tip, pose.axis};
    }

    // --- codes ---
    enum class Owner : std::uint8_t { motion, command, home, offset }; // of the words of a line: the greatest counts

    void words() {
        AxisNumbers given{};
        std::array<bool, 5> has{};
        std::optional<double> extruder;
        ArcWords arc;
        Owner owner = Owner::motion;
        bool moves = false, says_motion = false, shortens = false, takes_back = false;
        double diameter = -1;
        e_decimals_ = 0;
        const bool counts = machine::of_tool(p_, tool_).extrusion.feeding != Feeding::valve;
        for (const auto& [letter, v, decimals] : words_.words) {
            const std::size_t k = machine::axis_of(p_, letter);
            if (k < given.size()) {
                given[k] = v * (k < 3 ? modes_.unit : 1);
                has[k] = moves = true;
            } else if (counts && letter == p_.extrusion.letter) {
                extruder = v * modes_.unit;
                e_decimals_ = decimals;
            } else if (letter == 'G')
                owner = std::max(owner, g(v, says_motion, takes_back));
            else if (letter == 'M')
                owner = std::max(owner, m(v, diameter));
            else if (letter == 'T')
                owner = t(owner, v);
            else if (letter == 'I' || letter == 'J' || letter == 'R')
                (letter == 'I' ? arc.i : letter == 'J' ? arc.j : arc.r) = v * modes_.unit;
            else if (letter == 'P' || letter == 'L' || letter == 'S') {
                shortens = true;
                if (letter == 'P') arc.turns = static_cast<int>(v);
            } else if (letter == 'D' && diameter == 0)
                volumetric_ = v > 0;
        }
        if (owner == Owner::offset) return offset(given, has, extruder);
        if (owner == Owner::home) return home(has);
        if (takes_back && !shortens) return firmware_retraction();
        if (says_motion || (owner == Owner::motion && (moves || extruder))) {
            arc.clockwise = modes_.motion == 2;
            arc.from_begin = modes_.relative_centres;
            return go(target(given, has), extruder, arc);
        }
        ++ignored_;
    }

    [[nodiscard]] AxisNumbers target(const AxisNumbers& given, const std::array<bool, 5>& has) const {
        AxisNumbers to = at_;
        for (std::size_t k = 0; k < to.size(); ++k)
            if (has[k]) to[k] = modes_.relative ? at_[k] + given[k] : given[k] + zero_[k];
        return to;
    }

    Owner g(double v, bool& says_motion, bool& takes_back) {
        const auto is = [v](double code) { return std::abs(v - code) < 1e-3; };
        if (v == 0 || v == 1 || v == 2 || v == 3) {
            modes_.motion = static_cast<int>(v);
            says_motion = true;
        }
        if (v == 10 || v == 11) {
            takes_back = true;
            retracts_ = v == 10;
            return Owner::command;
        }
        if (v == 20 || v == 21) modes_.unit = v == 20 ? kInch : 1;
        if (is(90) || is(91)) modes_.places(v == 91);
        if (is(90.1) || is(91.1)) modes_.relative_centres = is(91.1);
        if (v == 92) return Owner::offset;
        if (v == 28 || v == 30) return Owner::home;
        if (v == 5 || v == 6 || is(5.1) || is(5.2) || v == 18 || v == 19 || v == 53 || (v >= 81 && v <= 89))
            fail("asks for G" + std::to_string(static_cast<int>(v)) + ", which is not understood");
        const bool modal = v < 4 || v == 17 || v == 20 || v == 21 || (v >= 90 && v < 92) || (v >= 40 && v <= 49) ||
                           (v >= 54 && v <= 64) || v == 80 || (v >= 93 && v <= 99);
        return modal ? Owner::motion : Owner::command;
    }

    Owner t(Owner owner, double v) {
        take(static_cast<std::uint32_t>(std::max(v, 0.0)));
        return std::max(owner, Owner::command);
    }

    Owner m(double v, double& diameter) {
        if (v == 82 || v == 83) modes_.extruder_is(v == 83);
        if (v == 200) diameter = 0;
        return Owner::command;
    }

    void offset(const AxisNumbers& given, const std::array<bool, 5>& has, std::optional<double> extruder) {
        for (std::size_t k = 0; k < given.size(); ++k)
            if (has[k]) zero_[k] = at_[k] - given[k];
        if (extruder) modes_.extruder = *extruder;
        ++ignored_;
    }

    // A machine knows where home is, the program does not: what is laid next begins at a new place.
    void home(const std::array<bool, 5>& has) {
        const bool all = std::none_of(has.begin(), has.end(), [](bool b) { return b; });
        for (std::size_t k = 0; k < 3; ++k)
            if (all || has[k]) at_[k] = zero_[k] = 0;
        ++ignored_;
    }

    void firmware_retraction() {
        ++ignored_;
        if (retracts_ && layers_.begun()) beads_.take_back(0);
    }

    // --- material ---
    // mm3 of one unit of the extruder word.
    [[nodiscard]] double unit_volume() const {
        const auto& e = machine::of_tool(p_, tool_).extrusion;
        if (volumetric_ || told_.volumetric) return 1;
        if (!p_.name.empty() && e.feeding != Feeding::filament) return 1 / e.per_mm3();
        double d = o_.filament;
        if (!(d > 0) && !told_.diameters.empty())
            d = told_.diameters[std::min<std::size_t>(tool_, told_.diameters.size() - 1)];
        if (!(d > 0) && !p_.name.empty()) return 1 / e.per_mm3();
        if (!(d > 0)) d = kUsualDiameter;
        return std::numbers::pi * d * d / 4;
    }

    void go(const AxisNumbers& to, std::optional<double> extruder, const ArcWords& arc) {
        if (modes_.motion < 0) fail("moves before any G0 or G1");
        const double by = extruder ? modes_.pushed(*extruder) : 0;
        ++moves_;
        std::vector<Vec3> points;
        if (modes_.motion >= 2) {
            ++arcs_;
            points = arc_points({at_[0], at_[1], at_[2]}, {to[0], to[1], to[2]}, arc, o_.arc_tolerance);
            if (points.empty()) fail("is an arc without a proper centre");
        } else {
            points = {{to[0], to[1], to[2]}};
        }
        double whole = 0;
        Vec3 from{at_[0], at_[1], at_[2]};
        for (const Vec3& p : points) {
            whole += distance(from, p);
            from = p;
        }
        for (const Vec3& p : points) {
            const Vec3 here{at_[0], at_[1], at_[2]};
            const double share = whole > 0 ? distance(here, p) / whole : 1;
            part({p.x, p.y, p.z, to[3], to[4]}, by * share, share, 0);
        }
    }

    // One straight piece of the axes; halved until the tip goes straight, too.
    void part(const AxisNumbers& to, double by, double share, int depth) {
        const Place a = place(at_), b = place(to);
        if ((at_[3] != to[3] || at_[4] != to[4]) && depth < kMostHalvings) {
            AxisNumbers middle{};
            for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = (at_[k] + to[k]) / 2;
            const Place m = place(middle);
            const Vec3 axis = a.axis + b.axis;
            const bool near = distance(m.tip, 0.5 * (a.tip + b.tip)) <= kChordOff &&
                              geom::angle(m.axis, axis) <= kLeanOff && geom::angle(a.axis, b.axis) <= 10 * kLeanOff;
            if (!near) {
                part(middle, by / 2, share / 2, depth + 1);
                part(to, by / 2, share / 2, depth + 1);
                return;
            }
        }
        move(a, b, by, share);
        at_ = to;
    }

    void move(const Place& a, const Place& b, double by, double share) {
        const bool planar = !p_.axes.active();
        const double way = planar ? distance(a.tip.xy(), b.tip.xy()) : distance(a.tip, b.tip);
        const bool valve = modes_.open && modes_.motion >= 1;
        const double volume = by * unit_volume();
        if ((by > kPushed || valve) && way > kAlong) return lay(a, b, volume, valve, share);
        if (by < -kPushed) beads_.take_back(-volume);
        if (by > kPushed) beads_.push(volume);
        if (distance(a.tip, b.tip) > 0) beads_.go(b, by < -kPushed);
    }

    void lay(const Place& a, const Place& b, double volume, bool valve, double share) {
        const double way = distance(a.tip, b.tip);
        if (!layers_.begun() && !o_.start_code) {
            purged_ += way;
            purged_volume_ += volume;
            ++purged_moves_;
            return;
        }
        layers_.bead(a.tip.z, b.tip.z);
        const double height = layers_.height(), decimal = std::pow(10.0, -e_decimals_);
        if (!(height > 0)) fail("lays a bead of unknown height; give --bead");
        if (valve && !(width_ > 0)) fail("lays a bead of unknown width; give --bead");
        const double laid = valve ? width_ * height * way : volume,
                     unsure = valve ? 0 : decimal * unit_volume() * share;
        if (!laid_) beads_.stand(a);
        laid_ = true;
        beads_.lay(b, {laid, unsure, height, layers_.index(), tool_, role_, feature_});
    }

    Found found() {
        Found out;
        out.counts = beads_.finish();
        if (!laid_)
            throw Error(Exit::bad_input,
                        "cannot find a bead in the program " + name_ +
                            "; is it G-code that extrudes, and the machine the right one? See --machine");
        const auto note = [&](const char* what, double amount, const char* unit, std::uint64_t count) {
            if (count > 0) out.notes.push_back({"", what, amount, unit, count});
        };
        note("laid before the first layer, left out; see --start-code", purged_, "mm", purged_moves_);
        constexpr double told = 0.5; // mm3: less is rounding, and what is given on top after each travel
        note("pushed out while the tool stands, in no bead", out.counts.still, "mm3", out.counts.still > told ? 1 : 0);
        const auto fact = [&](const char* what, double value, const char* unit = "") {
            out.facts.push_back({"", what, value, unit});
        };
        fact("strokes", static_cast<double>(out.counts.strokes), "strokes");
        fact("stops", static_cast<double>(out.counts.stops));
        fact("travels", static_cast<double>(out.counts.travels));
        fact("retractions", static_cast<double>(out.counts.retractions));
        fact("extruded", out.counts.extruded, "mm");
        fact("travelled", out.counts.travelled, "mm");
        fact("volume", out.counts.volume, "mm3");
        fact("moves", static_cast<double>(moves_));
        fact("arcs", static_cast<double>(arcs_));
        fact("other-lines", static_cast<double>(ignored_));
        return out;
    }

    std::string_view text_;
    const std::string& name_;
    const Profile& p_;
    const Options& o_;
    Told told_;
    Layers layers_;
    Modes modes_;
    std::map<std::string, std::uint32_t> tools_;
    Beads beads_;
    machine::Words words_;
    AxisNumbers at_{}, zero_{};
    double width_ = 0;
    toolpath::Feature feature_ = toolpath::Feature::none;
    toolpath::Role role_ = toolpath::Role::bead;
    std::uint64_t number_ = 0, ignored_ = 0, moves_ = 0, arcs_ = 0, purged_moves_ = 0;
    double purged_ = 0, purged_volume_ = 0; // mm, mm3
    std::uint32_t tool_ = 0;
    int e_decimals_ = 0; // of the line
    bool tip_ = true, volumetric_ = false, retracts_ = false, laid_ = false;
};

} // namespace

Found read(std::string_view program, const std::string& name, const machine::Profile& profile, const Options& options,
           const Beads::Emit& emit) {
    return Reader(program, name, profile, options, emit).follow();
}

} // namespace filum::ingest
