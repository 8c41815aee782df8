// The folders in which slicers keep presets.
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

// The name of the kind, such as "printer".
const char* name_of(PresetKind kind);
// The kind that a word names: "printer" or "machine", "print" or "process", "filament"; none for another word.  The
// word is the name of a section or of a folder, or the type of a JSON object.
std::optional<PresetKind> kind_of(std::string_view word);

// Files of presets: those beside one file, and those that PrusaSlicer, SuperSlicer, OrcaSlicer and Bambu Studio keep.
// Each slicer has a folder of the user's and one of the installed program.  $FILUM_PRESETS names further folders, with
// ':' between.
class PresetFolders {
  public:
    // `beside`: the file whose neighbours are presets, too, or "".
    explicit PresetFolders(std::string beside) : beside_(std::move(beside)) {}

    // The file of the preset `name` as `from` means it, a file that inherits from it ("": `beside`); none if there is
    // no such file.  A preset of the same vendor comes first, by the name of its file, then by the name in its JSON;
    // then the same in the library that all vendors of OrcaSlicer share; then any other.  Of several the one that
    // shares most folders with `from`; of equals the one that was found first.
    std::optional<std::string> find(PresetKind kind, const std::string& name, const std::string& from = "");
    // All bundles: files that hold many presets.
    const std::vector<std::string>& bundles();
    // All files that hold one preset of the kind.
    std::vector<std::string> files(PresetKind kind);

  private:
    struct Place {
        std::optional<PresetKind> kind; // none: unknown, fits every kind
        std::filesystem::path file;
    };
    void scan();
    void scan_folder(const std::filesystem::path& folder, bool deep);
    void add(const std::filesystem::path& file, const std::filesystem::path& root);
    static const Place* nearest(const std::vector<const Place*>& places, PresetKind kind,
                                const std::filesystem::path& from);
    // The presets of a vendor's folder with that name.
    std::vector<const Place*> in_vendor(const std::filesystem::path& vendor, const std::string& name);

    std::string beside_;
    bool scanned_ = false;
    std::size_t entries_ = 0; // of folders, scanned so far
    std::multimap<std::string, Place> places_;
    std::map<std::filesystem::path, std::multimap<std::string, const Place*>> names_; // in JSON, of vendors asked for
    std::vector<std::string> bundles_;
};

} // namespace filum::app::filum
