#include "app/filum/slicer_presets.hpp"

#include "app/filum/slicer_table.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

#include <algorithm>
#include <filesystem>

namespace filum::app::filum {

namespace {

constexpr std::size_t kDeepestPreset = 64; // longest chain of presets that inherit from each other
constexpr std::size_t kNamesShown = 6;     // most names in a message

// The names in a list.  The divider is ';', in lists from JSON ','.
std::vector<std::string> names_in(const std::string& list, char divider) {
    std::vector<std::string> out;
    std::size_t at = 0;
    while (at <= list.size()) {
        const std::size_t end = std::min(list.find(divider, at), list.size());
        const std::string name = unquoted(list.substr(at, end - at));
        if (!name.empty()) out.push_back(name);
        at = end + 1;
    }
    return out;
}

std::vector<std::string> parents_of(const Preset& preset) {
    const SlicerSetting* own = find_setting(preset.settings, "inherits");
    std::vector<std::string> out = own == nullptr ? std::vector<std::string>{} : names_in(own->value, ';');
    if (const SlicerSetting* more = find_setting(preset.settings, "include"); more != nullptr)
        std::ranges::copy(names_in(more->value, ','), std::back_inserter(out));
    return out;
}

PresetKind kind_by_keys(const std::vector<SlicerSetting>& settings) {
    const auto has = [&](const char* key) { return find_setting(settings, key) != nullptr; };
    if (const SlicerSetting* type = find_setting(settings, "type"); type != nullptr)
        if (const auto kind = kind_of(type->value)) return *kind;
    if (has("nozzle_diameter") || has("bed_shape") || has("printable_area") || has("printer_model"))
        return PresetKind::printer;
    return has("filament_type") || has("filament_diameter") || has("temperature") || has("nozzle_temperature")
               ? PresetKind::filament
               : PresetKind::print;
}

std::string shown(const std::vector<std::string>& names) {
    std::string out;
    for (std::size_t i = 0; i < std::min(names.size(), kNamesShown); ++i)
        out += std::string(out.empty() ? "'" : ", '") + names[i] + "'";
    return out + (names.size() > kNamesShown ? " and " + std::to_string(names.size() - kNamesShown) + " more" : "");
}

} // namespace

bool NamedPresets::any() const {
    return std::ranges::any_of(names, [](const std::string& name) { return !name.empty(); });
}

NamedPresets named_presets(const std::string& word) {
    NamedPresets out{word, {}};
    std::error_code none;
    if (std::filesystem::exists(word, none)) return out;
    const auto kind_at = [&](std::size_t at) -> std::optional<PresetKind> {
        const std::size_t equal = word.find('=', at);
        return equal == std::string::npos ? std::nullopt : kind_of(word.substr(at, equal - at));
    };
    std::size_t at = 0;
    while ((at = word.find(':', at)) != std::string::npos && !kind_at(at + 1)) ++at;
    if (at == std::string::npos) return out;
    out.file = word.substr(0, at);
    while (at < word.size()) {
        const PresetKind kind = *kind_at(at + 1);
        const std::size_t from = word.find('=', at) + 1;
        std::size_t end = from;
        while ((end = word.find(',', end)) != std::string::npos && !kind_at(end + 1)) ++end;
        end = std::min(end, word.size());
        std::string& name = out.names[static_cast<std::size_t>(kind)];
        name = trimmed(word.substr(from, end - from));
        if (name.empty())
            throw Error(Exit::usage, "cannot load '" + word + "': " + name_of(kind) + "= lacks the preset's name");
        at = end;
    }
    return out;
}

void PresetShelf::read_bundle(const std::string& text, const std::string& file, PresetBundle& into) {
    const Slicer slicer = writer_of(text, {}) == Slicer::unknown ? Slicer::prusa : writer_of(text, {});
    for (Section& section : sections(text, Lines::plain)) {
        const auto colon = section.heading.find(':');
        const auto kind = kind_of(section.heading.substr(0, colon));
        if (colon == std::string::npos || !kind) continue;
        const Key key{*kind, trimmed(section.heading.substr(colon + 1))};
        const auto [at, fresh] = into.presets.try_emplace(key, Preset{*kind, key.second, file, slicer, {}});
        if (fresh) into.order.push_back(key);
        for (const SlicerSetting& s : section.settings) {
            put_setting(at->second.settings, s);
            if (s.key != "renamed_from") continue;
            for (const std::string& old : names_in(s.value, ';')) into.renamed[{*kind, old}] = key.second;
        }
    }
}

void PresetShelf::add_bundle(const std::string& text, const std::string& file) { read_bundle(text, file, own_); }

const Preset* PresetShelf::in(const PresetBundle& bundled, const Key& key) {
    if (const auto at = bundled.presets.find(key); at != bundled.presets.end()) return &at->second;
    const auto renamed = bundled.renamed.find(key);
    if (renamed == bundled.renamed.end()) return nullptr;
    const auto at = bundled.presets.find({key.first, renamed->second});
    return at == bundled.presets.end() ? nullptr : &at->second;
}

const PresetShelf::PresetBundle& PresetShelf::vendors() {
    if (vendors_) return *vendors_;
    vendors_.emplace();
    for (const std::string& file : folders_.bundles()) read_bundle(content_of(file), file, *vendors_);
    return *vendors_;
}

std::optional<Preset> PresetShelf::find(PresetKind kind, const std::string& name, const std::string& from) {
    if (const Preset* found = in(own_, {kind, name})) return *found;
    if (const auto file = folders_.find(kind, name, from)) {
        Preset out = preset_of(content_of(*file), *file);
        out.kind = kind;
        out.name = name;
        return out;
    }
    if (const Preset* found = in(vendors(), {kind, name})) return *found;
    return std::nullopt;
}

std::vector<std::string> PresetShelf::names(PresetKind kind) const {
    std::vector<std::string> out;
    for (const Key& key : own_.order)
        if (key.first == kind && !key.second.starts_with('*')) out.push_back(key.second);
    return out;
}

std::vector<KnownPreset> PresetShelf::known(PresetKind kind) {
    std::vector<KnownPreset> out;
    for (const PresetBundle* bundled : {static_cast<const PresetBundle*>(&own_), &vendors()})
        for (const Key& key : bundled->order)
            if (key.first == kind && !key.second.starts_with('*'))
                out.push_back({key.second, bundled->presets.at(key).file});
    for (const std::string& file : folders_.files(kind)) {
        const std::string name = std::filesystem::path(file).stem().string();
        if (name.starts_with("fdm_")) continue; // bases of other presets; a user cannot choose them
        const Preset preset = preset_of(content_of(file), file);
        const SlicerSetting* shown = find_setting(preset.settings, "instantiation");
        const SlicerSetting* type = find_setting(preset.settings, "type");
        if ((shown == nullptr || shown->value == "true") && (type == nullptr || kind_of(type->value) == kind))
            out.push_back({name, file});
    }
    return out;
}

std::vector<std::string> PresetShelf::printers_of(const Preset& preset) {
    if (!preset.file.ends_with(".json")) return {};
    std::vector<std::string> missing;
    const auto all = whole(preset, missing);
    const SlicerSetting* printers = find_setting(all, "compatible_printers");
    if (printers == nullptr) return {};
    return names_in(printers->value, printers->value.find(';') != std::string::npos ? ';' : ',');
}

std::string PresetShelf::selected(PresetKind kind, const std::string& usual, const std::string& printer) {
    const auto holds = [&](const std::vector<std::string>& names) {
        return std::ranges::find(names, printer) != names.end();
    };
    const auto found = find(kind, usual);
    if (found) {
        const auto printers = printers_of(*found);
        if (printers.empty() || holds(printers)) return usual;
    }
    for (const std::string& file : folders_.files(kind)) {
        const std::string text = content_of(file);
        if (!file.ends_with(".json") || text.find('"' + printer + '"') == std::string::npos) continue;
        const Preset preset = preset_of(text, file);
        const SlicerSetting* shown = find_setting(preset.settings, "instantiation");
        if (shown != nullptr && shown->value == "true" && holds(printers_of(preset)))
            return std::filesystem::path(file).stem().string();
    }
    return found ? usual : "";
}

// Parents come first, so that a preset's own values replace theirs.
void PresetShelf::gather(const Preset& preset, std::vector<std::string>& path, std::vector<SlicerSetting>& out,
                         std::vector<std::string>& missing) {
    const std::string id = preset.file + "\n" + preset.name;
    if (std::ranges::find(path, id) != path.end() || path.size() > kDeepestPreset)
        throw Error(Exit::bad_input, "cannot use '" + preset.file + "': its preset '" + preset.name +
                                         "' inherits from itself; remove that line");
    path.push_back(id);
    for (const std::string& name : parents_of(preset)) {
        if (const auto parent = find(preset.kind, name, preset.file)) {
            gather(*parent, path, out, missing);
            continue;
        }
        const std::string what = "preset '" + name + "', which '" + (preset.name.empty() ? preset.file : preset.name) +
                                 "' inherits from, was not found: its settings are not applied; set FILUM_PRESETS to "
                                 "the folder that holds it, or export the whole configuration";
        if (std::ranges::find(missing, what) == missing.end()) missing.push_back(what);
    }
    path.pop_back();
    for (const SlicerSetting& s : preset.settings) put_setting(out, s);
}

std::vector<SlicerSetting> PresetShelf::whole(const Preset& preset, std::vector<std::string>& missing) {
    std::vector<SlicerSetting> out;
    std::vector<std::string> path;
    gather(preset, path, out, missing);
    return out;
}

Preset preset_of(const std::string& text, const std::string& file) {
    Preset out;
    out.file = file;
    out.settings = is_json(text) ? json_settings(text) : all_settings(text, Lines::plain);
    out.slicer = writer_of(text, out.settings);
    out.kind = kind_by_keys(out.settings);
    if (const SlicerSetting* name = find_setting(out.settings, "name"); name != nullptr) out.name = name->value;
    return out;
}

namespace {

// The preset of that kind and name.  `file`: for the message.  Throws Error(usage) if it does not exist.
Preset wanted_preset(PresetShelf& shelf, PresetKind kind, const std::string& name, const std::string& file) {
    if (auto found = shelf.find(kind, name)) return *found;
    const auto names = shelf.names(kind);
    const std::string meant = did_you_mean(name, names);
    throw Error(Exit::usage, "cannot use '" + file + "': it has no " + name_of(kind) + " '" + name + "'" +
                                 (meant.empty() ? "; it has " + shown(names) : meant));
}

// Takes names from the section [presets] of an exported bundle, for kinds that have none yet.
void name_active(const std::string& text, PresetNames& names) {
    for (const Section& section : sections(text, Lines::plain)) {
        if (section.heading != "presets") continue;
        for (const SlicerSetting& s : section.settings)
            if (const auto kind = kind_of(s.key); kind && names[static_cast<std::size_t>(*kind)].empty())
                names[static_cast<std::size_t>(*kind)] = unquoted(s.value);
    }
}

} // namespace

SlicerFile settings_of_presets(PresetShelf& shelf, PresetNames names, const std::string& file) {
    SlicerFile out;
    for (std::size_t i = 0; i < kPresetKinds; ++i) { // the printer comes first, since it names defaults for the others
        const auto kind = static_cast<PresetKind>(i);
        if (names[i].empty()) continue;
        const Preset preset = wanted_preset(shelf, kind, names[i], file);
        const auto settings = shelf.whole(preset, out.remarks);
        if (out.slicer == Slicer::unknown) out.slicer = preset.slicer;
        for (const SlicerSetting& s : settings) put_setting(out.settings, s);
        if (kind == PresetKind::print && out.slicer != Slicer::super) // SuperSlicer's defaults depend on each other
            for (const SlicerSetting& s : defaults_of(out.slicer))
                if (find_setting(out.settings, s.key) == nullptr) out.settings.push_back(s);
        if (kind != PresetKind::printer) continue;
        constexpr std::pair<PresetKind, const char*> kDefaults[] = {{PresetKind::print, "default_print_profile"},
                                                                    {PresetKind::filament, "default_filament_profile"}};
        for (const auto& [other, key] : kDefaults) {
            std::string& name = names[static_cast<std::size_t>(other)];
            const SlicerSetting* usual = find_setting(settings, key);
            if (!name.empty() || usual == nullptr) continue;
            const auto all = names_in(usual->value, preset.file.ends_with(".json") ? ',' : ';');
            if (all.empty()) continue;
            // Another process fits the nozzle; another filament may be another material, so the named one counts.
            if (other == PresetKind::print)
                name = shelf.selected(other, all.front(), preset.name);
            else if (shelf.find(other, all.front()))
                name = all.front();
            if (name != all.front())
                out.remarks.push_back(
                    std::string("the printer's default ") + name_of(other) + " '" + all.front() +
                    "' was not found, or is for other printers: " +
                    (name.empty() ? "none is used" : "'" + name + "' is used, which is for this one"));
        }
    }
    return out;
}

SlicerFile bundle_settings(const std::string& text, const NamedPresets& wanted) {
    PresetShelf shelf(wanted.file);
    shelf.add_bundle(text, wanted.file);
    PresetNames names = wanted.names;
    if (!wanted.any()) name_active(text, names);
    const auto printers = shelf.names(PresetKind::printer);
    std::string& printer = names[static_cast<std::size_t>(PresetKind::printer)];
    if (std::ranges::all_of(names, &std::string::empty) && printers.size() == 1) printer = printers.front();
    if (std::ranges::all_of(names, &std::string::empty))
        throw Error(Exit::bad_input, "cannot use '" + wanted.file + "': it is a bundle of presets, and nothing says " +
                                         "which hold; name them, as in --load '" + wanted.file +
                                         ":printer=" + (printers.empty() ? "NAME" : printers.front()) +
                                         "'; its printers are " + (printers.empty() ? "none" : shown(printers)));
    return settings_of_presets(shelf, names, wanted.file);
}

SlicerFile preset_settings(const std::string& text, const std::string& file) {
    Preset preset = preset_of(text, file);
    SlicerFile out;
    PresetShelf shelf(file);
    // PrusaSlicer and SuperSlicer write all settings into the presets that they save.
    const bool complete = !is_json(text) && text.substr(0, text.find('\n')).find("generated by ") != std::string::npos;
    out.settings = complete ? preset.settings : shelf.whole(preset, out.remarks);
    out.slicer = preset.slicer;
    if (is_json(text) && !preset.name.empty()) { // macros ask for the names of presets
        const char* keys[kPresetKinds] = {};
        keys[static_cast<std::size_t>(PresetKind::printer)] = "printer_settings_id";
        keys[static_cast<std::size_t>(PresetKind::print)] = "print_settings_id";
        keys[static_cast<std::size_t>(PresetKind::filament)] = "filament_settings_id";
        const char* key = keys[static_cast<std::size_t>(preset.kind)];
        const SlicerSetting* own = find_setting(out.settings, key);
        if (own == nullptr || own->value.empty()) put_setting(out.settings, {key, preset.name});
    }
    return out;
}

} // namespace filum::app::filum
