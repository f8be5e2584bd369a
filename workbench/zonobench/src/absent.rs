//! Options of reading that some commands have and others do not: a command without one says why.

/// The commands that read bodies and nothing else from tables.
const OF_BODIES: [&str; 7] = ["intersect", "distance", "hausdorff", "collide", "sweep", "reduce", "inspect"];

/// The options of reading points that no body has, with the reason.
const OF_POINTS: [(&str, &str); 2] = [
    ("--columns", "the rows of a zonotope are read whole; names in a header say which column is the centre"),
    (
        "--skip-nan",
        "no generators of a zonotope are left out, as it would be another one; a number that is missing is an error",
    ),
];

/// The reason why a command does not have an option of reading; none of other options.
pub(crate) fn reason(command: &str, option: &str) -> Option<&'static str> {
    let is_of_layout = ["--columns-are-generators", "--center-first"].contains(&option);
    let is_of_table = ["--columns", "--skip", "--no-header", "--skip-nan"].contains(&option);
    match command {
        _ if OF_BODIES.contains(&command) => {
            OF_POINTS.iter().find(|(name, _)| *name == option).map(|(_, reason)| *reason)
        }
        "mesh" if option == "--skip-nan" => Some("a mesh without a vertex is another one, so that is an error"),
        "mesh" if is_of_table => Some("meshes have no columns and no header"),
        "mesh" if is_of_layout => Some("meshes have no generators"),
        "enclose" if is_of_layout => Some("the rows of the file are points; a zonotope is read by other commands"),
        "verify" if is_of_layout => Some("an answer records how its zonotopes were read"),
        "solve" if is_of_table || is_of_layout || option == "--format" => {
            Some("questions are lines of JSON, and numbers that are missing are refused one by one")
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::Cli;
    use clap::CommandFactory;

    /// Every command that reads files has every option of reading, or says why not, and never both.
    #[test]
    fn each_option_of_reading_is_there_or_has_its_reason() {
        let cli = Cli::command();
        let reading = [
            "--columns",
            "--format",
            "--skip",
            "--no-header",
            "--skip-nan",
            "--columns-are-generators",
            "--center-first",
        ];
        let commands = OF_BODIES.into_iter().chain(["mesh", "enclose", "contains", "draw", "verify", "solve"]);
        for name in commands {
            let command = cli.find_subcommand(name).expect("a command");
            for option in reading {
                let is_there = command
                    .get_arguments()
                    .any(|argument| argument.get_long().is_some_and(|long| option.strip_prefix("--") == Some(long)));
                assert!(is_there != reason(name, option).is_some(), "{name} {option}: there: {is_there}");
            }
        }
    }
}
