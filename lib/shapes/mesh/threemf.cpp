// Reads 3MF (core specification 1.3, and objects in several files as in the production extension). A 3MF is a zip
// archive. Its root model lists objects and the build items made of them. An object is a mesh, or components: other
// objects, moved. threemf_rules.cpp judges extensions and kinds of objects; items.cpp puts items on the bed.
#include "archive/zip.hpp"
#include "base/error.hpp"
#include "geom/affine.hpp"
#include "mesh/formats.hpp"
#include "mesh/items.hpp"
#include "mesh/materials.hpp"
#include "mesh/paint.hpp"
#include "mesh/project.hpp"
#include "mesh/project_heights.hpp"
#include "mesh/text.hpp"
#include "mesh/threemf_rules.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <pugixml.hpp>
#include <set>
#include <tuple>

namespace filum::mesh {

using geom::Affine;

namespace {

struct Model {
    std::string text; // the XML, parsed in place
    pugi::xml_document xml;
    std::map<std::string, pugi::xml_node> objects; // by id
    double unit = 1;                               // mm per unit of the model
};

bool is(const pugi::xml_node& n, const char* name) { return threemf::local_name(n) == name; }
pugi::xml_node child(const pugi::xml_node& n, const char* name) {
    return n.find_child([&](const pugi::xml_node& c) { return is(c, name); });
}
class Archive {
  public:
    Archive(std::string_view bytes, const std::string& name, int plate, File& to)
        : name_(name), plate_(plate), to_(to), zip_(bytes, name) {}

    void read() {
        const std::string root = root_path();
        const Model& model = load(root);
        project_ = read_project(zip_, name_, plate_);
        triangles_.resize(project_.bodies.size());
        std::ranges::move(tell_heights(zip_, plate_), std::back_inserter(to_.notes));
        const std::vector<pugi::xml_node> items = wanted_items(model);
        for (const auto& item : items) {
            const std::string path = threemf::part_path(item);
            add(path.empty() ? root : path, item.attribute("objectid").value(), transform(item), {});
            ++items_;
        }
        if (same_.count > 0) to_.notes.push_back(std::move(same_));
        tell_left_out();
        refuse_program();
        reserve();
        for (const PlacedMesh& p : placed_) add_mesh(p);
        tell(NoteCode::triangle_element_unknown, unknown_, to_.notes);
        set_down();
        take_bodies();
        keep_if_several(to_.materials);
    }

  private:
    // A mesh and its position.
    struct PlacedMesh {
        pugi::xml_node mesh;
        double unit = 1;
        Affine place;
        std::string object;                // its id in the root model; empty for objects of other files
        std::size_t body = Project::kNone; // the body that the whole mesh belongs to
        std::uint32_t item = 0;            // of the build
        std::string path;                  // of its file in the archive
        Materials::Material material;
    };
    // What a component inherits from the objects above it.
    struct Ancestors {
        int depth = 0;
        bool support = false; // one of them is a support
        std::size_t body = Project::kNone;
        const Project::Component* component = nullptr; // what the project says of the object as a component
        Materials::Material material{};
    };

    [[noreturn]] void bad(const std::string& why) const {
        throw Error(Exit::bad_input, "cannot read " + name_ + ": " + why);
    }

    std::string root_path() {
        pugi::xml_document xml;
        const std::string text = zip_.read("_rels/.rels");
        if (!xml.load_buffer(text.data(), text.size())) bad("'_rels/.rels' in the archive is no XML");
        std::string out;
        for (const auto& r : child(xml, "Relationships").children()) {
            if (!std::string_view(r.attribute("Type").value()).ends_with("/3dmodel")) continue;
            if (!out.empty()) bad("the archive names two 3D models, and nothing says which one is meant");
            if (std::strcmp(r.attribute("TargetMode").value(), "External") == 0)
                bad("its 3D model is not in the archive, but at '" + std::string(r.attribute("Target").value()) + "'");
            out = r.attribute("Target").value();
        }
        if (out.empty()) bad("the archive names no 3D model: it is no 3MF");
        return out;
    }

    // Reads the build items: those of the plate that are printable.
    std::vector<pugi::xml_node> wanted_items(const Model& model) {
        const auto build = child(child(model.xml, "model"), "build");
        if (!build) bad("its model has no build: nothing says what is to be made");
        Plates plates(project_.plates, plate_);
        std::vector<pugi::xml_node> out;
        for (const auto& item : build.children()) {
            if (!is(item, "item") || !plates.wanted(item.attribute("objectid").value())) continue;
            if (std::strcmp(item.attribute("printable").value(), "0") == 0)
                to_.notes.push_back(note(NoteCode::item_not_printable));
            else
                out.push_back(item);
        }
        if (const std::string fault = plates.fault(); !fault.empty()) bad(fault);
        plates.tell(to_.notes);
        return out;
    }

