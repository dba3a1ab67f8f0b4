# SPDX-License-Identifier: GPL-3.0-or-later
# What scripts/package makes of the plugins for desktop MeshLabs:
#   component <host>               what the zip for the host has in it
#   target debian-package-<host>   a Debian package; only for the MeshLab that this machine's distribution packages
# The same bits in every folder and at any time, where SOURCE_DATE_EPOCH is set.

set(files ${PROJECT_BINARY_DIR}/packaging)
set(sources ${PROJECT_SOURCE_DIR}/packaging)

# What scripts/package has had written for meshlabserver, which only hosts of this plugin interface have.
function(_curvdecim_examples host folder component)
  if(CURVDECIM_API_${host} STREQUAL "2020")
    install(DIRECTORY ${files}/examples DESTINATION ${folder} COMPONENT ${component} EXCLUDE_FROM_ALL OPTIONAL)
  endif()
endfunction()

# The folders in the zip are those of build/, for install-plugin.
function(_curvdecim_zip host version)
  configure_file(${sources}/INSTALL-${CURVDECIM_API_${host}}.txt.in ${files}/${host}/INSTALL.txt @ONLY)
  install(TARGETS plugin-${host} LIBRARY DESTINATION plugins/${host} COMPONENT ${host} EXCLUDE_FROM_ALL)
  install(FILES ${files}/${host}/INSTALL.txt ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION . COMPONENT ${host}
          EXCLUDE_FROM_ALL)
  install(PROGRAMS ${PROJECT_SOURCE_DIR}/scripts/install-plugin DESTINATION . COMPONENT ${host} EXCLUDE_FROM_ALL)
  _curvdecim_examples(${host} . ${host})
endfunction()

# What Debian wants beside the plugin: its changelog and its copyright.
function(_curvdecim_debian_documents)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # SOURCE_DATE_EPOCH, where it is set
  configure_file(${sources}/debian/changelog.in ${files}/debian/changelog @ONLY)
  execute_process(COMMAND gzip -9 --no-name --stdout ${files}/debian/changelog
                  OUTPUT_FILE ${files}/debian/changelog.Debian.gz COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${files}/debian/changelog.Debian.gz ${sources}/debian/copyright
          DESTINATION share/doc/${CPACK_DEBIAN_DEBIAN_PACKAGE_NAME} COMPONENT debian EXCLUDE_FROM_ALL)
endfunction()

# library: the packaged libmeshlab-common of this version
function(_curvdecim_debian_package host version library)
  set(CPACK_PACKAGE_CONTACT "CurvDecim maintainers <maintainers@curvdecim.invalid>" CACHE STRING
      "Name and address in the Debian package")
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "filters for MeshLab that simplify a mesh and keep what is curved")
  set(CPACK_COMPONENT_DEBIAN_DESCRIPTION
"Edge collapse by quadrics weighted by curvature, edge collapse by algebraic
spheres, vertex removal, vertex clustering, and a filter that shows
beforehand what a setting protects. For MeshLab and meshlabserver.")
  set(CPACK_COMPONENTS_ALL debian)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_DEBIAN_DEBIAN_PACKAGE_NAME meshlab-plugin-curvdecim)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
  set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
  get_filename_component(folder ${library} DIRECTORY)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${folder})
  # Any packaging of this version, as 2020.09+dfsg1-2, and no later version.
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "meshlab (>= ${version}), meshlab (<< ${version}.~)")

  _curvdecim_debian_documents()
  _curvdecim_examples(${host} share/doc/${CPACK_DEBIAN_DEBIAN_PACKAGE_NAME} debian)
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY /usr)
  install(TARGETS plugin-${host} LIBRARY DESTINATION ${folder}/plugins COMPONENT debian EXCLUDE_FROM_ALL)
  include(CPack)
  add_custom_target(debian-package-${host}
    COMMAND ${CMAKE_CPACK_COMMAND} -G DEB -B ${files}/debian
    DEPENDS plugin-${host}
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
    VERBATIM)
endfunction()

foreach(host IN LISTS CURVDECIM_HOSTS)
  if(NOT host MATCHES "^meshlab-(.+)$" OR NOT TARGET plugin-${host})
    continue()
  endif()
  set(version ${CMAKE_MATCH_1})
  _curvdecim_zip(${host} ${version})
  _curvdecim_find_meshlab_library(meshlab ${version} library)
  if(library AND EXISTS /etc/debian_version)
    _curvdecim_debian_package(${host} ${version} ${library})
  endif()
endforeach()
