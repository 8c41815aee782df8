#include "machine/reader.hpp"

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/number.hpp"
#include "base/printable.hpp"
#include "machine/set_items.hpp"
#include "machine/template.hpp"
#include "machine/toml_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

namespace filum::machine {

namespace {

using Node = TomlValue;
using Table = TomlValue::Table;

} // namespace

struct Document::State {
    std::string kind, file;
    std::string within;                      // "tool.1.": the prefix of every key that is read
    Node* asked_for(const std::string& key); // finds prefix + key, and marks it as read
    Table root;
    std::set<std::string> asked; // dotted keys that were read
    std::set<std::string> set;   // keys that came from `set`
    std::string texts;           // all texts that were read, which may hold names in braces
    std::set<std::string> named; // sections whose keys are such names, see numbers()
};

namespace {

Node* find(Table& root, std::string_view key) {
    Table* table = &root;
    for (;;) {
        const auto dot = key.find('.');
        const auto at = table->find(std::string(key.substr(0, dot)));
        if (at == table->end()) return nullptr;
        if (dot == std::string_view::npos) return &at->second;
        if (!at->second.is_table()) return nullptr;
        table = &at->second.table();
        key.remove_prefix(dot + 1);
    }
}

Table parsed(std::string_view text, const std::string& file, const std::string& kind) {
    return read_toml(text, file, "cannot read " + kind + " '" + file + "'");
}

} // namespace

Node* Document::State::asked_for(const std::string& key) {
    asked.insert(within + key);
    return find(root, within + key);
}

namespace {

// The value after '=' in `set`: a number, true or false, a list in brackets or a text in quotes as TOML has them, or
// else an unchanged text.
void assign(Table& to, const std::string& key, const std::string& value) {
    if (value.starts_with('[') || value.starts_with('"')) {
        try {
            to[key] = parsed("value = " + value, key, "value").at("value");
        } catch (const Error&) {
            cannot_change(key + "=" + value, "its value is no list in brackets or text in quotes");
        }
        return;
    }
    if (value == "true" || value == "false") {
        to[key] = {value == "true"};
        return;
    }
    try {
        const double v = parse_number(value, key);
        if (v == std::floor(v) && std::abs(v) < 1e15)
            to[key] = {static_cast<std::int64_t>(v)};
        else
            to[key] = {v};
    } catch (const Error&) {
        to[key] = {value};
    }
}

} // namespace

Document::Document(std::string_view text, const std::string& file, const std::string& set, const std::string& kind)
    : state_(std::make_unique<State>()) {
    state_->kind = kind;
    state_->file = file;
    state_->root = parsed(text, file, kind);
    for (const auto& [key, value] : set_items(set)) {
        Table* table = &state_->root;
        std::string name = key;
        for (auto dot = name.find('.'); dot != std::string::npos; dot = name.find('.')) {
            const std::string section = name.substr(0, dot);
            name.erase(0, dot + 1);
            Node& inner = table->try_emplace(section, Node{Table{}}).first->second;
            if (!inner.is_table()) cannot_change(key, "'" + section + "' has no keys");
            table = &inner.table();
        }
        assign(*table, name, value);
        state_->set.insert(key);
    }
}

Document::~Document() = default;

namespace {

void add_missing(const Table& from, Table& to) {
    for (const auto& [name, node] : from) {
        Node& own = to.try_emplace(name, node).first->second;
        if (own.is_table() && node.is_table()) add_missing(node.table(), own.table());
    }
}

} // namespace

void Document::add_base(std::string_view text, const std::string& file) {
    add_missing(parsed(text, file, state_->kind), state_->root);
}

void Document::enter(const std::string& section) { state_->within = section + "."; }
void Document::leave() { state_->within.clear(); }

void Document::fail(const std::string& key, const std::string& why) const { fail_in_text(key, why, 0); }

bool Document::has(const std::string& key) const { return find(state_->root, state_->within + key) != nullptr; }

void Document::require(const std::string& key) const {
    if (state_->within.empty() && find(state_->root, key) == nullptr) fail(key, "it is missing");
}

namespace {

// Reads the number in `node`; returns its fault, or "" if there is none.
std::string number_in(const Node& node, const Document::Range& range, double& out) {
    const auto* whole = std::get_if<std::int64_t>(&node.value);
    const auto* floating = std::get_if<double>(&node.value);
    if (whole == nullptr && floating == nullptr) return "it must be a number";
    const double v = whole != nullptr ? static_cast<double>(*whole) : *floating;
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
    const auto* value = std::get_if<std::int64_t>(&node->value);
    if (value == nullptr || *value < min || *value > max)
        fail(key, "it must be a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    out = static_cast<int>(*value);
}

void Document::flag(const std::string& key, bool& out) {
    const auto* node = state_->asked_for(key);
    if (node == nullptr) return;
    const bool* value = std::get_if<bool>(&node->value);
    if (value == nullptr) fail(key, "it must be true or false");
    out = *value;
}

void Document::text(const std::string& key, std::string& out) {
    const auto* node = state_->asked_for(key);
    if (node == nullptr) return;
    if (!node->is_text()) fail(key, "it must be a text in quotes");
    out = node->text();
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
    if (!node->is_list() || node->list().size() != out.size())
        fail(key, "it must be " + (out.size() == 2 ? "two" : std::to_string(out.size())) + " numbers in brackets");
    for (std::size_t k = 0; k < out.size(); ++k)
        if (const auto why = number_in(node->list()[k], range, out[k]); !why.empty()) fail(key, why);
    return true;
}

std::vector<std::string> Document::tables(const std::string& section) const {
    std::vector<std::string> out;
    const auto* node = find(state_->root, section);
    if (node == nullptr) return out;
    if (!node->is_table()) fail(section, "it must be a section");
    for (const auto& [name, value] : node->table()) {
        if (!value.is_table()) fail(section + "." + name, "it must be a section");
        out.push_back(name);
    }
    return out;
}

void Document::numbers(const std::string& section, std::map<std::string, double>& out) {
    const auto* node = state_->asked_for(section);
    if (node == nullptr) return;
    if (!node->is_table()) fail(section, "it must be a table");
    state_->named.insert(section);
    for (const auto& [name, value] : node->table()) {
        const std::string key = section + "." + name;
        double v = 0;
        if (const auto why = number_in(value, {}, v); !why.empty()) fail(key, why);
        out[name] = v;
    }
}

void Document::texts(const std::string& section, std::map<std::string, std::vector<std::string>, std::less<>>& out) {
    const auto* node = state_->asked_for(section);
    if (node == nullptr) return;
    if (!node->is_table()) fail(section, "it must be a table");
    for (const auto& [name, value] : node->table()) {
        const std::string key = section + "." + name;
        std::vector<std::string>& to = out[name];
        const auto add = [&](const Node& item) {
            if (!item.is_text()) fail(key, "it must be a text in quotes, or a list of such texts");
            to.push_back(item.text());
        };
        if (!value.is_list()) {
            add(value);
            continue;
        }
        for (const Node& item : value.list()) add(item);
    }
}

void Document::uses(const std::string& text) const { state_->texts += text; }

void Document::check_names() const {
    const std::set<std::string> named = words_in_braces(state_->texts);
    for (const std::string& section : state_->named) {
        std::vector<std::string> used;
        std::vector<std::string> idle;
        for (const auto& [key, node] : find(state_->root, section)->table())
            (named.contains(key) ? used : idle).push_back(key);
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

struct UnreadKey {
    std::string key;
    std::size_t line;
};

// Collects the keys of `table` that nothing read; `above` is the prefix of its keys.  A section is searched if a key in
// it was read, else it is left over as a whole.
void unread(const Table& table, const std::string& above, const std::set<std::string>& asked,
            std::vector<UnreadKey>& out) {
    for (const auto& [name, node] : table) {
        const std::string key = above + name;
        if (asked.count(key) != 0) continue;
        const auto inside = asked.lower_bound(key + ".");
        const bool section = inside != asked.end() && inside->starts_with(key + ".");
        if (section && node.is_table())
            unread(node.table(), key + ".", asked, out);
        else
            out.push_back({key, node.line});
    }
}

// A question about a name in `root` that nothing has read and that is nearly a part of the missing `key`, "" if there
// is none: [feedz] for feeds.bead.
std::string meant_for(Table& root, const std::string& key, const std::set<std::string>& asked) {
    std::vector<UnreadKey> left;
    unread(root, "", asked, left);
    std::vector<std::string> names;
    for (const UnreadKey& k : left)
        if (!key.starts_with(k.key + ".")) names.push_back(k.key);
    for (std::size_t end = 0; end < key.size(); ++end) {
        end = std::min(key.find('.', end), key.size());
        const std::string part = key.substr(0, end);
        if (find(root, part) != nullptr) continue;
        const std::string typed = nearest(part, names);
        if (!typed.empty()) return "; is '" + shown(typed) + "' meant to be '" + part + "'?";
    }
    return "";
}

} // namespace

void Document::fail_in_text(const std::string& name, const std::string& why, std::size_t line) const {
    const std::string key = state_->within + name;
    if (state_->set.count(key) != 0) cannot_change(key, why);
    const Node* node = find(state_->root, key);
    // A key of a base stands in the base's file.
    const bool placed = node != nullptr && node->line > 0;
    std::string where = "'" + (placed ? node->file : state_->file) + "'";
    if (node != nullptr) where += ", line " + std::to_string(node->line + line);
    const std::string question = node == nullptr ? meant_for(state_->root, key, state_->asked) : "";
    throw Error(Exit::bad_input,
                "cannot use " + state_->kind + " " + where + ", key '" + shown(key) + "': " + why + question);
}

void Document::finish() const {
    std::vector<UnreadKey> left;
    unread(state_->root, "", state_->asked, left);
    if (left.empty()) return check_names();
    const auto first = std::min_element(left.begin(), left.end(), [](const UnreadKey& a, const UnreadKey& b) {
        return std::pair(a.line, a.key) < std::pair(b.line, b.key);
    });
    const std::vector<std::string> keys(state_->asked.begin(), state_->asked.end());
    for (const auto& key : state_->set)
        if (key.starts_with(first->key + ".")) cannot_change(key, "there is no such key" + did_you_mean(key, keys));
    const auto inside = state_->asked.lower_bound(first->key + ".");
    const bool section = inside != state_->asked.end() && inside->starts_with(first->key + ".");
    fail(first->key, section ? "it must be a section" : "there is no such key" + did_you_mean(first->key, keys));
}

} // namespace filum::machine
