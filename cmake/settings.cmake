# The table of slicers' settings, which is put into the program.
set(table ${CMAKE_SOURCE_DIR}/lib/motion/preset/settings.tsv)
set_source_files_properties(lib/motion/preset/table.cpp PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON
    COMPILE_DEFINITIONS "FILUM_SETTINGS=\"${table}\""
    OBJECT_DEPENDS "${table}")
