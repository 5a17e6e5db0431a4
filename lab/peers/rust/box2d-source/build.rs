//! Compiles the checkout of Box2D that BOX2D_SOURCE names, by the compiler in CC, and makes the bindings from its own headers, so that no layout is guessed.

use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=BOX2D_SOURCE");
    let source = PathBuf::from(std::env::var_os("BOX2D_SOURCE").expect("BOX2D_SOURCE names no checkout of Box2D"));
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    for folder in ["src", "include"] {
        println!("cargo:rerun-if-changed={}", source.join(folder).display());
    }
    compile(&source);
    write_bindings(&source, &out.join("bindings.rs"));
    println!("cargo:rustc-env=BOX2D_REVISION={}", revision_of(&source));
}

/// As Box2D's own release build does.
fn compile(source: &Path) {
    let mut files: Vec<PathBuf> = std::fs::read_dir(source.join("src"))
        .expect("the checkout has a folder src")
        .map(|entry| entry.expect("src can be listed").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "c"))
        .collect();
    files.sort();
    let mut build = cc::Build::new();
    build.files(files).include(source.join("include")).include(source.join("src")).std("gnu17").warnings(false);
    if std::env::var_os("CARGO_FEATURE_AVX2").is_some() {
        build.define("BOX2D_AVX2", None).flag("-mavx2");
    }
    build.compile("box2d");
}

/// Also tells whether b2DestroyJoint asks if the bodies are to wake, which it did until August 2026.
fn write_bindings(source: &Path, file: &Path) {
    let bindings = bindgen::Builder::default()
        .header(source.join("include/box2d/box2d.h").to_string_lossy())
        .clang_arg(format!("-I{}", source.join("include").display()))
        .clang_args(["-x", "c", "-std=gnu17"])
        .allowlist_function("b2.*")
        .allowlist_type("b2.*")
        .layout_tests(false)
        .formatter(bindgen::Formatter::None)
        .generate()
        .expect("bindings for include/box2d/box2d.h");
    println!("cargo:rustc-check-cfg=cfg(destroying_asks_to_wake)");
    if bindings.to_string().contains("wakeAttached") {
        println!("cargo:rustc-cfg=destroying_asks_to_wake");
    }
    bindings.write_to_file(file).expect("OUT_DIR can be written");
}

/// Of the checkout's commit the first seven digits, with a + when something was changed since; "checkout" when git can't tell.
fn revision_of(source: &Path) -> String {
    let git = |arguments: &[&str]| {
        let output = Command::new("git").arg("-C").arg(source).args(arguments).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_string())
    };
    if !source.join(".git").exists() {
        return "checkout".to_string(); // an unpacked archive, perhaps within another repository
    }
    match git(&["rev-parse", "--short=7", "HEAD"]) {
        Some(commit) => commit + if git(&["status", "--porcelain"]).is_some_and(|changes| !changes.is_empty()) { "+" } else { "" },
        None => "checkout".to_string(),
    }
}
