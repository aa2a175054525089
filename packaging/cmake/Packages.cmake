# What is installed besides program and library, and the archive that `cpack` makes of all of it. The Debian
# packages are made of the same files, by packaging/debian/ (docs/install.md).
include(GNUInstallDirs)

install(DIRECTORY packaging/schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/voroproof)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN Doxyfile EXCLUDE PATTERN site EXCLUDE)

set(CPACK_GENERATOR TGZ)
set(CPACK_PACKAGE_VENDOR "The voroproof maintainers")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
string(TOLOWER "${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}" system)
set(CPACK_PACKAGE_FILE_NAME voroproof-${PROJECT_VERSION}-${system})
include(CPack)
