#include "postproc/measure.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"
#include "postproc/fibre.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::postproc {

namespace {

double um(double v) { return std::round(v * 1000) / 1000; }

// The largest tilt of a surface that an upright nozzle can follow, rad.  Below the nozzle the surface rises towards one
// side of the flat, by the flat's radius times the tangent of the tilt.  If that exceeds the bead's height, the nozzle
// cuts into the surface.
double upright_limit(const machine::Profile& p, double height) {
    return p.head.flat_radius > 0 ? std::atan2(height, p.head.flat_radius) : std::numbers::pi / 2;
}

std::string degrees(double rad) { return fixed_text(geom::degrees(rad), 1); }

} // namespace

Measure::Measure(const machine::Profile& profile, Place place, const Orient& orient, bool flatten,
                 machine::Pauses pauses)
    : profile_(&profile), place_(place), rotary_(profile.axes.active()), surveyor_(profile, std::move(pauses)),
      automatic_(orient.automatic), turning_(orient.turning), low_(kInfinity), turned_low_(kInfinity),
      flatten_(flatten) {
    if (!rotary_ && (automatic_ || !turning_.none()))
        throw Error(Exit::usage, "--orient is for machines with rotary axes; turn the part before it is sliced");
}

toolpath::Span Measure::turned(toolpath::Span span) const {
    if (turning_.none()) return span;
    if (span.normals.empty()) span.normals.assign(span.points.size(), {0, 0, 1});
    for (Vec3& p : span.points) p = turning_(p) + Vec3{0, 0, rise_};
    for (Vec3& n : span.normals) n = turning_(n);
    return span;
}

void Measure::add(const toolpath::Span& span, const toolpath::MergeResult* merged) {
    if (walk_) return turning_.none() ? walk_->add(span, merged) : walk_->add(turned(span));
    joins_.add(span);
    if (!automatic_) part_.add(turning_.none() ? span : turned(span));
    if (toolpath::extrudes(span.role)) check_tool(*profile_, span);
    if (!rotary_) {
        if (!span.normals.empty() && toolpath::extrudes(span.role)) see_upright(span);
        return;
    }
    if (toolpath::extrudes(span.role)) see(span);
}

void Measure::see(const toolpath::Span& span) {
    for (std::size_t i = 0; i < span.points.size(); ++i) {
        const Vec3 axis = span.normals.empty() ? Vec3{0, 0, 1} : span.normals[i];
        if (automatic_) {
            if (axes_.empty() || !(axes_.back() == axis)) axes_.push_back(axis);
            continue;
        }
        const Vec3 p = turning_(span.points[i]), to = turning_(axis);
        box_.add(p.xy());
        low_ = std::min(low_, span.points[i].z);
        turned_low_ = std::min(turned_low_, p.z);
        if (const double tilt = std::atan2(std::hypot(to.x, to.y), to.z); tilt > tilt_) {
            tilt_ = tilt;
            tilt_at_ = p;
        }
    }
}

void Measure::see_upright(const toolpath::Span& span) {
    for (std::size_t i = 0; i < span.points.size(); ++i) {
        const Vec3& n = span.normals[i];
        const double tilt = std::atan2(std::hypot(n.x, n.y), n.z), height = span.height_at(i);
        if (tilt > tilt_) {
            tilt_ = tilt;
            tilt_at_ = span.points[i];
        }
        const double excess = tilt - upright_limit(*profile_, height);
        if (excess > excess_) {
            excess_ = excess;
            excess_tilt_ = tilt;
            excess_height_ = height;
            excess_at_ = span.points[i];
        }
    }
}

void Measure::check_upright() const {
    if (flatten_ || !(excess_ > 0)) return;
    const Vec3& p = excess_at_;
    throw Error(Exit::failure,
                "cannot follow the toolpath on '" + profile_->name + "', which holds the nozzle upright: at x " +
                    fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) + ", z " + fixed_text(p.z, 3) +
                    " of the toolpath the tool must tilt by " + degrees(excess_tilt_) + " degrees, and beyond " +
                    degrees(excess_tilt_ - excess_) + " a flat of " + fixed_text(profile_->head.flat_radius, 3) +
                    " mm radius cuts into the surface under a bead of " + fixed_text(excess_height_, 3) +
                    " mm; use a machine with rotary axes, or --flatten to go there upright all the same");
}

// Checks the tilts before the axes are computed, so that the message holds the largest tilt of the whole job.
void Measure::check_tilts() const {
    using kinematics::Carrier;
    const auto& a = profile_->axes;
    if (a.chain.carrier == Carrier::frame || a.chain.carrier == Carrier::polar) return;
    const double most = std::max(-a.limits.tilt_min, a.limits.tilt_max);
    if (tilt_ <= most + a.orientation) return;
    const Vec3 p{tilt_at_.x + shift_.x, tilt_at_.y + shift_.y, tilt_at_.z + rise_};
    throw Error(Exit::failure,
                "cannot reach x " + fixed_text(p.x, 3) + ", y " + fixed_text(p.y, 3) + ", z " + fixed_text(p.z, 3) +
                    " on '" + profile_->name + "': the tool must tilt by " + degrees(tilt_) +
                    " degrees there, and the tilt axis reaches " + degrees(a.limits.tilt_min) + " to " +
                    degrees(a.limits.tilt_max) + ", with a lean of " + degrees(a.orientation) +
                    (automatic_done_ ? "; no way to turn the part needs less: print it in several programs, each "
                                       "turned by itself, or on a machine of more tilt"
                                     : "; --orient auto turns the part so that it needs the least"));
}

bool Measure::again() {
    if (walk_) return false;
    if (!rotary_) {
        check_upright();
        walk_ = walker(
            *profile_, {}, [this](auto steps) { surveyor_.add(steps); }, &joins_);
        return true;
    }
    if (automatic_) {
        turning_ = upright(narrowest_cone(axes_).axis);
        axes_ = {};
        automatic_ = false;
        automatic_done_ = true;
        return true;
    }
    const auto& chain = profile_->axes.chain;
    const Vec2 to = chain.carrier == kinematics::Carrier::head_head ? profile_->bed.centre() : chain.turn_point.xy();
    if (place_ == Place::center && !box_.empty()) {
        shift_ = {um(to.x - (box_.lo.x + box_.hi.x) / 2), um(to.y - (box_.lo.y + box_.hi.y) / 2)};
        if (!turning_.none()) rise_ = um(low_ - turned_low_);
    }
    check_tilts();
    walk_ = walker(*profile_, shift_, [this](auto steps) { surveyor_.add(steps); });
    return true;
}

std::string Measure::placed() const {
    return rotary_ ? placed_text(turning_, {shift_.x, shift_.y, rise_}) : std::string{};
}

FirstPass Measure::end() {
    walk_->end();
    FirstPass first_pass = surveyor_.end();
    first_pass.efforts = walk_->efforts();
    if (!rotary_ && tilt_ > 0) {
        first_pass.efforts.lean = tilt_;
        first_pass.efforts.lean_at = tilt_at_;
    }
    first_pass.placed = placed();
    first_pass.part_size = part_.size();
    if (!rotary_) shift_ = placement(first_pass, profile_->bed, place_);
    check_limits(first_pass, *profile_, program_shift());
    return first_pass;
}

} // namespace filum::postproc
