// The text of a machine program.
#pragma once

#include "postproc/preset_job.hpp"
#include "postproc/wipe.hpp"
#include "postproc/writer.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace filum::postproc {

// Writes the program for the steps that `first_pass` was made of, moved by `shift`.
//
// Coordinates are whole multiples of the last decimal.  A word is written only if it changed.  A move that changes
// nothing is left out, and its material goes into the next one.  The extruder word is the difference of rounded totals,
// so rounding errors never add up, and no bead takes material back.  No move is shorter than toolpath::kLeastMove.  No
// number has an exponent.  The last line of comments says "end of program".
class Program final : public Writer {
  public:
    // `first_pass` must outlive the program.
    Program(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift, Text out);
    void begin(const std::vector<std::string>& about) override;
    void end(const std::vector<std::string>& history) override;

  private:
    void layer(const Step& step) override;
    void close(const Step& step) override;
    void retract() override;
    void prime() override;
    void change_tool(const Step& step) override;
    void purge(const Step& step) override;
    void push() override;
    void cut() override;
    void move(const Step& step) override;
    bool bead_words(const Step& step, const std::array<std::int64_t, 5>& to);
    void stand(const Step&) override {} // only robots have such steps
    bool words(const std::array<std::int64_t, 5>& to, std::string_view code);
    void begin_counting();
    void begin_axes();
    void end_axes();
    std::int64_t due();
    void material(std::int64_t units);
    void extruder_only(std::int64_t units, double speed);
    std::int64_t wipe(std::int64_t all);
    void feed(double mm_per_s);
    void feed(const Step& step, double way);
    void feed_units(double value);
    void bead_comments(const Step& step);
    void width_comment(const Step& step);
    void feature_codes(const Step& step);
    void reset_extruder();
    void line(const std::string& text);
    void wait(const Step& step);
    bool layer_values(const Step& step);
    void name_part(const Step& step);
    void tell_progress(const Step& step);

    Vec2 shift_;
    double xyz_scale_, degrees_scale_, e_scale_, f_scale_;
    std::array<std::int64_t, 5> at_; // x, y, z, tilt, turn as last written; units of the last decimal
    std::int64_t f_ = -1;            // F word as last written, in units of its last decimal; -1: unknown
    WipePath wipe_path_;             // in units of the last decimal
    double tilt_ = 0, turn_ = 0;     // rad, of the last step
    Vec3 stood_;                     // mm: the axes of the last step
    double laid_ = 0;                // extruder units of all beads so far, exact
    std::int64_t laid_units_ = 0;    // the same in units of the last decimal, as written
    bool counted_ = false;           // the program has set how extruder words count
    std::int64_t e_ = 0;             // the controller's extruder position, in units of the last decimal
    bool upper_ = false;             // the layer is above the first
    Role role_ = Role::travel;
    Feature feature_ = Feature::none;
    double acceleration_ = -1, fan_ = -1; // as last set for a feature; -1: unknown
    std::size_t layers_begun_ = 0;
    double layer_seconds_ = 0;      // s, duration of the current layer
    double width_ = 0, height_ = 0; // mm, as last written for viewers
    double unwritten_ = 0;          // mm of beads since then whose width differs
    std::uint64_t lines_ = 0;       // moves written
    void preset_code(const std::string& text);

    const FirstPass* planned_;
    std::unique_ptr<preset::Program> preset_; // null: the profile's own templates
    Step layer_;                              // the step that began the layer
    std::vector<LabelledPart> parts_;         // parts on the bed, with plain names
    std::vector<char> waited_;                // by pause: it was written
    std::int64_t part_ = -1;                  // the part begun last; -1: none
    std::vector<char> named_;                 // by part: its name was written
    Nominal nominal_;
    std::int64_t percent_ = -1, minutes_ = -1; // of the print, as last written
};

} // namespace filum::postproc
