#include "app/render/render.hpp"

#include "app/report/report.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <algorithm>

namespace filum::app::render {

namespace {

using filum::render::add;
using filum::render::Options;
using filum::render::Range;
using filum::render::Scene;

// Adds the part of `file` in `range` to the scene.  `seen`: increased by the number of payload frames, also of those
// outside the range.
stream::Payload load(const std::string& file, stream::Payload expected, Range range, Scene& scene, std::size_t& seen) {
    stream::Reader reader(file, expected);
    while (auto f = reader.next()) {
        seen += f->tag == stream::tag_of(reader.header().payload) ? 1 : 0;
        if (f->tag == stream::Tag::span)
            add(scene, wire::span(*f), range);
        else if (f->tag == stream::Tag::paths)
            add(scene, wire::paths(*f), range);
        else if (f->tag == stream::Tag::layer)
            add(scene, wire::layer(*f), range);
        else if (f->tag == stream::Tag::region)
            add(scene, wire::region(*f), range);
        else if (f->tag == stream::Tag::surface)
            add(scene, wire::sheet(*f));
    }
    return reader.header().payload;
}

// Warns of options of pictures for a report, which ignores them.  Throws Error(usage) for options of a report without
// one, and for --machine where it has no effect.
void check_report(const Options& o, const cli::Io& io) {
    const std::string shown[] = {"machine", "regions", "surface", "collisions", "figures", "beside", "title"};
    const auto both = [](const std::string& name) { return name != "figures" && name != "beside" && name != "title"; };
    for (const std::string& name : io.given) {
        const bool known = std::find(std::begin(shown), std::end(shown), name) != std::end(shown);
        if (o.html && !known) io.idle(name, "a report shows all, and is looked at from everywhere");
        if (!o.html && known && !both(name))
            throw Error(Exit::usage, "cannot use --" + name + ": only a report shows it; name the output x.html");
        if (!o.html && name == "machine" && o.color != "speed")
            throw Error(Exit::usage, "cannot use --machine: it does nothing without --color speed or a report");
    }
}

} // namespace

void run(const Options& given, const cli::Io& io) {
    Options o = given;
    o.html = io.output.ends_with(".html");
    check_report(o, io);
    if (o.html) return report::run({o.machine, o.regions, o.surface, o.beside, o.figures, o.collisions, o.title}, io);
    for (const char* format : {"svg", "pdf"})
        if (o.format == "auto" && io.output.ends_with(std::string(".") + format)) o.format = format;
    o.vtp = io.output.ends_with(".vtp");
    filum::render::check(o);
    Scene scene;
    std::size_t seen = 0;
    const auto payload = load(io.input, stream::Payload::unknown, o.range(), scene, seen);
    if (seen > 0 && scene.empty())
        throw Error(Exit::usage, "cannot draw layers " + std::to_string(o.range().from) + " to " +
                                     std::to_string(o.range().to) + ": the input has nothing there; see 'peek'");
    if (!o.surface.empty()) load(o.surface, stream::Payload::surface, o.range(), scene, seen);
    if (!o.regions.empty()) load(o.regions, stream::Payload::regions, o.range(), scene, seen);
    if (!o.flat() && !scene.sheet) io.idle("no-centres", "only --layer and surfaces show them");
    const bool regions = payload == stream::Payload::regions, layers = payload == stream::Payload::layers;
    const char* color = regions ? "stroke" : layers ? "layer" : scene.sheet ? "class" : "progress";
    stream::Sink out(io.output,
                     o.format == "svg" || o.vtp ? stream::Sink::Content::text : stream::Sink::Content::binary);
    out.write(filum::render::draw(std::move(scene), o, color, io.threads));
    out.commit();
}

} // namespace filum::app::render
