use crate::contenders::{Answer, CONTENDERS};
use crate::line_fit;
use crate::race::{self, Part, Plan};
use experiments::peers::{PeersRecord, tables};
use experiments::question::{Placement, Question};
use families::bodies;

/// A distance is asked of bodies that are apart and a depth of bodies that overlap; all others are asked about both.
#[test]
fn every_contender_is_right_where_the_case_is_clear() {
    let mut asked = vec![0; CONTENDERS.len()];
    for placement in ["overlapping", "separated"] {
        let generators = bodies::find("box_sums").expect("listed").generate(6, 4);
        let placement = Placement::find(placement).expect("listed");
        let question = Question::about(generators, placement, 4).expect("boxes have facets");
        for (contender, asked) in CONTENDERS.iter().zip(&mut asked) {
            let Some(mut work) = (contender.prepare)(&question) else { continue };
            let answer = work();
            let right = answer == Answer::Nothing || answer == Answer::Member(question.is_member());
            assert!(right, "{}: {answer:?} on {}", contender.id, placement.id);
            *asked += 1;
        }
    }
    for (contender, asked) in CONTENDERS.iter().zip(asked) {
        let is_measure =
            ["distance", "proximity", "penetration", "parry_distance", "parry_epa"].contains(&contender.id);
        assert_eq!(asked, if is_measure { 1 } else { 2 }, "{}", contender.id);
    }
}

#[test]
fn a_run_asks_times_and_tabulates() {
    let part =
        Part { families: vec!["random_bodies"], sizes: vec![1024], placements: vec!["inside_1e-9"], questions: 1 };
    let cells = race::run(&Plan { seed: 1, parts: vec![part], repetitions: 3, methods: Vec::new() }, |_| {})
        .expect("the ids exist");
    let ours = cells[0].entry("by_lad").expect("no size is too large for it");
    assert_eq!((ours.asked, ours.wrong, ours.failed, ours.samples_ns[0].len()), (1, 0, 0, 3));
    let record = PeersRecord { environment: None, seed: 1, cells, line_fits: Vec::new() };
    let near_contact = &tables(&record)[0];
    assert!(near_contact.rows.iter().any(|row| row[0].starts_with("ours") && row[2] != "–"), "{near_contact:?}");
}

#[test]
fn both_line_fits_find_the_same_minimum() {
    let fit = line_fit::compare(500, 1, 3).expect("the points are ordinary");
    assert!((fit.palb_residual / fit.ours_residual - 1.0).abs() < 1e-9, "{fit:?}");
}
