#include "app/peek/record.hpp"

#include "wire/surface.hpp"

#include <algorithm>

namespace filum::app::peek {

namespace {

std::int64_t whole(std::uint64_t v) { return static_cast<std::int64_t>(v); }

std::vector<Record> rims(const surface::Surface& s) {
    std::vector<Record> out;
    for (const auto& rim : s.rims)
        out.push_back({"rim",
                       {{"component", "", whole(rim.component)},
                        {"outer", "", Word{rim.outer ? "yes" : "no"}},
                        {"sides", "", whole(rim.sides.size())},
                        {"length", "mm", surface::rim_length(s, rim)}}});
    return out;
}

} // namespace

Record record(const stream::RawFrame& frame) {
    Record out = wire::record(frame);
    if (frame.tag != stream::Tag::surface) return out;
    const surface::Surface s = wire::sheet(frame).surface;
    const auto is_table = [](const wire::Entry& e) { return std::holds_alternative<Table>(e.value); };
    const auto tables = std::find_if(out.entries.begin(), out.entries.end(), is_table);
    out.entries.insert(tables, {{"components", "", whole(s.components)}, {"area", "mm2", surface::area(s)}});
    out.entries.push_back({"rims", "", rims(s)});
    return out;
}

} // namespace filum::app::peek
