#include "app/slice/slice.hpp"

#include "app/slice/sizes.hpp"
#include "cli/step_options.hpp"
#include "slice/volume.hpp"
#include "stream/crc32c.hpp"
#include "wire/planar.hpp"

#include <cstdio>

namespace filum::app::slice {

namespace {

using filum::slice::Sweep;

// Notes how the file is known again: by its content, as its name may not tell.
mesh::File read(const Options& o, cli::Io& self) {
    const mesh::Bytes bytes = mesh::load(self.input);
    char crc[9];
    std::snprintf(crc, sizeof crc, "%08x", stream::crc32c(0, bytes.data.get(), bytes.size));
    self.settings.push_back({"input_crc32c", crc});
    return mesh::step::read(bytes.view(), mesh::spoken_name(self.input), o.step);
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    cli::Io self = io;
    mesh::File file = read(o, self);
    cli::step_idle(io, file.kind == mesh::Kind::step);
    Notes notes = std::move(file.notes);
    check_precision(file.mesh, notes);
    mesh::place(file.mesh, o.place, mesh::states_unit(file.kind), notes);
    const mesh::Box3 box = mesh::bounds(file.mesh);
    const bool unit_known = mesh::states_unit(file.kind) || o.place.unit != "mm" || o.place.scale != std::vector{1.0};
    check_size(box, unit_known, notes);
    if (!o.machine.empty()) check_bed(box, o.machine);
    const filum::slice::Part part = filum::slice::make_part(std::move(file.mesh), notes, o.slice.hairline);
    const Sweep sweep = filum::slice::prepare(part, o.slice, io.threads, notes);
    const auto measured = filum::slice::judge(sweep, io.threads, notes);
    auto header = cli::header(self, stream::Payload::layers);
    header.expected = sweep.levels.size();
    std::vector<double> area(sweep.levels.size(), 0);
    const auto work = [&](std::size_t chunk, Notes& found) {
        filum::slice::Cut cut = filum::slice::cut(sweep, chunk);
        found = std::move(cut.notes);
        std::vector<stream::RawFrame> frames;
        for (const auto& layer : cut.layers) {
            area[layer.index] = polygon::signed_area(layer.contours);
            frames.push_back(wire::frame(layer));
        }
        return frames;
    };
    cli::source_stage(io, header, sweep.chunks(), std::move(notes), work,
                      [&](Notes& last) { filum::slice::compare(sweep, measured, area, io.threads, last); });
}

} // namespace filum::app::slice
