// Robots from URDF files; only their joints are read.
#include "base/error.hpp"
#include "base/length_unit.hpp"
#include "base/number.hpp"
#include "geom/frame.hpp"
#include "machine/robot.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace filum::machine {

namespace {

using geom::Frame;
using geom::Vec3;
using kinematics::kAxes;

struct Joint {
    std::string name, type, parent, child;
    Frame place; // the child in the parent's frame, at joint position 0
    kinematics::Axis axis;
    bool mimics = false;
    [[nodiscard]] bool fixed() const { return type == "fixed"; }
    [[nodiscard]] bool turns() const { return type == "revolute" || type == "continuous"; }
};

// rad, and rad/s: eight turns.  A larger limit is taken for degrees.  No axis of a robot with six axes has its limit
// there, and every such robot has axes that turn farther than 50 degrees.
constexpr double kMostAngle = 50;
constexpr double kMostLength = 50000; // mm: a longer link is taken for one in mm, as no robot is 50 m long

constexpr const char* kTypes[] = {"fixed", "revolute", "continuous", "prismatic", "planar", "floating"};

class Tree {
  public:
    Tree(std::string_view text, const std::string& file) : file_(file) {
        pugi::xml_document doc;
        const auto done = doc.load_buffer(text.data(), text.size());
        if (!done) fail(std::string("it is no XML: ") + done.description());
        const pugi::xml_node robot = doc.child("robot");
        if (!robot) fail("it has no <robot>");
        for (const pugi::xml_node& node : robot.children())
            if (std::string_view(node.name()).starts_with("xacro:")) fail("it is a xacro; run xacro on it first");
        for (const pugi::xml_node& node : robot.children("joint")) joints_.push_back(joint(node));
        for (const Joint& j : joints_)
            if (std::ranges::count(joints_, j.child, &Joint::child) > 1)
                fail("link '" + j.child + "' is the child of several joints");
    }

    [[nodiscard]] kinematics::Arm arm(const RobotLinks& links) const {
        const std::string flange = links.flange.empty() ? end() : known(links.flange);
        const auto chain = up(flange);
        for (const Joint* j : chain) {
            check_turns(*j);
            check_limits(*j);
        }
        if (axes_of(chain) != kAxes)
            fail("the way to link '" + flange + "' has " + std::to_string(axes_of(chain)) +
                 " turning axes, and robots of 6 are known; name another link by robot.flange_link");
        check_units(chain);
        const Frame from = geom::inverse(base(links, chain));
        Frame at = from;
        std::array<kinematics::Axis, kAxes> axes;
        std::size_t k = 0;
        for (const Joint* j : chain) {
            at = at * j->place;
            if (j->fixed()) continue;
            axes[k] = j->axis;
            axes[k].direction = at.turn * j->axis.direction;
            axes[k].point = at.origin;
            ++k;
        }
        return kinematics::arm(axes, at);
    }

  private:
    // Throws for a joint between root and flange that cannot be an axis of a robot with six axes, and names its type.
    void check_turns(const Joint& j) const {
        if (j.type == "prismatic")
            fail("joint '" + j.name +
                 "' is a rail (prismatic), and robots of 6 turning axes are known; make it fixed where the robot "
                 "stands on "
                 "it, or give a URDF that begins at the robot's own base");
        if (j.type == "planar" || j.type == "floating")
            fail("joint '" + j.name + "' is " + j.type + ", and robots of 6 turning axes are known; make it fixed");
        if (j.mimics) fail("joint '" + j.name + "' does not turn on its own: it mimics another one");
    }

    // A URDF is in rad and m.  Throws for numbers so large that they must be degrees or mm.
    void check_units(const std::vector<const Joint*>& chain) const {
        for (const Joint* j : chain) {
            if (norm(j->place.origin) > kMostLength)
                fail("joint '" + j->name + "' is " + fixed_text(norm(j->place.origin) / kMetre, 0) +
                     " m from the one before; URDF counts in m: if these are mm, divide xyz by 1000");
            if (!j->turns()) continue;
            const std::string then = "; URDF counts in rad: if these are degrees, multiply by 0.01745329 (pi / 180)";
            for (const double limit : {j->axis.min, j->axis.max})
                if (std::isfinite(limit) && std::abs(limit) > kMostAngle)
                    fail("joint '" + j->name + "' has a limit of " + fixed_text(limit, 3) + " rad, " +
                         fixed_text(std::abs(limit) / (2 * std::numbers::pi), 1) + " turns" + then +
                         ", if it turns without end, make it 'continuous'");
            if (j->axis.speed > kMostAngle)
                fail("joint '" + j->name + "' has a velocity of " + fixed_text(j->axis.speed, 3) + " rad/s" + then);
        }
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw Error(Exit::bad_input, "cannot use robot model '" + file_ + "': " + why);
    }

