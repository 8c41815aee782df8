// Reads AMF (ISO/ASTM 52915), unpacked. A file lists objects, whose meshes share a unit, and
// constellations: objects and other constellations that are turned and moved. PrusaSlicer and SuperSlicer write the
// places of parts as constellations, and mark volumes that are not printed by metadata.
#include "base/error.hpp"
#include "base/length_unit.hpp"
#include "geom/affine.hpp"
#include "mesh/formats.hpp"
#include "mesh/items.hpp"
#include "mesh/materials.hpp"
#include "mesh/project.hpp"
#include "mesh/text.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <set>

namespace filum::mesh {

using geom::Affine;

namespace {

constexpr std::string_view kSlicer = "slic3r."; // of metadata in PrusaSlicer's and SuperSlicer's files

// The map that turns by `degrees` in the plane of axes i and j.
Affine turn(double degrees, int i, int j) {
    const double a = degrees * std::numbers::pi / 180;
    Affine out;
    out.a[i][i] = out.a[j][j] = std::cos(a);
    out.a[i][j] = std::sin(a);
    out.a[j][i] = -std::sin(a);
    return out;
}

class Amf {
  public:
    Amf(std::string_view bytes, const std::string& name, File& to) : name_(name), to_(to) {
        const auto result = xml_.load_buffer(bytes.data(), bytes.size());
        if (!result)
            bad("it is an AMF file, but no XML: " + std::string(result.description()) + " at byte " +
                std::to_string(result.offset));
    }

    void read() {
        const auto amf = xml_.child("amf");
        const std::string_view unit(amf.attribute("unit").value());
        const auto mm = unit.empty() ? std::optional(1.0) : length_of_name(unit);
        if (!mm) bad("its unit '" + std::string(unit.substr(0, 20)) + "' is unknown");
        unit_ = *mm;
        collect(amf, "object", objects_);
        collect(amf, "constellation", constellations_);
        std::set<std::string> placed; // what constellations name
        for (const auto& node : amf.children("constellation"))
            for (const auto& instance : node.children("instance"))
                placed.insert(instance.attribute("objectid").value());
        // What no constellation places stands where it is.
        for (const auto& node : amf.children("object"))
            if (!placed.contains(node.attribute("id").value())) add_object(node, {});
        for (const auto& node : amf.children("constellation")) {
            const std::string id = node.attribute("id").value();
            if (!placed.contains(id) || objects_.contains(id)) add_constellation(node, {}, 0);
        }
        if (to_.mesh.triangles.empty() && !objects_.empty() && items_ == 0) bad("none of its objects is a part");
        finish();
    }

  private:
    [[noreturn]] void bad(const std::string& why) const {
        throw Error(Exit::bad_input, "cannot read " + name_ + ": " + why);
    }

    [[nodiscard]] double number(const pugi::xml_node& parent, const char* what, bool needed) const {
        Text text(parent.child_value(what));
        double v = 0;
        if (!text.more()) {
            if (needed) bad(std::string("a vertex has no number '") + what + "'");
            return 0;
        }
        if (!text.number(v) || text.more()) bad(std::string("a number '") + what + "' cannot be read");
        return v;
    }

    using Nodes = std::map<std::string, pugi::xml_node>; // by id

    void collect(const pugi::xml_node& amf, const char* kind, Nodes& to) const {
        for (const auto& node : amf.children(kind))
            if (!to.emplace(node.attribute("id").value(), node).second)
                bad(std::string("two ") + kind + "s have the id '" + node.attribute("id").value() + "'");
    }

    // An id stands for the object that has it; otherwise for the constellation.
    void add_constellation(const pugi::xml_node& constellation, const Affine& place, int depth) {
        if (depth > kMaxDepth) bad("its constellations are nested more than 32 deep, or in a circle");
        for (const auto& instance : constellation.children("instance")) {
            if (++copies_ > kMaxCopies) bad("its constellations ask for more than 100000 copies");
            if (std::string_view(instance.child_value("printable")) == "0") {
                to_.notes.push_back(note(NoteCode::item_not_printable));
                continue;
            }
            const std::string id = instance.attribute("objectid").value();
            const Affine there = then(placing(instance), place);
            if (const auto object = objects_.find(id); object != objects_.end())
                add_object(object->second, there);
            else if (const auto group = constellations_.find(id); group != constellations_.end())
                add_constellation(group->second, there, depth + 1);
            else
                bad("object '" + id + "' is missing");
        }
    }

    // Turns about x, then y, then z, and a shift; PrusaSlicer adds factors of size, which come first.
    [[nodiscard]] Affine placing(const pugi::xml_node& n) const {
        const double all = n.child("scale") ? number(n, "scale", false) : 1;
        const auto factor = [&](const char* name) { return n.child(name) ? number(n, name, false) : all; };
        const auto mirror = [&](const char* name) { return number(n, name, false) == 1 ? -1 : 1; };
        Affine out;
        out.a[0][0] = factor("scalex") * mirror("mirrorx");
        out.a[1][1] = factor("scaley") * mirror("mirrory");
        out.a[2][2] = factor("scalez") * mirror("mirrorz");
        out = then(out, turn(number(n, "rx", false), 1, 2));
        out = then(out, turn(number(n, "ry", false), 2, 0));
        out = then(out, turn(number(n, "rz", false), 0, 1));
        out.t[0] = number(n, "deltax", false);
        out.t[1] = number(n, "deltay", false);
        out.t[2] = number(n, "deltaz", false);
        if (out.flattens()) bad("an instance flattens an object to nothing; export the part again");
        return out;
    }

