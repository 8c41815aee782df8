// Presets of slicers: named sets of settings for a printer, a print or a filament.  A preset can inherit from others.
// Bundles of PrusaSlicer and SuperSlicer hold many presets; OrcaSlicer and Bambu Studio keep one in each JSON file.
#pragma once

#include "app/filum/preset_folders.hpp"
#include "app/filum/slicer_text.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace filum::app::filum {

struct Preset {
    PresetKind kind = PresetKind::print;
    std::string name, file;
    Slicer slicer = Slicer::unknown;
    std::vector<SlicerSetting> settings; // its own; inherited ones are not included
};

// A preset that a user can choose.
struct KnownPreset {
    std::string name, file;
};

// One name for each PresetKind; "": none.
using PresetNames = std::array<std::string, kPresetKinds>;

// The value of `--load`: a file and names of presets in it.
struct NamedPresets {
    std::string file;
    PresetNames names;
    [[nodiscard]] bool any() const;
};

// Parses "FILE:printer=NAME,print=NAME,filament=NAME"; names may hold spaces and commas.  If a file has the whole word
// as its name, the word names no presets.  Throws Error(usage) for an empty name.
NamedPresets named_presets(const std::string& word);

// The presets that one file can refer to: those of its bundle, those beside it, and those that slicers keep.
class PresetShelf {
  public:
    explicit PresetShelf(std::string beside) : folders_(std::move(beside)) {}

    // Adds the presets of a bundle.  find() returns them before all others.
    void add_bundle(const std::string& text, const std::string& file);
    // The preset `name`: first of added bundles, then of files (see PresetFolders), then of bundles in slicers'
    // folders. A name that a bundle has renamed finds the preset of today's name.  `from`: the file that inherits from
    // it.
    [[nodiscard]] std::optional<Preset> find(PresetKind kind, const std::string& name, const std::string& from = "");
    // The names of presets in added bundles that a user can choose, in the order of the bundle.
    [[nodiscard]] std::vector<std::string> names(PresetKind kind) const;
    // All presets that a user can choose: first those in bundles, then those in files of their own.  Presets that only
    // serve as bases for others are left out.
    [[nodiscard]] std::vector<KnownPreset> known(PresetKind kind);
    // The name of the preset that OrcaSlicer and Bambu Studio select with a printer: `usual`, unless it is missing or
    // made for other printers; then the first one by name that is made for this printer.  "": there is none.
    std::string selected(PresetKind kind, const std::string& usual, const std::string& printer);
    // The settings of a preset with all inherited ones.  `missing` gets a sentence for each parent that is not found.
    // Throws Error(bad_input) for a preset that inherits from itself.
    std::vector<SlicerSetting> whole(const Preset& preset, std::vector<std::string>& missing);

  private:
    using Key = std::pair<PresetKind, std::string>;
    struct PresetBundle {
        std::map<Key, Preset> presets;
        std::vector<Key> order;
        std::map<Key, std::string> renamed; // by the old name: the present name
    };
    static void read_bundle(const std::string& text, const std::string& file, PresetBundle& into);
    static const Preset* in(const PresetBundle& bundled, const Key& key);
    void gather(const Preset& preset, std::vector<std::string>& path, std::vector<SlicerSetting>& out,
                std::vector<std::string>& missing);

    const PresetBundle& vendors();
    // The printers that a preset in JSON is made for; empty: for all.
    std::vector<std::string> printers_of(const Preset& preset);

    PresetFolders folders_;
    PresetBundle own_;                    // from add_bundle()
    std::optional<PresetBundle> vendors_; // from bundles in slicers' folders; none: not read yet
};

// The preset in a text: a JSON object, or lines "name = value" without sections.  `file`: where the text comes from.
Preset preset_of(const std::string& text, const std::string& file);

// The settings of the named presets.  A kind without a name gets the default preset of the printer.  `file`: for
// messages.  Throws Error: usage for an unknown name, bad_input for a preset that inherits from itself.
SlicerFile settings_of_presets(PresetShelf& shelf, PresetNames names, const std::string& file);

// The settings of presets in the bundle `text`.  If `wanted` names no preset, the bundle's section [presets] names
// them; without that section, a bundle with a single printer means that printer.  A kind that is still without a name
// gets the default preset of the printer.  Throws Error: usage for an unknown name, bad_input if no preset is named in
// any of these ways.
SlicerFile bundle_settings(const std::string& text, const NamedPresets& wanted);

// The settings of the preset in `text`, with all inherited ones.  Presets that PrusaSlicer and SuperSlicer save are
// complete already.
SlicerFile preset_settings(const std::string& text, const std::string& file);

} // namespace filum::app::filum
