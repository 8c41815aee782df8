// 3MF (core specification 1.3, and the production extension's parts in several files): a zip archive whose root model
// lists objects (a mesh, or components: other objects, moved) and the build items that are to be made of them.
#include "archive/zip.hpp"
#include "base/error.hpp"
#include "geom/affine.hpp"
#include "mesh/formats.hpp"
#include "mesh/paint.hpp"
#include "mesh/project.hpp"
#include "mesh/text.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <set>
#include <tuple>

namespace filum::mesh {

using geom::Affine;

namespace {

constexpr std::size_t kMaxTriangles = std::size_t{1} << 24; // after all copies that components ask for
constexpr std::size_t kMaxCopies = 100000;
constexpr int kMaxDepth = 32;
constexpr std::uint32_t kNoVertex = 0xffffffff;

struct Model {
    std::string text; // parsed in place
    pugi::xml_document xml;
    std::map<std::string, pugi::xml_node> objects; // by id
    double unit = 1;                               // mm
};

// Element names without their namespace prefix.
bool is(const pugi::xml_node& n, const char* name) {
    const char* colon = std::strchr(n.name(), ':');
    return std::strcmp(colon != nullptr ? colon + 1 : n.name(), name) == 0;
}
pugi::xml_node child(const pugi::xml_node& n, const char* name) {
    return n.find_child([&](const pugi::xml_node& c) { return is(c, name); });
}
// The attribute "path" of the production extension, under whatever prefix.
std::string part_path(const pugi::xml_node& n) {
    for (const auto& a : n.attributes())
        if (const char* colon = std::strchr(a.name(), ':'); colon != nullptr && std::strcmp(colon, ":path") == 0)
            return a.value();
    return "";
}

class Archive {
  public:
    Archive(std::string_view bytes, const std::string& name, Notes& notes, std::vector<Body>& bodies)
        : name_(name), notes_(notes), bodies_(bodies), zip_(bytes, name) {}

    Mesh build() {
        const std::string root = root_path();
        const Model& model = load(root);
        read_project();
        const auto build = child(child(model.xml, "model"), "build");
        for (const auto& item : build.children()) {
            if (!is(item, "item")) continue;
            if (std::strcmp(item.attribute("printable").value(), "0") == 0) {
                notes_.push_back(note("build item marked as not printable left out", 0, ""));
                continue;
            }
            const std::string path = part_path(item);
            add(path.empty() ? root : path, item.attribute("objectid").value(), transform(item), 0);
        }
        if (same_.count > 0) notes_.push_back(std::move(same_));
        reserve();
        for (const Placed& p : placed_) add_mesh(p);
        take_bodies();
        return std::move(out_);
    }

  private:
    // A mesh, and where it is to be.
    struct Placed {
        pugi::xml_node mesh;
        double unit = 1;
        Affine place;
        std::string object;               // its id, in the root model; else empty
        std::size_t body = Unmade::kNone; // that it is all of
    };

    [[noreturn]] void bad(const std::string& why) const {
        throw Error(Exit::bad_input, "cannot read " + name_ + ": " + why);
    }

    std::string root_path() {
        if (!zip_.has("_rels/.rels")) {
            const std::string mesh = zip_.find(is_mesh_name); // the first entry that is one by its name
            bad(mesh.empty() ? "it is a ZIP archive, but no 3MF, and holds no mesh"
                             : "it is a ZIP archive that holds '" + mesh + "'; unpack it first");
        }
        pugi::xml_document xml;
        const std::string text = zip_.read("_rels/.rels");
        if (!xml.load_buffer(text.data(), text.size())) bad("'_rels/.rels' in the archive is no XML");
        for (const auto& r : child(xml, "Relationships").children())
            if (std::string_view(r.attribute("Type").value()).ends_with("/3dmodel"))
                return r.attribute("Target").value();
        bad("the archive names no 3D model: it is no 3MF");
    }

    void read_project() {
        constexpr std::pair<const char*, bool (*)(const std::string&, Unmade&)> kFiles[] = {
            {"Metadata/Slic3r_PE_model.config", read_prusa_project},
            {"Metadata/model_settings.config", read_bambu_project}};
        for (const auto& [path, read] : kFiles)
            if (zip_.has(path) && !read(zip_.read(path), unmade_))
                bad("'" + std::string(path) + "' in the archive is no XML");
        triangles_.resize(unmade_.bodies.size());
    }

    const Model& load(const std::string& path) {
        auto& slot = models_[path];
        if (slot != nullptr) return *slot;
        slot = std::make_unique<Model>();
        slot->text = zip_.read(path);
        const auto result = slot->xml.load_buffer_inplace(slot->text.data(), slot->text.size());
        if (!result) bad("'" + path + "' in the archive is no XML: " + result.description());
        const auto model = child(slot->xml, "model");
        slot->unit = unit(model.attribute("unit").value());
        for (const auto& o : child(model, "resources").children())
            if (is(o, "object")) slot->objects.emplace(o.attribute("id").value(), o);
        return *slot;
    }

