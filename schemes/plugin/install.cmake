# What is installed for authors of plugins (README.md): the library, its headers, and the package that
# find_package(kappabench) finds.
include(CMakePackageConfigHelpers)

install(TARGETS kappabench_library EXPORT kappabench LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(room schemes metrics datasets)
  install(
    DIRECTORY ${PROJECT_SOURCE_DIR}/${room}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kappabench
    FILES_MATCHING
    PATTERN "*.hpp")
endforeach()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/kappabench)
install(EXPORT kappabench NAMESPACE kappabench:: FILE kappabench-targets.cmake DESTINATION ${package})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/kappabench-config.cmake.in
                              ${PROJECT_BINARY_DIR}/kappabench-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kappabench-config-version.cmake COMPATIBILITY ExactVersion)
install(FILES ${PROJECT_BINARY_DIR}/kappabench-config.cmake ${PROJECT_BINARY_DIR}/kappabench-config-version.cmake
              ${CMAKE_CURRENT_LIST_DIR}/plugin_entry.cpp DESTINATION ${package})
