//! Files that appear whole or not at all, and results that take standard output in place of a file.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf, absolute};

use tempfile::{Builder, NamedTempFile};
use thiserror::Error;

use crate::standard_output::{StandardOutput, check_standard_output};

/// Why a file was not written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum OutputError {
    /// The file exists and may not be replaced.
    #[error("{}: exists already; --force replaces it", .0.display())]
    Exists(PathBuf),
    /// The file is read as well.
    #[error("{}: is read, so it is not written over", .0.display())]
    Input(PathBuf),
    /// The file is a link, which would be replaced.
    #[error("{}: is a link; name the file that it leads to, or - for standard output", .0.display())]
    Link(PathBuf),
    /// Standard output cannot be written; the complaint names it.
    #[error("{0}")]
    StandardOutput(#[source] io::Error),
    /// Two results would be written to the file.
    #[error("{}: two results cannot be written to one file", .0.display())]
    Twice(PathBuf),
    /// The file cannot be written.
    #[error("{}: cannot be written: {source}", .file.display())]
    Unwritable {
        /// The file.
        file: PathBuf,
        /// The system's complaint.
        source: io::Error,
    },
}

/// Whether a file that exists may be replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existing {
    /// Refuse.
    Keep,
    /// Replace it.
    Replace,
}

impl Existing {
    /// The meaning of the switch `--force`.
    pub fn from_force(force: bool) -> Self {
        if force { Self::Replace } else { Self::Keep }
    }
}

/// Results on their way to files.
#[derive(Debug, Default)]
pub struct Results<'a>(Vec<(&'a Path, anyhow::Result<Vec<u8>>)>);

impl<'a> Results<'a> {
    /// Adds a result that a file was named for; it is not made otherwise.
    pub fn add(&mut self, file: Option<&'a PathBuf>, content: impl FnOnce() -> anyhow::Result<Vec<u8>>) {
        self.0.extend(file.map(|file| (file.as_path(), content())));
    }
}

/// The destinations of the results of a command: to files, and one of them to standard output if it is named `-`.
#[derive(Debug, Clone, Copy)]
pub struct Outputs {
    existing: Existing,
    /// Whether a result has standard output to itself.
    has_piped_result: bool,
}

impl Outputs {
    /// Refuses early, before the work is done, what [`write_whole`] would refuse after it: files that exist, whose
    /// folder cannot be made or takes no files, that are named twice or are read as well. Standard output is refused
    /// where it is closed and a result goes there, or everything does because no file is named.
    pub fn checked<'a>(
        outputs: impl IntoIterator<Item = &'a PathBuf>,
        inputs: &[&Path],
        existing: Existing,
    ) -> Result<Self, OutputError> {
        let place =
            |file: &Path| file.canonicalize().or_else(|_| absolute(file)).unwrap_or_else(|_| file.to_path_buf());
        let inputs: Vec<PathBuf> = inputs.iter().filter(|file| !is_piped(file)).map(|input| place(input)).collect();
        let mut taken = Vec::new();
        for output in outputs {
            let place = if is_piped(output) {
                check_standard_output().map_err(OutputError::StandardOutput)?;
                output.clone()
            } else {
                check_free(output, existing)?;
                check_room(output).map_err(unwritable(output))?;
                place(output)
            };
            if inputs.contains(&place) {
                return Err(OutputError::Input(output.clone()));
            }
            if taken.contains(&place) {
                return Err(OutputError::Twice(output.clone()));
            }
            taken.push(place);
        }
        if taken.is_empty() {
            check_standard_output().map_err(OutputError::StandardOutput)?;
        }
        Ok(Self { existing, has_piped_result: taken.iter().any(|place| is_piped(place)) })
    }

    /// Writes a result to its file, or to standard output.
    pub fn write(&self, file: &Path, content: &[u8]) -> Result<(), OutputError> {
        if !is_piped(file) {
            return write_whole(file, content, self.existing);
        }
        StandardOutput::print(content).map_err(OutputError::StandardOutput)
    }

    /// Writes the results, each to its file, and tells the summary whatever becomes of them: one that cannot be made or
    /// written keeps none of the others back. Gives the first failure.
    pub fn finish(&self, results: Results<'_>, summary: &str) -> anyhow::Result<()> {
        let outcomes = self.write_all(results);
        let told = self.tell(summary);
        first_failure(outcomes).and(told.map_err(Into::into))
    }

    /// The same, with the summary on standard error: standard output has lines of its own.
    pub fn finish_on_standard_error(&self, results: Results<'_>, summary: &str) -> anyhow::Result<()> {
        let outcomes = self.write_all(results);
        let told = io::stderr().lock().write_all(summary.as_bytes());
        first_failure(outcomes).and(told.map_err(Into::into))
    }

    /// Writes one result to its file, and tells the summary, which says that it is there, unless it is not.
    pub fn finish_one(&self, file: &Path, content: &[u8], summary: &str) -> anyhow::Result<()> {
        self.write(file, content)?;
        Ok(self.tell(summary)?)
    }

    /// The fate of each result.
    fn write_all(&self, results: Results<'_>) -> Vec<anyhow::Result<()>> {
        results.0.into_iter().map(|(file, content)| Ok(self.write(file, &content?)?)).collect()
    }

    /// Prints lines on standard output, unless a result has that to itself.
    pub fn print(&self, lines: &str) -> io::Result<()> {
        if self.has_piped_result { Ok(()) } else { StandardOutput::print(lines.as_bytes()) }
    }

    /// Tells a person what was found: on standard output, or on standard error where a result has that to itself.
    pub fn tell(&self, summary: &str) -> io::Result<()> {
        if self.has_piped_result {
            io::stderr().lock().write_all(summary.as_bytes())
        } else {
            StandardOutput::print(summary.as_bytes())
        }
    }
}

