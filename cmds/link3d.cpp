// link3d - curves to one toolpath
// reads:  Paths
// writes: Toolpath
// memory: two regions
#include "cli/command.hpp"
#include "wire/planar.hpp"

namespace {

using namespace filum;

struct Options {};

cli::Spec spec(Options&) {
    return {.name = "link3d",
            .synopsis = "curves to one toolpath",
            .description = "Links.",
            .in = cli::reads(stream::Payload::paths),
            .out = cli::writes(stream::Payload::toolpath),
            .memory = "two regions",
            .options = {},
            .examples = {
                {"slice part.stl | regions | sequence | fill | link3d > part.toolpath", "the toolpath of a part"}}};
}

void run(const Options&, const cli::Io& io) {
    geom::Vec3 at{};
    bool first = true;
    std::uint32_t stroke = 0;
    cli::scan_stage(
        io, stream::Payload::paths, stream::Payload::toolpath,
        [&](const stream::RawFrame& frame, const auto& emit, Notes&) {
            const auto p = wire::paths(frame);
            for (const auto& c : p.curves) {
                toolpath::Span s{toolpath::Role::bead, 0, p.layer, p.region, {}, {c.width_at(0)}, {p.height}};
                for (const auto q : c.points) s.points.push_back({q.x, q.y, p.z});
                if (c.closed) s.points.push_back(s.points.front());
                if (!first) {
                    emit(wire::frame(toolpath::Span{
                        toolpath::Role::travel, stroke, p.layer, p.region, {at, s.points.front()}, {}, {}}));
                    ++stroke;
                }
                first = false;
                s.stroke = stroke;
                at = s.points.back();
                emit(wire::frame(s));
            }
        });
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
