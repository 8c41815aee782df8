// How programs are read back: shared by `ingest`, and by what measures the toolpaths that it makes.
#pragma once

namespace filum::machine {

// mm: largest distance of the lines that `ingest` reads from the tip's way on an arc or a move of rotary axes.
inline constexpr double kReadChord = 0.002;

} // namespace filum::machine
