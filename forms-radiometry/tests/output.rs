//! Files of a simulation: the numbers read back from them equal the results.

use exr::prelude::{ReadChannels, ReadLayers};
use forms_radiometry::output::{csv, exr, png};
use forms_radiometry::scene::{self, Scene};
use forms_radiometry::simulation::{Answer, ErrorKind, ErrorParts, Layout, Map, Quantity, Simulation};
use std::collections::HashMap;
use std::io::Cursor;

const NAME: &str = "floor, \"left\"";

/// Returns a map of 3 columns and 2 rows, with the last cell outside the polygon.
fn map(bands: usize) -> Map {
    let values = |band: usize| {
        let cell = |cell: u32| 0.1 + f64::from(cell) / 3.0 + band as f64;
        (0..5).map(cell).chain([f64::NAN]).collect()
    };
    Map {
        receiver: NAME.to_owned(),
        quantity: Quantity::Irradiance,
        size: [3, 2],
        values: (0..bands).map(values).collect(),
        errors: vec![vec![1e-300, 2e-7, 0.0, 1e21, 0.5, f64::NAN]; bands],
        scales: vec![1.0; bands],
        kind: ErrorKind::Estimate,
        layout: Layout::Grid,
    }
}

fn simulation(bands: usize) -> Simulation {
    let answer = |(quantity, band)| Answer {
        receiver: NAME.to_owned(),
        quantity,
        band,
        bin: None,
        value: 1.0 / 3.0,
        error: 1e-17,
        parts: ErrorParts { rounding: 1e-17, ..ErrorParts::default() },
        kind: ErrorKind::Bound,
        seconds: 0.0,
    };
    let band = |band: usize| (bands > 1).then_some(band);
    let asked = [Quantity::Irradiance, Quantity::VectorIrradiance(2)];
    let answers = asked.into_iter().flat_map(|quantity| (0..bands).map(move |index| (quantity, band(index))));
    let answers = answers.map(answer).collect();
    Simulation {
        answers,
        maps: vec![map(bands)],
        history: Vec::new(),
        seconds: 0.0,
        stopped: false,
        brightest: 0.0,
    }
}

fn scene(bands: &str) -> Scene {
    let lamp = "[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5
        [[surface]]\nname = \"lamp\"\nmaterial = \"grey\"\nradiance = 1\n\
        polygon = [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]\n";
    scene::read(&format!("{bands}\n{lamp}"), "scene.toml").expect("a scene")
}

const COLOURS: &str = "bands = [[600, 700], [500, 600], [400, 500]]";

/// Returns the channels of a file, each with its pixels row by row from above, and the size.
fn channels(file: &[u8]) -> (HashMap<String, Vec<f32>>, [usize; 2]) {
    let read = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels();
    let image = read.first_valid_layer().all_attributes().from_buffered(Cursor::new(file)).expect("OpenEXR");
    let layer = image.layer_data;
    let (width, height) = layer.size.into();
    let list = layer.channel_data.list;
    let values =
        list.iter().map(|channel| (channel.name.to_string(), channel.sample_data.values_as_f32().collect()));
    (values.collect(), [width, height])
}

fn same(a: f32, b: f32) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// Returns the lines below the header.
fn lines(simulation: &Simulation) -> Vec<Vec<String>> {
    let mut file = Vec::new();
    csv(simulation, &mut file).expect("memory takes all");
    let mut reader = ::csv::Reader::from_reader(file.as_slice());
    assert_eq!(*reader.headers().expect("a header"), HEADER[..]);
    reader.records().map(|line| line.expect("a line").iter().map(str::to_owned).collect()).collect()
}

const HEADER: [&str; 9] = ["receiver", "quantity", "band", "bin", "i", "j", "value", "error", "kind"];

#[test]
fn the_table_has_every_answer_and_every_cell_with_numbers_that_read_back_the_same() {
    for bands in [1, 3] {
        let simulation = simulation(bands);
        let lines = lines(&simulation);
        assert_eq!(lines.len(), (2 + 6) * bands);
        let number = |text: &str| text.parse::<f64>().expect("a number");
        for (line, answer) in lines.iter().zip(&simulation.answers) {
            let band = answer.band.map_or(String::new(), |band| band.to_string());
            assert_eq!(line[..6], [NAME, answer.quantity.name(), &band, "", "", ""]);
            assert_eq!([number(&line[6]), number(&line[7])], [answer.value, answer.error]);
            assert_eq!(&line[8], "bound");
        }
        let map = &simulation.maps[0];
        for line in &lines[2 * bands..] {
            assert_eq!(&line[8], "estimate");
            let band = if bands == 1 { 0 } else { line[2].parse().expect("a band") };
            let cell =
                line[5].parse::<usize>().expect("a row") * 3 + line[4].parse::<usize>().expect("a column");
            for (text, expected) in [(&line[6], map.values[band][cell]), (&line[7], map.errors[band][cell])] {
                assert!(number(text) == expected || (text == "NaN" && expected.is_nan()), "{line:?}");
            }
        }
        assert_eq!(lines[0][2].is_empty(), bands == 1);
        assert_eq!(lines[2 * bands + 4][4..6], ["1", "1"], "the fifth cell is in column 1 and row 1");
    }
}

