#include "preset/settings.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <utility>

namespace filum::preset {

namespace {

using macro::Value;
using macro::Variable;

std::string_view trimmed(std::string_view text) {
    const auto from = text.find_first_not_of(" \t\r\n");
    if (from == std::string_view::npos) return {};
    return text.substr(from, text.find_last_not_of(" \t\r\n") - from + 1);
}

// The number at the beginning of a text, as a C++ stream reads it.
std::optional<double> number_in(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double out = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    return error == std::errc() ? std::optional(out) : std::nullopt;
}

// Replaces \n, \r and \\ by their characters.
std::string unescaped(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (c == '\\' && i + 1 < text.size()) {
            c = text[++i];
            if (c == 'n') c = '\n';
            if (c == 'r') c = '\r';
        }
        out += c;
    }
    return out;
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '\n' || c == '\r' || c == '\\') out += '\\';
        out += c == '\n' ? 'n' : c == '\r' ? 'r' : c;
    }
    return out;
}

// Splits "one";two;"three": texts separated by semicolons, in quotes if they contain one.
std::vector<std::string> quoted_items(std::string_view text) {
    std::vector<std::string> out;
    text = trimmed(text);
    while (!text.empty()) {
        std::size_t end = 0;
        std::string_view item;
        if (text[0] == '"') {
            for (end = 1; end < text.size() && text[end] != '"'; ++end)
                if (text[end] == '\\') ++end;
            end = std::min(end, text.size());
            item = text.substr(1, end - 1);
            end = std::min(text.find(';', end), text.size());
        } else {
            end = std::min(text.find(';'), text.size());
            item = trimmed(text.substr(0, end));
        }
        out.push_back(unescaped(item));
        if (end == text.size()) break;
        text = trimmed(text.substr(end + 1));
        if (text.empty()) out.emplace_back();
    }
    return out;
}

