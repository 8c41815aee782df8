#include "app/filum/cura_file.hpp"

#include "app/filum/slicer_table.hpp"
#include "app/filum/slicer_text.hpp"
#include "archive/zip.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "wire/json.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

namespace filum::app::filum {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepestDefinition = 32; // longest chain of definitions that inherit from each other

// A value as the other readers expect it: True and False become 1 and 0.
std::string without_python(const std::string& value) { return value == "True" ? "1" : value == "False" ? "0" : value; }

// One file of a profile. A section that occurs twice counts as one, whose later values win.
struct CuraProfile {
    std::map<std::string, std::vector<SlicerSetting>> sections;

    explicit CuraProfile(const std::string& text) {
        for (const Section& part : app::filum::sections(text, Lines::continued)) {
            auto& all = sections[part.heading];
            for (const SlicerSetting& s : part.settings) put_setting(all, s);
        }
    }

    [[nodiscard]] std::string value(const std::string& section, const std::string& key) const {
        const auto in = sections.find(section);
        const SlicerSetting* found = in == sections.end() ? nullptr : find_setting(in->second, key);
        return found == nullptr ? "" : found->value;
    }
    [[nodiscard]] bool any() const { return sections.contains("general") && sections.contains("metadata"); }
    // The number of the extruder that the profile is for; -1: it is for all.
    [[nodiscard]] int extruder() const {
        const std::string text = value("metadata", "position");
        return text.size() == 1 && text[0] >= '0' && text[0] <= '9' ? text[0] - '0' : text.empty() ? -1 : 99;
    }
    // The place of the profile in Cura's order: a later one wins.
    [[nodiscard]] int rank() const {
        constexpr std::string_view kTypes[] = {"definition_changes", "variant", "material", "quality", "intent",
                                               "quality_changes",    "user"};
        const auto* const found = std::ranges::find(kTypes, value("metadata", "type"));
        return static_cast<int>(found - std::begin(kTypes));
    }
};

// The settings of profiles together: those for the first extruder win over those for all.
std::optional<SlicerFile> joined_profiles(std::vector<CuraProfile> profiles) {
    std::erase_if(profiles, [](const CuraProfile& p) { return !p.any(); });
    if (profiles.empty()) return std::nullopt;
    std::ranges::stable_sort(profiles, {}, [](const CuraProfile& p) { return std::tuple(p.extruder(), p.rank()); });
    SlicerFile out{.slicer = Slicer::cura, .settings = {}, .remarks = {}};
    std::size_t left = 0;
    for (const CuraProfile& profile : profiles) {
        const auto values = profile.sections.find("values");
        if (values == profile.sections.end()) continue;
        if (profile.extruder() > 0) {
            left += values->second.size();
            continue;
        }
        for (const SlicerSetting& s : values->second) put_setting(out.settings, {s.key, without_python(s.value)});
    }
    if (left > 0)
        out.remarks.push_back(std::to_string(left) +
                              " settings of further extruders are not used: one extruder prints");
    return out;
}

std::optional<SlicerFile> cura_archive(const std::string& bytes, const std::string& file) {
    archive::Zip zip(bytes, "'" + file + "'");
    const bool project = zip.has("[Content_Types].xml");
    std::vector<CuraProfile> profiles;
    for (const std::string& entry : zip.entries())
        if (!entry.ends_with('/') && (!project || (entry.starts_with("Cura/") && entry.ends_with(".inst.cfg"))))
            profiles.emplace_back(zip.read(entry));
    return joined_profiles(std::move(profiles));
}

// The profile at the end of a G-code file: JSON in pieces, whose backslashes are doubled.
std::optional<SlicerFile> cura_program(const std::string& text) {
    constexpr std::string_view kMark = ";SETTING_3 ";
    std::string json;
    for (std::size_t at = text.find(kMark); at != std::string::npos; at = text.find(kMark, at)) {
        at += kMark.size();
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        json.append(text, at, end - at);
        at = end;
    }
    if (json.empty()) return std::nullopt;
    std::string once;
    for (std::size_t i = 0; i < json.size(); ++i) {
        once += json[i];
        if (json[i] == '\\' && i + 1 < json.size() && json[i + 1] == '\\') ++i;
    }
    std::vector<CuraProfile> profiles;
    for (const auto& [path, value] : wire::json_leaves(once))
        if (path.starts_with("global_quality") || path.starts_with("extruder_quality")) profiles.emplace_back(value);
    auto out = joined_profiles(std::move(profiles));
    if (!out) throw Error(Exit::bad_input, "cannot use the lines ;SETTING_3 of a program of Cura: they are damaged");
    constexpr std::string_view kHeight = ";Layer height: ";
    const auto at = text.find(kHeight);
    if (!out->has("layer_height") && at != std::string::npos) {
        const std::size_t from = at + kHeight.size();
        put_setting(out->settings, {"layer_height", trimmed(text.substr(from, text.find('\n', from) - from))});
    }
    return out;
}

// What definitions say of a setting.
struct Property {
    std::string plain, formula; // default_value, value; "" for none
    bool sets = false;          // it is a setting of the file, not only one that formulas may refer to
};
using Properties = std::map<std::string, Property>;

// A definition, as the paths and values of its JSON.
class Definition {
  public:
    Definition(const std::string& text, fs::path file) : values_(wire::json_leaves(text)), file_(std::move(file)) {}

