# Beside the portable program and library, both once more for processors with AVX2, FMA, BMI and BMI2:
# the program in LIBEXECDIR/voroproof/avx2, to which the portable one hands over
# (apps/cli/variant.h), in the build directory, too, and the shared library where the dynamic linker looks for it on such
# processors (glibc-hwcaps).
include(ExternalProject)
include(GNUInstallDirs)

set(VOROPROOF_VARIANT_BUILD "" CACHE PATH "A finished build to install for newer processors; empty: make one")
if(VOROPROOF_VARIANT_BUILD)
  set(variant_dir ${VOROPROOF_VARIANT_BUILD})
else()
  set(variant_dir ${CMAKE_BINARY_DIR}/variant-avx2)
  ExternalProject_Add(variant_avx2
    SOURCE_DIR ${CMAKE_SOURCE_DIR}
    BINARY_DIR ${variant_dir}
    PREFIX ${CMAKE_BINARY_DIR}/variant-avx2-steps
    CMAKE_ARGS
      -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
      -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -DCMAKE_CXX_FLAGS=-mavx2\ -mfma\ -mbmi\ -mbmi2
      -DVOROPROOF_WERROR=${VOROPROOF_WERROR}
      -DVOROPROOF_VARIANTS=OFF
      -DVOROPROOF_PYTHON=OFF
      -DVOROPROOF_TESTS=OFF
      -DVOROPROOF_BENCH=OFF
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target voroproof voroproof_shared
    BUILD_ALWAYS ON
    INSTALL_COMMAND "")
endif()

set(VOROPROOF_VARIANT_DIR ${CMAKE_INSTALL_LIBEXECDIR}/voroproof/avx2)
install(PROGRAMS ${variant_dir}/voroproof DESTINATION ${VOROPROOF_VARIANT_DIR})
set(soname libvoroproof.so.${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
install(PROGRAMS ${variant_dir}/library/libvoroproof.so.${PROJECT_VERSION} RENAME ${soname}
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/x86-64-v3)
