//! The record of an answer about bodies of the files that it is about, so that `verify` asks the same question again.

use batch::json::{Tree, vector_to_json};
use serde_json::{Map, Value, json};

use super::value_of;
use crate::commands::asking::{POINT_FIELDS, PointOptions, RecordError, field, record_points, recorded_points, truth};
use crate::input::{Layout, Origin, Placed, Reading};

/// The question about the bodies of files, by the command that asks it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum About {
    /// Whether two bodies meet.
    Intersect,
    /// The distance of two bodies.
    Distance,
    /// The Hausdorff distance of two bodies.
    Hausdorff,
    /// When two moving bodies meet first.
    Collide,
    /// Which points a body contains.
    Contains,
    /// A body around all placements of a body.
    Sweep,
    /// A body of few generators.
    Reduce,
    /// The faces of a body.
    Inspect,
}

/// The part of a file in a question.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    /// The first body.
    A,
    /// The second body.
    B,
    /// The only body.
    Body,
    /// The points.
    Points,
}

impl Role {
    /// The field of a request that records the file.
    fn field(self) -> &'static str {
        match self {
            Self::A => "a",
            Self::B => "b",
            Self::Body => "body",
            Self::Points => "points",
        }
    }
}

impl About {
    const ALL: [Self; 8] = [
        Self::Intersect,
        Self::Distance,
        Self::Hausdorff,
        Self::Collide,
        Self::Sweep,
        Self::Contains,
        Self::Reduce,
        Self::Inspect,
    ];

    /// The command, and the kind of its question.
    fn names(self) -> [&'static str; 2] {
        match self {
            Self::Intersect => ["intersect", "intersect"],
            Self::Distance => ["distance", "distance"],
            Self::Hausdorff => ["hausdorff", "hausdorff"],
            Self::Collide => ["collide", "collide"],
            Self::Sweep => ["sweep", "sweep"],
            Self::Contains => ["contains", "member_batch"],
            Self::Reduce => ["reduce", "reduce"],
            Self::Inspect => ["inspect", "combinatorics"],
        }
    }

    /// The subject of an answer: what its request says, or its kind where it has none.
    pub(crate) fn of_answer(answer: &Tree) -> Option<Self> {
        let text = |tree: &Tree, name: &str| tree.field(name).and_then(Tree::text).map(str::to_owned);
        let recorded = answer.field("request").map(|request| text(request, "command"));
        let (name, index) = match recorded {
            Some(command) => (command?, 0),
            None => (text(answer, "kind")?, 1),
        };
        Self::ALL.into_iter().find(|about| about.names()[index] == name)
    }

    /// The files that it is about, in the order of the command line.
    fn roles(self) -> &'static [Role] {
        match self {
            Self::Intersect | Self::Distance | Self::Hausdorff | Self::Collide => &[Role::A, Role::B],
            Self::Contains => &[Role::Body, Role::Points],
            Self::Sweep | Self::Reduce | Self::Inspect => &[Role::Body],
        }
    }

    /// Whether each of the files is one of a body.
    pub(crate) fn are_bodies(self) -> impl Iterator<Item = bool> {
        self.roles().iter().map(|&role| role != Role::Points)
    }

    /// Whether the question is about bodies in doubles: images under poses are rounded to the nearest.
    pub(crate) fn takes_rounded(self) -> bool {
        matches!(self, Self::Hausdorff | Self::Sweep | Self::Reduce)
    }

    /// The question about bodies, and points, in the format of `solve`; of `reduce` with its count and its rule.
    pub(crate) fn question(
        self,
        id: &str,
        bodies: &[Value],
        points: Option<&Reading>,
        reduction: Option<(u64, &str)>,
    ) -> Value {
        let mut input = match (self, bodies) {
            (Self::Intersect | Self::Distance | Self::Hausdorff | Self::Collide, [a, b]) => json!({"a": a, "b": b}),
            (Self::Inspect, [body]) => match body.get("pose") {
                Some(pose) => json!({"generators": body["generators"], "pose": pose}),
                None => json!({"generators": body["generators"]}),
            },
            (_, bodies) => bodies.first().cloned().unwrap_or_default(),
        };
        if let Some(reading) = points {
            input["points"] = reading.points.rows().map(vector_to_json).collect();
        }
        if let Some((count, rule)) = reduction {
            input["count"] = count.into();
            input["rule"] = rule.into();
        }
        json!({"id": id, "kind": self.names()[1], "input": input})
    }
}

/// A body that was read and placed, with what its file was and how it was read.
pub(crate) struct BodyFile {
    /// The body where it is placed.
    pub(crate) placed: Placed,
    /// The file's format and hash.
    pub(crate) origin: Origin,
    /// Which vectors of a table or of an array are generators.
    pub(crate) layout: Layout,
}

/// The fields of a question that state the motion of a sweep; a request has them as well.
pub(crate) const SWEEP_FIELDS: [&str; 4] = ["axis_point", "axis", "angle", "translation"];

/// The fields of the record of a file with a body.
const BODY_FIELDS: [&str; 6] = ["format", COLUMNS_ARE_GENERATORS, CENTER_FIRST, "skip", "pose", "sha256"];

const COLUMNS_ARE_GENERATORS: &str = "columns_are_generators";
const CENTER_FIRST: &str = "center_first";

