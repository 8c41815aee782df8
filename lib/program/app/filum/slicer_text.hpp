// Parses the texts in which slicers write settings: lines "name = value", with or without sections, and JSON objects.
#pragma once

#include "app/filum/slicer_file.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::app::filum {

// The form of lines with settings.  plain: "name = value"; commented: "; name = value"; continued: as plain, and a line
// that begins with a blank belongs to the value above it, as in files of Python's configparser.
enum class Lines : std::uint8_t { plain, commented, continued };

// The settings below one heading "[kind:name]".  Settings before the first heading form a section with an empty
// heading.
struct Section {
    std::string heading;
    std::vector<SlicerSetting> settings;
};

// The text without spaces, tabs and carriage returns at both ends.
std::string trimmed(const std::string& text);

// The text without spaces, tabs and quotes at both ends.
std::string unquoted(const std::string& text);

// The number that the whole text is, such as "0.2"; none if it is no finite number.
std::optional<double> plain_number(std::string_view text);

// The sections of a text in its order; at least one.  A heading that occurs twice gives two sections.
std::vector<Section> sections(const std::string& text, Lines kind);

// The settings of all sections, one after the other.
std::vector<SlicerSetting> all_settings(const std::string& text, Lines kind);

// The settings of a JSON object, sorted by key.  The items of a list have commas between them.  The result is empty if
// the text is no JSON object.  Throws Error(bad_input) if a name is empty.
std::vector<SlicerSetting> json_settings(const std::string& text);

// Whether a text begins as a JSON object does.
bool is_json(const std::string& text);

// The whole content of a file; of text in UTF-8 or UTF-16, with or without a byte order mark and with line ends of any
// kind, as UTF-8 with line feeds.  Throws Error(io).
std::string content_of(const std::string& file);

} // namespace filum::app::filum
