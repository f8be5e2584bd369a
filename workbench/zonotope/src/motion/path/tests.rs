//! Refusals of numbers that are no motion, and placements far out.

use super::*;

#[test]
fn what_is_no_motion_is_refused_by_its_place() {
    let refusal = |poses: &[(f64, [f64; 4])]| {
        let pose = |&(time, quaternion)| KeyPose { time, quaternion, translation: [0.0; 3] };
        Motion::through(&poses.iter().map(pose).collect::<Vec<_>>()).expect_err("no motion").to_string()
    };
    let one = [1.0, 0.0, 0.0, 0.0];
    assert_eq!(refusal(&[(0.3, one), (1.0, one)]), "the first pose is at the time 0.3 and must be at 0");
    assert_eq!(refusal(&[(0.0, one), (1.0, [0.0; 4])]), "a quaternion of part or pose 1 of the motion is zero");
    let times = "part 0 of the motion ends at 0: the times must go up, from above 0 to 1";
    assert_eq!(refusal(&[(0.0, one), (0.0, one)]), times);
    assert_eq!(refusal(&[]), times);
    let turn = Motion::constant_rate([0.0; 3], [0.0, -0.0, 0.0], 1.0, [0.0; 3]).expect_err("no axis");
    assert_eq!(turn, MotionError::ZeroAxis);
}

#[test]
fn placements_far_out_are_told_and_there_are_none_outside_of_the_time() {
    let key = |time, x| KeyPose { time, quaternion: [1.0, 0.0, 0.0, 0.0], translation: [x, 0.0, 0.0] };
    let motion = Motion::through(&[key(0.0, 1e308), key(1.0, -1e308)]).expect("a motion");
    let x = |motion: &Motion, time| motion.pose_at(time).map(|pose| pose.translation()[0]);
    assert_eq!([0.0, 0.5, 1.0].map(|time| x(&motion, time)), [Some(1e308), Some(0.0), Some(-1e308)]);
    assert_eq!([-0.5, 1.5, f64::NAN].map(|time| x(&motion, time)), [None; 3]);
    // a part after a translation that is long and turns
    let part = |until, to, x| MotionPiece {
        until,
        from: [1.0, 0.0, 0.0, 0.0],
        to,
        axis_point: [0.0; 3],
        translation: [x, 0.0, 0.0],
    };
    let rest = [1.0, 0.0, 0.0, 0.0];
    let short = 0.5 + 2f64.powi(-31);
    let parts = [part(0.5, [1.0, 0.3, 0.2, 0.1], 1.7e308), part(short, rest, 0.0), part(1.0, rest, 0.0)];
    let motion = Motion::from_pieces(&parts).expect("a motion");
    for time in [0.5 + 2f64.powi(-32), short, 0.75] {
        let x = x(&motion, time).expect("it is a placement");
        assert!((x / 1.7e308 - 1.0).abs() < 1e-14, "{time}: {x}");
    }
}
