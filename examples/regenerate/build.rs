//! Two solvers of the catalogue; `templates/` has another template for one of them.

fn main() -> Result<(), eliminant_generator::BuildError> {
    eliminant_generator::Generator::new()
        .problems(eliminant_templates::FOLDER)
        .only(["pose_35pt_focal", "two_conics"])
        .templates("templates")
        .run()
}
