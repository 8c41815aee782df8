// Files that the build puts into the program.
#pragma once

#include <string_view>

namespace filum {

inline std::string_view embedded(const char* begin, const char* end) {
    return {begin, static_cast<std::size_t>(end - begin)};
}

} // namespace filum

// Embeds the file of this path, a string literal, under a name. The assembler does it, between two labels. The build
// defines the path: filum_embed() in cmake/embed.cmake. To be used outside of namespaces.
#define FILUM_EMBED(name, file)                                                                                        \
    __asm__(".section .rodata\n.global filum_file_" #name "\nfilum_file_" #name ":\n.incbin \"" file                   \
            "\"\n.global filum_file_" #name "_end\nfilum_file_" #name "_end:\n.byte 0\n.previous\n");                  \
    extern "C" const char filum_file_##name[], filum_file_##name##_end[]

// Its content.
#define FILUM_EMBEDDED(name) ::filum::embedded(filum_file_##name, filum_file_##name##_end)
