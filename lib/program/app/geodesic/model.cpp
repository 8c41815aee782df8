#include "app/geodesic/model.hpp"

#include "base/error.hpp"
#include "cli/output.hpp"
#include "mesh/seams.hpp"
#include "stream/crc32c.hpp"
#include "stream/reader.hpp"
#include "wire/surface.hpp"

#include <algorithm>

namespace filum::app::geodesic {

namespace {

void identify(const mesh::Bytes& bytes, const char* setting, cli::Io& self) {
    self.settings.push_back({setting, stream::crc32c_text(bytes.view())});
}

mesh::Mesh placed(const mesh::Bytes& bytes, const std::string& path, mesh::Placement place, Notes& notes,
                  const mesh::step::Tessellation& how, bool* step = nullptr) {
    mesh::File file = mesh::step::read(bytes.view(), mesh::spoken_name(path), how);
    notes.insert(notes.end(), file.notes.begin(), file.notes.end());
    mesh::tell_uncut(file, notes);
    if (step != nullptr) *step = file.kind == mesh::Kind::step;
    place.on_bed = false;
    mesh::place(file.mesh, place, mesh::states_unit(file.kind), notes);
    mesh::join_seams(file.mesh, notes);
    return std::move(file.mesh);
}

Model of_stream(const mesh::Bytes& bytes, const mesh::Placement& place, const std::string& path) {
    if (place.unit != "mm" || place.scale != std::vector<double>{1})
        throw Error(Exit::usage, "cannot use --unit or --scale on a Surface stream: it is in mm; use them where the "
                                 "mesh is read");
    Model out;
    std::size_t surfaces = 0;
    out.before = cli::read_all(stream::Reader(bytes.view(), mesh::spoken_name(path), stream::Payload::surface),
                               [&](const stream::RawFrame& frame) {
                                   out.sheet = wire::sheet(frame);
                                   ++surfaces;
                               });
    if (surfaces != 1)
        throw Error(Exit::bad_input, "cannot use " + mesh::spoken_name(path) + ": it holds " +
                                         std::to_string(surfaces) +
                                         " surfaces, not one; take one by 'partition --only'");
    return out;
}

} // namespace

mesh::Bytes load(const std::string& path, const char* setting, cli::Io& self) {
    mesh::Bytes bytes = mesh::load(path);
    identify(bytes, setting, self);
    return bytes;
}

mesh::Mesh read_mesh(const std::string& path, const char* setting, mesh::Placement place, cli::Io& self, Notes& notes,
                     const mesh::step::Tessellation& how) {
    return placed(load(path, setting, self), path, std::move(place), notes, how);
}

Model read(const mesh::Placement& place, cli::Io& self, const mesh::step::Tessellation& how) {
    const mesh::Bytes bytes = mesh::load(self.input);
    if (stream::is_stream(bytes.view())) return of_stream(bytes, place, self.input);
    identify(bytes, "input_crc32c", self);
    Model out;
    mesh::Mesh mesh = placed(bytes, self.input, place, out.notes, how, &out.step);
    out.sheet.surface = surface::connect(std::move(mesh), out.notes, &out.sheet.faces, &out.of_file);
    return out;
}

void write(const Model& model, const Facts& facts, const cli::Io& self) {
    auto header = cli::header(self, stream::Payload::surface, {&model.before.header});
    header.expected = 1;
    cli::Output output(self, header);
    output.pass_on(model.before, [&](const Fact& old) {
        const auto same = [&](const Fact& f) { return f.name == old.name; };
        return old.stage != self.program || std::none_of(facts.begin(), facts.end(), same);
    });
    output.add(model.notes);
    output.add(facts);
    output.write(wire::frame(model.sheet));
    output.close();
}

} // namespace filum::app::geodesic
