#include "postproc/fibre.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/polyline.hpp"
#include "postproc/tilted.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

using toolpath::Span;

constexpr double kSnap = 1e-3; // mm: a stretch ends at a point of the path within this distance
constexpr double kOver = 5;    // mm: least height of a travel over an omitted stroke

double length(const std::vector<Span>& spans) {
    double sum = 0;
    for (const Span& s : spans) sum += geom::length(s.points);
    return sum;
}

std::string place(const Span& span) {
    const Vec3& p = span.points.front();
    return "on layer " + std::to_string(span.layer) + " at x " + fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) +
           ", z " + fixed_text(p.z, 3) + " of the toolpath";
}

// A span without points that has the other properties of `from`.
Span like(const Span& from) {
    Span out{from.role, from.stroke, from.layer, from.region, {}, {}, {}, {}};
    out.tool = from.tool;
    return out;
}

// Appends the place at share `f` from point i to i + 1 of `from`, unless it is the last place of `out`.
void append(Span& out, const Span& from, std::size_t i, double f) {
    const std::size_t j = f > 0 ? i + 1 : i;
    const auto between = [&](const std::vector<double>& v) { return v[i] + f * (v[j] - v[i]); };
    const Vec3 p = f < 1 ? from.points[i] + f * (from.points[j] - from.points[i]) : from.points[j];
    if (!out.points.empty() && out.points.back() == p) return;
    out.points.push_back(p);
    const auto own = [&](std::vector<double>& to, const std::vector<double>& v) {
        if (v.size() > 1)
            to.push_back(between(v));
        else
            to = v;
    };
    own(out.width, from.width);
    own(out.height, from.height);
    if (from.normals.empty()) return;
    const Vec3 n = from.normals[i] + f * (from.normals[j] - from.normals[i]);
    out.normals.push_back(norm(n) > 0.01 ? 1 / norm(n) * n : from.normals[i]);
}

// Joins travels and omitted strokes to one travel.  It leads over the omitted strokes by `over` mm, without going down
// and up between them.
Span joined(const std::vector<Span>& spans, double over) {
    Span out = like(spans.front());
    out.role = Role::travel;
    const bool tilted = std::all_of(spans.begin(), spans.end(), [](const Span& s) { return !s.normals.empty(); });
    const auto omitted = [&](std::size_t k) { return k < spans.size() && toolpath::extrudes(spans[k].role); };
    for (std::size_t k = 0; k < spans.size(); ++k) {
        const Span& s = spans[k];
        const std::size_t skip = !omitted(k) && k > 0 && omitted(k - 1) ? 1 : 0;
        const std::size_t leave = !omitted(k) && omitted(k + 1) ? 1 : 0;
        for (std::size_t i = skip; i + leave < s.points.size(); ++i) {
            out.points.push_back(s.points[i] + (tilted && omitted(k) ? over : 0) * (tilted ? s.normals[i] : Vec3{}));
            if (tilted) out.normals.push_back(s.normals[i]);
        }
    }
    if (omitted(spans.size() - 1)) { // the next stroke begins where the omitted one ends
        out.points.push_back(spans.back().points.back());
        if (tilted) out.normals.push_back(spans.back().normals.back());
    }
    return out;
}

bool any_omitted(const std::vector<Span>& travels) {
    return std::any_of(travels.begin(), travels.end(), [](const Span& s) { return toolpath::extrudes(s.role); });
}

} // namespace

void check_tool(const machine::Profile& profile, const Span& span) {
    if (span.tool == 0 || !machine::change_codes(profile, span.tool).empty()) return;
    const std::string number = std::to_string(span.tool);
    throw Error(Exit::bad_input, "cannot take tool " + number + " " + place(span) + ": '" + profile.name +
                                     "' has no codes to change tools; add tools.change, or [tool." + number +
                                     "] with change");
}

