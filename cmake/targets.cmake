# The same source gives the same bits from g++ and clang, at -O0 and -O2.
set(carom_number_options -ffp-contract=off -fno-math-errno -fno-trapping-math)

# Compile options of all targets. Each links them PRIVATE, because programs that link carom choose their own warnings.
add_library(carom_compile_options INTERFACE)
target_compile_features(carom_compile_options INTERFACE cxx_std_20)
target_include_directories(carom_compile_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
target_compile_options(carom_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align
  -Woverloaded-virtual -Wconversion -Wno-sign-conversion -Werror
  $<$<CXX_COMPILER_ID:Clang>:-Wno-overloaded-shift-op-parentheses>  # how assertions take conditions apart
  # g++ 12 gives false warnings about inlined std::string (its bugs 105329 and 105651). With a precompiled header it does not
  # recognise the header as a system header.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds> $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread>
  ${carom_number_options})
option(CAROM_ASSERTIONS "cheap assertions in the program (CAROM_ASSERT)" OFF)
option(CAROM_VALIDATION "expensive assertions in the program (CAROM_VALIDATE)" OFF)
target_compile_definitions(carom_compile_options INTERFACE
  $<$<BOOL:${CAROM_ASSERTIONS}>:CAROM_ASSERTIONS>
  $<$<BOOL:${CAROM_VALIDATION}>:CAROM_VALIDATION>)

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# The layout of the build tree is that of an installed one: bin/, libexec/carom/, share/carom/.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

# Programs find modules that they load on demand (render/image_files/format_module.h) beside those in libexec/carom.
# g++'s sanitizers call dlopen from their own library, where the RUNPATH of the program does not count; the presets asan and tsan
# link with --disable-new-dtags, which writes an RPATH instead.
set(CMAKE_BUILD_RPATH ${PROJECT_BINARY_DIR}/libexec/carom)
set(CMAKE_INSTALL_RPATH "\$ORIGIN")

# Precompiled headers: a holder target compiles library headers that many files include, and other targets reuse the result.
# carom's own headers are not precompiled, because they change too often. CMake adds precompiled headers to every file of a
# target, so a missing #include is found only in a build with this option off.
option(CAROM_PRECOMPILED_HEADERS "parse the large headers of libraries once for many files" ON)

# Writes what ccache takes for the contents of a precompiled header, whose bytes differ from build to build: a hash of the text of
# all headers in it. (ccache itself looks at the compiler and its options.)
function(carom_identify_precompiled_headers holder headers libs)
  set(words -std=c++20 -E -P -x c++ -)
  foreach(lib ${libs})
    get_target_property(linked ${lib} INTERFACE_LINK_LIBRARIES)
    foreach(one ${lib} ${linked})
      if(TARGET ${one})
        get_target_property(folders ${one} INTERFACE_INCLUDE_DIRECTORIES)
        list(TRANSFORM folders PREPEND -I)
        list(PREPEND words ${folders})
      endif()
    endforeach()
  endforeach()
  list(TRANSFORM headers PREPEND "#include ")
  list(JOIN headers "\n" text)
  set(name ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${holder}.dir/cmake_pch.hxx)
  file(WRITE ${name}.in "${text}\n")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${words} COMMAND sha256sum INPUT_FILE ${name}.in OUTPUT_VARIABLE sum COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${name}.gch.sum "${sum}")
  file(WRITE ${name}.pch.sum "${sum}")
endfunction()

# carom_precompiled_headers(HOLDER HEADERS <a> <b> … [LIBS libs…] [EXECUTABLES]): makes the holder. EXECUTABLES: for the files
# of programs, which are compiled with -fPIE instead of -fPIC.
function(carom_precompiled_headers holder)
  cmake_parse_arguments(ARG "EXECUTABLES" "" "HEADERS;LIBS" ${ARGN})
  if(CAROM_PRECOMPILED_HEADERS)
    add_library(${holder} OBJECT ${PROJECT_SOURCE_DIR}/cmake/empty.cpp)
    target_link_libraries(${holder} PRIVATE carom_compile_options ${ARG_LIBS})
    target_precompile_headers(${holder} PRIVATE ${ARG_HEADERS})
    carom_identify_precompiled_headers(${holder} "${ARG_HEADERS}" "${ARG_LIBS}")
    target_compile_options(${holder} PRIVATE $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
    if(ARG_EXECUTABLES)
      set_target_properties(${holder} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
      target_compile_options(${holder} PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIE})
    endif()
  endif()
endfunction()

# ccache needs -fpch-preprocess to detect which precompiled header a file was compiled with.
function(carom_use_precompiled_headers target holder)
  if(CAROM_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${holder})
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endfunction()

# Precompiles the headers that most library files include, for the libraries of this folder and its subfolders.
macro(carom_precompile_for_libraries holder)
  carom_precompiled_headers(${holder}
    HEADERS <ImathMatrix.h> <ImathQuat.h> <algorithm> <cmath> <functional> <map> <optional> <sstream> <string> <variant> <vector>
    LIBS Imath::Imath)
  set(carom_headers_holder ${holder})
endmacro()

# carom_library(NAME SOURCES a.cpp … [PUBLIC libs…] [PRIVATE libs…] [PARSE_ALL]): makes a static library. PARSE_ALL: without
# precompiled headers, if a linked library needs its own compiler options (-pthread).
function(carom_library name)
  cmake_parse_arguments(ARG "PARSE_ALL" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE carom_compile_options PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  if(NOT ARG_PARSE_ALL)
    carom_use_precompiled_headers(${name} ${carom_headers_holder})
  endif()
endfunction()

# carom_program(NAME SOURCES a.cpp … LIBS libs…): makes a program.
function(carom_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE carom_compile_options ${ARG_LIBS})
endfunction()

# carom_test(NAME SOURCES a_test.cpp … LIBS libs… [TIMEOUT s] [SHARDS n]): makes a test program. CTest runs all its cases in one
# process, because starting a process with carom's libraries takes up to a quarter of a second, or in SHARDS processes, so that
# several cores share a long program. A case that takes longer than TIMEOUT ends the process (tests/test_main.cpp); with sanitizers
# than ten times of it.
function(carom_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT;SHARDS" "SOURCES;LIBS" ${ARGN})
  carom_program(${name} SOURCES ${ARG_SOURCES} LIBS ${ARG_LIBS} GTest::gmock carom_test_main)
  carom_use_precompiled_headers(${name} carom_test_headers)
  # Test code takes long to optimise and runs only once.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")  # programs are up to ten times slower
    math(EXPR ARG_TIMEOUT "10 * ${ARG_TIMEOUT}")
  endif()
  if(NOT ARG_SHARDS)
    set(ARG_SHARDS 1)
  endif()
  foreach(shard RANGE 1 ${ARG_SHARDS})
    set(test ${name})
    if(ARG_SHARDS GREATER 1)
      string(APPEND test _${shard}_of_${ARG_SHARDS})
    endif()
    math(EXPR index "${shard} - 1")
    add_test(NAME ${test} COMMAND ${name})
    set_tests_properties(${test} PROPERTIES
      ENVIRONMENT "CAROM_CASE_TIMEOUT=${ARG_TIMEOUT};GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${index}"
      TIMEOUT 7200)
  endforeach()
endfunction()
