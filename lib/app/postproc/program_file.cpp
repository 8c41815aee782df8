#include "app/postproc/program_file.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>

namespace filum::app::postproc {

namespace {

// "2h 5m 7s", as PrusaSlicer writes it.
std::string duration(double seconds) {
    const auto s = static_cast<long long>(std::llround(seconds));
    std::string out;
    if (s >= 3600) out += std::to_string(s / 3600) + "h ";
    if (s >= 60) out += std::to_string(s / 60 % 60) + "m ";
    return out + std::to_string(s % 60) + "s";
}

// A table has one line for a value.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
}

bool is_binary(const std::string& path, const machine::Profile& profile) {
    const std::string fault = "cannot write '" + path + "': ";
    if (path.ends_with(".3mf"))
        throw Error(Exit::usage, fault + "programs are written as text or as .bgcode; name it part.gcode");
    const bool binary = path.ends_with(".bgcode");
    if (binary && profile.format.dialect != machine::Dialect::gcode)
        throw Error(Exit::usage, fault + "'" + profile.name + "' reads no G-code; choose another ending");
    return binary;
}

} // namespace

ProgramFile::ProgramFile(const std::string& path, const machine::Profile& profile)
    : binary_(is_binary(path, profile)),
      sink_(path, binary_ ? stream::Sink::Content::binary : stream::Sink::Content::text) {}

void ProgramFile::write(std::string_view text) {
    if (binary_)
        file_.gcode += text;
    else
        sink_.write(text);
}

void ProgramFile::describe(const machine::Profile& profile, const filum::postproc::FirstPass& first_pass,
                           const std::vector<filum::postproc::Stage>& stages) {
    if (!binary_) return;
    constexpr double kCubicMm = 1000; // per cm3
    const auto used = filum::postproc::used(profile, first_pass);
    bgcode::Table takes;
    if (profile.extrusion.feeding == machine::Feeding::filament)
        takes.emplace_back("filament used [mm]", fixed_text(used.units, 2));
    takes.emplace_back("filament used [cm3]", fixed_text(used.volume / kCubicMm, 2));
    takes.emplace_back("estimated printing time (normal mode)", duration(first_pass.seconds));
    file_.about = {{"Producer", "Filum"}};
    file_.printer = {{"printer_model", one_line(profile.name)}};
    for (const auto& [key, name] : {std::pair{"temperature", "nozzle_temp"}, {"bed_temperature", "bed_temp"}})
        if (const auto value = profile.values.find(name); value != profile.values.end())
            file_.printer.emplace_back(key, shortest_text(value->second));
    file_.printer.emplace_back("max_layer_z", fixed_text(first_pass.part_high[2], 2));
    file_.printer.insert(file_.printer.end(), takes.begin(), takes.end());
    file_.print = takes;
    if (profile.extrusion.feeding == machine::Feeding::filament)
        file_.slicer.emplace_back("filament_diameter", shortest_text(profile.extrusion.diameter));
    for (const auto& stage : stages)
        for (const auto& [name, value] : stage.settings)
            file_.slicer.emplace_back("filum_" + stage.program + "_" + name, one_line(value));
}

void ProgramFile::add(const PictureSize& size, const std::string& png) {
    file_.thumbnails.push_back(
        {bgcode::Picture::png, static_cast<std::uint16_t>(size.width), static_cast<std::uint16_t>(size.height), png});
}

void ProgramFile::commit() {
    if (binary_) sink_.write(bgcode::written(file_));
    sink_.commit();
}

} // namespace filum::app::postproc
