#include "app/postproc/program_file.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>

namespace filum::app::postproc {

namespace {

constexpr double kCubicMm = 1000; // mm3 per cm3
constexpr double kMmPerM = 1000;

// The duration as PrusaSlicer writes it, such as "2h 5m 7s".
std::string duration(double seconds) {
    const auto s = static_cast<long long>(std::llround(seconds));
    std::string out;
    if (s >= 3600) out += std::to_string(s / 3600) + "h ";
    if (s >= 60) out += std::to_string(s / 60 % 60) + "m ";
    return out + std::to_string(s % 60) + "s";
}

// The text with blanks instead of line ends, since a value in a table has one line.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

// Fills the tables of binary G-code.
void describe_binary(bgcode::File& file, const machine::Profile& profile, const filum::postproc::FirstPass& first_pass,
                     const std::vector<filum::postproc::Stage>& stages) {
    const auto used = filum::postproc::used(profile, first_pass);
    bgcode::Table takes;
    if (profile.extrusion.feeding == machine::Feeding::filament)
        takes.emplace_back("filament used [mm]", fixed_text(used.units, 2));
    takes.emplace_back("filament used [cm3]", fixed_text(used.volume / kCubicMm, 2));
    takes.emplace_back("estimated printing time (normal mode)", duration(first_pass.seconds));
    file.about = {{"Producer", "Filum"}};
    file.printer = {{"printer_model", one_line(profile.name)}};
    for (const auto& [key, name] : {std::pair{"temperature", "nozzle_temp"}, {"bed_temperature", "bed_temp"}})
        if (const auto value = profile.values.find(name); value != profile.values.end())
            file.printer.emplace_back(key, shortest_text(value->second));
    file.printer.emplace_back("max_layer_z", fixed_text(first_pass.part_high[2], 2));
    file.printer.insert(file.printer.end(), takes.begin(), takes.end());
    file.print = takes;
    if (profile.extrusion.feeding == machine::Feeding::filament)
        file.slicer.emplace_back("filament_diameter", shortest_text(profile.extrusion.diameter));
    for (const auto& stage : stages)
        for (const auto& [name, value] : stage.settings)
            file.slicer.emplace_back("filum_" + stage.program + "_" + name, one_line(value));
}

// The parts on the plate: those with a name, or else the box of everything printed.
std::vector<archive::PlatePart> plate_parts(const filum::postproc::FirstPass& first_pass, geom::Vec2 shift) {
    std::vector<archive::PlatePart> out;
    for (const auto& part : first_pass.parts) {
        geom::Box2 box;
        for (const geom::Vec2& p : part.outline) box.add(p + shift);
        out.push_back({one_line(part.name), {box.lo.x, box.lo.y, box.hi.x, box.hi.y}});
    }
    const auto &lo = first_pass.part_low, &hi = first_pass.part_high;
    if (out.empty()) out.push_back({"part", {lo[0] + shift.x, lo[1] + shift.y, hi[0] + shift.x, hi[1] + shift.y}});
    return out;
}

std::vector<archive::FilamentUse> filament_uses(const machine::Profile& profile,
                                                const filum::postproc::FirstPass& first_pass) {
    std::vector<archive::FilamentUse> out;
    for (const auto& [number, tool] : first_pass.tools) {
        if (tool.fibre || tool.volume == 0) continue;
        const auto& e = machine::of_tool(profile, number).extrusion;
        const double length = e.feeding == machine::Feeding::filament ? tool.volume * e.per_mm3() / kMmPerM : 0;
        out.push_back({static_cast<int>(number), length, tool.volume * e.flow / kCubicMm * e.density});
    }
    return out;
}

} // namespace

ProgramFile::Form ProgramFile::form_of(const std::string& path, const machine::Profile& profile) {
    const std::string fault = "cannot write '" + path + "': ";
    const bool print_file = path.ends_with(".gcode.3mf");
    if (path.ends_with(".3mf") && !print_file)
        throw Error(Exit::usage, fault + "a program in a 3MF archive is named part.gcode.3mf");
    if (!print_file && !path.ends_with(".bgcode")) return Form::text;
    if (profile.format.dialect != machine::Dialect::gcode)
        throw Error(Exit::usage, fault + "'" + profile.name + "' reads no G-code; choose another ending");
    return print_file ? Form::print_file : Form::binary;
}

ProgramFile::ProgramFile(const std::string& path, const machine::Profile& profile)
    : form_(form_of(path, profile)),
      sink_(path, form_ == Form::text ? stream::Sink::Content::text : stream::Sink::Content::binary) {}

std::vector<PictureSize> ProgramFile::own_pictures() const {
    if (form_ != Form::print_file) return {};
    return {{archive::kPlatePicture, archive::kPlatePicture},
            {archive::kSmallPlatePicture, archive::kSmallPlatePicture}};
}

void ProgramFile::write(std::string_view text) {
    switch (form_) {
    case Form::text:
        sink_.write(text);
        break;
    case Form::binary:
        file_.gcode += text;
        break;
    case Form::print_file:
        print_file_.gcode += text;
        break;
    }
}

void ProgramFile::describe(const machine::Profile& profile, const filum::postproc::FirstPass& first_pass,
                           geom::Vec2 shift, const std::vector<filum::postproc::Stage>& stages) {
    if (form_ == Form::binary) describe_binary(file_, profile, first_pass, stages);
    if (form_ != Form::print_file) return;
    archive::PrintFile& f = print_file_;
    f.printer = profile.name;
    f.layer_height = first_pass.layers > 0 ? first_pass.part_high[2] / first_pass.layers : 0;
    f.seconds = first_pass.seconds;
    f.supports = std::ranges::any_of(stages, [](const auto& stage) { return stage.program == "supports"; });
    f.parts = plate_parts(first_pass, shift);
    f.filaments = filament_uses(profile, first_pass);
}

void ProgramFile::add(const PictureSize& size, const std::string& png) {
    if (form_ == Form::print_file)
        (print_file_.picture.empty() ? print_file_.picture : print_file_.small_picture) = png;
    else
        file_.thumbnails.push_back({bgcode::Picture::png, static_cast<std::uint16_t>(size.width),
                                    static_cast<std::uint16_t>(size.height), png});
}

void ProgramFile::commit() {
    if (form_ == Form::binary) sink_.write(bgcode::written(file_));
    if (form_ == Form::print_file) sink_.write(archive::written(print_file_));
    sink_.commit();
}

} // namespace filum::app::postproc
