#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

namespace {

using toolpath::Role;
using toolpath::Span;

class SpanWriter {
  public:
    SpanWriter(const Surface& s, const SpanOptions& o)
        : surface_(s), o_(o), normals_(surface::curve::vertex_normals(s)) {}

    void write(const Stroke& stroke, std::uint32_t number, std::vector<Span>& out) {
        bool first = true;
        for (const Section& piece : stroke.sections) {
            if (piece.line.size() < 2) continue;
            Span now = span(piece.hairpin ? Role::hairpin : Role::bead, number);
            for (const Place& p : piece.line.places) add(now, p, o_.offset);
            if (!piece.widths.empty()) now.width = piece.widths;
            if (first && !out.empty()) out.push_back(travel(out.back(), now, number));
            if (!first && out.back().role == now.role) {
                auto& to = out.back();
                to.points.insert(to.points.end(), now.points.begin() + 1, now.points.end());
                to.normals.insert(to.normals.end(), now.normals.begin() + 1, now.normals.end());
                if (now.width.size() > 1) to.width.insert(to.width.end(), now.width.begin() + 1, now.width.end());
            } else {
                out.push_back(std::move(now));
            }
            first = false;
        }
    }

  private:
    [[nodiscard]] Span span(Role role, std::uint32_t number) const {
        Span out{role, number, o_.layer, 0, {}, {}, {}, {}};
        if (toolpath::extrudes(role)) {
            out.width = {o_.width};
            out.height = {o_.height};
        }
        return out;
    }

    void add(Span& to, const Place& p, double above) const {
        const Vec3 n = surface::curve::normal_at(surface_, normals_, p);
        to.points.push_back(p.point + above * n);
        to.normals.push_back(n);
    }

    [[nodiscard]] Span travel(const Span& from, const Span& to, std::uint32_t number) const {
        Span out = span(Role::travel, number);
        const Vec3 &a = from.points.back(), &na = from.normals.back();
        const Vec3 &b = to.points.front(), &nb = to.normals.front();
        out.points = {a, a + o_.lift * na, b + o_.lift * nb, b};
        out.normals = {na, na, nb, nb};
        return out;
    }

    const Surface& surface_;
    const SpanOptions& o_;
    std::vector<Vec3> normals_;
};

} // namespace

void add_spans(const Surface& surface, const Plan& plan, const SpanOptions& options, std::vector<Span>& out) {
    SpanWriter writer(surface, options);
    for (std::uint32_t i = 0; i < plan.strokes.size(); ++i) writer.write(plan.strokes[i], options.stroke + i, out);
}

std::vector<Span> spans(const Surface& surface, const Plan& plan, const SpanOptions& options) {
    std::vector<Span> out;
    add_spans(surface, plan, options, out);
    return out;
}

} // namespace filum::surfpath::plan