    [[nodiscard]] Vec3 three(const pugi::xml_node& node, const char* name, const Vec3& otherwise) const {
        const std::string_view text = node.attribute(name).value();
        if (text.empty()) return otherwise;
        std::array<double, 3> v{};
        std::size_t at = 0;
        for (double& x : v) {
            at = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
            const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
            x = number(text.substr(at, end - at), name);
            at = end;
        }
        return {v[0], v[1], v[2]};
    }

    [[nodiscard]] double number(std::string_view text, const char* what) const {
        double v = 0;
        try {
            v = parse_number(text, what);
        } catch (const Error&) {
            fail("'" + std::string(text.substr(0, 40)) + "' in " + what + " is no number; is it a xacro?");
        }
        return v;
    }

    [[nodiscard]] Joint joint(const pugi::xml_node& node) const {
        constexpr double mm = kMetre; // URDF is in m
        Joint out;
        out.name = node.attribute("name").value();
        out.type = node.attribute("type").value();
        out.parent = node.child("parent").attribute("link").value();
        out.child = node.child("child").attribute("link").value();
        if (out.parent.empty() || out.child.empty()) fail("joint '" + out.name + "' lacks its links");
        if (std::ranges::find(kTypes, out.type) == std::end(kTypes))
            fail("joint '" + out.name + "' is of the unknown type '" + out.type + "'");
        const Vec3 xyz = three(node.child("origin"), "xyz", {}), rpy = three(node.child("origin"), "rpy", {});
        out.place = {geom::from_euler_zyx(rpy.z, rpy.y, rpy.x), mm * xyz};
        out.axis.direction = three(node.child("axis"), "xyz", {1, 0, 0});
        if (!out.fixed() && !(norm(out.axis.direction) > 0)) fail("joint '" + out.name + "' has no axis");
        out.mimics = static_cast<bool>(node.child("mimic"));
        limits(node, out);
        return out;
    }

    void limits(const pugi::xml_node& node, Joint& out) const {
        if (!out.turns()) return;
        const pugi::xml_node limit = node.child("limit");
        const auto value = [&](const char* name) { return number(limit.attribute(name).value(), name); };
        out.axis.min = -std::numeric_limits<double>::infinity();
        out.axis.max = -out.axis.min;
        if (out.type == "revolute") {
            out.axis.min = limit.attribute("lower") ? value("lower") : 0;
            out.axis.max = limit.attribute("upper") ? value("upper") : 0;
        }
        out.axis.speed = limit.attribute("velocity") ? value("velocity") : 0;
    }

    // Throws for an axis without room or speed. Joints beside the chain may have neither, as those of a cylinder.
    void check_limits(const Joint& j) const {
        if (!j.turns()) return;
        if (!(j.axis.min < j.axis.max)) fail("the limits of joint '" + j.name + "' leave it no room");
        if (!(j.axis.speed > 0)) fail("joint '" + j.name + "' needs a limit of its velocity, above 0");
    }

    [[nodiscard]] const Joint* above(const std::string& link) const {
        const auto j = std::ranges::find(joints_, link, &Joint::child);
        return j == joints_.end() ? nullptr : &*j;
    }

    // The joints from the root to a link.
    [[nodiscard]] std::vector<const Joint*> up(const std::string& link) const {
        std::vector<const Joint*> out;
        for (const Joint* j = above(link); j != nullptr; j = above(j->parent)) {
            if (out.size() > joints_.size()) fail("its joints go round in a circle");
            out.push_back(j);
        }
        std::ranges::reverse(out);
        return out;
    }

    [[nodiscard]] static std::size_t axes_of(const std::vector<const Joint*>& chain) {
        return static_cast<std::size_t>(std::ranges::count_if(chain, [](const Joint* j) { return j->turns(); }));
    }

