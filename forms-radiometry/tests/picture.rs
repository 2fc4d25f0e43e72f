//! The picture of the Cornell box: objects have the right places and colours, and the number of
//! threads does not matter.

use forms_radiometry::camera::Camera;
use forms_radiometry::scene::{self, ReceiverKind, Scene};
use forms_radiometry::{CORNELL_BOX, Picture, picture};

const SIDE: usize = 64;

fn small_box() -> (Scene, Camera) {
    let text = CORNELL_BOX.replace("[512, 512]", &format!("[{SIDE}, {SIDE}]"));
    let scene = scene::read(&text, "cornell_box.toml").unwrap();
    let cameras: Vec<Camera> = scene
        .receivers
        .iter()
        .filter_map(|receiver| match &receiver.kind {
            ReceiverKind::Camera(camera) => Some(camera.clone()),
            _ => None,
        })
        .collect();
    let [camera] = &cameras[..] else { panic!("the box has one camera") };
    (scene.clone(), camera.clone())
}

/// Returns the pixel at a fraction of the width and of the height.
fn at(picture: &Picture, x: f64, y: f64) -> [u8; 3] {
    let pixel = (y * SIDE as f64) as usize * SIDE + (x * SIDE as f64) as usize;
    [0, 1, 2].map(|component| picture.pixels()[3 * pixel + component])
}

#[test]
fn the_red_wall_is_on_the_left_the_green_on_the_right_and_the_lamp_white_in_a_black_ceiling() {
    let (scene, camera) = small_box();
    let picture = picture(&scene, &camera).unwrap();
    let [r, g, b] = at(&picture, 0.12, 0.3);
    assert!(r > 2 * g && r > 2 * b, "left: {r} {g} {b}");
    let [r, g, b] = at(&picture, 0.88, 0.3);
    assert!(g > 2 * r && g > b, "right: {r} {g} {b}");
    assert_eq!(at(&picture, 0.5, 0.145), [255, 255, 255], "lamp");
    assert_eq!(at(&picture, 0.5, 0.08), [0, 0, 0], "ceiling");
    let [r, g, b] = at(&picture, 0.5, 0.35);
    assert!(r > 150 && r.abs_diff(g) < 8 && g.abs_diff(b) < 8, "back wall: {r} {g} {b}");
    assert_eq!(at(&picture, 0.6, 0.8), [0, 0, 0], "the side of the short block that is turned from the lamp");
}

#[test]
fn the_picture_is_the_same_for_any_number_of_threads() {
    let (scene, camera) = small_box();
    let with_threads = |count| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap();
        pool.install(|| picture(&scene, &camera).unwrap())
    };
    let one = with_threads(1);
    for count in [2, 3, 7] {
        assert!(with_threads(count) == one, "{count} threads");
    }
}

#[test]
fn the_png_file_holds_the_pixels() {
    let (scene, camera) = small_box();
    let picture = picture(&scene, &camera).unwrap();
    let file = picture.png().unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width as usize, info.height as usize), (picture.width(), picture.height()));
    assert_eq!(pixels, picture.pixels());
}
