#include "postproc/measure.hpp"

#include <cmath>

namespace filum::postproc {

Measure::Measure(const machine::Profile& profile, Place place)
    : profile_(&profile), place_(place), rotary_(profile.axes.active()), surveyor_(profile) {
    if (!rotary_) walk_ = walker(profile, {}, [this](auto steps) { surveyor_.add(steps); });
}

void Measure::add(const toolpath::Span& span) {
    if (walk_) return walk_->add(span);
    if (toolpath::extrudes(span.role))
        for (const Vec3& p : span.points) box_.add(p.xy());
}

bool Measure::again() {
    if (walk_) return false;
    const auto um = [](double v) { return std::round(v * 1000) / 1000; };
    const auto& chain = profile_->axes.chain;
    const Vec2 to = chain.carrier == kinematics::Carrier::head_head ? profile_->bed.centre() : chain.turn_point.xy();
    if (place_ == Place::center && !box_.empty())
        shift_ = {um(to.x - (box_.lo.x + box_.hi.x) / 2), um(to.y - (box_.lo.y + box_.hi.y) / 2)};
    walk_ = walker(*profile_, shift_, [this](auto steps) { surveyor_.add(steps); });
    return true;
}

Survey Measure::end() {
    walk_->end();
    Survey survey = surveyor_.end();
    survey.efforts = walk_->efforts();
    if (!rotary_) shift_ = placement(survey, profile_->bed, place_);
    check_limits(survey, *profile_, program_shift());
    return survey;
}

} // namespace filum::postproc
