use bempd_sys as sys;

use crate::{CrackId, ErrorSource, LoadRule, NextEvent, RegionId, SingularityKind, StopReason, TipEnd, TipMethod};

/// Progress of a run, reported after every event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Load factor [-].
    pub load_factor: f64,
    /// Events so far.
    pub events: i64,
    /// Bonds broken so far.
    pub broken_bonds: i64,
}

/// How far a long part of a call is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhaseProgress<'a> {
    /// What is done, such as "boundary integrals" or "sparse factorization".
    pub phase: &'a str,
    /// Share of it that is done, 0 to 1.
    pub share: f64,
    /// Seconds that it has taken so far [s].
    pub seconds: f64,
    /// Seconds that it will take in all by this share [s]; 0 if nothing is known yet.
    pub expected: f64,
}

/// A struct whose members are those of a C struct, with the conversions that the members' types ask for.
macro_rules! mirror {
    ($(#[$documentation:meta])* $name:ident of $raw:ident { $($(#[$about:meta])* $member:ident: $kind:ty,)* }) => {
        $(#[$documentation])*
        #[derive(Clone, Debug, PartialEq)]
        #[non_exhaustive]
        pub struct $name { $($(#[$about])* pub $member: $kind,)* }

        impl $name {
            pub(crate) fn from_raw(raw: &sys::$raw) -> $name {
                $name { $($member: FromRaw::from_raw(raw.$member),)* }
            }
        }
    };
}

trait FromRaw<Raw> {
    fn from_raw(raw: Raw) -> Self;
}

impl<T> FromRaw<T> for T {
    fn from_raw(raw: T) -> T {
        raw
    }
}

impl FromRaw<i32> for bool {
    fn from_raw(raw: i32) -> bool {
        raw != 0
    }
}

impl FromRaw<i32> for StopReason {
    fn from_raw(raw: i32) -> StopReason {
        StopReason::from_raw(raw)
    }
}

impl FromRaw<i32> for CrackId {
    fn from_raw(raw: i32) -> CrackId {
        CrackId(raw)
    }
}

impl FromRaw<i32> for RegionId {
    fn from_raw(raw: i32) -> RegionId {
        RegionId(raw)
    }
}

impl FromRaw<i32> for ErrorSource {
    fn from_raw(raw: i32) -> ErrorSource {
        ErrorSource::from_raw(raw)
    }
}

impl FromRaw<i32> for NextEvent {
    fn from_raw(raw: i32) -> NextEvent {
        NextEvent::from_raw(raw)
    }
}

impl FromRaw<i32> for SingularityKind {
    fn from_raw(raw: i32) -> SingularityKind {
        SingularityKind::from_raw(raw)
    }
}

impl FromRaw<i32> for TipEnd {
    fn from_raw(raw: i32) -> TipEnd {
        TipEnd::from_raw(raw)
    }
}

impl FromRaw<i32> for TipMethod {
    fn from_raw(raw: i32) -> TipMethod {
        TipMethod::from_raw(raw)
    }
}

impl FromRaw<i32> for LoadRule {
    fn from_raw(raw: i32) -> LoadRule {
        LoadRule::from_raw(raw)
    }
}

/// A tip as it was.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TipRecord {
    /// Number of the event, or 0 for the end of a step.
    pub event: i64,
    /// Bonds broken by then.
    pub total_broken_bonds: i64,
    /// Load factor then [-].
    pub load_factor: f64,
    /// The tip.
    pub tip: CrackTip,
}

mirror! {
    /// The tip of a crack at the present load factor; `bempd_crack_tip` in the C header says how its values are found.
    CrackTip of bempd_crack_tip {
        /// The crack.
        crack: CrackId,
        /// End of the crack.
        end: TipEnd,
        /// Place [m].
        x: f64,
        /// Place [m].
        y: f64,
        /// Unit vector in which the crack would go straight on [-].
        direction_x: f64,
        /// [-].
        direction_y: f64,
        /// K_I [Pa m^(1/2)]; negative if the faces overlap at the tip.
        stress_intensity_1: f64,
        /// K_II, positive if the left side, seen in the direction, moves forward [Pa m^(1/2)].
        stress_intensity_2: f64,
        /// G of growth straight on [J/m^2].
        energy_release_rate: f64,
        /// Stress along the crack beside the singular one [Pa].
        t_stress: f64,
        /// Estimate of the error of the stress intensity factors [Pa m^(1/2)].
        error: f64,
        /// Angle by which the tip turns if it grows at the present loads, counter-clockwise [rad].
        kink_angle: f64,
        /// Load factor at which the tip grows while it rises; the largest number if it never does.
        critical_load_factor: f64,
        /// What the values come from.
        method: TipMethod,
        /// Rings that the values come from; a tip in a peridynamic region that has 0 has NaN for them.
        contours: i32,
        /// Whether bonds have broken since so that the tip is not the described end any more.
        grown: bool,
        /// Whether other ways lead on from the crack, too.
        branched: bool,
        /// Outer radius of the largest ring [m].
        contour_radius: f64,
        /// How far ahead of its place the tip is felt [m].
        felt_ahead: f64,
        /// Load factor at which the tip grows while it falls; minus the largest number if it never does.
        critical_load_factor_down: f64,
        /// Angle by which the tip turns at the critical load factor, counter-clockwise [rad].
        critical_kink_angle: f64,
        /// Load factor at which G of growth straight on is the fracture energy; a tip under shear grows earlier.
        straight_load_factor: f64,
        /// What the critical load factors come from.
        load_rule: LoadRule,
        /// Whether the faces press on each other at a tip in a lattice.
        closed: bool,
        /// Estimate of the relative error of the critical load factor.
        load_error: f64,
        /// Distance to the nearest edge, other material, other crack, bend or other end; nearer the factors hold [m].
        valid_radius: f64,
    }
}

mirror! {
    /// What breaks or grows next. Numbers are NaN and ids 0 where there is nothing.
    Explanation of bempd_explanation {
        /// What it is.
        next: NextEvent,
        /// Region of the bond.
        region: RegionId,
        /// Crack that grows.
        crack: CrackId,
        /// End of that crack.
        end: TipEnd,
        /// Place of the tip, or middle of the bond [m].
        x: f64,
        /// Place of the tip, or middle of the bond [m].
        y: f64,
        /// Load factor at which it happens [-].
        load_factor: f64,
        /// Present stretch over critical stretch, or equivalent K_I over toughness [-].
        ratio: f64,
    }
}

mirror! {
    /// What preparing a scene with bodies takes, and the errors that it will have, relative to the largest of their kind.
    BodyPlan of bempd_body_plan {
        /// Elements of all regions and cracks.
        boundary_elements: i64,
        /// Displacement components of all nodes.
        unknowns: i64,
        /// Points of peridynamic regions.
        material_points: i64,
        /// Bonds of peridynamic regions.
        bonds: i64,
        /// Largest memory of preparing, without the sparse factor [B].
        memory: f64,
        /// Time of preparing with this mesh and of the first solution [s].
        seconds: f64,
        /// Time that other meshes, which tell the errors, took until now [s].
        seconds_spent: f64,
        /// Option error.wanted [-].
        error_wanted: f64,
        /// Error of displacements [-].
        displacement_error: f64,
        /// Error of reactions [-].
        reaction_error: f64,
        /// Error of stress intensity factors [-].
        intensity_error: f64,
        /// Error of the load factor of growth, relative [-].
        growth_load_error: f64,
        /// Load factor at which a crack first grows [-].
        growth_load_factor: f64,
        /// Crack that grows then.
        growth_crack: CrackId,
        /// End of that crack.
        growth_end: TipEnd,
        /// Whether the errors are at most those wanted.
        meets_wish: bool,
        /// Whether this mesh has been solved; else numbers are extrapolated from coarser ones.
        is_solved: bool,
    }
}

mirror! {
    /// Errors of results by source, relative to the largest of their kind; sources are never added.
    Errors of bempd_errors {
        /// Option error.wanted [-].
        wanted: f64,
        /// Error of displacements, from boundary elements [-].
        displacement: f64,
        /// Error of reactions, from boundary elements [-].
        reaction: f64,
        /// Error of stress intensity factors, from boundary elements [-].
        stress_intensity: f64,
        /// Error of the next load factor of growth, from boundary elements [-].
        growth_load: f64,
        /// Errors from lattices; NaN where it is not estimated [-].
        lattice: f64,
        /// Errors from lattices in bodies [-].
        patch: f64,
        /// Difference between the growth criteria [-].
        model: f64,
        /// The largest of those that are known.
        dominating: ErrorSource,
        /// Time of preparing that half as long elements would take [s].
        halving_seconds: f64,
        /// Memory that they would take [B].
        halving_memory: f64,
    }
}

mirror! {
    /// Errors of a run in which cracks have grown, by source; sources are never added. NaN where they were not estimated.
    RunErrors of bempd_run_errors {
        /// Time that the estimate takes, roughly [s].
        expected_seconds: f64,
        /// Time that it took; 0 if it was not made [s].
        seconds: f64,
        /// Error of the load factor of the first growth, from boundary elements, relative [-].
        first_growth: f64,
        /// Error of the peak resistance, from elements and lengths of extensions, relative [-].
        peak: f64,
        /// Error of the paths of cracks, likewise [m].
        path: f64,
        /// Error of the first growth from lattice patches in place of elements [-].
        lattice_first_growth: f64,
        /// Error of the peak resistance from these [-].
        lattice_peak: f64,
        /// Error of the paths of cracks from these [m].
        lattice_path: f64,
        /// Crack with the largest of the errors of paths.
        path_crack: CrackId,
        /// Whether the estimate was made; else it takes longer than allowed.
        is_made: bool,
    }
}

mirror! {
    /// A place where the stress of the elastic body is unbounded: it grows as r to the power of exponent - 1.
    Singularity of bempd_singularity {
        /// Why it is.
        kind: SingularityKind,
        /// A region there.
        region: RegionId,
        /// Place [m].
        x: f64,
        /// Place [m].
        y: f64,
        /// Exponent of the displacement beside the place, 1/2 at crack tips, 0 at points under a force [-].
        exponent: f64,
        /// Imaginary part of the exponent [-].
        oscillation: f64,
    }
}

mirror! {
    /// What growth of cracks by a length did.
    Growth of bempd_growth {
        /// Tips that have grown.
        tips: i32,
        /// Tips among them that ended at an edge, a hole or another crack.
        ended: i32,
        /// Load factor at which they grew [-].
        load_factor: f64,
        /// Sum of their growth [m].
        length: f64,
        /// Energy that the body has released by it [J].
        released_energy: f64,
    }
}

mirror! {
    /// What growth by cycles did.
    FatigueReport of bempd_fatigue_report {
        /// Why it ended: a `bempd_fatigue_stop`, 1 cycles, 2 critical, 3 length, 4 none grows, 5 a tip ended, 6 a tip
        /// stopped, 7 steps, 8 on request.
        stop_reason: i32,
        /// Crack whose tip is the reason; 0: none.
        crack: i32,
        /// End of the crack, 1 the start and 2 the end; 0: none.
        end: i32,
        /// Steps made.
        steps: i64,
        /// Cycles that have passed, with those before.
        cycles: f64,
        /// Sum of the growth of all tips [m].
        growth: f64,
        /// Estimated error of the cycles, as a share of them.
        error: f64,
    }
}

mirror! {
    /// A tip after a step of growth by cycles.
    FatigueRecord of bempd_fatigue_record {
        /// Step; 0: as it was at first.
        step: i64,
        /// Event of the history; 0: as it was at first.
        event: i64,
        /// Id of the crack.
        crack: CrackId,
        /// End of the crack.
        end: TipEnd,
        /// Cycles that have passed, with those before.
        cycles: f64,
        /// Length of the crack [m].
        length: f64,
        /// Growth of the tip in the call [m].
        growth: f64,
        /// Place of the tip [m].
        x: f64,
        /// Place of the tip [m].
        y: f64,
        /// K_I at the high load [Pa m^(1/2)].
        stress_intensity_1: f64,
        /// K_II at the high load [Pa m^(1/2)].
        stress_intensity_2: f64,
        /// K_I at the low load [Pa m^(1/2)].
        stress_intensity_1_low: f64,
        /// K_II at the low load [Pa m^(1/2)].
        stress_intensity_2_low: f64,
        /// Factor of mode I in the direction of growth at the high load [Pa m^(1/2)].
        highest: f64,
        /// Range: `highest` less the factor at the low load [Pa m^(1/2)].
        range: f64,
        /// Load ratio R [-].
        ratio: f64,
        /// Growth in a cycle, mean over all blocks [m].
        rate: f64,
    }
}

mirror! {
    /// A vertex of a crack's path; what is not known of one that was described, or where the crack began, is NaN.
    PathVertex of bempd_path_vertex {
        /// Event of the history at which the crack grew to here; 0: it was described.
        event: i64,
        /// End that grew, 1 the start and 2 the end; 0: none.
        end: i32,
        /// Place [m].
        x: f64,
        /// Place [m].
        y: f64,
        /// Load factor at which it grew to here [-].
        load_factor: f64,
        /// K_I of the tip just before [Pa m^(1/2)].
        stress_intensity_1: f64,
        /// K_II of the tip just before [Pa m^(1/2)].
        stress_intensity_2: f64,
        /// G in the direction to here, just before [J/m^2].
        energy_release_rate: f64,
        /// Fracture energy G0 along the way to here [J/m^2].
        resistance: f64,
    }
}

mirror! {
    /// What one tip did when cracks grew.
    CrackExtension of bempd_crack_extension {
        /// Event of the history that it was part of.
        event: i64,
        /// The crack.
        crack: CrackId,
        /// End of the crack.
        end: TipEnd,
        /// 1: it has reached an edge, a hole or another crack; else 0.
        ended: i32,
        /// Extensions of this end up to this one.
        count: i32,
        /// End of the extension [m].
        x: f64,
        /// End of the extension, y [m].
        y: f64,
        /// Angle by which it turned, counter-clockwise [rad].
        angle: f64,
        /// Length of the extension [m].
        length: f64,
        /// Length of the whole crack after it [m].
        crack_length: f64,
        /// Load factor at which it grew [-].
        load_factor: f64,
        /// G in the new direction at the start of the extension [J/m^2].
        energy_release_rate_before: f64,
        /// G at the end of the extension [J/m^2]; 0 if the end is no tip now.
        energy_release_rate_after: f64,
        /// Mean of both times way and thickness, or what the others of the event leave [J].
        released_energy: f64,
        /// Start of the extension [m].
        from_x: f64,
        /// Start of the extension, y [m].
        from_y: f64,
        /// K_I of the tip as it grew; NaN where a crack began [Pa m^(1/2)].
        stress_intensity_1: f64,
        /// K_II of the tip as it grew [Pa m^(1/2)].
        stress_intensity_2: f64,
        /// Fracture energy of what it went through [J/m^2].
        resistance: f64,
        /// What became of the end: 0 it is a tip, 1 at an edge, 2 a hole, 3 a crack, 4 an interface, 5 separated.
        state: i32,
        /// Part of the released energy that the new area took; the rest becomes motion [J].
        surface_energy: f64,
    }
}

mirror! {
    /// What a step did.
    StepReport of bempd_step_report {
        /// Why the step ended.
        stop_reason: StopReason,
        /// Whether the load path is cut.
        separated: bool,
        /// Events in this step: batches of bonds broken at one load factor.
        events: i64,
        /// Bonds broken in this step.
        broken_bonds: i64,
        /// Events since the beginning.
        total_events: i64,
        /// Bonds broken since the beginning, without those cut by initial cracks.
        total_broken_bonds: i64,
        /// Pieces come free of all supports, or loaded ones that swing on a hinge.
        fragments: i64,
        /// Load factor reached [-].
        load_factor: f64,
        /// Elastic energy at the end [J].
        stored_energy: f64,
        /// Energy released by breaking bonds since the beginning [J].
        released_energy: f64,
        /// Work of loads and supports since the beginning [J].
        work: f64,
        /// |work - stored - released| over the largest work so far, worst of all events [-]; not small in scheme
        /// `paper`, whose stiffness is unsymmetric.
        energy_balance_error: f64,
        /// Largest unbalanced force at the end over the largest internal nodal force so far [-].
        residual: f64,
        /// Wall time of this step [s].
        seconds_total: f64,
        /// Wall time of solutions [s].
        seconds_solve: f64,
        /// Wall time of changes of the factorization [s].
        seconds_update: f64,
        /// Wall time of stretches, choice of bonds and connectivity [s].
        seconds_search: f64,
        /// Dissipated part of the released energy: that of bonds just at their critical stretch; the rest would have
        /// become motion [J].
        bond_energy: f64,
        /// The first event of this step at which equilibrium was lost; 0 if each was in equilibrium.
        unstable_event: i64,
        /// Force that the body bore after the last event, the pull in a tensile test [N].
        resistance: f64,
        /// The largest that it bore in equilibrium just before an event [N].
        peak_resistance: f64,
        /// Whether it is separated, but some bonds still connect what carried the load.
        hanging: bool,
        /// Places at which faces of cracks in lattices press on each other at the end, about one a spacing.
        closed_places: i64,
        /// How often such places have closed or opened in this step.
        face_switches: i64,
        /// Tips and places of new cracks that would have grown in this step as soon as those that did.
        ties: i64,
    }
}

mirror! {
    /// A piece of the body: what intact bonds, interfaces and boundary element regions join.
    Piece of bempd_piece {
        /// Material points and boundary nodes.
        nodes: i64,
        /// Supports that hold it.
        supports: i32,
        /// Loads that act on it.
        loads: i32,
        /// Independent rigid motions that supports leave it.
        free_motions: i32,
        /// Mean of the places of its nodes [m].
        x: f64,
        /// Mean of the places of its nodes, y [m].
        y: f64,
        /// The rigid motion nearest to that of its nodes: displacement there [m].
        move_x: f64,
        /// Displacement there, y [m].
        move_y: f64,
        /// Rotation about that place, counter-clockwise [rad].
        rotation: f64,
        /// Largest difference of a node's displacement from this motion [m].
        deviation: f64,
    }
}

mirror! {
    /// One line of the history: an event or the end of a step.
    HistoryEntry of bempd_history_entry {
        /// Number of the event, or 0 for the end of a step.
        event: i64,
        /// Bonds broken so far.
        total_broken_bonds: i64,
        /// Load factor [-].
        load_factor: f64,
        /// Largest bond stretch over its critical stretch just before the break, or of a tip its intensity over its
        /// toughness [-].
        stretch_ratio: f64,
        /// Elastic energy [J].
        stored_energy: f64,
        /// Energy released by breaking bonds so far [J].
        released_energy: f64,
        /// Work of loads and supports so far [J].
        work: f64,
        /// |work - stored - released| over the largest work so far [-].
        energy_balance_error: f64,
        /// Largest unbalanced force over the largest internal nodal force so far [-].
        residual: f64,
        /// Load factor on the equilibrium path at which the most stretched bond just reaches its critical stretch, or a
        /// tip its toughness; at the end of a step the load factor [-].
        critical_load_factor: f64,
        /// Elastic energy there, after the event [J].
        critical_stored_energy: f64,
        /// What bonds broken so far take where they just reach their critical stretch [J].
        bond_energy: f64,
        /// Just before the event, at the end of a step there: load factor [-].
        load_factor_before: f64,
        /// The same: elastic energy [J].
        stored_energy_before: f64,
        /// The same: work of loads and supports [J].
        work_before: f64,
        /// The same: force that the body bears in equilibrium; the largest is `peak_resistance` of reports [N].
        resistance_before: f64,
        /// Force that it bears after the event [N].
        resistance: f64,
        /// Tips or places that would have grown at this event as soon, but for rounding.
        ties: i64,
    }
}

mirror! {
    /// Sizes, counters and times since the model was created.
    Statistics of bempd_statistics {
        /// Nodes of all boundary element regions.
        boundary_nodes: i64,
        /// Elements of all boundary element regions.
        boundary_elements: i64,
        /// Points of all peridynamic regions.
        material_points: i64,
        /// Bonds of all peridynamic regions.
        bonds: i64,
        /// Bonds cut by initial cracks.
        cut_bonds: i64,
        /// Bonds broken in steps.
        broken_bonds: i64,
        /// Unknowns of the sparse system after condensing boundary element regions.
        sparse_unknowns: i64,
        /// Entries of the sparse factor.
        factor_nonzeros: i64,
        /// Evaluations of the boundary kernels, also for places inside boundary element regions.
        kernel_evaluations: i64,
        /// Factorizations of condensed boundary element regions.
        dense_factorizations: i64,
        /// Factorizations of the sparse system.
        sparse_factorizations: i64,
        /// Columns added to or removed from the factor.
        factor_updates: i64,
        /// Equilibrium solutions (load cases).
        solves: i64,
        /// Applications of the factor in these.
        solver_iterations: i64,
        /// Time for boundary operators [s].
        seconds_boundary: f64,
        /// Time for lattice, bonds and weights [s].
        seconds_lattice: f64,
        /// Time for condensation and assembly [s].
        seconds_assembly: f64,
        /// Time for sparse factorizations [s].
        seconds_factorization: f64,
        /// Time for solutions [s].
        seconds_solve: f64,
        /// Time for changes of the factor [s].
        seconds_update: f64,
        /// Time for stretches, choice of bonds, connectivity [s].
        seconds_search: f64,
        /// Crude reciprocal condition number of the worst equations solved so far; 1 if nothing was solved [-].
        reciprocal_condition: f64,
        /// Subdomains into which large BEM regions without cracks are cut; 0 if all are whole.
        subdomains: i64,
        /// Nodes on the cuts between subdomains.
        cut_nodes: i64,
    }
}
