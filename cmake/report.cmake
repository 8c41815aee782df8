# What the report's page is made of: the files of lib/results/report/page, and three.js of Debian's libjs-three.
find_file(FILUM_THREE_JS three.min.js PATHS /usr/share/javascript/three /usr/share/nodejs/three/build NO_DEFAULT_PATH)
if(NOT FILUM_THREE_JS)
    message(FATAL_ERROR "cannot find three.min.js of the package libjs-three, which reports are drawn with; "
        "run scripts/setup, or name the file by -DFILUM_THREE_JS=FILE")
endif()
set(page ${CMAKE_SOURCE_DIR}/lib/results/report/page)
file(GLOB page_files CONFIGURE_DEPENDS ${page}/*)
set_source_files_properties(lib/results/report/assets.cpp PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON
    COMPILE_DEFINITIONS "FILUM_PAGE=\"${page}\";FILUM_THREE_JS=\"${FILUM_THREE_JS}\""
    OBJECT_DEPENDS "${page_files};${FILUM_THREE_JS}")
