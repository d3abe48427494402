use std::slice;

use bempd_sys as sys;

use super::handle::{filled, Handle};
use super::points;
use crate::Result;

/// A field seen without copying. It borrows the model, which can therefore not change while the view lives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View<'a> {
    values: &'a [f64],
    components: usize,
    generation: i64,
}

impl<'a> View<'a> {
    /// All numbers, entry after entry.
    pub fn values(&self) -> &'a [f64] {
        self.values
    }

    /// The entries as arrays of `N` numbers, such as `[f64; 2]` of displacements; `None` if entries have not `N` numbers.
    pub fn entries<const N: usize>(&self) -> Option<&'a [[f64; N]]> {
        if N == 0 || N != self.components {
            return None;
        }
        let (start, count) = (self.values.as_ptr().cast(), self.values.len() / N);
        // SAFETY: the slice holds that many arrays, one after another, and lives as long as the view.
        Some(unsafe { slice::from_raw_parts(start, count) })
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.values.len() / self.components
    }

    /// Whether the field has no entries.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Numbers per entry.
    pub fn components(&self) -> usize {
        self.components
    }

    /// The model's generation when the view was made.
    pub fn generation(&self) -> i64 {
        self.generation
    }
}

// SAFETY, for every call of this file: `call` and `output` give a valid model and place for the result, arrays are given
// with their own length, and structs were filled by their `_init` function.
impl Handle {
    /// Shared borrows suffice, also for several views at a time: a view is of a prepared model in equilibrium, of which
    /// no method with `&self` changes the generation.
    pub(crate) fn view(&self, region: i32, field: i32) -> Result<View<'_>> {
        let (mut values, mut count, mut components, mut generation) = (std::ptr::null(), 0i64, 0i32, 0i64);
        self.call(|model| unsafe {
            sys::bempd_view_field(model, region, field, &mut values, &mut count, &mut components, &mut generation)
        })?;
        let components = components as usize;
        let values = match count as usize * components {
            0 => &[],
            // SAFETY: the library owns so many numbers there until the generation changes, which takes `&mut self`.
            size => unsafe { slice::from_raw_parts(values, size) },
        };
        Ok(View { values, components, generation })
    }

    pub(crate) fn field_size(&self, region: i32, field: i32) -> Result<(i64, i32)> {
        let mut components = 0;
        let count =
            self.output(|model, count| unsafe { sys::bempd_field_size(model, region, field, count, &mut components) })?;
        Ok((count, components))
    }

    pub(crate) fn copy_field(&self, region: i32, field: i32, values: &mut [f64]) -> Result<()> {
        let (capacity, start) = (values.len() as i64, values.as_mut_ptr());
        self.call(|model| unsafe { sys::bempd_copy_field(model, region, field, capacity, start) })
    }

    pub(crate) fn node_count(&self, region: i32) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_node_count(model, region, count) })
    }

    pub(crate) fn element_count(&self, region: i32) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_element_count(model, region, count) })
    }

    pub(crate) fn copy_elements(&self, region: i32, nodes: &mut [i32]) -> Result<()> {
        let (capacity, start) = (nodes.len() as i64, nodes.as_mut_ptr());
        self.call(|model| unsafe { sys::bempd_copy_elements(model, region, capacity, start) })
    }

    pub(crate) fn bond_count(&self, region: i32) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_bond_count(model, region, count) })
    }

    /// Ends and states of as many bonds as both slices have room for.
    pub(crate) fn copy_bonds(&self, region: i32, ends: &mut [[i32; 2]], states: &mut [i32]) -> Result<()> {
        let capacity = ends.len().min(states.len()) as i64;
        let (ends, states) = (ends.as_mut_ptr().cast(), states.as_mut_ptr());
        self.call(|model| unsafe { sys::bempd_copy_bonds(model, region, capacity, ends, states) })
    }

    pub(crate) fn reaction(&self, support: i32) -> Result<[f64; 2]> {
        let mut force = [0.0; 2];
        self.call(|model| unsafe { sys::bempd_reaction(model, support, force.as_mut_ptr()) })?;
        Ok(force)
    }

    pub(crate) fn reaction_moment(&self, support: i32, about: [f64; 2]) -> Result<f64> {
        let [x, y] = about;
        self.output(|model, moment| unsafe { sys::bempd_reaction_moment(model, support, x, y, moment) })
    }

    /// Displacement, force, and force before.
    pub(crate) fn history_support(&self, index: i64, support: i32) -> Result<[[f64; 2]; 3]> {
        let mut values = [[0.0; 2]; 3];
        let [displacement, force, before] = &mut values;
        self.call(|model| unsafe {
            sys::bempd_get_history_support(
                model,
                index,
                support,
                displacement.as_mut_ptr(),
                force.as_mut_ptr(),
                before.as_mut_ptr(),
            )
        })?;
        Ok(values)
    }

    pub(crate) fn admissible_load_factors(&self) -> Result<(f64, f64)> {
        let (mut lowest, mut highest) = (0.0, 0.0);
        self.call(|model| unsafe { sys::bempd_admissible_load_factors(model, &mut lowest, &mut highest) })?;
        Ok((lowest, highest))
    }

    pub(crate) fn evaluate(&self, places: &[[f64; 2]]) -> Result<(Vec<[f64; 2]>, Vec<[f64; 3]>, Vec<i32>)> {
        let mut displacement = vec![[0.0; 2]; places.len()];
        let mut stress = vec![[0.0; 3]; places.len()];
        let mut regions = vec![0; places.len()];
        let (count, places) = points(places);
        let outputs = (displacement.as_mut_ptr().cast(), stress.as_mut_ptr().cast(), regions.as_mut_ptr());
        self.call(|model| unsafe { sys::bempd_evaluate(model, count, places, outputs.0, outputs.1, outputs.2) })?;
        Ok((displacement, stress, regions))
    }

    pub(crate) fn evaluate_errors(&self, places: &[[f64; 2]]) -> Result<(Vec<f64>, Vec<f64>)> {
        let (mut displacement, mut stress) = (vec![0.0; places.len()], vec![0.0; places.len()]);
        let (count, places) = points(places);
        let outputs = (displacement.as_mut_ptr(), stress.as_mut_ptr());
        self.call(|model| unsafe { sys::bempd_evaluate_errors(model, count, places, outputs.0, outputs.1) })?;
        Ok((displacement, stress))
    }

    pub(crate) fn stress_orders(&self, places: &[[f64; 2]]) -> Result<Vec<f64>> {
        let mut orders = vec![0.0; places.len()];
        let (count, places) = points(places);
        let output = orders.as_mut_ptr();
        self.call(|model| unsafe { sys::bempd_stress_orders(model, count, places, output) })?;
        Ok(orders)
    }

    pub(crate) fn evaluate_displacement(&self, places: &[[f64; 2]]) -> Result<Vec<[f64; 2]>> {
        let mut displacement = vec![[0.0; 2]; places.len()];
        let (count, places) = points(places);
        let (output, none) = (displacement.as_mut_ptr().cast(), std::ptr::null_mut());
        self.call(|model| unsafe { sys::bempd_evaluate(model, count, places, output, none, std::ptr::null_mut()) })?;
        Ok(displacement)
    }

    pub(crate) fn edge_reaction(&self, region: i32, edge: i32, [x, y]: [f64; 2]) -> Result<([f64; 2], f64)> {
        let mut force = [0.0; 2];
        let moment = self.output(|model, moment| unsafe {
            sys::bempd_edge_reaction(model, region, edge, x, y, force.as_mut_ptr(), moment)
        })?;
        Ok((force, moment))
    }

    pub(crate) fn evaluate_in(
        &self,
        region: i32,
        face: i32,
        places: &[[f64; 2]],
    ) -> Result<(Vec<[f64; 2]>, Vec<[f64; 3]>)> {
        let mut displacement = vec![[0.0; 2]; places.len()];
        let mut stress = vec![[0.0; 3]; places.len()];
        let (count, places) = points(places);
        let outputs = (displacement.as_mut_ptr().cast(), stress.as_mut_ptr().cast());
        self.call(|model| unsafe { sys::bempd_evaluate_in(model, region, face, count, places, outputs.0, outputs.1) })?;
        Ok((displacement, stress))
    }

    pub(crate) fn piece_count(&self) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_piece_count(model, count) })
    }

    pub(crate) fn piece(&self, number: i32) -> Result<sys::bempd_piece> {
        let mut piece = filled(sys::bempd_piece_init)?;
        self.call(|model| unsafe { sys::bempd_get_piece(model, number, &mut piece) })?;
        Ok(piece)
    }

    pub(crate) fn node_pieces(&self, region: i32) -> Result<Vec<i32>> {
        let count = self.node_count(region)?;
        let mut pieces = vec![0; count as usize];
        self.call(|model| unsafe { sys::bempd_copy_node_pieces(model, region, count, pieces.as_mut_ptr()) })?;
        Ok(pieces)
    }

    pub(crate) fn support_piece(&self, support: i32) -> Result<i32> {
        self.output(|model, piece| unsafe { sys::bempd_support_piece(model, support, piece) })
    }

    pub(crate) fn load_piece(&self, load: i32) -> Result<i32> {
        self.output(|model, piece| unsafe { sys::bempd_load_piece(model, load, piece) })
    }

    pub(crate) fn are_connected(&self, support: i32, other: i32) -> Result<i32> {
        self.output(|model, connected| unsafe { sys::bempd_are_connected(model, support, other, connected) })
    }

    pub(crate) fn singularity_count(&self) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_singularity_count(model, count) })
    }

    pub(crate) fn singularity(&self, index: i64) -> Result<sys::bempd_singularity> {
        let mut singularity = filled(sys::bempd_singularity_init)?;
        self.call(|model| unsafe { sys::bempd_get_singularity(model, index, &mut singularity) })?;
        Ok(singularity)
    }

    /// What comes next, and sentences.
    pub(crate) fn explain(&self, rising: bool) -> Result<(sys::bempd_explanation, String)> {
        let mut explanation = filled(sys::bempd_explanation_init)?;
        let way = i32::from(rising);
        let needed = self.output(|model, needed| unsafe {
            sys::bempd_explain(model, way, &mut explanation, std::ptr::null_mut(), 0, needed)
        })?;
        let mut buffer = vec![0u8; needed as usize];
        self.call(|model| unsafe {
            let start = buffer.as_mut_ptr().cast();
            sys::bempd_explain(model, way, std::ptr::null_mut(), start, needed, std::ptr::null_mut())
        })?;
        buffer.pop();
        Ok((explanation, String::from_utf8_lossy(&buffer).into_owned()))
    }

    pub(crate) fn tip_count(&self) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_tip_count(model, count) })
    }

    pub(crate) fn tip(&self, index: i64) -> Result<sys::bempd_crack_tip> {
        let mut tip = filled(sys::bempd_crack_tip_init)?;
        self.call(|model| unsafe { sys::bempd_tip(model, index, &mut tip) })?;
        Ok(tip)
    }

    pub(crate) fn tip_history_count(&self) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_tip_history_count(model, count) })
    }

    /// Event, broken bonds, load factor and tip.
    pub(crate) fn tip_record(&self, index: i64) -> Result<(i64, i64, f64, sys::bempd_crack_tip)> {
        let mut tip = filled(sys::bempd_crack_tip_init)?;
        let (mut event, mut broken, mut factor) = (0, 0, 0.0);
        self.call(|model| unsafe {
            sys::bempd_get_tip_history(model, index, &mut event, &mut broken, &mut factor, &mut tip)
        })?;
        Ok((event, broken, factor, tip))
    }

    pub(crate) fn grow_cracks(&mut self, length: f64) -> Result<sys::bempd_growth> {
        let mut growth = filled(sys::bempd_growth_init)?;
        self.call(|model| unsafe { sys::bempd_grow_cracks(model, length, &mut growth) })?;
        Ok(growth)
    }

    pub(crate) fn extend_cracks(&mut self, cracks: &[i32], ends: &[i32], lengths: &[f64]) -> Result<sys::bempd_growth> {
        let mut growth = filled(sys::bempd_growth_init)?;
        self.call(|model| unsafe {
            sys::bempd_extend_cracks(
                model,
                cracks.len() as i64,
                cracks.as_ptr(),
                ends.as_ptr(),
                lengths.as_ptr(),
                &mut growth,
            )
        })?;
        Ok(growth)
    }

    pub(crate) fn set_growth_rate(&mut self, material: i32, fill: impl Fn(&mut sys::bempd_growth_rate)) -> Result<()> {
        let mut rate = filled(sys::bempd_growth_rate_init)?;
        fill(&mut rate);
        self.call(|model| unsafe { sys::bempd_set_growth_rate(model, material, &rate) })
    }

    /// `blocks`: high and low load factors, and cycles.
    pub(crate) fn grow_fatigue(
        &mut self,
        blocks: &[[f64; 3]],
        fill: impl Fn(&mut sys::bempd_fatigue),
    ) -> Result<sys::bempd_fatigue_report> {
        let column = |k: usize| blocks.iter().map(|block| block[k]).collect::<Vec<f64>>();
        let (high, low, cycles) = (column(0), column(1), column(2));
        let mut options = filled(sys::bempd_fatigue_init)?;
        fill(&mut options);
        let mut report = filled(sys::bempd_fatigue_report_init)?;
        self.call(|model| unsafe {
            sys::bempd_grow_fatigue(
                model,
                blocks.len() as i64,
                high.as_ptr(),
                low.as_ptr(),
                cycles.as_ptr(),
                &options,
                &mut report,
            )
        })?;
        Ok(report)
    }

    /// `factors`: high and low factors of all load cases for each block, one block after the other.
    pub(crate) fn grow_fatigue_cases(
        &mut self,
        cases: usize,
        factors: (&[f64], &[f64]),
        cycles: &[f64],
        fill: impl Fn(&mut sys::bempd_fatigue),
    ) -> Result<sys::bempd_fatigue_report> {
        let mut options = filled(sys::bempd_fatigue_init)?;
        fill(&mut options);
        let mut report = filled(sys::bempd_fatigue_report_init)?;
        let (blocks, cases) = (cycles.len() as i64, cases as i64);
        let (high, low) = (factors.0.as_ptr(), factors.1.as_ptr());
        self.call(|model| unsafe {
            sys::bempd_grow_fatigue_cases(model, blocks, cases, high, low, cycles.as_ptr(), &options, &mut report)
        })?;
        Ok(report)
    }

    pub(crate) fn fatigue_record_count(&self) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_fatigue_record_count(model, count) })
    }

    pub(crate) fn fatigue_record(&self, index: i64) -> Result<sys::bempd_fatigue_record> {
        let mut record = filled(sys::bempd_fatigue_record_init)?;
        self.call(|model| unsafe { sys::bempd_get_fatigue_record(model, index, &mut record) })?;
        Ok(record)
    }

    pub(crate) fn set_tip_frozen(&mut self, crack: i32, end: i32, frozen: bool) -> Result<()> {
        self.call(|model| unsafe { sys::bempd_set_tip_frozen(model, crack, end, frozen.into()) })
    }

    pub(crate) fn extension_count(&self) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_extension_count(model, count) })
    }

    pub(crate) fn extension(&self, index: i64) -> Result<sys::bempd_crack_extension> {
        let mut extension = filled(sys::bempd_crack_extension_init)?;
        self.call(|model| unsafe { sys::bempd_extension(model, index, &mut extension) })?;
        Ok(extension)
    }

    pub(crate) fn crack_count(&self) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_crack_count(model, count) })
    }

    pub(crate) fn crack_length(&self, crack: i32) -> Result<f64> {
        self.output(|model, length| unsafe { sys::bempd_crack_length(model, crack, length) })
    }

    pub(crate) fn crack_path_count(&self, crack: i32) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_crack_path_count(model, crack, count) })
    }

    pub(crate) fn crack_path(&self, crack: i32, index: i64) -> Result<sys::bempd_path_vertex> {
        let mut vertex = filled(sys::bempd_path_vertex_init)?;
        self.call(|model| unsafe { sys::bempd_crack_path(model, crack, index, &mut vertex) })?;
        Ok(vertex)
    }

    /// Normal and tangential.
    pub(crate) fn crack_opening(&self, crack: i32, fractions: &[f64]) -> Result<(Vec<f64>, Vec<f64>)> {
        let (mut normal, mut tangential) = (vec![0.0; fractions.len()], vec![0.0; fractions.len()]);
        let (count, places) = (fractions.len() as i64, fractions.as_ptr());
        let outputs = (normal.as_mut_ptr(), tangential.as_mut_ptr());
        self.call(|model| unsafe { sys::bempd_crack_opening(model, crack, count, places, outputs.0, outputs.1) })?;
        Ok((normal, tangential))
    }

    pub(crate) fn load_factor(&self) -> Result<f64> {
        self.output(|model, load_factor| unsafe { sys::bempd_load_factor(model, load_factor) })
    }

    pub(crate) fn generation(&self) -> Result<i64> {
        self.output(|model, generation| unsafe { sys::bempd_generation(model, generation) })
    }

    pub(crate) fn plan(&self) -> Result<sys::bempd_body_plan> {
        let mut plan = filled(sys::bempd_body_plan_init)?;
        self.call(|model| unsafe { sys::bempd_plan(model, &mut plan) })?;
        Ok(plan)
    }

    pub(crate) fn error_estimate(&self) -> Result<sys::bempd_errors> {
        let mut errors = filled(sys::bempd_errors_init)?;
        self.call(|model| unsafe { sys::bempd_error_estimate(model, &mut errors) })?;
        Ok(errors)
    }

    pub(crate) fn run_error_estimate(&self, seconds_allowed: f64) -> Result<sys::bempd_run_errors> {
        let mut errors = filled(sys::bempd_run_errors_init)?;
        self.call(|model| unsafe { sys::bempd_run_error_estimate(model, seconds_allowed, &mut errors) })?;
        Ok(errors)
    }

    pub(crate) fn statistics(&self) -> Result<sys::bempd_statistics> {
        let mut statistics = filled(sys::bempd_statistics_init)?;
        self.call(|model| unsafe { sys::bempd_get_statistics(model, &mut statistics) })?;
        Ok(statistics)
    }

    pub(crate) fn history_count(&self) -> Result<i64> {
        self.output(|model, count| unsafe { sys::bempd_history_count(model, count) })
    }

    pub(crate) fn history_entry(&self, index: i64) -> Result<sys::bempd_history_entry> {
        let mut entry = filled(sys::bempd_history_entry_init)?;
        self.call(|model| unsafe { sys::bempd_get_history_entry(model, index, &mut entry) })?;
        Ok(entry)
    }
}
