# What a stage of one's own in C++ is built with: headers and libraries of streams, options and data, and the package
# that find_package(Filum) finds.  `cmake --install build --component development --prefix DIR`; not part of `install`.
# examples/swap-a-stage/cpp is such a stage.
include(CMakePackageConfigHelpers)
set(rooms foundation/base foundation/geom foundation/parallel foundation/archive shapes/mesh shapes/polygon shapes/toolpath
    shapes/surface program/stream program/wire program/cli)
set(to lib/filum/cmake)
foreach(path IN LISTS rooms)
    get_filename_component(room ${path} NAME)
    set_target_properties(filum_${room} PROPERTIES EXPORT_NAME ${room})
    target_compile_features(filum_${room} PUBLIC cxx_std_20)
    install(TARGETS filum_${room} EXPORT Filum ARCHIVE DESTINATION lib/filum COMPONENT development EXCLUDE_FROM_ALL)
    install(DIRECTORY ${CMAKE_SOURCE_DIR}/lib/${path} DESTINATION include/filum COMPONENT development EXCLUDE_FROM_ALL
            FILES_MATCHING PATTERN "*.hpp" PATTERN "*.def")
endforeach()
set_target_properties(filum_proto PROPERTIES EXPORT_NAME proto)
install(TARGETS filum_proto EXPORT Filum ARCHIVE DESTINATION lib/filum COMPONENT development EXCLUDE_FROM_ALL)
install(EXPORT Filum NAMESPACE Filum:: FILE FilumTargets.cmake DESTINATION ${to} COMPONENT development EXCLUDE_FROM_ALL)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/FilumConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_SOURCE_DIR}/cmake/FilumConfig.cmake ${CMAKE_BINARY_DIR}/FilumConfigVersion.cmake DESTINATION ${to}
        COMPONENT development EXCLUDE_FROM_ALL)
