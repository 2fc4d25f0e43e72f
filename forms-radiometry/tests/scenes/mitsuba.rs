//! Scenes of Mitsuba 3: each element with an equivalent is read into the model as intended, and
//! each element without one is named.

use crate::{read, scene, shown};
use forms_radiometry::geometry::{Mesh, Sphere, Vector};
use forms_radiometry::scene::{
    Effect, Force, LightKind, MaterialKind, ReceiverKind, Scene, Shape, SurfaceSide, not_simulated,
};
use forms_radiometry::simulation::{Unwatched, plan, simulate};

const FILE: &str = "box.xml";

/// One of every supported element.
pub(crate) const EVERYTHING: &str = r#"<scene version="3.5.0">
    <default name="width" value="8"/>
    <default name="n" value="1.5"/>
    <integrator type="volpath">
        <integer name="max_depth" value="-1"/>
        <integer name="rr_depth" value="10"/>
    </integrator>
    <bsdf type="twosided" id="white">
        <bsdf type="diffuse">
            <rgb name="reflectance" value="0.7, 0.6, 0.5"/>
        </bsdf>
    </bsdf>
    <bsdf type="conductor" id="mirror"/>
    <bsdf type="conductor" id="gold">
        <rgb name="eta" value="0.2 0.4 1.4"/>
        <spectrum name="k" value="2"/>
    </bsdf>
    <bsdf type="dielectric" id="glass">
        <float name="int_ior" value="$n"/>
        <string name="ext_ior" value="vacuum"/>
    </bsdf>
    <medium type="homogeneous" id="milk">
        <rgb name="albedo" value="0.5, 0.75, 1"/>
        <float name="sigma_t" value="2"/>
        <float name="scale" value="4"/>
        <phase type="hg">
            <float name="g" value="-0.25"/>
        </phase>
        <boolean name="sample_emitters" value="false"/>
    </medium>
    <shape type="rectangle" id="floor">
        <ref id="white"/>
        <sensor type="irradiancemeter" id="meter">
            <film type="hdrfilm">
                <integer name="width" value="1"/>
                <integer name="height" value="1"/>
            </film>
            <sampler type="independent">
                <integer name="sample_count" value="64"/>
            </sampler>
        </sensor>
    </shape>
    <shape type="rectangle" id="lamp">
        <transform name="to_world">
            <scale x="2" y="3"/>
            <rotate x="1" angle="180"/>
            <translate value="0, 0, 10"/>
        </transform>
        <emitter type="area">
            <rgb name="radiance" value="18, 11, 3"/>
        </emitter>
    </shape>
    <shape type="cube" id="block">
        <transform name="to_world">
            <matrix value="1 0 0 5  0 1 0 0  0 0 2 0  0 0 0 1"/>
        </transform>
        <ref id="gold"/>
    </shape>
    <shape type="sphere" id="ball">
        <point name="center" x="1" z="2"/>
        <float name="radius" value="0.5"/>
        <transform name="to_world">
            <scale value="2"/>
        </transform>
        <ref id="glass"/>
        <ref name="interior" id="milk"/>
    </shape>
    <shape type="sphere" id="cloud">
        <point name="center" value="30, 0, 0"/>
        <bsdf type="null"/>
        <ref name="interior" id="milk"/>
    </shape>
    <shape type="disk" id="lid">
        <transform name="to_world">
            <lookat origin="0, 9, 0" target="0, 8, 0" up="1, 0, 0"/>
        </transform>
        <ref id="mirror"/>
    </shape>
    <shape type="obj" id="part">
        <string name="filename" value="part.obj"/>
        <boolean name="face_normals" value="true"/>
        <boolean name="flip_normals" value="true"/>
    </shape>
    <emitter type="point">
        <point name="position" value="0, 1, 2"/>
        <rgb name="intensity" value="3"/>
    </emitter>
    <emitter type="directional" id="sun">
        <vector name="direction" x="0" y="0" z="-2"/>
        <spectrum name="irradiance" value="1000"/>
    </emitter>
    <emitter type="constant">
        <float name="radiance" value="0.5"/>
    </emitter>
    <sensor type="perspective" id="eye">
        <float name="fov" value="90"/>
        <string name="fov_axis" value="x"/>
        <float name="near_clip" value="0.1"/>
        <transform name="to_world">
            <lookat origin="0, -20, 0" target="0, 0, 0" up="0, 0, 1"/>
        </transform>
        <film type="hdrfilm">
            <integer name="width" value="$width"/>
            <integer name="height" value="4"/>
            <string name="pixel_format" value="rgb"/>
            <rfilter type="gaussian"/>
        </film>
    </sensor>
