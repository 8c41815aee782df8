// What writes a program: of a machine tool's codes, or a robot's language.
#pragma once

#include "machine/template.hpp"
#include "postproc/survey.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace filum::postproc {

using Text = std::function<void(std::string_view)>;

class Writer {
  public:
    virtual ~Writer() = default;
    virtual void begin(const std::vector<std::string>& about) = 0; // `about`: lines for the head, see about.hpp
    void add(std::span<const Step> steps);
    virtual void end() = 0;

  protected:
    // What a step becomes, where languages differ.
    virtual void layer(const Step& step) = 0;
    virtual void close(const Step& step) = 0;
    virtual void retract() = 0;
    virtual void prime() = 0;
    virtual void change_tool(const Step& step) = 0;
    virtual void push() = 0;
    virtual void cut() = 0;
    virtual void move(const Step& step) = 0;

    Writer(const machine::Profile& profile, machine::Values values, Text out);
    void end_line() { text_ += profile_->format.crlf ? "\r\n" : "\n"; }
    void comment(std::string_view text);
    void code(const std::string& text); // of the profile, its placeholders filled in
    void spill();                       // hands the text on when it has grown to a block
    void flush();
    void tool(const Step& step); // the codes that change to it
    [[nodiscard]] bool lays_fibre(const Step& step) const { return profile_->fibre.lays(step.tool); }
    // Codes before and after a stroke.
    [[nodiscard]] const std::string& on(const Step& step) const;
    [[nodiscard]] const std::string& off(const Step& step) const;
    // What a step feeds, in units of its tool's extruder.
    [[nodiscard]] double feeds(const Step& step) const { return lays_fibre(step) ? step.fed : step.volume * per_mm3_; }
    [[nodiscard]] bool counts() const { return profile_->extrusion.feeding != machine::Feeding::valve; }

    const machine::Profile* profile_;
    std::string text_;
    machine::Values values_; // of the placeholders

  private:
    double per_mm3_;
    Text out_;
};

// Of the profile's dialect, for the steps that `survey` was made of, moved by `shift` (robots: placed already).
std::unique_ptr<Writer> writer(const machine::Profile& profile, const Survey& survey, Vec2 shift, Text out);

} // namespace filum::postproc
