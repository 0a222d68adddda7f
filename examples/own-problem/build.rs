fn main() -> Result<(), eliminant_generator::BuildError> {
    eliminant_generator::Generator::new().problems("problems").run()
}
