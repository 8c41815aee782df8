#include "mesh/threemf_rules.hpp"

#include "base/length_unit.hpp"
#include "mesh/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <pugixml.hpp>
#include <sstream>
#include <utility>

namespace filum::mesh::threemf {

namespace {

constexpr std::string_view kXmlns = "xmlns:";
constexpr std::string_view kConsortium = "/3dmanufacturing/"; // part of the namespaces of its extensions

// Extensions that change no shape, or that this reader follows; "slice" if the triangles give the shape too.
constexpr std::string_view kSupported[] = {"core", "material", "materials", "production", "slice", "trianglesets"};
constexpr std::string_view kSlicers[] = {"http://schemas.slic3r.org/3mf/", "http://schemas.bambulab.com/package/",
                                         "http://schemas.prusa3d.com/"};

// Elements of objects and meshes that are defined by the core or by extensions that change no shape.
constexpr std::string_view kPlain[] = {"mesh",      "components",   "metadatagroup", "vertices",
                                       "triangles", "trianglesets", "metadata",      "property"};

// "beamlattice" for ".../3dmanufacturing/beamlattice/2017/02"; the namespace itself if it is not the consortium's.
std::string extension_name(const std::string& uri) {
    const auto at = uri.find(kConsortium);
    if (at == std::string::npos) return uri;
    const auto from = at + kConsortium.size();
    return uri.substr(from, uri.find('/', from) - from);
}

bool supported(const std::string& uri, const std::string& name) {
    if (std::ranges::find(kSupported, name) != std::end(kSupported))
        return uri.find("/alternatives/") == std::string::npos; // production alternatives choose another object
    return std::ranges::any_of(kSlicers, [&](std::string_view start) { return uri.starts_with(start); });
}

std::string foreign_child(const pugi::xml_node& node) {
    for (const auto& c : node.children()) {
        if (c.type() != pugi::node_element) continue;
        const std::string_view name = local_name(c);
        if (std::ranges::find(kPlain, name) == std::end(kPlain)) return std::string(name);
    }
    return "";
}

} // namespace

std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name(node.name());
    return name.substr(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1);
}

std::string part_path(const pugi::xml_node& node) {
    for (const auto& a : node.attributes())
        if (std::string_view(a.name()).ends_with(":path")) return a.value();
    return "";
}

std::array<double, 12> numbers(const geom::Affine& place) {
    std::array<double, 12> out{};
    for (std::size_t i = 0; i < 12; ++i) out[i] = i < 9 ? place.a[i / 3][i % 3] : place.t[i - 9];
    return out;
}

bool has_another(const pugi::xml_node& node) {
    for (auto n = node.next_sibling(); n; n = n.next_sibling())
        if (n.type() == pugi::node_element) return true;
    return false;
}

std::optional<double> unit_mm(std::string_view name) {
    constexpr std::array<std::string_view, 6> kUnits{"micron", "millimeter", "centimeter", "inch", "foot", "meter"};
    if (name.empty()) return 1;
    if (std::ranges::find(kUnits, name) != kUnits.end()) return length_of_word(name);
    return std::nullopt;
}

std::optional<geom::Affine> transform(const char* text) {
    geom::Affine out;
    Text numbers(text);
    for (int i = 0; i < 12; ++i) {
        double& to = i < 9 ? out.a[i / 3][i % 3] : out.t[i - 9];
        if (!numbers.more() || !numbers.number(to) || !std::isfinite(to)) return std::nullopt;
    }
    if (numbers.more()) return std::nullopt;
    return out;
}

std::string unsupported_extension(const pugi::xml_node& model) {
    std::istringstream required(model.attribute("requiredextensions").value());
    for (std::string prefix; required >> prefix;) {
        const std::string uri = model.attribute((std::string(kXmlns) + prefix).c_str()).value();
        if (uri.empty()) return prefix;
        std::string name = extension_name(uri);
        if (!supported(uri, name)) return name;
    }
    return "";
}

Function function_of(const pugi::xml_node& object) {
    constexpr std::pair<std::string_view, Function> kFunctions[] = {
        {"", Function::part},           {"model", Function::part},      {"solidsupport", Function::support},
        {"support", Function::support}, {"surface", Function::surface}, {"other", Function::other}};
    const std::string_view type(object.attribute("type").value());
    for (const auto& [word, function] : kFunctions)
        if (type == word) return function;
    return Function::unknown;
}

std::string foreign_shape(const pugi::xml_node& object) {
    if (std::string own = foreign_child(object); !own.empty()) return own;
    for (const auto& c : object.children())
        if (local_name(c) == "mesh")
            if (std::string inner = foreign_child(c); !inner.empty()) return inner;
    return "";
}

bool is_low_resolution(const pugi::xml_node& object) {
    return std::ranges::any_of(object.attributes(), [](const pugi::xml_attribute& a) {
        const std::string_view name(a.name());
        return (name == "meshresolution" || name.ends_with(":meshresolution")) &&
               std::string_view(a.value()) == "lowres";
    });
}

} // namespace filum::mesh::threemf
