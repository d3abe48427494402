fn main() {
    println!("cargo:rustc-link-arg=-Wl,-rpath,{}", std::env::var("DEP_BEMPD_LIB_DIR").unwrap());
}
