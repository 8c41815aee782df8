#include "machine/reader.hpp"

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/number.hpp"
#include "machine/template.hpp"
#include "machine/toml_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

// In a release build toml++ 3.3 lets the compiler assume that its assertions hold, but texts such as "x = [1,}" break
// them.  So its assertions are kept, and throw exceptions.
namespace filum::machine {
[[noreturn]] static void toml_assertion() { throw std::logic_error("malformed"); }
} // namespace filum::machine
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) ((expression) ? static_cast<void>(0) : filum::machine::toml_assertion())
#include <toml++/impl/forward_declarations.h>
// The functions of toml++ that classify letters reach code that is marked unreachable.  There they return false.
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE                                                                                               \
    return {}
#include <toml++/impl/unicode.h>
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE __builtin_unreachable()
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace filum::machine {

struct Document::State {
    std::string kind, file;
    std::string within;                            // "tool.1.": the prefix of every key that is read
    toml::node* asked_for(const std::string& key); // finds prefix + key, and marks it as read
    toml::table root;
    std::set<std::string> asked; // dotted keys that were read
    std::set<std::string> set;   // keys that came from `set`
    std::vector<bool> opens;     // by line: a text of several lines opens at its end, and begins below it
    std::string texts;           // all texts that were read, which may hold names in braces
    std::set<std::string> named; // sections whose keys are such names, see numbers()
};

namespace {

std::string printable(std::string_view text) {
    std::string out(text.substr(0, 60));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    return out;
}

toml::node* find(toml::table& root, std::string_view key) {
    toml::table* table = &root;
    for (;;) {
        const auto dot = key.find('.');
        if (dot == std::string_view::npos) return table->get(key);
        table = table->get_as<toml::table>(key.substr(0, dot));
        if (table == nullptr) return nullptr;
        key.remove_prefix(dot + 1);
    }
}

} // namespace

toml::node* Document::State::asked_for(const std::string& key) {
    asked.insert(within + key);
    return find(root, within + key);
}

namespace {

// The value after '=' in `set`: a number, true or false, or else an unchanged text.
void assign(toml::table& to, const std::string& key, const std::string& value) {
    if (value == "true" || value == "false") {
        to.insert_or_assign(key, value == "true");
        return;
    }
    try {
        const double v = parse_number(value, key);
        if (v == std::floor(v) && std::abs(v) < 1e15)
            to.insert_or_assign(key, static_cast<std::int64_t>(v));
        else
            to.insert_or_assign(key, v);
    } catch (const Error&) {
        to.insert_or_assign(key, value);
    }
}

[[noreturn]] void misused(const std::string& item, const std::string& why) {
    throw Error(Exit::usage, "cannot set '" + printable(item) + "': " + why);
}

} // namespace

Document::Document(std::string_view text, const std::string& file, const std::string& set, const std::string& kind)
    : state_(std::make_unique<State>()) {
    state_->kind = kind;
    state_->file = file;
    const TomlText known = examine(text);
    if (!known.fault.empty())
        throw Error(Exit::bad_input,
                    "cannot read " + kind + " '" + file + "', line " + std::to_string(known.line) + ": " + known.fault);
    state_->opens = known.opens;
    try {
        state_->root = toml::parse(text, file);
    } catch (const toml::parse_error& e) {
        throw Error(Exit::bad_input, "cannot read " + kind + " '" + file + "', line " +
                                         std::to_string(e.source().begin.line) + ": " + printable(e.description()));
    } catch (const std::logic_error&) {
        throw Error(Exit::bad_input, "cannot read " + kind + " '" + file + "': it is no TOML");
    }
    for (std::size_t at = 0; at < set.size();) {
        const std::size_t comma = std::min(set.find(',', at), set.size());
        const std::string item = set.substr(at, comma - at);
        at = comma + 1;
        const auto equals = item.find('=');
        if (equals == std::string::npos || equals == 0) misused(item, "it is not KEY=VALUE");
        std::string key = item.substr(0, equals);
        if (key.find('.') == std::string::npos) key = "values." + key;
        toml::table* table = &state_->root;
        std::string name = key;
        for (auto dot = name.find('.'); dot != std::string::npos; dot = name.find('.')) {
            const std::string section = name.substr(0, dot);
            name.erase(0, dot + 1);
            if (section.empty() || name.empty()) misused(item, "it is no key");
            if (table->get(section) == nullptr) table->insert(section, toml::table{});
            table = table->get_as<toml::table>(section);
            if (table == nullptr) misused(item, "'" + section + "' has no keys");
        }
        assign(*table, name, item.substr(equals + 1));
        state_->set.insert(key);
    }
}

Document::~Document() = default;

void Document::enter(const std::string& section) { state_->within = section + "."; }
void Document::leave() { state_->within.clear(); }

void Document::fail(const std::string& key, const std::string& why) const { fail_in_text(key, why, 0); }

void Document::fail_in_text(const std::string& name, const std::string& why, std::size_t line) const {
    const std::string key = state_->within + name;
    if (state_->set.count(key) != 0) misused(key, why);
    const toml::node* node = find(state_->root, key);
    std::string where = "'" + state_->file + "'";
    if (node != nullptr && node->source().begin.line > 0) {
        const std::size_t first = node->source().begin.line;
        const bool below = node->is_string() && first <= state_->opens.size() && state_->opens[first - 1];
        where += ", line " + std::to_string(first + line + (below ? 1 : 0));
    }
    throw Error(Exit::bad_input, "cannot use " + state_->kind + " " + where + ", key '" + printable(key) + "': " + why);
}

bool Document::has(const std::string& key) const { return find(state_->root, state_->within + key) != nullptr; }

void Document::require(const std::string& key) const {
    if (state_->within.empty() && find(state_->root, key) == nullptr) fail(key, "it is missing");
}

namespace {

// Reads the number in `node`; returns its fault, or "" if there is none.
std::string number_in(const toml::node& node, const Document::Range& range, double& out) {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) return "it must be a number";
    const double v = *value;
    if (!(v >= range.min && v <= range.max) || (range.open && v == range.min)) { // nan fails, too
        std::string why = "it must be " + std::string(range.open ? "above " : "at least ") + shortest_text(range.min);
        if (std::isfinite(range.max)) why += " and at most " + shortest_text(range.max);
        return why;
    }
    out = v;
    return "";
}

} // namespace

