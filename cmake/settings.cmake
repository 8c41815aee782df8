# The table of slicers' settings, which is put into the program.
set(table ${CMAKE_SOURCE_DIR}/lib/program/app/filum/settings.tsv)
set_source_files_properties(lib/program/app/filum/slicer_table.cpp PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON
    COMPILE_DEFINITIONS "FILUM_SETTINGS=\"${table}\""
    OBJECT_DEPENDS "${table}")

# The types of slicers' settings, lib/motion/preset/keys.tsv, likewise.
set(keys ${CMAKE_SOURCE_DIR}/lib/motion/preset/keys.tsv)
set_source_files_properties(lib/motion/preset/table.cpp PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON
    COMPILE_DEFINITIONS "FILUM_PRESET_KEYS=\"${keys}\""
    OBJECT_DEPENDS "${keys}")
