# What a host finds: the shared library, its header, that for C++17 beside it, a CMake package and a pkg-config file. Eigen, LAPACK and
# SuiteSparse are private to the library, so none of them has to be installed where it is used.
if(NOT TARGET bempd)
  return()
endif()
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/bempd")
set(generated_dir "${PROJECT_BINARY_DIR}/package")

install(TARGETS bempd EXPORT bempdTargets
        LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime NAMELINK_COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/include/bempd.h" "${PROJECT_SOURCE_DIR}/include/bempd.hpp" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
        COMPONENT development)
install(EXPORT bempdTargets NAMESPACE bempd:: DESTINATION "${package_dir}" COMPONENT development)

# Component MPI: libbempd_mpi in a package of its own, because it needs MPI and MUMPS.
if(TARGET bempd_mpi)
  install(TARGETS bempd_mpi EXPORT bempdMPITargets
          LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT mpi NAMELINK_COMPONENT development OPTIONAL)
  install(FILES "${PROJECT_SOURCE_DIR}/include/bempd_mpi.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development)
  install(EXPORT bempdMPITargets NAMESPACE bempd:: DESTINATION "${package_dir}" COMPONENT development)
endif()

set(fortran_source_dir "${CMAKE_INSTALL_DATADIR}/bempd/fortran")
set(fortran_binary_dir "${CMAKE_INSTALL_LIBDIR}/bempd/fortran")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/bempdConfig.cmake.in" "${generated_dir}/bempdConfig.cmake"
                              INSTALL_DESTINATION "${package_dir}" PATH_VARS fortran_source_dir fortran_binary_dir)
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file("${generated_dir}/bempdConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${generated_dir}/bempdConfig.cmake" "${generated_dir}/bempdConfigVersion.cmake"
        "${PROJECT_SOURCE_DIR}/cmake/bempdFortran.cmake" "${PROJECT_SOURCE_DIR}/cmake/bempdMPI.cmake"
        DESTINATION "${package_dir}" COMPONENT development)

# Fortran: the sources for every compiler, and what was compiled for the one at hand, if it was: who builds the target bempd
# alone can install it.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/bindings/fortran/" DESTINATION "${fortran_source_dir}" COMPONENT development
        FILES_MATCHING PATTERN "*.f90")
if(TARGET bempd_fortran)
  get_target_property(fortran_modules bempd_fortran Fortran_MODULE_DIRECTORY)
  install(FILES "$<TARGET_FILE:bempd_fortran>" "${fortran_modules}/bempd_c.mod" "${fortran_modules}/bempd.mod"
          "${fortran_modules}/bempd_mpi.mod"
          DESTINATION "${fortran_binary_dir}" COMPONENT development OPTIONAL)
endif()

# The Python module goes into Debian packages only; everybody else uses pip.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/bindings/python/bempd" DESTINATION lib/python3/dist-packages
        COMPONENT python EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)

# So that pip lists it, and does not install a second one for those that need it.
set(metadata_dir "lib/python3/dist-packages/bempd-${PROJECT_VERSION}.dist-info")
configure_file("${PROJECT_SOURCE_DIR}/cmake/python_metadata.in" "${generated_dir}/METADATA" @ONLY)
file(WRITE "${generated_dir}/INSTALLER" "debian\n")
install(FILES "${generated_dir}/METADATA" "${generated_dir}/INSTALLER" DESTINATION "${metadata_dir}" COMPONENT python
        EXCLUDE_FROM_ALL)
install(FILES "${PROJECT_SOURCE_DIR}/bindings/python/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/python3-bempd" COMPONENT python EXCLUDE_FROM_ALL)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/python3-bempd" RENAME copyright
        COMPONENT python EXCLUDE_FROM_ALL)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples/first_crack" DESTINATION
        "${CMAKE_INSTALL_DATADIR}/doc/python3-bempd/examples" COMPONENT python EXCLUDE_FROM_ALL
        FILES_MATCHING PATTERN "*.py" PATTERN "README.md")

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
foreach(name bempd bempd-fortran bempd-mpi)
  configure_file("${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in" "${generated_dir}/${name}.pc" @ONLY)
endforeach()
install(FILES "${generated_dir}/bempd.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
if(TARGET bempd_mpi)
  install(FILES "${generated_dir}/bempd-mpi.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
endif()
if(TARGET bempd_fortran)
  install(CODE "if(EXISTS \"$<TARGET_FILE:bempd_fortran>\")
  file(INSTALL DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/pkgconfig\" TYPE FILE
       FILES \"${generated_dir}/bempd-fortran.pc\")
endif()" COMPONENT development)
endif()
