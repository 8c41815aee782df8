#include "app/filum/watch.hpp"

#include "cli/progress.hpp"

#include <chrono>
#include <fcntl.h>
#include <iostream>
#include <map>
#include <poll.h>
#include <sstream>
#include <unistd.h>

namespace filum::app::filum {

namespace {

constexpr int kPoll = 100;    // ms between two updates
constexpr double kUnseen = 1; // s before the line appears

struct StageProgress {
    std::uint64_t done = 0, expected = 0;
};

class Watch {
  public:
    explicit Watch(const std::vector<std::string>& names) : names_(&names) {
        if (::pipe2(pipe_, O_NONBLOCK) != 0) pipe_[0] = pipe_[1] = -1;
        ::fcntl(pipe_[0], F_SETFD, FD_CLOEXEC);
        ::setenv("FILUM_PROGRESS", std::to_string(pipe_[1]).c_str(), 1);
    }
    ~Watch() {
        ::unsetenv("FILUM_PROGRESS");
        for (const int end : pipe_)
            if (end >= 0) ::close(end);
        if (drawn_) std::cerr << "\r\033[K" << std::flush;
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    void look(const std::vector<bool>& ended) {
        pollfd ready{pipe_[0], POLLIN, 0};
        ::poll(&ready, 1, kPoll);
        char block[4096];
        for (ssize_t n = 0; (n = ::read(pipe_[0], block, sizeof block)) > 0;)
            text_.append(block, static_cast<std::size_t>(n));
        take();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
        if (seconds > kUnseen) draw(ended, seconds);
    }

  private:
    void take() {
        for (std::size_t end = 0; (end = text_.find('\n')) != std::string::npos; text_.erase(0, end + 1)) {
            std::istringstream line(text_.substr(0, end));
            std::string name;
            StageProgress d;
            if (line >> name >> d.done >> d.expected) done_[name] = d;
        }
    }

    void draw(const std::vector<bool>& ended, double seconds) {
        std::size_t at = 0;
        while (at < ended.size() && ended[at]) ++at;
        if (at == ended.size()) return;
        const auto found = done_.find((*names_)[at]);
        const StageProgress d = found == done_.end() ? StageProgress{} : found->second;
        std::cerr << "\r\033[K" << cli::bar((*names_)[at], d.done, d.expected) << "  " << static_cast<long>(seconds)
                  << " s" << std::flush;
        drawn_ = true;
    }

    const std::vector<std::string>* names_;
    int pipe_[2] = {-1, -1};
    std::string text_;
    std::map<std::string, StageProgress> done_;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
    bool drawn_ = false;
};

} // namespace

std::vector<ProcessEnd> run_watched(const std::vector<Command>& commands, const std::vector<std::string>& copies,
                                    const std::vector<std::string>& names, NotePrinters speakers) {
    Watch watch(names);
    return run_piped(
        commands, copies, [&](const std::vector<bool>& ended) { watch.look(ended); }, speakers);
}

} // namespace filum::app::filum
