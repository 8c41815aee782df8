// Presets of slicers: named sets of settings for a printer, a print or a filament.  A preset can inherit from others.
// Bundles of PrusaSlicer and SuperSlicer hold many of them; OrcaSlicer and Bambu Studio keep one in each JSON file.
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
    std::vector<SlicerSetting> settings; // its own, without those that it inherits
};

// A preset that a user can choose.
struct KnownPreset {
    std::string name, file;
};

// A name of each kind, by PresetKind; "": none.
using PresetNames = std::array<std::string, kPresetKinds>;

// What `--load` names: a file, and presets in it.
struct NamedPresets {
    std::string file;
    PresetNames names;
    [[nodiscard]] bool any() const;
};

// "FILE:printer=NAME,print=NAME,filament=NAME", in which names may hold spaces and commas; of a file by that whole name
// no presets are named.  Throws Error(usage) for an empty name.
NamedPresets named_presets(const std::string& word);

// The presets that one file can refer to: those of its bundle, those beside it, and those that slicers keep.
class PresetShelf {
  public:
    explicit PresetShelf(std::string beside) : folders_(std::move(beside)) {}

    // The presets of a bundle; found before all others.
    void add_bundle(const std::string& text, const std::string& file);
    [[nodiscard]] std::optional<Preset> find(PresetKind kind, const std::string& name);
    // The names of presets that can be chosen, in the order of their bundle.
    [[nodiscard]] std::vector<std::string> names(PresetKind kind) const;
    // All that a user can choose: those of bundles, then files of OrcaSlicer, Bambu Studio and the user's own.
    [[nodiscard]] std::vector<KnownPreset> known(PresetKind kind);
    // The settings of a preset with all that it inherits; `missing` gets a sentence for each preset that is not found.
    std::vector<SlicerSetting> whole(const Preset& preset, std::vector<std::string>& missing);

  private:
    using Key = std::pair<PresetKind, std::string>;
    struct Bundled {
        std::map<Key, Preset> presets;
        std::vector<Key> order;
        std::map<Key, std::string> renamed; // an old name: the name of today
    };
    static void read_bundle(const std::string& text, const std::string& file, Bundled& into);
    static const Preset* in(const Bundled& bundled, const Key& key);
    void gather(const Preset& preset, std::vector<std::string>& path, std::vector<SlicerSetting>& out,
                std::vector<std::string>& missing);

    const Bundled& vendors();

    PresetFolders folders_;
    Bundled own_;                    // of add_bundle
    std::optional<Bundled> vendors_; // of the slicers' folders, read when first needed
};

// The preset that a JSON object or lines without sections are.
Preset preset_of(const std::string& text, const std::string& file);

// The settings of the named presets; kinds without a name get the preset that the printer names as its default.  `file`
// is for messages.  Throws Error(usage) for an unknown name.
SlicerFile settings_of_presets(PresetShelf& shelf, PresetNames names, const std::string& file);

// The settings of the presets named in a bundle: what is not named is what the printer names as its default, or what
// the bundle's section [presets] names. Throws Error: usage for an unknown name, bad_input where nothing says which
// printer is meant.
SlicerFile bundle_settings(const std::string& text, const NamedPresets& wanted);

// The settings of a preset's text with all that it inherits.
SlicerFile preset_settings(const std::string& text, const std::string& file);

} // namespace filum::app::filum
