#include "app/filum/slicer_project.hpp"

#include "app/filum/slicer_text.hpp"
#include "archive/zip.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/project.hpp"
#include "mesh/project_heights.hpp"
#include "mesh/read.hpp"

#include <algorithm>
#include <cmath>

namespace filum::app::filum {

SlicerFile project_settings(const std::string& bytes, const std::string& file, int plate) {
    const std::string name = "'" + file + "'";
    archive::Zip zip(bytes, name);
    SlicerFile out;
    // SuperSlicer writes its settings, and beside them what PrusaSlicer would understand.
    constexpr const char *kSuper = "Metadata/SuperSlicer.config", *kPrusa = "Metadata/Slic3r_PE.config";
    if (const char* path = zip.has(kSuper) ? kSuper : kPrusa; zip.has(path)) {
        const std::string text = zip.read(path);
        out.settings = all_settings(text, Lines::commented);
        out.slicer = path == kSuper ? Slicer::super : writer_of(text, out.settings);
    } else if (const char* path = "Metadata/project_settings.config"; zip.has(path)) {
        const std::string text = zip.read(path);
        out.settings = json_settings(text);
        out.slicer = writer_of(text, out.settings);
    }
    if (out.settings.empty()) return out;
    for (const auto& [key, value] : mesh::read_project(zip, name, plate).shared)
        put_setting(out.settings, {key, value});
    return out;
}

ProjectBodies project_bodies(const std::string& file, int plate) {
    ProjectBodies out;
    try {
        const mesh::Bytes bytes = mesh::load(file);
        if (!archive::Zip::begins(bytes.view())) return out;
        using Purpose = mesh::Body::Purpose;
        for (const mesh::Body& b : mesh::read(bytes.view(), mesh::spoken_name(file), plate).bodies) {
            out.modifiers = out.modifiers || mesh::changes_settings(b);
            out.wanted = out.wanted || b.what == Purpose::painted || mesh::wants_supports(b, true);
            out.seams = out.seams || b.what == Purpose::painted_seam || b.what == Purpose::painted_no_seam;
            out.unwanted = out.unwanted || b.what == Purpose::painted_blocker || mesh::wants_supports(b, false);
        }
    } catch (const Error&) { // the file holds settings only
    }
    return out;
}

ProjectCodes project_codes(const std::string& file, int plate, double layer_height) {
    ProjectCodes out;
    try {
        const mesh::Bytes bytes = mesh::load(file);
        if (!archive::Zip::begins(bytes.view())) return out;
        archive::Zip zip(bytes.view(), "'" + file + "'");
        for (const mesh::HeightCode& code : mesh::codes_by_height(zip, plate)) {
            using Kind = mesh::HeightCode::Kind;
            const std::string at = shortest_text(code.z) + " mm";
            const double below = std::round((code.z - layer_height) * 1e6) / 1e6;
            if (code.what == Kind::tool)
                out.remarks.push_back("the project's change of tools at " + at +
                                      " is not followed; add a part with --body");
            else if (code.what == Kind::custom)
                out.remarks.push_back("the project's G-code at " + at + " is not followed: " + code.code.substr(0, 60));
            else if (below > 0)
                out.pauses += (out.pauses.empty() ? "" : ",") + shortest_text(below) +
                              (code.what == Kind::colour ? "mm:colour" : "mm");
        }
    } catch (const Error&) { // a damaged file is reported where the part is read
    }
    return out;
}

} // namespace filum::app::filum