    const Model& load(const std::string& path) {
        auto& slot = models_[path];
        if (slot != nullptr) return *slot;
        slot = std::make_unique<Model>();
        slot->text = zip_.read(path);
        const auto result = slot->xml.load_buffer_inplace(slot->text.data(), slot->text.size(),
                                                          pugi::parse_default | pugi::parse_doctype);
        if (!result) bad("'" + path + "' in the archive is no XML: " + result.description());
        const auto model = child(slot->xml, "model");
        if (!model || threemf::has_another(model)) bad("'" + path + "' in the archive does not hold one 3D model");
        if (slot->xml.find_child([](const auto& n) { return n.type() == pugi::node_doctype; }))
            bad("'" + path + "' in the archive has a document type definition, which 3MF forbids");
        if (const std::string name = threemf::unsupported_extension(model); !name.empty())
            bad("it requires the 3MF extension '" + name +
                "', which Filum does not support; export the part as a mesh of triangles");
        slot->unit = unit(model.attribute("unit").value());
        materials_.add_groups(path, child(model, "resources"));
        for (const auto& o : child(model, "resources").children())
            if (is(o, "object") && !slot->objects.emplace(o.attribute("id").value(), o).second)
                bad("two objects have the id '" + std::string(o.attribute("id").value()) + "'");
        return *slot;
    }

    [[nodiscard]] double unit(const std::string& word) const {
        const auto mm = threemf::unit_mm(word);
        if (!mm) bad("its unit '" + word.substr(0, 20) + "' is unknown");
        return *mm;
    }

    [[nodiscard]] Affine transform(const pugi::xml_node& n) const {
        const auto attribute = n.attribute("transform");
        if (!attribute) return {};
        const auto out = threemf::transform(attribute.value());
        if (!out) bad("a transform has no twelve numbers");
        if (out->flattens()) bad("a transform flattens an object to nothing; export the part again");
        return *out;
    }

    void add(const std::string& path, const std::string& id, const Affine& place, Ancestors above) {
        if (above.depth > kMaxDepth) bad("its components are nested more than 32 deep, or in a circle");
        const Model& model = load(path);
        const auto found = model.objects.find(id);
        if (found == model.objects.end()) bad("object '" + id + "' is missing");
        const auto& object = found->second;
        if (!there_.insert({&model, id, threemf::numbers(place), above.body}).second) {
            ++same_.count;
            return;
        }
        const threemf::Function function = checked_function(object, id, above.body != Project::kNone);
        above.material = materials_.of(path, object, above.depth == 0, above.component, above.material, project_);
        above.support = above.support || function == threemf::Function::support;
        if (const auto mesh = child(object, "mesh")) {
            if (above.support)
                ++supports_;
            else if (function == threemf::Function::surface)
                ++surfaces_;
            else
                placed_.push_back(
                    {mesh, model.unit, place, above.depth == 0 ? id : "", above.body, items_, path, above.material});
        }
        std::size_t index = 0;
        for (const auto& c : child(object, "components").children()) {
            if (!is(c, "component")) continue;
            const std::string other = threemf::part_path(c);
            const auto* part = project_.component(id, c.attribute("objectid").value(), index++);
            const std::size_t body = part == nullptr || part->body == Project::kNone ? above.body : part->body;
            if (++copies_ > kMaxCopies) bad("its components ask for more than 100000 copies");
            add(other.empty() ? path : other, c.attribute("objectid").value(), then(transform(c), place),
                {above.depth + 1, above.support, body, part, above.material});
        }
    }

    // The purpose of an object in the build. Bambu Studio and OrcaSlicer give the type "other" to bodies that are not
    // printed themselves.
    threemf::Function checked_function(const pugi::xml_node& object, const std::string& id, bool is_body) {
        const threemf::Function out = threemf::function_of(object);
        const std::string type = object.attribute("type").value();
        if (out == threemf::Function::unknown) bad("object '" + id + "' is of the unknown type '" + type + "'");
        if (out == threemf::Function::other && !is_body)
            bad("object '" + id + "' of type 'other' is among what is to be made");
        if (threemf::is_low_resolution(object))
            bad("the shape of object '" + id +
                "' is held as slices (3MF extension 'slice'), and its mesh is coarser; "
                "export the part as a mesh in full resolution");
        const std::string foreign = threemf::foreign_shape(object);
        if (foreign.empty()) return out;
        if (!child(object, "mesh") && !child(object, "components"))
            bad("object '" + id + "' is a '" + foreign +
                "' of a 3MF extension that Filum does not support; export the "
                "part as a mesh of triangles");
        to_.notes.push_back(note(NoteCode::extension_ignored, 0, foreign));
        return out;
    }

