// What the columns of a table of stresses mean; private to lib/stressfield.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace filum::stressfield {

// Position; vector of the greatest principal stress; principal stresses; tensor.
enum Role : std::size_t { kX, kY, kZ, kVx, kVy, kVz, kS1, kS2, kS3, kXx, kYy, kZz, kXy, kYz, kZx, kRoles };

inline constexpr std::size_t kNoColumn = ~std::size_t{0};

using Columns = std::array<std::size_t, kRoles>; // per role its column, or kNoColumn

// By the names of a header, whatever their case, units and marks: "X [mm]", "S-S11", "Points:0".  `doubt` is "", or
// says which two columns have one role that is used.
Columns columns_of_header(const std::vector<std::string_view>& names, std::string& doubt);

// By the words of --columns, a role each, "-" for a column of no use.  Throws Error(usage) naming what is no role.
Columns columns_of_option(const std::string& words);

// Without either: position and vector if there are six, and its s1 if seven.  All kNoColumn for any other number.
Columns columns_of_count(std::size_t count);

bool has_position(const Columns& columns);
bool has_tensor(const Columns& columns);

// The roles that are read: those of the position, and the tensor or else vector and principal stresses.
bool is_used(const Columns& columns, std::size_t role);

// "" if they make up positions and either vectors or tensors; else what is missing.
std::string missing(const Columns& columns);

// Whether a column of this name tells load cases apart: "Step", "Frame", "Time", "Section Point".
bool tells_cases(std::string_view name);

} // namespace filum::stressfield
