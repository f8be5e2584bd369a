//! Why a question is refused.

/// The reasons, by the names that the format gives them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Code {
    /// A number is NaN or infinite.
    NonFinite,
    /// Vectors of one question live in different dimensions, or in one that the kind does not know.
    DimensionMismatch,
    /// Two lists that go together are not of one length.
    LengthMismatch,
    /// Nothing was given where something is needed.
    Empty,
    /// A weight is below zero.
    NegativeWeight,
    /// A precision is not between 0 and 1.
    BadEpsilon,
    /// An axis of rotation is the zero vector.
    ZeroAxis,
    /// An angle is negative.
    BadAngle,
    /// More was given than is taken.
    TooLarge,
    /// No such kind.
    UnknownKind,
    /// The kind has no such method.
    UnknownMethod,
    /// A missing field, an extra one, or one of the wrong type.
    BadInput,
    /// The line is not JSON.
    BadJson,
}

impl Code {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::NonFinite,
        Self::DimensionMismatch,
        Self::LengthMismatch,
        Self::Empty,
        Self::NegativeWeight,
        Self::BadEpsilon,
        Self::ZeroAxis,
        Self::BadAngle,
        Self::TooLarge,
        Self::UnknownKind,
        Self::UnknownMethod,
        Self::BadInput,
        Self::BadJson,
    ];

    /// The name in the format.
    pub fn name(self) -> &'static str {
        match self {
            Self::NonFinite => "non_finite",
            Self::DimensionMismatch => "dimension_mismatch",
            Self::LengthMismatch => "length_mismatch",
            Self::Empty => "empty",
            Self::NegativeWeight => "negative_weight",
            Self::BadEpsilon => "bad_epsilon",
            Self::ZeroAxis => "zero_axis",
            Self::BadAngle => "bad_angle",
            Self::TooLarge => "too_large",
            Self::UnknownKind => "unknown_kind",
            Self::UnknownMethod => "unknown_method",
            Self::BadInput => "bad_input",
            Self::BadJson => "bad_json",
        }
    }
}

/// A refusal: its code and what exactly is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The reason.
    pub code: Code,
    /// One sentence that names the place; points, generators and coordinates count from 1.
    pub message: String,
}

impl Refusal {
    /// A refusal.
    pub fn new(code: Code, message: impl Into<String>) -> Self {
        Self { code, message: message.into() }
    }

    /// A refusal for a missing, extra or mistyped field.
    pub(super) fn bad_input(message: impl Into<String>) -> Self {
        Self::new(Code::BadInput, message)
    }
}
