// Changes of a profile that the user makes after it is read.
#include "machine/profile.hpp"

#include <utility>

namespace filum::machine {

namespace {

// Applies a change to the profile and to the profiles of its tools.
template <class Change>
void change_all(Profile& profile, const Change& change) {
    change(profile);
    for (auto& [number, one] : profile.own) {
        Profile copy = *one;
        change(copy);
        one = std::make_shared<const Profile>(std::move(copy));
    }
}

} // namespace

void merge_moves(Profile& profile, const Merging& merging) {
    change_all(profile, [&](Profile& p) { p.merging = merging; });
}

void set_pace(Profile& profile, const std::vector<double>& pace) {
    change_all(profile, [&](Profile& p) { p.pace = pace; });
}

} // namespace filum::machine
