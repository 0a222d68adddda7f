//! The report of `cylinders triangulate`: one page that needs no other file, whose names are text,
//! and whose script runs in a browser.

#![cfg(feature = "command")]

use std::path::{Path, PathBuf};
use std::process::Command;

use eliminant_cylinders::command::run;
use serde_json::Value;

/// A PNG file of one pixel that claims to be 4000 x 3000: only its header is read.
const PHOTOGRAPH: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x0f\xa0\0\0\x0b\xb8\x08\0\0\0\0";

/// A folder with a scene whose label and image names are tags, and a photograph of its first view.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a writable folder for tests");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/soda_can.json");
    let mut scene: Value = serde_json::from_str(&std::fs::read_to_string(path).expect("a file")).expect("JSON");
    for (index, view) in scene["views"].as_array_mut().expect("views").iter_mut().enumerate() {
        view["image"] = if index == 0 { "first.png".into() } else { format!("<b>{index}</b>").into() };
        view["cylinders"] = serde_json::json!(["<script>bad()</script>", "<script>bad()</script>"]);
    }
    std::fs::write(folder.join("scene.json"), scene.to_string()).expect("written");
    std::fs::write(folder.join("first.png"), PHOTOGRAPH).expect("written");
    folder
}

fn triangulate(folder: &Path, more: &[&str]) -> (u8, String) {
    let (scene, page) = (folder.join("scene.json"), folder.join("page.html"));
    let (scene, page) = (scene.display().to_string(), page.display().to_string());
    let arguments = ["cylinders", "triangulate", &scene, "--report", &page];
    let mut error = Vec::new();
    let code = run(arguments.iter().chain(more), &mut Vec::new(), &mut error);
    (code, String::from_utf8(error).expect("UTF-8"))
}

fn page(folder: &Path) -> String {
    std::fs::read_to_string(folder.join("page.html")).expect("a page")
}

#[test]
fn it_is_one_file_and_names_are_text() {
    let folder = folder("report_names");
    assert_eq!(triangulate(&folder, &["--refine"]), (0, String::new()));
    let text = page(&folder);
    assert!(text.starts_with("<!doctype html>") && text.ends_with("</html>\n") && !text.contains("{{"));
    assert!(!text.contains("<script>bad") && !text.contains("<b>"));
    assert!(text.contains("&lt;script&gt;bad()&lt;/script&gt;") && text.contains("&lt;b&gt;7&lt;/b&gt;"));
    // Nothing is loaded: every address is in the page. That of the SVG namespace is only a name.
    for address in text.split("href=\"").skip(1).chain(text.split("src=\"").skip(1)) {
        assert!(address.starts_with("data:image/"), "{}", &address[..40]);
    }
    assert_eq!(text.matches("<figure>").count(), 8);
    assert_eq!(text.matches("href=\"data:image/png;base64,").count(), 1);
    assert_eq!(text.matches("viewBox=\"0 0 4000 3000\"").count(), 8);
    assert_eq!(text.matches("class=\"given\"").count(), 16);
    assert_eq!(text.matches("class=\"found\"").count(), 16);
    // The table has the radius and its deviation as the JSON has them, and each line has a row.
    let out = folder.join("out.json").display().to_string();
    assert_eq!(triangulate(&folder, &["--refine", "--out", &out]).0, 0);
    let report: Value = serde_json::from_str(&std::fs::read_to_string(out).expect("a file")).expect("JSON");
    let report = &report["cylinders"][0];
    for value in [&report["radius"], &report["refinement"]["radius_deviation"]] {
        assert!(text.contains(&format!("<td>{:.7}</td>", value.as_f64().expect("a number"))), "{value}");
    }
    assert_eq!(text.matches("<tr><td>").count(), 1 + 16);
}

#[test]
fn it_is_the_same_each_time_and_written_with_the_others_or_not() {
    let folder = folder("report_files");
    assert_eq!(triangulate(&folder, &[]).0, 0);
    let first = page(&folder);
    assert_eq!(triangulate(&folder, &[]).0, 0);
    assert_eq!(first, page(&folder));
    std::fs::remove_file(folder.join("page.html")).expect("removed");
    let (code, error) = triangulate(&folder, &["--out", "no/such/folder/out.json"]);
    assert!(code == 1 && error.starts_with("error: cannot write `no/such/folder/out.json`"), "{error}");
    assert!(!folder.join("page.html").exists());
}

/// The first browser of these that is installed.
fn browser() -> Option<PathBuf> {
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    let names = ["chromium", "chromium-browser", "google-chrome", "chrome"];
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|path| path.is_file())
}

#[test]
fn its_script_runs_in_a_browser() {
    let Some(browser) = browser() else {
        println!("skipped: no Chromium is installed to open the page");
        return;
    };
    let folder = folder("report_browser");
    assert_eq!(triangulate(&folder, &[]).0, 0);
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--disable-quic"])
        .args(["--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"])
        .args(["--window-size=1400,2000", "--dump-dom"])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("file://{}", folder.join("page.html").display()))
        .output()
        .expect("a run of the browser");
    let dom = String::from_utf8_lossy(&output.stdout);
    let root = dom.split('>').find(|tag| tag.trim_start().starts_with("<html")).unwrap_or_default();
    assert!(root.contains("data-ready=\"true\"") && !root.contains("data-error"), "{root}");
    // 48 facets of one cylinder, and 8 edges of the pyramid of each of 8 cameras.
    assert!(root.contains(&format!("data-shapes=\"{}\"", 48 + 8 * 8)), "{root}");
    assert_eq!((dom.matches("<figure>").count(), dom.matches("<canvas").count()), (8, 1));
    assert_eq!(dom.matches("<script").count(), 2);
}
