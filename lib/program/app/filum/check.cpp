#include "app/filum/check.hpp"

#include "app/filum/folder.hpp"
#include "app/filum/process.hpp"
#include "app/filum/stage.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/shell.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

namespace filum::app::filum {

namespace {

constexpr const char* kPatience = "20"; // s, time limit of a run

// A hollow box and, beside it, a single open triangle.  The stages before the tested one write a note on the triangle.
constexpr const char* kPart =
    "OFF\n19 25 0\n0 0 0\n12 0 0\n12 9 0\n0 9 0\n0 0 1\n12 0 1\n12 9 1\n0 9 1\n"
    "4 3 0\n8 3 0\n8 6 0\n4 6 0\n4 3 1\n8 3 1\n8 6 1\n4 6 1\n20 0 0\n22 0 1\n20 2 1\n"
    "3 0 3 2\n3 0 2 1\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
    "3 3 0 4\n3 3 4 7\n3 8 10 11\n3 8 9 10\n3 12 14 13\n3 12 15 14\n3 8 13 9\n3 8 12 13\n"
    "3 9 14 10\n3 9 13 14\n3 10 15 11\n3 10 14 15\n3 11 12 8\n3 11 15 12\n3 16 17 18\n";

std::string content(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::string& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

class Check {
  public:
    Check(const Stage& as, const std::string& program) : as_(as), program_(program) { prepare(); }

    int all() {
        wellformed();
        say("the same bytes twice", run("input", "again") == 0 && content(at("again")) == content(at("output")),
            "two runs differ");
        notes();
        damaged();
        const int other = run("other", "bad");
        say("another payload is refused with 3", other == 3, ended(other));
        const int option = shell(word(program_) + " --no-such-option < " + in("input") + " > " + in("bad"));
        say("an unknown option is refused with 2", option == 2, ended(option));
        const int gone = shell(word(program_) + " < " + in("input") + " | head -c 10 > " + in("bad"));
        say("a reader that leaves ends it", gone != kTooLong, ended(gone));
        const int full = shell("test -w /dev/full || exit 1; " + word(program_) + " < " + in("input") + " > /dev/full");
        say("a full disk is an error", full != 0 && full != kTooLong, ended(full));
        std::cout << (failed_ == 0 ? "all promises kept\n" : std::to_string(failed_) + " promises broken\n")
                  << std::flush;
        return failed_ == 0 ? 0 : 1;
    }

  private:
    static constexpr int kTooLong = 124; // exit code of `timeout`

    static std::string word(const std::string& text) { return shell_word(text); }
    [[nodiscard]] std::string at(const std::string& name) const { return folder_.file(name); }
    [[nodiscard]] std::string in(const std::string& name) const { return word(folder_.file(name)); }

    static std::string ended(int code) {
        return code == kTooLong ? std::string("it does not end within ") + kPatience + " s"
                                : "it ends with " + std::to_string(code);
    }

    // Runs a line in a shell without standard error, and returns the exit code.
    static int shell(const std::string& line) {
        return run_piped({{"timeout", kPatience, "sh", "-c", "exec 2>/dev/null; " + line}}).front().code;
    }
    [[nodiscard]] int run(const std::string& input, const std::string& output) const {
        return shell(word(program_) + " < " + in(input) + " > " + in(output));
    }
    [[nodiscard]] bool whole(const std::string& name) const {
        return shell(word(stage_program("peek")) + " --check " + in(name)) == 0;
    }
    [[nodiscard]] std::string told(const std::string& name) const {
        return output_of({stage_program("peek"), "--text", at(name)});
    }

    // Makes two files: "input", a stream as the tested stage takes it, and "other", a stream of another payload.
    void prepare() {
        write(at("part.off"), kPart);
        std::string line = "cat " + in("part.off");
        for (const char* name : kPlanar) {
            if (as_.name == name) break;
            if (std::string_view(name) == "vase")
                continue; // the stages behind `vase` are tested with a part that is no vase
            line += " | " + word(stage_program(name));
        }
        if (shell(line + " > " + in("input")) != 0) throw Error(Exit::failure, "cannot make an input for the check");
        const std::string far = as_.in == "stream Layers"
                                    ? " | " + word(stage_program("regions")) + " | " + word(stage_program("sequence"))
                                    : "";
        if (shell("cat " + in("part.off") + " | " + word(stage_program("slice")) + far + " > " + in("other")) != 0)
            throw Error(Exit::failure, "cannot make an input for the check");
    }

    void say(const std::string& promise, bool kept, const std::string& otherwise) {
        std::cout << (kept ? "kept    " : "BROKEN  ") << promise << (kept ? "" : ": " + otherwise) << std::endl;
        failed_ += kept ? 0 : 1;
    }

    void wellformed() {
        const int code = run("input", "output");
        say("a good input ends with 0", code == 0, ended(code));
        if (!as_.out.starts_with("stream ")) return;
        say("its output is a whole stream", whole("output"), "'peek --check' refuses it");
        const std::string payload = as_.out.substr(7);
        std::istringstream text(whole("output") ? told("output") : "");
        std::string first;
        std::getline(text, first);
        say("it carries " + payload, first.find(payload) != std::string::npos, "it says '" + first + "'");
    }

    // Tests that notes, facts and history of the stages before are passed on.
    void notes() {
        if (!as_.out.starts_with("stream ") || !whole("output")) return;
        const std::string before = told("input"), after = told("output");
        const auto kept = [&](const std::string& kind) {
            std::istringstream lines(before);
            for (std::string line; std::getline(lines, line);)
                if (line.starts_with(kind) && after.find(line) == std::string::npos) return false;
            return true;
        };
        say("notes of the stages before go on", kept("note "), "one is lost");
        say("facts of the stages before go on", kept("fact "), "one is lost");
        say("the history of the stages before goes on", kept("run "), "a run is lost");
    }

    // Runs the program on a damaged stream.  Returns the fault: an exit code that is not in `right`, or a whole stream
    // as output.  Returns "" if there is no fault.
    [[nodiscard]] std::string taken(const std::string& bytes, const std::vector<int>& right) const {
        write(at("damaged"), bytes);
        const int code = run("damaged", "bad");
        if (std::find(right.begin(), right.end(), code) == right.end()) return ended(code);
        return as_.out.starts_with("stream ") && whole("bad") ? ended(code) + " and lets it pass" : "";
    }

    void damaged() {
        const std::string good = content(at("input"));
        std::string wrong;
        const auto attempt = [&](const std::string& bytes, const std::string& what, const std::vector<int>& right) {
            const std::string otherwise = wrong.empty() ? taken(bytes, right) : "";
            if (!otherwise.empty()) wrong = what + ": " + otherwise;
        };
        std::vector<std::size_t> cuts;
        for (std::size_t k = 0; k < 12; ++k) cuts.push_back(good.size() * k / 12);
        cuts.push_back(good.size() - 1);
        for (const std::size_t cut : cuts)
            attempt(good.substr(0, cut), "cut after " + std::to_string(cut) + " bytes", {4});
        say("a truncated input is refused with 4, and no whole output made of it", wrong.empty(), wrong);
        wrong.clear();
        for (std::size_t k = 1; k < 12; ++k) {
            const std::size_t byte = good.size() * k / 12;
            std::string flipped = good;
            flipped[byte] = static_cast<char>(~flipped[byte]);
            attempt(flipped, "byte " + std::to_string(byte) + " flipped", {3, 4});
        }
        say("a flipped byte is refused with 3 or 4", wrong.empty(), wrong);
    }

    Stage as_;
    std::string program_;
    Folder folder_;
    int failed_ = 0;
};

} // namespace

int check_foreign(const std::vector<std::string>& words) {
    std::string program, as;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--as" && i + 1 < words.size())
            as = words[++i];
        else if (words[i].starts_with("--as="))
            as = words[i].substr(5);
        else if (words[i].starts_with("-") || !program.empty())
            throw Error(Exit::usage, "unexpected argument '" + words[i] + "'; as in 'filum check ./mine --as fill'");
        else
            program = words[i];
    }
    if (program.empty() || as.empty())
        throw Error(Exit::usage, "cannot check without a program and a stage; as in 'filum check ./mine --as fill'");
    const std::vector<std::string> known(std::begin(kPlanar) + 1, std::end(kPlanar) - 1);
    if (std::find(known.begin(), known.end(), as) == known.end()) {
        std::string all;
        for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
        throw Error(Exit::usage, "cannot check as '" + as + "': it must be one of " + all + did_you_mean(as, known));
    }
    const Stage stage = ask(as);
    return Check(stage, std::filesystem::absolute(foreign(stage, program).program).string()).all();
}

} // namespace filum::app::filum
