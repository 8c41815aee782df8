// Writers of programs: G-code, or a robot's language.
#pragma once

#include "machine/template.hpp"
#include "postproc/first_pass.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace filum::postproc {

using Text = std::function<void(std::string_view)>;
// Opens the file `name` for a module of a program, and returns the function that writes to it.
using ModuleFile = std::function<Text(const std::string& name)>;

class Writer {
  public:
    virtual ~Writer() = default;
    virtual void begin(const std::vector<std::string>& about) = 0; // `about`: lines for the head, see about.hpp
    void add(std::span<const Step> steps);
    virtual void end(const std::vector<std::string>& history) = 0; // lines for the end

  protected:
    // One function per act whose text depends on the language.
    virtual void layer(const Step& step) = 0;
    virtual void open(const Step& step) { code(on(step)); }
    virtual void close(const Step& step) = 0;
    virtual void retract() = 0;
    virtual void prime() = 0;
    virtual void change_tool(const Step& step) = 0;
    virtual void purge(const Step&) {} // only machines with three axes have such steps
    virtual void push() = 0;
    virtual void cut() = 0;
    virtual void tension() { code(profile_->fibre.tension); }
    virtual void move(const Step& step) = 0;
    virtual void stand(const Step& step) = 0;

    Writer(const machine::Profile& profile, machine::Values values, Text out);
    void end_line() { text_ += profile_->format.crlf ? "\r\n" : "\n"; }
    void comment(std::string_view text);
    void code(const std::string& text); // writes codes of the profile, with placeholders replaced
    void spill();                       // hands the text on once it has the size of a block
    void flush();
    void redirect(Text out) { out_ = std::move(out); } // for later text; call flush() first
    void tool(const Step& step);                       // writes the codes that change to the step's tool
    [[nodiscard]] bool lays_fibre(const Step& step) const { return profile_->fibre.lays(step.tool); }
    // Codes before and after a stroke with the step's tool.
    [[nodiscard]] const std::string& on(const Step& step) const;
    [[nodiscard]] const std::string& off(const Step& step) const;
    // The triggers that do the same; "": none.
    [[nodiscard]] std::string on_trigger(const Step& step) const {
        return lays_fibre(step) ? "" : own(step).extrusion.on_trigger;
    }
    [[nodiscard]] std::string off_trigger(const Step& step) const {
        return lays_fibre(step) ? "" : own(step).extrusion.off_trigger;
    }
    // The material of a step: mm of fibre, or units of its tool's extruder.
    [[nodiscard]] double feeds(const Step& step) const {
        return lays_fibre(step) ? step.fed : step.volume * own(step).extrusion.per_mm3();
    }
    // The profile for the step's tool, and for the tool in use.
    [[nodiscard]] const machine::Profile& own(const Step& step) const { return machine::of_tool(*profile_, step.tool); }
    [[nodiscard]] const machine::Profile& own() const { return machine::of_tool(*profile_, tool_); }
    [[nodiscard]] bool counts() const { return own().extrusion.feeding != machine::Feeding::valve; }

    const machine::Profile* profile_;
    std::string text_;
    machine::Values values_; // of the placeholders

  private:
    std::uint32_t tool_ = 0; // the tool in use
    Text out_;
};

// The writer of the profile's dialect, for the steps that `first_pass` was made of, moved by `shift`.  Steps of robots
// are placed already, so `shift` is not used there.
// Throws Error(usage) if a robot's program needs more than one module and `modules` is empty.
std::unique_ptr<Writer> writer(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift, Text out,
                               ModuleFile modules = {});

} // namespace filum::postproc
