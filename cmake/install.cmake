# `cmake --install`: the library, its headers, and the files by which find_package(carom) finds them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/carom)

install(TARGETS carom EXPORT carom)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/carom DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} PATTERN scene_file.hpp EXCLUDE)
if(TARGET carom_scene_file)
    install(TARGETS carom_scene_file EXPORT carom-scene_file)
    install(FILES ${PROJECT_SOURCE_DIR}/include/carom/scene_file.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/carom)
    install(EXPORT carom-scene_file NAMESPACE carom:: FILE carom-scene_file-targets.cmake DESTINATION ${package_dir})
endif()

install(EXPORT carom NAMESPACE carom:: FILE carom-targets.cmake DESTINATION ${package_dir})
configure_file(cmake/carom-config.cmake.in carom-config.cmake @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/carom-config.cmake DESTINATION ${package_dir})
write_basic_package_version_file(carom-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/carom-config-version.cmake DESTINATION ${package_dir})

if(TARGET carom_cli)
    install(TARGETS carom_cli)
endif()
