# `find_package(pathrace)` offers the rooms as pathrace::core, pathrace::algorithms, ...
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/pathrace)
foreach(room core scenarios algorithms baselines results bench)
  install(TARGETS pathrace_${room} EXPORT pathraceTargets
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pathrace)
endforeach()
install(TARGETS pathrace_api EXPORT pathraceTargets
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})  # pathrace/pathrace.hpp
install(TARGETS pathrace)
install(EXPORT pathraceTargets NAMESPACE pathrace:: DESTINATION ${package_folder})
configure_package_config_file(cmake/pathraceConfig.cmake.in pathraceConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(pathraceConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pathraceConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/pathraceConfigVersion.cmake
        DESTINATION ${package_folder})
