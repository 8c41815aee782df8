// The text of a machine program.
#pragma once

#include "postproc/preset_job.hpp"
#include "postproc/writer.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace filum::postproc {

// Writes the program of the steps that `first_pass` was made of, moved by `shift`.
//
// Coordinates are whole multiples of the last decimal; a word is written only if it changed, a move that changes
// nothing is left out and its material goes into the next one.  The extruder word is the difference of rounded totals,
// so rounding never adds up and never takes back.  No move is shorter than toolpath::kLeastMove.  No number has an
// exponent.  The last line says "end of program".
class Program final : public Writer {
  public:
    // `first_pass` must live as long.
    Program(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift, Text out);
    void begin(const std::vector<std::string>& about) override;
    void end(const std::vector<std::string>& history) override;

  private:
    void layer(const Step& step) override;
    void close(const Step& step) override;
    void retract() override;
    void prime() override;
    void change_tool(const Step& step) override;
    void push() override;
    void cut() override;
    void move(const Step& step) override;
    bool bead_words(const Step& step, const std::array<std::int64_t, 5>& to);
    void stand(const Step&) override {} // of robots only
    bool words(const std::array<std::int64_t, 5>& to, std::string_view code);
    void begin_counting();
    void begin_axes();
    void end_axes();
    std::int64_t due();
    void material(std::int64_t units);
    void extruder_only(std::int64_t units, double speed);
    void feed(double mm_per_s);
    void feed(const Step& step, double way);
    void feed_units(double value);
    void bead_comments(const Step& step);
    void feature_codes(const Step& step);
    void reset_extruder();
    void line(const std::string& text);
    void wait(const Step& step);
    bool layer_values(const Step& step);
    void name_part(const Step& step);
    void tell_progress(const Step& step);

    Vec2 shift_;
    double xyz_scale_, degrees_scale_, e_scale_, f_scale_;
    std::array<std::int64_t, 5> at_; // x, y, z, tilt, turn as last written, in units of the last decimal
    std::int64_t f_ = -1;            // likewise
    double tilt_ = 0, turn_ = 0;     // rad, of the step before
    Vec3 stood_;                     // likewise, mm: its axes
    double laid_ = 0;                // extruder units of the bead so far, exact
    std::int64_t laid_units_ = 0;    // the same as written
    bool counted_ = false;           // the controller was told how extruder words count
    std::int64_t e_ = 0;             // where the controller believes the extruder to be
    bool upper_ = false;             // the layer is above the first
    Role role_ = Role::travel;
    Feature feature_ = Feature::none;
    double acceleration_ = -1, fan_ = -1; // as last told to the machine for a feature; -1: not yet
    std::size_t layers_begun_ = 0;
    double layer_seconds_ = 0;      // that the layer takes, as long as the program stays on it
    double width_ = 0, height_ = 0; // as last told to viewers
    std::uint64_t lines_ = 0;       // moves written
    void preset_code(const std::string& text);

    const FirstPass* planned_;
    std::unique_ptr<preset::Program> preset_; // null: the profile's own templates
    Step layer_;                              // that began the layer
    std::vector<Labelled> parts_;             // on the bed, under names that a program can hold
    std::uint64_t waited_ = 0;                // pauses written
    std::int64_t part_ = -1;                  // that the machine was told
    std::vector<char> named_;                 // parts that were told by name
    Nominal nominal_;
    std::int64_t percent_ = -1, minutes_ = -1; // as last told
};

} // namespace filum::postproc
