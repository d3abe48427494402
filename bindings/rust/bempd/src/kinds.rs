use bempd_sys as sys;

use crate::{LoadId, SupportId};

/// Plane stress (thin plates) or plane strain (long bodies).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Plane {
    /// Thin plates.
    Stress = sys::BEMPD_PLANE_STRESS as i32,
    /// Long bodies.
    Strain = sys::BEMPD_PLANE_STRAIN as i32,
}

/// Direction of a support or load.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Component {
    /// Component along x.
    X = sys::BEMPD_X as i32,
    /// Component along y.
    Y = sys::BEMPD_Y as i32,
    /// Components along x and y, where the function says so.
    Both = sys::BEMPD_BOTH as i32,
}

/// What acts on the faces of a crack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum FaceComponent {
    /// Pressure that pushes the faces apart.
    Pressure = sys::BEMPD_PRESSURE as i32,
    /// Shear along the crack that drives the left face, seen from its first point, forward and the other one back.
    Shear = sys::BEMPD_SHEAR as i32,
}

/// What the factors in a column of a load program belong to: [`Model::run_program`](crate::Model::run_program).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ProgramColumn {
    /// The column has the factors of a support.
    Support(SupportId),
    /// The column has the factors of a load.
    Load(LoadId),
}

impl ProgramColumn {
    pub(crate) fn kind(self) -> i32 {
        match self {
            Self::Support(_) => sys::BEMPD_COLUMN_SUPPORT as i32,
            Self::Load(_) => sys::BEMPD_COLUMN_LOAD as i32,
        }
    }

    pub(crate) fn id(self) -> i32 {
        match self {
            Self::Support(id) => id.0,
            Self::Load(id) => id.0,
        }
    }
}

/// How far [`Model::step_to_values`](crate::Model::step_to_values) goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Until {
    /// The step ends at the values, whatever breaks on the way.
    Values = sys::BEMPD_UNTIL_VALUES as i32,
    /// The step ends after one event, or at the values if no event comes before them.
    Event = sys::BEMPD_UNTIL_EVENT as i32,
    /// The step ends when the body is separated, or at the values.
    Separated = sys::BEMPD_UNTIL_SEPARATED as i32,
}

/// How a crack is modelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Treatment {
    /// The library chooses.
    Automatic = sys::BEMPD_TREATMENT_AUTOMATIC as i32,
    /// Boundary elements along its faces.
    Elements = sys::BEMPD_TREATMENT_ELEMENTS as i32,
    /// A lattice patch of its body around it.
    Lattice = sys::BEMPD_TREATMENT_LATTICE as i32,
    /// The crack's tips stay where they are.
    Frozen = sys::BEMPD_TREATMENT_FROZEN as i32,
}

/// Sense of turning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Turn {
    /// Sense of outer loops, which have the body on their left.
    CounterClockwise = sys::BEMPD_COUNTER_CLOCKWISE as i32,
    /// Sense of the hands of a clock.
    Clockwise = sys::BEMPD_CLOCKWISE as i32,
}

/// Face of a crack, seen from its first point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Face {
    /// Face on the left of the crack.
    Left = sys::BEMPD_FACE_LEFT as i32,
    /// Face on the right of the crack.
    Right = sys::BEMPD_FACE_RIGHT as i32,
}

/// What breaks or grows next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum NextEvent {
    /// Nothing, however far the load factor goes.
    Nothing,
    /// A bond breaks by itself, or a crack begins there.
    Bond,
    /// A crack grows at its tip.
    Tip,
    /// One that this version of the crate does not know.
    Other(i32),
}

impl NextEvent {
    pub(crate) fn from_raw(next: i32) -> NextEvent {
        match next as sys::bempd_next {
            sys::BEMPD_NEXT_NOTHING => NextEvent::Nothing,
            sys::BEMPD_NEXT_BOND => NextEvent::Bond,
            sys::BEMPD_NEXT_TIP => NextEvent::Tip,
            _ => NextEvent::Other(next),
        }
    }
}

/// Sources of errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorSource {
    /// Lengths of boundary elements.
    Boundary,
    /// Spacing of lattices.
    Lattice,
    /// Borders between lattices and boundary elements in bodies.
    Patch,
    /// Growth criterion.
    Model,
    /// One that this version of the crate does not know.
    Other(i32),
}