#[test]
fn a_pixel_of_the_linear_picture_is_the_cell_in_f32_and_the_last_row_is_above() {
    let map = map(1);
    let (channels, size) = channels(&exr(&map, &scene("")).expect("a file"));
    assert_eq!((size, channels.len()), ([3, 2], 1));
    for (pixel, &found) in channels["Y"].iter().enumerate() {
        let (i, j) = (pixel % 3, 1 - pixel / 3);
        assert!(same(found, map.values[0][3 * j + i] as f32), "{pixel}: {found}");
    }
}

#[test]
fn the_linear_picture_says_its_unit_in_utf_8() {
    let file = exr(&map(1), &scene("")).expect("a file");
    let unit = "irradiance in W/m²".as_bytes();
    assert!(file.windows(unit.len()).any(|bytes| bytes == unit));
}

#[test]
fn several_bands_are_channels_beside_their_colour() {
    let map = map(3);
    let (channels, _) = channels(&exr(&map, &scene(COLOURS)).expect("a file"));
    let mut names: Vec<&str> = channels.keys().map(String::as_str).collect();
    names.sort_unstable();
    assert_eq!(names, ["B", "G", "R", "band0", "band1", "band2"]);
    for band in 0..3 {
        assert!(same(channels[&format!("band{band}")][0], map.values[band][3] as f32));
    }
}

#[test]
fn light_as_the_lamps_send_it_is_white_in_the_linear_picture() {
    let white = Map { values: vec![vec![0.7; 6]; 3], ..map(3) };
    let (channels, _) = channels(&exr(&white, &scene(COLOURS)).expect("a file"));
    let [r, g, b] = ["R", "G", "B"].map(|name| channels[name][0]);
    assert!(g > 0.0 && (r / g - 1.0).abs() < 1e-3 && (b / g - 1.0).abs() < 1e-3, "{r} {g} {b}");
}

#[test]
fn bands_that_nobody_sees_are_shown_by_their_sum() {
    let map = map(2);
    let (channels, _) = channels(&exr(&map, &scene("bands = [[1000, 2000], [2000, 3000]]")).expect("a file"));
    assert_eq!(channels.len(), 3);
    assert!(same(channels["Y"][0], (map.values[0][3] + map.values[1][3]) as f32));
}

/// Returns the colours of a picture, the number of pixels along each side, and its description.
fn picture(file: &[u8]) -> (Vec<[u8; 4]>, [usize; 2], String) {
    let mut reader = ::png::Decoder::new(Cursor::new(file)).read_info().expect("PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let frame = reader.next_frame(&mut pixels).expect("pixels");
    let text = reader.info().utf8_text[0].get_text().expect("text");
    let colours = pixels.as_chunks::<4>().0.to_vec();
    (colours, [frame.width as usize, frame.height as usize], text)
}

#[test]
fn a_cell_is_a_square_of_one_colour_the_brightest_the_greatest_and_none_where_there_is_no_polygon() {
    let (pixels, [width, height], text) = picture(&png(&map(2)).expect("a file"));
    assert_eq!([width, height], [258, 172]);
    let at = |x: usize, y: usize| pixels[y * width + x];
    for (pixel, &colour) in pixels.iter().enumerate() {
        let (x, y) = (pixel % width, pixel / width);
        assert_eq!(colour, at(x / 86 * 86, y / 86 * 86));
    }
    assert_eq!(at(2 * 86, 0), [0; 4], "outside of the polygon");
    let brightest = colorous::VIRIDIS.eval_continuous(1.0);
    assert_eq!(at(86, 0), [brightest.r, brightest.g, brightest.b, 255]);
    let greatest = map(2).values.iter().map(|band| band[4]).sum::<f64>();
    assert!((greatest - 3.866_666_7).abs() < 1e-7);
    assert_eq!(
        text,
        format!("irradiance of {NAME}, sum of all bands, from 0 (dark) to 3.8666667 W/m² (bright)")
    );
}
