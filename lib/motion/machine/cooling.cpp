#include "machine/cooling.hpp"

#include <algorithm>
#include <cmath>

namespace filum::machine {

double Cooling::share(std::uint32_t layer) const {
    const auto number = static_cast<int>(std::min<std::uint32_t>(layer, 1'000'000));
    if (number < off_layers) return 0;
    const int full = full_layer <= off_layers && off_layers > 0 ? off_layers + 1 : full_layer;
    if (number + 1 >= full) return 1;
    return static_cast<double>(number + 1 - off_layers) / (full - off_layers);
}

double Cooling::speed(std::uint32_t layer, double seconds) const {
    double out = idle;
    if (seconds < fast) {
        out = most;
    } else if (seconds < below) {
        const double slow = (seconds - fast) / (below - fast);
        out = slow * least + (1 - slow) * most;
    }
    return share(layer) * out;
}

double Cooling::raised(std::uint32_t layer, double seconds, double wanted) const {
    return std::max(speed(layer, seconds), share(layer) * wanted);
}

void read_cooling(Document& doc, Cooling& c) {
    constexpr double kMostSpeed = 1e4, kMostSeconds = 1e5;
    constexpr int kMostLayers = 1'000'000;
    doc.number("cooling.most", c.most, {-1, kMostSpeed});
    doc.number("cooling.least", c.least, {0, kMostSpeed});
    doc.number("cooling.idle", c.idle, {0, kMostSpeed});
    doc.number("cooling.bridge", c.bridge, {0, kMostSpeed});
    doc.number("cooling.fast", c.fast, {0, kMostSeconds});
    doc.number("cooling.below", c.below, {0, kMostSeconds});
    doc.whole("cooling.off_layers", c.off_layers, 0, kMostLayers);
    doc.whole("cooling.full_layer", c.full_layer, 0, kMostLayers);
}

} // namespace filum::machine
