// The throughput of an empty hop: a stage that only copies Paths, between two real pipes.
// Prints for each kind of hop, by number of curve points in a frame: wall seconds, the hop's own CPU seconds, and
// million points a second (16 bytes a point: x and y as doubles; the width is one for all of a curve).
//   bench_hop [MILLION_POINTS]
#include "base/error.hpp"
#include "stream/reader.hpp"
#include "stream/writer.hpp"
#include "wire/planar.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace filum;

stream::Header header() { return {stream::Payload::paths, {{"hop", "1", {}, {}}}, 0}; }

void produce(std::size_t points, std::size_t per_frame) {
    toolpath::RegionPaths region;
    region.height = 0.2;
    region.area = 1;
    region.curves.push_back({true, {}, {0.4}});
    for (std::size_t i = 0; i < per_frame; ++i) {
        const double angle = 0.01 * static_cast<double>(i);
        region.curves[0].points.push_back({angle * std::cos(angle), angle * std::sin(angle)});
    }
    const auto frame = wire::frame(region);
    stream::Writer writer("-", header());
    for (std::size_t n = 0; n < points; n += per_frame) writer.write(frame);
    writer.close();
}

void copy(bool understand) {
    stream::Reader reader("-", stream::Payload::paths);
    stream::Writer writer("-", header());
    while (auto frame = reader.next()) writer.write(understand ? wire::frame(wire::paths(*frame)) : *frame);
    writer.close();
}

void consume() {
    char block[1 << 16];
    while (::read(STDIN_FILENO, block, sizeof block) > 0) {
    }
}

// Runs `work` in a child process between two descriptors.
pid_t child(int in, int out, const std::vector<int>& others, const std::function<void()>& work) {
    const pid_t pid = ::fork();
    if (pid != 0) return pid;
    ::dup2(in, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    for (const int fd : others) ::close(fd);
    try {
        work();
        std::_Exit(0);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "bench_hop: %s\n", e.what());
    }
    std::_Exit(1);
}

double cpu_of(pid_t pid, bool& fine) {
    int status = 0;
    rusage used{};
    ::wait4(pid, &status, 0, &used);
    fine = fine && status == 0;
    const auto seconds = [](timeval t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

bool measure(const char* name, std::size_t points, std::size_t per_frame, const std::function<void()>& hop) {
    int a[2], b[2];
    if (::pipe(a) != 0 || ::pipe(b) != 0) return false;
    const std::vector<int> all{a[0], a[1], b[0], b[1]};
    const auto start = std::chrono::steady_clock::now();
    const pid_t first = child(STDIN_FILENO, a[1], all, [&] { produce(points, per_frame); });
    const pid_t middle = child(a[0], b[1], all, hop);
    const pid_t last = child(b[0], STDOUT_FILENO, all, consume);
    for (const int fd : all) ::close(fd);
    bool fine = true;
    cpu_of(first, fine);
    const double cpu = cpu_of(middle, fine);
    cpu_of(last, fine);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    const double million = static_cast<double>(points) / 1e6;
    std::printf("%-22s %8zu points/frame  wall %6.3f s  cpu %6.3f s  %6.1f Mpoint/s  %6.1f Mpoint/cpu-s\n", name,
                per_frame, wall.count(), cpu, million / wall.count(), million / cpu);
    return fine;
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t points = 1'000'000 * static_cast<std::size_t>(argc > 1 ? std::atoi(argv[1]) : 50);
    ::mallopt(M_MMAP_THRESHOLD, 256 << 20); // as every command does
    ::mallopt(M_TRIM_THRESHOLD, 256 << 20);
    bool fine = true;
    for (const std::size_t per_frame : {1000U, 10'000U, 100'000U, 1'000'000U}) {
        fine = measure("copy", points, per_frame, [] { copy(false); }) && fine;
        fine = measure("copy, parsed and back", points, per_frame, [] { copy(true); }) && fine;
    }
    return fine ? 0 : 1;
}
