//! First contacts from the definition, in rationals: gaps at many times of each interval, and the common point.

use dashu_ratio::RBig;
use serde_json::Value;
use zonotope::motion::MotionPiece;
use zonotope::motion::continuous::SeparatingDirection;
use zonotope::motion::continuous::brute_force::{Placement, gap};
use zonotope::zonotope::Zonotope;

use crate::judges::proves;
use crate::rationals::{minus, number};

/// A gap is looked for at so many times of an interval, its ends included.
const TIMES: u8 = 12;

/// The pieces of a motion.
pub(super) struct Pieces(Vec<MotionPiece>);

/// A body with its motion.
struct Moving {
    body: Zonotope<3>,
    motion: Pieces,
}

pub(super) fn floats<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let all: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    all?.try_into().ok()
}

impl Moving {
    fn of(input: &Value, name: &str) -> Option<Self> {
        let generators: Option<Vec<[f64; 3]>> = input[name]["generators"].as_array()?.iter().map(floats).collect();
        let body = Zonotope::new(floats(&input[name]["center"])?, generators?).ok()?;
        Some(Self { body, motion: Pieces::of(input, name)? })
    }
}

impl Pieces {
    pub(super) fn of(input: &Value, name: &str) -> Option<Self> {
        let still = [1.0, 0.0, 0.0, 0.0];
        let rest = MotionPiece { until: 1.0, from: still, to: still, axis_point: [0.0; 3], translation: [0.0; 3] };
        let Some(motion) = input["motion"].get(name) else { return Some(Self(vec![rest])) };
        let piece = |piece: &Value| {
            Some(MotionPiece {
                until: piece["until"].as_f64()?,
                from: floats(&piece["from"])?,
                to: floats(&piece["to"])?,
                axis_point: floats(&piece["axis_point"])?,
                translation: floats(&piece["translation"])?,
            })
        };
        let pieces: Option<Vec<MotionPiece>> = motion["pieces"].as_array()?.iter().map(piece).collect();
        pieces.map(Self)
    }

    /// The placements at a time: two where a piece ends and another begins.
    pub(super) fn placements(&self, time: &RBig) -> Vec<Placement> {
        let mut start = RBig::ZERO;
        let mut all = Vec::new();
        for (index, piece) in self.0.iter().enumerate() {
            let end = RBig::try_from(piece.until).unwrap_or_default();
            if start <= *time && *time <= end {
                all.push(Placement::at(&self.0, index, time));
            }
            start = end;
        }
        all
    }
}

/// Whether an interval is exact in its form, and whether there is a gap at many of its times.
pub(super) fn interval_is_free(
    interval: &Value,
    motions: [&Pieces; 2],
    gap: impl Fn([&Placement; 2], &SeparatingDirection) -> RBig,
) -> Option<(bool, bool)> {
    let (from, to) = (interval["from"].as_f64()?, interval["to"].as_f64()?);
    if from >= to {
        return Some((false, false));
    }
    let u = &interval["direction"];
    let direction = match interval["frame"].as_str()? {
        "space" => SeparatingDirection::Space(floats(u)?),
        "a" => SeparatingDirection::First(floats(u)?),
        "b" => SeparatingDirection::Second(floats(u)?),
        "edges" if u.as_array()?.len() == 2 => SeparatingDirection::Edges([floats(&u[0])?, floats(&u[1])?]),
        _ => return Some((false, false)),
    };
    let (start, end) = (RBig::try_from(from).ok()?, RBig::try_from(to).ok()?);
    let breaks = motions.iter().flat_map(|motion| &motion.0);
    let breaks = breaks.filter_map(|piece| RBig::try_from(piece.until).ok());
    let breaks = breaks.filter(|time| start < *time && *time < end);
    let steps = (0..=TIMES).map(|step| &start + (&end - &start) * RBig::from(step) / RBig::from(TIMES));
    for time in steps.chain(breaks).collect::<Vec<_>>() {
        let [of_a, of_b] = motions.map(|motion| motion.placements(&time));
        // at the ends of an interval a piece that only begins or ends there is not part of it
        let is_judged = (start < time && time < end) || of_a.len() * of_b.len() == 1;
        let has_gap = || of_a.iter().all(|p| of_b.iter().all(|q| gap([p, q], &direction) > RBig::ZERO));
        if is_judged && !has_gap() {
            return Some((true, false));
        }
    }
    Some((true, true))
}

/// Whether two times are in order and so near each other as a contact without a resolution needs.
pub(super) fn is_bracket(time: &Value) -> Option<bool> {
    let (from, to) = (number(&time[0])?, number(&time[1])?);
    Some(from <= to && &to - &from <= RBig::try_from(1.0 / f64::from(1 << 30)).ok()?)
}

/// Whether the changed answer is exact in its form, and whether it is true.
pub fn judged(input: &Value, changed: &Value) -> Option<(bool, bool)> {
    let [a, b] = [Moving::of(input, "a")?, Moving::of(input, "b")?];
    let certificate = &changed["certificate"];
    let mut reached = 0.0;
    for interval in certificate["intervals"].as_array()? {
        if interval["from"].as_f64()? != reached {
            return Some((false, false));
        }
        let between = |placements: [&Placement; 2], direction: &SeparatingDirection| {
            gap([&a.body, &b.body], placements, direction)
        };
        let free = interval_is_free(interval, [&a.motion, &b.motion], between)?;
        if free != (true, true) {
            return Some(free);
        }
        reached = interval["to"].as_f64()?;
    }
    let time: Option<[f64; 2]> = floats(&changed["time"]);
    match changed["status"].as_str()? {
        "separate" => Some((reached == 1.0, true)),
        "contact" => {
            let [from, to] = time?;
            let is_narrow = is_bracket(&changed["time"])?;
            let at = RBig::try_from(to).ok()?;
            let meets = a.motion.placements(&at).iter().any(|p| {
                b.motion.placements(&at).iter().any(|q| common_point([&a, &b], [p, q], changed).unwrap_or(false))
            });
            Some((reached == from && is_narrow, meets))
        }
        "grazing" => {
            let [from, to] = time?;
            Some((reached == from && from <= to && to <= 1.0, is_near([&a, &b], to, &changed["distance_at_most"])?))
        }
        _ => Some((false, false)),
    }
}

fn common_point(moving: [&Moving; 2], [p, q]: [&Placement; 2], changed: &Value) -> Option<bool> {
    let [from, to] = [p.of(moving[0].body.center()), q.of(moving[1].body.center())].map(|center| center.to_vec());
    let own = moving[0].body.generators().iter().map(|g| p.turned(*g).to_vec());
    let others = moving[1].body.generators().iter().map(|g| q.turned(*g).to_vec());
    proves(&Some(minus(&to, &from)), &Some(own.chain(others).collect()), changed, changed)
}

/// Whether the bodies are so near at a time, in doubles.
fn is_near(moving: [&Moving; 2], time: f64, distance: &Value) -> Option<bool> {
    if distance == "Infinity" {
        return Some(true);
    }
    let poses = moving.map(|moving| zonotope::motion::Motion::from_pieces(&moving.motion.0).ok()?.pose_at(time));
    let [Some(p), Some(q)] = poses else { return None };
    let [a, b] = moving.map(|moving| &moving.body);
    let size = a
        .generators()
        .iter()
        .chain(b.generators())
        .flatten()
        .chain(&a.center())
        .chain(&b.center())
        .fold(1.0, |size: f64, c| size.max(c.abs()));
    let found = a.at(&p).distance(b.at(&q));
    Some(distance.as_f64()? >= found - 1e-9 * size)
}
