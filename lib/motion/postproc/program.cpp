#include "postproc/program.hpp"

#include "base/number.hpp"
#include "machine/type_names.hpp"
#include "postproc/digits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace filum::postproc {

namespace {

constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();
constexpr double kTold = 0.05; // least relative change of a width or height for a new comment
// The same for a width where the program has no other word for the material, as with a valve: volumes that are read
// back stay right to half a percent.
constexpr double kToldAlone = 0.005;

double power_of_ten(int n) { return std::pow(10.0, n); }

std::int64_t units(double value, double scale) { return static_cast<std::int64_t>(std::nearbyint(value * scale)); }

bool differs(double a, double b, double least = kTold) { return std::abs(a - b) > least * b; }

} // namespace

Program::Program(const machine::Profile& profile, const FirstPass& first_pass, Vec2 shift, Text out)
    : Writer(profile, placeholders(first_pass, profile, shift), std::move(out)), shift_(shift),
      xyz_scale_(power_of_ten(profile.format.xyz_decimals)),
      degrees_scale_(180 / std::numbers::pi * power_of_ten(profile.axes.angle_decimals)),
      e_scale_(power_of_ten(profile.format.e_decimals)), f_scale_(power_of_ten(profile.format.f_decimals)),
      planned_(&first_pass), preset_(preset_program(profile, first_pass, shift)),
      parts_(with_plain_names(first_pass.parts)), named_(parts_.size()) {
    at_.fill(kUnknown);
}

void Program::begin(const std::vector<std::string>& about) {
    for (const auto& line : about) comment(line);
    if (preset_ != nullptr) {
        preset_code(preset_->start());
        counted_ = true; // the preset's start sets how extruder words count
    } else {
        code(profile_->templates.start);
        // settings that every later line needs, even if the template has changed them
        text_ += "G90";
        end_line();
        begin_axes();
        begin_counting();
    }
    if (profile_->format.objects != machine::Objects::none && !parts_.empty())
        for (const auto& text : define_parts(profile_->format.objects, parts_, shift_)) line(text);
}

// Sets how extruder words count, before the first tool that has such words.
void Program::begin_counting() {
    if (!counts() || std::exchange(counted_, true)) return;
    if (profile_->extrusion.letter == 'E') {
        text_ += profile_->extrusion.relative ? "M83" : "M82";
        end_line();
    }
    if (!profile_->extrusion.relative) reset_extruder();
}

void Program::begin_axes() {
    const auto& a = profile_->axes;
    if (!a.active()) return;
    if (a.numbers == machine::Numbers::tip) code(a.tcp_on);
    if (a.feed_word == machine::FeedWord::inverse) code("G93");
}

void Program::end_axes() {
    const auto& a = profile_->axes;
    if (!a.active()) return;
    if (a.feed_word == machine::FeedWord::inverse) code("G94");
    if (a.numbers == machine::Numbers::tip) code(a.tcp_off);
}

void Program::reset_extruder() {
    text_ += "G92 ";
    text_ += profile_->extrusion.letter;
    text_ += '0';
    end_line();
    e_ = 0;
}

void Program::end(const std::vector<std::string>& history) {
    end_axes();
    if (part_ >= 0) line(end_part(profile_->format.objects, parts_, static_cast<std::size_t>(part_)));
    if (percent_ >= 0 && percent_ < 100) {
        values_["percent"] = 100;
        values_["minutes_left"] = 0;
        code(profile_->templates.progress);
    }
    if (preset_ != nullptr) {
        retract();
        preset_code(preset_->end(layer_.layer, layer_.to.z));
    } else {
        code(profile_->templates.end);
    }
    for (const auto& line : history) comment(line);
    comment("end of program, " + std::to_string(lines_) + " moves");
    flush();
}

void Program::line(const std::string& text) {
    text_ += text;
    end_line();
}

// During a change of tools the controller uses its own axes and feeds.  The position after it is unknown.
void Program::change_tool(const Step& step) {
    end_axes();
    if (preset_ != nullptr && preset_->tool() != step.tool)
        preset_code(preset_->change_tool(step.tool, layer_.layer, layer_.to.z));
    tool(step);
    begin_axes();
    nominal_.add(step);
    at_.fill(kUnknown);
    f_ = -1;
    begin_counting();
    if (counts() && !profile_->extrusion.relative) reset_extruder();
}

