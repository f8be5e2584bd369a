//! The families of point sets of the plane, each as a test.

/// One test for each family: `$check` on `$cases` draws of `$strategy`, which is given the family.
#[macro_export]
macro_rules! test_on_point_families {
    ($strategy:expr, $cases:expr, $check:expr) => {
        $crate::test_on_point_families!(
            $strategy, $cases, $check;
            generic lattice_points collinear duplicates symmetric regular_polygons near_parallel scaled one_ulp
            mixed_scales staggered ends_of_the_range
        );
    };
    ($strategy:expr, $cases:expr, $check:expr; $($family:ident)*) => {$(
        #[test]
        fn $family() {
            $crate::runner::for_all(&$strategy(::families::drawn::points::$family()), $cases, $check);
        }
    )*};
}
