use crate::{
    BodyPlan, BondState, CrackExtension, CrackId, CrackTip, Errors, Explanation, Face, Field, Growth, HistoryEntry,
    LoadId, Model, PathVertex, Piece, RegionId, Result, RunErrors, Singularity, Statistics, SupportId, TipEnd,
    TipRecord, View,
};

/// Node indices, from 0, of the boundary elements or lattice cells of a region.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Elements {
    /// Boundary elements: start, mid, end.
    Boundary(Vec<[i32; 3]>),
    /// Lattice cells: corners, counter-clockwise.
    Lattice(Vec<[i32; 4]>),
}

/// A bond between two material points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bond {
    /// Indices of the material points, from 0.
    pub points: [i32; 2],
    /// Whether it carries force.
    pub state: BondState,
}

/// Displacement and stress at places in the body, one entry a place.
#[derive(Clone, Debug, PartialEq)]
pub struct PointValues {
    /// Displacements [m].
    pub displacement: Vec<[f64; 2]>,
    /// Stress xx, yy, xy [Pa].
    pub stress: Vec<[f64; 3]>,
    /// The regions that hold the places.
    pub regions: Vec<RegionId>,
}

/// What supports exert on the body through one edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeReaction {
    /// Resultant [N].
    pub force: [f64; 2],
    /// Moment, positive counter-clockwise [N m].
    pub moment: f64,
}

/// What a support did at a line of the history.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HistorySupport {
    /// Displacement by which it moves the body, the mean over its nodes; NaN for a component that it leaves free [m].
    pub displacement: [f64; 2],
    /// Force that it exerts on the body [N].
    pub force: [f64; 2],
    /// Force that it exerted just before the line's event [N].
    pub force_before: [f64; 2],
}

/// Openings of a crack, one entry a place: displacement of its left face less that of its right one.
#[derive(Clone, Debug, PartialEq)]
pub struct CrackOpening {
    /// Normal to it, negative where its faces overlap [m].
    pub normal: Vec<f64>,
    /// Opening along the crack [m].
    pub tangential: Vec<f64>,
}