</scene>
"#;

fn everything() -> Scene {
    scene(EVERYTHING, FILE)
}

#[test]
fn a_colour_is_three_bands_and_without_one_there_are_none() {
    let bands: Vec<[f64; 2]> = everything().bands.iter().map(|band| [band.low, band.high]).collect();
    assert_eq!(bands, [[600.0, 700.0], [500.0, 600.0], [400.0, 500.0]]);
    assert_eq!(scene("<scene version=\"3.0.0\"/>", FILE).bands, []);
}

#[test]
fn materials_are_those_of_the_elements_and_what_has_none_is_black_if_it_emits_and_else_grey() {
    let scene = everything();
    let kind = |name: &str| {
        let surface = scene.surfaces.iter().find(|surface| surface.name == name).unwrap();
        (&scene.materials[surface.material].kind, surface.two_sided)
    };
    let diffuse = |reflectance: [f64; 3]| MaterialKind::Diffuse { reflectance: reflectance.to_vec() };
    assert_eq!(kind("floor"), (&diffuse([0.7, 0.6, 0.5]), true));
    assert_eq!(kind("lamp"), (&diffuse([0.0; 3]), false));
    assert_eq!(kind("part"), (&diffuse([0.5; 3]), false));
    assert_eq!(kind("lid").0, &MaterialKind::Mirror { reflectance: vec![1.0; 3] });
    assert_eq!(kind("block").0, &MaterialKind::Conductor { eta: vec![0.2, 0.4, 1.4], k: vec![2.0; 3] });
    assert!(matches!(kind("ball").0, MaterialKind::Dielectric { .. }));
}

fn vertices(scene: &Scene, name: &str) -> (Vec<Vector>, Vector) {
    let surface = scene.surfaces.iter().find(|surface| surface.name == name).unwrap();
    let polygon = surface.shape.as_polygon().unwrap();
    (polygon.vertices().to_vec(), polygon.normal())
}

fn volume(mesh: &Mesh) -> f64 {
    let pieces = mesh.polygons().flat_map(|polygon| polygon.convex_pieces().to_vec());
    let piece = |p: Vec<Vector>| (1..p.len() - 1).map(|i| p[0].dot(p[i].cross(p[i + 1])) / 6.0).sum::<f64>();
    pieces.map(piece).sum()
}

#[test]
fn shapes_are_moved_to_where_their_transform_puts_them() {
    let scene = everything();
    let (floor, up) = vertices(&scene, "floor");
    assert_eq!(
        (floor[0], floor[2], up),
        (Vector::new(-1.0, -1.0, 0.0), Vector::new(1.0, 1.0, 0.0), Vector::new(0.0, 0.0, 1.0))
    );
    let (lamp, down) = vertices(&scene, "lamp");
    assert!((lamp[0] - Vector::new(-2.0, 3.0, 10.0)).length() < 1e-14, "{lamp:?}");
    assert!((down - Vector::new(0.0, 0.0, -1.0)).length() < 1e-15, "{down:?}");
    let shape = |name: &str| &scene.surfaces.iter().find(|surface| surface.name == name).unwrap().shape;
    let Shape::Mesh(block) = shape("block") else { panic!("the block is a mesh") };
    assert_eq!((block.faces().len(), volume(block)), (6, 16.0));
    assert!(block.vertices().iter().all(|v| v.x == 4.0 || v.x == 6.0));
    let Shape::Sphere(ball) = shape("ball") else { panic!("the ball is a sphere") };
    assert_eq!(ball, &Sphere { center: Vector::new(2.0, 0.0, 4.0), radius: 1.0, inward: false });
    let Shape::Disk(lid) = shape("lid") else { panic!("the lid is a disk") };
    assert_eq!(
        (lid.center, lid.normal, lid.radius),
        (Vector::new(0.0, 9.0, 0.0), Vector::new(0.0, -1.0, 0.0), 1.0)
    );
    let Shape::Mesh(part) = shape("part") else { panic!("the part is a mesh") };
    assert!((volume(part) + 1.0 / 6.0).abs() < 1e-15, "its faces are turned");
}

