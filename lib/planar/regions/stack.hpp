// The regions of a stack of layers, several layers at a time.
#pragma once

#include "regions/bodies.hpp"

#include <cstdint>
#include <deque>
#include <vector>

namespace filum::regions {

// Turns layers, from the bed up, into regions. The result does not depend on the number of threads. Holds the layers of
// one batch, and the regions of the layers below it on which layers may rest that are several layers high.
class Stack {
  public:
    Stack(const Options& options, int threads) : options_(options), threads_(threads) {}
    // Adds a layer, or one more body of the last one (with its index). Returns the regions of all layers that are done,
    // in their order, with ids counted from the first; none until a batch is full.
    std::vector<polygon::Region> add(polygon::Layer layer, Notes& notes);
    std::vector<polygon::Region> end(Notes& notes); // returns the regions of the remaining layers
    [[nodiscard]] const Air& air() const { return air_; }
    [[nodiscard]] const Gaps& gaps() const { return gaps_; } // between bodies

  private:
    std::vector<polygon::Region> done(Notes& notes);
    void number(std::vector<std::vector<polygon::Region>>& batch);
    [[nodiscard]] Ground ground(const std::vector<std::vector<polygon::Region>>& batch, std::size_t k,
                                std::int64_t index) const;
    void keep(std::vector<std::vector<polygon::Region>> batch);

    Options options_;
    int threads_;
    std::vector<std::vector<polygon::Layer>> waiting_; // per layer, its bodies
    std::deque<std::vector<polygon::Region>> below_;   // of the last layers that are done, at most kMostLayers
    std::int64_t last_ = -2;                           // index of the last of them
    std::int64_t first_ = -1;                          // lowest layer that a body of the stack occupies; -1: none yet
    bool coarse_ = false;                              // some layer was several layers high
    std::uint32_t next_id_ = 0;
    Air air_;
    Gaps gaps_;
};

} // namespace filum::regions
