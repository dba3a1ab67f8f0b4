# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install <build>` installs, by component:
#   core     the headers, and what find_package(CurvDecim) reads
#   plugins  those that were built, in lib/curvdecim/<host>/; only if asked for by --component plugins
#   python   what goes into the wheel beside the Python files; only pip asks for it (pyproject.toml)

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_destination ${CMAKE_INSTALL_DATADIR}/cmake/CurvDecim)
set(package_files ${PROJECT_BINARY_DIR}/cmake-package)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/vcg_ext DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT core
        FILES_MATCHING PATTERN "*.h")

set_target_properties(curvdecim_core PROPERTIES EXPORT_NAME core)
install(TARGETS curvdecim_core EXPORT CurvDecimTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT CurvDecimTargets NAMESPACE CurvDecim:: DESTINATION ${package_destination} COMPONENT core)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/CurvDecimConfig.cmake.in
                              ${package_files}/CurvDecimConfig.cmake
                              INSTALL_DESTINATION ${package_destination}
                              NO_SET_AND_CHECK_MACRO)
# Headers only: the same for every machine.
write_basic_package_version_file(${package_files}/CurvDecimConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${package_files}/CurvDecimConfig.cmake ${package_files}/CurvDecimConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/CurvDecimVcglib.cmake
        DESTINATION ${package_destination} COMPONENT core)
