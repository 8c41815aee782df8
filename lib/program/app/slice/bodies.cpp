#include "app/slice/bodies.hpp"

#include "app/slice/grid.hpp"
#include "app/slice/heights.hpp"
#include "app/slice/sizes.hpp"
#include "base/number.hpp"
#include "cli/step_options.hpp"
#include "geom/hull.hpp"
#include "polygon/clip.hpp"
#include "polygon/region.hpp"
#include "stream/crc32c.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace filum::app::slice {

namespace {

using polygon::kMostTool;

[[noreturn]] void refuse(const std::string& item, const std::string& why) {
    throw Error(Exit::usage, "cannot use '" + item + "' as --body: " + why + "; it is FILE:tool=N, as core.stl:tool=1");
}

void set(const std::string& item, const std::string& setting, BodyItem& to) {
    const auto equal = setting.find('=');
    const std::string name = setting.substr(0, equal);
    const std::string value = equal == std::string::npos ? "" : setting.substr(equal + 1);
    if (value.empty()) refuse(item, "'" + setting + "' is no setting");
    const double number = parse_number(value, "--body " + name);
    if (name == "tool") {
        if (!(number >= 0 && number <= kMostTool) || number != std::floor(number))
            refuse(item, "a tool is a whole number from 0 to " + std::to_string(kMostTool));
        to.tool = static_cast<std::uint32_t>(number);
        to.named = true;
    } else if (name == "width") {
        if (!(number >= 0.01 && number <= 100)) refuse(item, "a width is between 0.01 and 100 mm");
        to.width = number;
    } else if (name == "height") {
        if (!(number >= 0.001 && number <= 1000)) refuse(item, "a height is between 0.001 and 1000 mm");
        to.height = number;
    } else {
        refuse(item, "its settings are tool, width and height, not '" + name + "'");
    }
}

// One item.  The last colon before a '=' divides file and settings, since names of files may hold colons.
BodyItem body_item(const std::string& text) {
    BodyItem out{.file = text};
    const auto equal = text.rfind('=');
    const auto colon =
        equal == std::string::npos ? std::string::npos : text.rfind(':', text.find('=', text.rfind(':')));
    if (colon != std::string::npos) {
        out.file = text.substr(0, colon);
        for (std::size_t from = colon + 1; from <= text.size();) {
            const std::size_t comma = std::min(text.find(',', from), text.size());
            set(text, text.substr(from, comma - from), out);
            from = comma + 1;
        }
    }
    if (out.file.empty()) refuse(text, "it names no file");
    return out;
}

// The mesh, divided by materials if the item names no tool and the file has several.
std::map<std::uint32_t, mesh::Mesh> by_tool(const BodyItem& item, mesh::File file) {
    std::map<std::uint32_t, mesh::Mesh> out;
    if (item.named || file.materials.empty()) {
        out[item.tool] = std::move(file.mesh);
        return out;
    }
    for (std::size_t i = 0; i < file.mesh.triangles.size(); ++i)
        out[file.materials[i]].triangles.push_back(file.mesh.triangles[i]);
    for (auto& [tool, mesh] : out) {
        mesh.vertices = file.mesh.vertices;
        mesh::drop_unused_vertices(mesh);
    }
    return out;
}

struct BodyMesh {
    BodyItem item;
    mesh::Mesh mesh;
    Notes notes;
};

// Bodies of one tool have one size of beads: that of those that state one.  `what` names it, as "beads".  Throws
// Error(usage) for two different sizes.
void share(std::vector<BodyMesh>& bodies, double BodyItem::*size, const std::string& what) {
    std::map<std::uint32_t, double> of_tool;
    for (const BodyMesh& b : bodies) {
        double& own = of_tool[b.item.tool];
        if (b.item.*size > 0 && own > 0 && b.item.*size != own)
            refuse(b.item.file, "tool " + std::to_string(b.item.tool) + " has " + what + " of " + shortest_text(own) +
                                    " mm already");
        own = std::max(own, b.item.*size);
    }
    for (BodyMesh& b : bodies) b.item.*size = of_tool[b.item.tool];
}

// Reads the files of the bodies.  `states_unit`: all of them state their unit.
std::vector<BodyMesh> read(const std::vector<BodyItem>& items, const Options& o, cli::Io& self, bool& states_unit) {
    std::vector<BodyMesh> out;
    std::string crc;
    std::size_t stating = 0;
    for (const BodyItem& item : items) {
        const mesh::Bytes bytes = mesh::load(item.file);
        crc += (crc.empty() ? "" : ",") + stream::crc32c_text(bytes.view());
        mesh::File file =
            mesh::step::read(bytes.view(), mesh::spoken_name(item.file), o.step, static_cast<int>(o.plate));
        if (is_carved(file)) refuse(item.file, "its project has negative bodies, which go with a part without --body");
        stating += mesh::states_unit(file.kind) ? 1 : 0;
        Notes notes = std::move(file.notes);
        check_precision(file.mesh, notes);
        for (auto& [tool, mesh] : by_tool(item, std::move(file))) {
            out.push_back({item, std::move(mesh), std::exchange(notes, {})});
            out.back().item.tool = tool;
        }
    }
    share(out, &BodyItem::width, "beads");
    share(out, &BodyItem::height, "layers");
    states_unit = stating == items.size();
    if (stating > 0 && !states_unit && o.place.unit != "mm")
        throw Error(Exit::usage, "cannot use --unit " + o.place.unit +
                                     " with these bodies: only some state their unit; convert the others to mm");
    self.settings.push_back({"input_crc32c", crc});
    return out;
}

} // namespace

