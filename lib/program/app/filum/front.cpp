#include "app/filum/front.hpp"

#include "app/filum/check.hpp"
#include "app/filum/compare.hpp"
#include "app/filum/machines.hpp"
#include "app/filum/print.hpp"
#include "app/filum/printers.hpp"
#include "app/filum/process.hpp"
#include "app/filum/show.hpp"
#include "app/filum/show_settings.hpp"
#include "app/filum/stage.hpp"
#include "base/error.hpp"
#include "base/shell.hpp"
#include "stream/sink.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace filum::app::filum {

namespace {

void list() {
    std::string out;
    for (const auto& name : stage_names()) {
        const Stage s = ask(name);
        const auto port = [](const std::string& p) {
            if (p == "stream unknown") return std::string("any stream");
            return p.starts_with("stream ") ? p.substr(7) : p;
        };
        const std::string ports = port(s.in) + " -> " + port(s.out);
        out += cell(s.name, 13) + cell(ports, 24) + s.synopsis + "\n";
    }
    for (const std::string& name : extra_names()) out += cell(name, 13) + "'filum-" + name + "' on the PATH\n";
    show(out);
}

// The possible values of an option, from the contract of its stage; "" if the stage has no such option.
std::string choices(const std::string& stage, const std::string& option) {
    std::istringstream answer(output_of({stage_program(stage), "--print-contract"}));
    const std::string key = "option " + option + " ";
    for (std::string line; std::getline(answer, line);)
        if (line.starts_with(key)) return line.substr(key.size());
    return "";
}

void patterns() {
    std::string out;
    const auto add = [&](const std::string& stage, const std::string& option, const std::string& typed) {
        std::istringstream all(choices(stage, option));
        for (std::string one; std::getline(all, one, '|');) out += cell(one, 20) + stage + " " + typed + one + "\n";
    };
    add("fill", "pattern", "--pattern ");
    add("surfpath", "algorithm", "");
    show(out + "\nfilum help fill, filum help surfpath explain them.\n");
}

// Prints lines that a shell can evaluate with `eval`.
void env() {
    std::string out = "export PATH=" + shell_word(stage_folder()) + ":\"$PATH\"\n";
    const std::filesystem::path share = std::filesystem::path(prefix()) / "share";
    if (std::filesystem::is_directory(share / "man"))
        out += "export MANPATH=" + shell_word((share / "man").string()) + ":\"${MANPATH:-}\"\n";
    const auto completion = share / "bash-completion" / "completions" / "filum";
    if (std::filesystem::is_regular_file(completion))
        out += "if [ -n \"${BASH_VERSION:-}\" ]; then . " + shell_word(completion.string()) + "; fi\n";
    show(out);
}

struct OwnCommand {
    const char* name;
    void (*run)(); // null: the command takes arguments
    const char* help;
    int (*run_with)(const std::vector<std::string>& arguments) = nullptr;
};

constexpr OwnCommand kOwnCommands[] = {
    {"list", list, "usage: filum list\n\nNames all stages, what they read and write, and what they do.\n"},
    {"env", env,
     "usage: eval \"$(filum env)\"\n\nPrints shell lines that put the stages on the PATH, with manual pages and "
     "completion.\n"},
    {"machines", nullptr, kMachinesHelp, machines},
    {"compare", nullptr, kCompareHelp, compare},
    {"patterns", patterns,
     "usage: filum patterns\n\nLists what fill and surfpath can lay, and the option that asks for it. Sparse infill "
     "has\n"
     "patterns of its own: filum help skins, --infill-pattern.\n"},
    {"check", nullptr,
     "usage: filum check PROGRAM --as STAGE\n\nRuns a program of your own as that stage, on a small part and on "
     "damaged "
     "streams, and says which of\na stage's promises it keeps. Exit code 0: all of them.\n",
     check_foreign},
    {"settings", nullptr,
     "usage: filum settings FILE...\n       filum settings --machine FILE... > mine.toml\n\n"
     "Shows what Filum makes of each setting of a slicer's file or project: the option for it, or why\nthere is "
     "none. --machine writes the printer that the files describe as a machine profile: its bed,\nfirmware and "
     "G-code, to keep, to edit and to print with --machine ./mine.toml.\n",
     show_settings},
    {"printers", nullptr, kPrintersHelp, show_printers},
};

const OwnCommand* own_command(const std::string& name) {
    const auto* at = std::find_if(std::begin(kOwnCommands), std::end(kOwnCommands),
                                  [&](const OwnCommand& c) { return name == c.name; });
    return at == std::end(kOwnCommands) ? nullptr : at;
}

bool asks_for_help(const std::string& word) { return word == "--help" || word == "-h"; }

} // namespace

int front(const std::vector<std::string>& words) {
    const std::string& what = words.at(0);
    const std::vector<std::string> rest(words.begin() + 1, words.end());
    if (what == "print") return print_part(rest);
    if (what == "help" && rest.size() == 1 && rest[0] == "print") return print_part({"--help"});
    if (what == "help" && rest.empty()) become({"/proc/self/exe", "--help"});
    const bool help = what == "help" && rest.size() == 1;
    if (const OwnCommand* own = own_command(help ? rest[0] : what)) {
        if (help || (rest.size() == 1 && asks_for_help(rest[0]))) return show(own->help), 0;
        if (own->run_with != nullptr) return own->run_with(rest);
        if (!rest.empty())
            throw Error(Exit::usage, "unexpected argument '" + rest[0] + "'; see 'filum help " + what + "'");
        return own->run(), 0;
    }
    if (help) become({stage_program(rest[0]), "--help"});
    const std::string extra = is_stage(what) ? "" : extra_program(what);
    Command command{extra.empty() ? stage_program(what) : extra};
    command.insert(command.end(), rest.begin(), rest.end());
    become(command);
}

} // namespace filum::app::filum
