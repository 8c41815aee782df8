#include "stream/frame.hpp"

#include "base/error.hpp"

#include "filum/stream.pb.h"

#include <cmath>

namespace filum::stream {

std::string_view name(Payload p) {
    switch (p) {
    case Payload::layers:
        return "Layers";
    case Payload::regions:
        return "Regions";
    case Payload::paths:
        return "Paths";
    case Payload::toolpath:
        return "Toolpath";
    case Payload::surface:
        return "Surface";
    case Payload::unknown:
        break;
    }
    return "unknown";
}

Tag tag_of(Payload p) {
    switch (p) {
    case Payload::layers:
        return Tag::layer;
    case Payload::regions:
        return Tag::region;
    case Payload::paths:
        return Tag::paths;
    case Payload::toolpath:
        return Tag::span;
    case Payload::surface:
        return Tag::surface;
    case Payload::unknown:
        break;
    }
    throw Error(Exit::failure, "internal error: no tag for an unknown payload");
}

std::string serialise(const Note& n) {
    const bool foreign = n.code == NoteCode::foreign;
    proto::Note m;
    m.set_stage(n.stage);
    m.set_what(foreign ? n.foreign.text : sentence(n));
    m.set_amount(n.amount);
    m.set_unit(unit(n));
    m.set_count(n.count);
    m.set_layer(n.layer);
    m.set_x(n.x);
    m.set_y(n.y);
    if (std::isfinite(n.z)) m.set_z(n.z);
    m.set_code(foreign ? n.foreign.code : code_name(n));
    m.set_grade(static_cast<proto::Grade>(static_cast<int>(code_grade(n)) + 1));
    m.set_detail(n.detail);
    m.set_patch(n.patch);
    m.set_bead(n.bead);
    return m.SerializeAsString();
}

Note parse_note(std::string_view body) {
    proto::Note m;
    if (!m.ParseFromArray(body.data(), static_cast<int>(body.size())))
        throw Error(Exit::bad_input, "cannot read a note frame: malformed");
    Note out{note_code(m.code()), m.amount(), m.count(), m.layer(), m.x(), m.y(), m.has_z() ? m.z() : std::nan(""),
             m.detail(),          m.patch(),  m.stage()};
    if (std::isfinite(m.bead()) && m.bead() > 0) out.bead = m.bead();
    if (out.code != NoteCode::foreign) return out;
    out.foreign = {m.code(), m.what(), m.unit()};
    if (m.grade() >= proto::HARMLESS && m.grade() <= proto::WILL_FAIL)
        out.foreign.grade = static_cast<Grade>(m.grade() - 1);
    return out;
}

std::string serialise(const Fact& f) {
    proto::Fact m;
    m.set_stage(f.stage);
    m.set_name(f.name);
    m.set_value(f.value);
    m.set_unit(f.unit);
    return m.SerializeAsString();
}

Fact parse_fact(std::string_view body) {
    proto::Fact m;
    if (!m.ParseFromArray(body.data(), static_cast<int>(body.size())) || !std::isfinite(m.value()))
        throw Error(Exit::bad_input, "cannot read a fact frame: malformed");
    return {m.stage(), m.name(), m.value(), m.unit()};
}

} // namespace filum::stream