std::vector<std::string> comma_items(std::string_view text) {
    std::vector<std::string> out;
    for (text = trimmed(text); !text.empty();) {
        const auto end = std::min(text.find(','), text.size());
        out.emplace_back(trimmed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

// Guesses the type of a setting without a type in settings.tsv from its values.
Key looks_like(std::string_view name, const std::vector<std::string>& values) {
    Key out;
    out.name = name;
    out.list = values.size() != 1;
    const auto all = [&](const char* characters) {
        return !values.empty() && std::ranges::all_of(values, [&](const std::string& v) {
            return number_in(v) && v.find_first_not_of(characters) == std::string::npos;
        });
    };
    if (all("0123456789-+"))
        out.type = Type::whole;
    else if (all("0123456789-+.eE"))
        out.type = Type::number;
    else if (all("0123456789-+.eE%"))
        out.type = Type::percent;
    return out;
}

// Converts a text to a value of a type, and to the text that [name] writes.
std::pair<Value, std::string> typed(Type type, const std::string& text, bool list) {
    if (text == "nil" && type != Type::text) return {Value{}, "nil"};
    const double number = number_in(text).value_or(0);
    switch (type) {
    case Type::flag: {
        const bool on = text == "1" || text == "true";
        return {Value{on}, on ? "1" : "0"};
    }
    case Type::whole: {
        constexpr double most = 9e15;
        const auto whole = static_cast<std::int64_t>(std::clamp(number, -most, most));
        return {Value{whole}, std::to_string(whole)};
    }
    case Type::number:
        return {Value{number}, macro::text_of(Value{number})};
    case Type::percent:
        return {Value{number}, macro::text_of(Value{number}) + "%"};
    case Type::share:
        return {Value{number}, macro::text_of(Value{number}) + (text.ends_with('%') ? "%" : "")};
    case Type::text:
        return {Value{text}, list ? text : escaped(text)};
    case Type::word:
    case Type::point:
        break;
    }
    return {Value{text}, text};
}

Variable variable(const Key& key, const std::vector<std::string>& values) {
    Variable out;
    out.list = key.list;
    for (const std::string& v : values) {
        auto [value, written] = typed(key.type, v, key.list);
        out.items.push_back(std::move(value));
        out.written.push_back(std::move(written));
        if (!key.list) break;
    }
    if (out.items.empty() && !out.list) {
        auto [value, written] = typed(key.type, "", false);
        out.items.push_back(std::move(value));
        out.written.push_back(std::move(written));
    }
    return out;
}

} // namespace

std::vector<std::string> values_of_line(std::string_view name, std::string_view value) {
    const Key* key = key_of(name);
    const bool code = name.ends_with("gcode") || name.ends_with("notes");
    if (key == nullptr && !code) {
        auto items = comma_items(value);
        if (looks_like(name, items).type != Type::text) return items;
    }
    const bool list = key != nullptr && key->list;
    if (list && key->type == Type::text) return quoted_items(value);
    if (list) return comma_items(value);
    if (key == nullptr || key->type == Type::text) return {unescaped(value)};
    return {std::string(trimmed(value))};
}

std::vector<std::string> values_of_json(std::string_view name, std::string_view value) {
    const Key* key = key_of(name);
    const bool code = name.ends_with("gcode") || name.ends_with("notes");
    const bool quoted = value.starts_with('"') && value.ends_with('"'); // several texts; see wire/json.hpp
    if (quoted && (code || (key != nullptr && key->list))) return quoted_items(value);
    if (code || (key != nullptr && !key->list)) return {std::string(value)};
    if (key != nullptr) return comma_items(value);
    const auto items = comma_items(value);
    return looks_like(name, items).type != Type::text ? items : std::vector{std::string(value)};
}

std::vector<geom::Vec2> corners(const std::vector<std::string>& texts) {
    std::vector<geom::Vec2> out;
    for (const std::string& text : texts) {
        // OrcaSlicer writes single points as "0,20".  The text is split first: a stream would read "0x20" as one
        // number.
        const auto between = text.find_first_of("x,", 1);
        const auto x = number_in(text.substr(0, between));
        const auto y = between == std::string::npos ? std::nullopt : number_in(text.substr(between + 1));
        if (!x || !y)
            throw Error(Exit::bad_input, "cannot use the shape of the bed: '" + text + "' is no corner, as 0x200");
        out.push_back({*x, *y});
    }
    return out;
}

// Whether a list of a preset of Bambu Studio can stand without an index, as in {nozzle_diameter == 0.2}: a list of
// numbers is then the value of the current tool's extruder. Lists whose values differ need an index here, since Bambu
// Studio and OrcaSlicer do not agree on that extruder.
static bool one_number(const Key& key, const Variable& list) {
    const bool numbers = key.type == Type::number || key.type == Type::share;
    return numbers && list.list && std::ranges::count(list.items, list.items.front()) == std::ssize(list.items);
}

Settings::Settings(const Preset& preset) {
    const bool orca = preset.slicer == "orca" || preset.slicer == "bambu";
    for (const Key& key : keys()) {
        const std::string_view usual = orca && !key.orca.empty() ? key.orca : key.usual;
        if (!usual.empty()) variables_[std::string(key.name)] = variable(key, values_of_line(key.name, usual));
    }
    for (const Key& key : keys()) // texts without a default are empty
        if (key.usual.empty() && key.type == Type::text && !preset.settings.contains(key.name))
            variables_[std::string(key.name)] = variable(key, {""});
    for (const auto& [name, values] : preset.settings) {
        const Key* key = key_of(name);
        Variable& made = variables_[name];
        made = variable(key != nullptr ? *key : looks_like(name, values), values);
        made.either = key == nullptr || (orca && one_number(*key, made));
    }
    resolve_shares();
    // A filament may override settings of the printer: filament_NAME replaces NAME.
    std::vector<std::pair<std::string, Variable>> own;
    for (const auto& [name, theirs] : variables_) {
        const auto printer = name.starts_with("filament_") ? variables_.find(name.substr(9)) : variables_.end();
        if (printer == variables_.end() || !printer->second.list || !theirs.list) continue;
        Variable merged = printer->second;
        for (std::size_t i = 0; i < theirs.items.size(); ++i) {
            if (std::holds_alternative<std::monostate>(theirs.items[i]) || merged.items.empty()) continue;
            while (merged.items.size() <= i) {
                merged.items.push_back(merged.items.front());
                merged.written.push_back(merged.written.front());
            }
            merged.items[i] = theirs.items[i];
            merged.written[i] = theirs.written[i];
        }
        own.emplace_back(printer->first, std::move(merged));
    }
    for (auto& [name, merged] : own) variables_[name] = std::move(merged);
}

// Converts percentages to absolute values.  [name] still writes the percentage.
void Settings::resolve_shares() {
    constexpr int deepest = 8;
    const double nozzle = number("nozzle_diameter", 0, 0.4);
    for (const Key& key : keys()) {
        const auto found = variables_.find(key.name);
        if (key.type != Type::share || key.list || found == variables_.end()) continue;
        if (key.name.ends_with("extrusion_width")) continue;
        double share = 1;
        const Key* of = &key;
        for (int depth = 0; depth < deepest; ++depth) {
            const auto at = variables_.find(of->name);
            if (at == variables_.end() || at->second.written.empty() || !at->second.written[0].ends_with('%')) {
                const double base =
                    of->name.ends_with("extrusion_width") ? width(std::string(of->name), nozzle) : number(of->name);
                found->second.items[0] = share * base;
                break;
            }
            share *= number_in(at->second.written[0]).value_or(0) / 100;
            of = key_of(of->of);
            if (of == nullptr) break; // the table does not say what it is a percentage of
        }
    }
    for (const Key& key : keys())
        if (key.name.ends_with("extrusion_width") && variables_.contains(key.name))
            variables_[std::string(key.name)].items[0] = width(std::string(key.name), nozzle);
}

// A width in mm.  0 means the common width; a common width of 0 depends on the nozzle.
double Settings::width(const std::string& name, double nozzle) const {
    const auto found = variables_.find(name);
    if (found == variables_.end() || found->second.written.empty()) return nozzle;
    const std::string& written = found->second.written[0];
    const double value = number_in(written).value_or(0);
    if (written.ends_with('%'))
        return value / 100 * number(name.starts_with("first_layer") ? "first_layer_height" : "layer_height");
    if (value > 0) return value;
    if (name != "extrusion_width") return width("extrusion_width", nozzle);
    constexpr double usual = 1.125; // of the nozzle's diameter, as slicers choose
    return usual * nozzle;
}

const Variable* Settings::find(std::string_view name) const {
    const auto found = variables_.find(name);
    return found == variables_.end() ? nullptr : &found->second;
}

const Value* Settings::value(std::string_view name, std::size_t extruder) const {
    const Variable* found = find(name);
    if (found == nullptr || found->items.empty()) return nullptr;
    return &found->items[extruder < found->items.size() ? extruder : 0];
}

std::string Settings::text(std::string_view name, std::size_t extruder) const {
    const Value* found = value(name, extruder);
    return found == nullptr ? "" : macro::text_of(*found);
}

double Settings::number(std::string_view name, std::size_t extruder, double otherwise) const {
    const Value* found = value(name, extruder);
    if (found == nullptr) return otherwise;
    if (const auto* whole = std::get_if<std::int64_t>(found)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(found)) return *number;
    if (const auto* flag = std::get_if<bool>(found)) return *flag ? 1 : 0;
    return otherwise;
}

bool Settings::flag(std::string_view name, std::size_t extruder) const { return number(name, extruder) != 0; }

std::vector<std::string> Settings::texts(std::string_view name) const {
    std::vector<std::string> out;
    if (const Variable* found = find(name))
        for (const Value& v : found->items) out.push_back(macro::text_of(v));
    return out;
}

} // namespace filum::preset