FibreWalk::FibreWalk(const machine::Profile& profile, std::unique_ptr<Walker> inner, Steps out)
    : profile_(&profile), inner_(std::move(inner)), out_(std::move(out)) {}

void FibreWalk::travel(const Span& span) {
    finish();
    travels_.push_back(span);
}

void FibreWalk::extrude(const Span& span) {
    if (span.tool != tool_) {
        check_tool(*profile_, span);
        finish();
        if (begun_ && travels_.empty()) {
            travels_.push_back(like(span));
            travels_.back().role = Role::travel;
            travels_.back().points = {span.points.front(), span.points.front()};
        }
        tool_ = span.tool;
    }
    if (profile_->fibre.lays(span.tool)) {
        stroke_.push_back(span);
        return;
    }
    release(span.tool);
    inner_->add(span, known());
}

// Hands on the travels that lead to a stroke of `tool`.
void FibreWalk::release(std::uint32_t tool) {
    if (any_omitted(travels_)) travels_ = {joined(travels_, std::max(kOver, profile_->travel.lift))};
    for (Span& t : travels_) {
        t.tool = tool;
        // Before the first stroke no travel is needed, unless it leads into a bath of gel.
        if (begun_ || (!t.normals.empty() && !profile_->axes.active())) inner_->add(t);
    }
    travels_.clear();
    begun_ = true;
}

void FibreWalk::finish() {
    if (stroke_.empty()) return;
    const auto& fibre = profile_->fibre;
    const double l = length(stroke_);
    if (l > fibre.most_path)
        throw Error(Exit::failure, "cannot lay a fibre of " + fixed_text(l, 1) + " mm " + place(stroke_.front()) +
                                       ": fibre.most_path of '" + profile_->name + "' is " +
                                       fixed_text(fibre.most_path, 1) + " mm; split the stroke before postproc");
    if (l < fibre.least_path - kSnap) {
        const Step step{.act = Act::omit,
                        .layer = stroke_.front().layer,
                        .to = stroke_.front().points.front(),
                        .length = l,
                        .tool = tool_};
        out_(std::span(&step, 1));
        std::move(stroke_.begin(), stroke_.end(), std::back_inserter(travels_));
    } else {
        release(tool_);
        lay(l);
    }
    stroke_.clear();
}

void FibreWalk::hand_on(const Span& piece, bool halt) {
    if (piece.points.size() < 2) return;
    inner_->add_fibre(piece, how_, halt);
    how_.before = machine::Event::none; // the event was before the first piece
}

void FibreWalk::lay(double length) {
    const auto all = machine::stretches(profile_->fibre, length);
    std::size_t k = 0;
    double s = 0; // arc length so far
    how_ = all.front();
    for (const Span& span : stroke_) {
        Span piece = like(span);
        append(piece, span, 0, 0);
        for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
            const double l = distance(span.points[i], span.points[i + 1]);
            for (; k + 1 < all.size() && all[k].to < s + l - kSnap; how_ = all[++k]) {
                const double f = all[k].to > s + kSnap ? (all[k].to - s) / l : 0;
                append(piece, span, i, f);
                hand_on(piece, true);
                piece = like(span);
                append(piece, span, i, f);
            }
            append(piece, span, i, 1);
            s += l;
        }
        hand_on(piece, std::abs(all[k].to - s) <= kSnap);
    }
}

void FibreWalk::end() {
    finish();
    if (any_omitted(travels_)) travels_.clear(); // no stroke follows
    release(tool_);
    inner_->end();
}

std::unique_ptr<Walker> walker(const machine::Profile& profile, Vec2 shift, Steps out, const Joins* joins) {
    std::unique_ptr<Walker> inner;
    if (profile.axes.active())
        inner = std::make_unique<TiltedWalk>(profile, shift, out);
    else
        inner = std::make_unique<Walk>(profile, out, joins);
    return std::make_unique<FibreWalk>(profile, std::move(inner), std::move(out));
}

} // namespace filum::postproc
