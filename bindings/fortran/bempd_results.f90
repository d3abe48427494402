!> Stepping, results, state and files of the module bempd.
submodule (bempd:bempd_support) bempd_results
  implicit none
contains

  module procedure prepare
    call finish(self, bempd_prepare(self%handle), stat, errmsg)
  end procedure prepare

  module procedure step
    type(bempd_step_report), target :: done
    integer(c_int) :: status

    status = bempd_step_report_init(done, c_sizeof(done))
    call finish(self, bempd_step(self%handle, load_factor, c_loc(done)), stat, errmsg)
    if (present(report)) report = done
  end procedure step

  module procedure step_to_next_event
    type(bempd_step_report), target :: done
    integer(c_int) :: status

    status = bempd_step_report_init(done, c_sizeof(done))
    call finish(self, bempd_step_to_next_event(self%handle, load_factor_limit, c_loc(done)), stat, errmsg)
    if (present(report)) report = done
  end procedure step_to_next_event

  module procedure run_to_separation
    type(bempd_step_report), target :: done
    integer(c_int) :: status

    status = bempd_step_report_init(done, c_sizeof(done))
    call finish(self, bempd_run_to_separation(self%handle, load_factor_limit, c_loc(done)), stat, errmsg)
    if (present(report)) report = done
  end procedure run_to_separation

  module procedure step_to_values
    type(bempd_step_report), target :: done
    integer(c_int32_t) :: goal
    integer(c_int) :: status

    goal = BEMPD_UNTIL_VALUES
    if (present(until)) goal = until
    status = bempd_step_report_init(done, c_sizeof(done))
    call finish(self, bempd_step_to_values(self%handle, load_factor, goal, c_loc(done)), stat, errmsg)
    if (present(report)) report = done
  end procedure step_to_values

  module procedure run_program
    type(bempd_step_report), target :: done
    integer(c_int32_t), allocatable, target :: kind_of(:), id_of(:)
    integer(c_int64_t) :: columns
    integer(c_int32_t) :: goal
    integer(c_int) :: status

    goal = BEMPD_UNTIL_VALUES
    if (present(until)) goal = until
    allocate (kind_of(1), id_of(1))
    columns = 0
    if (present(ids) .and. present(kinds)) then
      kind_of = kinds
      id_of = ids
      columns = size(ids, kind=c_int64_t)
    end if
    status = bempd_step_report_init(done, c_sizeof(done))
    if (size(factors, 2) /= size(times) .or. size(factors, 1) /= max(1_c_int64_t, columns) .or. &
        size(kind_of) /= size(id_of) .or. (present(ids) .neqv. present(kinds))) then
      call refuse(self, "run_program: give a kind and an id for each column, and factors(column, row) for each time", stat, errmsg)
      return
    end if
    call finish(self, bempd_run_program(self%handle, size(times, kind=c_int64_t), times, columns, c_loc(kind_of), &
      c_loc(id_of), factors, goal, c_loc(done)), stat, errmsg)
    if (present(report)) report = done
  end procedure run_program

  module procedure load_factor
    value = 0
    call finish(self, bempd_load_factor(self%handle, value), stat, errmsg)
  end procedure load_factor

  module procedure admissible_load_factors
    lowest = 0
    highest = 0
    call finish(self, bempd_admissible_load_factors(self%handle, lowest, highest), stat, errmsg)
  end procedure admissible_load_factors

  module procedure explain
    character(kind=c_char), allocatable, target :: letters(:)
    integer(c_int64_t), target :: needed
    type(bempd_explanation), target :: found
    integer(c_int) :: status, way

    text = ""
    needed = 0
    way = 1
    if (present(rising)) way = merge(1_c_int, 0_c_int, rising)
    status = bempd_explanation_init(found, c_sizeof(found))
    if (status == BEMPD_OK) &
      status = bempd_explain(self%handle, way, c_loc(found), c_null_ptr, 0_c_int64_t, c_loc(needed))
    if (status == BEMPD_OK) then
      allocate (letters(needed))
      status = bempd_explain(self%handle, way, c_null_ptr, c_loc(letters), needed, c_null_ptr)
      if (status == BEMPD_OK) text = bempd_text(letters)
    end if
    if (present(explanation)) explanation = found
    call finish(self, status, stat, errmsg)
  end procedure explain

  module procedure generation
    number = 0
    call finish(self, bempd_generation(self%handle, number), stat, errmsg)
  end procedure generation

  module procedure region_count
    count = 0
    call finish(self, bempd_region_count(self%handle, count), stat, errmsg)
  end procedure region_count

  module procedure edge_count
    count = 0
    call finish(self, bempd_edge_count(self%handle, region, count), stat, errmsg)
  end procedure edge_count

  module procedure name_region
    call finish(self, bempd_name_region(self%handle, region, c_string(name)), stat, errmsg)
  end procedure name_region

  module procedure name_edge
    call finish(self, bempd_name_edge(self%handle, region, edge, c_string(name)), stat, errmsg)
  end procedure name_edge

  module procedure name_support
    call finish(self, bempd_name_support(self%handle, support, c_string(name)), stat, errmsg)
  end procedure name_support

  module procedure name_load
    call finish(self, bempd_name_load(self%handle, load, c_string(name)), stat, errmsg)
  end procedure name_load

  module procedure edge_named
    edge = 0
    call finish(self, bempd_edge_named(self%handle, region, c_string(name), edge), stat, errmsg)
  end procedure edge_named

  module procedure node_count
    count = 0
    call finish(self, bempd_node_count(self%handle, region, count), stat, errmsg)
  end procedure node_count

  module procedure element_count
    count = 0
    call finish(self, bempd_element_count(self%handle, region, count), stat, errmsg)
  end procedure element_count

  module procedure bond_count
    count = 0
    call finish(self, bempd_bond_count(self%handle, region, count), stat, errmsg)
  end procedure bond_count

  module procedure reaction
    force = 0
    call finish(self, bempd_reaction(self%handle, support, force), stat, errmsg)
  end procedure reaction

  module procedure reaction_moment
    moment = 0
    call finish(self, bempd_reaction_moment(self%handle, support, x, y, moment), stat, errmsg)
  end procedure reaction_moment

  module procedure plan
    integer(c_int) :: status

    status = bempd_body_plan_init(found, c_sizeof(found))
    call finish(self, bempd_plan(self%handle, found), stat, errmsg)
  end procedure plan

  module procedure error_estimate
    integer(c_int) :: status

    status = bempd_errors_init(errors, c_sizeof(errors))
    call finish(self, bempd_error_estimate(self%handle, errors), stat, errmsg)
  end procedure error_estimate

  module procedure run_error_estimate
    integer(c_int) :: status

    status = bempd_run_errors_init(errors, c_sizeof(errors))
    call finish(self, bempd_run_error_estimate(self%handle, seconds_allowed, errors), stat, errmsg)
  end procedure run_error_estimate

  module procedure get_statistics
    integer(c_int) :: status

    status = bempd_statistics_init(statistics, c_sizeof(statistics))
    call finish(self, bempd_get_statistics(self%handle, statistics), stat, errmsg)
  end procedure get_statistics

  module procedure write_snapshot
    call finish(self, bempd_write_snapshot(self%handle, c_string(prefix)), stat, errmsg)
  end procedure write_snapshot

  module procedure history_support
    real(c_double), target :: values(2, 3)

    values = 0
    call finish(self, bempd_get_history_support(self%handle, line - 1, support, c_loc(values(1, 1)), c_loc(values(1, 2)), &
      c_loc(values(1, 3))), stat, errmsg)
    displacement = values(:, 1)
    force = values(:, 2)
    force_before = values(:, 3)
  end procedure history_support

  module procedure write_history
    call finish(self, bempd_write_history(self%handle, c_string(path)), stat, errmsg)
  end procedure write_history

  module procedure state_save
    logical :: with_values

    with_values = .false.
    if (present(values)) with_values = values
    call state%free()
    if (with_values) then
      call finish(self, bempd_state_save_with(self%handle, BEMPD_STATE_BODY_AND_VALUES, state%handle), stat, errmsg)
    else
      call finish(self, bempd_state_save(self%handle, state%handle), stat, errmsg)
    end if
  end procedure state_save

  module procedure state_restore
    call finish(self, bempd_state_restore(self%handle, state%handle), stat, errmsg)
  end procedure state_restore

  module procedure copy_field
    integer(c_int64_t), target :: count
    integer(c_int32_t), target :: components
    integer(c_int) :: status

    count = 0
    components = 0
    status = bempd_field_size(self%handle, region, field, c_loc(count), c_loc(components))
    allocate (values(components, count))
    if (status == BEMPD_OK) status = bempd_copy_field(self%handle, region, field, size(values, kind=c_int64_t), values)
    call finish(self, status, stat, errmsg)
  end procedure copy_field

  module procedure fill_field
    integer(c_int64_t), target :: count
    integer(c_int32_t), target :: components
    integer(c_int) :: status
    character(200) :: sentence

    count = 0
    components = 0
    status = bempd_field_size(self%handle, region, field, c_loc(count), c_loc(components))
    if (status == BEMPD_OK .and. any(shape(values, c_int64_t) /= [int(components, c_int64_t), count])) then
      write (sentence, '(4(a, i0), a)') "fill_field: values has the shape (", size(values, 1), ",", size(values, 2), &
        "); the field has (", components, ",", count, "); give an array of this shape"
      call refuse(self, trim(sentence), stat, errmsg)
      return
    end if
    if (status == BEMPD_OK) status = bempd_copy_field(self%handle, region, field, size(values, kind=c_int64_t), values)
    call finish(self, status, stat, errmsg)
  end procedure fill_field

  module procedure view_field
    type(c_ptr) :: address
    integer(c_int64_t), target :: count, stamp
    integer(c_int32_t), target :: components
    integer(c_int) :: status

    nullify (values)
    stamp = 0
    address = c_null_ptr
    status = bempd_view_field(self%handle, region, field, address, c_loc(count), c_loc(components), c_loc(stamp))
    if (status == BEMPD_OK .and. c_associated(address)) &
      call c_f_pointer(address, values, [int(components, c_int64_t), count])
    if (present(generation)) generation = stamp
    call finish(self, status, stat, errmsg)
  end procedure view_field

  module procedure copy_elements
    integer(c_int64_t) :: count, bonds
    integer(c_int) :: status
    integer :: corners

    ! Only lattices have bonds: their cells have four corners, a boundary element has three nodes.
    count = 0
    corners = merge(4, 3, bempd_bond_count(self%handle, region, bonds) == BEMPD_OK)
    status = bempd_element_count(self%handle, region, count)
    allocate (nodes(corners, count), source=0_c_int32_t)
    if (status == BEMPD_OK) status = bempd_copy_elements(self%handle, region, size(nodes, kind=c_int64_t), nodes)
    nodes = nodes + 1
    call finish(self, status, stat, errmsg)
  end procedure copy_elements

  module procedure copy_bonds
    integer(c_int32_t), allocatable, target :: ends(:, :), all_states(:)
    integer(c_int64_t) :: count
    integer(c_int) :: status

    count = 0
    status = bempd_bond_count(self%handle, region, count)
    allocate (ends(2, count), all_states(count))
    if (status == BEMPD_OK) status = bempd_copy_bonds(self%handle, region, count, c_loc(ends), c_loc(all_states))
    points = ends + 1
    if (present(states)) states = all_states
    call finish(self, status, stat, errmsg)
  end procedure copy_bonds

  module procedure evaluate
    real(c_double), allocatable, target :: u(:, :), s(:, :)
    integer(c_int32_t), allocatable, target :: ids(:)
    integer(c_int64_t) :: count

    if (.not. are_points(self, "bempd_evaluate", "points", points, stat, errmsg)) return
    count = size(points, 2)
    allocate (u(2, count), s(3, count), source=0.0_c_double)
    allocate (ids(count), source=0_c_int32_t)
    call finish(self, bempd_evaluate(self%handle, count, points, merge(c_loc(u), c_null_ptr, present(displacement)), &
      merge(c_loc(s), c_null_ptr, present(stress)), c_loc(ids)), stat, errmsg)
    if (present(displacement)) call move_alloc(u, displacement)
    if (present(stress)) call move_alloc(s, stress)
    if (present(regions)) call move_alloc(ids, regions)
  end procedure evaluate

  module procedure edge_reaction
    real(c_double), target :: f(2), m

    f = 0
    m = 0
    call finish(self, bempd_edge_reaction(self%handle, region, edge, x, y, c_loc(f), c_loc(m)), stat, errmsg)
    force = f
    moment = m
  end procedure edge_reaction

  module procedure evaluate_in
    real(c_double), allocatable, target :: u(:, :), s(:, :)
    integer(c_int64_t) :: count
    integer(c_int32_t) :: side

    if (.not. are_points(self, "bempd_evaluate_in", "points", points, stat, errmsg)) return
    side = BEMPD_FACE_LEFT
    if (present(face)) side = face
    count = size(points, 2)
    allocate (u(2, count), s(3, count), source=0.0_c_double)
    call finish(self, bempd_evaluate_in(self%handle, region, side, count, points, &
      merge(c_loc(u), c_null_ptr, present(displacement)), merge(c_loc(s), c_null_ptr, present(stress))), stat, errmsg)
    if (present(displacement)) call move_alloc(u, displacement)
    if (present(stress)) call move_alloc(s, stress)
  end procedure evaluate_in

  module procedure stress_orders
    if (.not. are_points(self, "bempd_stress_orders", "points", points, stat, errmsg)) return
    allocate (orders(size(points, 2)), source=0.0_c_double)
    call finish(self, bempd_stress_orders(self%handle, size(points, 2, c_int64_t), points, orders), stat, errmsg)
  end procedure stress_orders

  module procedure evaluate_errors
    real(c_double), allocatable, target :: u(:), s(:)

    if (.not. are_points(self, "bempd_evaluate_errors", "points", points, stat, errmsg)) return
    allocate (u(size(points, 2)), s(size(points, 2)), source=0.0_c_double)
    call finish(self, bempd_evaluate_errors(self%handle, size(points, 2, c_int64_t), points, c_loc(u), c_loc(s)), &
      stat, errmsg)
    call move_alloc(u, displacement)
    call move_alloc(s, stress)
  end procedure evaluate_errors

  module procedure singularities
    integer(c_int64_t) :: count, k
    integer(c_int) :: status

    count = 0
    status = bempd_singularity_count(self%handle, count)
    allocate (found(count))
    do k = 1, count
      status = bempd_singularity_init(found(k), c_sizeof(found(k)))
      status = bempd_get_singularity(self%handle, k - 1, found(k))
      if (status /= BEMPD_OK) exit
    end do
    call finish(self, status, stat, errmsg)
  end procedure singularities

  module procedure piece_count
    count = 0
    call finish(self, bempd_piece_count(self%handle, count), stat, errmsg)
  end procedure piece_count

  module procedure piece
    integer(c_int) :: status

    status = bempd_piece_init(found, c_sizeof(found))
    call finish(self, bempd_get_piece(self%handle, number, found), stat, errmsg)
  end procedure piece

  module procedure node_pieces
    integer(c_int64_t) :: count
    integer(c_int) :: status

    count = 0
    status = bempd_node_count(self%handle, region, count)
    allocate (pieces(count))
    pieces = 0
    if (status == BEMPD_OK) status = bempd_copy_node_pieces(self%handle, region, count, pieces)
    call finish(self, status, stat, errmsg)
  end procedure node_pieces

  module procedure support_piece
    number = 0
    call finish(self, bempd_support_piece(self%handle, support, number), stat, errmsg)
  end procedure support_piece

  module procedure load_piece
    number = 0
    call finish(self, bempd_load_piece(self%handle, load, number), stat, errmsg)
  end procedure load_piece

  module procedure are_connected
    integer(c_int32_t) :: answer

    answer = 0
    call finish(self, bempd_are_connected(self%handle, support, other, answer), stat, errmsg)
    connected = answer /= 0
  end procedure are_connected

  module procedure tips
    integer(c_int64_t) :: count, k
    integer(c_int) :: status

    count = 0
    status = bempd_tip_count(self%handle, count)
    allocate (found(count))
    do k = 1, count
      status = bempd_crack_tip_init(found(k), c_sizeof(found(k)))
      status = bempd_tip(self%handle, k - 1, found(k))
      if (status /= BEMPD_OK) exit
    end do
    call finish(self, status, stat, errmsg)
  end procedure tips

  module procedure tip_history
    integer(c_int64_t), allocatable, target :: event(:), broken(:)
    real(c_double), allocatable, target :: factor(:)
    integer(c_int64_t) :: count, k
    integer(c_int) :: status

    count = 0
    status = bempd_tip_history_count(self%handle, count)
    allocate (found(count), event(count), broken(count), factor(count))
    do k = 1, count
      status = bempd_crack_tip_init(found(k), c_sizeof(found(k)))
      status = bempd_get_tip_history(self%handle, k - 1, c_loc(event(k)), c_loc(broken(k)), c_loc(factor(k)), found(k))
      if (status /= BEMPD_OK) exit
    end do
    if (present(events)) call move_alloc(event, events)
    if (present(broken_bonds)) call move_alloc(broken, broken_bonds)
    if (present(load_factors)) call move_alloc(factor, load_factors)
    call finish(self, status, stat, errmsg)
  end procedure tip_history

  module procedure write_tips
    call finish(self, bempd_write_tips(self%handle, c_string(path)), stat, errmsg)
  end procedure write_tips

  module procedure grow_cracks
    type(bempd_growth), target :: done
    integer(c_int) :: status

    status = bempd_growth_init(done, c_sizeof(done))
    call finish(self, bempd_grow_cracks(self%handle, length, c_loc(done)), stat, errmsg)
    if (present(growth)) growth = done
  end procedure grow_cracks

  module procedure add_load_case
    integer(c_int32_t), allocatable, target :: load_ids(:), support_ids(:)
    integer(c_int32_t), target :: new

    new = 0
    allocate (load_ids(0), support_ids(0))
    if (present(loads)) load_ids = loads
    if (present(supports)) support_ids = supports
    call finish(self, bempd_load_case_add(self%handle, size(load_ids, kind=c_int64_t), c_loc(load_ids), &
      size(support_ids, kind=c_int64_t), c_loc(support_ids), c_loc(new)), stat, errmsg)
    if (present(load_case)) load_case = new
  end procedure add_load_case

  module procedure load_case_count
    count = 0
    call finish(self, bempd_load_case_count(self%handle, count), stat, errmsg)
  end procedure load_case_count

  module procedure combined_tips
    integer(c_int64_t) :: count, k, cases
    integer(c_int) :: status

    count = 0
    cases = size(factors, kind=c_int64_t)
    status = bempd_load_case_tip_count(self%handle, cases, factors, count)
    allocate (found(count))
    do k = 1, count
      status = bempd_crack_tip_init(found(k), c_sizeof(found(k)))
      status = bempd_load_case_tip(self%handle, cases, factors, k - 1, found(k))
      if (status /= BEMPD_OK) exit
    end do
    call finish(self, status, stat, errmsg)
  end procedure combined_tips

  module procedure combined_reaction
    force = 0
    call finish(self, bempd_load_case_reaction(self%handle, size(factors, kind=c_int64_t), factors, support, force), stat, &
      errmsg)
  end procedure combined_reaction

  module procedure combined_values
    real(c_double), allocatable, target :: u(:, :), s(:, :)

    if (.not. are_points(self, "bempd_load_case_evaluate", "points", points, stat, errmsg)) return
    allocate (u(2, size(points, 2)), s(3, size(points, 2)), source=0.0_c_double)
    call finish(self, bempd_load_case_evaluate(self%handle, size(factors, kind=c_int64_t), factors, &
      size(points, 2, c_int64_t), points, c_loc(u), c_loc(s)), stat, errmsg)
    call move_alloc(u, displacement)
    call move_alloc(s, stress)
  end procedure combined_values

  module procedure pressed_faces
    count = 0
    call finish(self, bempd_load_case_pressed_faces(self%handle, size(factors, kind=c_int64_t), factors, count), stat, errmsg)
  end procedure pressed_faces

  module procedure extend_cracks
    type(bempd_growth), target :: done
    integer(c_int) :: status

    status = bempd_growth_init(done, c_sizeof(done))
    call finish(self, bempd_extend_cracks(self%handle, size(lengths, kind=c_int64_t), cracks, ends, lengths, &
      c_loc(done)), stat, errmsg)
    if (present(growth)) growth = done
  end procedure extend_cracks

  module procedure set_growth_rate
    call finish(self, bempd_set_growth_rate(self%handle, material, rate), stat, errmsg)
  end procedure set_growth_rate

  module procedure grow_fatigue
    type(bempd_fatigue_report), target :: done
    type(c_ptr) :: counts, asked
    integer(c_int) :: status

    status = bempd_fatigue_report_init(done, c_sizeof(done))
    counts = c_null_ptr
    if (present(cycles)) counts = c_loc(cycles)
    asked = c_null_ptr
    if (present(options)) asked = c_loc(options)
    call finish(self, bempd_grow_fatigue(self%handle, size(high, kind=c_int64_t), high, low, counts, asked, &
      c_loc(done)), stat, errmsg)
    if (present(report)) report = done
  end procedure grow_fatigue

  module procedure grow_fatigue_cases
    type(bempd_fatigue_report), target :: done
    type(c_ptr) :: counts, asked
    integer(c_int) :: status

    status = bempd_fatigue_report_init(done, c_sizeof(done))
    counts = c_null_ptr
    if (present(cycles)) counts = c_loc(cycles)
    asked = c_null_ptr
    if (present(options)) asked = c_loc(options)
    call finish(self, bempd_grow_fatigue_cases(self%handle, size(high, 2, kind=c_int64_t), &
      size(high, 1, kind=c_int64_t), high, low, counts, asked, c_loc(done)), stat, errmsg)
    if (present(report)) report = done
  end procedure grow_fatigue_cases

  module procedure set_resistance_function
    type(c_ptr) :: handed

    handed = c_null_ptr
    if (present(user)) handed = user
    call finish(self, bempd_set_resistance_function(self%handle, material, c_funloc(function), handed), stat, errmsg)
  end procedure set_resistance_function

  module procedure fatigue_records
    integer(c_int64_t) :: count, k
    integer(c_int) :: status

    count = 0
    status = bempd_fatigue_record_count(self%handle, count)
    allocate (found(count))
    do k = 1, count
      status = bempd_fatigue_record_init(found(k), c_sizeof(found(k)))
      status = bempd_get_fatigue_record(self%handle, k - 1, found(k))
      if (status /= BEMPD_OK) exit
    end do
    call finish(self, status, stat, errmsg)
  end procedure fatigue_records

  module procedure set_tip_frozen
    call finish(self, bempd_set_tip_frozen(self%handle, crack, tip_end, merge(1_c_int32_t, 0_c_int32_t, frozen)), stat, &
      errmsg)
  end procedure set_tip_frozen

  module procedure extensions
    integer(c_int64_t) :: count, k
    integer(c_int) :: status

    count = 0
    status = bempd_extension_count(self%handle, count)
    allocate (found(count))
    do k = 1, count
      status = bempd_crack_extension_init(found(k), c_sizeof(found(k)))
      status = bempd_extension(self%handle, k - 1, found(k))
      if (status /= BEMPD_OK) exit
    end do
    call finish(self, status, stat, errmsg)
  end procedure extensions

  module procedure crack_count
    count = 0
    call finish(self, bempd_crack_count(self%handle, count), stat, errmsg)
  end procedure crack_count

  module procedure crack_length
    length = 0
    call finish(self, bempd_crack_length(self%handle, crack, length), stat, errmsg)
  end procedure crack_length

  module procedure crack_path
    integer(c_int64_t) :: count, k
    integer(c_int) :: status

    count = 0
    status = bempd_crack_path_count(self%handle, crack, count)
    allocate (vertices(count))
    do k = 1, count
      status = bempd_path_vertex_init(vertices(k), c_sizeof(vertices(k)))
      status = bempd_crack_path(self%handle, crack, k - 1, vertices(k))
      if (status /= BEMPD_OK) exit
    end do
    call finish(self, status, stat, errmsg)
  end procedure crack_path

  module procedure crack_opening
    real(c_double), allocatable, target :: n(:), t(:)

    allocate (n(size(fractions)), t(size(fractions)), source=0.0_c_double)
    call finish(self, bempd_crack_opening(self%handle, crack, size(fractions, kind=c_int64_t), fractions, c_loc(n), &
      c_loc(t)), stat, errmsg)
    if (present(normal)) call move_alloc(n, normal)
    if (present(tangential)) call move_alloc(t, tangential)
  end procedure crack_opening

  module procedure history
    integer(c_int64_t) :: count, k
    integer(c_int) :: status

    count = 0
    status = bempd_history_count(self%handle, count)
    allocate (entries(count))
    do k = 1, count
      status = bempd_history_entry_init(entries(k), c_sizeof(entries(k)))
      status = bempd_get_history_entry(self%handle, k - 1, entries(k))
      if (status /= BEMPD_OK) exit
    end do
    call finish(self, status, stat, errmsg)
  end procedure history

  module procedure to_bytes
    integer(c_int8_t), allocatable, target :: buffer(:)
    integer(c_int64_t), target :: needed
    integer(c_int) :: status

    needed = 0
    status = bempd_state_to_bytes(self%handle, 0_c_int64_t, c_null_ptr, c_loc(needed))
    allocate (buffer(needed))
    if (status == BEMPD_OK) status = bempd_state_to_bytes(self%handle, needed, c_loc(buffer), c_null_ptr)
    call move_alloc(buffer, bytes)
    call conclude(status, text_at(bempd_last_error(c_null_ptr)), stat, errmsg)
  end procedure to_bytes

  module procedure from_bytes
    integer(c_int) :: status

    call self%free()
    status = bempd_state_from_bytes(size(bytes, kind=c_int64_t), bytes, self%handle)
    call conclude(status, text_at(bempd_last_error(c_null_ptr)), stat, errmsg)
  end procedure from_bytes

  module procedure write_state_file
    integer(c_int) :: status

    status = bempd_state_write(self%handle, c_string(path))
    call conclude(status, text_at(bempd_last_error(c_null_ptr)), stat, errmsg)
  end procedure write_state_file

  module procedure read_state_file
    integer(c_int) :: status

    call self%free()
    status = bempd_state_read(c_string(path), self%handle)
    call conclude(status, text_at(bempd_last_error(c_null_ptr)), stat, errmsg)
  end procedure read_state_file
end submodule bempd_results