/// Front of a shape with a transform: Mitsuba transforms the normal by the inverse transpose.
#[test]
fn a_reflection_keeps_the_front_of_a_rectangle_and_flip_normals_turns_it() {
    let front = |transform: &str, flip: &str| {
        let text = format!(
            "<scene version=\"3.0.0\"><shape type=\"rectangle\" id=\"r\"><transform name=\"to_world\">{transform}</transform>\
             <boolean name=\"flip_normals\" value=\"{flip}\"/></shape></scene>"
        );
        vertices(&scene(&text, FILE), "r").1.z
    };
    assert_eq!(front("<scale x=\"-1\"/>", "false"), 1.0);
    assert_eq!(front("<scale z=\"-1\"/>", "false"), -1.0);
    assert_eq!(front("<scale value=\"2\"/>", "true"), -1.0);
    assert_eq!(front("<matrix value=\"0 1 0 1 0 0 0 0 1\"/>", "false"), 1.0);
}

#[test]
fn transforms_are_done_in_the_order_of_their_elements() {
    let centre = |steps: &str| {
        let text = format!(
            "<scene version=\"3.0.0\"><emitter type=\"point\"><transform name=\"to_world\">{steps}</transform>\
             <float name=\"intensity\" value=\"1\"/></emitter></scene>"
        );
        match scene(&text, FILE).lights[0].kind {
            LightKind::Point { position, .. } => position,
            LightKind::Distant { .. } => panic!("the light is a point"),
        }
    };
    let (shift, turn) = ("<translate x=\"1\"/>", "<rotate value=\"0, 0, 3\" angle=\"90\"/>");
    assert!((centre(&format!("{shift}{turn}")) - Vector::new(0.0, 1.0, 0.0)).length() < 1e-15);
    assert_eq!(centre(&format!("{turn}{shift}")), Vector::new(1.0, 0.0, 0.0));
    assert_eq!(centre(&format!("{shift}<scale value=\"2, 3, 4\"/>")), Vector::new(2.0, 0.0, 0.0));
}

#[test]
fn emitters_are_lights_and_light_from_outside() {
    let scene = everything();
    let position = Vector::new(0.0, 1.0, 2.0);
    assert_eq!(scene.lights[0].kind, LightKind::Point { position, intensity: vec![3.0; 3] });
    let direction = Vector::new(0.0, 0.0, -1.0);
    assert_eq!(scene.lights[1].kind, LightKind::Distant { direction, irradiance: vec![1000.0; 3] });
    assert_eq!(scene.ambient.radiance, [0.5; 3]);
    assert_eq!(scene.surfaces[1].radiance, [18.0, 11.0, 3.0]);
}

#[test]
fn sensors_are_a_camera_and_the_irradiance_of_a_shape() {
    let scene = everything();
    assert_eq!(
        scene.receivers[0].kind,
        ReceiverKind::Surface { surface: 0, side: SurfaceSide::Front, grid: None }
    );
    let ReceiverKind::Camera(camera) = &scene.receivers[1].kind else { panic!("the eye is a camera") };
    assert_eq!((camera.origin, camera.resolution), (Vector::new(0.0, -20.0, 0.0), [8, 4]));
    // 90° from left to right; x is to the right and z upright.
    let corner = camera.direction(8.0, 0.0);
    assert!((corner - Vector::new(1.0, 1.0, 0.5)).length() < 1e-15, "{corner:?}");
}

