#include "collision/program.hpp"

#include "base/error.hpp"
#include "geom/angle.hpp"
#include "kinematics/chain.hpp"
#include "machine/codes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace filum::collision {

namespace {

using geom::kDegree;
using kinematics::Joints;

constexpr double kChord = 0.002, kLean = 0.2 * kDegree, kTurn = 2 * kDegree;
constexpr int kChordHalvings = 16; // most halvings of a move

using Axes = machine::AxisNumbers;

class Reader {
  public:
    Reader(const std::string& name, const machine::Profile& profile, const ProgramOptions& options)
        : name_(name), p_(profile), o_(options), growth_(machine::heads(profile)), tools_(machine::tool_lines(profile)),
          width_(options.width), height_(options.height) {
        lose_place();
        if (p_.axes.start) stand(*p_.axes.start);
        tip_ = !p_.axes.active() || (p_.axes.numbers == machine::Numbers::tip && p_.axes.tcp_on.empty());
    }

    void line(std::string_view text) {
        ++number_;
        const machine::CodeLine line(text);
        remark(line.comment());
        if (line.code().empty() || line.code() == "%") return;
        if (!special(std::string(line.code()))) words(line.code());
    }

    // X, Y and Z become unknown; a polar machine has no Y.
    void lose_place() {
        at_[0] = at_[1] = at_[2] = std::numeric_limits<double>::quiet_NaN();
        if (p_.axes.chain.carrier == kinematics::Carrier::polar) at_[1] = p_.axes.chain.turn_point.y;
    }

    // Sets the joints; the program's numbers are joints as long as no code makes them tips.
    void stand(const Joints& j) {
        const bool tips = p_.axes.numbers == machine::Numbers::tip && p_.axes.tcp_on.empty();
        const Vec3 at = tips ? kinematics::forward(p_.axes.chain, j).tip : j.xyz;
        at_ = {at.x, at.y, at.z, j.tilt / kDegree, j.turn / kDegree};
    }

    Program finish() {
        if (unsized_ > 0 && stroke_ == 0) {
            number_ = unsized_;
            fail("extrudes a bead of unknown size; give --bead");
        }
        out_.moves = std::move(growth_.moves);
        out_.beads = std::move(growth_.beads);
        return std::move(out_);
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(Exit::bad_input,
                    "cannot follow the program in " + name_ + ": line " + std::to_string(number_) + " " + why);
    }

    void remark(std::string_view text) {
        const auto number = [&](std::string_view key, double& out) {
            if (!text.starts_with(key)) return;
            const auto value = machine::trimmed(text.substr(key.size()));
            double v = 0;
            if (std::from_chars(value.data(), value.data() + value.size(), v).ec == std::errc{} && v > 0) out = v;
        };
        if (!(o_.width > 0)) {
            number("WIDTH:", width_);
            number("HEIGHT:", height_);
        }
        double layer = -1;
        number("LAYER:", layer);
        if (layer >= 0) layer_ = static_cast<std::uint32_t>(layer);
    }

    // Handles lines that the profile defines.
    bool special(const std::string& code) {
        const auto is = [&](const std::string& other) { return !other.empty() && code == machine::trimmed(other); };
        const auto& a = p_.axes;
        if (const auto found = tools_.find(code); found != tools_.end()) {
            take(found->second);
            ++out_.ignored;
            return true;
        }
        const auto& e = machine::of_tool(p_, tool_).extrusion;
        if (is(machine::first_line(e.on))) {
            open_ = true;
            ++out_.ignored;
            return true;
        }
        if (is(machine::first_line(e.off))) {
            open_ = false;
            ++out_.ignored;
            return true;
        }
        if (p_.fibre.active() && is(p_.fibre.on)) {
            open_ = true;
            ++out_.ignored;
            return true;
        }
        if (p_.fibre.active() && is(p_.fibre.off)) {
            open_ = false;
            ++out_.ignored;
            return true;
        }
        if (!a.active() || a.numbers != machine::Numbers::tip) return false;
        if (is(a.tcp_on)) {
            switch_to(true);
            ++out_.ignored;
            return true;
        }
        if (is(a.tcp_off)) {
            switch_to(false);
            ++out_.ignored;
            return true;
        }
        return false;
    }

    // Selects a tool. The position of another tool's tip is unknown, as its codes may move.
    void take(std::uint32_t tool) {
        if (tool != tool_) lose_place();
        tool_ = tool;
    }

    // Changes the meaning of the numbers; the tool does not move.
    void switch_to(bool tip) {
        if (tip == tip_ || !known(at_)) return void(tip_ = tip);
        const Joints j = joints(at_);
        const Vec3 now = tip ? kinematics::forward(chain(), j).tip : j.xyz;
        at_[0] = now.x;
        at_[1] = now.y;
        at_[2] = now.z;
        tip_ = tip;
    }

    [[nodiscard]] const kinematics::Chain& chain() const { return machine::of_tool(p_, tool_).axes.chain; }
    static bool known(const Axes& a) { return !std::isnan(a[0]) && !std::isnan(a[1]) && !std::isnan(a[2]); }

    [[nodiscard]] Joints joints(const Axes& a) const { return machine::joints_of(p_, tool_, a, tip_); }

    // Offset of the tool: axis values refer to the tip of tool 0.
    [[nodiscard]] Vec3 offset() const { return machine::of_tool(p_, tool_).offset; }

    [[nodiscard]] ToolFrame stance(const Axes& a) const {
        const Joints j = joints(a);
        const auto pose = kinematics::forward(chain(), j);
        const Vec3 off = p_.axes.active() ? Vec3{} : offset();
        return {(tip_ ? Vec3{a[0], a[1], a[2]} + off : pose.tip) + o_.shift, pose.axis,
                kinematics::tool_side(chain(), j)};
    }

