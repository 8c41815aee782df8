#include "geodesic/named_sources.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <string>

namespace filum::geodesic {

namespace {

[[noreturn]] void bad(std::string_view word, const std::string& why) {
    throw Error(Exit::usage, "cannot use --source '" + std::string(word) + "': " + why);
}

std::vector<double> numbers(std::string_view word, std::string_view list, std::size_t count) {
    std::vector<double> out;
    while (true) {
        const std::size_t comma = std::min(list.find(','), list.size());
        out.push_back(parse_number(list.substr(0, comma), "--source"));
        if (!std::isfinite(out.back())) bad(word, "its numbers must be finite");
        if (comma == list.size()) break;
        list.remove_prefix(comma + 1);
    }
    if (out.size() != count) bad(word, "it needs " + std::to_string(count) + " numbers");
    return out;
}

std::size_t index(std::string_view word, std::string_view text, std::size_t count, const char* things) {
    const double v = parse_number(text, "--source");
    if (!(v >= 0 && v < static_cast<double>(count)) || v != std::floor(v))
        bad(word, "the surface has " + std::to_string(count) + " " + things + ", numbered from 0");
    return static_cast<std::size_t>(v);
}

void add_rim(Sources& out, const Surface& s, const surface::Rim& rim) {
    for (const std::uint32_t h : rim.sides) out.segments.push_back(surface::rim_side(s, h));
}

void add_boundary(Sources& out, const Surface& s, std::string_view word, std::string_view which) {
    if (s.rims.empty()) bad(word, "the surface is closed and has no boundary; name a vertex, point or plane");
    if (which != "all" && which != "outer")
        return add_rim(out, s, s.rims[index(word, which, s.rims.size(), "boundaries")]);
    for (const surface::Rim& rim : s.rims)
        if (rim.outer || which == "all") add_rim(out, s, rim);
}

void add_point(Sources& out, const Surface& s, std::string_view word, std::string_view place, Notes& notes) {
    const auto v = numbers(word, place, 3);
    const Vec3 p{v[0], v[1], v[2]};
    out.segments.push_back(surface::nearest(s, p));
    const double off = distance(p, out.segments.back().a);
    if (off > surface::mean_edge(s)) {
        Note n{.code = NoteCode::source_point_moved, .amount = off};
        n.x = p.x;
        n.y = p.y;
        notes.push_back(std::move(n));
    }
}

void add_plane(Sources& out, const Surface& s, std::string_view word, std::string_view place) {
    const auto v = numbers(word, place, 4);
    const surface::Plane plane{{v[0], v[1], v[2]}, v[3]};
    if (!(norm(plane.normal) > 0)) bad(word, "its normal is (0, 0, 0)");
    const auto cut = surface::section(s, plane);
    if (cut.empty()) bad(word, "the plane does not meet the surface");
    out.segments.insert(out.segments.end(), cut.begin(), cut.end());
}

void add_vertex(Sources& out, const Surface& s, std::string_view word, std::string_view which,
                std::span<const std::uint32_t> of_file) {
    const bool alike = of_file.empty();
    const std::size_t n = index(word, which, alike ? s.vertices.size() : of_file.size(), "vertices");
    const auto v = alike ? static_cast<std::uint32_t>(n) : of_file[n];
    if (v == surface::kNone) bad(word, "no triangle of the surface has this vertex of the file; name another one");
    out.vertices.push_back(v);
}

void add_word(Sources& out, const Surface& s, std::string_view word, Notes& notes,
              std::span<const std::uint32_t> of_file) {
    const std::size_t colon = std::min(word.find(':'), word.size());
    const std::string_view kind = word.substr(0, colon), what = word.substr(std::min(colon + 1, word.size()));
    if (kind == "vertex")
        add_vertex(out, s, word, what, of_file);
    else if (kind == "point")
        add_point(out, s, word, what, notes);
    else if (kind == "boundary")
        add_boundary(out, s, word, colon == word.size() ? "all" : what);
    else if (kind == "plane")
        add_plane(out, s, word, what);
    else
        bad(word, "sources are vertex:ID, point:X,Y,Z, boundary[:all|outer|N] and plane:NX,NY,NZ,D");
}

} // namespace

Sources named_sources(const Surface& s, std::string_view words, Notes& notes, std::span<const std::uint32_t> of_file) {
    constexpr std::string_view kBetween = " ;\t\n";
    Sources out;
    for (std::size_t at = words.find_first_not_of(kBetween); at != std::string_view::npos;) {
        const std::size_t end = std::min(words.find_first_of(kBetween, at), words.size());
        add_word(out, s, words.substr(at, end - at), notes, of_file);
        at = words.find_first_not_of(kBetween, end);
    }
    return out;
}

} // namespace filum::geodesic
