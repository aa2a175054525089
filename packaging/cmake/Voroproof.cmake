# Compiler settings and the external libraries, each found once.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# The rooms go into a shared library, too, which shows nothing but its own headers.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})

find_package(Threads REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(CGAL REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(GMPXX REQUIRED IMPORTED_TARGET gmpxx)
pkg_check_modules(MPFR REQUIRED IMPORTED_TARGET mpfr)
# Arb is a library of its own before FLINT 3 and a part of FLINT from there on.
find_path(ARB_INCLUDE arb.h PATH_SUFFIXES flint REQUIRED)
find_library(ARB_LIBRARY NAMES flint-arb arb)
find_library(FLINT_LIBRARY flint REQUIRED)
add_library(arb INTERFACE)
target_include_directories(arb SYSTEM INTERFACE ${ARB_INCLUDE})
target_link_libraries(arb INTERFACE
  $<$<BOOL:${ARB_LIBRARY}>:${ARB_LIBRARY}> ${FLINT_LIBRARY} PkgConfig::MPFR)
pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)
pkg_check_modules(ZLIB REQUIRED IMPORTED_TARGET zlib)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(EXPAT REQUIRED IMPORTED_TARGET expat)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
find_package(TBB REQUIRED)
pkg_check_modules(LEMON REQUIRED IMPORTED_TARGET lemon)

# The error bounds of filtered/ assume that every operation is rounded once, to
# nearest: no contraction to fused operations unless the source asks for one.
add_library(voroproof_options INTERFACE)
target_compile_options(voroproof_options INTERFACE
  -Wall -Wextra -ffp-contract=off -fno-fast-math
  $<$<BOOL:${VOROPROOF_WERROR}>:-Werror>
  $<$<BOOL:${VOROPROOF_NATIVE}>:-march=native>
  # g++ 12 sees overlapping copies in string concatenations (GCC bug 105651).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  # g++ 12 keeps wide registers over calls of functions that it knows not to touch them, and forgets
  # then to clear their upper halves, for which code without AVX pays later.
  $<$<CXX_COMPILER_ID:GNU>:-fno-ipa-ra>
  # How vectors of lanes are passed differs by processor; all of the project is made for one.
  -Wno-psabi)
if(VOROPROOF_LIBFUZZER)
  # What libFuzzer looks at, in all code; its main() only in the targets (tests/fuzz).
  target_compile_options(voroproof_options INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(voroproof_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(VOROPROOF_SANITIZE)
  target_compile_options(voroproof_options INTERFACE
    -fsanitize=${VOROPROOF_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(voroproof_options INTERFACE -fsanitize=${VOROPROOF_SANITIZE})
endif()

# voroproof_layer(NAME sources... USES layers and libraries...)
# A library of one room. Its headers are included as "room/header.h".
function(voroproof_layer name)
  cmake_parse_arguments(arg "" "" "USES" ${ARGN})
  add_library(voroproof_${name} STATIC ${arg_UNPARSED_ARGUMENTS})
  target_include_directories(voroproof_${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(voroproof_${name} PUBLIC ${arg_USES} PRIVATE voroproof_options)
  voroproof_use_precompiled(voroproof_${name} library)
endfunction()
