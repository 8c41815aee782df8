#include "app/filum/print.hpp"

#include "app/filum/distribute.hpp"
#include "app/filum/kept.hpp"
#include "app/filum/slicer_names.hpp"
#include "app/filum/watch.hpp"
#include "app/filum/wishes.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/shell.hpp"
#include "cli/lines.hpp"
#include "cli/output_name.hpp"
#include "machine/profile.hpp"
#include "stream/sink.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace filum::app::filum {

namespace {

int tell(const std::string& text) {
    stream::Sink out("-", stream::Sink::Content::text);
    out.write(text);
    out.commit();
    return 0;
}

// The options that a first print needs.  Their defaults come from the stages.
struct FirstOption {
    const char *name, *unit, *help;
};
constexpr FirstOption kFirstOptions[] = {
    {"machine", "NAME", "the machine: see filum machines"},
    {"printer", "NAME", "a printer of your slicer's presets or of Filum's: see filum printers"},
    {"filament", "NAME", "pla, petg, abs, tpu, or a filament of your slicer's presets"},
    {"layer-height", "MM", "height of a layer"},
    {"bead-width", "MM", "width of a bead: usually that of the nozzle"},
    {"infill", "PERCENT", "how much of the inside is filled; 100%: one unbroken curve without skins"},
    {"walls", "N", "walls about sparse infill"},
    {"top", "N", "solid layers under a top surface; --bottom above a lower one"},
    {"vase", "", "a solid floor and one bead in a helix above it; --walls, --bottom"},
    {"support", "", "supports under overhangs"},
    {"brim", "MM", "width of a brim about the first layer"},
    {"copies", "N", "how many of each part to pack on the bed"},
    {"scale", "FACTOR", "size: 1.5 or 150%; --rotate 45 turns"},
};

std::string first_options(const std::vector<Stage>& stages) {
    constexpr std::size_t column = 24;
    std::string out = "options that a first print needs:\n";
    for (const FirstOption& first : kFirstOptions) {
        std::string line = std::string("  --") + first.name + " " + first.unit;
        line.resize(std::max(line.size() + 2, column), ' ');
        std::string value;
        for (const Stage& s : stages) // options that vase shares with skins have the defaults of skins here
            for (const StageOption& o : s.options)
                if (o.name == first.name && value.empty() && s.name != "vase") value = o.value;
        out += line + first.help + (value.empty() ? "" : " [" + value + "]") + "\n";
    }
    return out + "\n";
}

std::string print_help(const std::vector<Stage>& stages) {
    std::string out = "usage: filum print [OPTIONS] [MESH...]\n\n"
                      "Runs the planar chain, all stages at once, and writes machine code:\n\n   ";
    for (const auto& s : stages) {
        out += &s == stages.data() ? " " : " | ";
        out += by_wish(s) ? "[" + s.name + "]" : s.name;
    }
    out +=
        "\n\n" + first_options(stages) +
        "A stage in brackets runs only if you use one of its own options; --vase asks for vase.\nAn option goes to "
        "every stage "
        "that has it; --STAGE.OPTION goes to that stage alone and wins there.\n"
        "--machine also tells the stages before whose head to keep clear of, unless --head says another.\n"
        "Several parts, or --copies, are packed on one bed; see filum help slice.\n"
        "On a terminal it shows the slowest stage, and at the end in a few lines what was made; the same lines stand\n"
        "first in the program.\n"
        "If a stage fails, the exit code is its own, and no file appears.\n\n"
        "  -o, --output FILE   where to write\n"
        "  --load FILE         settings of PrusaSlicer, OrcaSlicer or Bambu Studio (.ini, .json, or a project, .3mf);\n"
        "                      of a bundle the presets that stand behind it: "
        "FILE:printer=NAME,print=NAME,filament=NAME.\n"
        "                      Filum applies the settings it knows and lists those it ignores. A project that is\n"
        "                      printed alone is loaded, too; --load none prints without settings. A printer in it is\n"
        "                      the machine: its bed, firmware, and G-code with its macros (docs/slicer-profiles.md).\n"
        "                      Options win over it. Options by slicers' names are taken, too: --fill-density 15%,\n"
        "                      --temperature 210, --fan 50%, --bed 300x300x400, --rotate 45, --scale 150%\n"
        "  --keep FOLDER       keep the stream of every stage there: 1-slice.layers, 2-regions.regions, ...\n"
        "  --report FILE       a page to look around in, x.html: every bead, figures, places, how it was made\n"
        "  --stage NAME=FILE   your own program in place of a stage, as fill=./mine; several times for several\n"
        "  --picture FILE      a picture of the toolpath, too: FILE as render's --output\n"
        "  -q, --quiet         no warnings\n"
        "      --notes WHICH   which notes to say: all, also harmless ones; look; will-fail [look]\n"
        "  --dry-run           print the pipeline instead of running it\n\noptions of the stages:\n";
    for (const auto& s : stages) {
        out += "  " + s.name + ":";
        for (const auto& o : s.options)
            if (o.name != "output" && o.name != "threads" && o.name != "quiet" && o.name != "notes" &&
                o.name != "help" && o.name != "version")
                out += " --" + o.name;
        out += "\n";
    }
    return out + "\nfilum help STAGE explains them.\n";
}

// The value of the last --NAME=VALUE in the words of a stage; `otherwise` if there is none.
std::string value_in(const std::vector<std::string>& words, const std::string& name, const std::string& otherwise) {
    const std::string start = "--" + name + "=";
    std::string out = otherwise;
    for (const std::string& word : words)
        if (word.starts_with(start)) out = word.substr(start.size());
    return out;
}

// Reads the profiles that stages will read, so that a fault in one is reported once, before any work.
void check_profiles(const Request& request, const std::vector<Stage>& stages) {
    std::set<std::pair<std::string, std::string>> seen; // name, --set
    for (std::size_t s = 0; s < stages.size(); ++s) {
        const auto& words = request.arguments[s];
        std::string usual;
        for (const StageOption& o : stages[s].options)
            if (o.name == "machine") usual = o.value;
        const std::string set = value_in(words, "set", "");
        const std::string machine = value_in(words, "machine", set.empty() ? "" : usual);
        const std::string head = value_in(words, "head", "");
        if (!machine.empty() && seen.insert({machine, set}).second) machine::load_profile(machine, set);
        if (head.empty() || head == "ordinary" || head == "none" || head == machine) continue;
        if (seen.insert({head, ""}).second) machine::load_profile(head);
    }
}

std::vector<Command> commands_of(const Request& request, const std::vector<Stage>& stages) {
    std::vector<Command> out;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        Command command{stages[i].program};
        command.insert(command.end(), request.arguments[i].begin(), request.arguments[i].end());
        if (i + 1 == stages.size() && request.output != "-") command.push_back("--output=" + request.output);
        if (i == 0 && request.inputs != std::vector<std::string>{"-"}) {
            const auto dashed = [](const std::string& name) { return name.starts_with("-"); };
            if (std::any_of(request.inputs.begin(), request.inputs.end(), dashed)) command.emplace_back("--");
            command.insert(command.end(), request.inputs.begin(), request.inputs.end());
        }
        out.push_back(std::move(command));
    }
    return out;
}

