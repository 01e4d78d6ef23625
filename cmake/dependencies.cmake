# Libraries that we use, all of them Debian 12 packages. docs/architecture.md lists them.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(libjpeg REQUIRED IMPORTED_TARGET libjpeg)
pkg_check_modules(spng REQUIRED IMPORTED_TARGET spng)
pkg_check_modules(sdl2 REQUIRED IMPORTED_TARGET sdl2)
# Removes -D_REENTRANT, which has no effect in today's C libraries and would rule out the precompiled headers.
set_target_properties(PkgConfig::sdl2 PROPERTIES INTERFACE_COMPILE_OPTIONS "")
# Times of Wayland's events, which SDL 2 leaves out; SDL itself uses the same library.
pkg_check_modules(wayland REQUIRED IMPORTED_TARGET wayland-client)
# Pictures in X11 windows.
pkg_check_modules(xcb REQUIRED IMPORTED_TARGET xcb xcb-present xcb-shm)
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
  # Only Highway's target with one lane, for which the kernel sources call their scalar reference.
  target_compile_definitions(temblor_flags INTERFACE HWY_COMPILE_ONLY_SCALAR)
elseif(TEMBLOR_TWO_VECTOR_TARGETS)
  # Disables SSSE3, SSE4, AVX3 and AVX3_DL of x86. A sanitizer makes every further target expensive to compile.
  target_compile_definitions(temblor_flags INTERFACE HWY_DISABLED_TARGETS=0x1980)
endif()

# Debian 12 has Embree 3 and later systems have 4; src/rays/embree.h supports both.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
# The program loads the library at run time, when it first needs it, so only its headers are used here.
add_library(temblor_embree INTERFACE)
target_include_directories(temblor_embree SYSTEM INTERFACE $<TARGET_PROPERTY:embree,INTERFACE_INCLUDE_DIRECTORIES>)
target_link_libraries(temblor_embree INTERFACE ${CMAKE_DL_LIBS})
set(TEMBLOR_EMBREE_TARGET temblor_embree)

# Assembles code for x86-64 in one technique of the laboratory, which is left out without it.
set(TEMBLOR_ASMJIT_TARGET "")
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  find_package(asmjit QUIET)
  if(asmjit_FOUND)
    set(TEMBLOR_ASMJIT_TARGET asmjit::asmjit)
  endif()
endif()
