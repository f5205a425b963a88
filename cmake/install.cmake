include(CMakePackageConfigHelpers)

install(TARGETS bezcert bezcert_internal EXPORT bezcertTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS certify verifier RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/lib/bezcert DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp" PATTERN "flint_types.hpp" EXCLUDE)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bezcert)
install(EXPORT bezcertTargets NAMESPACE bezcert:: DESTINATION ${config_dir})
configure_package_config_file(cmake/bezcertConfig.cmake.in ${PROJECT_BINARY_DIR}/bezcertConfig.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bezcertConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bezcertConfig.cmake ${PROJECT_BINARY_DIR}/bezcertConfigVersion.cmake
  cmake/dependencies.cmake DESTINATION ${config_dir})
