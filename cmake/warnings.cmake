# Flags for the project's own code; generated protobuf code gets none of the warnings.
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()
# -Wno-restrict: g++ 12 sees overlap in every std::string operator+ (its bug 105651).
set(FILUM_WARNINGS -Wall -Wextra)
# Warnings are errors for g++ 12, with which CI builds. Newer ones find other things, some of them falsely (g++ 14: array
# bounds, where it inlines std::vector), and a warning must not keep anybody from building.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    list(APPEND FILUM_WARNINGS -Werror -Wno-restrict)
endif()
# -ffp-contract=off: the same bytes whether or not the compiler finds a fused multiply-add.
add_compile_options(-ffp-contract=off)
# Roots and roundings are single instructions if nobody asks errno or traps for what went wrong in them; same values.
add_compile_options(-fno-math-errno -fno-trapping-math)
# A program asks only for the shared libraries that it uses.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_link_options(LINKER:--as-needed)
endif()
if(FILUM_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # The sanitizers' own code hides what is initialised (GCC's manual says so); the plain build still asks.
        list(APPEND FILUM_WARNINGS -Wno-maybe-uninitialized)
    endif()
    # These checks alone more than double the time to compile.  AddressSanitizer stops at a null access, and where a
    # pointer leads out of an object, anyway; the readers of foreign bytes have all checks (tests/fuzz).
    add_compile_options(-fno-sanitize=null,alignment,pointer-overflow)
    # Nearly all of this is CGAL's code: it takes longest of all to compile.
    set_source_files_properties(lib/shapes/surface/remesh.cpp PROPERTIES COMPILE_OPTIONS "-fno-sanitize=all;-O0")
endif()
if(FILUM_FIND_RACES)
    add_compile_options(-fsanitize=thread)
    add_link_options(-fsanitize=thread)
    add_compile_definitions(FILUM_PLAIN_THREADS)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        list(APPEND FILUM_WARNINGS -Wno-tsan -Wno-maybe-uninitialized)
    endif()
    set_source_files_properties(lib/shapes/surface/remesh.cpp PROPERTIES COMPILE_OPTIONS "-fno-sanitize=all;-O0")
endif()
