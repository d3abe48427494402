# What a host finds: the shared library, its one header, a CMake package and a pkg-config file. Eigen, OpenMP and
# SuiteSparse are private to the library, so none of them has to be installed where it is used.
if(NOT TARGET bempd)
  return()
endif()
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/bempd")
set(generated_dir "${PROJECT_BINARY_DIR}/package")

install(TARGETS bempd EXPORT bempdTargets
        LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime NAMELINK_COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/include/bempd.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        COMPONENT development)
install(EXPORT bempdTargets NAMESPACE bempd:: DESTINATION "${package_dir}" COMPONENT development)

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/bempdConfig.cmake.in" "${generated_dir}/bempdConfig.cmake"
                              INSTALL_DESTINATION "${package_dir}")
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file("${generated_dir}/bempdConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${generated_dir}/bempdConfig.cmake" "${generated_dir}/bempdConfigVersion.cmake"
        DESTINATION "${package_dir}" COMPONENT development)

# The prefix is found from the file itself, so that the installed tree can be moved.
function(bempd_pkgconfig_path result dir)
  if(IS_ABSOLUTE "${dir}")
    set(${result} "${dir}" PARENT_SCOPE)
  else()
    set(${result} "\${prefix}/${dir}" PARENT_SCOPE)
  endif()
endfunction()
bempd_pkgconfig_path(pc_libdir "${CMAKE_INSTALL_LIBDIR}")
bempd_pkgconfig_path(pc_includedir "${CMAKE_INSTALL_INCLUDEDIR}")
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(pc_prefix "${CMAKE_INSTALL_PREFIX}")
else()
  file(RELATIVE_PATH pc_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  string(REGEX REPLACE "/$" "" pc_prefix "\${pcfiledir}/${pc_prefix}")
endif()
configure_file("${PROJECT_SOURCE_DIR}/cmake/bempd.pc.in" "${generated_dir}/bempd.pc" @ONLY)
install(FILES "${generated_dir}/bempd.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