void Program::purge(const Step& step) {
    const machine::Purge& p = own().purge;
    const Vec3 shift = own().offset - Vec3{0, 0, profile_->bed.z_offset};
    const auto go = [&](double z, const std::string& how, double speed) {
        if (!words({units(p.place.x - shift.x, xyz_scale_), units(p.place.y - shift.y, xyz_scale_),
                    units(z - shift.z, xyz_scale_), at_[3], at_[4]},
                   how))
            return;
        feed(speed);
        end_line();
        ++lines_;
    };
    go(std::max(step.to.z, p.height), profile_->format.travel_code, own().feeds.travel);
    go(p.height, "G1", own().feeds.z);
    if (step.halt) prime();
    if (counts()) {
        const double per_mm3 = own().extrusion.per_mm3();
        extruder_only(units(step.volume * per_mm3, e_scale_), p.speed * per_mm3);
    } else {
        values_["purge_s"] = step.volume / p.speed;
        values_["purge_ms"] = std::round(1000 * step.volume / p.speed);
        code(on(step));
        code(p.wait);
        code(off(step));
    }
    code(p.after);
    if (!p.after.empty()) {
        at_.fill(kUnknown); // the codes may move the tool
        f_ = -1;
    }
    retract();
    go(std::max(step.to.z, p.height), "G1", own().feeds.z);
}

void Program::push() {
    extruder_only(units(profile_->fibre.prime, e_scale_), profile_->fibre.prime_speed);
    if (counts() && !profile_->extrusion.relative && profile_->fibre.prime > 0) reset_extruder();
}

void Program::bead_comments(const Step& step) {
    if (!profile_->format.viewer_comments) return;
    if (step.role != role_ || step.feature != feature_) {
        comment(std::string("TYPE:") + machine::type_name(step.role, step.feature));
        if (!machine::says_all(step.role, step.feature))
            comment(std::string("ROLE:") + toolpath::kRoleNames[static_cast<std::size_t>(step.role)] + " " +
                    toolpath::kFeatureNames[static_cast<std::size_t>(step.feature)]);
    }
    width_comment(step);
    if (differs(step.height, height_, counts() ? kTold : kToldAlone))
        comment("HEIGHT:" + fixed_text(height_ = step.height, 3));
    role_ = step.role;
    feature_ = step.feature;
}

// Writes the width of a bead for viewers.  A width that lasts for at most one bead width, of the wider of both beads,
// is not written where extruder words hold the material: a nozzle cannot deliver it, and turns and joins of lines are
// full of such widths.
void Program::width_comment(const Step& step) {
    const bool same = !differs(step.width, width_, counts() ? kTold : kToldAlone);
    unwritten_ = same ? 0 : unwritten_ + step.length;
    if (same || (counts() && width_ > 0 && step.role == role_ && unwritten_ <= std::max(step.width, width_))) return;
    comment("WIDTH:" + fixed_text(width_ = step.width, 3));
    unwritten_ = 0;
}

// Appends the code and the words that changed.  If none did, it appends nothing and returns false.  `to` is in units of
// the last decimal.
bool Program::words(const std::array<std::int64_t, 5>& to, std::string_view code) {
    if (to == at_) return false;
    text_ += code;
    const char letters[] = {'X', 'Y', 'Z', profile_->axes.tilt_letter, profile_->axes.turn_letter};
    for (std::size_t k = 0; k < to.size(); ++k) {
        if (to[k] == at_[k] || (k == 1 && profile_->axes.chain.carrier == kinematics::Carrier::polar)) continue;
        text_ += ' ';
        text_ += letters[k];
        append_units(text_, to[k], k < 3 ? profile_->format.xyz_decimals : profile_->axes.angle_decimals);
    }
    at_ = to;
    return true;
}

