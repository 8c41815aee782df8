// Files in a zip archive in memory: reading and writing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace filum::archive {

class Zip {
  public:
    // An archive states names and sizes twice: in its directory, and before each entry.
    enum class Names : std::uint8_t { of_directory, of_both_places }; // the latter must agree

    // `bytes` must live as long as this; `name` is for messages.  Throws Error(bad_input) if they are no whole archive.
    Zip(std::string_view bytes, std::string name, Names names = Names::of_directory);
    ~Zip();
    Zip(const Zip&) = delete;
    Zip& operator=(const Zip&) = delete;

    // True for bytes that begin as an archive does.
    static bool begins(std::string_view bytes);

    // Names without regard to case; a leading '/' does not count.
    [[nodiscard]] bool has(const std::string& path) const;
    // The first entry whose name `fits`; "" if there is none.
    [[nodiscard]] std::string find(const std::function<bool(std::string_view)>& fits) const;
    // The content of an entry.  Throws Error(bad_input) if it is missing or damaged, and where all that was read comes
    // to more than kMost: a small archive can hold terabytes.
    std::string read(std::string path);

  private:
    static constexpr std::size_t kMost = std::size_t{1} << 29; // bytes
    [[noreturn]] void bad(const std::string& why) const;
    struct Handle;
    std::unique_ptr<Handle> handle_;
    std::string name_;
    std::size_t taken_ = 0;
};

// The bytes of an archive with these files, deflated, in this order: pairs of a path and a content.  Equal files give
// equal bytes: every entry is dated 1 January 1980, the first day that the format knows.  Throws Error(failure) if
// memory runs out.
std::string zipped(const std::vector<std::pair<std::string, std::string>>& files);

} // namespace filum::archive
