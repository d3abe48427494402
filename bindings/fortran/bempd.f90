!> Cracks in two-dimensional elastic bodies, for Fortran.
!>
!> Every procedure stands for the function of the same name in bempd_c, whose comment describes the arguments, units and
!> rules. What differs:
!>
!> * points are (2,n), fields (components,n), and counts are the arrays' own;
!> * nodes, lines of the history and everything else that C counts from 0 are counted from 1 here;
!> * ids and reports that nobody asks for are left out, as are constant or proportional parts that are 0;
!> * strings lose their trailing blanks.
!>
!> Errors. With stat= the outcome is given there (BEMPD_OK is 0) and errmsg= receives the sentence, cut or padded as by
!> allocate; last_error() has it in full. Results are then 0, empty or not associated. Without stat= an error stops the
!> program with the sentence.
!>
!> Callbacks are best procedures of a module: internal ones need an executable stack. What they work on travels in
!> user=, as c_loc of a variable that lives as long as the model.
module bempd
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int8_t, c_int32_t, c_int64_t, c_null_ptr, c_ptr
  use bempd_c, only: BEMPD_OK, BEMPD_ERROR_ARGUMENT, BEMPD_ERROR_ORDER, BEMPD_ERROR_UNSOLVABLE, &
    BEMPD_ERROR_CONVERGENCE, BEMPD_ERROR_CANCELLED, BEMPD_ERROR_MEMORY, BEMPD_ERROR_IO, BEMPD_ERROR_INTERNAL, &
    BEMPD_OPTION_NUMBER, BEMPD_OPTION_TEXT, BEMPD_PLANE_STRESS, BEMPD_PLANE_STRAIN, BEMPD_X, BEMPD_Y, BEMPD_BOTH, &
    BEMPD_STOP_LOAD_FACTOR, BEMPD_STOP_EVENT, BEMPD_STOP_SEPARATED, BEMPD_STOP_NO_FURTHER_EVENT, &
    BEMPD_STOP_NO_ADMISSIBLE_LOAD, BEMPD_STOP_NO_EQUILIBRIUM, BEMPD_STOP_REQUESTED, BEMPD_STOP_CRACK_STOPPED, &
    BEMPD_UNTIL_VALUES, BEMPD_UNTIL_EVENT, BEMPD_UNTIL_SEPARATED, BEMPD_COLUMN_SUPPORT, BEMPD_COLUMN_LOAD, BEMPD_POSITION, &
    BEMPD_STATE_BODY, BEMPD_STATE_BODY_AND_VALUES, &
    BEMPD_DISPLACEMENT, BEMPD_STRESS, BEMPD_DAMAGE, BEMPD_TRACTION, BEMPD_BOND_STRETCH, BEMPD_ELEMENT_STRESS, &
    BEMPD_STRESS_ORDER, BEMPD_COUNTER_CLOCKWISE, BEMPD_CLOCKWISE, BEMPD_FACE_LEFT, BEMPD_FACE_RIGHT, &
    BEMPD_SINGULAR_CORNER, BEMPD_SINGULAR_INTERFACE, BEMPD_SINGULAR_CRACK, BEMPD_SINGULAR_POINT, bempd_singularity, &
    BEMPD_NEXT_NOTHING, BEMPD_NEXT_BOND, BEMPD_NEXT_TIP, bempd_explanation, &
    bempd_piece, &
    BEMPD_BOND_INTACT, BEMPD_BOND_BROKEN, BEMPD_BOND_CUT, BEMPD_PRESSURE, BEMPD_SHEAR, BEMPD_CRACK_START, &
    BEMPD_CRACK_END, BEMPD_TIP_ELEMENTS, BEMPD_TIP_CONTOURS, BEMPD_TIP_STRESS, bempd_path_vertex, &
    BEMPD_LOAD_UNKNOWN, BEMPD_LOAD_FACTORS, BEMPD_LOAD_FIT, BEMPD_LOAD_ENERGY, &
    BEMPD_TIP_GROWS, BEMPD_TIP_AT_EDGE, BEMPD_TIP_AT_HOLE, BEMPD_TIP_AT_CRACK, BEMPD_TIP_AT_INTERFACE, BEMPD_TIP_SEPARATED, &
    bempd_step_report, bempd_statistics, bempd_body_plan, bempd_errors, bempd_run_errors, &
    BEMPD_ERROR_SOURCE_BOUNDARY, BEMPD_ERROR_SOURCE_LATTICE, BEMPD_ERROR_SOURCE_PATCH, BEMPD_ERROR_SOURCE_MODEL, &
    bempd_history_entry, bempd_crack_tip, bempd_growth, bempd_crack_extension, bempd_growth_rate, bempd_fatigue, &
    bempd_fatigue_report, bempd_fatigue_record, bempd_growth_rate_init, bempd_fatigue_init, BEMPD_RATE_PARIS, &
    BEMPD_RATE_FORMAN, BEMPD_RATE_NASGRO, BEMPD_RATE_SUSTAINED, BEMPD_RATE_HOST, BEMPD_FATIGUE_CYCLES, &
    BEMPD_FATIGUE_CRITICAL, BEMPD_FATIGUE_LENGTH, BEMPD_FATIGUE_NONE_GROWS, BEMPD_FATIGUE_TIP_ENDED, &
    BEMPD_FATIGUE_TIP_STOPPED, BEMPD_FATIGUE_STEPS, BEMPD_FATIGUE_REQUESTED, BEMPD_FATIGUE_NET_SECTION, &
    bempd_boundary_function, bempd_growth_function, bempd_progress_function, bempd_phase_function, bempd_log_function
  implicit none
  private :: c_char, c_double, c_int, c_int8_t, c_int32_t, c_int64_t, c_null_ptr, c_ptr

  !> A scene and its state. It cannot be copied; what goes out of scope is freed.
  type :: bempd_model
    private
    type(c_ptr) :: handle = c_null_ptr
    character(:), allocatable :: sentence  ! of an error that this module found
  contains
    procedure :: create, free, last_error, c_handle
    procedure, private :: set_option_number, set_option_text, get_option_number, get_option_text, refuse_copy
    generic :: set_option => set_option_number, set_option_text
    generic :: get_option => get_option_number, get_option_text
    generic :: assignment(=) => refuse_copy
    procedure :: add_body, set_body_lattice, set_crack_treatment, plan, error_estimate, run_error_estimate
    procedure :: add_material, add_bem_region, add_pd_region, add_hole, add_circular_hole, add_crack
    procedure :: add_bem_disc, set_edge_arc, set_edge_arc_about, set_edges_smooth, set_edge_mesh, set_toughness_at
    procedure :: set_resistance_curve, set_resistance_directions
    procedure :: remove_region, remove_crack, remove_support, remove_load
    procedure :: region_count, edge_count, node_count, element_count, bond_count
    procedure :: name_region, name_edge, name_support, name_load, edge_named
    procedure :: fix_edge, fix_point, prescribe_edge, prescribe_edge_function, prescribe_point
    procedure :: add_traction, add_traction_function, add_pressure, add_point_force
    procedure :: add_crack_pressure, add_body_force, add_rotation, add_temperature, add_temperature_function, set_load_values
    procedure :: set_support_values
    procedure :: crack_count, crack_length, crack_path
    procedure :: add_crack_traction, tips, tip_history, write_tips, crack_opening, grow_cracks, set_tip_frozen, extensions
    procedure :: extend_cracks, set_growth_rate, grow_fatigue, grow_fatigue_cases, fatigue_records, set_resistance_function
    procedure :: add_load_case, load_case_count, combined_tips, combined_reaction, combined_values, pressed_faces
    procedure :: set_progress, set_phase_progress, set_log, request_cancel, request_stop
    procedure :: prepare, step, step_to_next_event, run_to_separation, step_to_values, run_program
    procedure :: load_factor, admissible_load_factors, explain, generation, copy_field, fill_field, view_field
    procedure :: copy_elements, copy_bonds, reaction, reaction_moment, edge_reaction, evaluate, evaluate_in, singularities
    procedure :: stress_orders, evaluate_errors
    procedure :: add_edge_forces, set_support_nodal_values, set_load_nodal_values, set_support_values_at
    procedure :: set_load_values_at, fractions_on_edge, edge_nodes, edge_elements, edge_forces
    procedure :: piece_count, piece, node_pieces, support_piece, load_piece, are_connected
    procedure :: get_statistics, history, history_support, state_save, state_restore, write_snapshot, write_history
    final :: finalize_model
  end type bempd_model

  !> A saved state of a model. It cannot be copied; what goes out of scope is freed.
  type :: bempd_state
    private
    type(c_ptr) :: handle = c_null_ptr
  contains
    procedure :: free => free_state, to_bytes, from_bytes
    procedure :: write_file => write_state_file, read_file => read_state_file
    procedure, private :: refuse_copy_of_state
    generic :: assignment(=) => refuse_copy_of_state
    final :: finalize_state
  end type bempd_state

  !> What bempd_get_options says of one option.
  type :: bempd_option
    character(:), allocatable :: name, summary, unit, choices, default_text
    integer(c_int) :: kind  !< BEMPD_OPTION_NUMBER or BEMPD_OPTION_TEXT
    logical :: whole_number
    real(c_double) :: default_value, minimum, maximum
  end type bempd_option

  private :: create, free, last_error, c_handle, set_option_number, set_option_text, get_option_number, &
    get_option_text, refuse_copy, add_body, set_body_lattice, set_crack_treatment, plan, error_estimate, &
    run_error_estimate, &
    add_material, add_bem_region, &
    add_pd_region, add_hole, add_circular_hole, add_crack, &
    add_bem_disc, set_edge_arc, set_edge_arc_about, set_edges_smooth, set_edge_mesh, &
    set_toughness_at, set_resistance_curve, set_resistance_directions, &
    edge_reaction, evaluate_in, singularities, stress_orders, evaluate_errors, &
    add_edge_forces, set_support_nodal_values, set_load_nodal_values, set_support_values_at, set_load_values_at, &
    fractions_on_edge, edge_nodes, edge_elements, edge_forces, &
    piece_count, piece, node_pieces, support_piece, load_piece, are_connected, &
    remove_region, remove_crack, remove_support, remove_load, &
    region_count, edge_count, node_count, element_count, bond_count, name_region, name_edge, name_support, name_load, &
    edge_named, fix_edge, fix_point, prescribe_edge, &
    prescribe_edge_function, prescribe_point, add_traction, add_traction_function, add_pressure, add_point_force, &
    add_crack_pressure, add_body_force, add_rotation, add_temperature, add_temperature_function, set_load_values, &
    set_support_values, set_progress, set_phase_progress, set_log, request_cancel, request_stop, prepare, step, &
    step_to_next_event, run_to_separation, step_to_values, run_program, &
    load_factor, admissible_load_factors, explain, generation, copy_field, fill_field, view_field, copy_elements, copy_bonds, &
    reaction, &
    reaction_moment, evaluate, &
    get_statistics, &
    history, history_support, add_crack_traction, tips, tip_history, write_tips, crack_opening, grow_cracks, set_tip_frozen, &
    extensions, crack_count, crack_length, crack_path, extend_cracks, set_growth_rate, grow_fatigue, fatigue_records, &
    grow_fatigue_cases, set_resistance_function, &
    add_load_case, load_case_count, combined_tips, combined_reaction, combined_values, pressed_faces, &
    state_save, state_restore, write_snapshot, write_history, finalize_model, free_state, to_bytes, &
    from_bytes, write_state_file, read_state_file, refuse_copy_of_state, finalize_state

  interface

    ! Life and errors.
    module subroutine create(self, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine create
    module function last_error(self) result(sentence)
      class(bempd_model), intent(in) :: self
      character(:), allocatable :: sentence
    end function last_error
    !> The pointer of the C interface, for libraries that take it, as bempd_mpi does.
    module function c_handle(self) result(handle)
      class(bempd_model), intent(in) :: self
      type(c_ptr) :: handle
    end function c_handle

    ! Options: a number or a word.
    module subroutine set_option_number(self, name, value, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      character(*), intent(in) :: name
      real(c_double), intent(in) :: value
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_option_number
    module subroutine set_option_text(self, name, value, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      character(*), intent(in) :: name, value
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_option_text
    module subroutine get_option_number(self, name, value, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      character(*), intent(in) :: name
      real(c_double), intent(out) :: value
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine get_option_number
    module subroutine get_option_text(self, name, value, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      character(*), intent(in) :: name
      character(:), allocatable, intent(out) :: value
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine get_option_text

    ! Materials, regions and cracks.
    module subroutine add_material(self, young_modulus, poisson_ratio, id, thickness, critical_stretch, &
        fracture_energy, plane, stat, errmsg, thermal_expansion)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: young_modulus, poisson_ratio
      integer(c_int32_t), intent(out), optional :: id
      real(c_double), intent(in), optional :: thickness, critical_stretch, fracture_energy, thermal_expansion
      integer(c_int32_t), intent(in), optional :: plane
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_material
    !> A polygon whose boundary elements the library chooses.
    module subroutine add_body(self, material, vertices, body, stat, errmsg, bulges)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      real(c_double), intent(in) :: vertices(:, :)
      integer(c_int32_t), intent(out), optional :: body
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
      real(c_double), intent(in), optional :: bulges(:)
    end subroutine add_body
    module subroutine add_bem_region(self, material, vertices, element_length, region, stat, errmsg, bulges)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      real(c_double), intent(in) :: vertices(:, :), element_length
      integer(c_int32_t), intent(out), optional :: region
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
      real(c_double), intent(in), optional :: bulges(:)
    end subroutine add_bem_region
    module subroutine add_pd_region(self, material, vertices, spacing, horizon_ratio, region, stat, errmsg, bulges, &
      angle)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      real(c_double), intent(in) :: vertices(:, :), spacing
      integer(c_int32_t), intent(in), optional :: horizon_ratio
      integer(c_int32_t), intent(out), optional :: region
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
      real(c_double), intent(in), optional :: bulges(:)
      real(c_double), intent(in), optional :: angle
    end subroutine add_pd_region
    module subroutine add_hole(self, region, vertices, first_edge, stat, errmsg, bulges)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      real(c_double), intent(in) :: vertices(:, :)
      integer(c_int32_t), intent(out), optional :: first_edge
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
      real(c_double), intent(in), optional :: bulges(:)
    end subroutine add_hole
    module subroutine add_circular_hole(self, region, x, y, radius, first_edge, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      real(c_double), intent(in) :: x, y, radius
      integer(c_int32_t), intent(out), optional :: first_edge
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_circular_hole
    module subroutine set_edge_arc(self, region, edge, x, y, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      real(c_double), intent(in) :: x, y
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_edge_arc
    module subroutine add_bem_disc(self, material, x, y, radius, element_length, region, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      real(c_double), intent(in) :: x, y, radius, element_length
      integer(c_int32_t), intent(out), optional :: region
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_bem_disc
    module subroutine set_edge_arc_about(self, region, edge, x, y, radius, turn, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge, turn
      real(c_double), intent(in) :: x, y, radius
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_edge_arc_about
    module subroutine set_edges_smooth(self, region, first_edge, last_edge, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, first_edge, last_edge
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_edges_smooth
    module subroutine set_edge_mesh(self, region, edge, element_length, grading, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      real(c_double), intent(in) :: element_length
      real(c_double), intent(in), optional :: grading
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_edge_mesh
    ! Fracture energies [J/m^2] at places (2,n), in place of the one of the region's material.
    module subroutine set_toughness_at(self, region, places, values, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      real(c_double), intent(in) :: places(:, :), values(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_toughness_at
    ! Fracture energies [J/m^2] of a material by the growth of a tip [m], in place of its one.
    module subroutine set_resistance_curve(self, material, extensions, energies, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      real(c_double), intent(in) :: extensions(:), energies(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_resistance_curve
    ! Fracture energies [J/m^2] of a material by the direction of a crack [rad].
    module subroutine set_resistance_directions(self, material, angles, energies, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      real(c_double), intent(in) :: angles(:), energies(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_resistance_directions
    module subroutine add_crack(self, points, crack, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: points(:, :)
      integer(c_int32_t), intent(out), optional :: crack
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_crack
    ! Removal before the model is prepared; other ids stay.
    module subroutine remove_region(self, region, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_region
    module subroutine remove_crack(self, crack, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: crack
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_crack
    module subroutine remove_support(self, support, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_support
    module subroutine remove_load(self, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine remove_load
    module subroutine region_count(self, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine region_count
    module subroutine edge_count(self, region, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      integer(c_int32_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine edge_count

    ! Names that messages and files show; an empty one takes a name away.
    module subroutine name_region(self, region, name, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      character(*), intent(in) :: name
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine name_region
    module subroutine name_edge(self, region, edge, name, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      character(*), intent(in) :: name
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine name_edge
    module subroutine name_support(self, support, name, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support
      character(*), intent(in) :: name
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine name_support
    module subroutine name_load(self, load, name, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: load
      character(*), intent(in) :: name
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine name_load
    module subroutine edge_named(self, region, name, edge, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      character(*), intent(in) :: name
      integer(c_int32_t), intent(out) :: edge
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine edge_named

    ! Supports and loads. Without from and to: the whole edge.
    module subroutine fix_edge(self, region, edge, component, support, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge, component
      integer(c_int32_t), intent(out), optional :: support
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine fix_edge
    module subroutine fix_point(self, x, y, component, support, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: x, y
      integer(c_int32_t), intent(in) :: component
      integer(c_int32_t), intent(out), optional :: support
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine fix_point
    module subroutine prescribe_edge(self, region, edge, component, constant, proportional, from, to, support, stat, &
        errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge, component
      real(c_double), intent(in), optional :: constant(:), proportional(:), from, to
      integer(c_int32_t), intent(out), optional :: support
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine prescribe_edge
    module subroutine prescribe_edge_function(self, region, edge, component, function, user, from, to, support, &
        stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge, component
      procedure(bempd_boundary_function) :: function
      type(c_ptr), intent(in), optional :: user
      real(c_double), intent(in), optional :: from, to
      integer(c_int32_t), intent(out), optional :: support
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine prescribe_edge_function
    module subroutine prescribe_point(self, x, y, component, constant, proportional, support, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: x, y
      integer(c_int32_t), intent(in) :: component
      real(c_double), intent(in), optional :: constant, proportional
      integer(c_int32_t), intent(out), optional :: support
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine prescribe_point
    module subroutine add_traction(self, region, edge, component, constant, proportional, from, to, load, stat, &
        errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge, component
      real(c_double), intent(in), optional :: constant(:), proportional(:), from, to
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_traction
    module subroutine add_pressure(self, region, edge, constant, proportional, from, to, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      real(c_double), intent(in), optional :: constant(:), proportional(:), from, to
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_pressure
    module subroutine add_traction_function(self, region, edge, function, user, from, to, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      procedure(bempd_boundary_function) :: function
      type(c_ptr), intent(in), optional :: user
      real(c_double), intent(in), optional :: from, to
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_traction_function
    module subroutine add_crack_traction(self, crack, component, constant, proportional, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: crack, component
      real(c_double), intent(in), optional :: constant(:), proportional(:)
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_crack_traction
    module subroutine add_point_force(self, x, y, component, constant, proportional, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: x, y
      integer(c_int32_t), intent(in) :: component
      real(c_double), intent(in), optional :: constant, proportional
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_point_force
    module subroutine add_crack_pressure(self, crack, constant, proportional, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: crack
      real(c_double), intent(in), optional :: constant, proportional
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_crack_pressure
    module subroutine add_body_force(self, region, component, constant, proportional, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, component
      real(c_double), intent(in), optional :: constant, proportional
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_body_force
    module subroutine add_rotation(self, region, axis, constant, proportional, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      real(c_double), intent(in) :: axis(2)
      real(c_double), intent(in), optional :: constant, proportional
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_rotation
    module subroutine add_temperature_function(self, region, function, user, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      procedure(bempd_boundary_function) :: function
      type(c_ptr), intent(in), optional :: user
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_temperature_function
    module subroutine add_temperature(self, region, constant, proportional, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      real(c_double), intent(in), optional :: constant, proportional
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_temperature
    module subroutine set_load_values(self, load, constant, proportional, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: load
      real(c_double), intent(in), optional :: constant(:), proportional(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_load_values
    module subroutine set_support_values(self, support, constant, proportional, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support
      real(c_double), intent(in), optional :: constant(:), proportional(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_support_values

    ! Edges, for hosts that couple: values are (2,n), x and y of each place or node side by side.
    module subroutine add_edge_forces(self, region, edge, from, to, load, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      real(c_double), intent(in), optional :: from, to
      integer(c_int32_t), intent(out), optional :: load
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_edge_forces
    module subroutine set_support_nodal_values(self, support, constant, proportional, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support
      real(c_double), intent(in), optional :: constant(:, :), proportional(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_support_nodal_values
    module subroutine set_load_nodal_values(self, load, constant, proportional, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: load
      real(c_double), intent(in), optional :: constant(:, :), proportional(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_load_nodal_values
    module subroutine set_support_values_at(self, support, fractions, constant, proportional, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support
      real(c_double), intent(in) :: fractions(:)
      real(c_double), intent(in), optional :: constant(:, :), proportional(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_support_values_at
    module subroutine set_load_values_at(self, load, fractions, constant, proportional, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: load
      real(c_double), intent(in) :: fractions(:)
      real(c_double), intent(in), optional :: constant(:, :), proportional(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_load_values_at
    module subroutine fractions_on_edge(self, region, edge, points, fractions, distances, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      real(c_double), intent(in) :: points(:, :)
      real(c_double), allocatable, intent(out), optional :: fractions(:), distances(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine fractions_on_edge
    !> Nodes, from 1, where they lie as fractions of the edge, and the integrals of their shape functions [m].
    module subroutine edge_nodes(self, region, edge, nodes, fractions, weights, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      integer(c_int32_t), allocatable, intent(out), optional :: nodes(:)
      real(c_double), allocatable, intent(out), optional :: fractions(:), weights(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine edge_nodes
    !> Elements or cells, from 1.
    module subroutine edge_elements(self, region, edge, elements, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      integer(c_int32_t), allocatable, intent(out) :: elements(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine edge_elements
    !> Forces (2,n) of supports and neighbours at the nodes of edge_nodes() [N].
    module subroutine edge_forces(self, region, edge, forces, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      real(c_double), allocatable, intent(out) :: forces(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine edge_forces

    ! Callbacks; without a function there is none any more.
    module subroutine set_progress(self, function, user, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      procedure(bempd_progress_function), optional :: function
      type(c_ptr), intent(in), optional :: user
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_progress
    module subroutine set_phase_progress(self, function, user, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      procedure(bempd_phase_function), optional :: function
      type(c_ptr), intent(in), optional :: user
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_phase_progress
    module subroutine set_log(self, function, user, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      procedure(bempd_log_function), optional :: function
      type(c_ptr), intent(in), optional :: user
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_log
    module subroutine request_cancel(self, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine request_cancel
    module subroutine request_stop(self, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine request_stop

    ! Stepping.
    module subroutine prepare(self, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine prepare
    module subroutine step(self, load_factor, report, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: load_factor
      type(bempd_step_report), intent(out), optional :: report
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine step
    module subroutine step_to_next_event(self, load_factor_limit, report, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: load_factor_limit
      type(bempd_step_report), intent(out), optional :: report
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine step_to_next_event
    module subroutine run_to_separation(self, load_factor_limit, report, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: load_factor_limit
      type(bempd_step_report), intent(out), optional :: report
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine run_to_separation
    !> Loads and supports move together to the values that they have now; `until` is BEMPD_UNTIL_VALUES unless given.
    module subroutine step_to_values(self, load_factor, until, report, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: load_factor
      integer(c_int32_t), intent(in), optional :: until
      type(bempd_step_report), intent(out), optional :: report
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine step_to_values
    !> Factors by time, factors(column, row); a column of its own for each of `ids`, of the kind BEMPD_COLUMN_SUPPORT or
    !> BEMPD_COLUMN_LOAD, or without them one for all supports and loads. `until` is BEMPD_UNTIL_VALUES unless given.
    module subroutine run_program(self, times, factors, kinds, ids, until, report, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: times(:)
      real(c_double), intent(in) :: factors(:, :)
      integer(c_int32_t), intent(in), optional :: kinds(:), ids(:)
      integer(c_int32_t), intent(in), optional :: until
      type(bempd_step_report), intent(out), optional :: report
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine run_program

    ! Results.
    module subroutine load_factor(self, value, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(out) :: value
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine load_factor
    !> Lowest and highest load factor that the body bears with its present bonds; lowest > highest if there is none.
    module subroutine admissible_load_factors(self, lowest, highest, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(out) :: lowest, highest
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine admissible_load_factors
    !> What breaks or grows next while the load factor rises or falls (.false.), and what holds other tips back.
    module subroutine explain(self, text, rising, explanation, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      character(:), allocatable, intent(out) :: text
      logical, intent(in), optional :: rising
      type(bempd_explanation), intent(out), optional :: explanation
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine explain
    module subroutine generation(self, number, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int64_t), intent(out) :: number
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine generation
    module subroutine node_count(self, region, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      integer(c_int64_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine node_count
    module subroutine element_count(self, region, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      integer(c_int64_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine element_count
    module subroutine bond_count(self, region, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      integer(c_int64_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bond_count
    module subroutine copy_field(self, region, field, values, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, field
      real(c_double), allocatable, intent(out) :: values(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine copy_field
    ! Copies a field as copy_field does, into an array of the host's own that has the field's shape, (components,n).
    module subroutine fill_field(self, region, field, values, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, field
      real(c_double), intent(inout) :: values(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine fill_field
    module subroutine view_field(self, region, field, values, generation, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, field
      real(c_double), pointer, intent(out) :: values(:, :)
      integer(c_int64_t), intent(out), optional :: generation
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine view_field
    module subroutine copy_elements(self, region, nodes, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      integer(c_int32_t), allocatable, intent(out) :: nodes(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine copy_elements
    module subroutine copy_bonds(self, region, points, states, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      integer(c_int32_t), allocatable, intent(out) :: points(:, :)
      integer(c_int32_t), allocatable, intent(out), optional :: states(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine copy_bonds
    module subroutine reaction(self, support, force, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support
      real(c_double), intent(out) :: force(2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine reaction
    module subroutine reaction_moment(self, support, x, y, moment, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support
      real(c_double), intent(in) :: x, y
      real(c_double), intent(out) :: moment
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine reaction_moment
    module subroutine evaluate(self, points, displacement, stress, regions, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: points(:, :)
      real(c_double), allocatable, intent(out), optional :: displacement(:, :), stress(:, :)
      integer(c_int32_t), allocatable, intent(out), optional :: regions(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine evaluate
    module subroutine edge_reaction(self, region, edge, x, y, force, moment, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region, edge
      real(c_double), intent(in) :: x, y
      real(c_double), intent(out) :: force(2), moment
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine edge_reaction
    !> Values as one region has them; on cracks those of the left face unless face is given.
    module subroutine evaluate_in(self, region, points, displacement, stress, face, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      real(c_double), intent(in) :: points(:, :)
      real(c_double), allocatable, intent(out), optional :: displacement(:, :), stress(:, :)
      integer(c_int32_t), intent(in), optional :: face
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine evaluate_in
    !> How strongly stress grows at places: 0 where it is bounded, as bempd_stress_orders has it.
    module subroutine stress_orders(self, points, orders, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: points(:, :)
      real(c_double), allocatable, intent(out) :: orders(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine stress_orders
    !> Errors of displacements and stresses at places, as bempd_evaluate_errors has them.
    module subroutine evaluate_errors(self, points, displacement, stress, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: points(:, :)
      real(c_double), allocatable, intent(out) :: displacement(:), stress(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine evaluate_errors
    !> All places where stress is unbounded, as bempd_get_singularity has them.
    module subroutine singularities(self, found, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_singularity), allocatable, intent(out) :: found(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine singularities
    !> Pieces that the body consists of; a material point without any bond is one too.
    module subroutine piece_count(self, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int64_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine piece_count
    !> A piece, from 1; the one with the most nodes is the first.
    module subroutine piece(self, number, found, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: number
      type(bempd_piece), intent(out) :: found
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine piece
    !> Numbers of the pieces of the nodes of a region.
    module subroutine node_pieces(self, region, pieces, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: region
      integer(c_int32_t), allocatable, intent(out) :: pieces(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine node_pieces
    !> Number of the piece that a support holds; 0 if it holds nodes of several.
    module subroutine support_piece(self, support, number, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support
      integer(c_int32_t), intent(out) :: number
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine support_piece
    !> Number of the piece that a load acts on, also while it is 0; 0 if it acts on several.
    module subroutine load_piece(self, load, number, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: load
      integer(c_int32_t), intent(out) :: number
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine load_piece
    !> Whether two supports still hold the same piece.
    module subroutine are_connected(self, support, other, connected, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: support, other
      logical, intent(out) :: connected
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine are_connected
    !> The lattice of the patches of a body; 0 or absent: the library chooses.
    module subroutine set_body_lattice(self, body, spacing, horizon_ratio, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: body
      real(c_double), intent(in) :: spacing
      integer(c_int32_t), intent(in), optional :: horizon_ratio
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_body_lattice
    !> How a crack is modelled, a BEMPD_TREATMENT_ value, or that it stays as it is.
    module subroutine set_crack_treatment(self, crack, treatment, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: crack, treatment
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_crack_treatment
    !> Elements, unknowns, memory, time and errors of a scene with bodies, before anything expensive is solved.
    module subroutine plan(self, found, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_body_plan), intent(out) :: found
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine plan
    !> Errors of the present results by source.
    module subroutine error_estimate(self, errors, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_errors), intent(out) :: errors
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine error_estimate
    !> Errors of peak and paths of a run, which is run again if that takes at most `seconds_allowed`.
    module subroutine run_error_estimate(self, seconds_allowed, errors, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: seconds_allowed
      type(bempd_run_errors), intent(out) :: errors
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine run_error_estimate
    module subroutine get_statistics(self, statistics, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_statistics), intent(out) :: statistics
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine get_statistics
    !> All tips of cracks, as bempd_tip has them.
    module subroutine tips(self, found, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_crack_tip), allocatable, intent(out) :: found(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine tips
    !> The tips that were recorded, as bempd_get_tip_history has them: event number, bonds broken and load factor of each.
    module subroutine tip_history(self, found, events, broken_bonds, load_factors, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_crack_tip), allocatable, intent(out) :: found(:)
      integer(c_int64_t), allocatable, intent(out), optional :: events(:), broken_bonds(:)
      real(c_double), allocatable, intent(out), optional :: load_factors(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine tip_history
    module subroutine write_tips(self, path, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      character(*), intent(in) :: path
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine write_tips
    module subroutine grow_cracks(self, length, growth, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: length
      type(bempd_growth), intent(out), optional :: growth
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine grow_cracks
    !> A load case: loads and moved supports that act together, with their values at the load factor 1.
    module subroutine add_load_case(self, loads, supports, load_case, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in), optional :: loads(:), supports(:)
      integer(c_int32_t), intent(out), optional :: load_case
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine add_load_case
    module subroutine load_case_count(self, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine load_case_count
    !> Tips under a combination; factors(k) is that of the load case k.
    module subroutine combined_tips(self, factors, found, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: factors(:)
      type(bempd_crack_tip), allocatable, intent(out) :: found(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine combined_tips
    module subroutine combined_reaction(self, factors, support, force, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: factors(:)
      integer(c_int32_t), intent(in) :: support
      real(c_double), intent(out) :: force(2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine combined_reaction
    module subroutine combined_values(self, factors, points, displacement, stress, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: factors(:), points(:, :)
      real(c_double), allocatable, intent(out) :: displacement(:, :), stress(:, :)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine combined_values
    !> Places at which faces of cracks press on each other under a combination; where there is none, results add up.
    module subroutine pressed_faces(self, factors, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in) :: factors(:)
      integer(c_int64_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine pressed_faces
    !> Tips grow by lengths at the present load factor, whatever their load.
    module subroutine extend_cracks(self, cracks, ends, lengths, growth, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: cracks(:), ends(:)
      real(c_double), intent(in) :: lengths(:)
      type(bempd_growth), intent(out), optional :: growth
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine extend_cracks
    !> How far cracks in a material grow in a cycle of the loads; `rate` comes from bempd_growth_rate_init.
    module subroutine set_growth_rate(self, material, rate, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      type(bempd_growth_rate), intent(in) :: rate
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_growth_rate
    !> Cracks grow by cycles of the loads; one block may go without its number of cycles. `options` comes from
    !> bempd_fatigue_init.
    module subroutine grow_fatigue(self, high, low, cycles, options, report, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in), target, contiguous :: high(:), low(:)
      real(c_double), intent(in), target, contiguous, optional :: cycles(:)
      type(bempd_fatigue), intent(in), target, optional :: options
      type(bempd_fatigue_report), intent(out), optional :: report
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine grow_fatigue
    !> Cracks grow by cycles between combinations of load cases; factors have the shape (cases, blocks).
    module subroutine grow_fatigue_cases(self, high, low, cycles, options, report, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      real(c_double), intent(in), target, contiguous :: high(:, :), low(:, :)
      real(c_double), intent(in), target, contiguous, optional :: cycles(:)
      type(bempd_fatigue), intent(in), target, optional :: options
      type(bempd_fatigue_report), intent(out), optional :: report
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine grow_fatigue_cases
    !> A function gives the fracture energy that a tip in a material meets.
    module subroutine set_resistance_function(self, material, function, user, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: material
      procedure(bempd_growth_function) :: function
      type(c_ptr), intent(in), optional :: user
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_resistance_function
    !> Each tip at first and after every step of the last grow_fatigue.
    module subroutine fatigue_records(self, found, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_fatigue_record), allocatable, intent(out) :: found(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine fatigue_records
    module subroutine set_tip_frozen(self, crack, tip_end, frozen, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: crack, tip_end
      logical, intent(in) :: frozen
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine set_tip_frozen
    !> What every tip did in every call of grow_cracks, as bempd_extension has it.
    module subroutine extensions(self, found, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_crack_extension), allocatable, intent(out) :: found(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine extensions
    !> Number of cracks, described ones and those that began in the run.
    module subroutine crack_count(self, count, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int64_t), intent(out) :: count
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine crack_count
    !> Length of the path of a crack, or with 0 of all cracks together [m].
    module subroutine crack_length(self, crack, length, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: crack
      real(c_double), intent(out) :: length
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine crack_length
    !> Vertices of a crack from its start to its end, as bempd_crack_path has them.
    module subroutine crack_path(self, crack, vertices, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: crack
      type(bempd_path_vertex), allocatable, intent(out) :: vertices(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine crack_path
    module subroutine crack_opening(self, crack, fractions, normal, tangential, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int32_t), intent(in) :: crack
      real(c_double), intent(in) :: fractions(:)
      real(c_double), allocatable, intent(out), optional :: normal(:), tangential(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine crack_opening
    module subroutine history(self, entries, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      type(bempd_history_entry), allocatable, intent(out) :: entries(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine history
    !> What a support did at a line of the history, from 1, as bempd_get_history_support has it.
    module subroutine history_support(self, line, support, displacement, force, force_before, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      integer(c_int64_t), intent(in) :: line
      integer(c_int32_t), intent(in) :: support
      real(c_double), intent(out) :: displacement(2), force(2), force_before(2)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine history_support

    ! State and files.
    !> With values=.true. it contains those of loads and supports, which restoring brings back.
    module subroutine state_save(self, state, stat, errmsg, values)
      class(bempd_model), intent(inout) :: self
      class(bempd_state), intent(inout) :: state
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
      logical, intent(in), optional :: values
    end subroutine state_save
    module subroutine state_restore(self, state, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      class(bempd_state), intent(in) :: state
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine state_restore
    module subroutine write_snapshot(self, prefix, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      character(*), intent(in) :: prefix
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine write_snapshot
    module subroutine write_history(self, path, stat, errmsg)
      class(bempd_model), intent(inout) :: self
      character(*), intent(in) :: path
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine write_history

    module subroutine free(self)
      class(bempd_model), intent(inout) :: self
    end subroutine free
    impure elemental module subroutine finalize_model(self)
      type(bempd_model), intent(inout) :: self
    end subroutine finalize_model
    module subroutine refuse_copy(left, right)
      class(bempd_model), intent(inout) :: left
      type(bempd_model), intent(in) :: right
    end subroutine refuse_copy
    module subroutine free_state(self)
      class(bempd_state), intent(inout) :: self
    end subroutine free_state
    impure elemental module subroutine finalize_state(self)
      type(bempd_state), intent(inout) :: self
    end subroutine finalize_state
    module subroutine refuse_copy_of_state(left, right)
      class(bempd_state), intent(inout) :: left
      type(bempd_state), intent(in) :: right
    end subroutine refuse_copy_of_state
    module subroutine to_bytes(self, bytes, stat, errmsg)
      class(bempd_state), intent(in) :: self
      integer(c_int8_t), allocatable, intent(out) :: bytes(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine to_bytes
    module subroutine from_bytes(self, bytes, stat, errmsg)
      class(bempd_state), intent(inout) :: self
      integer(c_int8_t), intent(in) :: bytes(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine from_bytes
    !> A file that is there as a whole or not at all; one before it stays until then.
    module subroutine write_state_file(self, path, stat, errmsg)
      class(bempd_state), intent(in) :: self
      character(*), intent(in) :: path
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine write_state_file
    module subroutine read_state_file(self, path, stat, errmsg)
      class(bempd_state), intent(inout) :: self
      character(*), intent(in) :: path
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine read_state_file

    ! Options of the library, without a model.
    module subroutine bempd_get_options(options, stat, errmsg)
      type(bempd_option), allocatable, intent(out) :: options(:)
      integer, intent(out), optional :: stat
      character(*), intent(inout), optional :: errmsg
    end subroutine bempd_get_options
    module function bempd_version() result(text)
      character(:), allocatable :: text
    end function bempd_version
    module function bempd_build() result(text)
      character(:), allocatable :: text
    end function bempd_build
    module function bempd_status_word(status) result(text)
      integer, intent(in) :: status
      character(:), allocatable :: text
    end function bempd_status_word
    !> A zero-terminated string, such as the message that a log function receives.
    module function bempd_text(letters) result(text)
      character(kind=c_char), intent(in) :: letters(*)
      character(:), allocatable :: text
    end function bempd_text
  end interface
end module bempd
