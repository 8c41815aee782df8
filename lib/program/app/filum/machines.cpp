#include "app/filum/machines.hpp"

#include "app/filum/show.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "stream/sink.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace filum::app::filum {

namespace {

using machine::Feeding;
using machine::Profile;

constexpr double kFastPaste = 60; // mm/s: pastes and gels are extruded more slowly

int list_machines() {
    std::string out;
    for (const std::string& name : machine::profile_names()) {
        const Profile p = machine::load_profile(name);
        const auto size = [](double lo, double hi) { return fixed_text(hi - lo, 1); };
        const std::string reach = size(p.bed.x_min, p.bed.x_max) + " x " + size(p.bed.y_min, p.bed.y_max) + " x " +
                                  size(p.bed.z_min, p.bed.z_max) + " mm";
        out += cell(name, 20) + cell(reach, 26) + p.about + "\n";
    }
    show(out);
    return 0;
}

// The first of `codes` that is a word in the text; "" if none is.
std::string first_code(const std::string& text, const std::vector<std::string>& codes) {
    const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; };
    for (const std::string& code : codes)
        for (std::size_t at = text.find(code); at != std::string::npos; at = text.find(code, at + 1)) {
            const bool begins = at == 0 || !part(text[at - 1]);
            const std::size_t end = at + code.size();
            if (begins && (end == text.size() || !part(text[end]))) return code;
        }
    return "";
}

bool has_section(const std::string& text, const std::string& name) {
    return text.starts_with("[" + name + "]") || text.find("\n[" + name + "]") != std::string::npos;
}

void add_heat(const Profile& p, std::vector<std::string>& out) {
    const std::string codes =
        p.templates.start + p.templates.layer + p.templates.upper_layers + p.templates.first_layer + p.templates.end;
    const std::string heats = first_code(codes, {"M104", "M109", "M140", "M190", "M141", "M191", "M116", "M568"});
    const std::string fan = first_code(codes, {"M106"});
    const bool cold = p.extrusion.feeding == Feeding::plunger || p.extrusion.feeding == Feeding::valve ||
                      first_code(codes, {"M302"}) == "M302";
    if (cold && !heats.empty())
        out.push_back(heats + " heats, and the material is cold: take it out of [templates], or leave it if yours is "
                              "warmed");
    if (cold && heats.empty() && !fan.empty()) out.push_back(fan + " turns on a fan over a cold material: a gel dries");
    if (!cold && heats.empty() && p.extrusion.feeding == Feeding::filament)
        out.push_back("nothing heats the filament: add codes to templates.start, as M109 S{nozzle_temp}");
    const std::string& start = p.templates.start;
    if (p.extrusion.feeding != Feeding::valve && heats.empty() && first_code(start, {"M302"}).empty() &&
        p.motion.controller == machine::Controller::marlin && p.extrusion.feeding != Feeding::filament)
        out.push_back("Marlin refuses to extrude cold: add M302 P1 to templates.start");
}

void add_sizes(const Profile& p, const std::string& text, std::vector<std::string>& out) {
    if (p.extrusion.nozzle == 0 && !std::isfinite(p.limits.section))
        out.push_back("extrusion.nozzle is missing, so no bead is refused as too wide for it: add nozzle = 0.4 under "
                      "[extrusion]");
    const double most = 4 * p.extrusion.nozzle * p.extrusion.nozzle;
    if (p.extrusion.nozzle > 0 && p.limits.section > most * 1.0001)
        out.push_back("limits.section, " + shortest_text(p.limits.section) +
                      " mm2, lets beads be larger than four squares of the nozzle, " + shortest_text(most) +
                      " mm2: lower it");
    if (!has_section(text, "head"))
        out.push_back("[head] is missing: strokes climb as an ordinary printer's head allows; measure yours");
    if (p.head.none) out.push_back("head.none is true: nothing keeps the head clear of what is printed");
    if (p.bed.z_max - p.bed.z_min < 20)
        out.push_back("the machine is only " + shortest_text(p.bed.z_max - p.bed.z_min) + " mm high: check bed.z");
}

void add_feeding(const Profile& p, std::vector<std::string>& out) {
    if (p.extrusion.feeding == Feeding::valve && p.travel.retract > 0)
        out.push_back("travel.retract is not 0, and a valve takes nothing back: set it to 0");
    if (p.extrusion.feeding == Feeding::plunger && p.travel.retract > 1)
        out.push_back("travel.retract takes " + shortest_text(p.travel.retract) +
                      " mm of plunger back, much more than a syringe gives: is that mm of filament?");
    if (p.extrusion.feeding == Feeding::plunger && p.extrusion.diameter < 3)
        out.push_back("extrusion.diameter is " + shortest_text(p.extrusion.diameter) +
                      " mm, that of filament and of no syringe: measure the bore");
    if (p.extrusion.feeding == Feeding::filament && p.extrusion.diameter > 3.2)
        out.push_back("extrusion.diameter is " + shortest_text(p.extrusion.diameter) +
                      " mm, more than any filament: is the kind plunger?");
    if (p.extrusion.feeding == Feeding::plunger && p.feeds.bead > kFastPaste)
        out.push_back("feeds.bead is " + shortest_text(p.feeds.bead) + " mm/s, fast for a syringe");
    if (p.extrusion.feeding != Feeding::filament && p.templates.start.find("{purge") != std::string::npos)
        out.push_back("templates.start primes a line, by mm of filament: check the amount");
}

