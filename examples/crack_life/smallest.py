from bempd import Model, rectangle

model = Model()  # a sheet of aluminium, 120 x 240 mm, with a crack of 8 mm; SI units
aluminium = model.add_material(young_modulus=72e9, poisson_ratio=0.33)
sheet = model.add_bem_region(aluminium, rectangle(-0.06, -0.12, 0.06, 0.12), element_length=0.03)
crack = model.add_crack([(-0.004, 0), (0.004, 0)])
model.fix_point((-0.06, -0.12))
model.fix_point((0.06, -0.12), "y")
model.add_traction(sheet, 3, "y", 80e6)  # 80 MPa at load factor 1
model.add_traction(sheet, 1, "y", -80e6)
model.set_growth_rate(  # Paris and Walker, in MPa m^(1/2) and m
    aluminium, coefficient=2e-11, exponent=3, unit_intensity=1e6, walker=0.6, critical_intensity=35)
life = model.grow_fatigue(high=[1, 0.7], low=[0.1, 0.2], cycles=[10, 500])
print(f"breaks after {life.cycles:.0f} cycles, at a length of {1e3 * model.crack_length(crack):.1f} mm")
