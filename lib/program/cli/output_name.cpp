#include "cli/output_name.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cctype>

namespace filum::cli {

namespace {

struct Format {
    std::string_view endings; // each with a blank before and after it
    std::string_view name;    // the kind of these files
    std::string_view use;     // what to do instead
};

constexpr std::string_view kPictures =
    "draw the toolpath: filum print --picture x.png, or render -o x.png (or .svg, .pdf)";
constexpr std::string_view kPrograms = "machine code comes from 'filum print' or 'postproc'";

// Formats by their endings; the first match counts.
constexpr Format kFormats[] = {
    {" .gcode.3mf .bgcode .gcode .gco .g .nc .ngc .tap .cnc .src .mod .script .urp ", "machine code", kPrograms},
    {" .gx .x3g .makerbot .ufp .s3g ", "a printer's own program format", "write x.gcode"},
    {" .png .svg .pdf ", "a picture", kPictures},
    {" .jpg .jpeg .gif .webp .bmp .tif .tiff .eps .ps ", "a picture or document", kPictures},
    {" .html .htm ", "a page", "filum print --report x.html makes one, and so does render -o x.html"},
    {" .vtp .vtu .vtk ", "a data file of VTK", "render -o x.vtp writes one"},
    {" .stl .obj .ply .off .3mf .amf .step .stp .iges .igs .gltf .glb .dxf ", "a model", "Filum writes no models"},
    {" .layers .regions .paths .toolpath .surface ", "a stream of Filum", "the stages write streams: see filum list"},
    {" .doc .docx .odt .xls .xlsx .ods .zip .gz .xz .7z ", "a document or archive", "choose another ending"}};

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

// The ending of a file's name in lower case, from the last dot on, or ".gcode.3mf". "" without an ending.
std::string ending_of(const std::string& name) {
    const std::string file = lower(name.substr(name.find_last_of('/') + 1));
    if (file.ends_with(".gcode.3mf")) return ".gcode.3mf";
    const auto dot = file.rfind('.');
    return dot == std::string::npos || dot == 0 ? "" : file.substr(dot);
}

bool writes(const std::string& what, const Format& format, const std::string& ending) {
    const std::string text = lower(what);
    if (format.name == "machine code" && text.find("machine code") != std::string::npos) return true;
    if (format.name == "a stream of Filum" && text.find("stream") != std::string::npos) return true;
    return text.find(ending.substr(1)) != std::string::npos;
}

} // namespace

void check_output_name(const std::string& name, std::string_view program, const std::string& what) {
    const std::string ending = ending_of(name);
    if (ending.empty()) return;
    const auto* format = std::ranges::find_if(
        kFormats, [&](const Format& f) { return f.endings.find(" " + ending + " ") != std::string_view::npos; });
    if (format == std::end(kFormats) || writes(what, *format, ending)) return;
    std::string message = "cannot write '" + name + "': '";
    message.append(ending).append("' stands for ").append(format->name).append(", and ").append(program);
    message.append(" writes ").append(what).append("; ").append(format->use);
    throw Error(Exit::usage, message);
}

} // namespace filum::cli
