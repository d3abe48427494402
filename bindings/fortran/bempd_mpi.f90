!> One large body on several processes: MUMPS factorizes it over MPI (the library libbempd_mpi).
!>
!> Rank 0 of a communicator has the model and attaches it; the other ranks serve until rank 0 detaches or frees it:
!>
!>     if (rank == 0) then
!>       call mpi_attach(model, MPI_COMM_WORLD)
!>       call model%run_to_separation(1.0_c_double)
!>       call mpi_detach(model)
!>     else
!>       call mpi_serve(MPI_COMM_WORLD)
!>     end if
!>
!> Communicators are integers, as those of the module mpi; with mpi_f08 they are the member mpi_val.
module bempd_mpi
  use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_int, c_int32_t, c_null_char, c_ptr
  use, intrinsic :: iso_fortran_env, only: error_unit
  use bempd, only: bempd_model, BEMPD_OK
  implicit none
  private
  public :: mpi_attach, mpi_detach, mpi_serve

  interface
    function bempd_mpi_attach_handle(model, comm) bind(c, name="bempd_mpi_attach_handle")
      import :: c_int, c_int32_t, c_ptr
      type(c_ptr), value :: model
      integer(c_int32_t), value :: comm
      integer(c_int) :: bempd_mpi_attach_handle
    end function bempd_mpi_attach_handle
    function bempd_mpi_serve_handle(comm) bind(c, name="bempd_mpi_serve_handle")
      import :: c_int, c_int32_t
      integer(c_int32_t), value :: comm
      integer(c_int) :: bempd_mpi_serve_handle
    end function bempd_mpi_serve_handle
    function bempd_mpi_detach(model) bind(c, name="bempd_mpi_detach")
      import :: c_int, c_ptr
      type(c_ptr), value :: model
      integer(c_int) :: bempd_mpi_detach
    end function bempd_mpi_detach
    function bempd_mpi_last_error() bind(c, name="bempd_mpi_last_error")
      import :: c_ptr
      type(c_ptr) :: bempd_mpi_last_error
    end function bempd_mpi_last_error
  end interface

contains

  !> Lets MUMPS factorize the whole body of a model, on rank 0 before its first step or result.
  subroutine mpi_attach(model, comm, stat, errmsg)
    class(bempd_model), intent(inout) :: model
    integer, intent(in) :: comm
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    call conclude(bempd_mpi_attach_handle(model%c_handle(), int(comm, c_int32_t)), stat, errmsg)
  end subroutine mpi_attach

  !> Takes MUMPS away from a model, on rank 0; the other ranks return from mpi_serve.
  subroutine mpi_detach(model, stat, errmsg)
    class(bempd_model), intent(inout) :: model
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    call conclude(bempd_mpi_detach(model%c_handle()), stat, errmsg)
  end subroutine mpi_detach

  !> Works for rank 0 until it detaches or frees its model.
  subroutine mpi_serve(comm, stat, errmsg)
    integer, intent(in) :: comm
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    call conclude(bempd_mpi_serve_handle(int(comm, c_int32_t)), stat, errmsg)
  end subroutine mpi_serve

  !> Tells the caller how a call ended, or stops when nobody asked.
  subroutine conclude(status, stat, errmsg)
    integer(c_int), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    if (present(stat)) stat = status
    if (status == BEMPD_OK) return
    if (present(errmsg)) errmsg = last_error()
    if (present(stat)) return
    write (error_unit, '(a)') last_error()
    error stop 1
  end subroutine conclude

  function last_error() result(sentence)
    character(:), allocatable :: sentence
    character(kind=c_char), pointer :: letters(:)
    integer :: length

    call c_f_pointer(bempd_mpi_last_error(), letters, [1024])
    length = 0
    do while (letters(length + 1) /= c_null_char)
      length = length + 1
    end do
    allocate (character(length) :: sentence)
    sentence = transfer(letters(1:length), sentence)
  end function last_error
end module bempd_mpi
