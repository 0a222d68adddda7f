//! Writes the committed scene `data/soda_can.json` to standard output.

mod random;
mod scene;

use std::io::Write;

fn main() -> std::io::Result<()> {
    let setup = scene::soda_can_setup();
    let photographs = scene::photographs(&scene::soda_can(), &setup, &mut random::Random::new(scene::SODA_CAN_SEED));
    std::io::stdout().write_all(scene::json(&setup, &photographs).as_bytes())
}
