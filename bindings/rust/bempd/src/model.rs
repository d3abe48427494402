use std::fmt;
use std::ops::ControlFlow;
use std::path::Path;

use crate::raw::Handle;
use crate::{
    CancelToken, CrackId, Error, LoadId, LogLevel, Material, MaterialId, PhaseProgress, ProgramColumn, Progress,
    RegionId, Result, State, StepReport, SupportId, Treatment, Turn, Until,
};

/// A scene and its state. Dropping it frees everything.
///
/// It may move between threads but not be shared by them; a [`CancelToken`] may be used anywhere.
///
/// ```
/// fn movable<T: Send>() {}
/// movable::<bempd::Model>();
/// ```
///
/// ```compile_fail,E0277
/// fn shareable<T: Sync>() {}
/// shareable::<bempd::Model>();
/// ```
pub struct Model {
    pub(crate) handle: Handle,
}

impl Model {
    /// An empty model.
    pub fn new() -> Result<Model> {
        Ok(Model { handle: Handle::new()? })
    }

    /// A token with which any thread can stop a step of this model.
    pub fn cancel_token(&self) -> CancelToken {
        CancelToken(self.handle.cancel_target())
    }
}

/// # Materials, regions and cracks
impl Model {
    /// Adds a material.
    pub fn add_material(&mut self, material: &Material) -> Result<MaterialId> {
        self.handle.add_material(material).map(MaterialId)
    }

    /// Adds a polygon with straight edges whose boundary elements the library chooses by the option `error.wanted`. A body
    /// is a region: cracks, supports, loads and results take it like one.
    pub fn add_body(&mut self, material: MaterialId, vertices: &[[f64; 2]]) -> Result<RegionId> {
        self.handle.add_body(material.0, vertices).map(RegionId)
    }

    /// Chooses the lattice of the patches of a body; 0 leaves spacing or horizon to the library.
    pub fn set_body_lattice(&mut self, body: RegionId, spacing: f64, horizon_ratio: i32) -> Result<()> {
        self.handle.set_body_lattice(body.0, spacing, horizon_ratio)
    }

    /// Chooses how a crack is modelled, or freezes its tips.
    pub fn set_crack_treatment(&mut self, crack: CrackId, treatment: Treatment) -> Result<()> {
        self.handle.set_crack_treatment(crack.0, treatment as i32)
    }

    /// Adds a body with edges that may be circular arcs; `bulges` are as in [`Model::add_bem_region_with_arcs`].
    pub fn add_body_with_arcs(
        &mut self,
        material: MaterialId,
        vertices: &[[f64; 2]],
        bulges: &[f64],
    ) -> Result<RegionId> {
        self.handle.add_body_with_arcs(material.0, vertices, bulges).map(RegionId)
    }

    /// Adds a polygon with straight edges treated by boundary elements. `vertices` run counter-clockwise [m]; edge `k`,
    /// from 1, goes from vertex `k` to the next one. No element is longer than `element_length` [m].
    ///
    /// Edges that coincide with edges of other regions become interfaces and are bonded; there the elements follow the
    /// peridynamic lattice unless [`Model::set_edge_mesh`] is called, or the finer of two boundary meshes.
    pub fn add_bem_region(
        &mut self,
        material: MaterialId,
        vertices: &[[f64; 2]],
        element_length: f64,
    ) -> Result<RegionId> {
        self.handle.add_bem_region(material.0, vertices, element_length).map(RegionId)
    }

    /// Adds a region as [`Model::add_bem_region`] does, with edges that may be circular arcs. `bulges`, one for each edge,
    /// are the tangent of a quarter of the angle that the edge turns: 0 for a straight one, 1 for half a circle that
    /// bulges out of the body (as in DXF files).
    pub fn add_bem_region_with_arcs(
        &mut self,
        material: MaterialId,
        vertices: &[[f64; 2]],
        bulges: &[f64],
        element_length: f64,
    ) -> Result<RegionId> {
        self.handle.add_bem_region_with_arcs(material.0, vertices, bulges, element_length).map(RegionId)
    }

    /// Adds a round region treated by boundary elements no longer than `element_length` [m]: four quarter circles,
    /// counter-clockwise from the place with the largest x.
    pub fn add_bem_disc(
        &mut self,
        material: MaterialId,
        centre: [f64; 2],
        radius: f64,
        element_length: f64,
    ) -> Result<RegionId> {
        self.handle.add_bem_disc(material.0, centre, radius, element_length).map(RegionId)
    }

