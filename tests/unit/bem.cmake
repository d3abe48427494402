bempd_add_unit_test(bem_test bem_close_pairs_test.cpp bem_kernels_test.cpp bem_operator_test.cpp
  bem_quadrature_test.cpp)
