#include "app/filum/front.hpp"

#include "app/filum/process.hpp"
#include "app/filum/route.hpp"
#include "app/filum/stage.hpp"
#include "base/error.hpp"
#include "base/shell.hpp"
#include "machine/profile.hpp"
#include "stream/sink.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <unistd.h>

namespace filum::app::filum {

namespace {

constexpr const char* kPlanar[] = {"slice", "regions", "skins", "supports", "sequence", "fill", "link3d", "postproc"};
constexpr const char* kByWish[] = {"skins",
                                   "supports"}; // take part where one of the options that they alone have is given

void print(const std::string& text) {
    stream::Sink out("-", stream::Sink::Content::text);
    out.write(text);
    out.commit();
}

void list() {
    std::string out;
    for (const auto& name : stage_names()) {
        const Stage s = ask(name);
        std::string left = s.name;
        left.resize(std::max<std::size_t>(left.size() + 2, 13), ' ');
        const auto port = [](const std::string& p) {
            if (p == "stream unknown") return std::string("any stream");
            return p.starts_with("stream ") ? p.substr(7) : p;
        };
        std::string ports = port(s.in) + " -> " + port(s.out);
        ports.resize(std::max<std::size_t>(ports.size() + 2, 24), ' ');
        out += left + ports + s.synopsis + "\n";
    }
    print(out);
}

// Lines for eval in a shell.
void env() {
    std::string out = "export PATH=" + shell_word(stage_folder()) + ":\"$PATH\"\n";
    const std::filesystem::path share = std::filesystem::path(prefix()) / "share";
    if (std::filesystem::is_directory(share / "man"))
        out += "export MANPATH=" + shell_word((share / "man").string()) + ":\"${MANPATH:-}\"\n";
    const auto completion = share / "bash-completion" / "completions" / "filum";
    if (std::filesystem::is_regular_file(completion))
        out += "if [ -n \"${BASH_VERSION:-}\" ]; then . " + shell_word(completion.string()) + "; fi\n";
    print(out);
}

bool by_wish(const Stage& stage) {
    return std::find(std::begin(kByWish), std::end(kByWish), stage.name) != std::end(kByWish);
}

// Whether one of the words is an option that no other stage has, or one of this stage by its name.
bool wished(const std::vector<std::string>& words, const std::vector<Stage>& stages, const Stage& stage) {
    const auto has = [](const Stage& s, const std::string& name) {
        return std::any_of(s.options.begin(), s.options.end(), [&](const StageOption& o) { return o.name == name; });
    };
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        if (word.starts_with("--" + stage.name + ".")) return true;
        const std::string name = word.starts_with("--") ? word.substr(2, word.find('=') - 2) : "";
        return has(stage, name) && std::none_of(stages.begin(), stages.end(), [&](const Stage& other) {
                   return other.name != stage.name && has(other, name);
               });
    });
}

// Leaves out the stages that nobody asks for.
void keep_wished(const std::vector<std::string>& words, Request& request, std::vector<Stage>& stages) {
    const std::vector<Stage> all = stages;
    const Request given = request;
    stages.clear(), request.arguments.clear();
    for (std::size_t s = 0; s < all.size(); ++s) {
        if (by_wish(all[s]) && !wished(words, all, all[s])) continue;
        stages.push_back(all[s]), request.arguments.push_back(given.arguments[s]);
    }
}

