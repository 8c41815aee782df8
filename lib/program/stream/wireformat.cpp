#include "stream/wireformat.hpp"

#include "base/error.hpp"

#include "filum/stream.pb.h"

#include <algorithm>
#include <cmath>

namespace filum::stream {

namespace {

bool finite(const Object& object) {
    const auto all = [](const std::vector<double>& values) {
        return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    };
    return all(object.x) && all(object.y) && std::isfinite(object.height);
}

} // namespace

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
        for (const Object& object : run.objects) {
            auto* to = r->add_objects();
            to->set_name(object.name);
            to->set_height(object.height);
            to->mutable_x()->Add(object.x.begin(), object.x.end());
            to->mutable_y()->Add(object.y.begin(), object.y.end());
        }
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
        for (const auto& o : r.objects()) {
            run.objects.push_back({o.name(), {o.x().begin(), o.x().end()}, {o.y().begin(), o.y().end()}, o.height()});
            if (o.x_size() < 3 || o.x_size() != o.y_size() || !finite(run.objects.back()))
                throw Error(Exit::bad_input, "cannot use the header frame: an object has no outline");
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
