// Names of tensors and of their components in the files of finite-element programs; private to lib/curved/stressfield.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::stressfield {

// The letters and digits of a name in lower case, Greek letters by their names, without a unit in brackets: "S-S11"
// becomes "ss11".
std::string plain(std::string_view name);

enum class Quantity { unknown, stress, strain };

// The quantity that the name of an array states: "S", "Nodal Stress", "SIEF_NOEU"; "E", "TOSTRAIN", "EPSI_NOEU".
Quantity quantity_of(std::string_view name);

// A component of a tensor, from its name: "XX", "SXY", "S-S13", "SIXZ", "stress_yz", "tau_xy", "X" (short for XX).
struct Component {
    std::string prefix; // plain, without the indices
    int row = 0, column = 0;
    bool short_form = false; // one letter stands for two
    bool digits = false;
    bool has_zero = false; // digits start at 0
};
std::optional<Component> component_of(std::string_view name);

inline constexpr int kUnused = -1;

// For each number of a point, the entry of Tensor (0 to 5: xx yy zz xy yz zx), or kUnused.
using Order = std::vector<int>;

// "xx yy zz xy yz zx"
std::string text_of(const Order& order);

// VTK's order of 6 or 9 components.
Order vtk_order(std::size_t width);

// The order given by component names; nothing if they do not name a complete tensor: each of six entries once, or each
// of nine. Names of other numbers (Mises, Magnitude) are ignored.
std::optional<Order> order_of_names(const std::vector<std::string>& names);

// The order of --order: "vtk", "abaqus", "voigt", "upper", or names separated by commas. Throws Error(usage).
Order order_of_option(const std::string& words, std::size_t width);

} // namespace filum::stressfield
