#include "geodesic/lines.hpp"

#include "base/error.hpp"
#include "surface/meet.hpp"
#include "surface/trace.hpp"

#include <charconv>

namespace filum::geodesic {

namespace {

// The numbers in a line of text; false if it contains anything else.
bool numbers(std::string_view text, std::vector<double>& out) {
    const char *at = text.data(), *const end = at + text.size();
    for (;;) {
        while (at < end && (*at == ' ' || *at == '\t' || *at == ',' || *at == '\r')) ++at;
        if (at == end) return true;
        double v = 0;
        const auto [stop, error] = std::from_chars(at, end, v);
        if (error != std::errc() || !std::isfinite(v)) return false;
        out.push_back(v);
        at = stop;
    }
}

} // namespace

std::vector<std::vector<Vec3>> read_lines(std::string_view text, const std::string& name) {
    std::vector<std::vector<Vec3>> out(1);
    std::size_t number = 0;
    while (!text.empty()) {
        ++number;
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const bool comment = line.find('#') != std::string_view::npos;
        line = line.substr(0, line.find('#'));
        std::vector<double> v;
        if (!numbers(line, v) || (!v.empty() && v.size() != 3))
            throw Error(Exit::bad_input,
                        "cannot read " + name + ": line " + std::to_string(number) + " does not hold three numbers");
        if (!v.empty())
            out.back().push_back({v[0], v[1], v[2]});
        else if (!comment && !out.back().empty())
            out.emplace_back();
    }
    if (out.back().empty()) out.pop_back();
    if (out.empty()) throw Error(Exit::bad_input, "cannot use " + name + ": it contains no point");
    return out;
}

void add_lines(Sources& sources, const Surface& s, const std::vector<std::vector<Vec3>>& lines, Notes& notes) {
    for (const auto& line : lines) {
        const surface::Trace trace = surface::trace(s, line);
        sources.segments.insert(sources.segments.end(), trace.segments.begin(), trace.segments.end());
        if (trace.off > surface::mean_edge(s))
            notes.push_back({.code = NoteCode::source_line_moved, .amount = trace.off});
    }
}

Facts add_mesh(Sources& sources, const Surface& s, const mesh::Mesh& mesh) {
    const surface::Intersection m = surface::meet(s, mesh);
    if (m.segments.empty())
        throw Error(Exit::usage, "cannot use --source-mesh: the mesh does not touch the surface; check that both have "
                                 "the same origin");
    sources.segments.insert(sources.segments.end(), m.segments.begin(), m.segments.end());
    return {{"", "source-mesh-crossing", m.crossing, "mm"},
            {"", "source-mesh-touching", m.touching, "mm"},
            {"", "source-mesh-flush", m.flush, "mm2"}};
}

} // namespace filum::geodesic
