//! The example runs as a test.

#[path = "../examples/drawing.rs"]
mod drawing;

#[test]
fn drawing() {
    drawing::main();
}
