// The name of every figure of every report for programs and for people, its unit and its definition (meanings.tsv).
#pragma once

#include "figures/figures.hpp"

#include <span>
#include <string>
#include <string_view>

namespace filum::figures {

struct Meaning {
    std::string_view key, group, name, unit;
    int decimals;
    std::string_view says; // the definition
};

std::span<const Meaning> planar_meanings();  // metrics, of layers
std::span<const Meaning> surface_meanings(); // metrics --surface
std::span<const Meaning> head_meanings();    // collide
std::span<const Meaning> job_meanings();     // postproc --job

// Appends the figure of that key, `of` in the place of '*'; std::logic_error if `meanings` lack it.
void tell(Figures& out, std::span<const Meaning> meanings, std::string_view key, decltype(Figure::value) value,
          std::string_view of = {});

// Heading and name that tables have for a key of `metrics`; both empty for any other.  Of a path on a surface its own.
struct FigureLabel {
    std::string group, name;
};
FigureLabel spoken(std::string_view key, bool on_surface);

// Text as part of a key: lower case, with '_' for everything except letters, digits and points.
std::string key_text(std::string_view text);

// docs/metrics.md: page.txt with the tables of all figures.
std::string meanings_page();

} // namespace filum::figures
