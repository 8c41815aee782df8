#include "postproc/measure.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/angle.hpp"

#include <algorithm>
#include <cmath>

namespace filum::postproc {

namespace {

double um(double v) { return std::round(v * 1000) / 1000; }

std::string degrees(double rad) { return fixed_text(geom::degrees(rad), 1); }

} // namespace

Measure::Measure(const machine::Profile& profile, Place place, const Orient& orient)
    : profile_(&profile), place_(place), rotary_(profile.axes.active()), surveyor_(profile),
      automatic_(orient.automatic), turning_(orient.turning), low_(kInfinity), turned_low_(kInfinity) {
    if (!rotary_ && (automatic_ || !turning_.none()))
        throw Error(Exit::usage, "--orient is for machines with rotary axes; turn the part before it is sliced");
    if (!rotary_) walk_ = walker(profile, {}, [this](auto steps) { surveyor_.add(steps); });
}

toolpath::Span Measure::turned(toolpath::Span span) const {
    if (turning_.none()) return span;
    if (span.normals.empty()) span.normals.assign(span.points.size(), {0, 0, 1});
    for (Vec3& p : span.points) p = turning_(p) + Vec3{0, 0, rise_};
    for (Vec3& n : span.normals) n = turning_(n);
    return span;
}

void Measure::add(const toolpath::Span& span) {
    if (walk_) return turning_.none() ? walk_->add(span) : walk_->add(turned(span));
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
        low_ = std::min(low_, span.points[i].z), turned_low_ = std::min(turned_low_, p.z);
        if (const double tilt = std::atan2(std::hypot(to.x, to.y), to.z); tilt > tilt_) tilt_ = tilt, tilt_at_ = p;
    }
}

// Before any axis is worked out, so that the message knows the whole job.
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
    if (automatic_) {
        turning_ = upright(narrowest_cone(axes_).axis);
        axes_ = {};
        automatic_ = false, automatic_done_ = true;
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

Survey Measure::end() {
    walk_->end();
    Survey survey = surveyor_.end();
    survey.efforts = walk_->efforts();
    survey.placed = placed();
    if (!rotary_) shift_ = placement(survey, profile_->bed, place_);
    check_limits(survey, *profile_, program_shift());
    return survey;
}

} // namespace filum::postproc