std::vector<BodyItem> body_items(const std::string& text) {
    std::vector<BodyItem> out;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(';', from), text.size());
        if (end > from) out.push_back(body_item(text.substr(from, end - from)));
        from = end + 1;
    }
    if (out.empty()) refuse(text, "it names no file");
    return out;
}

std::vector<BedPart> read_bodies(const Options& o, cli::Io& self) {
    if (self.inputs.size() > 1)
        throw Error(Exit::usage, "cannot use --body with several parts: give each body of the part by --body");
    std::vector<BodyItem> items = body_items(o.body);
    if (!self.inputs.empty()) items.insert(items.begin(), BodyItem{.file = self.inputs.front(), .named = true});
    bool states_unit = false;
    std::vector<BodyMesh> meshes = read(items, o, self, states_unit);
    std::string said;
    for (const BodyMesh& b : meshes) {
        const BodyItem& i = b.item;
        said += (said.empty() ? "FILE:tool=" : ";FILE:tool=") + std::to_string(i.tool) +
                (i.width > 0 ? ",width=" + shortest_text(i.width) : "") +
                (i.height > 0 ? ",height=" + shortest_text(i.height) : "");
    }
    self.settings.push_back({"bodies", said, true});
    mesh::Mesh whole;
    for (const BodyMesh& b : meshes) mesh::append(b.mesh, whole);
    const bool several = o.copies > 1 || in_grid(o);
    mesh::Placement placement = o.place;
    placement.scale = enlarged(o.place.scale, o.shrinkage);
    if (several) {
        placement.center.clear();
        placement.translate = {0, 0, o.place.translate[2]};
    }
    Notes placed_notes;
    const mesh::PlacementMap placed = mesh::place(whole, placement, states_unit, placed_notes);
    const bool unit_known = states_unit || o.place.unit != "mm" || o.place.scale != std::vector{1.0};
    const geom::Box3 box = mesh::bounds(whole);
    check_size(box, unit_known, placed_notes);
    check_bed(box, o);
    meshes.front().notes.insert(meshes.front().notes.end(), placed_notes.begin(), placed_notes.end());
    const std::size_t each = copies(o, 1);
    std::vector<BedPart> out;
    for (BodyMesh& b : meshes) {
        mesh::move(b.mesh, placed.map);
        mesh::drop_unused_vertices(b.mesh);
        BedPart body;
        body.name = label(b.item.file);
        body.tool = b.item.tool;
        body.width = b.item.width;
        if (b.item.height > 0) body.layers = layers_of_height(b.item.file, b.item.height, o.slice);
        body.notes = std::move(b.notes);
        body.placement = placed;
        body.box = mesh::bounds(b.mesh);
        std::vector<Vec2> flat;
        for (const geom::Vec3& v : b.mesh.vertices) flat.push_back(v.xy());
        if (several) body.outline = geom::convex_hull(flat);
        body.part = std::make_unique<filum::slice::Part>(
            filum::slice::make_part(std::move(b.mesh), body.notes, o.slice.hairline));
        body.at.assign(each, {});
        out.push_back(std::move(body));
    }
    return out;
}

BedPart joint(const std::vector<BedPart>& bodies) {
    BedPart out;
    out.name = bodies.front().name;
    out.placement = bodies.front().placement;
    out.at = bodies.front().at;
    std::vector<Vec2> flat;
    for (const BedPart& b : bodies) {
        out.box.add(b.box.lo);
        out.box.add(b.box.hi);
        flat.insert(flat.end(), b.outline.begin(), b.outline.end());
    }
    if (!flat.empty()) out.outline = geom::convex_hull(flat);
    return out;
}

void cut_by_later(std::vector<polygon::Loops>& contours, const std::vector<std::uint32_t>& tools, double height,
                  double hairline, std::uint32_t layer, Notes& notes) {
    for (std::size_t b = contours.size(); b-- > 0;) {
        polygon::Loops later;
        for (std::size_t c = b + 1; c < contours.size(); ++c)
            if (tools[c] != tools[b]) later.add(contours[c]);
        if (contours[b].empty() || later.empty()) continue;
        later = polygon::unite(later);
        const polygon::Loops common = polygon::opened(polygon::intersect(contours[b], later), hairline / 2);
        contours[b] = polygon::subtract(contours[b], later);
        if (common.empty()) continue; // bodies that touch overlap by rounding
        const double area = polygon::signed_area(common);
        const Vec2 at = common.points.front();
        notes.push_back(
            {.code = NoteCode::body_overlap, .amount = area * height, .layer = layer, .x = at.x, .y = at.y});
    }
}

void tell_hidden(const std::vector<BedPart>& bodies, const std::vector<std::vector<double>>& kept,
                 std::span<const filum::slice::Level> levels, Notes& notes) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (std::any_of(kept[b].begin(), kept[b].end(), [](double area) { return area > 0; })) continue;
        double volume = 0;
        for (std::size_t i = 0; i < bodies[b].area.size(); ++i) volume += bodies[b].area[i] * levels[i].height;
        notes.push_back({.code = NoteCode::body_hidden, .amount = volume, .detail = "body " + std::to_string(b)});
    }
}

} // namespace filum::app::slice
