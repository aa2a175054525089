# The kernel of certify/kernel/ as a WebAssembly module: for the page of apps/certifier/ the script KERNEL_MODULE, packed by
# gzip, in base64; and NPM_PACKAGE, a package for Node.js and browsers. Both are empty where what makes them is not there.
set(KERNEL_MODULE "" CACHE INTERNAL "")
set(NPM_PACKAGE "" CACHE INTERNAL "")
find_program(VOROPROOF_EMXX em++)
if(NOT VOROPROOF_EMXX)
  message(STATUS "Page of the certifier: left out, no Emscripten (scripts/install-deps.sh browser)")
  return()
endif()
set(module_dir ${CMAKE_BINARY_DIR}/module)
# Headers alone of what this machine has.
find_path(JSON_INCLUDE nlohmann/json.hpp REQUIRED)
file(MAKE_DIRECTORY ${module_dir}/include)
file(CREATE_LINK ${Boost_INCLUDE_DIRS}/boost ${module_dir}/include/boost SYMBOLIC)
file(CREATE_LINK ${JSON_INCLUDE}/nlohmann ${module_dir}/include/nlohmann SYMBOLIC)
# Debian's Emscripten asks for scripts that a Node.js other than Debian's does not look for there.
set(em++ ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs ${VOROPROOF_EMXX} -O3 -fwasm-exceptions)

get_target_property(sources voroproof_kernel SOURCES)
list(TRANSFORM sources PREPEND certify/kernel/)
file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/certify/kernel/*.h)
foreach(source IN LISTS sources ITEMS apps/certifier/module.cpp)
  get_filename_component(name ${source} NAME_WE)
  add_custom_command(OUTPUT ${module_dir}/${name}.o
    COMMAND ${em++} -std=c++20 -DNDEBUG -ffile-prefix-map=${CMAKE_BINARY_DIR}=. -I${CMAKE_SOURCE_DIR} -isystem ${module_dir}/include
      -c ${CMAKE_SOURCE_DIR}/${source} -o ${module_dir}/${name}.o
    DEPENDS ${CMAKE_SOURCE_DIR}/${source} ${headers} VERBATIM)
  list(APPEND objects ${module_dir}/${name}.o)
endforeach()
set(KERNEL_MODULE ${module_dir}/kernel-module.js CACHE INTERNAL "")
add_custom_command(OUTPUT ${KERNEL_MODULE}
  COMMAND ${em++} ${objects} --no-entry -Wl,--stack-first -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=4GB
    -sWARN_ON_UNDEFINED_SYMBOLS=0 -sERROR_ON_UNDEFINED_SYMBOLS=0 -o ${module_dir}/kernel.wasm
  COMMAND sh -c "printf 'const KERNEL_MODULE = \"%s\";\\n' $(gzip -n9 < kernel.wasm | base64 -w0) > kernel-module.js"
  DEPENDS ${objects} WORKING_DIRECTORY ${module_dir} VERBATIM)

find_program(VOROPROOF_NPM npm)
if(NOT VOROPROOF_NPM)
  return()
endif()
set(npm_dir ${CMAKE_BINARY_DIR}/npm/voroproof-kernel)
set(npm_sources ${CMAKE_SOURCE_DIR}/packaging/npm)
set(page_dir ${CMAKE_SOURCE_DIR}/apps/certifier/page)
set(NPM_PACKAGE ${npm_dir}-${PROJECT_VERSION}.tgz CACHE INTERNAL "")
configure_file(${npm_sources}/package.json.in ${npm_dir}/package.json @ONLY)
set(npm_files ${npm_sources}/index.mjs ${npm_sources}/index.d.ts ${npm_sources}/README.md ${CMAKE_SOURCE_DIR}/certify/kernel/LICENSE)
add_custom_command(OUTPUT ${NPM_PACKAGE}
  COMMAND ${CMAKE_COMMAND} -E copy ${npm_files} ${module_dir}/kernel.wasm ${npm_dir}
  COMMAND sh -c "cat judge.js && echo 'export { judge };'" > ${npm_dir}/judge.mjs
  COMMAND ${VOROPROOF_NPM} pack --silent --pack-destination ${CMAKE_BINARY_DIR}/npm ${npm_dir} > ${npm_dir}.log
  DEPENDS ${KERNEL_MODULE} ${npm_files} ${npm_dir}/package.json ${page_dir}/judge.js WORKING_DIRECTORY ${page_dir} VERBATIM)
add_custom_target(npm ALL DEPENDS ${NPM_PACKAGE})
