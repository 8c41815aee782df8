// Keeps frames for a second reading: in memory up to a limit, beyond it in a temporary file without a name.
#pragma once

#include "stream/frame.hpp"

#include <memory>
#include <optional>

namespace filum::stream {

class Spool {
  public:
    static constexpr std::size_t kMemory = std::size_t{48} << 20; // bytes

    // `memory`: the bytes kept in memory before a file (in $TMPDIR, else /tmp) is used.
    explicit Spool(std::size_t memory = kMemory);
    ~Spool();
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    // Adds a frame. Throws Error(io) if the file cannot be written.
    void add(RawFrame frame);
    // Returns the next frame, in the order of adding; none after the last. No frame can be added after the first call.
    // Throws Error(io).
    std::optional<RawFrame> next();
    // Makes the first frame the next one again.
    void rewind();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::stream
