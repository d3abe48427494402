!> Options, scene, conditions and callbacks of the module bempd.
submodule (bempd:bempd_support) bempd_scene
  implicit none
contains

  module procedure set_option_number
    call finish(self, bempd_set_option(self%handle, c_string(name), value), stat, errmsg)
  end procedure set_option_number

  module procedure set_option_text
    call finish(self, bempd_set_option_text(self%handle, c_string(name), c_string(value)), stat, errmsg)
  end procedure set_option_text

  module procedure get_option_number
    value = 0
    call finish(self, bempd_get_option(self%handle, c_string(name), value), stat, errmsg)
  end procedure get_option_number

  module procedure get_option_text
    character(kind=c_char), allocatable, target :: letters(:)
    integer(c_int64_t), target :: needed
    integer(c_int) :: status

    value = ""
    needed = 0
    status = bempd_get_option_text(self%handle, c_string(name), c_null_ptr, 0_c_int64_t, c_loc(needed))
    if (status == BEMPD_OK) then
      allocate (letters(needed))
      status = bempd_get_option_text(self%handle, c_string(name), c_loc(letters), needed, c_null_ptr)
      if (status == BEMPD_OK) value = bempd_text(letters)
    end if
    call finish(self, status, stat, errmsg)
  end procedure get_option_text

  module procedure add_material
    type(bempd_material) :: material
    integer(c_int) :: status
    integer(c_int32_t), target :: new

    status = bempd_material_init(material, c_sizeof(material))
    material%young_modulus = young_modulus
    material%poisson_ratio = poisson_ratio
    if (present(thickness)) material%thickness = thickness
    if (present(critical_stretch)) material%critical_stretch = critical_stretch
    if (present(fracture_energy)) material%fracture_energy = fracture_energy
    if (present(thermal_expansion)) material%thermal_expansion = thermal_expansion
    if (present(plane)) material%plane = plane
    new = 0
    call finish(self, bempd_add_material(self%handle, material, c_loc(new)), stat, errmsg)
    call give(new, id)
  end procedure add_material

  module procedure add_bem_region
    integer(c_int32_t), target :: new
    real(c_double), allocatable, target :: bends(:)

    new = 0
    if (can_be_loop(self, "bempd_add_bem_region", vertices, bulges, bends, stat, errmsg)) then
      if (present(bulges)) then
        call finish(self, bempd_add_bem_region_with_arcs(self%handle, material, size(vertices, 2, c_int64_t), vertices, &
          c_loc(bends), element_length, c_loc(new)), stat, errmsg)
      else
        call finish(self, bempd_add_bem_region(self%handle, material, size(vertices, 2, c_int64_t), vertices, &
          element_length, c_loc(new)), stat, errmsg)
      end if
    end if
    call give(new, region)
  end procedure add_bem_region

  module procedure add_body
    integer(c_int32_t), target :: new
    real(c_double), allocatable, target :: bends(:)

    new = 0
    if (can_be_loop(self, "bempd_add_body", vertices, bulges, bends, stat, errmsg)) then
      if (present(bulges)) then
        call finish(self, bempd_add_body_with_arcs(self%handle, material, size(vertices, 2, c_int64_t), vertices, &
          c_loc(bends), c_loc(new)), stat, errmsg)
      else
        call finish(self, bempd_add_body(self%handle, material, size(vertices, 2, c_int64_t), vertices, c_loc(new)), &
          stat, errmsg)
      end if
    end if
    call give(new, body)
  end procedure add_body

  module procedure set_body_lattice
    integer(c_int32_t) :: ratio

    ratio = 0
    if (present(horizon_ratio)) ratio = horizon_ratio
    call finish(self, bempd_set_body_lattice(self%handle, body, spacing, ratio), stat, errmsg)
  end procedure set_body_lattice

  module procedure set_crack_treatment
    call finish(self, bempd_set_crack_treatment(self%handle, crack, treatment), stat, errmsg)
  end procedure set_crack_treatment

  module procedure add_pd_region
    integer(c_int32_t) :: ratio
    integer(c_int32_t), target :: new
    real(c_double), allocatable, target :: bends(:)

    ratio = 0
    if (present(horizon_ratio)) ratio = horizon_ratio
    new = 0
    if (can_be_loop(self, "bempd_add_pd_region", vertices, bulges, bends, stat, errmsg)) then
      if (present(angle)) then
        if (.not. present(bulges)) allocate (bends(size(vertices, 2)), source=0._c_double)
        call finish(self, bempd_add_turned_pd_region(self%handle, material, size(vertices, 2, c_int64_t), vertices, &
          c_loc(bends), spacing, ratio, angle, c_loc(new)), stat, errmsg)
      else if (present(bulges)) then
        call finish(self, bempd_add_pd_region_with_arcs(self%handle, material, size(vertices, 2, c_int64_t), vertices, &
          c_loc(bends), spacing, ratio, c_loc(new)), stat, errmsg)
      else
        call finish(self, bempd_add_pd_region(self%handle, material, size(vertices, 2, c_int64_t), vertices, spacing, &
          ratio, c_loc(new)), stat, errmsg)
      end if
    end if
    call give(new, region)
  end procedure add_pd_region

  module procedure add_hole
    integer(c_int32_t), target :: new
    real(c_double), allocatable, target :: bends(:)

    new = 0
    if (can_be_loop(self, "bempd_add_hole", vertices, bulges, bends, stat, errmsg)) then
      if (present(bulges)) then
        call finish(self, bempd_add_hole_with_arcs(self%handle, region, size(vertices, 2, c_int64_t), vertices, &
          c_loc(bends), c_loc(new)), stat, errmsg)
      else
        call finish(self, bempd_add_hole(self%handle, region, size(vertices, 2, c_int64_t), vertices, c_loc(new)), stat, &
          errmsg)
      end if
    end if
    call give(new, first_edge)
  end procedure add_hole

  module procedure add_circular_hole
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_circular_hole(self%handle, region, x, y, radius, c_loc(new)), stat, errmsg)
    call give(new, first_edge)
  end procedure add_circular_hole

  module procedure set_edge_arc
    call finish(self, bempd_set_edge_arc(self%handle, region, edge, x, y), stat, errmsg)
  end procedure set_edge_arc

  module procedure add_bem_disc
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_bem_disc(self%handle, material, x, y, radius, element_length, c_loc(new)), stat, errmsg)
    call give(new, region)
  end procedure add_bem_disc

  module procedure set_edge_arc_about
    call finish(self, bempd_set_edge_arc_about(self%handle, region, edge, x, y, radius, turn), stat, errmsg)
  end procedure set_edge_arc_about

  module procedure set_edges_smooth
    call finish(self, bempd_set_edges_smooth(self%handle, region, first_edge, last_edge), stat, errmsg)
  end procedure set_edges_smooth

  module procedure set_edge_mesh
    call finish(self, bempd_set_edge_mesh(self%handle, region, edge, element_length, value_or(grading, 1.0_c_double)), &
      stat, errmsg)
  end procedure set_edge_mesh

  module procedure set_toughness_at
    character(48) :: counts

    if (.not. are_points(self, "bempd_set_toughness_at", "places", places, stat, errmsg)) return
    if (size(values) /= size(places, 2)) then
      write (counts, '(i0," values and ",i0," places")') size(values), size(places, 2)
      call refuse(self, "bempd_set_toughness_at: there are " // trim(counts) // "; give one value for each place", stat, &
        errmsg)
      return
    end if
    call finish(self, bempd_set_toughness_at(self%handle, region, size(places, 2, c_int64_t), places, values), stat, errmsg)
  end procedure set_toughness_at

  module procedure set_resistance_curve
    if (.not. are_alike(self, "bempd_set_resistance_curve", "extensions", extensions, energies, stat, errmsg)) return
    call finish(self, bempd_set_resistance_curve(self%handle, material, size(extensions, kind=c_int64_t), extensions, &
      energies), stat, errmsg)
  end procedure set_resistance_curve

  module procedure set_resistance_directions
    if (.not. are_alike(self, "bempd_set_resistance_directions", "angles", angles, energies, stat, errmsg)) return
    call finish(self, bempd_set_resistance_directions(self%handle, material, size(angles, kind=c_int64_t), angles, &
      energies), stat, errmsg)
  end procedure set_resistance_directions

  ! Whether a table of fracture energies has as many energies as places.
  logical function are_alike(self, function_name, name, places, energies, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    character(*), intent(in) :: function_name, name
    real(c_double), intent(in) :: places(:), energies(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(48) :: counts

    are_alike = size(places) == size(energies)
    if (are_alike) return
    write (counts, '(i0," energies and ",i0,1x)') size(energies), size(places)
    call refuse(self, function_name // ": there are " // trim(counts) // " " // name // "; give one energy for each", stat, &
      errmsg)
  end function are_alike

  module procedure add_crack
    integer(c_int32_t), target :: new

    new = 0
    if (are_points(self, "bempd_add_crack", "points", points, stat, errmsg)) then
      call finish(self, bempd_add_crack(self%handle, size(points, 2, c_int64_t), points, c_loc(new)), stat, errmsg)
    end if
    call give(new, crack)
  end procedure add_crack

  module procedure remove_region
    call finish(self, bempd_remove_region(self%handle, region), stat, errmsg)
  end procedure remove_region

  module procedure remove_crack
    call finish(self, bempd_remove_crack(self%handle, crack), stat, errmsg)
  end procedure remove_crack

  module procedure remove_support
    call finish(self, bempd_remove_support(self%handle, support), stat, errmsg)
  end procedure remove_support

  module procedure remove_load
    call finish(self, bempd_remove_load(self%handle, load), stat, errmsg)
  end procedure remove_load

  module procedure fix_edge
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_fix_edge(self%handle, region, edge, component, c_loc(new)), stat, errmsg)
    call give(new, support)
  end procedure fix_edge

  module procedure fix_point
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_fix_point(self%handle, x, y, component, c_loc(new)), stat, errmsg)
    call give(new, support)
  end procedure fix_point

  module procedure prescribe_edge
    type(value_parts), target :: parts
    integer(c_int32_t), target :: new

    new = 0
    if (are_values(self, "bempd_prescribe_edge", constant, proportional, parts, stat, errmsg)) then
      call finish(self, bempd_prescribe_edge(self%handle, region, edge, value_or(from, 0.0_c_double), value_or(to, &
        1.0_c_double), component, parts%count, c_loc(parts%constant), c_loc(parts%proportional), c_loc(new)), stat, &
        errmsg)
    end if
    call give(new, support)
  end procedure prescribe_edge

  module procedure prescribe_edge_function
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_prescribe_edge_function(self%handle, region, edge, value_or(from, 0.0_c_double), &
      value_or(to, 1.0_c_double), component, c_funloc(function), address_or_null(user), c_loc(new)), stat, errmsg)
    call give(new, support)
  end procedure prescribe_edge_function

  module procedure prescribe_point
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_prescribe_point(self%handle, x, y, component, value_or(constant, 0.0_c_double), &
      value_or(proportional, 0.0_c_double), c_loc(new)), stat, errmsg)
    call give(new, support)
  end procedure prescribe_point

  module procedure add_traction
    type(value_parts), target :: parts
    integer(c_int32_t), target :: new

    new = 0
    if (are_values(self, "bempd_add_traction", constant, proportional, parts, stat, errmsg)) then
      call finish(self, bempd_add_traction(self%handle, region, edge, value_or(from, 0.0_c_double), value_or(to, &
        1.0_c_double), component, parts%count, c_loc(parts%constant), c_loc(parts%proportional), c_loc(new)), stat, &
        errmsg)
    end if
    call give(new, load)
  end procedure add_traction

  module procedure add_pressure
    type(value_parts), target :: parts
    integer(c_int32_t), target :: new

    new = 0
    if (are_values(self, "bempd_add_pressure", constant, proportional, parts, stat, errmsg)) then
      call finish(self, bempd_add_pressure(self%handle, region, edge, value_or(from, 0.0_c_double), value_or(to, &
        1.0_c_double), parts%count, c_loc(parts%constant), c_loc(parts%proportional), c_loc(new)), stat, errmsg)
    end if
    call give(new, load)
  end procedure add_pressure

  module procedure add_traction_function
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_traction_function(self%handle, region, edge, value_or(from, 0.0_c_double), &
      value_or(to, 1.0_c_double), c_funloc(function), address_or_null(user), c_loc(new)), stat, errmsg)
    call give(new, load)
  end procedure add_traction_function

  module procedure add_crack_traction
    type(value_parts), target :: parts
    integer(c_int32_t), target :: new

    new = 0
    if (are_values(self, "bempd_add_crack_traction", constant, proportional, parts, stat, errmsg)) then
      call finish(self, bempd_add_crack_traction(self%handle, crack, component, parts%count, c_loc(parts%constant), &
        c_loc(parts%proportional), c_loc(new)), stat, errmsg)
    end if
    call give(new, load)
  end procedure add_crack_traction

  module procedure add_point_force
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_point_force(self%handle, x, y, component, value_or(constant, 0.0_c_double), &
      value_or(proportional, 0.0_c_double), c_loc(new)), stat, errmsg)
    call give(new, load)
  end procedure add_point_force

  module procedure add_crack_pressure
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_crack_pressure(self%handle, crack, value_or(constant, 0.0_c_double), &
      value_or(proportional, 0.0_c_double), c_loc(new)), stat, errmsg)
    call give(new, load)
  end procedure add_crack_pressure

  module procedure add_body_force
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_body_force(self%handle, region, component, value_or(constant, 0.0_c_double), &
      value_or(proportional, 0.0_c_double), c_loc(new)), stat, errmsg)
    call give(new, load)
  end procedure add_body_force

  module procedure add_rotation
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_rotation(self%handle, region, axis(1), axis(2), value_or(constant, 0.0_c_double), &
      value_or(proportional, 0.0_c_double), c_loc(new)), stat, errmsg)
    call give(new, load)
  end procedure add_rotation

  module procedure add_temperature_function
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_temperature_function(self%handle, region, c_funloc(function), address_or_null(user), &
      c_loc(new)), stat, errmsg)
    call give(new, load)
  end procedure add_temperature_function

  module procedure add_temperature
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_temperature(self%handle, region, value_or(constant, 0.0_c_double), &
      value_or(proportional, 0.0_c_double), c_loc(new)), stat, errmsg)
    call give(new, load)
  end procedure add_temperature

  module procedure set_load_values
    type(value_parts), target :: parts

    if (are_values(self, "bempd_set_load_values", constant, proportional, parts, stat, errmsg)) then
      call finish(self, bempd_set_load_values(self%handle, load, parts%count, c_loc(parts%constant), &
        c_loc(parts%proportional)), stat, errmsg)
    end if
  end procedure set_load_values

  module procedure set_support_values
    type(value_parts), target :: parts

    if (are_values(self, "bempd_set_support_values", constant, proportional, parts, stat, errmsg)) then
      call finish(self, bempd_set_support_values(self%handle, support, parts%count, c_loc(parts%constant), &
        c_loc(parts%proportional)), stat, errmsg)
    end if
  end procedure set_support_values

  module procedure set_progress
    type(c_funptr) :: address

    address = c_null_funptr
    if (present(function)) address = c_funloc(function)
    call finish(self, bempd_set_progress(self%handle, address, address_or_null(user)), stat, errmsg)
  end procedure set_progress

  module procedure set_phase_progress
    type(c_funptr) :: address

    address = c_null_funptr
    if (present(function)) address = c_funloc(function)
    call finish(self, bempd_set_phase_progress(self%handle, address, address_or_null(user)), stat, errmsg)
  end procedure set_phase_progress

  module procedure set_log
    type(c_funptr) :: address

    address = c_null_funptr
    if (present(function)) address = c_funloc(function)
    call finish(self, bempd_set_log(self%handle, address, address_or_null(user)), stat, errmsg)
  end procedure set_log

  module procedure request_cancel
    call finish(self, bempd_request_cancel(self%handle), stat, errmsg)
  end procedure request_cancel

  module procedure request_stop
    call finish(self, bempd_request_stop(self%handle), stat, errmsg)
  end procedure request_stop
end submodule bempd_scene
