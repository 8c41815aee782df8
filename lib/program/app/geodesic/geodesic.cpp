#include "app/geodesic/geodesic.hpp"

#include "base/error.hpp"
#include "cli/step_options.hpp"
#include "geodesic/lines.hpp"
#include "geodesic/named_sources.hpp"
#include "surface/facing.hpp"

namespace filum::app::geodesic {

namespace {

// Adds a note on components that face inwards, since their paths would be printed from the inside.
void tell_inward(const surface::Surface& s, Notes& notes) {
    const surface::InwardArea in = surface::inward(s);
    if (in.components > 0)
        notes.push_back(
            {NoteCode::surface_faces_inwards, in.area, in.components, -1, in.place.x, in.place.y, in.place.z});
}

filum::geodesic::Sources sources(const Options& o, const Model& model, cli::Io& self, Notes& notes, Facts& facts) {
    const surface::Surface& s = model.sheet.surface;
    auto out = filum::geodesic::named_sources(s, o.source, notes, model.of_file);
    if (!o.lines.empty()) {
        const mesh::Bytes text = load(o.lines, "source_lines_crc32c", self);
        filum::geodesic::add_lines(out, s, filum::geodesic::read_lines(text.view(), "'" + o.lines + "'"), notes);
    }
    if (!o.mesh.empty()) {
        const auto mesh = read_mesh(o.mesh, "source_mesh_crc32c", o.place, self, notes, o.step);
        const Facts met = filum::geodesic::add_mesh(out, s, mesh);
        facts.insert(facts.end(), met.begin(), met.end());
    }
    return out;
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    cli::Io self = io; // its settings get the checksum of the input
    Model m = read(o.place, self, o.step);
    if (o.mesh.empty()) cli::step_idle(io, m.step);
    Facts facts = shape(m, o.shape, o.place, self);
    const Facts size = surface::facts(m.sheet.surface);
    facts.insert(facts.begin(), size.begin(), size.end());
    if (m.before.header.history.empty()) tell_inward(m.sheet.surface, m.notes); // a stream has the note already
    const auto from = sources(o, m, self, m.notes, facts);
    if (!from.empty()) {
        const Facts found = filum::geodesic::measure(m.sheet, from, o.measure, m.notes);
        facts.insert(facts.end(), found.begin(), found.end());
    } else if (!o.measure.levels.empty() || o.measure.spacing > 0 || o.measure.with_sides) {
        throw Error(Exit::usage, "cannot draw isolines, or tell sides, without a source");
    }
    write(m, facts, self);
}

} // namespace filum::app::geodesic
