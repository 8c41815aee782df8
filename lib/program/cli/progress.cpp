#include "cli/progress.hpp"

#include "cli/command.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <sys/stat.h>
#include <unistd.h>

namespace filum::cli {

namespace {

constexpr std::uint64_t kOften = 16; // number of steps between two lines to FILUM_PROGRESS

// The progress of this process: Progress counts it, and Clock draws it.
struct ProcessProgress {
    std::atomic<std::uint64_t> done = 0, expected = 0;
};
ProcessProgress far_;

void put(int file, const std::string& text) {
    if (::write(file, text.data(), text.size()) < 0) return; // a failed write only loses one status line
}

bool watched(const Io& io) {
    struct stat info {};
    const bool piped = ::fstat(STDOUT_FILENO, &info) == 0 && S_ISFIFO(info.st_mode);
    const bool printed = io.output == "-" && ::isatty(STDOUT_FILENO) != 0;
    return !io.quiet && !piped && !printed && ::isatty(STDERR_FILENO) != 0 && std::getenv("FILUM_PROGRESS") == nullptr;
}

void tick(const std::stop_token& stop, const std::string& program) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    bool drawn = false;
    for (long seconds = 1;; ++seconds) {
        wake.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
        if (stop.stop_requested()) break;
        put(STDERR_FILENO, "\r\033[K" + bar(program, far_.done, far_.expected) + "  " + std::to_string(seconds) + " s");
        drawn = true;
    }
    if (drawn) put(STDERR_FILENO, "\r\033[K");
}

} // namespace

std::string bar(const std::string& name, std::uint64_t done, std::uint64_t expected) {
    if (done == 0 && expected == 0) return name;
    if (expected == 0) return name + ": " + std::to_string(done);
    constexpr std::uint64_t width = 30;
    const std::uint64_t filled = std::min(width, done * width / expected);
    const std::string percent = std::to_string(std::min<std::uint64_t>(100, done * 100 / expected));
    return name + " [" + std::string(filled, '#') + std::string(width - filled, ' ') + "] " +
           std::string(3 - percent.size(), ' ') + percent + " %";
}

Progress::Progress(const Io& io, std::uint64_t expected) : program_(io.program), expected_(expected) {
    if (const char* told = std::getenv("FILUM_PROGRESS")) told_ = std::atoi(told);
    far_.expected = expected;
}

Progress::~Progress() {
    far_.done = 0;
    far_.expected = 0;
}

void Progress::reach(std::uint64_t done) {
    const std::uint64_t before = done_;
    if (done <= before) return;
    far_.done = done_ = done;
    if (told_ < 0 || (done_ / kOften == before / kOften && done_ != expected_)) return;
    put(told_, program_ + " " + std::to_string(done_) + " " + std::to_string(expected_) + "\n");
}

Clock::Clock(const Io& io) {
    if (watched(io))
        ticks_ = std::jthread([program = io.program](const std::stop_token& stop) { tick(stop, program); });
}

Clock::~Clock() = default; // stops the thread and waits for it

} // namespace filum::cli
