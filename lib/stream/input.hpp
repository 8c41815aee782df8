// Bytes from a file, a pipe or memory, through one block of memory; private to lib/stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace filum::stream {

class Input {
  public:
    // Opens `path` ("-" or "": standard input).  Throws Error: io; usage if it is a terminal.
    explicit Input(const std::string& path);
    // Reads `bytes`, which must outlive it.
    Input(std::string_view bytes, std::string name);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    // 'part.layers' or standard input, for messages.
    [[nodiscard]] const std::string& name() const { return name_; }
    // How many bytes were dropped so far.
    [[nodiscard]] std::uint64_t offset() const { return offset_; }

    // The next `size` bytes (at most 64), or fewer at the end of the input; they stay the next ones until drop().
    std::string_view ahead(std::size_t size);
    void drop(std::size_t size);

    // Moves the next `size` bytes to the end of `to` and carries the checksum on over them; returns false if the input
    // ends before.  Takes memory only for bytes that really arrive.
    bool append(std::string& to, std::size_t size, std::uint32_t& crc);

  private:
    std::size_t refill(std::size_t from);
    std::string name_;
    int fd_ = -1;           // none: reads from memory
    std::string_view rest_; // of it
    std::unique_ptr<char[]> block_;
    std::size_t at_ = 0, filled_ = 0;
    std::uint64_t offset_ = 0;
};

} // namespace filum::stream
