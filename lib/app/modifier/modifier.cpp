#include "app/modifier/modifier.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/place.hpp"
#include "mesh/step/step.hpp"
#include "polygon/clip.hpp"
#include "slice/slice.hpp"
#include "stream/crc32c.hpp"

#include <algorithm>
#include <sstream>

namespace filum::app::modifier {

namespace {

using filum::slice::Level;

constexpr const char* kPlacement = "placement_map";

// One level for each layer that has a region.
std::vector<Level> levels_of(const std::vector<polygon::Region>& regions, std::vector<std::uint32_t>& layer) {
    std::vector<Level> out;
    for (const polygon::Region& r : regions)
        if (layer.empty() || layer.back() != r.layer) {
            layer.push_back(r.layer);
            out.push_back({r.z, r.height, r.z - r.height / 2});
        }
    return out;
}

} // namespace

stream::Setting placement_setting(const geom::Affine& map) {
    std::string text;
    for (const auto& row : map.a)
        for (const double v : row) text += shortest_text(v) + ",";
    for (int k = 0; k < 3; ++k) text += shortest_text(map.t[k]) + (k < 2 ? "," : "");
    return {kPlacement, text};
}

std::optional<geom::Affine> placement_in(const stream::Header& header) {
    std::optional<std::string> text;
    for (const stream::Run& run : header.history)
        for (const stream::Setting& s : run.settings) {
            if (run.program != "slice" || s.name != kPlacement) continue;
            if (text) return std::nullopt;
            text = s.value;
        }
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

Body body(const std::string& path, const stream::Header& header, const std::vector<polygon::Region>& regions,
          int threads, Notes& notes) {
    const auto map = placement_in(header);
    if (!map)
        throw Error(Exit::bad_input, "cannot place '" + path +
                                         "': the stream does not say how one part was moved; bodies that change "
                                         "settings go with a single part, as this 'slice' puts it down");
    const mesh::Bytes bytes = mesh::load(path);
    mesh::File file = mesh::step::read(bytes.view(), mesh::spoken_name(path), {});
    for (const Note& n : file.notes) notes.push_back(n);
    try {
        mesh::move(file.mesh, *map);
    } catch (const Error&) {
        throw Error(Exit::bad_input, "cannot use '" + path + "': moved as the part was, it reaches beyond 10000 m");
    }
    std::vector<std::uint32_t> layer;
    std::vector<Level> levels = levels_of(regions, layer);
    Body out{std::vector<polygon::Loops>(layer.empty() ? 0 : layer.back() + 1), stream::crc32c_text(bytes.view())};
    if (levels.empty()) return out;
    const auto part = filum::slice::make_part(std::move(file.mesh), notes);
    const auto sweep = filum::slice::sweep_over(part, {}, std::move(levels), threads);
    for (std::size_t chunk = 0; chunk < sweep.chunks(); ++chunk) {
        filum::slice::Cut cut = filum::slice::cut(sweep, chunk);
        for (polygon::Layer& l : cut.layers) out.outlines[layer[l.index]] = std::move(l.contours);
        for (Note& n : cut.notes) {
            if (n.layer >= 0) n.layer = layer[static_cast<std::size_t>(n.layer)];
            notes.push_back(std::move(n));
        }
    }
    const bool meets = std::ranges::any_of(regions, [&](const polygon::Region& r) {
        const polygon::Loops& here = out.outlines[r.layer];
        return !here.empty() && !polygon::intersect(here, r.loops).empty();
    });
    if (!meets) notes.push_back({.stage = "", .what = "body meets nothing of the part", .unit = ""});
    return out;
}

} // namespace filum::app::modifier
