#include "app/filum/slicer_text.hpp"

#include "archive/zip.hpp"
#include "base/error.hpp"
#include "base/padding.hpp"
#include "base/utf8.hpp"
#include "wire/json.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace filum::app::filum {

namespace {

bool is_key(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
        return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_' || std::isupper(c) != 0;
    });
}

// Text in UTF-16 as UTF-8. `low` is the index of the low byte of a pair of bytes.
std::string from_utf16(std::string_view text, std::size_t low) {
    std::string out;
    std::uint32_t high = 0; // half of a character that takes two pairs of bytes
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
        const auto byte = [&](std::size_t k) { return std::uint32_t{static_cast<unsigned char>(text[i + k])}; };
        const std::uint32_t unit = byte(low) | byte(1 - low) << 8;
        if (unit >= 0xd800 && unit < 0xdc00) {
            high = unit;
            continue;
        }
        append_utf8(unit >= 0xdc00 && unit < 0xe000 ? 0x10000 + ((high & 0x3ff) << 10) + (unit & 0x3ff) : unit, out);
    }
    return out;
}

// The text without byte order mark, in UTF-8, with line feeds as line ends.
std::string plain_text(std::string text) {
    if (text.starts_with("\xff\xfe"))
        text = from_utf16(std::string_view(text).substr(2), 0);
    else if (text.starts_with("\xfe\xff"))
        text = from_utf16(std::string_view(text).substr(2), 1);
    else if (text.starts_with("\xef\xbb\xbf"))
        text.erase(0, 3);
    text.resize(without_padding(text).size());
    if (text.find('\r') == std::string::npos) return text;
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\r')
            out += text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            out += '\n';
    return out;
}

} // namespace

std::string trimmed(const std::string& text) {
    const auto from = text.find_first_not_of(" \t\r");
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

std::string unquoted(const std::string& text) {
    const auto from = text.find_first_not_of(" \t\"");
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t\"") - from + 1);
}

std::optional<double> plain_number(std::string_view text) {
    double out = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    const bool whole = error == std::errc() && end == text.data() + text.size() && std::isfinite(out);
    return whole ? std::optional(out) : std::nullopt;
}

std::vector<Section> sections(const std::string& text, Lines kind) {
    std::vector<Section> out(1);
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const bool indented = line.starts_with(' ') || line.starts_with('\t');
        line = trimmed(line);
        if (kind == Lines::continued && indented && !line.empty()) {
            if (!out.back().settings.empty()) out.back().settings.back().value.append("\n").append(line);
            continue;
        }
        const bool comment = line.starts_with(';');
        if (comment != (kind == Lines::commented)) continue;
        if (comment) line = trimmed(line.substr(1));
        if (!comment && line.starts_with('[') && line.ends_with(']')) {
            out.push_back({line.substr(1, line.size() - 2), {}});
            continue;
        }
        const auto equal = line.find('=');
        const std::string key = trimmed(line.substr(0, equal));
        if (equal != std::string::npos && is_key(key))
            out.back().settings.push_back({key, trimmed(line.substr(equal + 1))});
    }
    return out;
}

std::vector<SlicerSetting> all_settings(const std::string& text, Lines kind) {
    std::vector<SlicerSetting> out;
    for (Section& section : sections(text, kind)) std::ranges::move(section.settings, std::back_inserter(out));
    return out;
}

std::vector<SlicerSetting> json_settings(const std::string& text) {
    std::vector<SlicerSetting> out;
    for (const auto& [key, value] : wire::json_values(text)) {
        if (key.empty())
            throw Error(Exit::bad_input, "a setting of the JSON file has no name; write one before its ':'");
        out.push_back({key, value});
    }
    return out;
}

bool is_json(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return first != std::string::npos && text[first] == '{';
}

std::string content_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text;
    if (in) text.assign(std::istreambuf_iterator<char>(in), {});
    if (!in || in.bad()) throw Error(Exit::io, "cannot read '" + file + "': " + std::strerror(errno));
    if (archive::Zip::begins(text) || text.starts_with("GCDE")) return text;
    return plain_text(std::move(text));
}

} // namespace filum::app::filum
