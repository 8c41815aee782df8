#include "render/view.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <array>
#include <cmath>

namespace filum::render {

namespace {

using geom::Vec3;

constexpr std::size_t kMostLooks = 64;

const std::vector<ViewDirection>& names() {
    constexpr Vec3 kIso{1, -1.5, 0.9};
    constexpr double kLean = 1.2; // tangent of 50 degrees
    static const std::vector<ViewDirection> kNames = {
        {"iso", kIso},
        {"top", {0, 0, 1}},
        {"bottom", {0, 0, -1}},
        {"front", {0, -1, 0.12}},
        {"back", {0, 1, 0.12}},
        {"left", {-1, 0, 0.12}},
        {"right", {1, 0, 0.12}},
        {"face", kIso, true},
        {"face-left", kIso, true, -kLean, 0},
        {"face-right", kIso, true, kLean, 0},
        {"face-up", kIso, true, 0, kLean},
        {"face-down", kIso, true, 0, -kLean},
    };
    return kNames;
}

[[noreturn]] void misused(const std::string& list, const std::string& option) {
    throw Error(
        Exit::usage,
        "cannot use '" + list + "' for --" + option +
            ": it must be iso, top, bottom, front, back, left, right, face, face-left, -right, -up, -down, or three " +
            "numbers with commas between, not all 0");
}

std::vector<std::string> words(const std::string& list) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t comma = std::min(list.find(',', at), list.size());
        out.push_back(list.substr(at, comma - at));
        at = comma + 1;
    }
    return out;
}

// The number of columns of a sheet of n cells: the one with cells nearest to 4 : 3 and few empty cells. Ties: fewer
// columns.
int columns(int n, int width, int height) {
    int best = 1;
    double least = INFINITY;
    for (int c = 1; c <= n; ++c) {
        const int rows = (n + c - 1) / c;
        const double ratio = (static_cast<double>(width) / c) / (static_cast<double>(height) / rows);
        const double off = std::abs(std::log(ratio * 3 / 4)) + 0.2 * (c * rows - n);
        if (off < least) {
            least = off;
            best = c;
        }
    }
    return best;
}

} // namespace

std::vector<ViewDirection> looks(const std::string& list, const std::string& option) {
    const auto all = words(list);
    std::vector<ViewDirection> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        bool known = false;
        for (const ViewDirection& l : names())
            if (l.name == all[i]) {
                out.push_back(l);
                known = true;
            }
        if (known) continue;
        if (i + 2 >= all.size() || all[i].find_first_of("0123456789") == std::string::npos) misused(list, option);
        std::array<double, 3> v{};
        for (std::size_t k = 0; k < 3; ++k) v[k] = parse_number(all[i + k], "--" + option);
        const Vec3 from{v[0], v[1], v[2]};
        if (!(norm(from) > 1e-100) || !std::isfinite(norm(from))) misused(list, option);
        out.push_back({all[i] + "," + all[i + 1] + "," + all[i + 2], from});
        i += 2;
    }
    if (out.size() > kMostLooks)
        throw Error(Exit::usage, "cannot draw more than 64 views; ask for fewer in --" + option);
    return out;
}

void contact_sheet(Canvas& page, const std::vector<ViewDirection>& looks, const Draw& draw) {
    if (looks.size() == 1) return draw(page, looks.front());
    const int width = page.width(), height = page.height(), n = static_cast<int>(looks.size()),
              across = columns(n, width, height), down = (n + across - 1) / across;
    for (int k = 0; k < n; ++k) {
        const int i = k % across, j = k / across;
        const int x0 = i * width / across, x1 = (i + 1) * width / across;
        const int y0 = j * height / down, y1 = (j + 1) * height / down;
        if (x1 - x0 < 2 || y1 - y0 < 2) continue; // no room for a picture
        Canvas cell = page.part(x0, y0, x1 - x0 - 1, y1 - y0 - 1);
        draw(cell, looks[static_cast<std::size_t>(k)]);
        const double size = std::clamp(cell.height() / 60.0, 6.0, 24.0);
        cell.text({size, 1.8 * size}, size, looks[static_cast<std::size_t>(k)].name, oklch(0.42, 0.02, 260));
    }
}

} // namespace filum::render