impl ErrorSource {
    pub(crate) fn from_raw(source: i32) -> ErrorSource {
        match source as sys::bempd_error_source {
            sys::BEMPD_ERROR_SOURCE_BOUNDARY => ErrorSource::Boundary,
            sys::BEMPD_ERROR_SOURCE_LATTICE => ErrorSource::Lattice,
            sys::BEMPD_ERROR_SOURCE_PATCH => ErrorSource::Patch,
            sys::BEMPD_ERROR_SOURCE_MODEL => ErrorSource::Model,
            _ => ErrorSource::Other(source),
        }
    }
}

/// Why stress is unbounded at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum SingularityKind {
    /// A corner of the boundary of one material, or a place where what supports hold changes.
    Corner,
    /// A place where materials meet.
    Interface,
    /// A tip, a kink or a branch of a crack in a boundary element region.
    Crack,
    /// A single point that is held or loaded.
    Point,
    /// One that this version of the crate does not know.
    Other(i32),
}

impl SingularityKind {
    pub(crate) fn from_raw(kind: i32) -> SingularityKind {
        match kind as sys::bempd_singularity_kind {
            sys::BEMPD_SINGULAR_CORNER => SingularityKind::Corner,
            sys::BEMPD_SINGULAR_INTERFACE => SingularityKind::Interface,
            sys::BEMPD_SINGULAR_CRACK => SingularityKind::Crack,
            sys::BEMPD_SINGULAR_POINT => SingularityKind::Point,
            _ => SingularityKind::Other(kind),
        }
    }
}

/// End of a crack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum TipEnd {
    /// The end at the crack's first point.
    Start,
    /// The end at the crack's last point.
    End,
    /// One that this version of the crate does not know.
    Other(i32),
}

impl TipEnd {
    pub(crate) fn from_raw(end: i32) -> TipEnd {
        match end as sys::bempd_tip_end {
            sys::BEMPD_CRACK_START => TipEnd::Start,
            sys::BEMPD_CRACK_END => TipEnd::End,
            _ => TipEnd::Other(end),
        }
    }

    pub(crate) fn raw(self) -> i32 {
        match self {
            TipEnd::Start => sys::BEMPD_CRACK_START as i32,
            TipEnd::End => sys::BEMPD_CRACK_END as i32,
            TipEnd::Other(end) => end,
        }
    }
}

/// What the values of a tip come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TipMethod {
    /// Boundary elements on the crack.
    Elements,
    /// Rings around the tip in a peridynamic region.
    Contours,
    /// The stress ahead of a crack that grows as a line, where no ring fits.
    Stress,
    /// One that this version of the crate does not know.
    Other(i32),
}

impl TipMethod {
    pub(crate) fn from_raw(method: i32) -> TipMethod {
        match method as sys::bempd_tip_method {
            sys::BEMPD_TIP_ELEMENTS => TipMethod::Elements,
            sys::BEMPD_TIP_CONTOURS => TipMethod::Contours,
            sys::BEMPD_TIP_STRESS => TipMethod::Stress,
            _ => TipMethod::Other(method),
        }
    }
}

/// What the load factors at which a tip grows come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LoadRule {
    /// Nothing is known of them.
    Unknown,
    /// Stress intensity factors of the tip.
    Factors,
    /// Factors fitted to the stress ahead of a line in a lattice, corrected by the energy of its past steps.
    Fit,
    /// The energy of trial steps of a line, where that fit does not hold.
    Energy,
    /// One that this version of the crate does not know.
    Other(i32),
}

impl LoadRule {
    pub(crate) fn from_raw(rule: i32) -> LoadRule {
        match rule as sys::bempd_load_rule {
            sys::BEMPD_LOAD_UNKNOWN => LoadRule::Unknown,
            sys::BEMPD_LOAD_FACTORS => LoadRule::Factors,
            sys::BEMPD_LOAD_FIT => LoadRule::Fit,
            sys::BEMPD_LOAD_ENERGY => LoadRule::Energy,
            _ => LoadRule::Other(rule),
        }
    }
}

