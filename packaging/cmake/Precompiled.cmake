# Headers that most files include, compiled once for the libraries, once for the tests and once for
# the program: a third of the time of a build was reading them, half of one without optimization.
# Every file still includes what it uses; the builds that are made without this see to it
# (CONTRIBUTING.md).
#
# FLINT's headers are not among them: they define macros (MAX) that are names elsewhere.
#
# Files can share what was compiled for them only with the same options. Libraries are
# position-independent code, programs are position-independent executables.
set(voroproof_common_headers
  <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <filesystem> <fstream> <functional> <iostream> <map>
  <memory> <mutex> <optional> <random> <set> <sstream> <stdexcept> <string> <string_view> <thread> <unordered_map>
  <utility> <variant> <vector> <gmpxx.h> <mpfr.h>)

# voroproof_precompiled(KIND flags headers...)
function(voroproof_precompiled kind flags)
  file(WRITE ${CMAKE_BINARY_DIR}/precompiled/${kind}.cpp "")
  add_library(voroproof_precompiled_${kind} OBJECT ${CMAKE_BINARY_DIR}/precompiled/${kind}.cpp)
  target_link_libraries(voroproof_precompiled_${kind} PRIVATE voroproof_options PkgConfig::GMPXX PkgConfig::MPFR)
  target_precompile_headers(voroproof_precompiled_${kind} PRIVATE ${voroproof_common_headers} ${ARGN})
  if(flags)
    set_target_properties(voroproof_precompiled_${kind} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(voroproof_precompiled_${kind} PRIVATE ${flags})
  endif()
endfunction()

# Lets the target use them.
function(voroproof_use_precompiled target kind)
  if(VOROPROOF_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM voroproof_precompiled_${kind})
    # g++ 12 forgets that what it precompiled is the standard library's, and warns of string
    # concatenations in it (GCC bug 105651). The builds for distribution are made without.
    foreach(warning array-bounds stringop-overflow stringop-overread)
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-${warning}>)
    endforeach()
  endif()
endfunction()

if(VOROPROOF_PRECOMPILE)
  voroproof_precompiled(library "")
  voroproof_precompiled(program "-fPIE;$<$<CONFIG:Release>:-O1>")
endif()
