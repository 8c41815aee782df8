#include "app/filum/process.hpp"

#include "base/error.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace filum::app::filum {

namespace {

constexpr int kPipe = 1 << 20;

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
        read = both[0], write = both[1];
        ::fcntl(write, F_SETPIPE_SZ, kPipe);
    }
};

void close_if_open(int& fd) {
    if (fd >= 0) ::close(fd);
    fd = -1;
}

// The child's side of a fork: only what is allowed between fork and exec.
[[noreturn]] void start(char** argv, pid_t parent, int in, int out, bool chained) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1); // it died before we asked
    if (in >= 0) ::dup2(in, STDIN_FILENO);
    if (out >= 0) ::dup2(out, STDOUT_FILENO);
    if (chained) ::setenv("FILUM_CHAIN", "1", 1);
    ::execv(argv[0], argv);
    ::_exit(127);
}

pid_t spawn(const Command& command, int in, int out, bool chained) {
    auto argv = arguments(command);
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid < 0) fail("start '" + command[0] + "'");
    if (pid == 0) start(argv.data(), parent, in, out, chained);
    return pid;
}

Ended wait_for(pid_t pid) {
    int status = 0;
    while (::waitpid(pid, &status, 0) < 0)
        if (errno != EINTR) return {1, false};
    if (WIFSIGNALED(status)) return {128 + WTERMSIG(status), true};
    return {WEXITSTATUS(status), false};
}

} // namespace

std::string output_of(const Command& command) {
    Pipe pipe;
    const pid_t pid = spawn(command, -1, pipe.write, false);
    close_if_open(pipe.write);
    std::string out;
    char block[4096];
    for (ssize_t n = 0; (n = ::read(pipe.read, block, sizeof block)) != 0;) {
        if (n < 0 && errno != EINTR) break;
        if (n > 0) out.append(block, static_cast<std::size_t>(n));
    }
    close_if_open(pipe.read);
    if (const Ended end = wait_for(pid); end.code != 0)
        throw Error(Exit::failure, "cannot ask '" + command[0] + "': it ended with " + std::to_string(end.code));
    return out;
}

void become(const Command& command) {
    auto argv = arguments(command);
    ::execv(argv[0], argv.data());
    fail("start '" + command[0] + "'");
}

std::vector<Ended> run_piped(const std::vector<Command>& commands) {
    std::vector<pid_t> children;
    int in = -1;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        int out = -1, next = -1;
        if (i + 1 < commands.size()) {
            const Pipe pipe;
            out = pipe.write, next = pipe.read;
        }
        children.push_back(spawn(commands[i], in, out, i > 0));
        close_if_open(in);
        close_if_open(out);
        in = next;
    }
    std::vector<Ended> ended;
    for (const pid_t pid : children) ended.push_back(wait_for(pid));
    return ended;
}

int verdict(const std::vector<Ended>& ended, std::size_t& who) {
    int code = 0;
    for (std::size_t i = 0; i < ended.size(); ++i) {
        const Ended& e = ended[i];
        if (e.code == 0) continue;
        const bool follows = (e.by_signal && e.code == 128 + SIGPIPE) ||
                             (!e.by_signal && i > 0 && e.code == static_cast<int>(Exit::truncated));
        if (code == 0 || !follows) code = e.code, who = i;
        if (!follows) break;
    }
    return code;
}

} // namespace filum::app::filum
