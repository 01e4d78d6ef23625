# Flags that every target of ours shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(temblor_flags INTERFACE)
target_include_directories(temblor_flags INTERFACE "${CMAKE_SOURCE_DIR}/src")
# A frame must be the same on every machine: no fused multiply-add behind our back.
target_compile_options(temblor_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(temblor_flags INTERFACE -Wno-sign-conversion)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 sees overlapping copies in plain assignments to std::string where there are none (gcc bug 105329).
  target_compile_options(temblor_flags INTERFACE -Wno-restrict)
endif()
if(TEMBLOR_WARNINGS_ARE_ERRORS)
  target_compile_options(temblor_flags INTERFACE -Werror)
endif()
if(TEMBLOR_SANITIZE)
  target_compile_options(temblor_flags INTERFACE -fsanitize=${TEMBLOR_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=all)
  target_link_options(temblor_flags INTERFACE -fsanitize=${TEMBLOR_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With sanitizers g++ 12 sees uninitialized values inside <regex> and <variant> that are none.
    target_compile_options(temblor_flags INTERFACE -Wno-maybe-uninitialized)
    if(TEMBLOR_SANITIZE MATCHES "undefined")
      # With g++ these checks of every pointer are half of the time to compile, and the address sanitizer sees most of
      # what they see; the fuzz preset, with clang, has them all.
      target_compile_options(temblor_flags INTERFACE -fno-sanitize=null,alignment,object-size,vptr)
    endif()
  endif()
endif()
