use bempd_sys as sys;

use crate::{CrackId, FatigueRecord, FatigueReport, Growth, MaterialId, Model, Result, TipEnd};

/// Law by which a crack grows in a cycle of the loads; K_max and K_min are factors of mode I in the direction of growth.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RateLaw {
    /// Paris and Walker: C [(1 - R)^(gamma - 1) dK]^m; gamma = 1 lets R have no effect.
    Paris {
        /// Exponent of the load ratio.
        walker: f64,
    },
    /// Forman: C dK^m / ((1 - R) K_c - dK).
    Forman,
    /// NASGRO, with Newman's closure.
    Nasgro {
        /// Exponent towards the threshold.
        p: f64,
        /// Exponent towards the critical factor.
        q: f64,
        /// 1 plane stress to 3 plane strain.
        closure_alpha: f64,
        /// Largest stress over the flow stress.
        closure_stress: f64,
    },
    /// Growth in time under a sustained load: C K_max^m.
    Sustained,
}

/// How growth slows down in the plastic zone of an earlier, higher load.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Retardation {
    /// Wheeler: da/dN times (zone of the cycle / distance to the end of the overload's zone)^exponent.
    Wheeler {
        /// Yield strength [Pa].
        yield_strength: f64,
        /// Exponent.
        exponent: f64,
    },
    /// Willenborg, generalized by Gallagher; it acts through the load ratio.
    Willenborg {
        /// Yield strength [Pa].
        yield_strength: f64,
        /// Overload over load that stops a tip.
        shutoff_ratio: f64,
    },
}

/// A law of growth with its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrowthRate {
    law: RateLaw,
    coefficient: f64,
    exponent: f64,
    unit_intensity: f64,
    threshold: f64,
    critical_intensity: f64,
    retardation: Option<Retardation>,
    flow_stress: f64,
}

impl GrowthRate {
    /// da/dN = C dK^m, for factors over a unit: 1e6 for tables in MPa m^(1/2) and m.
    pub fn paris(coefficient: f64, exponent: f64, unit_intensity: f64) -> GrowthRate {
        GrowthRate {
            law: RateLaw::Paris { walker: 1.0 },
            coefficient,
            exponent,
            unit_intensity,
            threshold: 0.0,
            critical_intensity: 0.0,
            retardation: None,
            flow_stress: 0.0,
        }
    }

    /// Takes another law with the same numbers.
    pub fn law(self, law: RateLaw) -> GrowthRate {
        GrowthRate { law, ..self }
    }

    /// Sets the range up to which a tip does not grow, in the unit.
    pub fn threshold(self, threshold: f64) -> GrowthRate {
        GrowthRate { threshold, ..self }
    }

    /// Sets the factor at which a tip breaks, in the unit; without it that of the material's fracture energy.
    pub fn critical_intensity(self, critical_intensity: f64) -> GrowthRate {
        GrowthRate { critical_intensity, ..self }
    }

    /// Lets earlier, higher loads slow down growth.
    pub fn retardation(self, retardation: Retardation) -> GrowthRate {
        GrowthRate { retardation: Some(retardation), ..self }
    }

    /// Sets the stress at which the net section of a tip yields as a whole, which ends the growth [Pa].
    pub fn flow_stress(self, flow_stress: f64) -> GrowthRate {
        GrowthRate { flow_stress, ..self }
    }

    fn fill(&self, rate: &mut sys::bempd_growth_rate) {
        rate.flow_stress = self.flow_stress;
        rate.coefficient = self.coefficient;
        rate.exponent = self.exponent;
        rate.unit_intensity = self.unit_intensity;
        rate.threshold = self.threshold;
        rate.critical_intensity = self.critical_intensity;
        match self.retardation {
            Some(Retardation::Wheeler { yield_strength, exponent }) => {
                rate.retardation = sys::BEMPD_RETARDATION_WHEELER as i32;
                (rate.yield_strength, rate.wheeler_exponent) = (yield_strength, exponent);
            }
            Some(Retardation::Willenborg { yield_strength, shutoff_ratio }) => {
                rate.retardation = sys::BEMPD_RETARDATION_WILLENBORG as i32;
                (rate.yield_strength, rate.shutoff_ratio) = (yield_strength, shutoff_ratio);
            }
            None => {}
        }
        rate.kind = match self.law {
            RateLaw::Paris { walker } => {
                rate.walker = walker;
                sys::BEMPD_RATE_PARIS
            }
            RateLaw::Forman => sys::BEMPD_RATE_FORMAN,
            RateLaw::Nasgro { p, q, closure_alpha, closure_stress } => {
                (rate.p, rate.q) = (p, q);
                (rate.closure_alpha, rate.closure_stress) = (closure_alpha, closure_stress);
                sys::BEMPD_RATE_NASGRO
            }
            RateLaw::Sustained => sys::BEMPD_RATE_SUSTAINED,
        } as i32;
    }
}

