// Frames kept for a second reading: in memory up to a limit, beyond it in a temporary file without a name.
#pragma once

#include "stream/frame.hpp"

#include <memory>
#include <optional>

namespace filum::stream {

class Spool {
  public:
    static constexpr std::size_t kMemory = std::size_t{48} << 20; // bytes

    // `memory`: how much may be kept before the file (in $TMPDIR, else /tmp) is used.
    explicit Spool(std::size_t memory = kMemory);
    ~Spool();
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    // Throws Error(io) if the file cannot be written.
    void add(RawFrame frame);
    // Frames in the order they were added; the first call ends the adding.  Throws Error(io).
    std::optional<RawFrame> next();
    // The next one is the first again.
    void rewind();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace filum::stream
