#include "app/filum/front.hpp"

#include "app/filum/print.hpp"
#include "app/filum/process.hpp"
#include "app/filum/stage.hpp"
#include "base/error.hpp"
#include "base/shell.hpp"
#include "stream/sink.hpp"

#include <algorithm>
#include <filesystem>

namespace filum::app::filum {

namespace {

void show(const std::string& text) {
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
    show(out);
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
    show(out);
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
