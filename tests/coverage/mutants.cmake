# The sources BEMPD_ALONE are compiled one by one where others are compiled together.
function(bempd_compile_alone)
  set_source_files_properties(${BEMPD_ALONE} TARGET_DIRECTORY bempd_engine PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
cmake_language(DEFER DIRECTORY "${CMAKE_SOURCE_DIR}" CALL bempd_compile_alone)
