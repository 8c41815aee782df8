#include "stream/unfinished.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>
#include <sys/wait.h>
#include <unistd.h>

namespace filum::stream {

namespace {

struct Slot {
    std::atomic<bool> taken = false;   // in use by an UnfinishedPath
    std::atomic<pid_t> watched_by = 0; // owner; a child between fork and exec must not remove files of its parent
    std::array<char, PATH_MAX> path{};
};

// Global, because a signal handler has no other access to them.
std::array<Slot, 32> slots; // NOLINT(cert-err58-cpp)

// Removes a file, or a folder with its contents. Calls only functions that are safe in a signal handler.
void remove(const char* path) {
    if (::unlink(path) == 0 || errno == ENOENT) return;
    const pid_t child = ::fork(); // not a file: a folder
    if (child == 0) {
        ::execl("/bin/rm", "rm", "-rf", "--", path, static_cast<char*>(nullptr));
        ::_exit(127);
    }
    int status = 0;
    while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
}

void clean_up(int number) {
    for (Slot& s : slots)
        if (s.watched_by == ::getpid()) remove(s.path.data());
    std::signal(number, SIG_DFL); // the signal is blocked here, so it ends the program when this function returns
    std::raise(number);
}

void watch_signals() {
    static const bool once = [] {
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            struct sigaction now {};
            if (::sigaction(number, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;
            now.sa_handler = clean_up;
            ::sigfillset(&now.sa_mask);
            ::sigaction(number, &now, nullptr);
        }
        return true;
    }();
    (void)once;
}

} // namespace

UnfinishedPath::UnfinishedPath(const std::string& path) : slot_(slots.size()) {
    watch_signals();
    for (std::size_t i = 0; i < slots.size() && path.size() < PATH_MAX; ++i) {
        if (slots[i].taken.exchange(true)) continue;
        std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
        slots[i].watched_by = ::getpid();
        slot_ = i;
        return;
    }
}

UnfinishedPath::~UnfinishedPath() {
    if (slot_ == slots.size()) return;
    slots[slot_].watched_by = 0;
    slots[slot_].taken = false;
}

} // namespace filum::stream
