#include "metrics/figures/said.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::figures {

void said_before(const Notes& notes, const Facts& facts, Figures& out) {
    for (const Fact& f : facts)
        out.push_back({"said by the stages before", f.stage + ": " + f.name,
                       fixed_text(f.value, 4) + (f.unit.empty() ? "" : " " + f.unit)});
    Notes sums;
    for (const Note& n : notes) {
        const auto it = std::find_if(sums.begin(), sums.end(), [&](const Note& s) {
            return s.stage == n.stage && s.what == n.what && s.unit == n.unit;
        });
        if (it == sums.end())
            sums.push_back(n);
        else
            it->amount += n.amount, it->count += n.count;
    }
    for (const Note& n : sums)
        out.push_back(
            {"said by the stages before", n.stage + ": " + n.what,
             std::to_string(n.count) + (n.count == 1 ? " case" : " cases") +
                 (n.unit.empty() || !std::isfinite(n.amount) ? "" : ", " + fixed_text(n.amount, 4) + " " + n.unit)});
}

} // namespace filum::metrics::figures
