//! Programs that are none.

use super::*;

#[test]
fn what_is_not_a_program_is_refused() {
    let free = BoundedVariable::free;
    let refused = LinearProgram::new(vec![free(f64::NAN)]).expect_err("NaN is no cost");
    assert_eq!(refused.to_string(), "variable 0: the cost is NaN, not a finite number");
    let empty = BoundedVariable { cost: 0.0, lower: 1.0, upper: -1.0 };
    assert!(matches!(LinearProgram::new(vec![free(0.0), empty]), Err(LinearProgramError::EmptyBounds { .. })));
    let mut program = LinearProgram::new(vec![free(0.0); 2]).expect("valid");
    let row = |terms: &[(usize, f64)]| Row { terms: terms.to_vec(), relation: Relation::Equal, right: 0.0 };
    assert!(matches!(program.add_row(row(&[(2, 1.0)])), Err(LinearProgramError::UnknownVariable { variable: 2, .. })));
    assert!(matches!(
        program.add_row(row(&[(0, 1.0), (0, 2.0)])),
        Err(LinearProgramError::RepeatedVariable { variable: 0, .. })
    ));
    let refused = program.add_row(row(&[(0, f64::INFINITY)])).expect_err("no coefficient is infinite");
    assert_eq!(refused.to_string(), "row 0: a coefficient is inf, not a finite number");
    let unbounded = Row { terms: Vec::new(), relation: Relation::Equal, right: f64::NAN };
    let refused = program.add_row(unbounded).expect_err("NaN is no right side");
    assert_eq!(refused.to_string(), "row 0: the right side is NaN, not a finite number");
    assert!(program.rows().is_empty());
}
