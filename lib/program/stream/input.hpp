// Reads bytes from a file, a pipe or memory, through one block of memory; private to lib/program/stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace filum::stream {

class Input {
  public:
    // Opens `path` ("-" or "": standard input). Throws Error: io if it cannot be opened, usage if it is a terminal.
    explicit Input(const std::string& path);
    // Reads from `bytes`, which must outlive this object; `name` is for messages.
    Input(std::string_view bytes, std::string name);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    // The name of the input in messages: 'part.layers' or standard input.
    [[nodiscard]] const std::string& name() const { return name_; }
    // The number of bytes dropped or moved out so far.
    [[nodiscard]] std::uint64_t offset() const { return offset_; }

    // Returns the next `size` bytes (at most 64), or fewer at the end of the input. They are not consumed until drop().
    std::string_view ahead(std::size_t size);
    void drop(std::size_t size);

    // Moves the next `size` bytes to the end of `to` and continues the checksum `crc` over them. Returns false if the
    // input ends before. Memory is used only for bytes that arrive.
    bool append(std::string& to, std::size_t size, std::uint32_t& crc);

  private:
    std::size_t refill(std::size_t from);
    std::string name_;
    int fd_ = -1;           // -1: reads from memory
    std::string_view rest_; // the bytes in memory that are still to be read
    std::unique_ptr<char[]> block_;
    std::size_t at_ = 0, filled_ = 0;
    std::uint64_t offset_ = 0;
};

} // namespace filum::stream
