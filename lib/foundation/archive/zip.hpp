// Reads and writes zip archives in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace filum::archive {

class Zip {
  public:
    // Where names and sizes come from.  An archive states them twice: in its directory, and before each entry.
    enum class Names : std::uint8_t { of_directory, of_both_places }; // the latter must agree

    // `bytes` must outlive this object; `name` is for messages. Throws Error(bad_input) if they are not a complete
    // archive.
    Zip(std::string_view bytes, std::string name, Names names = Names::of_directory);
    ~Zip();
    Zip(const Zip&) = delete;
    Zip& operator=(const Zip&) = delete;

    // True if `bytes` begin like a zip archive.
    static bool begins(std::string_view bytes);

    // True if the archive has this entry.  Names are compared without regard to case and without a leading '/'.
    [[nodiscard]] bool has(const std::string& path) const;
    // The names of all entries, in their order.
    [[nodiscard]] std::vector<std::string> entries() const;
    // The content of an entry. Throws Error(bad_input) if it is missing or damaged. Also throws if all entries read so
    // far exceed kMost, as a small archive can expand to terabytes.
    std::string read(std::string path);

  private:
    static constexpr std::size_t kMost = std::size_t{1} << 29; // bytes
    [[noreturn]] void bad(const std::string& why) const;
    struct Handle;
    std::unique_ptr<Handle> handle_;
    std::string name_;
    std::size_t taken_ = 0;
};

// The bytes of an archive with these files, in this order: pairs of path and content. Entries are deflated. Equal files
// give equal bytes: every entry is dated 1 January 1980, the first day of the format. Throws Error(failure) if memory
// runs out.
std::string zipped(const std::vector<std::pair<std::string, std::string>>& files);

} // namespace filum::archive
