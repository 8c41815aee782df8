// The meaning of the columns of a table of stresses; private to lib/curved/stressfield.
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

// From the names of a header, independent of case, units and punctuation: "X [mm]", "S-S11", "Points:0". `doubt` is
// set to "", or to a text that names two columns with the same role if that role is used.
Columns columns_of_header(const std::vector<std::string_view>& names, std::string& doubt);

// From the words of --columns, one role each; "-" for an unused column. Throws Error(usage) that names an unknown
// role.
Columns columns_of_option(const std::string& words);

// Without a header and --columns: position and vector if there are six columns, also s1 if seven. All kNoColumn for
// other counts.
Columns columns_of_count(std::size_t count);

bool has_position(const Columns& columns);
bool has_tensor(const Columns& columns);

// Whether the role is read: the position, and the tensor or else vector and principal stresses.
bool is_used(const Columns& columns, std::size_t role);

// "" if the columns are positions and either vectors or tensors; otherwise the missing ones.
std::string missing(const Columns& columns);

// Whether a column of this name distinguishes load cases: "Step", "Frame", "Time", "Section Point".
bool tells_cases(std::string_view name);

} // namespace filum::stressfield