// A program as it is typed: a stage of Filum by its name, another program by its file.
std::string typed(const std::string& program) {
    const std::filesystem::path file = program;
    return file.parent_path() == stage_folder() ? file.filename().string() : shell_word(program);
}

std::string pipeline(const std::vector<Command>& commands) {
    std::string line;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        line += (i > 0 ? " | " : "") + typed(commands[i].front());
        for (std::size_t w = 1; w < commands[i].size(); ++w) line += " " + shell_word(commands[i][w]);
    }
    return line + "\n";
}

// The text of the pipeline.  If a slicer's printer is the machine, its temporary profile gets another name,
// SlicerMachine::kShownName, and the command that makes that file comes first.
std::string shown_pipeline(std::vector<Command> commands, const SlicerMachine* machine) {
    if (machine == nullptr) return pipeline(commands);
    for (Command& command : commands)
        for (std::string& word : command)
            if (word.ends_with("=" + machine->path()))
                word.replace(word.size() - machine->path().size(), std::string::npos, SlicerMachine::kShownName);
    return machine->command() + pipeline(commands);
}

// Reports the settings of files that are not used; first those without which a print can go wrong.
void tell_left(const SlicerTranslation& from) {
    const auto list = [](const char* more, const std::string& what, const std::vector<std::string>& names) {
        if (names.empty()) return;
        std::string line = "filum: " + std::to_string(names.size()) + more;
        line += (names.size() == 1 ? " setting" : " settings") + what;
        for (const std::string& name : names) line += " " + name;
        std::cerr << cli::for_terminal(line) << std::endl;
    };
    list("", " of --load not followed, and a print without can go wrong:", from.harmful);
    for (const std::string& remark : from.remarks) std::cerr << cli::for_terminal("filum: " + remark) << std::endl;
    list(" more", " of --load not used yet (filum settings FILE tells why):", from.left);
}

