!> A host in Fortran over two ranks: rank 0 has the model, the other serves.
program host
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
  use mpi
  use bempd
  use bempd_mpi
  implicit none
  integer, parameter :: events = 20
  integer :: rank, level, error, status
  character(200) :: sentence

  call MPI_Init_thread(MPI_THREAD_FUNNELED, level, error)
  call MPI_Comm_rank(MPI_COMM_WORLD, rank, error)
  if (rank == 0) then
    call mpi_serve(MPI_COMM_WORLD, status, sentence)
    if (status /= BEMPD_ERROR_ARGUMENT .or. index(sentence, "bempd_mpi_attach") == 0) error stop "rank 0 may serve"
    call compare()
  else
    call mpi_serve(MPI_COMM_WORLD)
  end if
  call MPI_Finalize(error)

contains

  subroutine build(model)
    type(bempd_model), intent(inout) :: model
    integer(c_int32_t) :: solid, region
    real(c_double), parameter :: corners(2, 4) = reshape([0d0, 0d0, 0.03d0, 0d0, 0.03d0, 0.02d0, 0d0, 0.02d0], [2, 4])

    call model%create()
    call model%set_option("crack.rule", "bond")
    call model%add_material(3d9, 1d0 / 3, solid, fracture_energy=300d0)
    call model%add_pd_region(solid, corners, 0.001d0, 4, region)
    call model%add_crack(reshape([0.0145d0, 0d0, 0.0145d0, 0.006d0], [2, 2]))
    call model%fix_edge(region, 4, BEMPD_BOTH)
    call model%prescribe_edge(region, 2, BEMPD_X, proportional=[1d-6])
  end subroutine build

  subroutine compare()
    type(bempd_model) :: with, without
    type(bempd_step_report) :: here, there
    real(c_double) :: at, other
    integer :: k

    call build(with)
    call build(without)
    call mpi_attach(with, MPI_COMM_WORLD)
    do k = 1, events
      call with%step_to_next_event(1d6, here)
      call without%step_to_next_event(1d6, there)
      if (here%broken_bonds /= there%broken_bonds .or. here%broken_bonds == 0) error stop "other bonds break"
      call with%load_factor(at)
      call without%load_factor(other)
      if (abs(at - other) > 1d-9 * other) error stop "at other loads"
    end do
    call mpi_detach(with)
    print '(a)', "the same bonds break"
  end subroutine compare
end program host
