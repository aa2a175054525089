# Manual pages and completions, of what the program says of itself (scripts/manual.py).
include(GNUInstallDirs)
find_package(Python3 COMPONENTS Interpreter)
install(FILES certify/kernel/voroproof-kernel.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
if(NOT Python3_FOUND)
  message(STATUS "No Python: no manual pages and no completions")
  return()
endif()

set(manual ${CMAKE_BINARY_DIR}/manual)
set(manual_script ${CMAKE_SOURCE_DIR}/scripts/manual.py)
add_custom_command(OUTPUT ${manual}/help.json
  COMMAND ${CMAKE_COMMAND} -E make_directory ${manual}
  COMMAND voroproof help --json > ${manual}/help.json
  COMMAND ${Python3_EXECUTABLE} -B ${manual_script} ${manual}/help.json ${manual}
  DEPENDS voroproof ${manual_script}
  VERBATIM)
add_custom_target(voroproof_manual ALL DEPENDS ${manual}/help.json)
install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} OPTIONAL)
install(FILES ${manual}/bash/voroproof DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions OPTIONAL)
install(FILES ${manual}/zsh/_voroproof DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions OPTIONAL)
install(FILES ${manual}/fish/voroproof.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d OPTIONAL)