    void tell_left_out() {
        tell(NoteCode::support_object_ignored, supports_, to_.notes);
        tell(NoteCode::surface_object_ignored, surfaces_, to_.notes);
        if (placed_.empty() && supports_ + surfaces_ > 0)
            bad("nothing in its build is a part, only supports or surfaces");
        if (placed_.empty() && same_.count > 0) bad("its components refer to each other in a circle");
    }

    // Printers of Bambu Lab take programs in 3MF archives, which hold no mesh.
    void refuse_program() const {
        const auto entries = zip_.entries();
        const bool program =
            std::ranges::any_of(entries, [](const std::string& entry) { return entry.ends_with(".gcode"); });
        if (placed_.empty() && program)
            bad("it holds a program for a printer (.gcode.3mf), no mesh; give the project or the mesh that it was made "
                "from");
    }

    // Sets items on the bed that would hang in the air or reach below it.
    void set_down() {
        std::vector<geom::Box3> boxes(items_);
        for (std::size_t i = 0; i < to_.mesh.triangles.size(); ++i)
            for (const std::uint32_t v : to_.mesh.triangles[i]) boxes[item_of_[i]].add(to_.mesh.vertices[v]);
        if (project_.found) {
            for (std::uint32_t i = 0; i < items_; ++i) cut_below_bed(boxes[i], i, to_);
            return;
        }
        const std::vector<double> down = heights_to_lose(boxes, to_.notes);
        for (std::size_t v = 0; v < item_of_vertex_.size(); ++v) to_.mesh.vertices[v].z -= down[item_of_vertex_[v]];
    }

    // Throws, before copying any mesh, if the result would be too large.
    void reserve() {
        std::map<const void*, std::pair<std::size_t, std::size_t>> size; // per mesh: numbers of vertices and triangles
        std::size_t vertices = 0, triangles = 0;
        for (const PlacedMesh& p : placed_) {
            const auto [it, fresh] = size.try_emplace(p.mesh.internal_object());
            if (fresh) it->second = {children(child(p.mesh, "vertices")), children(child(p.mesh, "triangles"))};
            vertices += it->second.first;
            triangles += it->second.second;
        }
        if (std::max(vertices, triangles) > kMaxTriangles)
            bad("with all its copies it has " + std::to_string(triangles) + " triangles and " +
                std::to_string(vertices) + " vertices, more than 16 million; print fewer copies at once");
        to_.mesh.vertices.reserve(vertices);
        to_.mesh.triangles.reserve(triangles);
    }
    static std::size_t children(const pugi::xml_node& n) {
        return static_cast<std::size_t>(std::distance(n.begin(), n.end()));
    }

    // The translation of a transform is in the model's unit too, so the unit is applied last.
    void add_mesh(const PlacedMesh& placed) {
        std::vector<Vec3>& vertices = to_.mesh.vertices;
        const std::size_t first = vertices.size();
        for (const auto& v : child(placed.mesh, "vertices").children()) {
            if (!is(v, "vertex")) continue;
            vertices.push_back(placed.unit * placed.place({number(v, "x"), number(v, "y"), number(v, "z")}));
            item_of_vertex_.push_back(placed.item);
        }
        const std::size_t count = vertices.size() - first, before = to_.mesh.triangles.size();
        std::vector<std::size_t> part; // of the project, per printed triangle
        const bool turn = placed.place.mirrors();
        std::size_t number_of = 0;
        for (const auto& t : child(placed.mesh, "triangles").children()) {
            if (!is(t, "triangle")) {
                if (t.type() == pugi::node_element) ++unknown_;
                continue;
            }
            const std::size_t body =
                placed.body != Project::kNone ? placed.body : project_.of_triangle(placed.object, number_of);
            const std::uint32_t material =
                materials_.of_triangle(placed.path, t, number_of++, placed.material, project_);
            Triangle tri{index(t, "v1", count), index(t, "v2", count), index(t, "v3", count)};
            for (auto& v : tri) v += static_cast<std::uint32_t>(first);
            if (project_.printed(body)) take_paint(t, tri);
            if (turn) std::swap(tri[1], tri[2]);
            if (body != Project::kNone) triangles_[body][placed.item].push_back(tri);
            if (!project_.printed(body)) continue;
            to_.mesh.triangles.push_back(tri);
            part.push_back(project_.part_of_triangle(placed.object, number_of - 1, part.empty() ? 0 : part.back()));
            item_of_.push_back(placed.item);
            to_.materials.push_back(material);
        }
        if (project_.found) face_outwards(to_.mesh, before, part, to_.notes);
    }

