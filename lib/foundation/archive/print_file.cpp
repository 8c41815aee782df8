#include "archive/print_file.hpp"

#include "archive/zip.hpp"
#include "base/json.hpp"
#include "base/number.hpp"

#include <md5.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

namespace filum::archive {

namespace {

constexpr const char* kProgram = "Metadata/plate_1.gcode";
constexpr const char* kBoxes = "Metadata/plate_1.json";
constexpr const char* kPicture = "Metadata/plate_1.png";
constexpr const char* kSmallPicture = "Metadata/plate_1_small.png";

// Slicers compare this version with their own.  They take a file without it for a plain model.
constexpr const char* kFormatVersion = "01.10.01.50";

// Bambu Lab's model ids. A printer refuses a file with the id of another model, and accepts one without an id.
struct Model {
    const char *name, *id;
};
constexpr Model kModels[] = {{"a1 mini", "N1"},        {"a1", "N2S"},  {"p1p", "C11"},   {"p1s", "C12"},
                             {"x1 carbon", "BL-P001"}, {"x1e", "C13"}, {"x1", "BL-P002"}};

std::string lower(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

// The model id of a Bambu Lab printer; "" for printers of other makers.
std::string model_id(const std::string& printer) {
    const std::string name = lower(printer);
    if (name.find("bambu") == std::string::npos) return "";
    for (const Model& model : kModels)
        if (name.find(model.name) != std::string::npos) return model.id;
    return "";
}

// The MD5 sum as 32 capital hexadecimal digits.
std::string md5(const std::string& bytes) {
    MD5_CTX state;
    MD5Init(&state);
    MD5Update(&state, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    std::array<std::uint8_t, MD5_DIGEST_LENGTH> digest{};
    MD5Final(digest.data(), &state);
    std::string out;
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    for (const unsigned byte : digest) {
        out += kDigits[byte >> 4U];
        out += kDigits[byte & 15U];
    }
    return out;
}

std::string text_of(const pugi::xml_document& document) {
    std::ostringstream out;
    document.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
    return out.str();
}

pugi::xml_document document_with(const char* root, pugi::xml_node& node) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    node = document.append_child(root);
    return document;
}

void append_value(pugi::xml_node parent, const char* tag, const char* key, const std::string& value) {
    pugi::xml_node node = parent.append_child(tag);
    node.append_attribute("key") = key;
    node.append_attribute("value") = value.c_str();
}

const char* word(bool yes) { return yes ? "true" : "false"; }

std::string content_types() {
    pugi::xml_node types;
    const auto document = document_with("Types", types);
    types.append_attribute("xmlns") = "http://schemas.openxmlformats.org/package/2006/content-types";
    for (const auto& [ending, type] : {std::pair{"rels", "application/vnd.openxmlformats-package.relationships+xml"},
                                       {"model", "application/vnd.ms-package.3dmanufacturing-3dmodel+xml"},
                                       {"png", "image/png"},
                                       {"gcode", "text/x.gcode"}}) {
        pugi::xml_node node = types.append_child("Default");
        node.append_attribute("Extension") = ending;
        node.append_attribute("ContentType") = type;
    }
    return text_of(document);
}

struct Relation {
    std::string target, type;
};

std::string relations(const std::vector<Relation>& list) {
    pugi::xml_node root;
    const auto document = document_with("Relationships", root);
    root.append_attribute("xmlns") = "http://schemas.openxmlformats.org/package/2006/relationships";
    for (std::size_t i = 0; i < list.size(); ++i) {
        pugi::xml_node node = root.append_child("Relationship");
        node.append_attribute("Target") = ("/" + list[i].target).c_str();
        node.append_attribute("Id") = ("rel-" + std::to_string(i + 1)).c_str();
        node.append_attribute("Type") = list[i].type.c_str();
    }
    return text_of(document);
}

std::string package_relations(const PrintFile& file) {
    std::vector<Relation> list{{"3D/3dmodel.model", "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"}};
    if (!file.picture.empty()) {
        list.push_back({kPicture, "http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"});
        list.push_back({kPicture, "http://schemas.bambulab.com/package/2021/cover-thumbnail-middle"});
    }
    if (!file.small_picture.empty())
        list.push_back({kSmallPicture, "http://schemas.bambulab.com/package/2021/cover-thumbnail-small"});
    return relations(list);
}

// The empty model of the package.
std::string model() {
    pugi::xml_node root;
    const auto document = document_with("model", root);
    root.append_attribute("unit") = "millimeter";
    root.append_attribute("xml:lang") = "en-US";
    root.append_attribute("xmlns") = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
    root.append_attribute("xmlns:BambuStudio") = "http://schemas.bambulab.com/package/2021";
    for (const auto& [name, value] :
         {std::pair<const char*, std::string>{"Application", std::string("BambuStudio-") + kFormatVersion},
          {"BambuStudio:3mfVersion", "1"},
          {"Description", "made by Filum"}}) {
        pugi::xml_node node = root.append_child("metadata");
        node.append_attribute("name") = name;
        node.text() = value.c_str();
    }
    root.append_child("resources");
    root.append_child("build");
    return text_of(document);
}

std::string model_settings(const PrintFile& file) {
    pugi::xml_node config;
    const auto document = document_with("config", config);
    pugi::xml_node plate = config.append_child("plate");
    append_value(plate, "metadata", "plater_id", "1");
    append_value(plate, "metadata", "plater_name", "");
    append_value(plate, "metadata", "locked", "false");
    append_value(plate, "metadata", "gcode_file", kProgram);
    if (!file.picture.empty()) append_value(plate, "metadata", "thumbnail_file", kPicture);
    append_value(plate, "metadata", "pattern_bbox_file", kBoxes);
    return text_of(document);
}

// The number of a part, from 1.  Software shows it, and uses it to make the printer skip a part.
std::size_t part_number(std::size_t index) { return index + 1; }

std::string slice_info(const PrintFile& file) {
    pugi::xml_node config;
    const auto document = document_with("config", config);
    pugi::xml_node header = config.append_child("header");
    append_value(header, "header_item", "X-BBL-Client-Type", "slicer");
    append_value(header, "header_item", "X-BBL-Client-Version", kFormatVersion);
    pugi::xml_node plate = config.append_child("plate");
    append_value(plate, "metadata", "index", "1");
    if (const std::string id = model_id(file.printer); !id.empty())
        append_value(plate, "metadata", "printer_model_id", id);
    if (file.nozzle > 0) append_value(plate, "metadata", "nozzle_diameters", fixed_text(file.nozzle, 2));
    append_value(plate, "metadata", "timelapse_type", "0");
    append_value(plate, "metadata", "prediction", std::to_string(std::llround(file.seconds)));
    double weight = 0;
    for (const FilamentUse& use : file.filaments) weight += use.weight;
    append_value(plate, "metadata", "weight", fixed_text(weight, 2));
    append_value(plate, "metadata", "outside", "false");
    append_value(plate, "metadata", "support_used", word(file.supports));
    append_value(plate, "metadata", "label_object_enabled", "false");
    for (std::size_t i = 0; i < file.parts.size(); ++i) {
        pugi::xml_node object = plate.append_child("object");
        object.append_attribute("identify_id") = std::to_string(part_number(i)).c_str();
        object.append_attribute("name") = file.parts[i].name.c_str();
        object.append_attribute("skipped") = "false";
    }
    for (const FilamentUse& use : file.filaments) {
        pugi::xml_node filament = plate.append_child("filament");
        filament.append_attribute("id") = use.tool + 1;
        filament.append_attribute("color") = "#FFFFFF";
        filament.append_attribute("used_m") = fixed_text(use.length, 2).c_str();
        filament.append_attribute("used_g") = fixed_text(use.weight, 2).c_str();
    }
    return text_of(document);
}

std::string json_box(const PlateBox& box) {
    std::string out = "[";
    for (std::size_t i = 0; i < box.size(); ++i) out += (i > 0 ? "," : "") + fixed_text(box[i], 3);
    return out + "]";
}

// The boxes of the parts, for the picture in which a user picks parts to skip.
std::string boxes(const PrintFile& file) {
    PlateBox all = file.parts.empty() ? PlateBox{} : file.parts.front().box;
    std::string objects;
    for (std::size_t i = 0; i < file.parts.size(); ++i) {
        const PlateBox& box = file.parts[i].box;
        for (const std::size_t k : {0U, 1U}) {
            all[k] = std::min(all[k], box[k]);
            all[k + 2] = std::max(all[k + 2], box[k + 2]);
        }
        objects += std::string(i > 0 ? "," : "") + R"({"area":)" +
                   fixed_text((box[2] - box[0]) * (box[3] - box[1]), 3) + R"(,"bbox":)" + json_box(box) + R"(,"id":)" +
                   std::to_string(part_number(i)) + R"(,"layer_height":)" + fixed_text(file.layer_height, 3) +
                   R"(,"name":)" + json_text(file.parts[i].name) + "}";
    }
    std::string colors, ids;
    for (std::size_t i = 0; i < file.filaments.size(); ++i) {
        colors += i > 0 ? R"(,"#FFFFFF")" : R"("#FFFFFF")";
        ids += (i > 0 ? "," : "") + std::to_string(file.filaments[i].tool);
    }
    const int first = file.filaments.empty() ? 0 : file.filaments.front().tool;
    return R"({"bbox_all":)" + json_box(all) + R"(,"bbox_objects":[)" + objects + R"(],"filament_colors":[)" + colors +
           R"(],"filament_ids":[)" + ids + R"(],"first_extruder":)" + std::to_string(first) +
           R"(,"is_seq_print":false)" + (file.nozzle > 0 ? R"(,"nozzle_diameter":)" + fixed_text(file.nozzle, 2) : "") +
           R"(,"version":2})";
}

} // namespace

std::string written(const PrintFile& file) {
    std::vector<std::pair<std::string, std::string>> entries{
        {"[Content_Types].xml", content_types()},
        {"_rels/.rels", package_relations(file)},
        {"3D/3dmodel.model", model()},
        {kProgram, file.gcode},
        {std::string(kProgram) + ".md5", md5(file.gcode)},
        {kBoxes, boxes(file)},
        {"Metadata/model_settings.config", model_settings(file)},
        {"Metadata/_rels/model_settings.config.rels",
         relations({{kProgram, "http://schemas.bambulab.com/package/2021/gcode"}})},
        {"Metadata/slice_info.config", slice_info(file)}};
    if (!file.picture.empty()) entries.emplace_back(kPicture, file.picture);
    if (!file.small_picture.empty()) entries.emplace_back(kSmallPicture, file.small_picture);
    return zipped(entries);
}

} // namespace filum::archive