    /// Adds a polygon treated by peridynamics. With edges parallel to the axes it is square lattice cells of size
    /// `spacing` [m], which must divide all edges, with material points on their corners; with others material points
    /// lie on the edges, about `spacing` apart, and on a lattice inside. `vertices` run counter-clockwise [m].
    ///
    /// `horizon_ratio` is horizon over spacing, 2 to 8; `None` stands for 4.
    pub fn add_pd_region(
        &mut self,
        material: MaterialId,
        vertices: &[[f64; 2]],
        spacing: f64,
        horizon_ratio: impl Into<Option<i32>>,
    ) -> Result<RegionId> {
        let ratio = horizon_ratio.into().unwrap_or(0);
        self.handle.add_pd_region(material.0, vertices, spacing, ratio).map(RegionId)
    }

    /// Adds a region as [`Model::add_pd_region`] does, with edges that may be circular arcs, given as for
    /// [`Model::add_bem_region_with_arcs`].
    pub fn add_pd_region_with_arcs(
        &mut self,
        material: MaterialId,
        vertices: &[[f64; 2]],
        bulges: &[f64],
        spacing: f64,
        horizon_ratio: impl Into<Option<i32>>,
    ) -> Result<RegionId> {
        let ratio = horizon_ratio.into().unwrap_or(0);
        self.handle.add_pd_region_with_arcs(material.0, vertices, bulges, spacing, ratio).map(RegionId)
    }

    /// Adds a region as [`Model::add_pd_region`] does, with a lattice whose rows are turned by `angle` from the x axis
    /// [rad], counter-clockwise; other than 0 there are material points on all edges.
    pub fn add_turned_pd_region(
        &mut self,
        material: MaterialId,
        vertices: &[[f64; 2]],
        spacing: f64,
        horizon_ratio: impl Into<Option<i32>>,
        angle: f64,
    ) -> Result<RegionId> {
        let ratio = horizon_ratio.into().unwrap_or(0);
        self.handle.add_turned_pd_region(material.0, vertices, spacing, ratio, angle).map(RegionId)
    }

    /// Cuts a hole into a region and returns the number of its first edge: the hole's edges continue the region's
    /// numbering. `vertices` run clockwise, with the body on the left [m].
    pub fn add_hole(&mut self, region: RegionId, vertices: &[[f64; 2]]) -> Result<i32> {
        self.handle.add_hole(region.0, vertices)
    }

    /// Cuts a hole as [`Model::add_hole`] does, with edges that may be circular arcs: a bulge of -1 is half a circle that
    /// bulges into the body.
    pub fn add_hole_with_arcs(&mut self, region: RegionId, vertices: &[[f64; 2]], bulges: &[f64]) -> Result<i32> {
        self.handle.add_hole_with_arcs(region.0, vertices, bulges)
    }

    /// Cuts a circular hole into a boundary element region [m] and returns the number of its first edge: four quarter
    /// circles, clockwise from the place with the largest x.
    pub fn add_circular_hole(&mut self, region: RegionId, centre: [f64; 2], radius: f64) -> Result<i32> {
        self.handle.add_circular_hole(region.0, centre, radius)
    }

    /// Makes an edge of a boundary element region the circular arc through a place between its ends [m].
    pub fn set_edge_arc(&mut self, region: RegionId, edge: i32, place: [f64; 2]) -> Result<()> {
        self.handle.set_edge_arc(region.0, edge, place)
    }

    /// Makes an edge of a boundary element region the circular arc about a centre, on which both of its vertices lie,
    /// turning from the first one to the last one [m].
    pub fn set_edge_arc_about(
        &mut self,
        region: RegionId,
        edge: i32,
        centre: [f64; 2],
        radius: f64,
        turn: Turn,
    ) -> Result<()> {
        self.handle.set_edge_arc_about(region.0, edge, centre, radius, turn as i32)
    }

    /// Makes a row of edges of a boundary element region a smooth curve through their vertices.
    pub fn set_edges_smooth(&mut self, region: RegionId, first_edge: i32, last_edge: i32) -> Result<()> {
        self.handle.set_edges_smooth(region.0, first_edge, last_edge)
    }

    /// Chooses the elements of one edge of a boundary element region: `ceil(length / element_length)` of them [m],
    /// whose lengths grow from both ends by the ratio `grading`, 1 to 4; 1 is for equal ones.
    ///
    /// On an interface with a peridynamic region they need not match the lattice then.
    pub fn set_edge_mesh(&mut self, region: RegionId, edge: i32, element_length: f64, grading: f64) -> Result<()> {
        self.handle.set_edge_mesh(region.0, edge, element_length, grading)
    }

    /// Gives a region fracture energies \[J/m^2\] at places, in place of the one of its material: linear on the Delaunay
    /// triangles of the places, and outside them that of the nearest place on their border.
    pub fn set_toughness_at(&mut self, region: RegionId, places: &[[f64; 2]], values: &[f64]) -> Result<()> {
        self.handle.set_toughness_at(region.0, places, values)
    }