    [[nodiscard]] std::string known(const std::string& link) const {
        for (const Joint& j : joints_)
            if (j.parent == link || j.child == link) return link;
        fail("it has no link '" + link + "'");
    }

    [[nodiscard]] bool has_link(const std::string& link) const {
        return std::ranges::any_of(joints_, [&](const Joint& j) { return j.parent == link || j.child == link; });
    }

    // The link with this name, or else the only link with a prefix before the name ("left_tool0"); 6 axes must lead to
    // it.  "" if there is none.
    [[nodiscard]] std::string tip(const std::string& name) const {
        const auto six = [&](const std::string& link) { return axes_of(up(link)) == kAxes; };
        if (has_link(name) && six(name)) return name;
        std::set<std::string> prefixed;
        for (const Joint& j : joints_)
            if (j.child.ends_with("_" + name) && six(j.child)) prefixed.insert(j.child);
        if (prefixed.size() > 1)
            fail("its flange may be '" + *prefixed.begin() + "' or '" + *prefixed.rbegin() +
                 "'; name one by robot.flange_link");
        return prefixed.empty() ? "" : *prefixed.begin();
    }

    // A joint behind the link that moves on its own; nullptr if there is none.
    [[nodiscard]] const Joint* beyond(const std::string& link) const {
        for (const Joint& j : joints_)
            if (!j.fixed() && !j.mimics && j.child != link)
                if (const auto chain = up(j.child); std::ranges::find(chain, link, &Joint::child) != chain.end())
                    return &j;
        return nullptr;
    }

    [[nodiscard]] std::string end() const {
        for (const char* name : {"tool0", "flange"})
            if (auto link = tip(name); !link.empty()) return link;
        std::set<std::string> last; // last links of chains with six axes, without fixed links after them
        for (const Joint& j : joints_)
            if (j.turns() && axes_of(up(j.child)) == kAxes) last.insert(j.child);
        if (last.size() == 1) {
            if (const Joint* more = beyond(*last.begin()))
                fail("joint '" + more->name +
                     "' moves behind the sixth axis, and robots of 6 turning axes are known; if "
                     "it belongs to a tool, name the flange by robot.flange_link");
            return *last.begin();
        }
        if (!last.empty()) fail("it has several chains of 6 axes; name the last link by robot.flange_link");
        for (const Joint& j : joints_) {
            const auto chain = up(j.child);
            const auto moving = std::ranges::count_if(chain, [](const Joint* k) { return !k->fixed(); });
            for (const Joint* k : chain)
                if (moving >= static_cast<std::ptrdiff_t>(kAxes)) check_turns(*k);
        }
        fail("it has no chain of 6 turning axes");
    }

    // The frame of the robot's base, as its controller counts, seen from the root.  It is that of robot.base_link, or
    // else that of a link "base" or "base_link" (first with the flange's prefix), or else that of the root.  A link
    // that turns with an axis, such as the base of a gripper, is not a base.
    [[nodiscard]] Frame base(const RobotLinks& links, const std::vector<const Joint*>& chain) const {
        const auto stands = [&](const std::string& link) {
            return std::ranges::all_of(up(link), [](const Joint* j) { return j->fixed(); });
        };
        const std::string& flange = chain.back()->child;
        std::string prefix;
        for (const std::string name : {"_tool0", "_flange"})
            if (flange.ends_with(name)) prefix = flange.substr(0, flange.size() - name.size() + 1);
        std::string link = links.base.empty() ? "" : known(links.base);
        for (const char* const name : {"base", "base_link"})
            for (const std::string& full : {prefix + name, std::string(name)})
                if (link.empty() && has_link(full) && stands(full)) link = full;
        if (link.empty()) link = chain.front()->parent;
        if (!stands(link)) fail("link '" + link + "', the base, moves");
        Frame out;
        for (const Joint* j : up(link)) out = out * j->place;
        return out;
    }

    const std::string& file_;
    std::vector<Joint> joints_;
};

} // namespace

kinematics::Arm urdf_robot(std::string_view text, const std::string& file, const RobotLinks& links) {
    return Tree(text, file).arm(links);
}

} // namespace filum::machine
