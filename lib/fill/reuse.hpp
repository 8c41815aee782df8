// Regions filled before: walls that stand upright give the same outlines on layer after layer.
#pragma once

#include "fill/fill.hpp"

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace filum::fill {

// Fills regions with the same options, by any number of threads.  Gives what fill() gives; of outlines that are equal
// to the last bit, and told apart by nothing but their layer, the first is worked out and the others take its curves.
// Holds up to `most` points of outlines and curves; what came first is forgotten first.
class Reuse {
  public:
    explicit Reuse(Options options, std::size_t most = kMost);

    // The same of another way to fill; `of_layer` is all that matters to it of a layer.
    using Work = std::function<toolpath::RegionPaths(const polygon::Region&, Notes&)>;
    using OfLayer = std::function<double(std::uint32_t layer)>;
    Reuse(Work work, OfLayer of_layer, std::size_t most = kMost)
        : work_(std::move(work)), of_layer_(std::move(of_layer)), most_(most) {}

    // As fill(region, options, notes), or the other way.
    toolpath::RegionPaths operator()(const polygon::Region& region, Notes& notes);

  private:
    static constexpr std::size_t kMost = std::size_t{1} << 20;
    struct Filled {
        std::uint64_t key = 0;
        polygon::Loops loops;
        double layer = 0; // what of the layer matters: the angle of rows, the shift of starts
        std::mutex mutex; // of what follows: who comes second waits, and takes what the first one made
        bool done = false;
        toolpath::RegionPaths paths;
        Notes notes;
        std::size_t points = 0;
    };
    std::shared_ptr<Filled> find(const polygon::Region& region); // or begins it
    void work_out(const polygon::Region& region, const std::shared_ptr<Filled>& filled);
    void hold(const std::shared_ptr<Filled>& filled);

    Work work_;
    OfLayer of_layer_;
    std::size_t most_, held_ = 0; // points
    std::mutex mutex_;
    std::unordered_map<std::uint64_t, std::shared_ptr<Filled>> filled_; // only ever asked for one key
    std::deque<std::shared_ptr<Filled>> done_;                          // in the order they were worked out
};

} // namespace filum::fill
