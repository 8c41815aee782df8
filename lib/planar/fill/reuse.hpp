// Reuses fills of equal regions: upright walls have the same outlines on layer after layer.
#pragma once

#include "fill/fill.hpp"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace filum::fill {

// Fills regions with the same options, from any number of threads. Results are those of fill(). Of regions whose
// outlines, walls and areas are equal to the last bit and that differ only by their layer, the first is filled and the
// others get its curves. The height counts only for waves, which depend on it.
//
// Keeps up to `most` points of outlines, areas and curves; the oldest results go first.
class Reuse {
  public:
    explicit Reuse(Options options, std::size_t most = kMost);

    // Uses `work` instead of fill(). `of_layer` gives the number that is all that `work` depends on in a layer.
    using Work = std::function<toolpath::RegionPaths(const polygon::Region&, Notes&)>;
    using OfLayer = std::function<double(std::uint32_t layer)>;
    Reuse(Work work, OfLayer of_layer, std::size_t most = kMost)
        : work_(std::move(work)), of_layer_(std::move(of_layer)), most_(most) {}

    // The paths and notes of `region`, from fill() or `work`; notes get the layer of the region.
    toolpath::RegionPaths operator()(const polygon::Region& region, Notes& notes);

  private:
    static constexpr std::size_t kMost = std::size_t{1} << 20;
    struct CachedFill {
        std::uint64_t key = 0;
        polygon::Region region;
        double layer = 0; // what the result depends on in a layer: the angle of rows, the shift of starts
        std::mutex mutex; // guards the members below: a second thread waits for the result of the first
        bool done = false;
        toolpath::RegionPaths paths;
        Notes notes;
        std::size_t points = 0;
    };
    std::shared_ptr<CachedFill> find(const polygon::Region& region); // adds an entry if there is none
    void work_out(const polygon::Region& region, const std::shared_ptr<CachedFill>& filled);
    void hold(const std::shared_ptr<CachedFill>& filled);

    Work work_;
    OfLayer of_layer_;
    std::size_t most_, held_ = 0; // points
    std::mutex mutex_;
    std::unordered_map<std::uint64_t, std::shared_ptr<CachedFill>> filled_; // looked up by key, never traversed
    std::deque<std::shared_ptr<CachedFill>> done_;                          // oldest result first
};

// Fills of regions with bead widths of their own: one Reuse for each width. Can be used from any number of threads.
class ReuseByWidth {
  public:
    // `make` returns the fills for a bead width in mm.
    explicit ReuseByWidth(std::function<Reuse(double)> make) : make_(std::move(make)) {}
    Reuse& of(double width);

  private:
    std::function<Reuse(double)> make_;
    std::mutex mutex_;
    std::map<double, std::unique_ptr<Reuse>> fills_;
};

} // namespace filum::fill
