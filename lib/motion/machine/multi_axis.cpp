#include "machine/multi_axis.hpp"

#include "geom/angle.hpp"
#include "machine/reader.hpp"

#include <limits>

namespace filum::machine {

namespace {

using kinematics::Carrier;
using Range = Document::Range;

using geom::kDegree;
constexpr Range kPlace{-1e5, 1e5};

void point(Document& doc, const std::string& key, geom::Vec3& out) {
    doc.number(key + "_x", out.x, kPlace);
    doc.number(key + "_y", out.y, kPlace);
    doc.number(key + "_z", out.z, kPlace);
}

void degrees(Document& doc, const std::string& key, double& rad, Range range) {
    double value = rad / kDegree;
    doc.number(key, value, range);
    rad = value * kDegree;
}

void limits(Document& doc, const std::string& key, double& lo, double& hi) {
    double a = lo / kDegree, b = hi / kDegree;
    constexpr double endless = std::numeric_limits<double>::infinity();
    doc.pair(key, a, b, {-endless, endless});
    if (!(a < b)) doc.fail(key, "the first number must be below the second");
    lo = a * kDegree;
    hi = b * kDegree;
}

void letters(Document& doc, MultiAxis& m) {
    std::string tilt(1, m.tilt_letter), turn(1, m.turn_letter), about = "y";
    doc.choice("kinematics.tilt_letter", tilt, {"A", "B", "U", "V", "W"});
    doc.choice("kinematics.turn_letter", turn, {"A", "B", "C", "U", "V", "W"});
    doc.choice("kinematics.tilt_about", about, {"x", "y", "-x", "-y"});
    if (tilt == turn) doc.fail("kinematics.turn_letter", "it must not be the tilt axis' letter");
    m.tilt_letter = tilt.front();
    m.turn_letter = turn.front();
    const double sign = about.front() == '-' ? -1 : 1;
    m.chain.tilt_axis = about.back() == 'x' ? geom::Vec3{sign, 0, 0} : geom::Vec3{0, sign, 0};
    bool reversed = false;
    doc.flag("kinematics.turn_reversed", reversed);
    m.chain.turn_sign = reversed ? -1 : 1;
}

void speeds(Document& doc, MultiAxis& m) {
    degrees(doc, "kinematics.tilt_speed_deg", m.tilt_speed, {0, 1e6, true});
    degrees(doc, "kinematics.turn_speed_deg", m.turn_speed, {0, 1e6, true});
    degrees(doc, "kinematics.tilt_acceleration_deg", m.tilt_acceleration, {0, 1e8, true});
    degrees(doc, "kinematics.turn_acceleration_deg", m.turn_acceleration, {0, 1e8, true});
    degrees(doc, "kinematics.tilt_corner_speed_deg", m.tilt_corner_speed, {0, 1e6, true});
    degrees(doc, "kinematics.turn_corner_speed_deg", m.turn_corner_speed, {0, 1e6, true});
    limits(doc, "kinematics.tilt_deg", m.limits.tilt_min, m.limits.tilt_max);
    limits(doc, "kinematics.turn_deg", m.limits.turn_min, m.limits.turn_max);
}

void program(Document& doc, MultiAxis& m) {
    std::string numbers = m.numbers == Numbers::tip ? "tip" : "joints", feed = "inverse-time";
    doc.choice("kinematics.numbers", numbers, {"tip", "joints"});
    m.numbers = numbers == "tip" ? Numbers::tip : Numbers::joints;
    doc.choice("kinematics.feed_word", feed, {"per-minute", "inverse-time", "seconds"});
    m.feed_word = feed == "per-minute" ? FeedWord::per_minute
                  : feed == "seconds"  ? FeedWord::seconds
                                       : FeedWord::inverse;
    doc.text("kinematics.tcp_on", m.tcp_on);
    doc.text("kinematics.tcp_off", m.tcp_off);
    if (m.numbers == Numbers::tip && m.tcp_on.empty())
        doc.fail("kinematics.tcp_on", "programs of tip numbers need the code that tells the controller so");
    doc.number("kinematics.chord", m.chord, {1e-5, 1});
    degrees(doc, "kinematics.orientation_deg", m.orientation, {0, 45});
    std::string spin = "fixed";
    doc.choice("kinematics.spin", spin, {"fixed", "follow", "free"});
    m.spin = spin == "follow" ? Spin::follow : spin == "free" ? Spin::free : Spin::fixed;
    doc.number("kinematics.blend", m.blend, {0, 100});
    doc.whole("kinematics.angle_decimals", m.angle_decimals, 2, 8);
}

void start(Document& doc, MultiAxis& m) {
    std::array<double, 5> v{};
    if (!doc.list("kinematics.start", v, kPlace)) return;
    if (m.chain.carrier == Carrier::none || m.chain.carrier == Carrier::frame)
        doc.fail("kinematics.start", "it is for machines with rotary axes; a robot has robot.start");
    m.start = kinematics::Joints{{v[0], v[1], v[2]}, v[3] * kDegree, v[4] * kDegree};
    const auto& l = m.limits;
    if (m.start->tilt < l.tilt_min || m.start->tilt > l.tilt_max || m.start->turn < l.turn_min ||
        m.start->turn > l.turn_max)
        doc.fail("kinematics.start", "a rotary axis does not reach there");
}

} // namespace

void read_multi_axis(Document& doc, MultiAxis& m) {
    std::string carrier = "none";
    doc.choice("kinematics.carrier", carrier, {"none", "table-table", "head-table", "head-head", "polar", "frame"});
    m.chain.carrier = carrier == "table-table"  ? Carrier::table_table
                      : carrier == "head-table" ? Carrier::head_table
                      : carrier == "head-head"  ? Carrier::head_head
                      : carrier == "polar"      ? Carrier::polar
                      : carrier == "frame"      ? Carrier::frame
                                                : Carrier::none;
    letters(doc, m);
    speeds(doc, m);
    program(doc, m);
    if (m.chain.carrier == Carrier::polar && m.chain.tilt_axis.x != 0)
        doc.fail("kinematics.tilt_about", "a polar machine tilts about y or -y, across its radius");
    if (m.chain.carrier == Carrier::polar && m.numbers == Numbers::tip)
        doc.fail("kinematics.numbers", "a polar machine's numbers are its joints");
    point(doc, "kinematics.tilt_point", m.chain.tilt_point);
    point(doc, "kinematics.turn_point", m.chain.turn_point);
    point(doc, "kinematics.tip_to_tilt", m.chain.tip_to_tilt);
    point(doc, "kinematics.tilt_to_turn", m.chain.tilt_to_turn);
    start(doc, m);
}

} // namespace filum::machine
