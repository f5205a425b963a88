include(CMakePackageConfigHelpers)

install(TARGETS bezcert EXPORT bezcertTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS certify verifier RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bezcert)
install(EXPORT bezcertTargets NAMESPACE bezcert:: DESTINATION ${config_dir})
configure_package_config_file(cmake/bezcertConfig.cmake.in ${PROJECT_BINARY_DIR}/bezcertConfig.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bezcertConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bezcertConfig.cmake ${PROJECT_BINARY_DIR}/bezcertConfigVersion.cmake
  cmake/dependencies.cmake DESTINATION ${config_dir})
