# Files that are put into the programs (lib/foundation/base/embed.hpp).

# Defines each NAME of NAME=PATH in `source` as the text of its path. `source` is compiled anew when one of the further
# files changes.
function(filum_embed source paths)
    list(TRANSFORM paths REPLACE "=(.*)" "=\"\\1\"")
    set_source_files_properties(${CMAKE_SOURCE_DIR}/lib/${source} PROPERTIES
        SKIP_UNITY_BUILD_INCLUSION ON COMPILE_DEFINITIONS "${paths}" OBJECT_DEPENDS "${ARGN}")
endfunction()

# The names and definitions of figures.
set(figures ${CMAKE_SOURCE_DIR}/lib/foundation/figures)
filum_embed(foundation/figures/meanings.cpp FILUM_FIGURES=${figures} ${figures}/meanings.tsv ${figures}/page.txt)

# The tables of slicers' settings.
set(settings ${CMAKE_SOURCE_DIR}/lib/motion/preset/settings.tsv)
set(cura ${CMAKE_SOURCE_DIR}/lib/motion/preset/cura.tsv)
filum_embed(motion/preset/table.cpp "FILUM_SETTINGS=${settings};FILUM_CURA=${cura}" ${settings} ${cura})

# The font of pictures, of Debian's fonts-dejavu-core.
find_file(FILUM_FONT DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu REQUIRED)
filum_embed(results/render/font.cpp FILUM_FONT=${FILUM_FONT} ${FILUM_FONT})

# What the report's page is made of: the files of lib/results/report/page, and three.js of Debian's libjs-three.
find_file(FILUM_THREE_JS three.min.js PATHS /usr/share/javascript/three /usr/share/nodejs/three/build NO_DEFAULT_PATH)
if(NOT FILUM_THREE_JS)
    message(FATAL_ERROR "cannot find three.min.js of the package libjs-three, which reports are drawn with; "
        "run scripts/setup, or name the file by -DFILUM_THREE_JS=FILE")
endif()
set(page ${CMAKE_SOURCE_DIR}/lib/results/report/page)
file(GLOB page_files CONFIGURE_DEPENDS ${page}/*)
filum_embed(results/report/assets.cpp "FILUM_PAGE=${page};FILUM_THREE_JS=${FILUM_THREE_JS}" ${page_files} ${FILUM_THREE_JS})
