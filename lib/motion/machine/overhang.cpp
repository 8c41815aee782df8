#include "machine/overhang.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <cmath>
#include <sstream>
#include <string>

namespace filum::machine {

double Overhang::feed(double own, double share) const {
    if (steps.empty() || share < steps.front().share) return own;
    const auto feed_of = [&](const Step& s) { return s.relative ? s.feed * own : s.feed; };
    for (std::size_t k = 1; k < steps.size(); ++k) {
        const Step &low = steps[k - 1], &high = steps[k];
        if (share >= high.share) continue;
        return std::lerp(feed_of(low), feed_of(high), (share - low.share) / (high.share - low.share));
    }
    return feed_of(steps.back());
}

Overhang overhang(std::string_view text) {
    constexpr double kMostFeed = 1e5, kMostPercent = 1000;
    Overhang out;
    std::istringstream items{std::string(text)};
    for (std::string item; items >> item;) {
        const auto colon = item.find(':');
        if (colon == std::string::npos)
            throw Error(Exit::usage, "cannot read '" + item + "': write SHARE:FEED, as in 0.25:40 or 0.25:60%");
        Overhang::Step step;
        step.share = parse_number(std::string_view(item).substr(0, colon), "the share over air");
        step.relative = item.ends_with('%');
        const std::string feed = item.substr(colon + 1, item.size() - colon - (step.relative ? 2 : 1));
        step.feed = parse_number(feed, "the speed over air");
        const double most = step.relative ? kMostPercent : kMostFeed;
        if (!(step.share >= (out.steps.empty() ? 0 : std::nextafter(out.steps.back().share, 2)) && step.share <= 1))
            throw Error(Exit::usage, "cannot use '" + item + "': shares must be from 0 to 1, and grow");
        if (!(step.feed > 0 && step.feed <= most))
            throw Error(Exit::usage,
                        "cannot use '" + item + "': a speed must be above 0, and at most " + shortest_text(most));
        if (step.relative) step.feed /= 100;
        out.steps.push_back(step);
    }
    return out;
}

void read_overhang(Document& doc, Overhang& to) {
    std::string text;
    doc.text("overhang.feeds", text);
    try {
        to = overhang(text);
    } catch (const Error& e) {
        doc.fail("overhang.feeds", e.what());
    }
}

} // namespace filum::machine
