# Precompiled headers: what almost every file reads of the language and of libraries, parsed once a build. Every file
# names what it uses all the same: builds with clang (fuzz, lint) go without. Only g++ reads the headers of one target
# into others, which have further definitions.

# temblor_headers(NAME FLAGS [HEADER ...]): the common headers and HEADERs, compiled as the library FLAGS says.
function(temblor_headers name flags)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    return()
  endif()
  file(WRITE "${CMAKE_BINARY_DIR}/${name}.cpp" "")
  add_library(${name} OBJECT "${CMAKE_BINARY_DIR}/${name}.cpp")
  target_link_libraries(${name} PRIVATE ${flags} fmt::fmt glm::glm)
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

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(temblor_flags INTERFACE -fpch-preprocess)  # lets ccache know it
endif()
temblor_headers(temblor_common_headers temblor_flags)
