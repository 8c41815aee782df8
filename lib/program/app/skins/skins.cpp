#include "app/skins/skins.hpp"

#include "app/modifier/modifier.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "cli/other_values.hpp"
#include "cli/output.hpp"
#include "polygon/stack.hpp"
#include "wire/planar.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>

namespace filum::app::skins {

namespace {

using filum::skins::Modifier;
using polygon::Region;

// One item of --modifier: FILE:SETTINGS, or FILE alone for the modifiers of a project.  The last colon divides the two,
// since names of files may hold colons.
struct ModifierRequest {
    std::string file, settings;
};

bool is_project(std::string name) {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name.ends_with(".3mf") || name.ends_with(".amf");
}

bool is_ours(std::string_view name) {
    return std::ranges::find(filum::skins::kModifierSettings, name) != filum::skins::kModifierSettings.end();
}

// The setting with Filum's name instead of another slicer's: infill=40% for fill_density=40%.
std::string in_our_words(const std::string& setting) {
    const auto equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    const cli::OtherName* other =
        is_ours(name) || equals == std::string::npos ? nullptr : cli::other_name(name, is_ours);
    if (other == nullptr) return setting;
    const auto word = cli::our_word(*other, setting.substr(equals + 1));
    if (!word)
        throw Error(Exit::usage,
                    "cannot use '" + setting + "' of --modifier; here it is '" + std::string(other->ours) + "'");
    return word->substr(2); // without "--"
}

// The settings "A=1,B=2" with Filum's names.
std::string settings_in_our_words(const std::string& settings) {
    std::string out;
    for (std::size_t from = 0; from <= settings.size();) {
        const std::size_t comma = std::min(settings.find(',', from), settings.size());
        out += (from > 0 ? "," : "") + in_our_words(settings.substr(from, comma - from));
        from = comma + 1;
    }
    return out;
}

std::vector<ModifierRequest> asked(const std::string& text) {
    std::vector<ModifierRequest> out;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(';', from), text.size());
        const std::string one = text.substr(from, end - from);
        from = end + 1;
        if (is_project(one)) {
            out.push_back({one, ""});
            continue;
        }
        const std::size_t colon = one.rfind(':');
        if (colon == std::string::npos || colon == 0 || colon + 1 == one.size())
            throw Error(Exit::usage, "cannot use '" + one +
                                         "' as --modifier: it is FILE:SETTINGS, as knob.stl:infill=40%, or a slicer's "
                                         "project, as knob.3mf");
        out.push_back({one.substr(0, colon), settings_in_our_words(one.substr(colon + 1))});
    }
    return out;
}

// A setting of a project's modifier, with Filum's name.  None if the setting or its value has no meaning in Filum.
std::optional<std::string> in_our_words(std::string key, const std::string& value, const filum::skins::Options& part) {
    std::ranges::replace(key, '_', '-');
    const cli::OtherName* other = cli::other_name(key, is_ours);
    if (other == nullptr) return std::nullopt;
    try {
        const auto word = cli::our_word(*other, value);
        if (!word) return std::nullopt;
        std::string out = word->substr(2); // without "--"
        filum::skins::modified(part, out);
        return out;
    } catch (const Error&) { // the value has another form or is out of bounds
        return std::nullopt;
    }
}

void tell_left_out(const std::string& key, const std::string& value, Notes& notes) {
    notes.push_back({.code = NoteCode::modifier_setting, .detail = key + "=" + value});
}

// All settings of a project's modifier, with Filum's names.  Notes report the settings that are left out, except widths
// of 0, which mean that the slicer chooses them.
std::string settings_of_project(const std::vector<std::pair<std::string, std::string>>& all,
                                const filum::skins::Options& part, Notes& notes) {
    std::string out;
    for (const auto& [key, value] : all) {
        if (value == "0" && key.ends_with("width")) continue;
        if (key == "support_material" || key == "enable_support") continue; // `supports` takes these
        if (const auto word = in_our_words(key, value, part))
            out += (out.empty() ? "" : ",") + *word;
        else
            tell_left_out(key, value, notes);
    }
    return out;
}

