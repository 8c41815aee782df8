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
    std::atomic<bool> taken = false;   // by an Unfinished
    std::atomic<pid_t> watched_by = 0; // a child between fork and exec must not remove what is its parent's
    std::array<char, PATH_MAX> path{};
};

// A signal handler sees nothing but globals.
std::array<Slot, 32> slots; // NOLINT(cert-err58-cpp)

// Only with what may be called in a signal handler.
void remove(const char* path) {
    if (::unlink(path) == 0 || errno == ENOENT) return;
    const pid_t child = ::fork(); // a folder
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
    std::signal(number, SIG_DFL); // the signal is blocked here, and ends the program when this returns
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

Unfinished::Unfinished(const std::string& path) : slot_(slots.size()) {
    watch_signals();
    for (std::size_t i = 0; i < slots.size() && path.size() < PATH_MAX; ++i) {
        if (slots[i].taken.exchange(true)) continue;
        std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
        slots[i].watched_by = ::getpid();
        slot_ = i;
        return;
    }
}

Unfinished::~Unfinished() {
    if (slot_ == slots.size()) return;
    slots[slot_].watched_by = 0;
    slots[slot_].taken = false;
}

} // namespace filum::stream
