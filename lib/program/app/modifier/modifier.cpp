#include "app/modifier/modifier.hpp"

#include "app/modifier/painted.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/place.hpp"
#include "mesh/project.hpp"
#include "mesh/read.hpp"
#include "mesh/step/step.hpp"
#include "polygon/clip.hpp"
#include "slice/slice.hpp"
#include "stream/crc32c.hpp"

#include <algorithm>
#include <sstream>

namespace filum::app::modifier {

namespace {

// Whether a note reports that reading the mesh has left out something of a slicer's project.
bool of_project(NoteCode code) {
    constexpr NoteCode kCodes[] = {NoteCode::project_modifier,        NoteCode::project_part_settings,
                                   NoteCode::project_support_body,    NoteCode::project_negative,
                                   NoteCode::project_metadata_unused, NoteCode::project_codes,
                                   NoteCode::project_paint_unused};
    return std::ranges::find(kCodes, code) != std::end(kCodes);
}

using filum::slice::Level;

constexpr const char* kPlacement = "placement_map";
constexpr const char* kUnit = "placement_unit";

// One level for each layer that has a region.
struct Levels {
    std::vector<Level> level;
    std::vector<std::uint32_t> layer;

    explicit Levels(const std::vector<polygon::Region>& regions) {
        for (const polygon::Region& r : regions)
            if (layer.empty() || layer.back() != r.layer) {
                layer.push_back(r.layer);
                level.push_back({r.z, r.height, r.z - r.height / 2});
            }
    }
    [[nodiscard]] std::vector<polygon::Loops> none() const {
        return std::vector<polygon::Loops>(layer.empty() ? 0 : layer.back() + 1);
    }
};

// The value of the setting `name` of `slice` in the history; none if there is not exactly one.
std::optional<std::string> told(const stream::Header& header, const char* name) {
    std::optional<std::string> out;
    for (const stream::Run& run : header.history)
        for (const stream::Setting& s : run.settings) {
            if (run.program != "slice" || s.name != name) continue;
            if (out) return std::nullopt;
            out = s.value;
        }
    return out;
}

// A file whose meshes are moved as the part was.
struct PlacedFile {
    std::string crc32c;
    mesh::File file;
    geom::Affine map; // from the coordinates of the file to those of the layers

