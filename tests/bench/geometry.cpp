// Micro benchmarks of the planar geometry: how the cost grows with the number of vertices.
// cmake --preset release -DFILUM_BENCH=ON && ninja -C build bench_geometry && build/tests/bench_geometry
#include "fill/fill.hpp"
#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "stream/crc32c.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <malloc.h>
#include <numbers>
#include <string>

namespace {

using namespace filum;

// A gear-like outline of n vertices with a wavy hole: teeth 3 mm apart, so that the area grows with n as real slices of
// larger parts do, at ten vertices per millimetre of outline.
polygon::Loops gear(std::size_t n) {
    const double turn = 2 * std::numbers::pi;
    const double radius = static_cast<double>(n) / 10 / turn;
    const double teeth = std::round(turn * radius / 3);
    polygon::Loops out;
    const auto ring = [&](double r, double wave, bool reversed) {
        for (std::size_t i = 0; i < n / 2; ++i) {
            const double angle = turn * static_cast<double>(i) / static_cast<double>(n / 2) * (reversed ? -1 : 1);
            const double at = r + wave * std::sin(teeth * angle);
            out.points.push_back({at * std::cos(angle), at * std::sin(angle)});
        }
        out.close();
    };
    ring(radius, 0.8, false);
    ring(std::max(0.5 * radius, radius - 12), 0.4, true); // a wall of at most 12 mm, so area is linear in n
    return out;
}

void offset_inward(benchmark::State& state) {
    const auto loops = gear(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(polygon::offset(loops, -0.2));
    state.SetComplexityN(state.range(0));
}

void unite(benchmark::State& state) {
    const auto loops = gear(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(polygon::unite(loops));
    state.SetComplexityN(state.range(0));
}

void simplify(benchmark::State& state) {
    const auto loops = gear(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(polygon::simplify(loops, 0.001));
    state.SetComplexityN(state.range(0));
}

void segment_grid(benchmark::State& state) {
    const auto loops = gear(static_cast<std::size_t>(state.range(0)));
    std::vector<geom::Segment> segments;
    for (std::size_t k = 0; k < loops.size(); ++k) {
        const auto loop = loops[k];
        for (std::size_t i = 0; i < loop.size(); ++i) segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
    }
    for (auto _ : state) {
        const geom::SegmentGrid grid(segments, 0.8);
        std::size_t met = 0;
        for (const auto& s : segments)
            grid.near({s.a.x - 0.4, s.a.y - 0.4}, {s.a.x + 0.4, s.a.y + 0.4}, [&](std::uint32_t) { ++met; });
        benchmark::DoNotOptimize(met);
    }
    state.SetComplexityN(state.range(0));
}

// One region by `fill` with its defaults: the curve that the pipeline lays.
void fill_region(benchmark::State& state) {
    polygon::Region region;
    region.height = 0.2;
    region.loops = gear(static_cast<std::size_t>(state.range(0)));
    region.area = polygon::signed_area(region.loops);
    Notes notes;
    benchmark::DoNotOptimize(fill::fill(region, {}, notes)); // takes the memory that the measured passes use again
    for (auto _ : state) benchmark::DoNotOptimize(fill::fill(region, {}, notes));
    state.SetComplexityN(state.range(0));
    state.counters["mm2/s"] = benchmark::Counter(region.area, benchmark::Counter::kIsIterationInvariantRate);
}

void crc32c(benchmark::State& state) {
    const std::string bytes(static_cast<std::size_t>(state.range(0)), 'x');
    for (auto _ : state) benchmark::DoNotOptimize(stream::crc32c(0, bytes.data(), bytes.size()));
    state.SetBytesProcessed(state.iterations() * state.range(0));
}

BENCHMARK(unite)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(offset_inward)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(simplify)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(segment_grid)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(fill_region)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(crc32c)->Arg(64 << 20)->Unit(benchmark::kMillisecond);

} // namespace

// Memory that one pass gives back is kept for the next: otherwise only large inputs would pay for new pages each time.
int main(int argc, char** argv) {
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, -1);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
}