    void add_object(const pugi::xml_node& object, const Affine& place) {
        const auto mesh = object.child("mesh");
        const std::size_t first = to_.mesh.vertices.size();
        for (const auto& v : mesh.child("vertices").children("vertex")) {
            const auto at = v.child("coordinates");
            to_.mesh.vertices.push_back(unit_ *
                                        place({number(at, "x", true), number(at, "y", true), number(at, "z", true)}));
        }
        const std::size_t count = to_.mesh.vertices.size() - first;
        for (const auto& volume : mesh.children("volume")) add_volume(volume, first, count, place.mirrors());
        edges_ += static_cast<std::size_t>(std::ranges::distance(mesh.child("vertices").children("edge")));
        if (std::max(to_.mesh.triangles.size(), to_.mesh.vertices.size()) > kMaxTriangles)
            bad("with all its copies it has more than 16 million triangles or vertices; print fewer copies at once");
        ++items_;
    }

    void add_volume(const pugi::xml_node& volume, std::size_t first, std::size_t count, bool turned) {
        if (std::string_view(volume.attribute("type").value()) == "support") {
            ++supports_;
            return;
        }
        std::optional<Body> body = unprinted(volume);
        const std::uint32_t material =
            materials_
                .try_emplace(volume.attribute("materialid").value(), static_cast<std::uint32_t>(materials_.size()))
                .first->second;
        std::vector<Triangle> triangles;
        for (const auto& t : volume.children("triangle")) {
            Triangle tri{corner(t, "v1", first, count), corner(t, "v2", first, count), corner(t, "v3", first, count)};
            if (turned) std::swap(tri[1], tri[2]);
            triangles.push_back(tri);
        }
        if (body) {
            body->item = items_;
            bodies_.emplace_back(std::move(*body), std::move(triangles));
            return;
        }
        to_.mesh.triangles.insert(to_.mesh.triangles.end(), triangles.begin(), triangles.end());
        to_.materials.resize(to_.mesh.triangles.size(), material);
        to_.items.resize(to_.mesh.triangles.size(), items_);
    }

    // The body of a slicer's volume that is not printed, with its settings.
    [[nodiscard]] static std::optional<Body> unprinted(const pugi::xml_node& volume) {
        std::optional<Body::Purpose> what;
        Body out;
        for (const auto& data : volume.children("metadata")) {
            const std::string_view type(data.attribute("type").value()), value(data.child_value());
            if (!type.starts_with(kSlicer)) continue;
            const std::string key(type.substr(kSlicer.size()));
            if (key == "volume_type")
                what = prusa_body(value);
            else if (key == "modifier" && value == "1" && !what)
                what = Body::Purpose::modifier;
            else if (is_setting(key) ||
                     (key == "extruder" && value != "0" && value != "1")) // that of the part otherwise
                out.settings.emplace_back(key, value);
        }
        if (!what) return std::nullopt;
        out.what = *what;
        return out;
    }

    [[nodiscard]] std::uint32_t corner(const pugi::xml_node& t, const char* what, std::size_t first,
                                       std::size_t count) const {
        Text text(t.child_value(what));
        long long v = -1;
        if (!text.more() || !text.whole(v) || v < 0 || static_cast<std::size_t>(v) >= count)
            bad("a triangle has a corner that is no vertex");
        return static_cast<std::uint32_t>(first + static_cast<std::size_t>(v));
    }

    void finish() {
        bool cut = false;
        for (auto& [body, triangles] : bodies_) {
            body.mesh = part_of(to_.mesh, triangles);
            cut = cut || body.what == Body::Purpose::negative;
            to_.bodies.push_back(std::move(body));
        }
        if (!cut) to_.items.clear();
        keep_if_several(to_.materials);
        tell_bodies(to_);
        tell(NoteCode::support_object_ignored, supports_, to_.notes);
        tell(NoteCode::triangle_element_unknown, edges_, to_.notes);
    }

    const std::string& name_;
    File& to_;
    pugi::xml_document xml_;
    double unit_ = 1; // mm
    Nodes objects_, constellations_;
    std::map<std::string, std::uint32_t> materials_;
    std::vector<std::pair<Body, std::vector<Triangle>>> bodies_;
    std::size_t copies_ = 0, supports_ = 0, edges_ = 0; // edges: of curved triangles, which are taken as flat
    std::uint32_t items_ = 0;                           // objects in their places so far
};

} // namespace

void read_amf(std::string_view bytes, const std::string& name, File& to) { Amf(bytes, name, to).read(); }

} // namespace filum::mesh