#[test]
fn the_field_of_view_is_along_the_axis_that_is_named() {
    let cases = [("x", 2.0, 1.0), ("y", 4.0, 2.0), ("smaller", 4.0, 2.0), ("larger", 2.0, 1.0)];
    for (axis, right, up) in cases {
        let text =
            EVERYTHING.replace("fov_axis\" value=\"x\"", &format!("fov_axis\" value=\"{axis}\"")).replace(
                "\"fov\" value=\"90\"",
                &format!("\"fov\" value=\"{}\"", 2.0 * 2.0_f64.atan().to_degrees()),
            );
        let scene = scene(&text, FILE);
        let ReceiverKind::Camera(camera) = &scene.receivers[1].kind else { panic!("the eye is a camera") };
        let corner = camera.direction(8.0, 0.0);
        assert!((corner - Vector::new(right, 1.0, up)).length() < 1e-14, "{axis}: {corner:?}");
    }
}

#[test]
fn a_limit_of_depth_is_a_limit_of_interreflection() {
    const CAMERA: &str = "<sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/></sensor>";
    const METER: &str = "<shape type=\"rectangle\"><sensor type=\"irradiancemeter\"><film type=\"hdrfilm\">\
        <integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/></film></sensor></shape>";
    let text =
        |integrator: &str, sensors: &str| format!("<scene version=\"3.0.0\">{integrator}{sensors}</scene>");
    let forced = |integrator: &str, sensors: &str| {
        let scene = scene(&text(integrator, sensors), FILE);
        scene.solve.forced.iter().map(|forced| (forced.effect, forced.force)).collect::<Vec<_>>()
    };
    let path = |depth: i32| {
        format!("<integrator type=\"path\"><integer name=\"max_depth\" value=\"{depth}\"/></integrator>")
    };
    assert_eq!(forced(&path(-1), CAMERA), []);
    assert_eq!(forced(&path(2), CAMERA), [(Effect::Interreflection, Force::Off)]);
    assert_eq!(forced(&path(5), CAMERA), [(Effect::Interreflection, Force::Orders(3))]);
    assert_eq!(forced(&path(5), METER), [(Effect::Interreflection, Force::Orders(4))]);
    assert_eq!(forced("<integrator type=\"direct\"/>", CAMERA), [(Effect::Interreflection, Force::Off)]);
    // of a camera and a meter, or with mirrors or media, all events count
    let mirror = "<shape type=\"disk\"><bsdf type=\"conductor\"/></shape>";
    for sensors in [format!("{CAMERA}{METER}"), format!("{mirror}{CAMERA}")] {
        let scene = scene(&text(&path(5), &sensors), FILE);
        assert_eq!((scene.solve.forced.len(), scene.solve.events), (0, Some(4)));
    }
}

#[test]
fn a_scene_of_rectangles_is_seen_like_its_likeness_in_toml() {
    let scene = scene(
        r#"<scene version="3.0.0">
        <shape type="rectangle"><transform name="to_world"><scale value="5"/></transform></shape>
        <shape type="rectangle">
            <transform name="to_world"><rotate x="1" angle="180"/><translate z="2"/></transform>
            <emitter type="area"><spectrum name="radiance" value="3"/></emitter>
        </shape>
        <sensor type="perspective">
            <float name="fov" value="40"/>
            <transform name="to_world"><lookat origin="0, 0, 1" target="0, 0, 0" up="0, 1, 0"/></transform>
            <film type="hdrfilm"><integer name="width" value="9"/><integer name="height" value="9"/></film>
        </sensor>
    </scene>"#,
        FILE,
    );
    assert_eq!(not_simulated(&scene), []);
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", shown(&errors)));
    let found = simulate(&plan, &Unwatched);
    let [image] = &found.maps[..] else { panic!("a camera is asked for") };
    let values = || image.values.iter().flatten();
    let brightest = values().copied().fold(0.0, f64::max);
    assert!(brightest > 0.0 && values().all(|&value| value > 0.15 * brightest), "{image:?}");
}

#[test]
fn every_name_of_an_index_is_read() {
    for (name, n) in [("Water", 1.333), ("bk7", 1.5046), ("diamond", 2.419)] {
        let text = EVERYTHING.replace(
            "<float name=\"int_ior\" value=\"$n\"/>",
            &format!("<string name=\"int_ior\" value=\"{name}\"/>"),
        );
        let scene = read(&text, FILE).unwrap_or_else(|errors| panic!("{}", shown(&errors)));
        assert!(scene.media.iter().any(|medium| medium.index == [n; 3]), "{name}");
    }
}
