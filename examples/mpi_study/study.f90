! Strengths of plates with a random crack: each MPI rank takes every size-th case, with
! models of its own. The library knows nothing of MPI.
module plates
  use, intrinsic :: iso_fortran_env, only: dp => real64, int64, error_unit
  use bempd
  implicit none
contains

  ! A random number between 0 and 1 (Park and Miller, Comm. ACM 31, 1988): the same in
  ! every language, and for a case the same on every rank.
  function random_number_of(state) result(value)
    integer(int64), intent(inout) :: state
    real(dp) :: value
    state = mod(16807_int64 * state, 2147483647_int64)
    value = real(state, dp) / 2147483647._dp
  end function random_number_of

  ! Force at which the plate of a case tears; its sentence and 0 if it fails.
  function strength(number) result(force)
    integer, intent(in) :: number
    real(dp) :: force
    real(dp), parameter :: square(2, 4) = reshape( &
      [0._dp, 0._dp, .024_dp, 0._dp, .024_dp, .024_dp, 0._dp, .024_dp], [2, 4])
    real(dp), parameter :: pull = 1e-6_dp
    type(bempd_model) :: model
    type(bempd_step_report) :: report
    integer(int64) :: state
    integer :: glass, status
    real(dp) :: x, y, skipped

    state = 1 + mod(1000003_int64 * (number + 1), 2147483646_int64)
    skipped = random_number_of(state)
    x = .006_dp + .012_dp * random_number_of(state)
    y = .006_dp + .012_dp * random_number_of(state)

    call model%create()
    call model%set_option("threads", 1._dp)  ! ranks share the cores
    call model%add_material(70e9_dp, 1 / 3._dp, glass, fracture_energy=8._dp)
    call model%add_pd_region(glass, square, .001_dp, 4)
    call model%add_crack(reshape([x - .003_dp, y, x + .003_dp, y], [2, 2]))
    call model%fix_edge(1, 1, BEMPD_BOTH)
    call model%prescribe_edge(1, 3, BEMPD_Y, proportional=[pull])
    call model%run_to_separation(1e4_dp, report, stat=status)
    force = report%peak_resistance
    if (status /= BEMPD_OK) then
      write (error_unit, '("case ", i0, ": ", a)') number, model%last_error()
      force = 0
    end if
    call model%free()
  end function strength
end module plates

program study
  use mpi
  use plates
  implicit none
  integer :: cases, rank, size_of_world, number, failed, ierr
  real(dp), allocatable :: own(:), all(:)
  character(len=20) :: argument

  cases = 12
  if (command_argument_count() > 0) then
    call get_command_argument(1, argument)
    read (argument, *) cases
  end if
  call mpi_init(ierr)
  call mpi_comm_rank(MPI_COMM_WORLD, rank, ierr)
  call mpi_comm_size(MPI_COMM_WORLD, size_of_world, ierr)
  allocate (own(0:cases - 1), all(0:cases - 1))
  own = 0
  all = 0
  do number = rank, cases - 1, size_of_world
    own(number) = strength(number)
  end do
  call mpi_reduce(own, all, cases, MPI_DOUBLE_PRECISION, MPI_SUM, 0, MPI_COMM_WORLD, ierr)
  failed = count(all <= 0)
  if (rank == 0) then
    do number = 0, cases - 1
      print '(i4, es15.6e2, " N/m")', number, all(number)
    end do
    if (cases > failed) print '("mean", es15.6e2, " N/m of ", i0, " plates")', &
      sum(all) / (cases - failed), cases - failed
  end if
  call mpi_finalize(ierr)
  if (rank == 0 .and. failed > 0) error stop 1
end program study