    /// Gives a material fracture energies \[J/m^2\] by the growth of a tip \[m\] (R-curve), in place of its one: linear
    /// between the rows, constant beyond them.
    pub fn set_resistance_curve(&mut self, material: MaterialId, extensions: &[f64], energies: &[f64]) -> Result<()> {
        self.handle.set_resistance_curve(material.0, extensions, energies)
    }

    /// Gives a material fracture energies \[J/m^2\] by the direction of a crack \[rad\], ascending within half a turn. A
    /// tip goes where its energy release rate over the energy is largest.
    pub fn set_resistance_directions(&mut self, material: MaterialId, angles: &[f64], energies: &[f64]) -> Result<()> {
        self.handle.set_resistance_directions(material.0, angles, energies)
    }

    /// Adds an initial crack: bonds that meet the closed polyline are cut (touching its tip counts). It must lie in
    /// peridynamic regions (ending on their boundary is fine); material points on it it passes by on its right.
    pub fn add_crack(&mut self, line: &[[f64; 2]]) -> Result<CrackId> {
        self.handle.add_crack(line).map(CrackId)
    }

    /// Removes a region that bears no support or load, before the model is prepared; other ids stay.
    pub fn remove_region(&mut self, region: RegionId) -> Result<()> {
        self.handle.remove_region(region.0)
    }

    /// Removes an initial crack before the model is prepared; other ids stay.
    pub fn remove_crack(&mut self, crack: CrackId) -> Result<()> {
        self.handle.remove_crack(crack.0)
    }

    /// Number of regions, with those that were removed.
    pub fn region_count(&self) -> Result<usize> {
        self.handle.region_count().map(|count| count as usize)
    }

    /// Number of edges of a region with its holes.
    pub fn edge_count(&self, region: RegionId) -> Result<usize> {
        self.handle.edge_count(region.0).map(|count| count as usize)
    }

    /// Names a region: messages, the log and files then show the name behind the number. An empty name takes it away.
    pub fn name_region(&mut self, region: RegionId, name: &str) -> Result<()> {
        self.handle.name_region(region.0, name)
    }

    /// Names an edge, as [`Model::name_region`] does a region; several edges may have one name.
    pub fn name_edge(&mut self, region: RegionId, edge: i32, name: &str) -> Result<()> {
        self.handle.name_edge(region.0, edge, name)
    }

    /// Names a support, as [`Model::name_region`] does a region.
    pub fn name_support(&mut self, support: SupportId, name: &str) -> Result<()> {
        self.handle.name_support(support.0, name)
    }

    /// Names a load, as [`Model::name_region`] does a region.
    pub fn name_load(&mut self, load: LoadId, name: &str) -> Result<()> {
        self.handle.name_load(load.0, name)
    }

    /// Number of the edge with a name; an error if there is none, or several.
    pub fn edge_named(&self, region: RegionId, name: &str) -> Result<i32> {
        self.handle.edge_named(region.0, name)
    }
}

/// # Progress and log
impl Model {
    /// Tells `function` after every event where a step stands. If it breaks off, the step returns to its start and fails
    /// with [`Error::Cancelled`].
    ///
    /// ```
    /// # let mut model = bempd::Model::new()?;
    /// use std::ops::ControlFlow;
    /// model.set_progress(|now| if now.events < 1000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) })?;
    /// # Ok::<(), bempd::Error>(())
    /// ```
    pub fn set_progress(&mut self, function: impl FnMut(Progress) -> ControlFlow<()> + Send + 'static) -> Result<()> {
        self.handle.set_progress(Some(Box::new(function)))
    }

    /// No longer tells of progress.
    pub fn clear_progress(&mut self) -> Result<()> {
        self.handle.set_progress(None)
    }

    /// Tells `function` how far a long part of a call is, ten times a second at most. If it breaks off, the call fails
    /// with [`Error::Cancelled`] and leaves the model as it was.
    ///
    /// ```
    /// # let mut model = bempd::Model::new()?;
    /// use std::ops::ControlFlow;
    /// model.set_phase_progress(|now| {
    ///     eprintln!("{}: {:.0} %", now.phase, 100.0 * now.share);
    ///     ControlFlow::Continue(())
    /// })?;
    /// # Ok::<(), bempd::Error>(())
    /// ```
    pub fn set_phase_progress(
        &mut self,
        function: impl FnMut(PhaseProgress) -> ControlFlow<()> + Send + 'static,
    ) -> Result<()> {
        self.handle.set_phase_progress(Some(Box::new(function)))
    }

    /// No longer tells of long parts.
    pub fn clear_phase_progress(&mut self) -> Result<()> {
        self.handle.set_phase_progress(None)
    }

