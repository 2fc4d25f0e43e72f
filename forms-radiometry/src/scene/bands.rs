//! Bands: reduces a scene with several bands to a single band, with the midrange of every optical
//! number.

use super::midrange::middle;
use super::model::{LightKind, MaterialKind, Scene};

impl Scene {
    /// Returns the same scene in a single band, where every optical number is halfway between the
    /// smallest and the largest of its bands.
    pub(crate) fn with_one_band(&self) -> Self {
        let mut scene = self.clone();
        scene.bands = Vec::new();
        for medium in &mut scene.media {
            for values in
                [&mut medium.absorption, &mut medium.scattering, &mut medium.asymmetry, &mut medium.index]
            {
                merge(values);
            }
        }
        scene.merge_materials();
        scene.surfaces.iter_mut().for_each(|surface| merge(&mut surface.radiance));
        for light in &mut scene.lights {
            match &mut light.kind {
                LightKind::Point { intensity, .. } => merge(intensity),
                LightKind::Distant { irradiance, .. } => merge(irradiance),
            }
        }
        let ambient = &mut scene.ambient;
        match &mut ambient.map {
            Some(map) => (*map, ambient.radiance) = map.with_one_band(&ambient.radiance),
            None => merge(&mut ambient.radiance),
        }
        scene
    }

    /// Reduces the materials, and the textures of surfaces, to a single band.
    fn merge_materials(&mut self) {
        for surface in &mut self.surfaces {
            if let Some(texture) = &mut surface.texture {
                let most = self.materials[surface.material].kind.diffuse_reflectance();
                *texture = texture.with_one_band(most);
            }
        }
        for material in &mut self.materials {
            match &mut material.kind {
                MaterialKind::Diffuse { reflectance } | MaterialKind::Mirror { reflectance } => {
                    merge(reflectance);
                }
                MaterialKind::Plastic { reflectance, specular, .. } => {
                    merge(reflectance);
                    merge(specular);
                }
                MaterialKind::Conductor { eta, k } => {
                    merge(eta);
                    merge(k);
                }
                MaterialKind::Rough(rough) => rough.change_spectra(merge),
                MaterialKind::Dielectric { .. } => {}
            }
        }
    }
}

fn merge(values: &mut Vec<f64>) {
    if !values.is_empty() {
        *values = vec![middle(values)];
    }
}
