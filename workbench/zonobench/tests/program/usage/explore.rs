//! `explore`: the page is written whole, and handed to the program that opens pages.

use std::fs;

use crate::run;

#[test]
fn the_page_is_one_file_that_names_its_compiler_and_loads_nothing() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let written = run(folder.path(), &["explore", "--out", "new/page.html"]);
    assert_eq!((written.status, written.stderr.as_str()), (0, ""));
    assert!(written.stdout.starts_with("new/page.html: the page"), "{}", written.stdout);
    let page = fs::read_to_string(folder.path().join("new/page.html")).expect("the page is text");
    assert!(page.starts_with("<!doctype html>") && page.trim_end().ends_with("</html>"));
    assert!(page.contains("<meta name=\"compiler\" content=\"rustc 1."));
    assert!(page.len() <= 2_400_000, "{} bytes", page.len());
    for attribute in [" src=", " href="] {
        assert!(!page.contains(&format!("{attribute}\"http")), "the page loads nothing");
    }
    assert_eq!(run(folder.path(), &["explore", "--out", "-"]).stdout, page);

    let again = run(folder.path(), &["explore", "--out", "new/page.html"]);
    assert_eq!(again.stderr, "zonobench: new/page.html: exists already; --force replaces it\n");
    assert_eq!((again.status, run(folder.path(), &["explore", "--out", "new/page.html", "--force"]).status), (1, 0));
}

#[test]
fn explore_wants_a_file_or_a_browser() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for words in [&["explore"][..], &["explore", "--out", "-", "--open"]] {
        let refused = run(folder.path(), words);
        assert_eq!((refused.status, refused.stdout.as_str()), (2, ""), "{words:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn the_browser_gets_the_place_of_the_page() {
    use std::os::unix::fs::PermissionsExt;
    use std::process::Command;
    use std::time::Duration;

    let folder = tempfile::tempdir().expect("a temporary folder");
    let browser = folder.path().join("browser");
    fs::write(&browser, "#!/bin/sh\nprintf '%s' \"$1\" >opened.part && mv opened.part opened\n").expect("written");
    fs::set_permissions(&browser, fs::Permissions::from_mode(0o755)).expect("a program");
    let explore = |browser: &std::path::Path| {
        Command::new(env!("CARGO_BIN_EXE_zonobench"))
            .args(["explore", "--out", "page.html", "--open", "--force"])
            .current_dir(folder.path())
            .env("BROWSER", browser)
            .output()
            .expect("the program ends")
    };
    assert!(explore(&browser).status.success());
    let opened = folder.path().join("opened");
    for _ in 0..200 {
        if opened.exists() {
            break;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    let page = folder.path().join("page.html").canonicalize().expect("written");
    assert_eq!(fs::read_to_string(&opened).expect("the browser ran"), page.display().to_string());
    let missing = explore(&folder.path().join("no browser"));
    let complaint = String::from_utf8(missing.stderr).expect("text");
    assert!(!missing.status.success() && complaint.contains("is written, but cannot be opened"), "{complaint}");
}
