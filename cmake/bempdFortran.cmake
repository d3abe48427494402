# Component Fortran: the target bempd::fortran. Module files fit one compiler only, so the installed ones serve where
# they can be read; elsewhere the installed sources are compiled with the host's compiler.
if(NOT CMAKE_Fortran_COMPILER_LOADED)
  set(bempd_Fortran_FOUND FALSE)
  string(APPEND bempd_NOT_FOUND_MESSAGE
         "component Fortran: enable the language first, with project(... LANGUAGES Fortran) or enable_language(Fortran)\n")
  return()
endif()

set(bempd_Fortran_FOUND TRUE)
if(TARGET bempd::fortran)
  return()
endif()

set(bempd_probe "${CMAKE_BINARY_DIR}${CMAKE_FILES_DIRECTORY}/bempd_probe")
file(WRITE "${bempd_probe}.f90" "program probe\n  use bempd\n  implicit none\nend program\n")
file(GLOB bempd_fortran_library "${bempd_fortran_binary_dir}/libbempd_fortran.*")
if(bempd_fortran_library)
  try_compile(bempd_fortran_modules_fit "${bempd_probe}" SOURCES "${bempd_probe}.f90"
              CMAKE_FLAGS "-DINCLUDE_DIRECTORIES=${bempd_fortran_binary_dir}"
              LINK_LIBRARIES "${bempd_fortran_library}" bempd::bempd)
endif()

if(bempd_fortran_modules_fit)
  add_library(bempd::fortran STATIC IMPORTED)
  set_target_properties(bempd::fortran PROPERTIES IMPORTED_LOCATION "${bempd_fortran_library}"
                        IMPORTED_LINK_INTERFACE_LANGUAGES Fortran)
  target_include_directories(bempd::fortran INTERFACE "${bempd_fortran_binary_dir}")
  target_link_libraries(bempd::fortran INTERFACE bempd::bempd)
else()
  file(GLOB bempd_fortran_sources "${bempd_fortran_source_dir}/*.f90")
  add_library(bempd_fortran STATIC EXCLUDE_FROM_ALL ${bempd_fortran_sources})
  add_library(bempd::fortran ALIAS bempd_fortran)
  set_target_properties(bempd_fortran PROPERTIES POSITION_INDEPENDENT_CODE ON
                        Fortran_MODULE_DIRECTORY "${CMAKE_BINARY_DIR}${CMAKE_FILES_DIRECTORY}/bempd_modules")
  target_include_directories(bempd_fortran INTERFACE "${CMAKE_BINARY_DIR}${CMAKE_FILES_DIRECTORY}/bempd_modules")
  target_link_libraries(bempd_fortran PUBLIC bempd::bempd)
endif()