/// Cycles between two load factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// High load factor [-].
    pub high: f64,
    /// Low load factor [-].
    pub low: f64,
    /// Cycles; of one block alone any number.
    pub cycles: f64,
}

/// Cycles between two combinations of load cases; cases beyond the given factors have 0.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseBlock {
    /// Factors of the cases at one end of a cycle [-].
    pub high: Vec<f64>,
    /// Factors at the other end [-].
    pub low: Vec<f64>,
    /// Cycles; of one block alone any number.
    pub cycles: f64,
}

/// What `Model::grow_fatigue` is asked for; 0 stands for no limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FatigueOptions {
    /// Cycles that have passed before.
    pub first_cycle: f64,
    /// Cycles at which to stop, counted with those before.
    pub most_cycles: f64,
    /// Length of a crack at which to stop [m].
    pub most_length: f64,
    /// Steps after which to stop.
    pub most_steps: i64,
    /// Error of the cycles in each step, as a share of these.
    pub tolerance: f64,
    /// Longest step over the crack's length.
    pub largest_step: f64,
}

impl FatigueOptions {
    fn fill(&self, raw: &mut sys::bempd_fatigue) {
        raw.first_cycle = self.first_cycle;
        raw.most_cycles = self.most_cycles;
        raw.most_length = self.most_length;
        raw.most_steps = self.most_steps;
        raw.tolerance = self.tolerance;
        raw.largest_step = self.largest_step;
    }
}

impl Default for FatigueOptions {
    fn default() -> FatigueOptions {
        FatigueOptions {
            first_cycle: 0.0,
            most_cycles: 0.0,
            most_length: 0.0,
            most_steps: 1000,
            tolerance: 1e-3,
            largest_step: 0.25,
        }
    }
}

/// Tip of which a closure is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct GrowingTip {
    /// Crack that it belongs to.
    pub crack: CrackId,
    /// End of the crack.
    pub end: TipEnd,
    /// Factor of mode I in the direction of growth [Pa m^(1/2)].
    pub equivalent: f64,
    /// R = K_min / K_max; 1 under a load that is held.
    pub ratio: f64,
    /// K_I and K_II [Pa m^(1/2)].
    pub stress_intensities: [f64; 2],
    /// T, along the crack [Pa].
    pub t_stress: f64,
    /// Growth of this end in the model [m].
    pub length: f64,
    /// Place of the tip [m].
    pub place: [f64; 2],
}

