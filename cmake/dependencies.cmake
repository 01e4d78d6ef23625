# What we do not write ourselves (the table in docs/architecture.md); all Debian 12 packages.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
# Debian's libzip-config.cmake wants the command-line tools' package as well; pkg-config does not.
pkg_check_modules(libzip REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(spng REQUIRED IMPORTED_TARGET spng)
pkg_check_modules(sdl2 REQUIRED IMPORTED_TARGET sdl2)
# -D_REENTRANT, which means nothing to today's C libraries, would do without the precompiled headers.
set_target_properties(PkgConfig::sdl2 PROPERTIES INTERFACE_COMPILE_OPTIONS "")
pkg_check_modules(sndfile REQUIRED IMPORTED_TARGET sndfile)
pkg_check_modules(samplerate REQUIRED IMPORTED_TARGET samplerate)
pkg_check_modules(vorbisenc REQUIRED IMPORTED_TARGET vorbisenc vorbis ogg)

set(TEMBLOR_TBB_TARGET "")
if(TEMBLOR_ONETBB)
  find_package(TBB REQUIRED)
  set(TEMBLOR_TBB_TARGET TBB::tbb)
endif()

pkg_check_modules(highway REQUIRED IMPORTED_TARGET libhwy)
set(TEMBLOR_HIGHWAY_TARGET PkgConfig::highway)
if(TEMBLOR_SCALAR_ONLY)
  # Highway's one-lane target and no other: kernel files then call their plain twins.
  target_compile_definitions(temblor_flags INTERFACE HWY_COMPILE_ONLY_SCALAR)
endif()

# Debian 12 has Embree 3, later systems 4; src/compiler/light/rays/embree.h knows both.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
# The program opens the library itself, when it needs it.
add_library(temblor_embree INTERFACE)
target_include_directories(temblor_embree SYSTEM INTERFACE $<TARGET_PROPERTY:embree,INTERFACE_INCLUDE_DIRECTORIES>)
target_link_libraries(temblor_embree INTERFACE ${CMAKE_DL_LIBS})
set(TEMBLOR_EMBREE_TARGET temblor_embree)
