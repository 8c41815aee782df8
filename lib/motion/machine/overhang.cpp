#include "machine/overhang.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <cmath>
#include <sstream>
#include <string>

namespace filum::machine {

namespace {

using Steps = std::vector<Overhang::Step>;

constexpr double kMostFeed = 1e5, kMostPercent = 1000; // mm/s, %
constexpr double kMostFan = 1e4;                       // as of [cooling]

double value_at(const Steps& steps, double own, double share) {
    if (steps.empty() || share < steps.front().share) return own;
    const auto value_of = [&](const Overhang::Step& s) { return s.relative ? s.value * own : s.value; };
    for (std::size_t k = 1; k < steps.size(); ++k) {
        const Overhang::Step &low = steps[k - 1], &high = steps[k];
        if (share >= high.share) continue;
        return std::lerp(value_of(low), value_of(high), (share - low.share) / (high.share - low.share));
    }
    return value_of(steps.back());
}

// The share of an item, and the text of its value.  The share is above that of the step before.
Overhang::Step step_of(const std::string& item, const Steps& before, const char* example, std::string& value) {
    const auto colon = item.find(':');
    if (colon == std::string::npos) throw Error(Exit::usage, "cannot read '" + item + "': write SHARE:" + example);
    value = item.substr(colon + 1);
    Overhang::Step out;
    out.share = parse_number(std::string_view(item).substr(0, colon), "the share over air");
    if (!(out.share >= (before.empty() ? 0 : std::nextafter(before.back().share, 2)) && out.share <= 1))
        throw Error(Exit::usage, "cannot use '" + item + "': shares must be from 0 to 1, and grow");
    return out;
}

void read_steps(Document& doc, const char* key, Steps (*steps)(std::string_view), Steps& to) {
    std::string text;
    doc.text(key, text);
    try {
        to = steps(text);
    } catch (const Error& e) {
        doc.fail(key, e.what());
    }
}

} // namespace

double Overhang::feed(double own, double share) const { return value_at(steps, own, share); }

double Overhang::fan(double share) const { return value_at(fans, -1, share); }

Steps overhang_feeds(std::string_view text) {
    Steps out;
    std::istringstream items{std::string(text)};
    for (std::string item, value; items >> item;) {
        Overhang::Step step = step_of(item, out, "FEED, as in 0.25:40 or 0.25:60%", value);
        step.relative = value.ends_with('%');
        if (step.relative) value.pop_back();
        step.value = parse_number(value, "the speed over air");
        const double most = step.relative ? kMostPercent : kMostFeed;
        if (!(step.value > 0 && step.value <= most))
            throw Error(Exit::usage,
                        "cannot use '" + item + "': a speed must be above 0, and at most " + shortest_text(most));
        if (step.relative) step.value /= 100;
        out.push_back(step);
    }
    return out;
}

Steps overhang_fans(std::string_view text) {
    Steps out;
    std::istringstream items{std::string(text)};
    for (std::string item, value; items >> item;) {
        Overhang::Step step = step_of(item, out, "FAN, as in 0.5:128", value);
        step.value = parse_number(value, "the fan over air");
        if (!(step.value >= 0 && step.value <= kMostFan))
            throw Error(Exit::usage, "cannot use '" + item + "': a fan must be from 0 to " + shortest_text(kMostFan));
        out.push_back(step);
    }
    return out;
}

void read_overhang(Document& doc, Overhang& to) {
    read_steps(doc, "overhang.feeds", overhang_feeds, to.steps);
    read_steps(doc, "overhang.fans", overhang_fans, to.fans);
}

} // namespace filum::machine
