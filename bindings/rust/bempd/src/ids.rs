use std::fmt;

macro_rules! ids {
    ($($(#[$documentation:meta])* $name:ident;)*) => { $(
        $(#[$documentation])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(pub i32);

        impl fmt::Display for $name {
            fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(formatter)
            }
        }
    )* };
}

ids! {
    /// Id of a material, from 1 in the order of adding.
    MaterialId;
    /// Id of a region, from 1 in the order of adding.
    RegionId;
    /// Id of an initial crack, from 1 in the order of adding.
    CrackId;
    /// Id of a support, from 1 in the order of adding.
    SupportId;
    /// Id of a load, from 1 in the order of adding.
    LoadId;
    /// Id of a load case, from 1 in the order of adding.
    LoadCaseId;
}
