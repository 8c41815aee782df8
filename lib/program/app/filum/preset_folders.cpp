#include "app/filum/preset_folders.hpp"

#include "app/filum/slicer_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace filum::app::filum {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostEntries = 100'000; // most entries of folders that are scanned; OrcaSlicer has 20,000 presets
constexpr const char* kLibrary = "OrcaFilamentLibrary"; // OrcaSlicer's folder of filaments for all vendors
constexpr int kDeepestFolder = 6; // most levels of folders that are scanned below a folder of presets

std::string from_environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// The folders in which slicers keep presets: those of FILUM_PRESETS, then the user's, then those of installed programs.
std::vector<fs::path> kept_folders() {
    std::vector<fs::path> out;
    std::istringstream own(from_environment("FILUM_PRESETS"));
    for (std::string folder; std::getline(own, folder, ':');)
        if (!folder.empty())
            out.push_back((fs::path(folder) / "x").lexically_normal().parent_path()); // no '/' at its end
    const fs::path home = from_environment("HOME");
    const std::string config = from_environment("XDG_CONFIG_HOME");
    constexpr std::pair<const char*, const char*> kSlicers[] = {{"PrusaSlicer", "com.prusa3d.PrusaSlicer"},
                                                                {"SuperSlicer", ""},
                                                                {"OrcaSlicer", "io.github.softfever.OrcaSlicer"},
                                                                {"OrcaSlicer", "com.orcaslicer.OrcaSlicer"},
                                                                {"BambuStudio", "com.bambulab.BambuStudio"}};
    for (const auto& [name, flatpak] : kSlicers) {
        if (!config.empty() || !home.empty())
            out.push_back((config.empty() ? home / ".config" : fs::path(config)) / name);
        if (*flatpak != '\0' && !home.empty()) out.push_back(home / ".var" / "app" / flatpak / "config" / name);
    }
    for (const auto& [name, flatpak] : kSlicers)
        for (const char* share : {"/usr/share", "/usr/local/share", "/opt"}) {
            out.push_back(fs::path(share) / name / "profiles");
            out.push_back(fs::path(share) / name / "resources" / "profiles");
        }
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

// The number of folders that two paths share, from the root on.
std::size_t shared_folders(const fs::path& a, const fs::path& b) {
    const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
    return static_cast<std::size_t>(std::distance(a.begin(), end));
}

// The folder of a preset's vendor: the one above the folder of its kind; "" if there is none.
fs::path vendor_folder(const fs::path& file) {
    for (fs::path at = file.parent_path(); at.has_filename(); at = at.parent_path())
        if (kind_of(at.filename().string())) return at.parent_path();
    return {};
}

} // namespace

const char* name_of(PresetKind kind) {
    constexpr const char* kNames[kPresetKinds] = {"printer", "print", "filament"};
    return kNames[static_cast<std::size_t>(kind)];
}

std::optional<PresetKind> kind_of(std::string_view word) {
    if (word == "printer" || word == "machine") return PresetKind::printer;
    if (word == "print" || word == "process") return PresetKind::print;
    if (word == "filament") return PresetKind::filament;
    return std::nullopt;
}

// A preset lies in a folder of its kind, or in a folder below that.  An .ini file elsewhere is a vendor's bundle.
void PresetFolders::add(const fs::path& file, const fs::path& root) {
    const bool ini = file.extension() == ".ini";
    if (!ini && file.extension() != ".json") return;
    std::optional<PresetKind> kind;
    for (fs::path at = file.parent_path(); !kind && shared_folders(at, root) >= shared_folders(root, root);
         at = at.parent_path()) {
        kind = kind_of(at.filename().string());
        if (at == root || at == at.parent_path()) break;
    }
    const bool is_beside = !beside_.empty() && file.parent_path() == fs::absolute(beside_).parent_path();
    if (kind || is_beside)
        places_.emplace(file.stem().string(), Place{kind, file});
    else if (ini)
        bundles_.push_back(file.string());
}