    [[nodiscard]] bool any() const {
        return std::ranges::any_of(values_, [](const auto& v) { return v.first.starts_with("metadata/"); }) &&
               std::ranges::any_of(values_, [](const auto& v) {
                   return v.first.starts_with("overrides/") || v.first.starts_with("settings/");
               });
    }
    [[nodiscard]] std::string value(const std::string& path) const {
        const auto at = values_.find(path);
        return at == values_.end() ? "" : at->second;
    }
    [[nodiscard]] std::string parent() const { return value("inherits"); }
    [[nodiscard]] std::string first_extruder() const { return value("metadata/machine_extruder_trains/0"); }
    [[nodiscard]] const fs::path& file() const { return file_; }

    // Puts what it says of settings over what its parents say.  As in Cura, a plain default leaves a parent's formula.
    // Of the root only the settings of the printer count, unless `whole`.
    void apply(bool whole, Properties& to) const {
        for (const auto& [path, value] : values_) {
            const auto slash = path.rfind('/');
            if (slash == std::string::npos || !(path.starts_with("overrides/") || path.starts_with("settings/")))
                continue;
            const std::string name = path.substr(slash + 1);
            if ((name != "default_value" && name != "value") || value.empty()) continue;
            const std::string key = path.substr(path.rfind('/', slash - 1) + 1, slash - path.rfind('/', slash - 1) - 1);
            Property& of = to[key];
            (name == "value" ? of.formula : of.plain) = name == "value" ? trimmed(value) : value;
            of.sets = of.sets || whole || !parent().empty() || row_of(key, Slicer::cura).reading == "machine";
        }
    }

  private:
    std::map<std::string, std::string> values_;
    fs::path file_;
};

// A definition and those that it inherits from, the root last.  A remark names a missing one.
std::vector<Definition> ancestry(Definition definition, SlicerFile& out) {
    std::vector<Definition> chain{std::move(definition)};
    while (!chain.back().parent().empty()) {
        if (chain.size() > kDeepestDefinition)
            throw Error(Exit::bad_input, "cannot use '" + chain.front().file().string() +
                                             "': it inherits from itself, or too deep; remove \"inherits\"");
        const fs::path file = chain.back().file().parent_path() / (chain.back().parent() + ".def.json");
        std::error_code none;
        if (!fs::is_regular_file(file, none)) {
            // The root of all holds defaults that the table has, too.
            if (const std::string name = chain.back().parent(); name != "fdmprinter" && name != "fdmextruder")
                out.remarks.push_back("the definition that '" + chain.back().file().filename().string() +
                                      "' inherits from was not found: its settings are not applied; put it beside the "
                                      "file, as " +
                                      name + ".def.json");
            break;
        }
        chain.emplace_back(content_of(file.string()), file);
    }
    return chain;
}

std::optional<SlicerFile> cura_definition(const std::string& text, const std::string& file) {
    Definition own(text, fs::absolute(file));
    if (!own.any()) return std::nullopt;
    SlicerFile out{.slicer = Slicer::cura, .settings = {}, .remarks = {}};
    Properties all;
    const std::vector<Definition> chain = ancestry(std::move(own), out);
    for (auto at = chain.rbegin(); at != chain.rend(); ++at) at->apply(chain.size() == 1, all);
    const auto train = std::ranges::find_if(chain, [](const Definition& d) { return !d.first_extruder().empty(); });
    const std::string name = train == chain.end() ? "" : train->first_extruder();
    if (!name.empty() && name != "fdmextruder") {
        const fs::path there = train->file().parent_path() / ".." / "extruders" / (name + ".def.json");
        std::error_code none;
        if (fs::is_regular_file(there, none))
            Definition(content_of(there.string()), there).apply(false, all);
        else
            out.remarks.push_back("the definition of its extruder, '" + name +
                                  "', was not found in '../extruders': nozzle and filament are those that Cura has "
                                  "without it, but filament is 1.75 mm");
    }
    for (const auto& [key, of] : all)
        (of.sets ? out.settings : out.beneath)
            .push_back(of.formula.empty() ? SlicerSetting{key, of.plain}
                                          : SlicerSetting{key, "=" + of.formula, of.plain});
    return out;
}

} // namespace

bool is_formula(const std::string& value) { return value.starts_with('='); }

std::optional<SlicerFile> cura_file(const std::string& bytes, const std::string& file) {
    std::optional<SlicerFile> out;
    if (archive::Zip::begins(bytes))
        out = cura_archive(bytes, file);
    else if (is_json(bytes))
        out = cura_definition(bytes, file);
    else if (bytes.find(";SETTING_3 ") != std::string::npos)
        out = cura_program(bytes);
    else if (bytes.find("[general]") != std::string::npos && bytes.find("[metadata]") != std::string::npos)
        out = joined_profiles({CuraProfile(bytes)});
    return out;
}

} // namespace filum::app::filum
