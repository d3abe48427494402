//! Finds the shared library and tells the linker, and dependent build scripts, where it is.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{self, Command};
use std::time::SystemTime;

fn main() {
    for name in ["BEMPD_LIB_DIR", "PKG_CONFIG", "PKG_CONFIG_PATH", "PKG_CONFIG_LIBDIR"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    let folder = find_library().unwrap_or_else(|sentence| {
        eprintln!("bempd-sys: {sentence}");
        process::exit(1);
    });
    // A run path must not depend on where the program is started.
    let folder = folder.canonicalize().unwrap_or(folder);
    println!("cargo:rerun-if-changed={}", library_in(&folder).display());
    println!("cargo:rustc-link-search=native={}", folder.display());
    println!("cargo:rustc-link-lib=dylib=bempd");
    println!("cargo:lib_dir={}", folder.display());
}

fn find_library() -> Result<PathBuf, String> {
    if let Some(folder) = env::var_os("BEMPD_LIB_DIR") {
        let folder = PathBuf::from(folder);
        return if has_library(&folder) {
            Ok(folder)
        } else {
            Err(format!(
                "BEMPD_LIB_DIR is \"{}\", where no {} is; set it to the folder of the library",
                folder.display(),
                library_name()
            ))
        };
    }
    from_pkg_config().or_else(from_build_tree).ok_or_else(|| {
        format!(
            "{} was not found: BEMPD_LIB_DIR is not set, pkg-config knows no bempd >= {}, and {} holds no build; \
             build the library with cmake, then set BEMPD_LIB_DIR to the library's folder or PKG_CONFIG_PATH to that of bempd.pc",
            library_name(),
            env!("CARGO_PKG_VERSION"),
            build_tree().display()
        )
    })
}

fn from_pkg_config() -> Option<PathBuf> {
    let program = env::var_os("PKG_CONFIG").unwrap_or_else(|| "pkg-config".into());
    let ask = |question: &str| {
        let answer = Command::new(&program).args([question, "bempd"]).output().ok()?;
        answer.status.success().then(|| String::from_utf8_lossy(&answer.stdout).trim().to_owned())
    };
    ask(concat!("--atleast-version=", env!("CARGO_PKG_VERSION")))?;
    // pkg-config escapes spaces for a shell.
    let folder = PathBuf::from(ask("--variable=libdir")?.replace('\\', ""));
    has_library(&folder).then_some(folder)
}

/// The newest library of the build tree; one built with sanitizers cannot be loaded by an ordinary program.
fn from_build_tree() -> Option<PathBuf> {
    fs::read_dir(build_tree())
        .ok()?
        .flatten()
        .filter(|entry| entry.file_name() != "sanitize")
        .map(|entry| entry.path().join("src").join("capi"))
        .filter(|folder| has_library(folder))
        .max_by_key(|folder| written(&library_in(folder)))
}

fn build_tree() -> PathBuf {
    let tree = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../build");
    tree.canonicalize().unwrap_or(tree)
}

fn written(file: &Path) -> SystemTime {
    fs::metadata(file).and_then(|facts| facts.modified()).unwrap_or(SystemTime::UNIX_EPOCH)
}

fn has_library(folder: &Path) -> bool {
    library_in(folder).exists()
}

fn library_in(folder: &Path) -> PathBuf {
    folder.join(library_name())
}

fn library_name() -> &'static str {
    match env::var("CARGO_CFG_TARGET_OS").as_deref() {
        Ok("macos") => "libbempd.dylib",
        Ok("windows") => "bempd.lib",
        _ => "libbempd.so",
    }
}