    [[nodiscard]] double unit(std::string_view word) const {
        constexpr std::pair<std::string_view, double> kUnits[] = {
            {"", 1},        {"millimeter", 1}, {"micron", 0.001}, {"centimeter", 10},
            {"inch", 25.4}, {"foot", 304.8},   {"meter", 1000}};
        for (const auto& [text, mm] : kUnits)
            if (word == text) return mm;
        bad("its unit '" + std::string(word.substr(0, 20)) + "' is unknown");
    }

    [[nodiscard]] Affine transform(const pugi::xml_node& n) const {
        Affine out;
        const auto attribute = n.attribute("transform");
        if (!attribute) return out;
        Text text(attribute.value());
        for (int i = 0; i < 12; ++i) {
            double& to = i < 9 ? out.a[i / 3][i % 3] : out.t[i - 9];
            if (!text.more() || !text.number(to)) bad("a transform has no twelve numbers");
        }
        return out;
    }

    void add(const std::string& path, const std::string& id, const Affine& place, int depth,
             std::size_t body = Unmade::kNone) {
        if (depth > kMaxDepth) bad("its components are nested more than 32 deep, or in a circle");
        const Model& model = load(path);
        const auto found = model.objects.find(id);
        if (found == model.objects.end()) bad("object '" + id + "' is missing");
        const auto& object = found->second;
        if (!there_.insert({&model, id, key(place)}).second) {
            ++same_.count;
            return;
        }
        if (const auto mesh = child(object, "mesh"))
            placed_.push_back({mesh, model.unit, place, depth == 0 ? id : "", body});
        for (const auto& c : child(object, "components").children()) {
            if (!is(c, "component")) continue;
            const std::string other = part_path(c);
            const std::size_t part = unmade_.of_component(id, c.attribute("objectid").value());
            if (++copies_ > kMaxCopies) bad("its components ask for more than 100000 copies");
            add(other.empty() ? path : other, c.attribute("objectid").value(), then(transform(c), place), depth + 1,
                part == Unmade::kNone ? body : part);
        }
    }

    static std::array<double, 12> key(const Affine& place) {
        std::array<double, 12> out{};
        for (std::size_t i = 0; i < 12; ++i) out[i] = i < 9 ? place.a[i / 3][i % 3] : place.t[i - 9];
        return out;
    }

    // Refuses what would be too large before it is made.
    void reserve() {
        std::map<const void*, std::pair<std::size_t, std::size_t>> size; // of a mesh: vertices, triangles
        std::size_t vertices = 0, triangles = 0;
        for (const Placed& p : placed_) {
            const auto [it, fresh] = size.try_emplace(p.mesh.internal_object());
            if (fresh) it->second = {children(child(p.mesh, "vertices")), children(child(p.mesh, "triangles"))};
            vertices += it->second.first;
            triangles += it->second.second;
        }
        if (std::max(vertices, triangles) > kMaxTriangles)
            bad("with all its copies it has " + std::to_string(triangles) + " triangles and " +
                std::to_string(vertices) + " vertices, more than 16 million; print fewer copies at once");
        out_.vertices.reserve(vertices);
        out_.triangles.reserve(triangles);
    }
    static std::size_t children(const pugi::xml_node& n) {
        return static_cast<std::size_t>(std::distance(n.begin(), n.end()));
    }

    // The translation of a transform is in the model's unit as well, so scale last.
    void add_mesh(const Placed& placed) {
        const auto& [mesh, unit, place, object, all_of] = placed;
        const std::size_t first = out_.vertices.size();
        for (const auto& v : child(mesh, "vertices").children()) {
            if (!is(v, "vertex")) continue;
            out_.vertices.push_back(unit * place({number(v, "x"), number(v, "y"), number(v, "z")}));
        }
        const std::size_t count = out_.vertices.size() - first;
        const bool turn = place.mirrors();
        std::size_t number_of = 0;
        for (const auto& t : child(mesh, "triangles").children()) {
            if (!is(t, "triangle")) continue;
            const std::size_t body = all_of != Unmade::kNone ? all_of : unmade_.of_triangle(object, number_of);
            ++number_of;
            Triangle tri{index(t, "v1", count), index(t, "v2", count), index(t, "v3", count)};
            for (auto& v : tri) v += static_cast<std::uint32_t>(first);
            if (body == Unmade::kNone) take_paint(t, tri);
            if (turn) std::swap(tri[1], tri[2]);
            (body == Unmade::kNone ? out_.triangles : triangles_[body]).push_back(tri);
        }
    }