fn first_failure(outcomes: Vec<anyhow::Result<()>>) -> anyhow::Result<()> {
    outcomes.into_iter().collect()
}

fn is_piped(file: &Path) -> bool {
    file.as_os_str() == "-"
}

fn check_free(file: &Path, existing: Existing) -> Result<(), OutputError> {
    if file.is_dir() && !file.is_symlink() {
        return Err(unwritable(file)(io::Error::other("is a folder, not a file")));
    }
    // A file takes the place of a link, not of what the link leads to; `/dev/stdout` is one.
    if file.is_symlink() {
        return Err(OutputError::Link(file.to_path_buf()));
    }
    if existing == Existing::Keep && file.symlink_metadata().is_ok() {
        return Err(OutputError::Exists(file.to_path_buf()));
    }
    if file.exists() && !file.is_file() {
        return Err(unwritable(file)(io::Error::other("is not an ordinary file")));
    }
    Ok(())
}

/// Makes a file of a temporary name where the given one will stand, or where its folder will be made.
fn check_room(file: &Path) -> io::Result<()> {
    match file.symlink_metadata() {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
        _ => {}
    }
    let existing = folder_of(file).ancestors().find(|folder| folder.as_os_str().is_empty() || folder.exists());
    let folder = existing.filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let told = |error: io::Error| {
        let kind = error.kind();
        io::Error::new(kind, format!("no file can be made in {}: {}", folder.display(), io::Error::from(kind)))
    };
    new_file(folder).map(drop).map_err(told)
}

fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

/// Writes `content` under a temporary name in the same folder, then gives it its own name in one step, so that whatever
/// interrupts the program, nothing partial ever stands under the final name. Missing folders are made.
pub fn write_whole(file: &Path, content: &[u8], existing: Existing) -> Result<(), OutputError> {
    check_free(file, existing)?;
    let folder = folder_of(file);
    fs::create_dir_all(folder).map_err(unwritable(file))?;
    let temporary = written(folder, content).map_err(unwritable(file))?;
    let outcome = match existing {
        Existing::Replace => temporary.persist(file),
        Existing::Keep => temporary.persist_noclobber(file),
    };
    match outcome {
        Ok(_) => Ok(()),
        Err(error) if error.error.kind() == io::ErrorKind::AlreadyExists => {
            Err(OutputError::Exists(file.to_path_buf()))
        }
        Err(error) => Err(unwritable(file)(error.error)),
    }
}

fn written(folder: &Path, content: &[u8]) -> io::Result<NamedTempFile> {
    let temporary = new_file(folder)?;
    // The file itself, as the temporary one would add its name to every complaint.
    let mut file = temporary.as_file();
    file.write_all(content)?;
    file.sync_all()?;
    Ok(temporary)
}

