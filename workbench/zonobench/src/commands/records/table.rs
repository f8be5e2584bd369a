//! Records as a table with a number a row, so that its columns are the same for all experiments.

use experiments::definition::Verdict;
use experiments::record::{CaseKey, CountOutcome, CountRow, TimeOutcome, TimeRow};

/// The columns; the manual says what they hold.
const COLUMNS: [&str; 11] =
    ["sort", "experiment", "input", "method", "n", "instance", "repetition", "quantity", "number", "outcome", "note"];

/// The numbers of one record.
struct Numbers<'a> {
    sort: &'static str,
    key: &'a CaseKey,
    repetition: String,
    outcome: &'static str,
    note: &'a str,
    /// Names and numbers; a record without any has a row all the same.
    named: Vec<(&'a str, String)>,
}

/// The table of some records, with a header.
pub(in crate::commands) fn csv<'a>(
    counts: impl IntoIterator<Item = &'a CountRow>,
    times: impl IntoIterator<Item = &'a TimeRow>,
) -> anyhow::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
    for numbers in counts.into_iter().flat_map(of_count).chain(times.into_iter().map(of_time)) {
        let nothing = [("", String::new())];
        for (name, number) in if numbers.named.is_empty() { &nothing[..] } else { &numbers.named } {
            let CaseKey { experiment, family, variant, n, instance, .. } = numbers.key;
            let [n, instance] = [n.to_string(), instance.to_string()];
            let case = [numbers.sort, experiment, family, variant, &n, &instance, &numbers.repetition];
            writer.write_record(case.into_iter().chain([*name, number, numbers.outcome, numbers.note]))?;
        }
    }
    Ok(writer.into_inner()?)
}

/// The operation counts of a case, and its other numbers.
fn of_count(row: &CountRow) -> Vec<Numbers<'_>> {
    let of =
        |sort, outcome, note, named| Numbers { sort, key: &row.key, repetition: String::new(), outcome, note, named };
    match &row.outcome {
        CountOutcome::Failed { error } => vec![of("count", "failed", error, Vec::new())],
        CountOutcome::Measured { counts, values, verdict, .. } => {
            let (outcome, note) = match verdict {
                Verdict::Correct(check) => ("right", check),
                Verdict::Wrong(reason) => ("wrong", reason),
                Verdict::Unchecked(reason) => ("unchecked", reason),
            };
            let counts = counts.iter().map(|(name, count)| (name.as_str(), count.to_string())).collect();
            let values: Vec<_> = values.iter().map(|(name, value)| (name.as_str(), format!("{value:?}"))).collect();
            let values = (!values.is_empty()).then(|| of("value", outcome, note, values));
            [of("count", outcome, note, counts)].into_iter().chain(values).collect()
        }
    }
}

/// The laps of a repetition, in nanoseconds.
fn of_time(row: &TimeRow) -> Numbers<'_> {
    let (outcome, note, laps) = match &row.outcome {
        TimeOutcome::Valid { laps_ns } => ("valid", "", Some(laps_ns)),
        TimeOutcome::Void { laps_ns, reason } => ("void", reason.as_str(), Some(laps_ns)),
        TimeOutcome::Failed { error } => ("failed", error.as_str(), None),
    };
    let named = laps.into_iter().flatten().map(|(name, ns)| (name.as_str(), ns.to_string())).collect();
    Numbers { sort: "time", key: &row.key, repetition: row.repetition.to_string(), outcome, note, named }
}

#[cfg(test)]
mod tests {
    use super::*;
    use experiments::definition::{Case, Measurement};
    use zonotope::tally::OperationCounts;

    #[test]
    fn every_number_and_every_failure_has_a_row() {
        let case = Case::new(1, "hull-scaling", "disc", "by_scan", 64, 2);
        let verdict = Verdict::Wrong("half, or less".to_owned());
        let measured = Measurement::new(&OperationCounts::default(), 0, verdict).with_value("ratio", 0.5);
        let counts = [CountRow::new(&case, Ok(measured)), CountRow::new(&case, Err("it \"failed\"".to_owned()))];
        let laps_ns = [("solve".to_owned(), 12)].into_iter().collect();
        let outcome = TimeOutcome::Valid { laps_ns };
        let time = TimeRow { key: (&case).into(), repetition: 3, environment: String::new(), outcome };
        let table = String::from_utf8(csv(&counts, &[time]).expect("memory can be written")).expect("text");
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines[0], "sort,experiment,input,method,n,instance,repetition,quantity,number,outcome,note");
        assert!(lines.contains(&"value,hull-scaling,disc,by_scan,64,2,,ratio,0.5,wrong,\"half, or less\""), "{table}");
        assert!(lines.contains(&"count,hull-scaling,disc,by_scan,64,2,,,,failed,\"it \"\"failed\"\"\""), "{table}");
        assert_eq!(lines.last(), Some(&"time,hull-scaling,disc,by_scan,64,2,3,solve,12,valid,"));
        assert!(lines.iter().all(|line| line.matches(',').count() >= 10), "{table}");
    }
}