    // What PrusaSlicer, or OrcaSlicer and Bambu Studio, paint on a triangle for supports.
    void take_paint(const pugi::xml_node& t, const Triangle& tri) {
        for (const auto& a : t.attributes()) {
            const std::string_view attribute(a.name());
            if (!attribute.ends_with(":custom_supports") && attribute != "paint_supports") continue;
            const auto& v = out_.vertices;
            const bool known =
                each_painted(a.value(), {v[tri[0]], v[tri[1]], v[tri[2]]}, [&](Paint paint, auto& corners) {
                    std::vector<Corners>* to = paint == Paint::wanted     ? &painted_
                                               : paint == Paint::unwanted ? &painted_blocker_
                                                                          : nullptr;
                    if (to != nullptr) to->push_back(corners);
                });
            if (!known) ++unread_paint_;
        }
    }

    // The bodies with the triangles that were found, and what is painted.
    void take_bodies() {
        std::vector<std::uint32_t> index(out_.vertices.size(), kNoVertex);
        for (std::size_t b = 0; b < unmade_.bodies.size(); ++b) {
            Body& body = unmade_.bodies[b];
            for (Triangle& t : triangles_[b])
                for (auto& v : t) {
                    if (index[v] == kNoVertex) {
                        index[v] = static_cast<std::uint32_t>(body.mesh.vertices.size());
                        body.mesh.vertices.push_back(out_.vertices[v]);
                        seen_.push_back(v);
                    }
                    v = index[v];
                }
            for (const std::uint32_t v : seen_) index[v] = kNoVertex;
            seen_.clear();
            body.mesh.triangles = std::move(triangles_[b]);
            bodies_.push_back(std::move(body));
        }
        take_painted(Body::What::painted, painted_);
        take_painted(Body::What::painted_blocker, painted_blocker_);
        tell_bodies();
    }

    void tell_bodies() {
        using What = Body::What;
        const auto tell = [&](const std::string& what, std::size_t count) {
            if (count == 0) return;
            notes_.push_back(note(what, 0, ""));
            notes_.back().count = count;
        };
        const auto count = [&](std::initializer_list<What> words) {
            return static_cast<std::size_t>(std::ranges::count_if(
                bodies_, [&](const Body& b) { return std::ranges::find(words, b.what) != words.end(); }));
        };
        const std::string body(kOfProject);
        tell(body + " that changes settings left out; see --modifier", count({What::modifier}));
        tell(body + " for supports left out; see --support-in and --no-support-in",
             count({What::enforcer, What::blocker}));
        tell(body + " that is to be cut away left out", count({What::negative}));
        tell("painted triangle of a slicer's project that cannot be read left out", unread_paint_);
    }

    void take_painted(Body::What what, const std::vector<Corners>& painted) {
        if (painted.empty()) return;
        Body& body = bodies_.emplace_back();
        body.what = what;
        for (const Corners& c : painted) {
            const auto first = static_cast<std::uint32_t>(body.mesh.vertices.size());
            body.mesh.vertices.insert(body.mesh.vertices.end(), c.begin(), c.end());
            body.mesh.triangles.push_back({first, first + 1, first + 2});
        }
    }

    [[nodiscard]] double number(const pugi::xml_node& n, const char* what) const {
        Text text(n.attribute(what).value());
        double v = 0;
        if (!text.more() || !text.number(v)) bad(std::string("a vertex has no number '") + what + "'");
        return v;
    }
    [[nodiscard]] std::uint32_t index(const pugi::xml_node& n, const char* what, std::size_t count) const {
        Text text(n.attribute(what).value());
        long long v = -1;
        if (!text.more() || !text.whole(v) || v < 0 || static_cast<std::size_t>(v) >= count)
            bad("a triangle has a corner that is no vertex");
        return static_cast<std::uint32_t>(v);
    }

    const std::string& name_;
    Notes& notes_;
    std::vector<Body>& bodies_;
    archive::Zip zip_;
    std::map<std::string, std::unique_ptr<Model>> models_; // by path
    std::size_t copies_ = 0;
    std::set<std::tuple<const Model*, std::string, std::array<double, 12>>> there_;
    std::vector<Placed> placed_;
    Note same_{.stage = "", .what = "copy of a body in the same place left out", .unit = "", .count = 0};
    Unmade unmade_;
    std::vector<std::vector<Triangle>> triangles_; // of each unmade body
    std::vector<std::uint32_t> seen_;              // vertices of the body at hand
    std::vector<Corners> painted_, painted_blocker_;
    std::size_t unread_paint_ = 0;
    Mesh out_;
};

} // namespace

Mesh read_3mf(std::string_view bytes, const std::string& name, Notes& notes, std::vector<Body>& bodies) {
    return Archive(bytes, name, notes, bodies).build();
}

} // namespace filum::mesh
