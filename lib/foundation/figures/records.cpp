#include "figures/records.hpp"

#include "base/number.hpp"
#include "figures/meanings.hpp"

#include <cmath>

namespace filum::figures {

namespace {

// As many as the value needs, at most four.
int decimals(double v) {
    const std::string text = fixed_text(v, 4);
    const auto point = text.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

} // namespace

void add_records(const Notes& notes, const Facts& facts, Figures& out) {
    for (const Fact& f : facts) {
        Figure said{"said by the stages before", f.stage + ": " + f.name, f.value, decimals(f.value), f.unit};
        said.key = "said." + key_text(f.stage) + "." + key_text(f.name);
        out.push_back(std::move(said));
    }
    for (const Note& n : summed(notes)) {
        const std::string key = "noted." + key_text(n.stage) + "." + key_text(code_name(n)) + ".",
                          name = n.stage + ": " + code_name(n), group = "notes of the stages";
        out.push_back(
            {group, n.stage + ": " + sentence(n), std::string(::filum::name(grade(n))), 0, "", key + "grade"});
        out.push_back({group, name, n.count, 0, n.count == 1 ? "case" : "cases", key + "cases"});
        if (unit(n).empty() || !std::isfinite(n.amount)) continue;
        out.push_back({group, name, n.amount, decimals(n.amount), unit(n), key + key_text(unit(n))});
    }
}

} // namespace filum::figures
