bempd_add_unit_test(pd_test pd_crack_test.cpp pd_fields_test.cpp pd_lattice_test.cpp pd_network_test.cpp
  pd_outlined_test.cpp)
bempd_thorough_test(pd_test pd_test)
