# Every library is a Debian package; scripts/setup lists them.
find_program(CCACHE ccache)
if(CCACHE)
    # Paths in objects are relative, so that clones and worktrees share them.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=true
                                    ${CCACHE})
endif()

find_package(Threads REQUIRED)
set(Protobuf_USE_STATIC_LIBS ON) # a command starts a fifth sooner
find_package(Protobuf REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(Boost REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo freetype2)
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)
pkg_check_modules(libzip REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(re2 REQUIRED IMPORTED_TARGET re2)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET muparser)
pkg_check_modules(libmd REQUIRED IMPORTED_TARGET libmd)
pkg_check_modules(pugixml REQUIRED IMPORTED_TARGET pugixml)
pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET nlopt)
pkg_check_modules(jemalloc IMPORTED_TARGET jemalloc) # optional, see FILUM_ALLOCATES
find_path(LIBNEST2D_INCLUDE libnest2d/libnest2d.hpp REQUIRED)
find_package(ZLIB REQUIRED)
find_path(TOML_INCLUDE toml.hpp REQUIRED)
find_package(CGAL REQUIRED)
find_path(EMBREE_INCLUDE NAMES embree4/rtcore.h embree3/rtcore.h REQUIRED) # 4: Debian 13
find_library(EMBREE_LIBRARY NAMES embree4 embree3 REQUIRED)
find_path(GLPK_INCLUDE glpk.h REQUIRED)
find_library(GLPK_LIBRARY glpk REQUIRED)
find_path(CHOLMOD_INCLUDE suitesparse/cholmod.h REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)

# Programs that allocate many small lists in offsets and Boolean operations: with jemalloc skins takes 14 %, fill and
# supports 5 %, regions 4 % less CPU time; slice and link3d take 5 % more. Sanitizers have an allocator of their own.
set(FILUM_ALLOCATES regions skins fill supports)

# What a folder of lib/ uses from outside; included in its .cpp files only, but for Eigen.
set(FILUM_USES_geom Eigen3::Eigen)
set(FILUM_USES_kinematics Eigen3::Eigen)
set(FILUM_USES_parallel TBB::tbb)
set(FILUM_USES_polygon PkgConfig::polyclipping)
set(FILUM_USES_macro PkgConfig::re2)
set(FILUM_USES_archive PkgConfig::libzip PkgConfig::libmd PkgConfig::pugixml)
set(FILUM_USES_bgcode ZLIB::ZLIB)
set(FILUM_USES_mesh PkgConfig::pugixml)
set(FILUM_USES_machine PkgConfig::pugixml)
set(FILUM_USES_sequence ${GLPK_LIBRARY})
set(FILUM_USES_fill_scaffold PkgConfig::muparser)
set(FILUM_USES_fill_rings Boost::headers)
set(FILUM_USES_link3d CGAL::CGAL)
set(FILUM_HIDES_surface CGAL::CGAL) # whose flags (-frounding-math) are for its own files only
set(FILUM_USES_sparse Eigen3::Eigen ${CHOLMOD_LIBRARY} gomp) # gomp: the OpenMP that CHOLMOD runs on, part of g++
set(FILUM_USES_geodesic Eigen3::Eigen)
set(FILUM_USES_stressfield Eigen3::Eigen PkgConfig::pugixml ZLIB::ZLIB)
set(FILUM_USES_partition Eigen3::Eigen)
set(FILUM_USES_surface_directions Eigen3::Eigen)
set(FILUM_USES_surfpath_field Eigen3::Eigen)
set(FILUM_USES_baselines_kipping2022 Eigen3::Eigen)
set(FILUM_USES_stream filum_proto)
set(FILUM_USES_wire filum_proto)
set(FILUM_HIDES_plate PkgConfig::polyclipping PkgConfig::nlopt)
set_source_files_properties(${CMAKE_SOURCE_DIR}/lib/planar/plate/nest.cpp PROPERTIES
    COMPILE_OPTIONS "-std=c++17;-DBOOST_ALLOW_DEPRECATED_HEADERS")
# The file that replaces functions of libm; a compiler that knows those functions would call them in it.
set_source_files_properties(${CMAKE_SOURCE_DIR}/lib/foundation/base/libm.cpp PROPERTIES
    COMPILE_OPTIONS "-fno-builtin" SKIP_UNITY_BUILD_INCLUSION ON)
set(FILUM_USES_report ZLIB::ZLIB)
set(FILUM_USES_render ${EMBREE_LIBRARY} PkgConfig::cairo)
