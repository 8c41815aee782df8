# Every library is a Debian package; scripts/setup lists them.
find_program(CCACHE ccache)
if(CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

find_package(Threads REQUIRED)
find_package(Protobuf REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(Boost REQUIRED)
find_package(PNG REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)
pkg_check_modules(libzip REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(pugixml REQUIRED IMPORTED_TARGET pugixml)
find_package(ZLIB REQUIRED)
find_path(TOML_INCLUDE toml++/toml.h REQUIRED)
find_package(CGAL REQUIRED)
find_path(EMBREE_INCLUDE embree3/rtcore.h REQUIRED)
find_library(EMBREE_LIBRARY embree3 REQUIRED)
find_path(GLPK_INCLUDE glpk.h REQUIRED)
find_library(GLPK_LIBRARY glpk REQUIRED)
find_path(CHOLMOD_INCLUDE suitesparse/cholmod.h REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)

# What a folder of lib/ uses from outside; included in its .cpp files only, but for Eigen.
set(FILUM_USES_geom Eigen3::Eigen)
set(FILUM_USES_parallel TBB::tbb)
set(FILUM_USES_polygon PkgConfig::polyclipping)
set(FILUM_USES_mesh PkgConfig::libzip PkgConfig::pugixml)
set(FILUM_USES_sequence ${GLPK_LIBRARY})
set(FILUM_USES_fill Boost::headers Eigen3::Eigen)
set(FILUM_USES_link3d CGAL::CGAL)
set(FILUM_HIDES_surface CGAL::CGAL) # whose flags (-frounding-math) are for its own files only
set(FILUM_USES_geodesic Eigen3::Eigen ${CHOLMOD_LIBRARY})
<<<<<<< HEAD
set(FILUM_USES_stressfield Eigen3::Eigen PkgConfig::pugixml ZLIB::ZLIB)
=======
set(FILUM_USES_kipping2022 Eigen3::Eigen)
>>>>>>> kipping
set(FILUM_USES_stream filum_proto)
set(FILUM_USES_wire filum_proto)
set(FILUM_USES_render ${EMBREE_LIBRARY} PNG::PNG)
