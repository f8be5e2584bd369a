//! Options that say how a body is read and where it is put.

mod motion;
mod pose_file;
mod start;

use std::path::{Path, PathBuf};

use anyhow::anyhow;
use clap::Args;

pub(super) use self::motion::{Shift, Turn, radians_of};
pub use self::start::TableStart;
pub(super) use self::start::told;
use super::asked::{BodyFile, body_formats};
use super::table::{ROUNDED, Table, counted, figure, in_full, position};
use super::usage::tell;
use crate::input::{BodySource, Format, Layout, OptionNames, Placed};
use batch::placement::Placement;

/// The reading of a body, and the place where it is put.
#[derive(Debug, Clone, Default, PartialEq, Args)]
pub struct Placing {
    /// Put the body where the pose of a file puts it.
    ///
    /// The file has `matrix`, `translation` or both, or the rows of a matrix, square or with the translation as its
    /// last column.
    #[arg(long, value_name = "FILE")]
    pose: Option<PathBuf>,
    /// Turn the body about an axis through the origin, after any pose: z,30 or 1,1,0,30; in the plane 30.
    ///
    /// The matrix that is taken is printed.
    #[arg(long, value_name = "AXIS,DEGREES", allow_hyphen_values = true)]
    turn: Option<Turn>,
    /// Move the body, after any pose and turn.
    #[arg(long = "move", value_name = "X,Y,Z", allow_hyphen_values = true)]
    shift: Option<Shift>,
    /// Read the columns of the table or array as generators, not its rows.
    #[arg(long)]
    columns_are_generators: bool,
    /// Read the first vector of the table or array as the centre.
    #[arg(long)]
    center_first: bool,
}

/// The same for the second body.
#[derive(Debug, Clone, Default, PartialEq, Args)]
pub struct PlacingOfSecond {
    /// Put the second body where a pose puts it, as --pose does the first.
    #[arg(long, value_name = "FILE")]
    pose_b: Option<PathBuf>,
    /// Turn the second body, after any pose.
    #[arg(long, value_name = "AXIS,DEGREES", allow_hyphen_values = true)]
    turn_b: Option<Turn>,
    /// Move the second body, after any pose and turn.
    #[arg(long = "move-b", value_name = "X,Y,Z", allow_hyphen_values = true)]
    shift_b: Option<Shift>,
    /// Read the columns of the second table or array as generators.
    #[arg(long)]
    columns_are_generators_b: bool,
    /// Read the first vector of the second table or array as the centre.
    #[arg(long)]
    center_first_b: bool,
    /// The format of the second file, where it is another than that of the first.
    #[arg(long, value_name = "FORMAT", value_parser = body_formats())]
    format_b: Option<Format>,
    /// The number of lines of the second table to leave out at its start.
    #[arg(long, value_name = "N")]
    skip_b: Option<u64>,
    /// The first line of the second table, behind those that are left out, holds data.
    #[arg(long)]
    no_header_b: bool,
}

impl PlacingOfSecond {
    /// The format of the second file: its own, or that of both.
    pub(super) fn format(&self, of_both: Option<Format>) -> Option<Format> {
        self.format_b.or(of_both)
    }

    /// The number of lines that are left out of the second table: its own, or that of both.
    pub(super) fn skip(&self, of_both: Option<u64>) -> Option<u64> {
        told(self.skip_b, self.no_header_b).or(of_both)
    }

    /// The name of an option that is given, if there is one.
    pub(super) fn given(&self) -> Option<&'static str> {
        let given = [
            (self.pose_b.is_some(), "--pose-b"),
            (self.turn_b.is_some(), "--turn-b"),
            (self.shift_b.is_some(), "--move-b"),
            (self.columns_are_generators_b, "--columns-are-generators-b"),
            (self.center_first_b, "--center-first-b"),
            (self.format_b.is_some(), "--format-b"),
            (self.skip_b.is_some(), "--skip-b"),
            (self.no_header_b, "--no-header-b"),
        ];
        given.into_iter().find(|(is_given, _)| *is_given).map(|(_, name)| name)
    }

    /// The options as those of a single body.
    pub(super) fn placing(&self) -> Placing {
        Placing {
            pose: self.pose_b.clone(),
            turn: self.turn_b.clone(),
            shift: self.shift_b.clone(),
            columns_are_generators: self.columns_are_generators_b,
            center_first: self.center_first_b,
        }
    }
}

impl Placing {
    /// The files that are read: the body, and perhaps a pose.
    pub(super) fn inputs<'a>(&'a self, body: &'a Path) -> Vec<&'a Path> {
        [Some(body), self.pose.as_deref()].into_iter().flatten().collect()
    }

