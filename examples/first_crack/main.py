from bempd import Model, rectangle

model = Model(options={"error.wanted": 0.01})  # the elements follow from it
pmma = model.add_material(  # acrylic glass (PMMA), 5 mm thick; SI units
    young_modulus=3e9, poisson_ratio=1 / 3, thickness=0.005, fracture_energy=300)
strip = model.add_body(pmma, rectangle(0, 0, 0.06, 0.02))  # 60 x 20 mm
model.add_circular_hole(strip, (0.034, 0.013), 0.003)
model.add_crack([(0.03, 0), (0.03, 0.005)])
model.fix_edge(strip, 4)  # edge 4: the left end
model.prescribe_edge(strip, 2, "x", 1e-6)  # the right end, m per unit of load factor
end = model.run_to_separation(1e4)
print(f"growth at {end.load_factor:.1f} micrometres, {end.peak_resistance:.0f} N")
