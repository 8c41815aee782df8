// Strokes of continuous fibre: where they are anchored and cut, and which cannot be laid.
#pragma once

#include "postproc/walk.hpp"

namespace filum::postproc {

// Throws Error(bad_input) naming the place if the profile cannot change to the span's tool.
void check_tool(const machine::Profile& profile, const toolpath::Span& span);

// Stands before another walker.  Strokes of other tools pass as they are.  One of fibre is whatever is laid between two
// travels by the fibre's tool; it is kept until its end and handed on in pieces, as machine::stretches cuts it by arc
// length of the tip's path: the cut at cut_to_nozzle from the end, in a point of its own unless one of the path's is
// within 0.001 mm.  One shorter than least_path is left out: the step Act::omit tells of it, and the travels before and
// after it become one, which leads over its place.
// Where the tool changes without a travel, one of no length is put in.  Travels get the tool of the stroke behind them.
// Throws Error(failure) naming the place of a stroke above most_path, and as check_tool does.
class FibreWalk final : public Walker {
  public:
    FibreWalk(const machine::Profile& profile, std::unique_ptr<Walker> inner, Steps out);
    void end() override;
    [[nodiscard]] const Efforts& efforts() const override { return inner_->efforts(); }

  private:
    void travel(const toolpath::Span& span) override;
    void extrude(const toolpath::Span& span) override;
    void release(std::uint32_t tool);
    void finish();
    void lay(double length);
    void hand_on(const toolpath::Span& piece, bool halt);

    const machine::Profile* profile_;
    std::unique_ptr<Walker> inner_;
    Steps out_;
    std::vector<toolpath::Span> travels_; // since the last stroke; those that extrude are fibre that is left out
    std::vector<toolpath::Span> stroke_;  // of fibre, still open
    machine::Stretch how_;                // of the piece that comes next
    std::uint32_t tool_ = 0;
    bool begun_ = false; // something was handed on
};

} // namespace filum::postproc
