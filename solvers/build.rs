//! Emits every solver of `templates/`.

fn main() -> Result<(), eliminant_generator::BuildError> {
    eliminant_generator::Generator::new().problems("../templates").run()
}
