//! The families of points, directions and weights, each as a test.

/// One test for each family and dimension: `$check::<D>` on `$cases` draws.
#[macro_export]
macro_rules! test_on_direction_families {
    ($cases:expr; $($family:ident: $check:ident;)*) => {$(
        mod $family {
            use super::*;

            #[test]
            fn on_the_line() {
                $crate::runner::for_all(&::families::drawn::directions::$family::<1>(), $cases, $check);
            }
            #[test]
            fn in_the_plane() {
                $crate::runner::for_all(&::families::drawn::directions::$family::<2>(), $cases, $check);
            }
            #[test]
            fn in_space() {
                $crate::runner::for_all(&::families::drawn::directions::$family::<3>(), $cases, $check);
            }
            #[test]
            fn in_four_dimensions() {
                $crate::runner::for_all(&::families::drawn::directions::$family::<4>(), $cases, $check);
            }
        }
    )*};
}