void tell_idle(const std::vector<std::string>& options) {
    std::string all;
    for (const std::string& option : options) all += (all.empty() ? "" : ", ") + option;
    std::cerr << "filum: a vase is empty above its floor: no effect of " << all << std::endl;
}

// The exit code of the chain.  If it is not 0, the failed stage has reported why; where it cannot, this throws Error
// with the reason.
int judge(const std::vector<ProcessEnd>& ended, const std::vector<Stage>& stages) {
    std::size_t who = 0;
    const int code = verdict(ended, who);
    if (code == 0) return 0;
    if (code == 128 + SIGPIPE) return code; // the reader of the program closed the pipe
    if (ended[who].by_signal)
        throw Error(Exit::failure,
                    "stage '" + stages[who].name + "' was killed by signal " + std::to_string(code - 128));
    if (code == static_cast<int>(Exit::truncated) && who > 0)
        throw Error(Exit::truncated, "stage '" + stages[who].name + "' received an incomplete stream");
    return code;
}

std::vector<std::string> names_of(const std::vector<Stage>& stages) {
    std::vector<std::string> out(stages.size());
    std::transform(stages.begin(), stages.end(), out.begin(), [](const Stage& s) { return s.name; });
    return out;
}

// Whether no part is piped to standard input: it is a terminal, /dev/null, or closed.
bool stdin_is_empty() {
    struct stat about {};
    return ::fstat(STDIN_FILENO, &about) != 0 || S_ISCHR(about.st_mode);
}

// Replaces stages by the programs that --stage names.
void swap(const std::vector<std::string>& words, std::vector<Stage>& stages) {
    const std::string option = "--stage";
    for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
        if (words[i] != option && !words[i].starts_with(option + "=")) continue;
        const bool apart = words[i] == option;
        const std::string what = !apart ? words[i].substr(option.size() + 1) : i + 1 < words.size() ? words[i + 1] : "";
        const auto equal = what.find('=');
        const std::string name = what.substr(0, equal);
        if (equal == std::string::npos || equal + 1 == what.size())
            throw Error(Exit::usage, "cannot use --stage '" + what + "': it is no NAME=FILE, as fill=./mine");
        const auto found = std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.name == name; });
        if (found == stages.end()) {
            const std::string meant = did_you_mean(name, names_of(stages));
            throw Error(Exit::usage, "cannot put in the stage '" + name + "': the chain has none of that name" +
                                         (meant.empty() ? "; see 'filum help print'" : meant));
        }
        *found = foreign(*found, what.substr(equal + 1));
    }
}

