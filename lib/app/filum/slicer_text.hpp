// The forms in which slicers write settings: lines "name = value", in sections or not, and JSON objects.
#pragma once

#include "app/filum/slicer_file.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// How lines with settings look: "name = value", behind a semicolon in comments.
enum class Lines : std::uint8_t { plain, commented };

// The settings below one heading "[kind:name]"; those before the first heading have none.
struct Section {
    std::string heading;
    std::vector<SlicerSetting> settings;
};

// Without spaces, tabs and carriage returns at both ends.
std::string trimmed(const std::string& text);

// Without spaces, tabs and quotes at both ends.
std::string unquoted(const std::string& text);

// The sections of a text in its order; at least one. A heading that occurs twice is two sections.
std::vector<Section> sections(const std::string& text, Lines kind);

// The settings of all sections, one after the other.
std::vector<SlicerSetting> all_settings(const std::string& text, Lines kind);

// The settings of a JSON object by key, a list's items with commas between them; none if it is no JSON object.
std::vector<SlicerSetting> json_settings(const std::string& text);

// Whether a text begins as a JSON object does.
bool is_json(const std::string& text);

// The whole content of a file.  Throws Error(io).
std::string content_of(const std::string& file);

} // namespace filum::app::filum
