// Robots by their URDF: of it the joints are read, and nothing else.
#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/frame.hpp"
#include "machine/robot.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <limits>
#include <set>

namespace filum::machine {

namespace {

using geom::Frame;
using geom::Vec3;
using kinematics::kAxes;

struct Joint {
    std::string name, type, parent, child;
    Frame place; // of the child in the parent, at 0
    kinematics::Axis axis;
    bool mimics = false;
    [[nodiscard]] bool fixed() const { return type == "fixed"; }
};

class Tree {
  public:
    Tree(std::string_view text, const std::string& file) : file_(file) {
        pugi::xml_document doc;
        const auto done = doc.load_buffer(text.data(), text.size());
        if (!done) fail(std::string("it is no XML: ") + done.description());
        const pugi::xml_node robot = doc.child("robot");
        if (!robot) fail("it has no <robot>");
        for (const pugi::xml_attribute& a : robot.attributes())
            if (std::string_view(a.name()) == "xmlns:xacro" && robot.child("xacro:macro"))
                fail("it is a xacro; run xacro on it first");
        for (const pugi::xml_node& node : robot.children("joint")) joints_.push_back(joint(node));
        for (const Joint& j : joints_)
            if (std::ranges::count(joints_, j.child, &Joint::child) > 1)
                fail("link '" + j.child + "' is the child of several joints");
    }

    [[nodiscard]] kinematics::Arm arm(const RobotLinks& links) const {
        const std::string flange = links.flange.empty() ? end() : known(links.flange);
        const auto chain = up(flange);
        if (axes_of(chain) != kAxes)
            fail("the way to link '" + flange + "' has " + std::to_string(axes_of(chain)) +
                 " turning axes, and robots of 6 are known; name another link by robot.flange_link");
        const Frame from = geom::inverse(base(links, chain));
        Frame at = from;
        std::array<kinematics::Axis, kAxes> axes;
        std::size_t k = 0;
        for (const Joint* j : chain) {
            at = at * j->place;
            if (j->fixed()) continue;
            if (j->type == "prismatic" || j->type == "planar" || j->type == "floating" || j->mimics)
                fail("joint '" + j->name + "' does not turn on its own");
            axes[k] = j->axis;
            axes[k].direction = at.turn * j->axis.direction;
            axes[k].point = at.origin;
            ++k;
        }
        return kinematics::arm(axes, at);
    }

  private:
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
        constexpr double mm = 1000; // URDF counts in m
        Joint out;
        out.name = node.attribute("name").value();
        out.type = node.attribute("type").value();
        out.parent = node.child("parent").attribute("link").value();
        out.child = node.child("child").attribute("link").value();
        if (out.parent.empty() || out.child.empty()) fail("joint '" + out.name + "' lacks its links");
        const Vec3 xyz = three(node.child("origin"), "xyz", {}), rpy = three(node.child("origin"), "rpy", {});
        out.place = {geom::from_euler_zyx(rpy.z, rpy.y, rpy.x), mm * xyz};
        out.axis.direction = three(node.child("axis"), "xyz", {1, 0, 0});
        if (!out.fixed() && !(norm(out.axis.direction) > 0)) fail("joint '" + out.name + "' has no axis");
        out.mimics = static_cast<bool>(node.child("mimic"));
        limits(node, out);
        return out;
    }

    void limits(const pugi::xml_node& node, Joint& out) const {
        if (out.type != "revolute" && out.type != "continuous") return;
        const pugi::xml_node limit = node.child("limit");
        const auto value = [&](const char* name) { return number(limit.attribute(name).value(), name); };
        if (!limit && out.type == "revolute") fail("joint '" + out.name + "' has no limit");
        out.axis.min = -std::numeric_limits<double>::infinity();
        out.axis.max = -out.axis.min;
        if (out.type == "revolute") {
            out.axis.min = limit.attribute("lower") ? value("lower") : 0;
            out.axis.max = limit.attribute("upper") ? value("upper") : 0;
        }
        out.axis.speed = limit ? value("velocity") : 0;
        if (!(out.axis.min < out.axis.max)) fail("the limits of joint '" + out.name + "' leave it no room");
        if (!(out.axis.speed > 0)) fail("joint '" + out.name + "' needs a limit of its velocity, above 0");
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
        return static_cast<std::size_t>(std::ranges::count_if(chain, [](const Joint* j) { return !j->fixed(); }));
    }

    [[nodiscard]] std::string known(const std::string& link) const {
        for (const Joint& j : joints_)
            if (j.parent == link || j.child == link) return link;
        fail("it has no link '" + link + "'");
    }

    // Names may have a prefix: "left_tool0".
    [[nodiscard]] std::string named(const char* name) const {
        for (const Joint& j : joints_)
            if (j.child == name || j.child.ends_with(std::string("_") + name)) return j.child;
        return "";
    }

    [[nodiscard]] std::string end() const {
        for (const char* name : {"tool0", "flange"})
            if (const auto link = named(name); !link.empty() && axes_of(up(link)) == kAxes) return link;
        std::set<std::string> last; // of a chain of six, before anything fixed
        for (const Joint& j : joints_)
            if (!j.fixed() && axes_of(up(j.child)) == kAxes) last.insert(j.child);
        if (last.size() != 1)
            fail(last.empty() ? "it has no chain of 6 turning axes"
                              : "it has several chains of 6 axes; name the last link by robot.flange_link");
        return *last.begin();
    }

    // The frame that the controller counts from, seen from the root.
    [[nodiscard]] Frame base(const RobotLinks& links, const std::vector<const Joint*>& chain) const {
        std::string link = links.base.empty() ? named("base") : known(links.base);
        if (link.empty()) link = chain.front()->parent;
        Frame out;
        for (const Joint* j : up(link)) {
            if (!j->fixed()) fail("link '" + link + "', the base, moves");
            out = out * j->place;
        }
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
