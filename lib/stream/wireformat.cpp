#include "stream/wireformat.hpp"

#include "base/error.hpp"

#include "filum/stream.pb.h"

namespace filum::stream {

void be_quiet() { google::protobuf::SetLogHandler(nullptr); }

std::string preamble() {
    proto::Preamble m;
    m.set_magic(kMagic);
    m.set_version(kVersion);
    const std::string body = m.SerializeAsString();
    std::string out;
    append_varint(out, body.size());
    return out + body;
}

std::string frame_prefix(Tag tag, std::size_t body) {
    std::string inner;
    append_varint(inner, static_cast<std::uint64_t>(tag) << 3 | 2);
    append_varint(inner, body);
    std::string out;
    append_varint(out, inner.size() + body);
    return out + inner;
}

std::string serialise(const Header& header) {
    proto::Header m;
    m.set_payload(static_cast<proto::Payload>(header.payload));
    m.set_units("mm");
    m.set_expected(header.expected);
    for (const Run& run : header.history) {
        auto* r = m.add_history();
        r->set_program(run.program);
        r->set_version(run.version);
        for (const Setting& s : run.settings) {
            auto* t = r->add_settings();
            t->set_name(s.name);
            t->set_value(s.value);
            t->set_changed(s.changed);
        }
        for (const auto parent : run.parents) r->add_parents(parent);
    }
    return m.SerializeAsString();
}

Header parse_header(std::string_view body) {
    proto::Header m;
    if (!m.ParseFromArray(body.data(), static_cast<int>(body.size())))
        throw Error(Exit::bad_input, "cannot read the header frame: malformed");
    if (m.units() != "mm") throw Error(Exit::bad_input, "cannot use the header frame: units are not mm");
    Header out;
    if (m.payload() > 0 && m.payload() < 256) out.payload = static_cast<Payload>(m.payload());
    if (name(out.payload) == name(Payload::unknown))
        throw Error(Exit::bad_input, "cannot use the header frame: unknown payload");
    out.expected = m.expected();
    for (const auto& r : m.history()) {
        Run run{r.program(), r.version(), {}, {}};
        for (const auto& t : r.settings()) run.settings.push_back({t.name(), t.value(), t.changed()});
        for (const auto parent : r.parents()) {
            if (parent >= out.history.size())
                throw Error(Exit::bad_input, "cannot use the header frame: history refers to a later run");
            run.parents.push_back(parent);
        }
        out.history.push_back(std::move(run));
    }
    return out;
}

std::string serialise(const EndRecord& end) {
    proto::End m;
    m.set_frames(end.frames);
    m.set_crc32c(end.crc);
    return m.SerializeAsString();
}

EndRecord parse_end(std::string_view body) {
    proto::End m;
    if (!m.ParseFromArray(body.data(), static_cast<int>(body.size())))
        throw Error(Exit::bad_input, "cannot read the end frame: malformed");
    return {m.frames(), m.crc32c()};
}

} // namespace filum::stream