/// A field on a region. Nodes are boundary nodes or material points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(i32)]
pub enum Field {
    /// Positions of the nodes, 2 numbers each [m].
    Position = sys::BEMPD_POSITION as i32,
    /// Displacements of the nodes, 2 numbers each [m].
    Displacement = sys::BEMPD_DISPLACEMENT as i32,
    /// Stress xx, yy, xy at the nodes [Pa].
    Stress = sys::BEMPD_STRESS as i32,
    /// Peridynamic regions: share of a point's bonds that is broken or cut [-].
    Damage = sys::BEMPD_DAMAGE as i32,
    /// Boundary element regions: tractions at the three nodes of every element, 2 numbers each [Pa].
    Traction = sys::BEMPD_TRACTION as i32,
    /// Peridynamic regions: stretch of every bond, also of broken ones [-].
    BondStretch = sys::BEMPD_BOND_STRETCH as i32,
    /// Boundary elements only: stress xx, yy, xy at the three nodes of every element as that element has it [Pa].
    ElementStress = sys::BEMPD_ELEMENT_STRESS as i32,
    /// Order of the stress at the nodes: 0 where it is bounded, 1/2 at crack tips [-].
    StressOrder = sys::BEMPD_STRESS_ORDER as i32,
}

/// State of a bond.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum BondState {
    /// Carries force.
    Intact,
    /// Broken in a step.
    Broken,
    /// Cut by an initial crack.
    Cut,
    /// A state that this version of the crate does not know.
    Other(i32),
}

impl BondState {
    pub(crate) fn from_raw(state: i32) -> BondState {
        match state as sys::bempd_bond_state {
            sys::BEMPD_BOND_INTACT => BondState::Intact,
            sys::BEMPD_BOND_BROKEN => BondState::Broken,
            sys::BEMPD_BOND_CUT => BondState::Cut,
            _ => BondState::Other(state),
        }
    }
}

/// Why a step ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum StopReason {
    /// The load factor asked for was reached.
    LoadFactor,
    /// One event happened, in [`Model::step_to_next_event`](crate::Model::step_to_next_event).
    Event,
    /// The body is separated: the proportional load meets no resistance any more.
    Separated,
    /// No bond can break however far the load factor goes in this direction.
    NoFurtherEvent,
    /// The equilibrium path ends: constant loads stretch bonds beyond their critical stretch at every load factor.
    NoAdmissibleLoad,
    /// Equilibrium does not exist after the bonds of the next increment break.
    NoEquilibrium,
    /// The host asked for the end of the step, which keeps the events before.
    Requested,
    /// A crack has come to an interface or to the border of its region, where it cannot go on.
    CrackStopped,
    /// A reason that this version of the crate does not know.
    Other(i32),
}

impl StopReason {
    pub(crate) fn from_raw(reason: i32) -> StopReason {
        match reason as sys::bempd_stop_reason {
            sys::BEMPD_STOP_LOAD_FACTOR => StopReason::LoadFactor,
            sys::BEMPD_STOP_EVENT => StopReason::Event,
            sys::BEMPD_STOP_SEPARATED => StopReason::Separated,
            sys::BEMPD_STOP_NO_FURTHER_EVENT => StopReason::NoFurtherEvent,
            sys::BEMPD_STOP_NO_ADMISSIBLE_LOAD => StopReason::NoAdmissibleLoad,
            sys::BEMPD_STOP_NO_EQUILIBRIUM => StopReason::NoEquilibrium,
            sys::BEMPD_STOP_REQUESTED => StopReason::Requested,
            sys::BEMPD_STOP_CRACK_STOPPED => StopReason::CrackStopped,
            _ => StopReason::Other(reason),
        }
    }
}

/// How much a line of the log matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LogLevel {
    /// Something to look at.
    Warning,
    /// What happens.
    Information,
    /// What happens, in detail.
    Detail,
}

impl LogLevel {
    pub(crate) fn from_raw(level: i32) -> LogLevel {
        match level {
            i32::MIN..=1 => LogLevel::Warning,
            2 => LogLevel::Information,
            _ => LogLevel::Detail,
        }
    }
}
