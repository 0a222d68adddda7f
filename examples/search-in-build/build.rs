//! `problems/meet.rs` has no template file: with the feature `search` the build script constructs
//! the template.

fn main() -> Result<(), eliminant_generator::BuildError> {
    eliminant_generator::Generator::new().problems("problems").run()
}
