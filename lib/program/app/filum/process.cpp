#include "app/filum/process.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace filum::app::filum {

namespace {

constexpr int kPipe = 1 << 20;
constexpr const char* kTee = "tee"; // program of coreutils that copies a pipe to a file

[[noreturn]] void fail(const std::string& what) {
    throw Error(Exit::failure, "cannot " + what + ": " + std::strerror(errno));
}

std::vector<char*> arguments(const Command& command) {
    std::vector<char*> out;
    for (const auto& word : command) out.push_back(const_cast<char*>(word.c_str()));
    out.push_back(nullptr);
    return out;
}

struct Pipe {
    int read = -1, write = -1;
    Pipe() {
        int both[2];
        if (::pipe2(both, O_CLOEXEC) != 0) fail("make a pipe");
        read = both[0];
        write = both[1];
        ::fcntl(write, F_SETPIPE_SZ, kPipe);
    }
};

void close_if_open(int& fd) {
    if (fd >= 0) ::close(fd);
    fd = -1;
}

// The place of a child in a chain.
struct Place {
    bool chained = false;        // another stage writes its input, and reports its own failure
    const char* notes = nullptr; // FILUM_NOTES: "later": the last stage prints its notes; "all": it prints all notes
};

// Runs in the child after a fork.  It only calls functions that are allowed between fork and exec.
[[noreturn]] void start(char** argv, pid_t parent, int in, int out, const Place& place) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1); // the parent ended before prctl took effect
    if (in >= 0) ::dup2(in, STDIN_FILENO);
    if (out >= 0) ::dup2(out, STDOUT_FILENO);
    if (place.chained) ::setenv("FILUM_CHAIN", "1", 1);
    if (place.notes != nullptr) ::setenv("FILUM_NOTES", place.notes, 1);
    ::execvp(argv[0], argv);
    ::_exit(127);
}

pid_t spawn(const Command& command, int in, int out, const Place& place) {
    auto argv = arguments(command);
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid < 0) fail("start '" + command[0] + "'");
    if (pid == 0) start(argv.data(), parent, in, out, place);
    return pid;
}

ProcessEnd how(int status) {
    if (WIFSIGNALED(status)) return {128 + WTERMSIG(status), true};
    return {WEXITSTATUS(status), false};
}

ProcessEnd wait_for(pid_t pid) {
    int status = 0;
    while (::waitpid(pid, &status, 0) < 0)
        if (errno != EINTR) return {1, false};
    return how(status);
}

std::optional<ProcessEnd> ended_by_now(pid_t pid) {
    int status = 0;
    if (::waitpid(pid, &status, WNOHANG) != pid) return std::nullopt;
    return how(status);
}

} // namespace

std::string output_of(const Command& command, bool silently) {
    Pipe pipe;
    int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC); // a program without --print-contract could wait for input
    const pid_t pid =
        spawn(silently ? Command{"/bin/sh", "-c", "exec \"$0\" \"$@\" 2>/dev/null", command[0], command[1]} : command,
              nothing, pipe.write, {});
    close_if_open(nothing);
    close_if_open(pipe.write);
    std::string out;
    char block[4096];
    for (ssize_t n = 0; (n = ::read(pipe.read, block, sizeof block)) != 0;) {
        if (n < 0 && errno != EINTR) break;
        if (n > 0) out.append(block, static_cast<std::size_t>(n));
    }
    close_if_open(pipe.read);
    if (const ProcessEnd end = wait_for(pid); end.code != 0)
        throw Error(Exit::failure, "cannot ask '" + command[0] + "': it ended with " + std::to_string(end.code));
    return out;
}

void become(const Command& command) {
    auto argv = arguments(command);
    ::execvp(argv[0], argv.data());
    fail("start '" + command[0] + "'");
}

namespace {

// The children of a chain, in their order.  `copies`: whether the child copies a stream instead of running a command.
struct Children {
    std::vector<pid_t> pids;
    std::vector<bool> copies;
};

Children start_all(const std::vector<Command>& commands, const std::vector<std::string>& copies,
                   NotePrinters speakers) {
    Children out;
    int in = -1;
    const auto add = [&](const Command& command, bool last, const Place& place, bool copy) {
        int to = -1, next = -1;
        if (!last) {
            const Pipe pipe;
            to = pipe.write;
            next = pipe.read;
        }
        out.pids.push_back(spawn(command, in, to, place));
        out.copies.push_back(copy);
        close_if_open(in);
        close_if_open(to);
        in = next;
    };
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const bool last = i + 1 == commands.size();
        add(commands[i], last, {i > 0, speakers == NotePrinters::each ? nullptr : last ? "all" : "later"}, false);
        if (i + 1 < commands.size() && i < copies.size() && !copies[i].empty())
            add({kTee, copies[i]}, false, {true}, true);
    }
    return out;
}

} // namespace

std::vector<ProcessEnd> run_piped(const std::vector<Command>& commands, const std::vector<std::string>& copies,
                                  const Look& look, NotePrinters speakers) {
    const Children children = start_all(commands, copies, speakers);
    std::vector<std::optional<ProcessEnd>> ended(children.pids.size());
    const auto all = [&] {
        return std::all_of(ended.begin(), ended.end(), [](const auto& e) { return e.has_value(); });
    };
    while (look && !all()) {
        std::vector<bool> done;
        for (std::size_t i = 0; i < ended.size(); ++i) {
            if (!ended[i]) ended[i] = ended_by_now(children.pids[i]);
            if (!children.copies[i]) done.push_back(ended[i].has_value());
        }
        look(done);
    }
    std::vector<ProcessEnd> out;
    bool copied = true;
    for (std::size_t i = 0; i < ended.size(); ++i) {
        const ProcessEnd end = ended[i] ? *ended[i] : wait_for(children.pids[i]);
        if (!children.copies[i])
            out.push_back(end);
        else
            copied = copied && (end.code == 0 || end.by_signal);
    }
    if (!copied) throw Error(Exit::io, "cannot keep the streams: a copy could not be written; is the disk full?");
    return out;
}

int verdict(const std::vector<ProcessEnd>& ended, std::size_t& who) {
    int code = 0;
    for (std::size_t i = 0; i < ended.size(); ++i) {
        const ProcessEnd& e = ended[i];
        if (e.code == 0) continue;
        const bool follows = (e.by_signal && e.code == 128 + SIGPIPE) ||
                             (!e.by_signal && i > 0 && e.code == static_cast<int>(Exit::truncated));
        if (code == 0 || !follows) {
            code = e.code;
            who = i;
        }
        if (!follows) break;
    }
    return code;
}

} // namespace filum::app::filum