void PresetFolders::scan_folder(const fs::path& folder, bool deep) {
    std::error_code none;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, none);
    const fs::recursive_directory_iterator end;
    std::vector<fs::path> files;
    while (!none && at != end && entries_ < kMostEntries) {
        ++entries_;
        if (at->is_directory(none) && (!deep || at.depth() >= kDeepestFolder)) at.disable_recursion_pending();
        if (at->is_regular_file(none)) files.push_back(at->path());
        at.increment(none);
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) add(file, folder);
}

// If `beside_` lies in a folder of its kind, that folder holds presets of the same vendor.  The folder two levels above
// holds the vendor's other kinds, and other vendors.
void PresetFolders::scan() {
    if (scanned_) return;
    scanned_ = true;
    if (!beside_.empty()) {
        const fs::path folder = fs::absolute(beside_).lexically_normal().parent_path();
        fs::path kind = folder;
        while (!kind_of(kind.filename().string()) && kind != kind.parent_path()) kind = kind.parent_path();
        const bool sorted = kind_of(kind.filename().string()).has_value();
        scan_folder(sorted ? kind : folder, sorted);
        if (sorted) scan_folder(kind.parent_path().parent_path(), true);
    }
    for (const fs::path& folder : kept_folders()) scan_folder(folder, true);
}

const PresetFolders::Place* PresetFolders::nearest(const std::vector<const Place*>& places, PresetKind kind,
                                                   const fs::path& from) {
    const Place* best = nullptr;
    for (const Place* place : places) {
        if ((place->kind && *place->kind != kind) || place->file == from) continue;
        if (best == nullptr || shared_folders(place->file, from) > shared_folders(best->file, from)) best = place;
    }
    return best;
}

std::vector<const PresetFolders::Place*> PresetFolders::in_vendor(const fs::path& vendor, const std::string& name) {
    std::vector<const Place*> out;
    const auto [begin, end] = places_.equal_range(name);
    for (auto at = begin; at != end; ++at)
        if (vendor_folder(at->second.file) == vendor) out.push_back(&at->second);
    if (!out.empty()) return out;
    const auto [names, fresh] = names_.try_emplace(vendor);
    if (fresh)
        for (const auto& [stem, place] : places_) {
            if (place.file.extension() != ".json" || vendor_folder(place.file) != vendor) continue;
            const auto settings = json_settings(content_of(place.file.string()));
            if (const SlicerSetting* own = find_setting(settings, "name"); own != nullptr)
                names->second.emplace(own->value, &place);
        }
    const auto [first, last] = names->second.equal_range(name);
    for (auto at = first; at != last; ++at) out.push_back(at->second);
    return out;
}

std::optional<std::string> PresetFolders::find(PresetKind kind, const std::string& name, const std::string& from) {
    scan();
    const std::string& file = from.empty() ? beside_ : from;
    const fs::path own = file.empty() ? fs::path() : fs::absolute(file).lexically_normal();
    const Place* best = nullptr;
    if (const fs::path vendor = vendor_folder(own); !vendor.empty())
        for (const fs::path& folder : {vendor, vendor.parent_path() / kLibrary})
            if (best == nullptr) best = nearest(in_vendor(folder, name), kind, own);
    std::vector<const Place*> all;
    const auto [begin, end] = places_.equal_range(name);
    for (auto at = begin; at != end; ++at) all.push_back(&at->second);
    if (best == nullptr) best = nearest(all, kind, own);
    if (best == nullptr) return std::nullopt;
    return best->file.string();
}

const std::vector<std::string>& PresetFolders::bundles() {
    scan();
    return bundles_;
}

std::vector<std::string> PresetFolders::files(PresetKind kind) {
    scan();
    std::vector<std::string> out;
    for (const auto& [name, place] : places_)
        if (place.kind == kind) out.push_back(place.file.string());
    return out;
}

} // namespace filum::app::filum
