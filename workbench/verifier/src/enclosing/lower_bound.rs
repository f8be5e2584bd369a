//! The lower bound that an answer claims beside the one that its certificate proves.

use std::cmp::Ordering;

use crate::exact::proportion::Proportion;

/// Accepts a finite lower bound that is not above the proven one, nor below it by more than a relative 1e-9.
pub(crate) fn check_bound(claimed: f64, proven: &Proportion) -> Result<(), String> {
    if !claimed.is_finite() {
        return Err(format!("lower_bound is {claimed}"));
    }
    if Proportion::of_double(claimed).compare(proven) == Ordering::Greater {
        return Err(format!(
            "lower_bound {claimed:?} is above {:?}, all that the certificate proves",
            proven.nearest()
        ));
    }
    // The largest double is the most that can be claimed.
    let [smallest, largest] = [f64::MIN_POSITIVE, f64::MAX].map(Proportion::of_double);
    let most = if proven.compare(&largest) == Ordering::Greater { &largest } else { proven };
    let weaker = most.times(&Proportion::of_double(1.0 - 1e-9)).minus(&smallest);
    if Proportion::of_double(claimed).compare(&weaker) == Ordering::Less {
        return Err(format!("lower_bound {claimed:?} says less than the certificate proves, {:?}", proven.nearest()));
    }
    Ok(())
}
