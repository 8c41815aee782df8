#include "stream/writer.hpp"

#include "base/error.hpp"
#include "stream/crc32c.hpp"
#include "stream/wireformat.hpp"

namespace filum::stream {

Writer::Writer(const std::string& path, const Header& header) : sink_(path, Sink::Content::binary) {
    put(preamble());
    write(Tag::header, serialise(header));
}

void Writer::put(std::string_view bytes) {
    crc_ = crc32c(crc_, bytes.data(), bytes.size());
    sink_.write(bytes);
}

void Writer::write(Tag tag, std::string_view body) {
    const std::string prefix = frame_prefix(tag, body.size());
    if (prefix.size() + body.size() > kMaxFrame)
        throw Error(Exit::failure, "cannot write a frame of more than 64 MiB; the part is too large");
    put(prefix);
    put(body);
    ++frames_;
}

void Writer::write(const RawFrame& frame) { write(frame.tag, frame.body); }

void Writer::write(const Note& note) { write(Tag::note, serialise(note)); }

void Writer::write(const Fact& fact) { write(Tag::fact, serialise(fact)); }

void Writer::close() {
    const std::string body = serialise(EndRecord{frames_, crc_});
    sink_.write(frame_prefix(Tag::end, body.size()));
    sink_.write(body);
    sink_.commit();
}

} // namespace filum::stream
