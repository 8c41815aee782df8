#include "app/metrics/metrics.hpp"

#include "app/metrics/parts.hpp"
#include "stream/sink.hpp"

namespace filum::app::metrics {

void run(const Options& options, const cli::Io& io) {
    for (const auto& [name, given] : {std::pair{"--voids", !options.voids.empty()},
                                      {"--map", !options.map.empty()},
                                      {"--spacing", options.curved.spacing > 0},
                                      {"--step", options.curved.step > 0}})
        if (given && options.surface.empty())
            throw Error(Exit::usage,
                        "cannot use '" + std::string(name) + "' without the surface; name it by --surface");
    const auto figures = options.surface.empty() ? planar(options.plane, io) : curved(options, io);
    cli::write_text(io.output, filum::figures::text(figures, filum::figures::format_named(options.plane.format)));
}

} // namespace filum::app::metrics