    // Reads the paint of a triangle for supports and seams, as PrusaSlicer, OrcaSlicer and Bambu Studio write it.
    // Counts all paint that programs may leave unused.
    void take_paint(const pugi::xml_node& t, const Triangle& tri) {
        for (const auto& a : t.attributes()) {
            const char* what = paint_of(a.name());
            if (what == kSupportPaint) paint_.push_back({tri, a.value()}); // points into a text of models_
            if (what == kSeamPaint && *a.value() != '\0') seam_paint_.push_back({tri, a.value()});
            if (what != kSupportPaint && what != nullptr && *a.value() != '\0') ++other_paint_[what];
        }
    }

    // Fills the bodies with their triangles, and adds painted faces.  Each item has negative bodies of its own.
    void take_bodies() {
        std::vector<Body> of_items; // go behind those of the project
        std::swap(of_items, to_.bodies);
        // Printed parts come first, as modifiers have precedence over their settings.
        std::vector<std::size_t> order(project_.bodies.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_partition(order.begin(), order.end(), [&](std::size_t b) { return project_.bodies[b].printed; });
        for (const std::size_t b : order) {
            const Body& body = project_.bodies[b];
            std::vector<Triangle> all;
            for (auto& [item, triangles] : triangles_[b]) {
                all.insert(all.end(), triangles.begin(), triangles.end());
                if (body.what != Body::Purpose::negative) continue;
                to_.bodies.push_back({body.what, body.settings, part_of(to_.mesh, std::exchange(all, {})), item});
            }
            if (body.what != Body::Purpose::negative)
                to_.bodies.push_back({body.what, body.settings, part_of(to_.mesh, all), 0, body.printed});
        }
        std::ranges::move(of_items, std::back_inserter(to_.bodies));
        if (std::ranges::any_of(to_.bodies, [](const Body& b) { return b.what == Body::Purpose::negative; }))
            to_.items = std::move(item_of_);
        add_painted(paint_, Body::Purpose::painted, Body::Purpose::painted_blocker, to_);
        add_painted(seam_paint_, Body::Purpose::painted_seam, Body::Purpose::painted_no_seam, to_);
        tell_bodies(to_);
        for (const auto& [what, triangles] : other_paint_) {
            to_.notes.push_back(note(NoteCode::project_paint_unused, 0, what));
            to_.notes.back().count = triangles;
        }
    }

    [[nodiscard]] double number(const pugi::xml_node& n, const char* what) const {
        Text text(n.attribute(what).value());
        double v = 0;
        if (!text.more()) bad(std::string("a vertex has no number '") + what + "'");
        if (!text.number(v) || text.more())
            bad("'" + std::string(n.attribute(what).value()).substr(0, 20) + "' is no number, but a vertex's " + what);
        return v;
    }
    [[nodiscard]] std::uint32_t index(const pugi::xml_node& n, const char* what, std::size_t count) const {
        Text text(n.attribute(what).value());
        long long v = -1;
        if (!text.more() || !text.whole(v) || text.more() || v < 0 || static_cast<std::size_t>(v) >= count)
            bad("a triangle has a corner that is no vertex");
        return static_cast<std::uint32_t>(v);
    }

    const std::string& name_;
    int plate_;
    File& to_;
    archive::Zip zip_;
    std::map<std::string, std::unique_ptr<Model>> models_; // by path of the file
    std::size_t copies_ = 0;
    std::set<std::tuple<const Model*, std::string, std::array<double, 12>, std::size_t>> there_; // with the body
    std::vector<PlacedMesh> placed_;
    std::uint32_t items_ = 0; // build items so far
    std::vector<std::uint32_t> item_of_vertex_, item_of_;
    std::size_t supports_ = 0, surfaces_ = 0, unknown_ = 0;
    Note same_{.code = NoteCode::body_repeated, .count = 0};
    Project project_;
    Materials materials_;
    std::vector<std::map<std::uint32_t, std::vector<Triangle>>> triangles_; // per body of the project, by item
    std::vector<PaintedTriangle> paint_, seam_paint_;                       // for supports, and for seams
    std::map<std::string, std::size_t> other_paint_; // painted triangles, by the purpose of the paint
};

} // namespace

void read_3mf(std::string_view bytes, const std::string& name, int plate, File& to) {
    Archive(bytes, name, plate, to).read();
}

} // namespace filum::mesh
