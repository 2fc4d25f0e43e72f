//! Prints the direct irradiance of the Cornell box at its named points.

use forms_radiometry::{CORNELL_BOX, scene, simulate_direct};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = scene::read(CORNELL_BOX, "cornell_box.toml")
        .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n\n"))?;
    for result in simulate_direct(&scene) {
        let total: f64 = result.irradiance.iter().sum();
        let unoccluded: f64 = result.unoccluded.iter().sum();
        println!("{:18} {total:20.14} W/m²  of {unoccluded:20.14}", result.receiver);
    }
    Ok(())
}
