//! The names of the options that say how a body is read, for messages that advise one.

/// The names of the options of one body of a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OptionNames {
    /// The option that names the format of the file.
    pub format: &'static str,
    /// The option by which columns are read as generators.
    pub columns_are_generators: &'static str,
    /// The option by which the first vector is read as the centre.
    pub center_first: &'static str,
    /// The option of the number of lines that are left out of a table.
    pub skip: &'static str,
    /// The option of a file with a pose.
    pub pose: &'static str,
    /// The option of a turn.
    pub turn: &'static str,
    /// The option of a move.
    pub shift: &'static str,
}

impl OptionNames {
    /// The options of a first or only body.
    pub const OF_FIRST: Self = Self {
        format: "--format",
        columns_are_generators: "--columns-are-generators",
        center_first: "--center-first",
        skip: "--skip",
        pose: "--pose",
        turn: "--turn",
        shift: "--move",
    };

    /// The options of a second body.
    pub const OF_SECOND: Self = Self {
        format: "--format-b",
        columns_are_generators: "--columns-are-generators-b",
        center_first: "--center-first-b",
        skip: "--skip-b",
        pose: "--pose-b",
        turn: "--turn-b",
        shift: "--move-b",
    };

    /// The options of a body beside a file of points, whose format has the plain name.
    pub const BESIDE_POINTS: Self = Self { format: "--body-format", skip: "--body-skip", ..Self::OF_FIRST };
}