/// # Results
///
/// Those of regions, supports and places prepare the model if that has not been done.
impl Model {
    /// Looks at a field without copying. Several views can live at a time; while one lives the model cannot change.
    ///
    /// ```compile_fail,E0502
    /// # use bempd::{Field, Model, RegionId, Result};
    /// fn refused(model: &mut Model, region: RegionId) -> Result<f64> {
    ///     let displacement = model.view(region, Field::Displacement)?;
    ///     model.step(1.0)?;
    ///     Ok(displacement.values()[0])
    /// }
    /// ```
    pub fn view(&self, region: RegionId, field: Field) -> Result<View<'_>> {
        self.handle.view(region.0, field as i32)
    }

    /// Number of entries of a field, and of numbers per entry.
    pub fn field_size(&self, region: RegionId, field: Field) -> Result<(usize, usize)> {
        self.handle.field_size(region.0, field as i32).map(|(count, components)| (count as usize, components as usize))
    }

    /// Copies a field into the first numbers of `values`, which must have room for all.
    pub fn copy_field(&self, region: RegionId, field: Field, values: &mut [f64]) -> Result<()> {
        self.handle.copy_field(region.0, field as i32, values)
    }

    /// Number of boundary nodes or material points of a region.
    pub fn node_count(&self, region: RegionId) -> Result<usize> {
        self.handle.node_count(region.0).map(|count| count as usize)
    }

    /// Number of boundary elements or lattice cells of a region.
    pub fn element_count(&self, region: RegionId) -> Result<usize> {
        self.handle.element_count(region.0).map(|count| count as usize)
    }

    /// Nodes of the boundary elements or of the lattice cells of a region.
    pub fn elements(&self, region: RegionId) -> Result<Elements> {
        // The library writes three or four indices an element, as the region is; indices are not negative.
        let count = self.element_count(region)?;
        let mut nodes = vec![-1; 4 * count];
        self.handle.copy_elements(region.0, &mut nodes)?;
        Ok(match nodes.last() {
            Some(-1) => Elements::Boundary(nodes[..3 * count].chunks(3).map(|n| [n[0], n[1], n[2]]).collect()),
            _ => Elements::Lattice(nodes.chunks(4).map(|n| [n[0], n[1], n[2], n[3]]).collect()),
        })
    }

    /// Number of bonds of a peridynamic region, with broken and cut ones.
    pub fn bond_count(&self, region: RegionId) -> Result<usize> {
        self.handle.bond_count(region.0).map(|count| count as usize)
    }

    /// Ends and states of the bonds of a peridynamic region.
    pub fn bonds(&self, region: RegionId) -> Result<Vec<Bond>> {
        let count = self.bond_count(region)?;
        let (mut ends, mut states) = (vec![[0; 2]; count], vec![0; count]);
        self.handle.copy_bonds(region.0, &mut ends, &mut states)?;
        let bond = |(points, state)| Bond { points, state: BondState::from_raw(state) };
        Ok(ends.into_iter().zip(states).map(bond).collect())
    }

    /// Force that a support exerts on the body at the present load factor [N]. Where supports share a node's component
    /// the first one counts it.
    pub fn reaction(&self, support: SupportId) -> Result<[f64; 2]> {
        self.handle.reaction(support.0)
    }

    /// Moment about a place of the forces that a support exerts on the body [N m], positive counter-clockwise.
    pub fn reaction_moment(&self, support: SupportId, about: [f64; 2]) -> Result<f64> {
        self.handle.reaction_moment(support.0, about)
    }

    /// Lowest and highest load factor that the body bears with its present bonds; the lowest is above the highest where
    /// there is none, and both are at the ends of the range of numbers where nothing bounds them.
    pub fn admissible_load_factors(&self) -> Result<(f64, f64)> {
        self.handle.admissible_load_factors()
    }

    /// What breaks or grows next while the load factor rises or falls, and what holds other tips back.
    pub fn explain(&self, rising: bool) -> Result<(Explanation, String)> {
        let (found, text) = self.handle.explain(rising)?;
        Ok((Explanation::from_raw(&found), text))
    }

    /// Displacement and stress at places in the body [m]: by the interior identities in boundary element regions, by
    /// interpolation between material points in peridynamic ones.
    pub fn evaluate(&self, places: &[[f64; 2]]) -> Result<PointValues> {
        let (displacement, stress, regions) = self.handle.evaluate(places)?;
        Ok(PointValues { displacement, stress, regions: regions.into_iter().map(RegionId).collect() })
    }

    /// Errors [m], [Pa] of the displacements and stresses that [`Model::evaluate`] gives; NaN where they are not known.
    pub fn evaluate_errors(&self, places: &[[f64; 2]]) -> Result<(Vec<f64>, Vec<f64>)> {
        self.handle.evaluate_errors(places)
    }

    /// Displacement as [`Model::evaluate`] computes it, without the cost of the stress.
    pub fn evaluate_displacement(&self, places: &[[f64; 2]]) -> Result<Vec<[f64; 2]>> {
        self.handle.evaluate_displacement(places)
    }

    /// Force, and moment about a place, that all supports of an edge exert through it; what corners carry is shared among
    /// the edges that meet there.
    pub fn edge_reaction(&self, region: RegionId, edge: i32, about: [f64; 2]) -> Result<EdgeReaction> {
        let (force, moment) = self.handle.edge_reaction(region.0, edge, about)?;
        Ok(EdgeReaction { force, moment })
    }

    /// Values as [`Model::evaluate`] has them, for one region: on its side of interfaces, and on one face of cracks.
    pub fn evaluate_in(&self, region: RegionId, face: Face, places: &[[f64; 2]]) -> Result<PointValues> {
        let (displacement, stress) = self.handle.evaluate_in(region.0, face as i32, places)?;
        Ok(PointValues { displacement, stress, regions: vec![region; places.len()] })
    }

    /// Number of pieces that the body consists of; a material point without any bond is one too.
    pub fn piece_count(&self) -> Result<usize> {
        self.handle.piece_count().map(|count| count as usize)
    }

    /// A piece, from 1; the one with the most nodes is the first.
    pub fn piece(&self, number: i32) -> Result<Piece> {
        Ok(Piece::from_raw(&self.handle.piece(number)?))
    }

    /// Numbers of the pieces of the nodes of a region.
    pub fn node_pieces(&self, region: RegionId) -> Result<Vec<i32>> {
        self.handle.node_pieces(region.0)
    }

    /// Number of the piece that a support holds; none if it holds nodes of several.
    pub fn support_piece(&self, support: SupportId) -> Result<Option<i32>> {
        self.handle.support_piece(support.0).map(|piece| Some(piece).filter(|number| *number > 0))
    }

    /// Number of the piece that a load acts on, also while it is 0; none if it acts on several.
    pub fn load_piece(&self, load: LoadId) -> Result<Option<i32>> {
        self.handle.load_piece(load.0).map(|piece| Some(piece).filter(|number| *number > 0))
    }

    /// Whether two supports still hold the same piece.
    pub fn are_connected(&self, support: SupportId, other: SupportId) -> Result<bool> {
        self.handle.are_connected(support.0, other.0).map(|connected| connected != 0)
    }

    /// All places where stress is unbounded, so that its number there depends on the elements.
    pub fn stress_orders(&self, places: &[[f64; 2]]) -> Result<Vec<f64>> {
        self.handle.stress_orders(places)
    }

    /// Places where stress is unbounded, so that its number there depends on the elements.
    pub fn singularities(&self) -> Result<Vec<Singularity>> {
        let count = self.handle.singularity_count()?;
        (0..count).map(|index| Ok(Singularity::from_raw(&self.handle.singularity(index)?))).collect()
    }

    /// Number of tips that cracks have.
    pub fn tip_count(&self) -> Result<usize> {
        self.handle.tip_count().map(|count| count as usize)
    }

    /// A tip, from 0.
    pub fn tip(&self, index: usize) -> Result<CrackTip> {
        Ok(CrackTip::from_raw(&self.handle.tip(index as i64)?))
    }

    /// All tips with their stress intensity factors: those in boundary element regions first, by crack.
    ///
    /// ```
    /// use bempd::{Component, FaceComponent, Material, Model, TipEnd, Values};
    ///
    /// # fn main() -> bempd::Result<()> {
    /// let mut model = Model::new()?;
    /// let glass = model.add_material(&Material::new(70e9, 0.2))?;
    /// model.add_bem_region(glass, &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 0.5)?;
    /// let crack = model.add_crack(&[[-0.01, 0.0], [0.01, 0.0]])?;
    /// model.fix_point([-1.0, -1.0], Component::Both)?;
    /// model.fix_point([1.0, -1.0], Component::Y)?;
    /// model.add_crack_traction(crack, FaceComponent::Pressure, Values::constant(&[1e6]))?;
    ///
    /// let tips = model.tips()?;
    /// let expected = 1e6 * (std::f64::consts::PI * 0.01).sqrt();
    /// assert_eq!((tips.len(), tips[1].crack, tips[1].end), (2, crack, TipEnd::End));
    /// assert!((tips[1].stress_intensity_1 / expected - 1.0).abs() < 3e-4);
    /// let opening = model.crack_opening(crack, &[0.5, 1.0])?;
    /// assert!(opening.normal[0] > 0.0 && opening.normal[1].abs() < 1e-15);
    /// assert!(opening.tangential[0].abs() < 1e-6 * opening.normal[0]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn tips(&self) -> Result<Vec<CrackTip>> {
        (0..self.tip_count()?).map(|index| self.tip(index)).collect()
    }

    /// The tips that were recorded: at every n-th event and at the ends of steps with the option `tips.record` = n.
    ///
    /// ```
    /// use bempd::{Component, Material, Model, TipMethod, Values};
    ///
    /// # fn main() -> bempd::Result<()> {
    /// let mut model = Model::new()?;
    /// model.set_option("tips.record", 1.0)?;
    /// let glass = model.add_material(&Material::new(1.0, 1.0 / 3.0))?;
    /// let square = [[-20.5, -20.5], [20.5, -20.5], [20.5, 20.5], [-20.5, 20.5]];
    /// let plate = model.add_pd_region(glass, &square, 1.0, 3)?;
    /// model.add_crack(&[[-10.0, 0.0], [10.0, 0.0]])?;
    /// model.fix_point([-20.5, -20.5], Component::Both)?;
    /// model.fix_point([20.5, -20.5], Component::Y)?;
    /// model.add_traction(plate, 3, .., Component::Y, Values::proportional(&[1.0]))?;
    /// model.add_traction(plate, 1, .., Component::Y, Values::proportional(&[-1.0]))?;
    /// model.step(0.01)?;
    ///
    /// let recorded = model.tip_history()?;
    /// assert_eq!((recorded.len(), recorded[1].event, recorded[1].load_factor), (2, 0, 0.01));
    /// assert_eq!((recorded[1].tip.method, recorded[1].tip.contours), (TipMethod::Contours, 3));
    /// # Ok(())
    /// # }
    /// ```
    pub fn tip_history(&self) -> Result<Vec<TipRecord>> {
        let count = self.handle.tip_history_count()?;
        let record = |index| {
            let (event, total_broken_bonds, load_factor, tip) = self.handle.tip_record(index)?;
            Ok(TipRecord { event, total_broken_bonds, load_factor, tip: CrackTip::from_raw(&tip) })
        };
        (0..count).map(record).collect()
    }

    /// Lets the tips of cracks in boundary element regions that reach their fracture energy first grow by a length [m].
    /// The load factor is solved for; the model is there afterwards, with the longer cracks; the history goes on. The
    /// options named `crack.*` choose the criterion and which tips grow together.
    pub fn grow_cracks(&mut self, length: f64) -> Result<Growth> {
        Ok(Growth::from_raw(&self.handle.grow_cracks(length)?))
    }

    /// Keeps the tip at an end of a crack from growing, or lets it grow again.
    ///
    /// ```
    /// use bempd::{Component, Material, Model, TipEnd, Values, FaceComponent};
    ///
    /// # fn main() -> bempd::Result<()> {
    /// let mut model = Model::new()?;
    /// let glass = model.add_material(&Material::new(1.0, 0.3).fracture_energy(1.0))?;
    /// model.add_bem_region(glass, &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 0.5)?;
    /// let crack = model.add_crack(&[[-0.3, 0.0], [0.3, 0.0]])?;
    /// model.fix_point([-1.0, -1.0], Component::Both)?;
    /// model.fix_point([1.0, -1.0], Component::Y)?;
    /// model.add_crack_traction(crack, FaceComponent::Pressure, Values::proportional(&[1.0]))?;
    /// model.set_tip_frozen(crack, TipEnd::Start, true)?;
    /// let growth = model.grow_cracks(0.1)?;
    /// let extensions = model.extensions()?;
    /// assert_eq!((growth.tips, extensions.len(), extensions[0].end), (1, 1, TipEnd::End));
    /// assert!((extensions[0].x - 0.4).abs() < 1e-6);
    /// assert!((extensions[0].energy_release_rate_before - 1.0).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    pub fn set_tip_frozen(&mut self, crack: CrackId, end: TipEnd, frozen: bool) -> Result<()> {
        self.handle.set_tip_frozen(crack.0, end.raw(), frozen)
    }

    /// What every tip did in every call of `grow_cracks`, in order.
    pub fn extensions(&self) -> Result<Vec<CrackExtension>> {
        (0..self.handle.extension_count()?)
            .map(|index| Ok(CrackExtension::from_raw(&self.handle.extension(index)?)))
            .collect()
    }

    /// Number of cracks: those that were described and, with the next ids, those that began in the run.
    pub fn crack_count(&self) -> Result<i64> {
        self.handle.crack_count()
    }

    /// Length of a crack's path with what it has grown by [m].
    pub fn crack_length(&self, crack: CrackId) -> Result<f64> {
        self.handle.crack_length(crack.0)
    }

    /// Length of all cracks together [m].
    pub fn total_crack_length(&self) -> Result<f64> {
        self.handle.crack_length(0)
    }

    /// Vertices of a crack from its start to its end: the described points, and those to which it has grown.
    ///
    /// ```
    /// use bempd::{Component, Material, Model, Values};
    ///
    /// # fn main() -> bempd::Result<()> {
    /// let mut model = Model::new()?;
    /// let glass = model.add_material(&Material::new(1.0, 0.2).fracture_energy(1.0))?;
    /// let plate = model.add_bem_region(glass, &[[-1.0, -3.0], [1.0, -3.0], [1.0, 3.0], [-1.0, 3.0]], 0.5)?;
    /// let crack = model.add_crack(&[[-1.0, 0.0], [0.0, 0.0]])?;
    /// model.fix_point([-1.0, -3.0], Component::Both)?;
    /// model.fix_point([1.0, -3.0], Component::Y)?;
    /// model.add_traction(plate, 3, .., Component::Y, Values::proportional(&[1.0]))?;
    /// model.add_traction(plate, 1, .., Component::Y, Values::proportional(&[-1.0]))?;
    /// model.grow_cracks(0.1)?;
    ///
    /// let path = model.crack_path(crack)?;
    /// assert_eq!((path.len(), path[2].event, model.crack_count()?), (3, 1, 1));
    /// assert!(path[1].load_factor.is_nan() && (model.crack_length(crack)? - 1.1).abs() < 1e-6);
    /// assert_eq!(model.total_crack_length()?, model.crack_length(crack)?);
    /// # Ok(())
    /// # }
    /// ```
    pub fn crack_path(&self, crack: CrackId) -> Result<Vec<PathVertex>> {
        (0..self.handle.crack_path_count(crack.0)?)
            .map(|index| Ok(PathVertex::from_raw(&self.handle.crack_path(crack.0, index)?)))
            .collect()
    }

    /// Openings of a crack at places given as fractions of its length; NaN where they are not known.
    pub fn crack_opening(&self, crack: CrackId, fractions: &[f64]) -> Result<CrackOpening> {
        let (normal, tangential) = self.handle.crack_opening(crack.0, fractions)?;
        Ok(CrackOpening { normal, tangential })
    }

    /// Present load factor [-].
    pub fn load_factor(&self) -> Result<f64> {
        self.handle.load_factor()
    }

    /// Number that changes whenever the model's fields may have changed.
    pub fn generation(&self) -> Result<i64> {
        self.handle.generation()
    }

    /// Elements, unknowns, memory, time and errors of a scene with bodies, before anything expensive is solved.
    pub fn plan(&self) -> Result<BodyPlan> {
        Ok(BodyPlan::from_raw(&self.handle.plan()?))
    }

    /// Errors of the present results by source; it solves the scene with longer elements.
    pub fn error_estimate(&self) -> Result<Errors> {
        Ok(Errors::from_raw(&self.handle.error_estimate()?))
    }

    /// Errors of peak and paths of the run so far, which is run again if that takes at most `seconds_allowed`.
    pub fn run_error_estimate(&self, seconds_allowed: f64) -> Result<RunErrors> {
        Ok(RunErrors::from_raw(&self.handle.run_error_estimate(seconds_allowed)?))
    }

    /// Sizes, counters and times so far.
    pub fn statistics(&self) -> Result<Statistics> {
        Ok(Statistics::from_raw(&self.handle.statistics()?))
    }

    /// Number of lines of the history: one per event and per end of a step.
    pub fn history_count(&self) -> Result<usize> {
        self.handle.history_count().map(|count| count as usize)
    }

    /// A line of the history, from 0.
    pub fn history_entry(&self, index: usize) -> Result<HistoryEntry> {
        Ok(HistoryEntry::from_raw(&self.handle.history_entry(index as i64)?))
    }

    /// What a support did at a line of the history, from 0.
    pub fn history_support(&self, index: usize, support: SupportId) -> Result<HistorySupport> {
        let [displacement, force, force_before] = self.handle.history_support(index as i64, support.0)?;
        Ok(HistorySupport { displacement, force, force_before })
    }

    /// The whole history.
    pub fn history(&self) -> Result<Vec<HistoryEntry>> {
        (0..self.history_count()?).map(|index| self.history_entry(index)).collect()
    }
}
