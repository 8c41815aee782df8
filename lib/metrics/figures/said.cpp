#include "metrics/figures/said.hpp"

#include "base/number.hpp"
#include "metrics/figures/meanings.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::figures {

namespace {

// As many as the value needs, at most four.
int decimals(double v) {
    const std::string text = fixed_text(v, 4);
    const auto point = text.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

} // namespace

void said_before(const Notes& notes, const Facts& facts, Figures& out) {
    for (const Fact& f : facts) {
        Figure said{"said by the stages before", f.stage + ": " + f.name, f.value, decimals(f.value), f.unit};
        said.key = "said." + key_text(f.stage) + "." + key_text(f.name);
        out.push_back(std::move(said));
    }
    Notes sums;
    for (const Note& n : notes) {
        const auto it = std::find_if(sums.begin(), sums.end(), [&](const Note& s) {
            return s.stage == n.stage && s.what == n.what && s.unit == n.unit;
        });
        if (it == sums.end())
            sums.push_back(n);
        else {
            it->amount += n.amount;
            it->count += n.count;
        }
    }
    for (const Note& n : sums) {
        const std::string key = "noted." + key_text(n.stage) + "." + key_text(n.what) + ".",
                          name = n.stage + ": " + n.what;
        out.push_back({"said by the stages before", name, n.count, 0, n.count == 1 ? "case" : "cases", key + "cases"});
        if (n.unit.empty() || !std::isfinite(n.amount)) continue;
        out.push_back({"said by the stages before", name + ", in all", n.amount, decimals(n.amount), n.unit,
                       key + key_text(n.unit)});
    }
}

} // namespace filum::metrics::figures
