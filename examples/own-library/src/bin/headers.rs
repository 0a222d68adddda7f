//! Writes `own.h` and `own.hpp` into the folder `target/include`.

fn main() -> std::io::Result<()> {
    eliminant_capi_runtime::write_headers(&own_library::HEADERS, "target/include".as_ref())
}
