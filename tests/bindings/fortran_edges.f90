!> Edges as hosts see them: nodes and forces, values at nodes and places, states with values.
program fortran_edges
  use fortran_checks
  use, intrinsic :: iso_c_binding, only: c_int32_t
  implicit none

  call forces_sum_to_the_reaction()
  call nodes_have_the_values_that_were_given()
  call forces_on_nodes_act()
  call states_contain_values_if_asked()
  call finish_checks()

contains

  subroutine forces_sum_to_the_reaction()
    type(bempd_model) :: model
    real(dp), allocatable :: forces(:, :), opposite(:, :)
    real(dp) :: reaction(2)
    character(200) :: message
    integer :: stat

    call make_strip(model)
    call model%step(2._dp)
    call model%edge_forces(3, 2, forces)
    call model%reaction(2, reaction)
    call check(reaction(1) > 1e-3_dp .and. abs(sum(forces(1, :)) - reaction(1)) <= 1e-12_dp * reaction(1), &
      "forces sum to the reaction")
    call model%edge_forces(2, 2, forces)
    call model%edge_forces(3, 4, opposite)
    call check(all(abs(forces + opposite(:, size(opposite, 2):1:-1)) < 1e-10_dp * reaction(1)), "both sides balance")
    call model%edge_forces(2, 1, forces, stat, message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "neither held")
  end subroutine forces_sum_to_the_reaction

  subroutine nodes_have_the_values_that_were_given()
    type(bempd_model) :: model
    integer(c_int32_t), allocatable :: nodes(:), elements(:)
    real(dp), allocatable :: fractions(:), weights(:), values(:, :), moved(:, :), distances(:)
    character(200) :: message
    integer :: stat

    call make_strip(model)
    call model%edge_nodes(3, 2, nodes, fractions, weights)
    call check(abs(sum(weights) - 2) < 1e-12_dp .and. minval(nodes) >= 1, "weights sum to the length")
    call model%edge_elements(3, 2, elements)
    call check(size(elements) == (size(nodes) - 1) / 2 .and. minval(elements) >= 1, "elements of the edge")
    allocate (values(2, size(nodes)), source=0._dp)
    values(1, :) = 1e-3_dp * (1 + fractions**2)
    call model%set_support_nodal_values(2, constant=values)
    call model%step(0._dp)
    call model%copy_field(3, BEMPD_DISPLACEMENT, moved)
    call check(all(abs(moved(1, nodes) - values(1, :)) <= 0), "nodes have their values")
    call model%set_support_values_at(2, [0._dp, 1._dp], constant=values(:, [1, size(nodes)]))
    call model%step_to_values(1._dp)
    call model%copy_field(3, BEMPD_DISPLACEMENT, moved)
    call check(all(abs(moved(1, nodes) - 1e-3_dp * (1 + fractions)) < 1e-17_dp), "and those between places")
    call model%fractions_on_edge(3, 2, reshape([6._dp, .5_dp, 7._dp, 1.5_dp], [2, 2]), fractions, distances)
    call check(abs(fractions(1) - .25_dp) < 1e-14_dp .and. abs(distances(2) - 1) < 1e-14_dp, "places of another mesh")
    call model%set_support_values_at(2, [0._dp], constant=values, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "fractions")
    call model%set_support_nodal_values(2, stat=stat, errmsg=message)
    call check_error(stat, BEMPD_ERROR_ARGUMENT, message, "neither a constant")
  end subroutine nodes_have_the_values_that_were_given

  subroutine forces_on_nodes_act()
    type(bempd_model) :: model
    real(dp), allocatable :: weights(:), forces(:, :)
    real(dp) :: reaction(2)
    integer(c_int32_t) :: load

    call make_strip(model)
    call model%add_edge_forces(3, 3, load=load)
    call model%edge_nodes(3, 3, weights=weights)
    allocate (forces(2, size(weights)), source=0._dp)
    forces(2, :) = .01_dp * weights
    call model%set_load_nodal_values(load, constant=forces)
    call model%step(0._dp)
    call model%reaction(1, reaction)
    call check(abs(reaction(2) + .02_dp) < 1e-10_dp, "forces on nodes act")
    call model%set_load_values_at(load, [.5_dp], proportional=reshape([0._dp, 0._dp], [2, 1]))
    call model%reaction(1, reaction)
    call check(abs(reaction(2)) < 1e-12_dp, "and give way to values at a place")
  end subroutine forces_on_nodes_act

  subroutine states_contain_values_if_asked()
    type(bempd_model) :: model
    type(bempd_state) :: with_values, without
    real(dp) :: before(2), after(2)
    character(200) :: message
    integer :: stat

    call make_strip(model)
    call model%step(1._dp)
    call model%reaction(2, before)
    call model%state_save(with_values, values=.true.)
    call model%state_save(without)
    call model%set_support_values(2, constant=[0._dp])
    call model%state_restore(without)
    call model%reaction(2, after)
    call check(abs(after(1)) < 1e-12_dp, "without values the present ones stay")
    call model%state_restore(with_values)
    call model%reaction(2, after)
    call check(abs(after(1) - before(1)) < 1e-12_dp * abs(before(1)), "with values they come back")
    call with_values%write_file("fortran_edges.state")
    call with_values%read_file("no_such.state", stat, message)
    call check_error(stat, BEMPD_ERROR_IO, message, "cannot read no_such.state")
    call with_values%read_file("fortran_edges.state")
    call model%set_support_values(2, constant=[0._dp])
    call model%state_restore(with_values)
    call model%reaction(2, after)
    call check(abs(after(1) - before(1)) < 1e-12_dp * abs(before(1)), "from a file too")
    call without%write_file("no_such_folder/a.state", stat, message)
    call check_error(stat, BEMPD_ERROR_IO, message, "no_such_folder")
  end subroutine states_contain_values_if_asked

end program fortran_edges
