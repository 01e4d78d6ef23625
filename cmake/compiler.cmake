# Compile flags that all our targets share.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(temblor_flags INTERFACE)
target_include_directories(temblor_flags INTERFACE "${CMAKE_SOURCE_DIR}/src")
# Every machine must draw the same frame, so the compiler may not fuse multiplications and additions.
target_compile_options(temblor_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion)
# Tests may have another compiler than the rest of the tree, so these conditions are evaluated for each target.
set(gnu "$<CXX_COMPILER_ID:GNU>")
target_compile_options(temblor_flags INTERFACE "$<$<NOT:${gnu}>:-Wno-sign-conversion>")
# g++ 12 warns of overlapping copies in correct assignments to std::string (gcc bug 105329).
target_compile_options(temblor_flags INTERFACE "$<$<AND:${gnu},$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>")
cmake_host_system_information(RESULT memory_mb QUERY TOTAL_PHYSICAL_MEMORY)
if(memory_mb GREATER 7000)
  # Below 1 GB (the number is in KB), g++ need not look for memory to free, which takes 8% to 18% of its time.
  target_compile_options(temblor_flags INTERFACE "$<${gnu}:SHELL:--param ggc-min-heapsize=1000000>")
endif()
if(TEMBLOR_WARNINGS_ARE_ERRORS)
  target_compile_options(temblor_flags INTERFACE -Werror)
endif()
if(TEMBLOR_SANITIZE)
  target_compile_options(temblor_flags INTERFACE -fsanitize=${TEMBLOR_SANITIZE} -fno-omit-frame-pointer
                                                 -fno-sanitize-recover=all)
  target_link_options(temblor_flags INTERFACE -fsanitize=${TEMBLOR_SANITIZE})
  if(TEMBLOR_SANITIZE MATCHES "undefined")
    # These checks of every pointer take half of the compile time, and the address sanitizer sees most of what they see.
    target_compile_options(temblor_flags INTERFACE -fno-sanitize=null,alignment,object-size,vptr)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With sanitizers, g++ 12 wrongly warns of uninitialized values inside <regex> and <variant>.
    target_compile_options(temblor_flags INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()

# temblor_kernel_flags(TARGET), after its sources are known: flags of the kernel sources, *_simd.cpp, in sanitizer builds. clang 16
# takes minutes to optimize Highway's code with inline checks of the address sanitizer, and seconds with checks that are
# function calls. Without optimization, the tests that draw would take ten times as long.
function(temblor_kernel_flags target)
  if(NOT TEMBLOR_SANITIZE MATCHES "address" OR NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "_simd\\.cpp$")
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS
                              "-fno-sanitize=undefined,fuzzer-no-link;-mllvm;-asan-instrumentation-with-call-threshold=0"
                              SKIP_PRECOMPILE_HEADERS ON)
endfunction()
