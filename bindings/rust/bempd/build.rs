//! Puts the library's folder into the run path of this package's own tests and examples.

fn main() {
    let folder = std::env::var("DEP_BEMPD_LIB_DIR").expect("bempd-sys says where the library is");
    println!("cargo:rustc-link-arg=-Wl,-rpath,{folder}");
}
