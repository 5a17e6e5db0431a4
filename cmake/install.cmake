# `cmake --install`: the library, its headers, and the files by which find_package(carom) finds them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/carom)

install(TARGETS carom EXPORT carom)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/carom DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

install(EXPORT carom NAMESPACE carom:: FILE carom-targets.cmake DESTINATION ${package_dir})
configure_file(cmake/carom-config.cmake.in carom-config.cmake @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/carom-config.cmake DESTINATION ${package_dir})
write_basic_package_version_file(carom-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/carom-config-version.cmake DESTINATION ${package_dir})

if(TARGET carom_cli)
    install(TARGETS carom_cli)
endif()