// Appends the words of an extruding move.  An arc is written as an arc unless it is too small to differ from its chord.
bool Program::bead_words(const Step& step, const std::array<std::int64_t, 5>& to) {
    const std::int64_t i = units(step.centre.x + shift_.x, xyz_scale_) - at_[0],
                       j = units(step.centre.y + shift_.y, xyz_scale_) - at_[1];
    constexpr std::int64_t least = 10; // units of the last decimal
    const auto far = [](std::int64_t a, std::int64_t b) { return std::abs(a) + std::abs(b) >= least; };
    if (step.sweep == 0 || !far(i, j) || !far(to[0] - at_[0], to[1] - at_[1])) return words(to, "G1");
    text_ += step.sweep > 0 ? "G3" : "G2";
    const auto word = [&](char letter, std::int64_t value) {
        text_ += ' ';
        text_ += letter;
        append_units(text_, value, profile_->format.xyz_decimals);
    };
    word('X', to[0]);
    word('Y', to[1]);
    if (to[2] != at_[2]) word('Z', to[2]);
    word('I', i);
    word('J', j);
    at_ = to;
    return true;
}

void Program::feed_units(double value) {
    const auto f = std::max<std::int64_t>(1, units(value, f_scale_));
    if (f == f_) return;
    text_ += " F";
    append_units(text_, f, profile_->format.f_decimals);
    f_ = f;
}

void Program::feed(double mm_per_s) { feed_units(mm_per_s * 60); }

// Appends the feed of a machine with rotary axes, in the meaning of the profile's feed word.  `way`: way of X, Y and Z,
// mm.
void Program::feed(const Step& step, double way) {
    constexpr double degrees = 180 / std::numbers::pi;
    const double turned = std::max(std::abs(step.tilt - tilt_), std::abs(step.turn - turn_)) * degrees;
    tilt_ = step.tilt;
    turn_ = step.turn;
    if (!(step.seconds > 0)) { // unknown duration: the step's feed, as the last feed may be unknown
        if (profile_->axes.feed_word == machine::FeedWord::per_minute) feed(step.feed);
        return;
    }
    switch (profile_->axes.feed_word) {
    case machine::FeedWord::per_minute:
        return feed_units(60 * (way > 0 ? way : turned) / step.seconds);
    case machine::FeedWord::inverse:
        f_ = -1; // each line needs its own F word
        return feed_units(60 / step.seconds);
    case machine::FeedWord::seconds:
        return feed_units(step.seconds);
    }
}

// Appends the extruder word for `units` more material.
void Program::material(std::int64_t units) {
    if (units == 0) return;
    e_ += units;
    text_ += ' ';
    text_ += profile_->extrusion.letter;
    append_units(text_, profile_->extrusion.relative ? units : e_, profile_->format.e_decimals);
}

void Program::extruder_only(std::int64_t units, double speed) {
    if (units == 0 || !counts()) return;
    text_ += "G1";
    material(units);
    const double seconds = std::max(static_cast<double>(std::abs(units)) / e_scale_ / speed, kLeastSeconds);
    if (profile_->axes.active() && profile_->axes.feed_word != machine::FeedWord::per_minute) {
        f_ = -1;
        feed_units(profile_->axes.feed_word == machine::FeedWord::inverse ? 60 / seconds : seconds);
    } else {
        feed(speed);
    }
    end_line();
}

