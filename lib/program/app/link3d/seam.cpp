#include "app/link3d/seam.hpp"

#include "app/modifier/modifier.hpp"
#include "mesh/read.hpp"
#include "stream/crc32c.hpp"

namespace filum::app::link3d {

PaintedSeams::PaintedSeams(const std::string& file, filum::link3d::Options& how, cli::Io& io) {
    if (file.empty()) return;
    io.settings.push_back({"seam-in", "FILE", true}); // files have no names in the history
    io.settings.push_back({"seam-in_crc32c", stream::crc32c_text(mesh::load(file).view())});
    const auto faces = std::make_shared<modifier::SeamFaces>();
    how.paint = [faces](double z) {
        return filum::link3d::SeamPaint{modifier::lines_at(faces->wanted, z), modifier::lines_at(faces->unwanted, z)};
    };
    begin_.begin = [faces, file](const stream::Header& header, Notes& notes) {
        *faces = modifier::seam_faces(file, header, notes);
    };
    begin_.drop = [](const Note& note) {
        return note.code == NoteCode::project_paint_unused && note.detail == "seams";
    };
}

} // namespace filum::app::link3d
