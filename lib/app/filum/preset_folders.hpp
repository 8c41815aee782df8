// Where slicers keep presets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::app::filum {

enum class PresetKind : std::uint8_t { printer, print, filament };
inline constexpr std::size_t kPresetKinds = 3;

// "printer"
const char* name_of(PresetKind kind);
// The kind by the name of a section, a folder or a JSON type: "printer" or "machine", "print" or "process", "filament".
std::optional<PresetKind> kind_of(std::string_view word);

// Files of presets: those beside one file, and those in the folders of PrusaSlicer, SuperSlicer, OrcaSlicer and Bambu
// Studio, of the user's and of the installed program.  $FILUM_PRESETS names further folders, with ':' between.
class PresetFolders {
  public:
    // `beside`: a file, or "".
    explicit PresetFolders(std::string beside) : beside_(std::move(beside)) {}

    // The file that holds the preset of that name; of several the nearest in the tree of folders.
    std::optional<std::string> find(PresetKind kind, const std::string& name);
    // All bundles, and all files of that kind.
    const std::vector<std::string>& bundles();
    std::vector<std::string> files(PresetKind kind);

  private:
    struct Place {
        std::optional<PresetKind> kind; // nothing says which: any
        std::filesystem::path file;
    };
    void scan();
    void scan_folder(const std::filesystem::path& folder, bool deep);
    void add(const std::filesystem::path& file, const std::filesystem::path& root);

    std::string beside_;
    bool scanned_ = false;
    std::size_t entries_ = 0; // seen so far
    std::multimap<std::string, Place> places_;
    std::vector<std::string> bundles_;
};

} // namespace filum::app::filum