// Keeps the streams and makes the picture and the report, as far as the request asks for them.
void finish(const Request& request, KeptStreams& kept) {
    kept.commit();
    if (!request.picture.empty()) kept.draw({}, request.picture);
    if (request.report.empty()) return;
    const std::string machine = value_in(request.arguments.back(), "machine", "");
    const bool named = request.inputs.size() == 1 && request.inputs[0] != "-";
    kept.report(named ? request.inputs[0] : request.inputs.size() > 1 ? "plate" : "part", machine, request.report);
}

// The inode number of a regular file; 0 if there is none of that name.  The number changes when the file is replaced.
ino_t number_of(const std::string& name) {
    struct stat info {};
    return name != "-" && ::stat(name.c_str(), &info) == 0 && S_ISREG(info.st_mode) ? info.st_ino : 0;
}

void refuse_input_as_output(const Request& request) {
    for (const std::string& input : request.inputs) {
        std::error_code none;
        if (input != "-" && std::filesystem::equivalent(input, request.output, none) &&
            std::filesystem::is_regular_file(input, none))
            throw Error(Exit::usage, "cannot write '" + request.output + "': it is the input; give another name by -o");
    }
}

} // namespace

int print_part(const std::vector<std::string>& typed) {
    std::vector<Stage> stages;
    for (const char* name : kPlanar) stages.push_back(ask(name));
    if (!typed.empty() && (typed[0] == "--help" || typed[0] == "-h")) return tell(print_help(stages));
    if (typed.empty() && stdin_is_empty())
        throw Error(Exit::usage, "cannot print without a part; as in 'filum print part.stl -o part.gcode'; see 'filum "
                                 "print --help'");
    const SlicerTranslation ours = translated(typed, stages);
    const auto& words = ours.words;
    swap(words, stages);
    Request request = distribute(words, stages);
    const auto idle = keep_wished(words, request, stages);
    if (!request.report.empty() && !request.report.ends_with(".html"))
        throw Error(Exit::usage, "cannot make the report '" + request.report + "': its name must end in .html");
    refuse_input_as_output(request);
    cli::check_output_name(request.output, "filum print", "machine code");
    if (!request.picture.empty())
        cli::check_output_name(request.picture, "--picture", "a PNG picture, SVG, VTP or an HTML page");
    if (!request.quiet) tell_left(ours);
    if (!request.quiet && !idle.empty()) tell_idle(idle);
    if (ours.machine != nullptr && !request.inputs.empty()) ours.machine->name_input(request.inputs.front());
    check_profiles(request, stages);
    std::vector<Command> commands = commands_of(request, stages);
    if (request.dry_run) return tell(shown_pipeline(commands, ours.machine.get()));
    if (request.output == "-" && ::isatty(STDOUT_FILENO) != 0)
        throw Error(Exit::usage,
                    "cannot write machine code to a terminal; add -o FILE, as in -o part.gcode, or pipe it on");
    const bool talks = ::isatty(STDERR_FILENO) != 0 && !request.quiet;
    KeptStreams kept(request, stages);
    if (talks) commands.back().push_back("--summary=" + kept.summary());
    // If the last stage is a program of the user's own, each stage prints its notes, since that program may not do so.
    const NotePrinters speakers =
        stages.back().program == stage_program(stages.back().name) ? NotePrinters::last : NotePrinters::each;
    const ino_t before = number_of(request.output);
    try {
        const auto ended = talks ? run_watched(commands, kept.files(), names_of(stages), speakers)
                                 : run_piped(commands, kept.files(), {}, speakers);
        if (const int code = judge(ended, stages); code != 0) return code;
        finish(request, kept);
    } catch (const Error&) {
        // If the report, picture or a kept stream cannot be written, the program is removed, too.
        if (number_of(request.output) != before) ::unlink(request.output.c_str());
        throw;
    }
    if (talks) std::cerr << kept.told(request.output) << std::flush;
    return 0;
}

} // namespace filum::app::filum