    /// The name of an option that is given, if there is one.
    pub(super) fn given(&self) -> Option<&'static str> {
        let given = [
            (self.pose.is_some(), "--pose"),
            (self.turn.is_some(), "--turn"),
            (self.shift.is_some(), "--move"),
            (self.columns_are_generators, "--columns-are-generators"),
            (self.center_first, "--center-first"),
        ];
        given.into_iter().find(|(is_given, _)| *is_given).map(|(_, name)| name)
    }

    /// Reads the body, and puts it where its file and the options say: first the pose of its file, then that of the
    /// option, then the turn, then the move.
    pub(super) fn read(
        &self,
        file: &Path,
        format: Option<Format>,
        skip: Option<u64>,
        options: OptionNames,
    ) -> anyhow::Result<BodyFile> {
        start::check(skip, format, file, options.skip)?;
        let Self { columns_are_generators, center_first, .. } = *self;
        let layout = Layout { columns_are_generators, center_first, skip };
        let (mut placed, origin) = BodySource { file: file.to_path_buf(), format, layout, options }.read(tell)?;
        placed.pose = self.after(placed.pose.take(), placed.dimension(), file, options)?;
        Ok(BodyFile { placed, origin, layout })
    }

    /// The placement by the options after one that a file may state; none where neither states one.
    pub(super) fn after(
        &self,
        first: Option<Placement>,
        dimension: usize,
        file: &Path,
        options: OptionNames,
    ) -> anyhow::Result<Option<Placement>> {
        let given = [
            self.pose.as_deref().map(|pose| pose_file::read(pose, dimension, options.pose)),
            self.turn.as_ref().map(|turn| turn.placement(dimension, options)),
            self.shift.as_ref().map(|shift| shift.placement(dimension, options.shift)),
        ];
        let mut all = first;
        for next in given.into_iter().flatten() {
            let next = next?;
            all = Some(match all {
                None => next,
                Some(first) => {
                    let beyond = || anyhow!("{}: the poses lead beyond the range of doubles", file.display());
                    let (both, is_exact) = next.after(&first).ok_or_else(beyond)?;
                    if !is_exact {
                        tell(&format!(
                            "{}: several poses are made one, each number rounded to nearest",
                            file.display()
                        ));
                    }
                    both
                }
            });
        }
        Ok(all)
    }

    /// The name of an option that says which vectors are generators, if one is given.
    pub(super) fn layout_given(&self) -> Option<&'static str> {
        let columns = self.columns_are_generators.then_some("--columns-are-generators");
        columns.or(self.center_first.then_some("--center-first"))
    }
}

/// The placement by a turn and then a move; none where neither is given.
pub(super) fn put(
    dimension: usize,
    turn: Option<&Turn>,
    shift: Option<&Shift>,
    options: OptionNames,
) -> anyhow::Result<Option<Placement>> {
    let turned = turn.map(|turn| turn.placement(dimension, options)).transpose()?;
    let moved = shift.map(|shift| shift.placement(dimension, options.shift)).transpose()?;
    // a move after a turn is the translation of the turned body
    Ok(match (turned, moved) {
        (Some(turned), Some(moved)) => Placement::new(turned.matrix().to_vec(), moved.translation().to_vec()),
        (turned, moved) => turned.or(moved),
    })
}

/// The pose in words, with the exact numbers that are taken.
pub(super) fn in_words(pose: &Placement) -> String {
    let in_full = |vector: &[f64]| format!("({})", vector.iter().map(|&x| in_full(x)).collect::<Vec<_>>().join(", "));
    let moved = format!("translation {}", in_full(pose.translation()));
    if *pose.matrix() == *Placement::identity(pose.translation().len()).matrix() {
        return moved;
    }
    let rows: Vec<String> = pose.matrix().iter().map(|row| in_full(row)).collect();
    format!("matrix ({}), {moved}", rows.join(", "))
}

/// Says of a body of a file how many generators it has, where its centre is, and what pose put it there.
pub(super) fn describe(table: &mut Table, [name, pose_name]: [&str; 2], placed: &Placed, file: &Path) {
    let count = counted(placed.body.generators.len(), "generator", "generators");
    let (center, is_exact) = placed.center();
    let of_pose = if is_exact { "" } else { ", rounded" };
    let rounded = if placed.body.is_rounded { ROUNDED } else { "" };
    table.row(
        name,
        format!("{count} in {}, centre {}{of_pose}{rounded}", file.display(), position(&center, placed.reach())),
    );
    if let Some(pose) = &placed.pose {
        table.row(pose_name, in_words(pose));
    }
}

/// The reach of the smaller one of two bodies that is no point; 0 if both are points.
pub(super) fn smaller_reach(bodies: &[Placed; 2]) -> f64 {
    let [a, b] = bodies.each_ref().map(Placed::reach);
    if a == 0.0 || b == 0.0 { a.max(b) } else { a.min(b) }
}

/// The note on a body whose centre and generators are rounded images under its pose.
pub(super) fn rounded_in_words(off: f64) -> String {
    format!("the body under the pose is taken in doubles, no point of it farther off than {}", figure(off))
}