std::string print_help(const std::vector<Stage>& stages) {
    std::string out = "usage: filum print [OPTIONS] [MESH]\n\n"
                      "Runs the planar chain, all stages at once, and writes machine code:\n\n   ";
    for (const auto& s : stages) {
        out += (&s == stages.data() ? " " : " | ");
        out += by_wish(s) ? "[" + s.name + "]" : s.name;
    }
    out += "\n\nA stage in brackets takes part where an option is given that it alone has.\nAn option goes to every "
           "stage that has it; --STAGE.OPTION goes to that stage alone and wins there.\n"
           "--machine also tells the stages before whose head to keep clear of, unless --head says another.\n"
           "If a stage fails, the exit code is its own, and a file named by --output does not appear.\n\n"
           "  -o, --output FILE   where to write\n  -q, --quiet         no warnings\n"
           "  --dry-run           print the pipeline instead of running it\n\noptions of the stages:\n";
    for (const auto& s : stages) {
        out += "  " + s.name + ":";
        for (const auto& o : s.options)
            if (o.name != "output" && o.name != "threads" && o.name != "quiet" && o.name != "help" &&
                o.name != "version")
                out += " --" + o.name;
        out += "\n";
    }
    return out + "\nfilum help STAGE explains them.\n";
}

// What --NAME= says in the words of a stage, the last time; else `otherwise`.
std::string value_in(const std::vector<std::string>& words, const std::string& name, const std::string& otherwise) {
    const std::string start = "--" + name + "=";
    std::string out = otherwise;
    for (const std::string& word : words)
        if (word.starts_with(start)) out = word.substr(start.size());
    return out;
}

// Reads the profiles that stages will read, so that what is wrong with one is told once, before any work.
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

int print_part(const std::vector<std::string>& words) {
    std::vector<Stage> stages;
    for (const char* name : kPlanar) stages.push_back(ask(name));
    if (!words.empty() && (words[0] == "--help" || words[0] == "-h")) return print(print_help(stages)), 0;
    Request request = route(words, stages);
    keep_wished(words, request, stages);
    check_profiles(request, stages);
    std::vector<Command> commands;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        Command command{stages[i].program};
        command.insert(command.end(), request.arguments[i].begin(), request.arguments[i].end());
        if (i + 1 == stages.size() && request.output != "-") command.push_back("--output=" + request.output);
        if (i == 0 && request.input.starts_with("-") && request.input != "-") command.emplace_back("--");
        if (i == 0 && request.input != "-") command.push_back(request.input);
        commands.push_back(std::move(command));
    }
    if (request.dry_run) {
        std::string line;
        for (std::size_t i = 0; i < commands.size(); ++i) {
            line += (i > 0 ? " | " : "") + stages[i].name;
            for (std::size_t w = 1; w < commands[i].size(); ++w) line += " " + shell_word(commands[i][w]);
        }
        return print(line + "\n"), 0;
    }
    if (request.output == "-" && ::isatty(STDOUT_FILENO) != 0)
        throw Error(Exit::usage,
                    "cannot write machine code to a terminal; add -o FILE, as in -o part.gcode, or pipe it on");
    const auto ended = run_piped(commands);
    std::size_t who = 0;
    const int code = verdict(ended, who);
    if (code == 0) return 0;
    if (code == 128 + SIGPIPE) return code; // whoever read the program had enough
    if (ended[who].by_signal)
        throw Error(Exit::failure,
                    "stage '" + stages[who].name + "' was killed by signal " + std::to_string(code - 128));
    if (code == static_cast<int>(Exit::truncated) && who > 0)
        throw Error(Exit::truncated, "stage '" + stages[who].name + "' received an incomplete stream");
    return code; // the stage has said why
}

} // namespace

int front(const std::vector<std::string>& words) {
    const std::string& what = words.at(0);
    const std::vector<std::string> rest(words.begin() + 1, words.end());
    if (what == "print") return print_part(rest);
    if (what == "help" && rest.size() == 1 && rest[0] == "print") return print_part({"--help"});
    if (what == "help" && rest.empty()) become({"/proc/self/exe", "--help"});
    if (what == "help" && rest.size() == 1) become({stage_program(rest[0]), "--help"});
    if (what == "list" || what == "env") {
        if (!rest.empty()) throw Error(Exit::usage, "unexpected argument '" + rest[0] + "'; see 'filum --help'");
        what == "list" ? list() : env();
        return 0;
    }
    Command command{stage_program(what)};
    command.insert(command.end(), rest.begin(), rest.end());
    become(command);
}

} // namespace filum::app::filum