void Document::number(const std::string& key, double& out, Range range) {
    const auto* node = state_->asked_for(key);
    if (node == nullptr) return;
    if (const auto why = number_in(*node, range, out); !why.empty()) fail(key, why);
}

void Document::whole(const std::string& key, int& out, int min, int max) {
    const auto* node = state_->asked_for(key);
    if (node == nullptr) return;
    const auto* value = node->as_integer();
    if (value == nullptr || value->get() < min || value->get() > max)
        fail(key, "it must be a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    out = static_cast<int>(value->get());
}

void Document::flag(const std::string& key, bool& out) {
    const auto* node = state_->asked_for(key);
    if (node == nullptr) return;
    if (!node->is_boolean()) fail(key, "it must be true or false");
    out = node->as_boolean()->get();
}

void Document::text(const std::string& key, std::string& out) {
    const auto* node = state_->asked_for(key);
    if (node == nullptr) return;
    if (!node->is_string()) fail(key, "it must be a text in quotes");
    out = node->as_string()->get();
    for (const char c : out)
        if ((static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f)
            fail(key, "it holds a control character");
    state_->texts += out;
}

void Document::choice(const std::string& key, std::string& out, const std::vector<std::string>& choices) {
    text(key, out);
    if (std::find(choices.begin(), choices.end(), out) != choices.end()) return;
    std::string all;
    for (const auto& c : choices) all += (all.empty() ? "" : ", ") + c;
    fail(key, "it must be one of " + all);
}

void Document::pair(const std::string& key, double& a, double& b, Range range) {
    std::array<double, 2> both{a, b};
    if (!list(key, both, range)) return;
    a = both[0];
    b = both[1];
}

bool Document::list(const std::string& key, std::span<double> out, Range range) {
    const auto* node = state_->asked_for(key);
    if (node == nullptr) return false;
    const auto* array = node->as_array();
    if (array == nullptr || array->size() != out.size())
        fail(key, "it must be " + (out.size() == 2 ? "two" : std::to_string(out.size())) + " numbers in brackets");
    for (std::size_t k = 0; k < out.size(); ++k)
        if (const auto why = number_in(*array->get(k), range, out[k]); !why.empty()) fail(key, why);
    return true;
}

std::vector<std::string> Document::tables(const std::string& section) const {
    std::vector<std::string> out;
    const auto* node = find(state_->root, section);
    if (node == nullptr) return out;
    if (!node->is_table()) fail(section, "it must be a section");
    for (const auto& [name, value] : *node->as_table()) {
        if (!value.is_table()) fail(section + "." + std::string(name.str()), "it must be a section");
        out.emplace_back(name.str());
    }
    return out;
}

void Document::numbers(const std::string& section, std::map<std::string, double>& out) {
    const auto* node = state_->asked_for(section);
    if (node == nullptr) return;
    if (!node->is_table()) fail(section, "it must be a table");
    state_->named.insert(section);
    for (const auto& [name, value] : *node->as_table()) {
        const std::string key = section + "." + std::string(name.str());
        double v = 0;
        if (const auto why = number_in(value, {}, v); !why.empty()) fail(key, why);
        out[std::string(name.str())] = v;
    }
}

void Document::texts(const std::string& section, std::map<std::string, std::vector<std::string>, std::less<>>& out) {
    const auto* node = state_->asked_for(section);
    if (node == nullptr) return;
    if (!node->is_table()) fail(section, "it must be a table");
    for (const auto& [name, value] : *node->as_table()) {
        const std::string key = section + "." + std::string(name.str());
        std::vector<std::string>& to = out[std::string(name.str())];
        const auto add = [&](const toml::node& item) {
            if (!item.is_string()) fail(key, "it must be a text in quotes, or a list of such texts");
            to.push_back(item.as_string()->get());
        };
        if (!value.is_array()) {
            add(value);
            continue;
        }
        for (const toml::node& item : *value.as_array()) add(item);
    }
}

void Document::uses(const std::string& text) const { state_->texts += text; }

void Document::check_names() const {
    const std::set<std::string> named = words_in_braces(state_->texts);
    for (const std::string& section : state_->named) {
        const auto* table = state_->root.get_as<toml::table>(section);
        std::vector<std::string> used;
        std::vector<std::string> idle;
        for (const auto& [name, node] : *table) {
            const std::string key(name.str());
            (named.contains(key) ? used : idle).push_back(key);
        }
        // A template from --set need not name the values that the profile's own template named.
        const bool replaced = std::any_of(state_->set.begin(), state_->set.end(),
                                          [](const std::string& key) { return key.starts_with("templates."); });
        if (replaced)
            std::erase_if(idle, [&](const auto& name) { return state_->set.count(section + "." + name) == 0; });
        if (idle.empty()) continue;
        const auto set = std::find_if(idle.begin(), idle.end(),
                                      [&](const auto& name) { return state_->set.count(section + "." + name) != 0; });
        const std::string& name = set != idle.end() ? *set : idle.front();
        for (const std::string& key : state_->asked) // "bead" may be meant as feeds.bead
            if (key.ends_with("." + name)) used = {key};
        const std::string meant = did_you_mean(name, used);
        fail(section + "." + name,
             "no template names it" +
                 (meant.empty() ? "; leave it out, or write {" + name + "} where it is to stand" : meant));
    }
}

namespace {

struct Left {
    std::string key;
    toml::source_position at;
};

// Collects the keys of `table` that nothing read; `above` is the prefix of its keys.  A section is searched if a key in
// it was read, else it is left over as a whole.
void left_over(const toml::table& table, const std::string& above, const std::set<std::string>& asked,
               std::vector<Left>& out) {
    for (const auto& [name, node] : table) {
        const std::string key = above + std::string(name.str());
        if (asked.count(key) != 0) continue;
        const auto inside = asked.lower_bound(key + ".");
        const bool section = inside != asked.end() && inside->starts_with(key + ".");
        if (section && node.is_table())
            left_over(*node.as_table(), key + ".", asked, out);
        else
            out.push_back({key, node.source().begin});
    }
}

} // namespace

void Document::finish() const {
    std::vector<Left> left;
    left_over(state_->root, "", state_->asked, left);
    if (left.empty()) return check_names();
    const auto first = std::min_element(left.begin(), left.end(), [](const Left& a, const Left& b) {
        return std::pair(a.at.line, a.key) < std::pair(b.at.line, b.key);
    });
    const std::vector<std::string> keys(state_->asked.begin(), state_->asked.end());
    for (const auto& key : state_->set)
        if (key.starts_with(first->key + ".")) misused(key, "there is no such key" + did_you_mean(key, keys));
    const auto inside = state_->asked.lower_bound(first->key + ".");
    const bool section = inside != state_->asked.end() && inside->starts_with(first->key + ".");
    fail(first->key, section ? "it must be a section" : "there is no such key" + did_you_mean(first->key, keys));
}

} // namespace filum::machine
