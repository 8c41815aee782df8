#include "mesh/project_heights.hpp"

#include "mesh/formats.hpp"

#include <algorithm>
#include <cstdlib>
#include <pugixml.hpp>
#include <set>

namespace filum::mesh {

namespace {

// The kinds of codes by their numbers in the files of both families of slicers.
HeightCode::Kind kind_of(int number) {
    using Kind = HeightCode::Kind;
    constexpr Kind kKinds[] = {Kind::colour, Kind::pause, Kind::tool};
    return number >= 0 && number < 3 ? kKinds[number] : Kind::custom;
}

void add_codes(const pugi::xml_node& list, const char* name, const char* height, std::vector<HeightCode>& to) {
    for (const auto& code : list.children(name)) {
        const double z = std::strtod(code.attribute(height).value(), nullptr);
        const HeightCode::Kind what = kind_of(code.attribute("type").as_int(-1));
        if (z > 0) to.push_back({z, what, code.attribute("extra").value()});
    }
}

// The names of the settings that hold between heights; "" if there are none.
std::string settings_by_height(const std::string& text) {
    pugi::xml_document xml;
    if (!xml.load_buffer(text.data(), text.size())) return "";
    std::set<std::string> names;
    for (const auto& option : xml.select_nodes("//range/option"))
        names.insert(option.node().attribute("opt_key").value());
    std::string out;
    for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
    return out;
}

} // namespace

std::vector<HeightCode> codes_by_height(archive::Zip& zip, int plate) {
    std::vector<HeightCode> out;
    pugi::xml_document xml;
    if (const char* path = "Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml"; zip.has(path)) {
        const std::string text = zip.read(path);
        if (xml.load_buffer(text.data(), text.size()))
            add_codes(xml.child("custom_gcodes_per_print_z"), "code", "print_z", out);
    } else if (const char* path = "Metadata/custom_gcode_per_layer.xml"; zip.has(path)) {
        const std::string text = zip.read(path);
        if (xml.load_buffer(text.data(), text.size()))
            for (const auto& p : xml.child("custom_gcodes_per_layer").children("plate"))
                if (p.child("plate_info").attribute("id").as_int(1) == plate) add_codes(p, "layer", "top_z", out);
    }
    std::ranges::stable_sort(out, {}, &HeightCode::z);
    return out;
}

Notes tell_heights(archive::Zip& zip, int plate) {
    struct Part {
        const char *path, *element, *what; // the file means something if it holds the element
    };
    constexpr Part kParts[] = {{"Metadata/Slic3r_PE_layer_heights_profile.txt", "|", "layer heights by height"},
                               {"Metadata/layer_heights_profile.txt", "|", "layer heights by height"},
                               {"Metadata/Slic3r_PE_brim_ear_points.txt", "|", "brim ears"},
                               {"Metadata/brim_ear_points.txt", "|", "brim ears"}};
    Notes out;
    for (const Part& part : kParts)
        if (zip.has(part.path) && zip.read(part.path).find(part.element) != std::string::npos)
            out.push_back(note(NoteCode::project_metadata_unused, 0, part.what));
    for (const char* path : {"Metadata/Prusa_Slicer_layer_config_ranges.xml", "Metadata/layer_config_ranges.xml"}) {
        const std::string names = zip.has(path) ? settings_by_height(zip.read(path)) : "";
        if (!names.empty())
            out.push_back(note(NoteCode::project_metadata_unused, 0, "settings by height (" + names + ")"));
    }
    if (const auto codes = codes_by_height(zip, plate); !codes.empty()) {
        out.push_back(note(NoteCode::project_codes));
        out.back().count = codes.size();
    }
    return out;
}

} // namespace filum::mesh