impl Model {
    /// Lets a closure give the fracture energy [J/m^2] that a tip in a material meets, in place of its number.
    ///
    /// ```
    /// use bempd::{Component, Material, Model, Values};
    ///
    /// # fn main() -> bempd::Result<()> {
    /// let load = |energy: f64| -> bempd::Result<f64> {
    ///     let mut model = Model::new()?;
    ///     let glass = model.add_material(&Material::new(1.0, 0.3).fracture_energy(1.0))?;
    ///     let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    ///     let plate = model.add_bem_region(glass, &corners, 0.5)?;
    ///     model.add_crack(&[[-0.3, 0.0], [0.3, 0.0]])?;
    ///     model.fix_edge(plate, 1, Component::Both)?;
    ///     model.prescribe_edge(plate, 3, .., Component::Y, Values::proportional(&[1.0]))?;
    ///     model.set_resistance_function(glass, move |tip| energy * (1.0 + tip.length))?;
    ///     model.step_to_next_event(1e9)?;
    ///     model.load_factor()
    /// };
    /// assert!((load(4.0)? / load(1.0)? - 2.0).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    pub fn set_resistance_function(
        &mut self,
        material: MaterialId,
        function: impl FnMut(&GrowingTip) -> f64 + Send + 'static,
    ) -> Result<()> {
        self.handle.set_resistance_function(material.0, Box::new(function))
    }

    /// Says how far cracks in a material grow in a cycle of the loads. A law of one's own takes `extend_cracks`.
    pub fn set_growth_rate(&mut self, material: MaterialId, rate: &GrowthRate) -> Result<()> {
        self.handle.set_growth_rate(material.0, |raw| rate.fill(raw))
    }

    /// Lets cracks grow by cycles of the loads and counts the cycles; blocks follow each other and are repeated.
    ///
    /// ```
    /// use bempd::{Block, Component, FaceComponent, FatigueOptions, GrowthRate, Material, Model, Values};
    ///
    /// # fn main() -> bempd::Result<()> {
    /// let mut model = Model::new()?;
    /// let glass = model.add_material(&Material::new(1.0, 0.3))?;
    /// model.add_bem_region(glass, &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 0.5)?;
    /// let crack = model.add_crack(&[[-0.3, 0.0], [0.3, 0.0]])?;
    /// model.fix_point([-1.0, -1.0], Component::Both)?;
    /// model.fix_point([1.0, -1.0], Component::Y)?;
    /// model.add_crack_traction(crack, FaceComponent::Pressure, Values::proportional(&[1.0]))?;
    /// model.set_growth_rate(glass, &GrowthRate::paris(1e-6, 3.0, 1.0))?;
    /// let block = Block { high: 1.0, low: 0.0, cycles: 1.0 };
    /// let report = model.grow_fatigue(&[block], &FatigueOptions { most_length: 0.9, ..Default::default() })?;
    /// let records = model.fatigue_records()?;
    /// assert!((records.last().unwrap().length - 0.9).abs() < 1e-9);
    /// assert_eq!(records.last().unwrap().cycles, report.cycles);
    /// # Ok(())
    /// # }
    /// ```
    pub fn grow_fatigue(&mut self, blocks: &[Block], options: &FatigueOptions) -> Result<FatigueReport> {
        let rows: Vec<[f64; 3]> = blocks.iter().map(|block| [block.high, block.low, block.cycles]).collect();
        let report = self.handle.grow_fatigue(&rows, |raw| options.fill(raw))?;
        Ok(FatigueReport::from_raw(&report))
    }

    /// Lets cracks grow by cycles between combinations of load cases (`add_load_case`): each block has a factor for each
    /// of `cases` cases at both ends of its cycles.
    ///
    /// ```
    /// use bempd::{CaseBlock, Component, FaceComponent, FatigueOptions, GrowthRate, Material, Model, Values};
    ///
    /// # fn main() -> bempd::Result<()> {
    /// let mut model = Model::new()?;
    /// let glass = model.add_material(&Material::new(1.0, 0.3))?;
    /// model.add_bem_region(glass, &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], 0.5)?;
    /// let crack = model.add_crack(&[[-0.3, 0.0], [0.3, 0.0]])?;
    /// model.fix_point([-1.0, -1.0], Component::Both)?;
    /// model.fix_point([1.0, -1.0], Component::Y)?;
    /// let inside = model.add_crack_traction(crack, FaceComponent::Pressure, Values::proportional(&[1.0]))?;
    /// model.add_load_case(&[inside], &[])?;
    /// model.set_growth_rate(glass, &GrowthRate::paris(1e-6, 3.0, 1.0))?;
    /// let block = CaseBlock { high: vec![1.0], low: vec![], cycles: 1.0 };
    /// let options = FatigueOptions { most_length: 0.9, ..Default::default() };
    /// let report = model.grow_fatigue_cases(1, &[block], &options)?;
    /// assert!((report.growth - 0.3).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    pub fn grow_fatigue_cases(
        &mut self,
        cases: usize,
        blocks: &[CaseBlock],
        options: &FatigueOptions,
    ) -> Result<FatigueReport> {
        let row = |factors: &[f64]| (0..cases).map(|k| factors.get(k).copied().unwrap_or(0.0)).collect::<Vec<f64>>();
        let high: Vec<f64> = blocks.iter().flat_map(|block| row(&block.high)).collect();
        let low: Vec<f64> = blocks.iter().flat_map(|block| row(&block.low)).collect();
        let cycles: Vec<f64> = blocks.iter().map(|block| block.cycles).collect();
        let report = self.handle.grow_fatigue_cases(cases, (&high, &low), &cycles, |raw| options.fill(raw))?;
        Ok(FatigueReport::from_raw(&report))
    }

    /// Each tip at first and after every step of the last `grow_fatigue`.
    pub fn fatigue_records(&self) -> Result<Vec<FatigueRecord>> {
        (0..self.handle.fatigue_record_count()?)
            .map(|index| Ok(FatigueRecord::from_raw(&self.handle.fatigue_record(index)?)))
            .collect()
    }

    /// Lets tips in boundary element regions grow by lengths [m] at the present load factor, whatever their load.
    pub fn extend_cracks(&mut self, tips: &[(CrackId, TipEnd, f64)]) -> Result<Growth> {
        let cracks: Vec<i32> = tips.iter().map(|tip| tip.0 .0).collect();
        let ends: Vec<i32> = tips.iter().map(|tip| tip.1.raw()).collect();
        let lengths: Vec<f64> = tips.iter().map(|tip| tip.2).collect();
        Ok(Growth::from_raw(&self.handle.extend_cracks(&cracks, &ends, &lengths)?))
    }
}