void add_codes(const Profile& p, std::vector<std::string>& out) {
    if (p.format.dialect != machine::Dialect::gcode) return;
    const std::string& start = p.templates.start;
    if (start.empty()) {
        out.push_back("templates.start is empty: nothing homes the machine");
        return;
    }
    const bool own_macro = start.find("START") != std::string::npos || start.find("start") != std::string::npos;
    if (!own_macro && first_code(start, {"G28", "M420"}).empty())
        out.push_back("templates.start homes nothing: add G28, unless the machine stands at its zero");
    if (p.templates.end.find("{z_park}") == std::string::npos && first_code(p.templates.end, {"Z"}).empty() &&
        p.templates.end.find("END") == std::string::npos && p.templates.end.find("G1 Z") == std::string::npos)
        out.push_back("templates.end does not raise the nozzle: add G1 Z{z_park} F{z_feed}");
    const auto names = machine::profile_names();
    if (std::find(names.begin(), names.end(), p.name) != names.end())
        out.push_back("its name, '" + p.name + "', is that of a profile that comes with Filum: choose one of your own");
}

// Names the values that a profile marks by the remark "placeholder: ...", each with its section.
void add_placeholders(const std::string& text, std::vector<std::string>& out) {
    std::istringstream lines(text);
    std::string section;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("[")) section = line.substr(1, line.find(']') - 1);
        if (line.starts_with("#") || line.find("# placeholder: ") == std::string::npos) continue;
        const std::string key = line.substr(0, line.find_first_of(" ="));
        out.push_back(std::string(section).append(".").append(key) +
                      " is a placeholder: measure it as the profile says, then delete the remark behind it");
    }
}

// The text of a profile that has the other one as its base and states nothing of its own but its name.
std::string based_on(const std::string& base) {
    return "# Everything that this file does not state is as in the profile '" + base + "' (docs/machines.md).\n" +
           "name = \"\"\nbase = \"" + base + "\"\n\n# [bed]\n# x = [0, 220]\n# y = [0, 220]\n# z = [0, 250]\n\n" +
           "# [values]\n# nozzle_temp = 210\n";
}

// `based`: the file names `from` as its base; otherwise it is a copy.
void write_new(const std::string& file, const std::string& from, bool based) {
    if (!file.ends_with(".toml"))
        throw Error(Exit::usage, "cannot write the profile '" + file + "': its name must end in .toml");
    std::error_code none;
    if (std::filesystem::exists(file, none))
        throw Error(Exit::usage, "cannot write the profile '" + file + "': it is there already; give another name");
    machine::load_profile(from); // throws if the profile is faulty
    std::string text = based ? based_on(from) : machine::profile_text(from);
    std::string name = std::filesystem::path(file).stem().string();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '_' && c != '-') c = '_';
    name.resize(std::min<std::size_t>(name.size(), 64));
    const std::size_t at = text.starts_with("name =") ? 0 : text.find("\nname =") + 1;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    text.replace(at, end - at, "name = \"" + name + "\"  # required; stands in the program's header");
    stream::Sink out(file, stream::Sink::Content::text);
    out.write(text);
    out.commit();
    show("wrote " + file + (based ? ", based on " : ", a copy of ") + from +
         "; edit it, then\n  filum machines --check " + file + "\n  filum print part.stl --machine " + file +
         " -o part.gcode\n");
}

int check_profile(const std::string& file) {
    const Profile profile = machine::load_profile(file);
    std::string text; // of the profile and its bases
    for (const machine::ProfileText& one : machine::profile_texts(file)) text += one.text + "\n";
    const auto found = surprises(profile, text);
    std::string out;
    for (const std::string& one : found) out.append(file).append(": ").append(one) += '\n';
    if (found.empty()) out = file + ": nothing wrong or surprising\n";
    show(out);
    return found.empty() ? 0 : static_cast<int>(Exit::failure);
}

} // namespace

std::vector<std::string> surprises(const Profile& profile, const std::string& text) {
    std::vector<std::string> out;
    add_sizes(profile, text, out);
    add_heat(profile, out);
    add_feeding(profile, out);
    add_codes(profile, out);
    add_placeholders(text, out);
    return out;
}

int machines(const std::vector<std::string>& words) {
    if (words.empty()) return list_machines();
    std::string fresh, from, base, checked;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::size_t equal = words[i].find('=');
        const std::string name = words[i].substr(0, equal);
        std::string* to = name == "--new"     ? &fresh
                          : name == "--from"  ? &from
                          : name == "--base"  ? &base
                          : name == "--check" ? &checked
                                              : nullptr;
        if (to == nullptr)
            throw Error(Exit::usage, "unexpected argument '" + words[i] + "'; see 'filum help machines'");
        if (equal == std::string::npos && i + 1 == words.size())
            throw Error(Exit::usage, "cannot use '" + name + "' without a value; see 'filum help machines'");
        *to = equal == std::string::npos ? words[++i] : words[i].substr(equal + 1);
    }
    if (!checked.empty() && fresh.empty() && from.empty() && base.empty()) return check_profile(checked);
    if (fresh.empty() || from.empty() == base.empty() || !checked.empty())
        throw Error(
            Exit::usage,
            "cannot make a machine: give --new FILE and --from NAME or --base NAME, as in 'filum machines --new "
            "mine.toml --from clay'");
    write_new(fresh, base.empty() ? from : base, !base.empty());
    return 0;
}

} // namespace filum::app::filum