    void words(std::string_view code) {
        machine::split(code, words_);
        if (words_.own) return void(++out_.ignored);
        if (machine::lacks_code(words_)) fail(words_.fault);
        Axes to = at_;
        std::optional<double> extruder;
        bool moves = false, says_so = false;
        LineMeaning other = LineMeaning::none;
        const bool counts = machine::of_tool(p_, tool_).extrusion.feeding != machine::Feeding::valve;
        const bool command = machine::is_command(words_);
        for (const auto& [letter, v, decimals, flag] : words_.words) {
            if (command && letter != 'M') continue;
            const std::size_t k = machine::axis_of(p_, letter);
            if (k < to.size()) {
                if (!flag) to[k] = v;
                moves = true;
            } else if (letter == 'G' && (v == 0 || v == 1)) {
                mode_ = static_cast<int>(v);
                says_so = true;
            } else if (letter == 'G')
                other = std::max(other, g(v));
            else if (letter == 'M')
                other = std::max(other, m(v));
            else if (counts && letter == p_.extrusion.letter)
                extruder = v;
        }
        if (other == LineMeaning::offset && moves) fail("shifts the zero of an axis with G92, which is not supported");
        if (other == LineMeaning::offset && extruder) extruder_ = *extruder;
        if (other == LineMeaning::home) lose_place();
        if (moves && (other == LineMeaning::none || says_so)) {
            if (*words_.fault != 0) fail(words_.fault);
            if (words_.cut) fail("holds a number with two points");
            return go(to, extruder);
        }
        if (other == LineMeaning::none && extruder) pushed(*extruder);
        ++out_.ignored;
    }

    // What a line does besides moving, which determines its words: the greatest counts.
    enum class LineMeaning : std::uint8_t { none, command, home, offset };

    LineMeaning g(double v) {
        if (v == 2 || v == 3) fail("is an arc; only straight moves are supported");
        if (v == 20) fail("switches to inches; only mm are supported");
        if (v == 91) fail("switches to relative coordinates; only absolute ones are supported");
        if (v == 53) fail("moves to machine coordinates, which are unknown here");
        if (v == 92) return LineMeaning::offset;
        if (v == 28 || v == 30) return LineMeaning::home;
        const bool modal = (v >= 17 && v <= 21) || (v >= 40 && v <= 49) || (v >= 54 && v <= 64) || v == 80 ||
                           (v >= 90 && v < 92) || (v >= 93 && v <= 99);
        return modal ? LineMeaning::none : LineMeaning::command;
    }

    LineMeaning m(double v) {
        if (v == 82) relative_ = false;
        if (v == 83) relative_ = true;
        return LineMeaning::command;
    }

    // Advance of the extruder, mm.
    double pushed(double word) {
        const double by = relative_ ? word : word - extruder_;
        extruder_ = relative_ ? extruder_ + word : word;
        return by;
    }

    void go(const Axes& to, std::optional<double> extruder) {
        if (mode_ < 0) fail("moves before any G0 or G1");
        bool lays = extruder ? pushed(*extruder) > 0 && mode_ == 1 : open_ && mode_ == 1;
        ++out_.lines;
        if (!known(at_) || !known(to)) {
            ++out_.unknown;
            at_ = to;
            return;
        }
        // Material extruded before any size is stated is start code, such as a purge line: the move is followed,
        // without a bead.
        const bool purges = lays && !(width_ > 0 && height_ > 0);
        if (purges && unsized_ == 0) unsized_ = number_;
        lays = lays && !purges;
        if (lays && !laid_) ++stroke_;
        laid_ = lays;
        part(at_, to, stance(at_), stance(to), lays, 0);
        at_ = to;
    }

    // Halves the move until the straight way from stance to stance agrees with that of the axes.
    void part(const Axes& a, const Axes& b, const ToolFrame& from, const ToolFrame& to, bool lays, int depth) {
        Axes middle;
        for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = (a[k] + b[k]) / 2;
        const bool turns = a[3] != b[3] || a[4] != b[4];
        if (turns && depth < kChordHalvings) {
            const ToolFrame true_middle = stance(middle);
            const ToolFrame straight = at(Move{from, to, 0, 0, 0, 0, false}, 0.5);
            const bool near = distance(true_middle.tip, straight.tip) <= kChord &&
                              geom::angle(true_middle.axis, straight.axis) <= kLean &&
                              geom::angle(from.axis, to.axis) + geom::angle(from.side, to.side) <= kTurn;
            if (!near) {
                part(a, middle, from, true_middle, lays, depth + 1);
                part(middle, b, true_middle, to, lays, depth + 1);
                return;
            }
        }
        growth_.add({from, to, 0, static_cast<std::uint32_t>(number_), layer_, stroke_, !lays, tool_},
                    lays ? width_ : 0, height_);
    }

    const std::string& name_;
    const machine::Profile& p_;
    const ProgramOptions& o_;
    Program out_;
    BeadGrowth growth_;
    machine::Words words_; // of the current line
    std::map<std::string, std::uint32_t> tools_;
    Axes at_{};
    double width_, height_, extruder_ = 0;
    // line numbers, from 1; the first line that extruded without a known size, or 0
    std::uint64_t number_ = 0, unsized_ = 0;
    std::uint32_t layer_ = 0, stroke_ = 0, tool_ = 0;
    int mode_ = -1;
    bool tip_ = true, open_ = false, laid_ = false;
    bool relative_ = p_.extrusion.relative;
};

} // namespace

Program read_program(std::string_view text, const std::string& name, const machine::Profile& profile,
                     const ProgramOptions& options) {
    Reader reader(name, profile, options);
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        reader.line(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return reader.finish();
}

} // namespace filum::collision
