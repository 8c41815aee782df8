// try_surfaces - every algorithm of surfpath on random surfaces, each in a process of its own, under a judge that asks
// none of them
//
// try_surfaces [--same] [--seed S] [--first K] [--count N] [--jobs J] [--seconds T] [--write DIR] [--quiet]
//   Runs the trials K .. K + N - 1 of the seed.  A trial that dies, takes longer than T seconds of processor time, or
//   has faults is printed with what it was.  --write: leaves their surfaces there as streams.  Exit 1 if there is one.
//   --same: compares paths on the same surface in other triangles instead.
#include "stream/writer.hpp"
#include "wire/surface.hpp"

#include "base/error.hpp"
#include "same.hpp"
#include "trial.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace filum;

struct Asked {
    std::uint64_t seed = 1, first = 0, count = 100, jobs = 2, seconds = 60;
    std::string write;
    bool quiet = false, same = false;
};

void leave(const Asked& asked, std::uint64_t number, const surface::Sheet& sheet) {
    stream::Header header;
    header.payload = stream::Payload::surface;
    header.expected = 1;
    stream::Writer out(asked.write + "/" + std::to_string(asked.seed) + "-" + std::to_string(number) + ".surface",
                       header);
    out.write(wire::frame(sheet));
    out.close();
}

// In the child, of --same.  Exits as work().
int work_same(const Asked& asked, std::uint64_t number) {
    try {
        const auto like = trials::compare(asked.seed, number);
        std::printf("%llu %s\n", static_cast<unsigned long long>(number), like.words.c_str());
        for (const auto& f : like.faults) std::printf("  FAULT %s\n", f.c_str());
        std::fflush(stdout);
        return like.faults.empty() ? 0 : 10;
    } catch (const Error& e) {
        std::printf("%llu no trial: %s\n", static_cast<unsigned long long>(number), e.what());
        std::fflush(stdout);
        return 11;
    }
}

// In the child.  Exit 0: good; 10: faults; 11: no trial; 12: refused.
int work(const Asked& asked, std::uint64_t number) {
    std::string words;
    try {
        trials::Trial trial = [&] {
            try {
                return trials::make(asked.seed, number);
            } catch (const Error& e) {
                std::printf("%llu no trial: %s\n", static_cast<unsigned long long>(number), e.what());
                std::fflush(stdout);
                std::_Exit(11);
            }
        }();
        std::printf("%llu %s\n", static_cast<unsigned long long>(number), trial.words.c_str());
        std::fflush(stdout);
        if (!asked.write.empty()) leave(asked, number, trial.sheet);
        const auto out = trials::run(trial);
        for (const auto& f : out.faults) std::printf("  FAULT %s\n", f.c_str());
        const auto& j = out.judged;
        if (!out.refused.empty())
            std::printf("  refused: %s\n", out.refused.c_str());
        else
            std::printf("  area %.0f covered %.3f bare %.3f overlap %.3f crossings %zu doubled %.1f tight %.1f of %.0f "
                        "unmarked %.2f least %.2f\n",
                        j.area, j.covered, j.bare, j.overlap, j.crossings, j.doubled, j.tight, j.length, j.unmarked,
                        j.least_radius);
        std::fflush(stdout);
        return !out.faults.empty() ? 10 : out.refused.empty() ? 0 : 12;
    } catch (const std::exception& e) {
        std::printf("  FAULT internal error: %s\n", e.what());
        std::fflush(stdout);
        return 10;
    }
}

// Starts a trial, its output into a pipe of its own.
struct Running {
    std::uint64_t number;
    std::FILE* output;
};
pid_t start(const Asked& asked, std::uint64_t number, std::FILE* output) {
    std::fflush(stdout);
    const pid_t pid = ::fork();
    if (pid != 0) return pid;
    ::dup2(::fileno(output), STDOUT_FILENO);
    ::dup2(::fileno(output), STDERR_FILENO);
    const rlimit limit{asked.seconds, asked.seconds + 1};
    ::setrlimit(RLIMIT_CPU, &limit);
    std::_Exit(asked.same ? work_same(asked, number) : work(asked, number));
}

std::string text(std::FILE* f) {
    std::string out;
    char part[4096];
    std::rewind(f);
    while (const std::size_t n = std::fread(part, 1, sizeof part, f)) out.append(part, n);
    std::fclose(f);
    return out;
}

int all(const Asked& asked) {
    std::map<pid_t, Running> running;
    std::map<std::string, std::size_t> counts;
    std::uint64_t next = asked.first;
    while (next < asked.first + asked.count || !running.empty()) {
        if (next < asked.first + asked.count && running.size() < asked.jobs) {
            std::FILE* output = std::tmpfile();
            if (output == nullptr) return 5;
            running.insert({start(asked, next, output), {next, output}});
            ++next;
            continue;
        }
        int status = 0;
        const pid_t pid = ::wait(&status);
        const auto it = running.find(pid);
        if (it == running.end()) continue;
        const std::string said = text(it->second.output);
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        std::string kind = code == 0    ? "good"
                           : code == 12 ? "refused"
                           : code == 11 ? "no trial"
                           : code == 10 ? "faulty"
                                        : "died";
        if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) kind = "too long";
        ++counts[kind];
        const bool bad = kind == "faulty" || kind == "died" || kind == "too long";
        if (bad || !asked.quiet) std::printf("%s%s", said.c_str(), bad ? ("  " + kind + "\n").c_str() : "");
        if (kind == "died")
            std::printf("  %llu died: status %d\n", static_cast<unsigned long long>(it->second.number), status);
        running.erase(it);
    }
    std::size_t bad = 0;
    for (const auto& [kind, n] : counts) {
        std::printf("%s: %zu\n", kind.c_str(), n);
        if (kind == "faulty" || kind == "died" || kind == "too long") bad += n;
    }
    return bad == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    Asked asked;
    for (int i = 1; i < argc; ++i) {
        const auto number = [&](const char* name, std::uint64_t& to) {
            if (std::strcmp(argv[i], name) != 0 || i + 1 >= argc) return false;
            to = std::strtoull(argv[++i], nullptr, 10);
            return true;
        };
        if (std::strcmp(argv[i], "--quiet") == 0)
            asked.quiet = true;
        else if (std::strcmp(argv[i], "--same") == 0)
            asked.same = true;
        else if (std::strcmp(argv[i], "--write") == 0 && i + 1 < argc)
            asked.write = argv[++i];
        else if (!number("--seed", asked.seed) && !number("--first", asked.first) && !number("--count", asked.count) &&
                 !number("--jobs", asked.jobs) && !number("--seconds", asked.seconds)) {
            std::fprintf(stderr, "try_surfaces: unknown option '%s'; see the head of try_surfaces.cpp\n", argv[i]);
            return 2;
        }
    }
    return all(asked);
}