impl BodyFile {
    /// The record of a request on it: how the file is read and placed, and its SHA-256.
    pub(crate) fn record(&self) -> Value {
        let mut record = json!({"format": self.origin.format.to_string()});
        let Layout { columns_are_generators, center_first, skip } = self.layout;
        for (name, is_set) in [(COLUMNS_ARE_GENERATORS, columns_are_generators), (CENTER_FIRST, center_first)] {
            if is_set {
                record[name] = true.into();
            }
        }
        if let Some(skip) = skip {
            record["skip"] = skip.into();
        }
        if let Some(pose) = &self.placed.pose {
            record["pose"] = pose.to_json();
        }
        record["sha256"] = self.origin.sha256.clone().into();
        record
    }
}

/// The `request` of an answer about the given files.
pub(crate) fn record(
    about: About,
    bodies: &[&BodyFile],
    points: Option<(&PointOptions, &Reading)>,
    reduction: Option<(u64, &str)>,
) -> Value {
    let mut request = Map::new();
    request.insert("command".to_owned(), about.names()[0].into());
    let mut bodies = bodies.iter();
    for &role in about.roles() {
        let record = match (role, points) {
            (Role::Points, Some((options, reading))) => record_points(options, reading),
            _ => bodies.next().map(|body| body.record()).unwrap_or_default(),
        };
        request.insert(role.field().to_owned(), record);
    }
    if let Some((count, rule)) = reduction {
        request.insert("count".to_owned(), count.into());
        request.insert("rule".to_owned(), rule.into());
    }
    Value::Object(request)
}

/// The record of an answer on its files.
#[derive(Debug, Default)]
pub(crate) struct Recorded {
    /// The files, in the order of the command line.
    pub(crate) files: Vec<RecordedFile>,
    /// The most generators and the rule of a reduction.
    pub(crate) reduction: Option<(u64, String)>,
    /// The motions of bodies, and the resolution if one was asked for: further fields of the question.
    pub(crate) step: Vec<(&'static str, Value)>,
    /// The first field that no request has.
    pub(crate) unknown: Option<String>,
}

/// The record of an answer on a file.
#[derive(Debug, Clone, Default)]
pub(crate) struct RecordedFile {
    /// The reading of points; of a body the format alone.
    pub(crate) points: PointOptions,
    /// The reading of the vectors of a body.
    pub(crate) layout: Layout,
    /// The pose of a body.
    pub(crate) pose: Option<Tree>,
    /// The SHA-256 of its content.
    pub(crate) sha256: Option<String>,
}

impl Recorded {
    /// The record of an answer about something; `None` if it records nothing.
    pub(crate) fn of(about: About, answer: &Tree) -> Option<Result<Self, RecordError>> {
        answer.field("request").map(|request| recorded(about, request))
    }

    /// Facts about the files of an answer that records nothing.
    pub(crate) fn nothing(about: About) -> Self {
        Self { files: vec![RecordedFile::default(); about.roles().len()], ..Self::default() }
    }
}

fn recorded(about: About, request: &Tree) -> Result<Recorded, RecordError> {
    let mut recorded = Recorded::default();
    let mut note_unknown = |tree: &Tree, known: &[&str], place: &str| {
        let Tree::Object(fields) = tree else { return };
        let other = fields.iter().map(|(name, _)| name).find(|name| !known.contains(&name.as_str()));
        recorded.unknown = recorded.unknown.take().or(other.map(|name| format!("{place}{name}")));
    };
    let roles: Vec<&str> = about.roles().iter().map(|role| role.field()).collect();
    note_unknown(
        request,
        &[&roles[..], &["command", "count", "rule", "motion", "resolution"], &SWEEP_FIELDS].concat(),
        "",
    );
    for &role in about.roles() {
        let record = request.field(role.field()).ok_or(RecordError(role.field()))?;
        let known = if role == Role::Points { &POINT_FIELDS[..] } else { &BODY_FIELDS };
        note_unknown(record, known, &format!("{}, ", role.field()));
        let sha256 = field(record, "sha256", |value| value.text().map(str::to_owned))?;
        let points = recorded_points(record)?;
        let skip = points.skip;
        let file = RecordedFile {
            points,
            layout: Layout {
                columns_are_generators: field(record, COLUMNS_ARE_GENERATORS, truth)?.unwrap_or(false),
                center_first: field(record, CENTER_FIRST, truth)?.unwrap_or(false),
                skip,
            },
            pose: record.field("pose").cloned(),
            sha256: Some(sha256.ok_or(RecordError("sha256"))?),
        };
        recorded.files.push(file);
    }
    if about == About::Reduce {
        let count = field(request, "count", |value| value.index().and_then(|count| u64::try_from(count).ok()))?;
        let rule = field(request, "rule", |value| value.text().map(str::to_owned))?;
        recorded.reduction = Some((count.ok_or(RecordError("count"))?, rule.ok_or(RecordError("rule"))?));
    }
    if about == About::Collide {
        let motion = request.field("motion").ok_or(RecordError("motion"))?;
        let resolution = request.field("resolution").map(|resolution| ("resolution", value_of(resolution)));
        recorded.step = [("motion", value_of(motion))].into_iter().chain(resolution).collect();
    }
    if about == About::Sweep {
        for name in SWEEP_FIELDS {
            let value = request.field(name).ok_or(RecordError(name))?;
            recorded.step.push((name, value_of(value)));
        }
    }
    Ok(recorded)
}
