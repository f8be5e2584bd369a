//! The command line.

use clap::{Parser, Subcommand};

use crate::commands::{
    collide, compare, contains, distance, draw, enclose, explore, figure, hausdorff, inspect, intersect, list, merge,
    mesh, records, reduce, reproduce, shell, solve, sweep, verify,
};

/// Zonotopes as bounding volumes: enclose data, check answers, reproduce every figure and number of the report.
#[derive(Debug, Parser)]
#[command(name = "zonobench", version, arg_required_else_help = true)]
pub struct Cli {
    /// The work to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run every experiment, draw every figure, check every claim, and write the report.
    Reproduce(reproduce::Options),
    /// Put together the parts that `reproduce --shard` or `solve --shard` wrote.
    Merge(merge::Options),
    /// Draw one figure of the report.
    Figure(figure::Options),
    /// Draw your own data as the paper draws its examples.
    Draw(draw::Options),
    /// Hand on what a run of `reproduce` recorded.
    Records(records::Options),
    /// Compare what two runs of `reproduce` recorded: counts must agree, times are told as ratios.
    Compare(compare::Options),
    /// List experiments, figures, claims and methods.
    List(list::Options),
    /// Find the smallest zonotope around the points of a file, by area or by total length.
    Enclose(enclose::Options),
    /// Tell whether two zonotopes have a point in common, with the proof.
    Intersect(intersect::Options),
    /// Tell for each point of a file whether a zonotope contains it.
    Contains(contains::Options),
    /// Tell how far apart two zonotopes are, or how deep they overlap.
    Distance(distance::Options),
    /// Tell how different two zonotopes are: their Hausdorff distance, and whether one contains the other.
    Hausdorff(hausdorff::Options),
    /// Tell whether two zonotopes or two meshes in motion meet, and when first, with the proof.
    Collide(collide::Options),
    /// Tell whether two meshes of triangles meet, in which pairs of triangles, or how far apart they are.
    Mesh(mesh::Options),
    /// Find a zonotope around all placements of a zonotope that turns about an axis and translates.
    Sweep(sweep::Options),
    /// Find a zonotope of few generators around a zonotope.
    Reduce(reduce::Options),
    /// Tell what kind of body a zonotope is: faces, volume, size.
    Inspect(inspect::Options),
    /// Answer questions, one line of JSON each.
    Solve(solve::Options),
    /// Check answers against their questions, exactly.
    Verify(verify::Options),
    /// Write the page that shows the paper's geometry at work, and open it in the browser.
    Explore(explore::Options),
    /// Print the completions of the command line for a shell.
    Completions(shell::CompletionOptions),
    /// Print a page of the manual in the format of `man`.
    Man(shell::ManOptions),
}
