#include "app/filum/slicer_overhangs.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::app::filum {

namespace {

// The steps of a text for the key overhang.feeds of a machine.
class Steps {
  public:
    void add(double share, double mm_s) { put(share, shortest_text(std::round(mm_s * 1e3) / 1e3)); }
    void add_own(double share) { put(share, "100%"); }
    void add_or_own(double share, double mm_s) { mm_s > 0 ? add(share, mm_s) : add_own(share); }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    void put(double share, const std::string& feed) {
        text_ += (text_.empty() ? "" : " ") + shortest_text(share) + ":" + feed;
    }
    std::string text_;
};

// The share over air of a wall whose degree of overhang is this part of the whole range of degrees.
double share_of_degree(double part) { return std::round((0.1 + 0.9 * part) * 1e4) / 1e4; }

constexpr double kJump = 0.001; // share within which a speed changes at once

// Whether `key` is the first of these keys that the file has.
bool is_first(const SlicerValues& values, const std::string& key, std::initializer_list<const char*> keys) {
    for (const char* k : keys)
        if (!values.text(k).empty()) return key == k;
    return false;
}

std::vector<std::string> speed_words(const SlicerValues& values) {
    const auto speed = [&](const char* key) { return values.speed(key, row_of(key, values.slicer())); };
    Steps steps;
    if (!values.of_orca()) {
        if (values.number_or("enable_dynamic_overhang_speeds", 0) == 0) return {};
        const auto own = [&](const char* key) {
            const double mm_s = speed(key);
            return mm_s > 0 ? mm_s : speed("external_perimeter_speed");
        };
        steps.add_own(0);
        steps.add(0.25, own("overhang_speed_3"));
        steps.add(0.5, own("overhang_speed_2"));
        steps.add(0.75, own("overhang_speed_1"));
        steps.add(1, own("overhang_speed_0"));
        return {"--overhang-shares", "--set=overhang.feeds=" + steps.text()};
    }
    if (values.number_or("enable_overhang_speed", 1) == 0) return {};
    const std::array quarters{speed("overhang_1_4_speed"), speed("overhang_2_4_speed"), speed("overhang_3_4_speed"),
                              speed("overhang_4_4_speed")};
    if (std::ranges::all_of(quarters, [](double mm_s) { return mm_s <= 0; })) return {};
    // presets of Bambu Studio need not name it
    const bool bambu = values.slicer() == Slicer::bambu || !values.text("overhang_totally_speed").empty();
    const double bridge = speed(bambu ? "overhang_totally_speed" : "bridge_speed");
    const auto put = [&](const std::array<double, 4>& shares, double end, double last) {
        for (std::size_t k = 0; k < shares.size(); ++k) steps.add_or_own(shares[k], quarters[k]);
        if (end > shares.back() + kJump && bambu) steps.add_or_own(end - kJump, quarters.back());
        steps.add_or_own(end, last);
    };
    if (bambu || values.number_or("overhang_speed_classic", 0) != 0) {
        const std::array<double, 4> parts = bambu ? std::array{0.1, 0.25, 0.5, 0.75} : std::array{0.2, 0.4, 0.6, 0.8};
        std::array<double, 4> shares{};
        std::ranges::transform(parts, shares.begin(), share_of_degree);
        steps.add_own(share_of_degree(0));
        put(shares, 1, bridge);
    } else {
        const bool curled = values.number_or("slowdown_for_curled_perimeters", 1) != 0;
        put({0.25, 0.5, 0.75, 0.87}, 0.87 + kJump, curled ? quarters.back() : bridge);
    }
    return {"--overhang-shares", "--set=overhang.feeds=" + steps.text()};
}

// The fan of walls over air.  PrusaSlicer has a speed for each share, and none on walls that rest on the layer below.
// In OrcaSlicer and Bambu Studio walls have the fan of overhangs from a share on.
std::vector<std::string> fan_words(const SlicerValues& values, std::vector<std::string>& remarks) {
    constexpr double kFull = 2.55; // of the fan for 1 %
    Steps steps;
    if (!values.of_orca()) {
        if (values.number_or("enable_dynamic_fan_speeds", 0) == 0) return {};
        steps.add(0, 0);
        for (const auto& [share, key] :
             {std::pair(0.25, "overhang_fan_speed_3"), std::pair(0.5, "overhang_fan_speed_2"),
              std::pair(0.75, "overhang_fan_speed_1"), std::pair(1.0, "overhang_fan_speed_0")})
            steps.add(share, kFull * values.number_or(key, 0));
    } else {
        if (values.number_or("enable_overhang_bridge_fan", 1) == 0) return {};
        const double from = values.number("overhang_fan_threshold") / 100;
        if (!(from > 0)) {
            remarks.emplace_back(
                "overhang_fan_threshold = 0%: outer walls that rest on the layer below have the fan of "
                "the others");
            steps.add(0, kFull * values.number_or("overhang_fan_speed", 100));
        } else {
            steps.add(from, kFull * values.number_or("overhang_fan_speed", 100));
        }
    }
    return {"--overhang-shares", "--set=overhang.fans=" + steps.text()};
}

} // namespace

std::vector<std::string> overhang_words(const SlicerValues& values, const std::string& key,
                                        std::vector<std::string>& remarks) {
    if (is_first(values, key, {"enable_dynamic_fan_speeds", "overhang_fan_threshold"}))
        return fan_words(values, remarks);
    return is_first(values, key,
                    {"enable_dynamic_overhang_speeds", "enable_overhang_speed", "overhang_1_4_speed",
                     "overhang_2_4_speed", "overhang_3_4_speed", "overhang_4_4_speed"})
               ? speed_words(values)
               : std::vector<std::string>{};
}

} // namespace filum::app::filum
