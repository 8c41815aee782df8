#include "app/peek/peek.hpp"

#include "app/peek/text.hpp"
#include "stream/reader.hpp"

namespace filum::app::peek {

namespace {

// Prints the frames and returns their summary.
Summary read_frames(const Options& o, stream::Reader& reader, stream::Sink& out) {
    Summary summary;
    bool first = true;
    for (std::uint64_t at = reader.offset(); const auto frame = reader.next(); at = reader.offset()) {
        const Record found = record(*frame);
        add(summary, *frame, found);
        if (o.json) out.write((first ? "\n" : ",\n") + json(found));
        if (o.text) out.write(text(found, static_cast<int>(o.decimals)));
        if (o.frames) out.write(std::to_string(at) + " " + found.kind + "\n");
        first = false;
    }
    return summary;
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    if (o.check + o.text + o.json + o.script + o.frames > 1)
        throw Error(Exit::usage, "cannot use two of --check, --text, --json, --frames and --script at once");
    stream::Reader reader(io.input, stream::Payload::unknown);
    stream::Sink out(io.output, stream::Sink::Content::text);
    if (o.json)
        out.write("{\"header\":" + json(reader.header()) + ",\"frames\":[");
    else if (!o.check && !o.script && !o.frames)
        out.write(text(reader.header()));
    Summary summary;
    try {
        summary = read_frames(o, reader, out);
    } catch (const Error&) {
        if (io.output == "-") out.commit(); // show the part before the fault
        throw;
    }
    if (o.json)
        out.write("],\n\"summary\":" + json(summary) + "}\n");
    else if (o.script)
        out.write(script(reader.header(), o.defaults));
    else if (!o.check && !o.text && !o.frames)
        out.write(text(summary));
    out.commit();
}

} // namespace filum::app::peek
