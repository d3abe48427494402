!> Edges of the module bempd, for hosts that couple: values, nodes and forces.
submodule (bempd:bempd_support) bempd_edges
  implicit none
contains

  !> Whether both parts are (2,n) with the same n; they are copied to where C can read them, with 0 for a missing part.
  logical function are_pairs(self, procedure_name, constant, proportional, parts, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    character(*), intent(in) :: procedure_name
    real(c_double), intent(in), optional :: constant(:, :), proportional(:, :)
    type(value_parts), intent(out) :: parts
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    are_pairs = .false.
    if (present(constant)) then
      if (.not. are_points(self, procedure_name, "constant", constant, stat, errmsg)) return
      parts%constant = reshape(constant, [size(constant)])
    end if
    if (present(proportional)) then
      if (.not. are_points(self, procedure_name, "proportional", proportional, stat, errmsg)) return
      parts%proportional = reshape(proportional, [size(proportional)])
    end if
    if (.not. allocated(parts%constant)) then
      if (.not. allocated(parts%proportional)) then
        call refuse(self, procedure_name // ": there is neither a constant nor a proportional part; give one", stat, errmsg)
        return
      end if
      parts%constant = 0 * parts%proportional
    end if
    if (.not. allocated(parts%proportional)) parts%proportional = 0 * parts%constant
    parts%count = size(parts%constant)
    are_pairs = size(parts%proportional) == parts%count
    if (.not. are_pairs) call refuse(self, procedure_name // ": constant and proportional have different shapes; " // &
      "give as many of both, or leave one out", stat, errmsg)
  end function are_pairs

  !> Whether the values are pairs with a column for each fraction.
  logical function are_pairs_at(self, procedure_name, fractions, constant, proportional, parts, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    character(*), intent(in) :: procedure_name
    real(c_double), intent(in) :: fractions(:)
    real(c_double), intent(in), optional :: constant(:, :), proportional(:, :)
    type(value_parts), intent(out) :: parts
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    are_pairs_at = are_pairs(self, procedure_name, constant, proportional, parts, stat, errmsg)
    if (.not. are_pairs_at) return
    are_pairs_at = parts%count == 2 * size(fractions)
    if (.not. are_pairs_at) call refuse(self, procedure_name // ": there are values for another number of places than " // &
      "fractions; give a column of values for each fraction", stat, errmsg)
  end function are_pairs_at

  module procedure add_edge_forces
    integer(c_int32_t), target :: new

    new = 0
    call finish(self, bempd_add_edge_forces(self%handle, region, edge, value_or(from, 0.0_c_double), &
      value_or(to, 1.0_c_double), c_loc(new)), stat, errmsg)
    call give(new, load)
  end procedure add_edge_forces

  module procedure set_support_nodal_values
    type(value_parts), target :: parts

    if (.not. are_pairs(self, "bempd_set_support_nodal_values", constant, proportional, parts, stat, errmsg)) return
    call finish(self, bempd_set_support_nodal_values(self%handle, support, parts%count / 2, &
      c_loc(parts%constant), c_loc(parts%proportional)), stat, errmsg)
  end procedure set_support_nodal_values

  module procedure set_load_nodal_values
    type(value_parts), target :: parts

    if (.not. are_pairs(self, "bempd_set_load_nodal_values", constant, proportional, parts, stat, errmsg)) return
    call finish(self, bempd_set_load_nodal_values(self%handle, load, parts%count / 2, &
      c_loc(parts%constant), c_loc(parts%proportional)), stat, errmsg)
  end procedure set_load_nodal_values

  module procedure set_support_values_at
    type(value_parts), target :: parts

    if (.not. are_pairs_at(self, "bempd_set_support_values_at", fractions, constant, proportional, parts, stat, errmsg)) return
    call finish(self, bempd_set_support_values_at(self%handle, support, size(fractions, kind=c_int64_t), fractions, &
      c_loc(parts%constant), c_loc(parts%proportional)), stat, errmsg)
  end procedure set_support_values_at

  module procedure set_load_values_at
    type(value_parts), target :: parts

    if (.not. are_pairs_at(self, "bempd_set_load_values_at", fractions, constant, proportional, parts, stat, errmsg)) return
    call finish(self, bempd_set_load_values_at(self%handle, load, size(fractions, kind=c_int64_t), fractions, &
      c_loc(parts%constant), c_loc(parts%proportional)), stat, errmsg)
  end procedure set_load_values_at

  module procedure fractions_on_edge
    real(c_double), allocatable, target :: s(:), d(:)
    integer(c_int64_t) :: count

    if (.not. are_points(self, "bempd_fractions_on_edge", "points", points, stat, errmsg)) return
    count = size(points, 2)
    allocate (s(count), d(count), source=0.0_c_double)
    call finish(self, bempd_fractions_on_edge(self%handle, region, edge, count, points, c_loc(s), c_loc(d)), stat, errmsg)
    if (present(fractions)) call move_alloc(s, fractions)
    if (present(distances)) call move_alloc(d, distances)
  end procedure fractions_on_edge

  module procedure edge_nodes
    integer(c_int64_t), target :: count
    integer(c_int32_t), allocatable, target :: entries(:)
    real(c_double), allocatable, target :: s(:), w(:)
    integer(c_int) :: status

    count = 0
    status = bempd_edge_size(self%handle, region, edge, c_loc(count), c_null_ptr)
    allocate (entries(count))
    allocate (s(count), w(count), source=0.0_c_double)
    entries = -1
    if (status == BEMPD_OK) status = bempd_copy_edge_nodes(self%handle, region, edge, count, c_loc(entries), c_loc(s), &
      c_loc(w))
    call finish(self, status, stat, errmsg)
    entries = entries + 1
    if (present(nodes)) call move_alloc(entries, nodes)
    if (present(fractions)) call move_alloc(s, fractions)
    if (present(weights)) call move_alloc(w, weights)
  end procedure edge_nodes

  module procedure edge_elements
    integer(c_int64_t), target :: count
    integer(c_int) :: status

    count = 0
    status = bempd_edge_size(self%handle, region, edge, c_null_ptr, c_loc(count))
    allocate (elements(count))
    elements = -1
    if (status == BEMPD_OK) status = bempd_copy_edge_elements(self%handle, region, edge, count, elements)
    call finish(self, status, stat, errmsg)
    elements = elements + 1
  end procedure edge_elements

  module procedure edge_forces
    integer(c_int64_t), target :: count
    integer(c_int) :: status

    count = 0
    status = bempd_edge_size(self%handle, region, edge, c_loc(count), c_null_ptr)
    allocate (forces(2, count), source=0.0_c_double)
    if (status == BEMPD_OK) status = bempd_copy_edge_forces(self%handle, region, edge, count, forces)
    call finish(self, status, stat, errmsg)
  end procedure edge_forces

end submodule bempd_edges