/// An empty file of a temporary name, which goes when it is dropped.
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".zonobench-");
    // Ordinary permissions (the process's mask applies) in place of a temporary file's private ones.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

fn unwritable(file: &Path) -> impl FnOnce(io::Error) -> OutputError {
    let file = file.to_path_buf();
    |source| OutputError::Unwritable { file, source }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_kept_unless_replacing_is_asked_for() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let file = folder.path().join("a/b.txt");
        write_whole(&file, b"one", Existing::Keep).expect("free");
        let refused = write_whole(&file, b"two", Existing::Keep).expect_err("taken");
        assert!(refused.to_string().ends_with("b.txt: exists already; --force replaces it"));
        assert_eq!(fs::read(&file).expect("readable"), b"one");
        write_whole(&file, b"two", Existing::Replace).expect("replaced");
        assert_eq!(fs::read(&file).expect("readable"), b"two");
        let names: Vec<_> = fs::read_dir(file.parent().expect("a folder")).expect("listed").collect();
        assert_eq!(names.len(), 1, "no temporary file stays behind");
    }

    #[test]
    fn a_file_has_one_use() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let [input, free] = ["input", "free"].map(|name| folder.path().join(name));
        fs::write(&input, "1").expect("writable");
        let check = |outputs: &[&PathBuf], existing| {
            let checked = Outputs::checked(outputs.iter().copied(), &[&input], existing);
            checked
                .map(|outputs| outputs.has_piped_result)
                .map_err(|error| error.to_string().rsplit(": ").next().unwrap_or_default().to_owned())
        };
        assert_eq!(check(&[&free], Existing::Keep), Ok(false));
        let complaint = |text: &str| Err(text.to_owned());
        assert_eq!(check(&[&input], Existing::Replace), complaint("is read, so it is not written over"));
        assert_eq!(check(&[&free, &free], Existing::Keep), complaint("two results cannot be written to one file"));
        let dash = PathBuf::from("-");
        assert_eq!(check(&[&free, &dash], Existing::Keep), Ok(true));
        assert_eq!(check(&[&dash, &dash], Existing::Keep), complaint("two results cannot be written to one file"));
    }

    #[cfg(unix)]
    #[test]
    fn links_are_not_replaced() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let [file, link] = ["file", "link"].map(|name| folder.path().join(name));
        fs::write(&file, "mine").expect("writable");
        std::os::unix::fs::symlink(&file, &link).expect("a link");
        let refused = Outputs::checked([&link], &[], Existing::Replace).expect_err("a link").to_string();
        assert!(refused.ends_with("link: is a link; name the file that it leads to, or - for standard output"));
        assert!(write_whole(&link, b"", Existing::Replace).is_err());
        assert!(link.is_symlink() && fs::read(&file).expect("readable") == b"mine");
    }

    #[test]
    fn a_file_that_cannot_be_written_is_refused_before_the_work() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let at = |name: &str| folder.path().join(name);
        fs::write(at("file"), "1").expect("writable");
        let long = "n".repeat(300);
        for name in ["file/a.json", "file/b/a.json", &long, "."] {
            let refused = Outputs::checked([&at(name)], &[], Existing::Replace).expect_err(name);
            assert!(matches!(refused, OutputError::Unwritable { .. }), "{name}: {refused}");
        }
        Outputs::checked([&at("new/folder/a.json")], &[], Existing::Keep).expect("folders are made");
        assert_eq!(fs::read_dir(folder.path()).expect("listed").count(), 1, "nothing is left of the trial");
    }

    #[test]
    fn a_result_that_fails_keeps_no_other_back() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let [broken, good] = ["broken", "good"].map(|name| folder.path().join(name));
        let outputs = Outputs::checked([&broken, &good], &[], Existing::Keep).expect("free");
        let mut results = Results::default();
        results.add(Some(&broken), || Err(anyhow::anyhow!("no faces")));
        results.add(Some(&good), || Ok(b"1".to_vec()));
        results.add(None, || unreachable!("nobody asked for it"));
        let failure = outputs.finish(results, "").expect_err("the first result fails");
        assert_eq!(failure.to_string(), "no faces");
        assert_eq!((broken.exists(), fs::read(&good).expect("written")), (false, b"1".to_vec()));
    }

    #[test]
    fn folders_are_not_replaced() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        assert!(write_whole(folder.path(), b"", Existing::Replace).is_err());
    }
}