// The modifiers in their order of precedence, and the text that records them in the history.
struct ModifierSet {
    std::vector<Modifier> modifiers;
    std::string said, crc; // in the history, where files have no names
    bool of_part = false;  // some are from the part's own project

    void add(std::vector<polygon::Loops> where, const std::string& settings, const filum::skins::Options& part) {
        said += (said.empty() ? "FILE:" : ";FILE:") + settings;
        modifiers.push_back({std::move(where), filum::skins::modified(part, settings)});
    }
};

ModifierSet read_modifiers(const std::vector<ModifierRequest>& all, const filum::skins::Options& part,
                           const stream::Header& header, const std::vector<Region>& regions, cli::Io& self,
                           Notes& notes) {
    ModifierSet out;
    for (const ModifierRequest& a : all) {
        std::string crc;
        if (a.settings.empty()) {
            auto project = modifier::modifiers(a.file, header, regions, self.threads, notes);
            crc = std::move(project.crc32c);
            out.of_part = out.of_part || modifier::is_part(crc, header);
            for (auto& m : project.bodies)
                if (const auto settings = settings_of_project(m.settings, part, notes); !settings.empty())
                    out.add(std::move(m.outlines), settings, part);
        } else {
            auto body = modifier::body(a.file, header, regions, self.threads, notes);
            crc = std::move(body.crc32c);
            out.add(std::move(body.outlines), a.settings, part);
        }
        out.crc += (out.crc.empty() ? "" : ",") + crc;
    }
    if (all.empty()) return out;
    self.settings.push_back({"modifier", out.said, true});
    self.settings.push_back({"modifier_crc32c", out.crc});
    return out;
}

} // namespace

namespace {

// Adds a note if sparse areas have beads of another width than the one that they are planned with, as those of a tool
// with a width of its own.
void note_other_width(const std::vector<Region>& regions, const filum::skins::Options& o, Notes& notes) {
    const auto other = std::ranges::find_if(regions, [&](const Region& r) {
        return r.width > 0 && r.width != o.bead_width &&
               std::ranges::any_of(r.areas, [](const polygon::Area& a) { return a.kind == polygon::AreaKind::sparse; });
    });
    if (other == regions.end()) return;
    notes.push_back({.code = NoteCode::setting_differs,
                     .layer = other->layer,
                     .detail = "beads of tool " + std::to_string(other->tool) + " are " + shortest_text(other->width) +
                               " mm wide, but sparse areas of all tools are planned for " +
                               shortest_text(o.bead_width) + " mm"});
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    filum::skins::Options options = o.how;
    options.infill = filum::skins::share(o.infill);
    options.pattern = filum::skins::pattern(o.pattern);
    const auto bodies = asked(o.modifiers);
    for (const ModifierRequest& a : bodies) filum::skins::modified(options, a.settings);
    std::vector<Region> regions;
    auto whole = cli::read_all(io.input, stream::Payload::regions,
                               [&](stream::RawFrame frame) { regions.push_back(wire::region(frame)); });
    const auto original = polygon::close_gaps(regions, filum::skins::reach_in_layers(options));
    cli::Io self = io;
    Notes notes;
    const auto [modifiers, said, crc, of_part] = read_modifiers(bodies, options, whole.header, regions, self, notes);
    if (of_part)
        std::erase_if(whole.notes, [](const Note& n) {
            return n.code == NoteCode::project_modifier || n.code == NoteCode::project_part_settings;
        });
    Facts facts;
    std::ranges::move(filum::skins::skins(regions, options, modifiers, facts), std::back_inserter(notes));
    note_other_width(regions, options, notes);
    for (Region& r : regions) r.layer = original[r.layer];
    polygon::restore_layers(notes, original);
    whole.header.expected = regions.size();
    cli::Output output(io, cli::header(self, stream::Payload::regions, {&whole.header}));
    output.pass_on(whole);
    output.add(notes);
    output.add(facts);
    for (const auto& r : regions) output.write(wire::frame(r));
    output.close();
}

} // namespace filum::app::skins
