// Several toolpaths as one.
#pragma once

#include "toolpath/path.hpp"

#include <vector>

namespace filum::assemble {

struct Options {
    double lift = 5; // mm: along the tool axis, of travels from one toolpath to the next
    // Tool of each toolpath in turn, the last one also of all that follow; none: they keep their own.
    std::vector<double> tools{};
};

// Takes the spans of toolpaths in their order and gives back those of the job.
class Job {
  public:
    explicit Job(const Options& options) : o_(options) {}

    // The next toolpath begins.
    void begin();

    // The span with its stroke numbered on from the toolpaths before; the first one of a toolpath behind a travel from
    // where the last one ended: up along the tool axis there, across, and down along the axis here.
    std::vector<toolpath::Span> add(toolpath::Span span);

  private:
    Options o_;
    std::size_t begun_count_ = 0;        // toolpaths
    std::uint32_t first_ = 0, next_ = 0; // strokes: of this toolpath, and behind the greatest
    bool fresh_ = false, begun_ = false;
    geom::Vec3 at_, axis_{0, 0, 1};
};

} // namespace filum::assemble