    void move(mesh::Mesh& mesh, const std::string& path) const {
        try {
            mesh::move(mesh, map);
        } catch (const Error&) {
            throw Error(Exit::bad_input, "cannot use '" + path + "': moved as the part was, it reaches beyond 10000 m");
        }
    }
};

PlacedFile load(const std::string& path, const stream::Header& header, Notes& notes) {
    const auto map = placement_in(header);
    if (!map)
        throw Error(Exit::bad_input, "cannot place '" + path +
                                         "': the stream does not say how one part was moved; bodies that change "
                                         "settings go with a single part, as this 'slice' puts it down");
    const mesh::Bytes bytes = mesh::load(path);
    const std::string crc = stream::crc32c_text(bytes.view());
    // The plate of the part counts only if this file is the part's own project; otherwise plate 1 is read.
    const auto plate = told(header, "plate"), part = told(header, "input_crc32c");
    const int number = plate && part == crc ? std::stoi(*plate) : 1;
    PlacedFile out{crc, mesh::step::read(bytes.view(), mesh::spoken_name(path), {}, number), *map};
    if (mesh::states_unit(out.file.kind)) { // it is in mm, but the map takes the unit of the part's file
        geom::Affine to_unit;
        for (int k = 0; k < 3; ++k) to_unit.a[k][k] = 1 / unit_in(header);
        out.map = geom::then(to_unit, *map);
    }
    for (const Note& n : out.file.notes)
        if (!of_project(n.code)) notes.push_back(n); // reading leaves out these bodies, but this file uses them
    return out;
}

// The outlines of a body in each layer, indexed by layer number.
std::vector<polygon::Loops> outlines(mesh::Mesh mesh, const Levels& levels, int threads, Notes& notes) {
    std::vector<polygon::Loops> out = levels.none();
    if (out.empty() || mesh.triangles.empty()) return out;
    const auto part = filum::slice::make_part(std::move(mesh), notes);
    const auto sweep = filum::slice::sweep_over(part, {}, levels.level, threads);
    for (std::size_t chunk = 0; chunk < sweep.chunks(); ++chunk) {
        filum::slice::SlicedChunk cut = filum::slice::cut(sweep, chunk);
        for (polygon::Layer& l : cut.layers) out[levels.layer[l.index]] = std::move(l.contours);
        for (Note& n : cut.notes) {
            if (n.layer >= 0) n.layer = levels.layer[static_cast<std::size_t>(n.layer)];
            notes.push_back(std::move(n));
        }
    }
    return out;
}

void tell_if_apart(const std::vector<polygon::Loops>& outlines, const std::vector<polygon::Region>& regions,
                   Notes& notes) {
    const bool meets = std::ranges::any_of(regions, [&](const polygon::Region& r) {
        const polygon::Loops& here = outlines[r.layer];
        return !here.empty() && !polygon::intersect(here, r.loops).empty();
    });
    if (!meets && !regions.empty()) notes.push_back({.code = NoteCode::body_apart});
}

} // namespace

stream::Setting placement_setting(const geom::Affine& map) {
    std::string text;
    for (const auto& row : map.a)
        for (const double v : row) text += shortest_text(v) + ",";
    for (int k = 0; k < 3; ++k) text += shortest_text(map.t[k]) + (k < 2 ? "," : "");
    return {kPlacement, text};
}

stream::Setting unit_setting(double mm) { return {kUnit, shortest_text(mm)}; }

double unit_in(const stream::Header& header) {
    const auto text = told(header, kUnit);
    return text ? parse_number(*text, kUnit) : 1;
}

std::optional<geom::Affine> placement_in(const stream::Header& header) {
    const auto text = told(header, kPlacement);
    if (!text) return std::nullopt;
    std::istringstream in(*text);
    const auto number = [&] {
        std::string word;
        std::getline(in, word, ',');
        return parse_number(word, kPlacement);
    };
    geom::Affine out;
    for (auto& row : out.a)
        for (double& v : row) v = number();
    for (double& v : out.t) v = number();
    return out;
}

bool is_part(const std::string& crc32c, const stream::Header& header) { return told(header, "input_crc32c") == crc32c; }

Body body(const std::string& path, const stream::Header& header, const std::vector<polygon::Region>& regions,
          int threads, Notes& notes) {
    PlacedFile placed = load(path, header, notes);
    placed.move(placed.file.mesh, path);
    Body out{outlines(std::move(placed.file.mesh), Levels(regions), threads, notes), std::move(placed.crc32c)};
    tell_if_apart(out.outlines, regions, notes);
    return out;
}

Project modifiers(const std::string& path, const stream::Header& header, const std::vector<polygon::Region>& regions,
                  int threads, Notes& notes) {
    PlacedFile placed = load(path, header, notes);
    const Levels levels(regions);
    Project out{{}, std::move(placed.crc32c)};
    for (mesh::Body& b : placed.file.bodies) {
        if (!mesh::changes_settings(b)) continue;
        placed.move(b.mesh, path);
        out.bodies.push_back({outlines(std::move(b.mesh), levels, threads, notes), std::move(b.settings)});
        tell_if_apart(out.bodies.back().outlines, regions, notes);
    }
    if (!out.bodies.empty()) return out;
    throw Error(Exit::bad_input, "cannot use '" + path +
                                     "' as --modifier: it holds no bodies that change settings; say what holds in all "
                                     "of it, as '" +
                                     path + ":infill=40%'");
}

SeamFaces seam_faces(const std::string& path, const stream::Header& header, Notes& notes) {
    using Purpose = mesh::Body::Purpose;
    PlacedFile placed = load(path, header, notes);
    SeamFaces out;
    for (mesh::Body& b : placed.file.bodies) {
        if (b.what != Purpose::painted_seam && b.what != Purpose::painted_no_seam) continue;
        placed.move(b.mesh, path);
        mesh::append(b.mesh, b.what == Purpose::painted_seam ? out.wanted : out.unwanted);
    }
    if (!out.wanted.triangles.empty() || !out.unwanted.triangles.empty()) return out;
    throw Error(Exit::bad_input,
                "cannot use '" + path + "' as --seam-in: none of its faces is painted for seams; use --seam instead");
}

Places support_places(const std::string& path, bool wanted, const stream::Header& header,
                      const std::vector<polygon::Region>& regions, int threads, Notes& notes) {
    using Purpose = mesh::Body::Purpose;
    PlacedFile placed = load(path, header, notes);
    const Levels levels(regions);
    const Purpose paint = wanted ? Purpose::painted : Purpose::painted_blocker;
    const auto of_supports = [](const mesh::Body& b) {
        return b.what == Purpose::painted || b.what == Purpose::painted_blocker || mesh::wants_supports(b, true) ||
               mesh::wants_supports(b, false);
    };
    Places out{{levels.none(), std::move(placed.crc32c)}, 0};
    if (std::ranges::none_of(placed.file.bodies, of_supports)) {
        placed.move(placed.file.mesh, path);
        out.body.outlines = outlines(std::move(placed.file.mesh), levels, threads, notes);
        tell_if_apart(out.body.outlines, regions, notes);
        return out;
    }
    bool any = false;
    for (mesh::Body& b : placed.file.bodies) {
        if (!mesh::wants_supports(b, wanted) && b.what != paint) continue;
        any = true;
        placed.move(b.mesh, path);
        if (b.what == paint) out.painted += area_facing_down(b.mesh);
        const auto more = b.what == paint ? seen_from_below(b.mesh, levels.level, levels.layer)
                                          : outlines(std::move(b.mesh), levels, threads, notes);
        for (std::size_t i = 0; i < more.size(); ++i)
            if (!more[i].empty()) out.body.outlines[i] = polygon::unite(out.body.outlines[i], more[i]);
    }
    if (any) return out;
    throw Error(Exit::bad_input, "cannot use '" + path + "' as " + (wanted ? "--support-in" : "--no-support-in") +
                                     ": its bodies and what is painted are for " +
                                     (wanted ? "--no-support-in" : "--support-in"));
}

} // namespace filum::app::modifier
