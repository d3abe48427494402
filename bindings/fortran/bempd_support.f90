!> Support of the module bempd: how calls end, what C cannot check, strings, and the life of models and states.
submodule (bempd) bempd_support
  use, intrinsic :: iso_c_binding, only: c_f_pointer, c_funloc, c_funptr, c_loc, c_null_char, c_null_funptr, c_sizeof, &
    c_associated
  use, intrinsic :: iso_fortran_env, only: error_unit
  use bempd_c
  implicit none

  !> Values of a support or load, where C can read them.
  type :: value_parts
    integer(c_int64_t) :: count
    real(c_double), allocatable :: constant(:), proportional(:)
  end type value_parts

contains

  !> Tells the caller how a call ended, or stops when nobody asked.
  subroutine conclude(status, sentence, stat, errmsg)
    integer, intent(in) :: status
    character(*), intent(in) :: sentence
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    if (present(stat)) stat = status
    if (status == BEMPD_OK) return
    if (present(errmsg)) errmsg = sentence
    if (present(stat)) return
    write (error_unit, '(a)') sentence
    error stop 1
  end subroutine conclude

  !> The end of a call on a model.
  subroutine finish(self, status, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    integer(c_int), intent(in) :: status
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    if (allocated(self%sentence)) deallocate (self%sentence)
    if (status == BEMPD_OK) then
      call conclude(status, "", stat, errmsg)
    else
      call conclude(status, self%last_error(), stat, errmsg)
    end if
  end subroutine finish

  !> An argument error that this layer finds.
  subroutine refuse(self, sentence, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    character(*), intent(in) :: sentence
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    self%sentence = sentence
    call conclude(BEMPD_ERROR_ARGUMENT, sentence, stat, errmsg)
  end subroutine refuse

  !> Whether an array is (2,n); refuses it if not.
  logical function are_points(self, procedure_name, array_name, array, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    character(*), intent(in) :: procedure_name, array_name
    real(c_double), intent(in) :: array(:, :)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(24) :: numbers

    are_points = size(array, 1) == 2
    if (are_points) return
    write (numbers, '(i0,",",i0)') shape(array)
    call refuse(self, procedure_name // ": " // array_name // " has shape (" // trim(numbers) // &
      "); it must be (2,n), x and y of each point side by side; try transpose(" // array_name // ")", stat, errmsg)
  end function are_points

  !> Whether vertices are (2,n) with as many bulges or none; refuses them if not. Copies the bulges as are_bulges() does.
  logical function can_be_loop(self, procedure_name, vertices, bulges, bends, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    character(*), intent(in) :: procedure_name
    real(c_double), intent(in) :: vertices(:, :)
    real(c_double), intent(in), optional :: bulges(:)
    real(c_double), allocatable, target, intent(out) :: bends(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg

    can_be_loop = are_points(self, procedure_name, "vertices", vertices, stat, errmsg)
    if (can_be_loop) can_be_loop = are_bulges(self, procedure_name, vertices, bulges, bends, stat, errmsg)
  end function can_be_loop

  !> Whether there is a bulge for each vertex; they are copied to where C can read them, as 0 if there are none.
  logical function are_bulges(self, procedure_name, vertices, bulges, bends, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    character(*), intent(in) :: procedure_name
    real(c_double), intent(in) :: vertices(:, :)
    real(c_double), intent(in), optional :: bulges(:)
    real(c_double), allocatable, target, intent(out) :: bends(:)
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(24) :: numbers(2)

    allocate (bends(size(vertices, 2)), source=0.0_c_double)
    are_bulges = .true.
    if (.not. present(bulges)) return
    are_bulges = size(bulges) == size(bends)
    if (are_bulges) then
      bends = bulges
    else
      write (numbers, '(i0)') size(bulges), size(bends)
      call refuse(self, procedure_name // ": there are " // trim(numbers(1)) // " bulges for " // trim(numbers(2)) // &
        " edges; give one for each", stat, errmsg)
    end if
  end function are_bulges

  !> Whether both parts have as many numbers; they are copied to where C can read them, with 0 for a missing part.
  logical function are_values(self, procedure_name, constant, proportional, parts, stat, errmsg)
    class(bempd_model), intent(inout) :: self
    character(*), intent(in) :: procedure_name
    real(c_double), intent(in), optional :: constant(:), proportional(:)
    type(value_parts), intent(out) :: parts
    integer, intent(out), optional :: stat
    character(*), intent(inout), optional :: errmsg
    character(24) :: numbers(2)

    parts%constant = [0.0_c_double]
    if (present(constant)) parts%constant = constant
    parts%proportional = 0 * parts%constant
    if (present(proportional)) parts%proportional = proportional
    if (.not. present(constant)) parts%constant = 0 * parts%proportional
    parts%count = size(parts%constant)
    are_values = size(parts%proportional) == parts%count
    if (.not. are_values) then
      write (numbers, '(i0)') size(constant), size(proportional)
      call refuse(self, procedure_name // ": constant has " // trim(numbers(1)) // " values and proportional " // &
        trim(numbers(2)) // "; give as many of both, or leave one out", stat, errmsg)
    end if
  end function are_values

  function c_string(text)
    character(*), intent(in) :: text
    character(:, c_char), allocatable :: c_string

    c_string = trim(text) // c_null_char
  end function c_string

  function text_at(address) result(text)
    type(c_ptr), intent(in) :: address
    character(:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)

    text = ""
    if (.not. c_associated(address)) return
    call c_f_pointer(address, letters, [1])
    text = bempd_text(letters)
  end function text_at

  real(c_double) function value_or(value, default)
    real(c_double), intent(in), optional :: value
    real(c_double), intent(in) :: default

    value_or = default
    if (present(value)) value_or = value
  end function value_or

  type(c_ptr) function address_or_null(user)
    type(c_ptr), intent(in), optional :: user

    address_or_null = c_null_ptr
    if (present(user)) address_or_null = user
  end function address_or_null

  subroutine give(number, place)
    integer(c_int32_t), intent(in) :: number
    integer(c_int32_t), intent(out), optional :: place

    if (present(place)) place = number
  end subroutine give

  module procedure bempd_text
    integer :: length, k

    length = 0
    do while (letters(length + 1) /= c_null_char)
      length = length + 1
    end do
    allocate (character(length) :: text)
    do k = 1, length
      text(k:k) = letters(k)
    end do
  end procedure bempd_text

  module procedure bempd_version
    text = text_at(bempd_version_string())
  end procedure bempd_version

  module procedure bempd_build
    text = text_at(bempd_build_info())
  end procedure bempd_build

  module procedure bempd_status_word
    text = text_at(bempd_status_name(int(status, c_int)))
  end procedure bempd_status_word

  module procedure bempd_get_options
    type(bempd_option_info) :: info
    integer(c_int64_t) :: count, k
    integer(c_int) :: status

    count = 0
    status = bempd_option_count(count)
    allocate (options(count))
    do k = 1, count
      status = bempd_option_info_init(info, c_sizeof(info))
      if (status == BEMPD_OK) status = bempd_option_describe(k - 1, info)
      if (status /= BEMPD_OK) exit
      options(k)%name = text_at(info%name)
      options(k)%summary = text_at(info%summary)
      options(k)%unit = text_at(info%unit)
      options(k)%choices = text_at(info%choices)
      options(k)%default_text = text_at(info%default_text)
      options(k)%kind = info%kind
      options(k)%whole_number = info%whole_number /= 0
      options(k)%default_value = info%default_value
      options(k)%minimum = info%minimum
      options(k)%maximum = info%maximum
    end do
    call conclude(status, text_at(bempd_last_error(c_null_ptr)), stat, errmsg)
  end procedure bempd_get_options

  module procedure create
    call self%free()
    call finish(self, bempd_model_create(self%handle), stat, errmsg)
  end procedure create

  module procedure free
    call bempd_model_free(self%handle)
    self%handle = c_null_ptr
    if (allocated(self%sentence)) deallocate (self%sentence)
  end procedure free

  module procedure finalize_model
    call self%free()
  end procedure finalize_model

  module procedure refuse_copy
    error stop "bempd: a model cannot be copied; pass it on as an argument or point to it"
  end procedure refuse_copy

  module procedure last_error
    if (allocated(self%sentence)) then
      sentence = self%sentence
    else
      ! A call from within another call on this model leaves its sentence with the thread.
      sentence = text_at(bempd_last_error(self%handle))
      if (sentence == "") sentence = text_at(bempd_last_error(c_null_ptr))
    end if
  end procedure last_error

  module procedure c_handle
    handle = self%handle
  end procedure c_handle

  module procedure free_state
    call bempd_state_free(self%handle)
    self%handle = c_null_ptr
  end procedure free_state

  module procedure finalize_state
    call self%free()
  end procedure finalize_state

  module procedure refuse_copy_of_state
    error stop "bempd: a state cannot be copied; save it twice, or carry it as bytes"
  end procedure refuse_copy_of_state
end submodule bempd_support
