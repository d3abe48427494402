from bempd import Model, rectangle

model = Model()  # a strip of acrylic glass (PMMA), 60 x 20 mm, 5 mm thick; SI units
pmma = model.add_material(
    young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
left = model.add_bem_region(pmma, rectangle(0, 0, 0.02, 0.02), element_length=0.005)
middle = model.add_pd_region(pmma, rectangle(0.02, 0, 0.04, 0.02), spacing=0.001)
right = model.add_bem_region(pmma, rectangle(0.04, 0, 0.06, 0.02), element_length=0.005)
model.add_crack([(0.0295, 0), (0.0295, 0.0045)])
model.fix_edge(left, 4)  # edge 4: the left end
model.prescribe_edge(right, 2, "x", 1e-6)  # the right end, m per unit of load factor
end = model.run_to_separation(1e4)
print(f"in two at {end.load_factor:.2f} micrometres: {end.total_broken_bonds} bonds in",
      f"{end.total_events} events, {end.released_energy:.4f} J released")
