//! The families of lines for the kernel, each as a test.

/// One test for each family in a module: `$check` on `$cases` draws of so many lines; of mixed scales fewer, as exact
/// numbers are long there.
#[macro_export]
macro_rules! test_on_line_families {
    (mod $name:ident: $sizes:expr, mixed $mixed:expr, $cases:ident, $check:ident) => {
        mod $name {
            $crate::test_on_line_families!(
                $sizes, $cases, $check:
                generic lattice_lines concurrent parallel axis_parallel near_parallel duplicates symmetric
                regular_polygons scaled one_ulp
            );
            $crate::test_on_line_families!($mixed, $cases, $check: mixed_scales);
        }
    };
    ($sizes:expr, $cases:ident, $check:ident: $($family:ident)*) => {$(
        #[test]
        fn $family() {
            $crate::runner::for_all(&::families::drawn::lines::$family($sizes), super::$cases, super::$check);
        }
    )*};
}