    /// Gives `function` the lines of the log.
    ///
    /// ```
    /// # let mut model = bempd::Model::new()?;
    /// model.set_log(|level, line| eprintln!("{level:?}: {line}"))?;
    /// # Ok::<(), bempd::Error>(())
    /// ```
    pub fn set_log(&mut self, function: impl FnMut(LogLevel, &str) + Send + 'static) -> Result<()> {
        self.handle.set_log(Some(Box::new(function)))
    }

    /// No longer gives the log.
    pub fn clear_log(&mut self) -> Result<()> {
        self.handle.set_log(None)
    }
}

/// # Stepping
impl Model {
    /// Checks the scene and builds its operators. The first step does it if you do not. From then on nothing can be
    /// added; loads and supports can still change their values.
    pub fn prepare(&mut self) -> Result<()> {
        self.handle.prepare()
    }

    /// Moves the load factor up or down, breaking what reaches its critical load on the way.
    pub fn step(&mut self, load_factor: f64) -> Result<StepReport> {
        Ok(StepReport::from_raw(&self.handle.step(load_factor)?))
    }

    /// Goes to the next event, no further than to the limit up or down, and performs it: one batch of bonds.
    pub fn step_to_next_event(&mut self, load_factor_limit: f64) -> Result<StepReport> {
        Ok(StepReport::from_raw(&self.handle.step_to_next_event(load_factor_limit)?))
    }

    /// Goes on until the body is separated, no bond can break any more, or the limit is reached.
    pub fn run_to_separation(&mut self, load_factor_limit: f64) -> Result<StepReport> {
        Ok(StepReport::from_raw(&self.handle.run_to_separation(load_factor_limit)?))
    }

    /// Goes from the values with which the last step ended to those that loads and supports have now, on a straight
    /// line, while the load factor goes to the one given: the time of a host, say. The same call goes on where a step
    /// has ended on the way.
    pub fn step_to_values(&mut self, load_factor: f64, until: Until) -> Result<StepReport> {
        Ok(StepReport::from_raw(&self.handle.step_to_values(load_factor, until as i32)?))
    }

    /// Goes through a table of factors by time, on straight lines between its rows: `factors` has one for each column
    /// in each row, or, without columns, one a row for all supports and loads. The load factor is the time.
    pub fn run_program(
        &mut self,
        times: &[f64],
        columns: &[ProgramColumn],
        factors: &[f64],
        until: Until,
    ) -> Result<StepReport> {
        let needed = times.len() * columns.len().max(1);
        if factors.len() != needed {
            return Err(Error::Argument(format!(
                "run_program: there are {} factors; give {needed}, one for each time and column",
                factors.len()
            )));
        }
        let kinds: Vec<i32> = columns.iter().map(|column| column.kind()).collect();
        let ids: Vec<i32> = columns.iter().map(|column| column.id()).collect();
        Ok(StepReport::from_raw(&self.handle.run_program(times, &kinds, &ids, factors, until as i32)?))
    }

    /// Saves the state of a prepared model in memory, so that a host can repeat a step.
    pub fn save(&mut self) -> Result<State> {
        self.handle.save()
    }

    /// Saves the state with the values of loads and supports, which [`Model::restore`] then brings back.
    pub fn save_with_values(&mut self) -> Result<State> {
        self.handle.save_with_values()
    }

    /// Brings the model back to a saved state, of this model or one with the same scene. Loads and supports keep their
    /// present values, unless it was saved with theirs.
    pub fn restore(&mut self, state: &State) -> Result<()> {
        self.handle.restore(state)
    }
}

/// # Files
impl Model {
    /// Writes the present state for ParaView, which opens `prefix.pvd`: all snapshots with this prefix, with lattices,
    /// boundaries, the inside of BEM regions and cracks as parts. The folder must exist; files of another run with this
    /// prefix are an error of kind `Io` unless the option `snapshots.existing` is `continue` or `replace`.
    pub fn write_snapshot(&mut self, prefix: impl AsRef<Path>) -> Result<()> {
        self.handle.write_snapshot(utf8(prefix.as_ref())?)
    }

    /// Writes the history with the reactions of all supports as comma-separated values.
    pub fn write_history(&self, path: impl AsRef<Path>) -> Result<()> {
        self.handle.write_history(utf8(path.as_ref())?)
    }

    /// Writes what [`Model::tip_history`] has as comma-separated values.
    pub fn write_tips(&self, path: impl AsRef<Path>) -> Result<()> {
        self.handle.write_tips(utf8(path.as_ref())?)
    }
}

pub(crate) fn utf8(path: &Path) -> Result<&str> {
    path.to_str().ok_or_else(|| Error::Argument(format!("{path:?} is not UTF-8; give a path that is")))
}

impl fmt::Debug for Model {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Model").finish_non_exhaustive()
    }
}
