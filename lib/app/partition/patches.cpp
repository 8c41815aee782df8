#include "app/partition/patches.hpp"

#include "stream/writer.hpp"
#include "wire/surface.hpp"

namespace filum::app::partition {

void write(const std::vector<cli::Whole>& before, const std::vector<surface::Sheet>& sheets, Notes notes,
           const Facts& facts, const cli::Io& self) {
    std::vector<const stream::Header*> headers;
    for (const auto& b : before) headers.push_back(&b.header);
    auto header = cli::header(self, stream::Payload::surface, headers);
    header.expected = sheets.size();
    stream::Writer writer(self.output, header);
    cli::Report report(self);
    for (const auto& b : before) {
        for (const Note& note : b.notes) writer.write(note);
        for (const Fact& fact : b.facts)
            if (fact.stage != self.program) writer.write(fact); // else it is of what was before
    }
    for (Note& note : notes) note.stage = self.program, writer.write(note), report.add(note);
    for (const Fact& fact : facts) writer.write(Fact{self.program, fact.name, fact.value, fact.unit});
    for (const auto& p : sheets) writer.write(wire::frame(p));
    writer.close();
    report.say();
}

} // namespace filum::app::partition
