#include "mesh/paint.hpp"

#include "mesh/formats.hpp"

#include <optional>
#include <vector>

namespace filum::mesh {

namespace {

constexpr int kMostCuts = 32; // deepest nesting of splits

// Attributes with paint: in PrusaSlicer's namespace, and in OrcaSlicer and Bambu Studio.
struct PaintName {
    std::string_view prusa, bambu;
    const char* what;
};

class PaintReader {
  public:
    PaintReader(std::string_view text, const std::function<void(Paint, const Corners&)>& put)
        : text_(text), put_(put) {}

    bool run(const Corners& corners) { return triangle(corners, 0) && text_.empty(); }

  private:
    std::optional<int> digit() {
        if (text_.empty()) return std::nullopt;
        const char c = text_.back();
        text_.remove_suffix(1);
        if (c >= '0' && c <= '9') return c - '0';
        if (c >= 'A' && c <= 'F') return c - 'A' + 10;
        if (c >= 'a' && c <= 'f') return c - 'a' + 10;
        return std::nullopt;
    }

    bool triangle(const Corners& corners, int depth) {
        const auto code = digit();
        if (!code || depth > kMostCuts) return false;
        const int cut = *code % 4, rest = *code / 4;
        if (cut > 0) return rest < 3 && children(corners, cut, rest, depth);
        int paint = rest;
        if (rest == 3) {
            const auto more = digit();
            if (!more) return false;
            paint += *more;
        }
        put_(paint < 3 ? static_cast<Paint>(paint) : Paint::other, corners);
        return true;
    }

    // Splits triangle a, b, c, whose first corner is the given one.  One cut halves b-c; two cuts halve a-b and c-a.
    bool children(const Corners& corners, int cut, int first, int depth) {
        const auto f = static_cast<std::size_t>(first);
        const Vec3 a = corners[f], b = corners[(f + 1) % 3], c = corners[(f + 2) % 3];
        const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
        std::vector<Corners> parts;
        if (cut == 1)
            parts = {{a, b, bc}, {bc, c, a}};
        else if (cut == 2)
            parts = {{a, ab, ca}, {ab, b, ca}, {b, c, ca}};
        else
            parts = {{a, ab, ca}, {ab, b, bc}, {bc, c, ca}, {ab, bc, ca}};
        for (std::size_t k = parts.size(); k-- > 0;)
            if (!triangle(parts[k], depth + 1)) return false;
        return true;
    }

    using Vec3 = geom::Vec3;
    std::string_view text_;
    const std::function<void(Paint, const Corners&)>& put_;
};

} // namespace

const char* const kSupportPaint = "supports";
const char* const kSeamPaint = "seams";

const char* paint_of(std::string_view attribute) {
    static constexpr PaintName kNames[] = {{":mmu_segmentation", "paint_color", "materials"},
                                           {":fuzzy_skin", "paint_fuzzy_skin", "fuzzy skin"}};
    if (attribute.ends_with(":custom_supports") || attribute == "paint_supports") return kSupportPaint;
    if (attribute.ends_with(":custom_seam") || attribute == "paint_seam") return kSeamPaint;
    for (const PaintName& name : kNames)
        if (attribute.ends_with(name.prusa) || attribute == name.bambu) return name.what;
    return nullptr;
}

bool each_painted(std::string_view text, const Corners& corners,
                  const std::function<void(Paint, const Corners&)>& put) {
    return PaintReader(text, put).run(corners);
}

namespace {

void add_faces(Body::Purpose what, const std::vector<Corners>& faces, File& to) {
    if (faces.empty()) return;
    Body& body = to.bodies.emplace_back();
    body.what = what;
    for (const Corners& c : faces) {
        const auto first = static_cast<std::uint32_t>(body.mesh.vertices.size());
        body.mesh.vertices.insert(body.mesh.vertices.end(), c.begin(), c.end());
        body.mesh.triangles.push_back({first, first + 1, first + 2});
    }
}

} // namespace

void add_painted(const std::vector<PaintedTriangle>& painted, Body::Purpose wanted_kind, Body::Purpose unwanted_kind,
                 File& to) {
    std::vector<Corners> wanted, unwanted;
    std::size_t unread = 0;
    const auto& v = to.mesh.vertices;
    for (const PaintedTriangle& p : painted) {
        const auto& t = p.triangle;
        const bool known = each_painted(p.digits, {v[t[0]], v[t[1]], v[t[2]]}, [&](Paint paint, auto& corners) {
            if (paint == Paint::wanted) wanted.push_back(corners);
            if (paint == Paint::unwanted) unwanted.push_back(corners);
        });
        if (!known) ++unread;
    }
    add_faces(wanted_kind, wanted, to);
    add_faces(unwanted_kind, unwanted, to);
    if (unread == 0) return;
    to.notes.push_back(note(NoteCode::paint_unreadable));
    to.notes.back().count = unread;
}

} // namespace filum::mesh
