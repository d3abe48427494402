# Builds the source tree that this port lies in; not tested with vcpkg.
vcpkg_check_linkage(ONLY_DYNAMIC_LIBRARY)
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../../.." ABSOLUTE)

if("suitesparse" IN_LIST FEATURES)
  set(linalg suitesparse)
else()
  set(linalg eigen)
endif()
vcpkg_check_features(OUT_FEATURE_OPTIONS feature_options FEATURES paper BEMPD_SCHEME_PAPER)

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${feature_options}
    "-DBEMPD_LINALG=${linalg}"
    -DBEMPD_BUILD_TESTS=OFF
    -DBEMPD_BUILD_EXAMPLES=OFF
    -DBEMPD_BUILD_BENCHMARKS=OFF
    -DBEMPD_BUILD_FORTRAN=OFF
    -DBEMPD_INSTALL=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/bempd)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
