# temblor_use_test_compiler(): in a g++ tree, the targets of this folder are compiled and linked with the clang that
# TEMBLOR_TEST_COMPILER names, if it is installed. It takes three quarters of the time that g++ takes for all tests. Both
# compilers use the same standard library, and a test program links our libraries as g++ compiled them.
#
# CMake knows one compiler for each language. But it looks up the compiler's path and flags in the folder of a target, so
# a folder can have its own.
macro(temblor_use_test_compiler)
  if(TEMBLOR_TEST_COMPILER AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT TEMBLOR_SANITIZE)
    find_program(test_compiler NAMES "${TEMBLOR_TEST_COMPILER}" NO_CACHE)
    if(test_compiler)
      set(CMAKE_CXX_COMPILER "${test_compiler}")
      set(CMAKE_CXX_COMPILER_ID Clang)
      set(CMAKE_CXX_COMPILER_FRONTEND_VARIANT GNU)
      execute_process(COMMAND "${test_compiler}" -dumpversion OUTPUT_VARIABLE CMAKE_CXX_COMPILER_VERSION
                      OUTPUT_STRIP_TRAILING_WHITESPACE)
      include(Compiler/Clang-CXX)
      find_program(TEMBLOR_MOLD mold)
      if(TEMBLOR_MOLD)
        # The linker keeps the first copy of an inline function. Our libraries come first, because theirs are optimized.
        # Other linkers than mold would not find functions of a library that comes before its callers.
        set(CMAKE_CXX_LINK_EXECUTABLE
            "<CMAKE_CXX_COMPILER> <FLAGS> <CMAKE_CXX_LINK_FLAGS> <LINK_FLAGS> <LINK_LIBRARIES> <OBJECTS> -o <TARGET>")
      endif()
    endif()
  endif()
endmacro()
