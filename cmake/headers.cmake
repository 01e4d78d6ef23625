# Precompiled headers: the parts of the standard library, fmt, and glm that almost every file includes, parsed once for each
# build tree. Every file still includes what it uses (`make lint` compiles without precompiled headers). Targets reuse the
# header of another target although they have more definitions; g++ and clang both accept that.

# temblor_headers(NAME FLAGS [HEADER ...]): compiles the common headers and HEADERs with the flags of the library FLAGS.
function(temblor_headers name flags)
  file(WRITE "${CMAKE_BINARY_DIR}/${name}.cpp" "")
  add_library(${name} OBJECT "${CMAKE_BINARY_DIR}/${name}.cpp")
  # temblor_flags come first, as in the targets that use the header, because ${flags} may turn some of them off.
  target_link_libraries(${name} PRIVATE temblor_flags ${flags} fmt::fmt glm::glm)
  target_precompile_headers(
    ${name} PRIVATE
    <algorithm> <array> <bit> <charconv> <cmath> <cstddef> <cstdint> <cstring> <functional> <limits> <map> <memory>
    <numbers> <optional> <set> <span> <string> <string_view> <utility> <variant> <vector> <fmt/format.h> <glm/glm.hpp>
    ${ARGN})
endfunction()

function(temblor_use_headers target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()

# Both options let ccache work with precompiled headers.
target_compile_options(temblor_flags INTERFACE "$<IF:${gnu},-fpch-preprocess,SHELL:-Xclang -fno-pch-timestamp>")
temblor_headers(temblor_common_headers temblor_flags)

# temblor_is_cold(TARGET): gives a target its flags and the precompiled header. Tests spend little time in a cold target, so
# the sanitizer tree does not optimize it, which compiles it in half of the time. No fuzz target may call it: it has no
# coverage counters there.
function(temblor_is_cold target)
  if(NOT TEMBLOR_SANITIZE MATCHES "fuzzer")
    temblor_use_headers(${target} temblor_common_headers)
    return()
  endif()
  if(NOT TARGET temblor_cold_flags)
    add_library(temblor_cold_flags INTERFACE)
    target_compile_options(temblor_cold_flags INTERFACE -O0 -fno-sanitize=fuzzer-no-link)
    temblor_headers(temblor_cold_headers temblor_cold_flags)
  endif()
  target_link_libraries(${target} PRIVATE temblor_cold_flags)
  temblor_use_headers(${target} temblor_cold_headers)
endfunction()
