// Strokes of continuous fibre: where they are anchored and cut, and which are too short or too long to lay.
#pragma once

#include "postproc/walk.hpp"

namespace filum::postproc {

// Throws Error(bad_input) naming the place if the profile cannot change to the span's tool.
void check_tool(const machine::Profile& profile, const toolpath::Span& span);

// Prepares fibre strokes for another walker, to which it hands everything on.  Spans of other tools pass unchanged.
//
// A fibre stroke is all that the fibre's tool lays between two travels.  It is kept until its end, then handed on in
// pieces, as machine::stretches divides it by arc length of the tip's path.  The cut is cut_to_nozzle before the end.
// Each division gets a point of its own, unless a point of the path is within 0.001 mm.
//
// A stroke shorter than least_path is left out: the step Act::omit reports it.  The travels before and after it become
// one travel, which leads over its place.
// A change of tool without a travel gets a travel of no length.  A travel gets the tool of the next stroke.
// Throws Error(failure) with the place of a stroke longer than most_path, and throws as check_tool does.
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
    std::vector<toolpath::Span> travels_; // since the last stroke; spans that extrude are omitted fibre
    std::vector<toolpath::Span> stroke_;  // the fibre stroke being collected
    machine::Stretch how_;                // of the next piece
    std::uint32_t tool_ = 0;
    bool begun_ = false; // something was handed on
};

} // namespace filum::postproc
