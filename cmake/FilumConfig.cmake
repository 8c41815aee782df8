# find_package(Filum): libraries Filum::cli (options, shapes of programs), Filum::wire (messages to data) and those that
# these use.  All libraries from outside are packages of Debian, as in scripts/setup.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
set(Protobuf_USE_STATIC_LIBS ON)
find_dependency(Protobuf)
find_dependency(Eigen3 NO_MODULE)
find_dependency(TBB)
find_dependency(CGAL)
find_dependency(PkgConfig)
foreach(name IN ITEMS polyclipping libzip libmd pugixml)
    pkg_check_modules(${name} REQUIRED IMPORTED_TARGET ${name})
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/FilumTargets.cmake)