void Program::move(const Step& step) {
    const bool rotary = profile_->axes.active();
    const Vec3 at = rotary ? step.to : step.to - own(step).offset + Vec3{0, 0, profile_->bed.z_offset};
    if (step.act == Act::travel) name_part(step);
    tell_progress(step);
    std::array<std::int64_t, 5> to{units(at.x + shift_.x, xyz_scale_), units(at.y + shift_.y, xyz_scale_),
                                   units(at.z, xyz_scale_), at_[3], at_[4]};
    if (profile_->axes.chain.carrier == kinematics::Carrier::polar) to[1] = 0;
    if (rotary) {
        to[3] = units(step.tilt, degrees_scale_);
        to[4] = units(step.turn, degrees_scale_);
    }
    const bool known = at_[0] != kUnknown && at_[1] != kUnknown && at_[2] != kUnknown;
    // If the position is unknown, the way is measured from the assumed position of the axes.
    double way =
        known ? std::hypot(to[0] - at_[0], to[1] - at_[1], to[2] - at_[2]) / xyz_scale_ : distance(step.axes, stood_);
    stood_ = step.axes;
    const bool timed = rotary && profile_->axes.feed_word != machine::FeedWord::per_minute;
    if (known && way < toolpath::kLeastMove * (1 - 1e-9)) {
        to[0] = at_[0];
        to[1] = at_[1];
        to[2] = at_[2];
        way = 0;
    }
    if (step.act == Act::climb) {
        const bool rapid = timed && !(step.seconds > 0); // from an unknown position
        if (!words({at_[0], at_[1], to[2], at_[3], at_[4]}, rapid ? profile_->format.travel_code : "G1"))
            return; // x and y keep their values, even unknown ones
        if (rotary && !timed && !(step.seconds > 0)) feed(step.feed);
    } else if (step.act == Act::travel) {
        if (!words(to, rotary && step.seconds > 0 ? "G1" : profile_->format.travel_code)) return;
    } else {
        feature_codes(step);
        laid_ += feeds(step);
        bead_comments(step);
        const auto from = at_;
        if (!bead_words(step, to)) return; // too short: its material goes into the next move
        if (wipes(*profile_, own().travel)) {
            const auto place = [](const auto& p) { return Vec3{double(p[0]), double(p[1]), double(p[2])}; };
            if (step.sweep == 0)
                wipe_path_.add(place(from), place(at_), own().travel.wipe * xyz_scale_);
            else
                wipe_path_.clear(); // the way back over an arc is not known
        }
        if (counts()) material(due());
    }
    if (rotary)
        feed(step, way);
    else
        feed(step.feed);
    end_line();
    ++lines_;
}

// The extruder units not yet written for the beads so far.  They are never negative, so no stroke takes material back.
std::int64_t Program::due() {
    const auto total = units(laid_, e_scale_);
    return total - std::exchange(laid_units_, total);
}

void Program::close(const Step& step) {
    extruder_only(due(), own().travel.retract_speed);
    code(off(step));
    role_ = Role::travel;
}

void Program::retract() {
    const auto& t = own().travel;
    if (!t.retract_codes.empty()) return code(t.retract_codes);
    const std::int64_t all = units(t.retract, e_scale_);
    extruder_only(wipe(all) - all, t.retract_speed);
}

// Goes back over the last bead and takes material back meanwhile.  `all`: extruder units of the whole retraction.
// Returns the units that were taken back.
std::int64_t Program::wipe(std::int64_t all) {
    const auto& t = own().travel;
    if (!wipes(*profile_, t)) return 0;
    const auto places = wipe_path_.back(t.wipe * xyz_scale_);
    if (places.empty()) return 0; // as before the first stroke
    const std::int64_t first = units(t.retract * t.before_wipe, e_scale_);
    extruder_only(-first, t.retract_speed);
    const auto step = [&](std::size_t i) {
        const Vec3 from = i > 0 ? places[i - 1] : Vec3{double(at_[0]), double(at_[1]), double(at_[2])};
        return geom::distance(from, places[i]);
    };
    std::vector<double> ways; // up to each place
    for (std::size_t i = 0; i < places.size(); ++i) ways.push_back((i > 0 ? ways.back() : 0) + step(i));
    std::int64_t taken = first;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::array<std::int64_t, 5> to{units(places[i].x, 1), units(places[i].y, 1), at_[2], at_[3], at_[4]};
        if (!words(to, "G1")) continue;
        const std::int64_t due = first + units(static_cast<double>(all - first) * ways[i] / ways.back(), 1);
        material(taken - due);
        taken = due;
        feed(wipe_feed(t, own().feeds, ways.back() / xyz_scale_));
        end_line();
    }
    wipe_path_.clear();
    return taken;
}

void Program::prime() {
    const auto& t = own().travel;
    if (!t.prime_codes.empty()) return code(t.prime_codes);
    const double speed = t.prime_speed > 0 ? t.prime_speed : t.retract_speed;
    extruder_only(units(t.retract, e_scale_) + units(t.extra, e_scale_), speed);
}

void Program::cut() {
    (void)due(); // the remainder from rounding cannot be fed after the cut
    code(profile_->fibre.cut);
}

} // namespace filum::postproc
