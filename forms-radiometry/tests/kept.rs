//! Checkpoints of path tracing: work that is stopped and continued, or divided into shards, gives
//! the same bits as work in one piece.

use forms_radiometry::scene::{Overrides, Scene, Sources};
use forms_radiometry::simulation::{
    Budget, ErrorKind, Identity, Job, Keeper, Map, Misfit, Plan, Share, Simulation, Snapshot, State,
    StateFile, Unwatched, Watch, merge, plan, simulate, simulate_job,
};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};

use forms_testing::scene_text::{material, point_receiver, polygon, surface, tolerance};

const TOLERANCE: f64 = 0.1;

/// Returns a lamp in front of a mirror, above a floor with a map, and a ray that is answered
/// without samples.
fn hall(bands: &str) -> Scene {
    let mirror = "[[material]]\nname = \"silver\"\nkind = \"mirror\"\nreflectance = 0.9\n";
    let floor = polygon(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    let wall = polygon(&[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]]);
    let lamp = polygon(&[[0.5, 0.0, 1.0], [0.5, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
    let text = [
        bands.to_owned(),
        material("grey", 0.5),
        mirror.to_owned(),
        surface("floor", "grey", &floor),
        surface("wall", "silver", &wall),
        material("black", 0.0),
        surface("lamp", "black", &format!("{lamp}\nradiance = 1")),
        point_receiver("here", [1.0, 0.5, 0.1], [0.0, 0.0, 1.0]),
        // the image of the lamp, which needs no samples
        "[[receiver]]\nname = \"sight\"\nkind = \"ray\"\norigin = [1, 0.5, 0.5]\ndirection = [-1, 0, 0.3]\n"
            .to_owned(),
        "[[receiver]]\nname = \"map\"\nkind = \"surface\"\nsurface = \"floor\"\ngrid = [4, 2]\n".to_owned(),
        tolerance(TOLERANCE),
    ];
    forms_radiometry::scene::read(&text.concat(), "hall.toml")
        .unwrap_or_else(|errors| panic!("{}", errors[0]))
}

/// Returns a lamp in smoke above a black floor. A point and the cells of a map are answered without
/// samples, and the mean of the map is not.
fn smoke() -> Scene {
    let floor = polygon(&[[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    let lamp = polygon(&[[0.5, 0.0, 1.0], [0.5, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
    let text = [
        "[[medium]]\nname = \"smoke\"\nsigma_a = 0.5\n[ambient]\nmedium = \"smoke\"\n".to_owned(),
        material("black", 0.0),
        surface("floor", "black", &floor),
        surface("lamp", "black", &format!("{lamp}\nradiance = 1")),
        point_receiver("here", [1.0, 0.5, 0.1], [0.0, 0.0, 1.0]),
        "[[receiver]]\nname = \"map\"\nkind = \"surface\"\nsurface = \"floor\"\ngrid = [4, 2]\n".to_owned(),
        tolerance(TOLERANCE),
    ];
    forms_radiometry::scene::read(&text.concat(), "smoke.toml")
        .unwrap_or_else(|errors| panic!("{}", errors[0]))
}

/// Observer that stops the work after this many queries.
struct Patience(AtomicU32);

impl Watch for Patience {
    fn progress(&self, _stage: &str, _fraction: f64) {}

    fn is_stopped(&self) -> bool {
        let before = self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1));
        before.is_err()
    }
}

/// Keeper that keeps the last state, and requests one all the time.
#[derive(Default)]
struct Memory(Mutex<Vec<u8>>);

impl Keeper for Memory {
    fn is_due(&self) -> bool {
        true
    }

    fn keep(&self, snapshot: &Snapshot<'_>) {
        let mut bytes = Vec::new();
        StateFile::Checkpoint.write(&(), snapshot, &mut bytes).expect("memory can be written");
        *self.0.lock().expect("nobody panicked") = bytes;
    }
}

impl Memory {
    fn state(&self) -> State {
        StateFile::Checkpoint.read::<()>(&self.0.lock().expect("nobody panicked")).expect("a state").1
    }
}

/// Returns the bits of all numbers.
fn bits(found: &Simulation) -> Vec<u64> {
    let of_map =
        |map: &Map| -> Vec<f64> { map.values.iter().chain(&map.errors).flatten().copied().collect() };
    let answers = found.answers.iter().flat_map(|answer| [answer.value, answer.error]);
    answers.chain(found.maps.iter().flat_map(of_map)).map(f64::to_bits).collect()
}

fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads").install(work)
}

/// Runs a shard, with or without a budget. The work is stopped again and again, each time after
/// more queries.
fn resumed(plan: &Plan, budget: Option<Budget>, share: Share) -> (Simulation, State, usize) {
    let mut state: Option<State> = None;
    for stops in 0.. {
        let (memory, patience) = (Memory::default(), Patience(AtomicU32::new(2 + 3 * stops)));
        let job = Job { budget, share, state: state.take(), keeper: Some(&memory) };
        let found = on_threads(1 + stops as usize % 2, || simulate_job(plan, job, &patience));
        let found = found.expect("the state is of this work");
        if !found.stopped {
            return (found, memory.state(), stops as usize);
        }
        state = Some(memory.state());
    }
    unreachable!("patience grows without end")
}

#[test]
fn work_that_is_stopped_again_and_again_comes_to_the_same_bits() {
    for bands in ["", "bands = [[400, 500], [500, 600]]\n"] {
        let scene = hall(bands);
        let plan = plan(&scene).expect("a plan");
        assert!(plan.is_by_paths());
        let whole = on_threads(2, || simulate(&plan, &Unwatched));
        assert_eq!(bits(&on_threads(1, || simulate(&plan, &Unwatched))), bits(&whole));
        let (found, state, stops) = resumed(&plan, None, Share::WHOLE);
        assert!(stops > 2 && state.is_done(), "{stops}");
        assert_eq!(bits(&found), bits(&whole), "{bands}");
    }
}

#[test]
fn shares_that_were_stopped_come_to_the_bits_of_one_run() {
    assert_shares_are_one_run(&hall(""));
    assert_shares_are_one_run(&smoke());
}

fn assert_shares_are_one_run(scene: &Scene) {
    let plan = plan(scene).expect("a plan");
    for (count, samples) in [(3, None), (7, None), (3, Some(512)), (7, Some(512))] {
        let budget = samples.map(|samples| Budget::new(samples).expect("a number of samples"));
        let job = Job { budget, ..Job::default() };
        let whole = simulate_job(&plan, job, &Unwatched).expect("there is no state");
        let shares = format!("1/{count}").parse::<Share>().expect("a share").all();
        let parts = shares.map(|share| (share, resumed(&plan, budget, share).1)).collect();
        let merged = merge(&plan, budget, parts).expect("all shares");
        assert_eq!(bits(&merged), bits(&whole), "{count} shares, {samples:?}");
        let kinds = |found: &Simulation| found.answers.iter().map(|answer| answer.kind).collect::<Vec<_>>();
        assert_eq!(kinds(&merged), kinds(&whole));
        assert!(
            kinds(&whole).iter().any(|kind| *kind != ErrorKind::Sigma)
                && kinds(&whole).contains(&ErrorKind::Sigma)
        );
    }
}

#[test]
fn cells_are_as_exact_as_the_largest_of_them_asks_for() {
    let scene = hall("");
    let found = simulate(&plan(&scene).expect("a plan"), &Unwatched);
    let map = &found.maps[0];
    let largest = map.values[0].iter().copied().fold(0.0, f64::max);
    assert!(map.errors[0].iter().all(|&error| error <= TOLERANCE * largest), "{map:?}");
}

#[test]
fn a_state_of_another_scene_is_refused() {
    let (scene, other) = (hall(""), hall("bands = [[400, 500], [500, 600]]\n"));
    let [here, there] = [&scene, &other].map(|scene| plan(scene).expect("a plan"));
    let (_, state, _) = resumed(&here, None, Share::WHOLE);
    let mut other = other;
    other.materials[0].kind = forms_radiometry::scene::MaterialKind::Diffuse { reflectance: vec![0.5, 0.25] };
    let there = plan(&other).unwrap_or(there);
    let job = Job { state: Some(state.clone()), ..Job::default() };
    assert_eq!(simulate_job(&there, job, &Unwatched).err(), Some(Misfit));
    assert_eq!(merge(&here, None, vec![("1/2".parse().expect("a share"), state)]).err(), Some(Misfit));
}

#[test]
fn every_changed_byte_of_a_file_is_found() {
    let scene = hall("");
    let planned = plan(&scene).expect("a plan");
    let memory = Memory::default();
    let budget = Budget::new(32).ok();
    let job = Job { budget, keeper: Some(&memory), ..Job::default() };
    simulate_job(&planned, job, &Unwatched).expect("there is no state");
    let bytes = memory.0.into_inner().expect("nobody panicked");
    assert!(StateFile::Checkpoint.read::<()>(&bytes).is_ok() && StateFile::Part.read::<()>(&bytes).is_err());
    for place in (0..bytes.len()).step_by(bytes.len() / 200 + 1).chain(bytes.len() - 40..bytes.len()) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 1 << (place % 8);
        assert!(StateFile::Checkpoint.read::<()>(&damaged).is_err(), "byte {place}");
        assert!(StateFile::Checkpoint.read::<()>(&bytes[..place]).is_err(), "{place} bytes");
    }
}

#[test]
fn work_is_told_from_other_work() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let open = |name: &str, text: &str| {
        let path = folder.join(format!("kept-{}-{name}.toml", std::process::id()));
        std::fs::write(&path, text).expect("a file");
        let opened = Sources::open(&path).unwrap_or_else(|errors| panic!("{}", errors[0]));
        std::fs::remove_file(path).expect("a file");
        opened
    };
    let text = |rho: f64| {
        let floor = polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
        material("grey", rho) + &surface("floor", "grey", &floor)
    };
    let (scene, sources) = open("one", &text(0.5));
    let planned = plan(&scene).expect("a plan");
    let share: Share = "2/3".parse().expect("a share");
    let identity = |sources: &Sources| Identity::new(sources, &planned, None, share);
    let with = |overrides: Overrides| {
        let mut scene = scene.clone();
        overrides.apply(&mut scene);
        let planned = plan(&scene).expect("a plan");
        Identity::new(&sources, &planned, None, share)
    };
    let one = identity(&sources);
    assert_eq!(one.difference(&identity(&open("two", &text(0.5)).1)), None);
    // options that repeat the settings of the scene change nothing
    let same = Overrides { tolerance: Some(1e-3), seed: Some(1), effects: None };
    assert_eq!(one.difference(&with(same)), None);
    let others = [
        identity(&open("three", &text(0.6)).1),
        Identity::new(&sources, &planned, Budget::new(64).ok(), share),
        Identity::new(&sources, &planned, None, Share::WHOLE),
        with(Overrides { tolerance: Some(0.01), ..Overrides::default() }),
        with(Overrides { seed: Some(7), ..Overrides::default() }),
        with(Overrides { effects: "interreflection=2".parse().ok(), ..Overrides::default() }),
    ];
    let told = [
        "another scene",
        "64 samples",
        "shard 1/1, not 2/3",
        "tolerance 0.01, not 0.001",
        "seed 7, not 1",
        "other effects",
    ];
    for (other, part) in others.iter().zip(told) {
        assert!(one.difference(other).is_some_and(|told| told.contains(part)), "{part}");
    }
}

#[test]
fn shares_may_be_counted_from_zero() {
    let share = |text: &str| text.parse::<Share>();
    let from_zero: Vec<_> = ["1/3", "2/3", "0/3"].map(share).into_iter().collect();
    assert_eq!(from_zero, ["1/3", "2/3", "3/3"].map(share));
    assert!(share("4/3").is_err() && share("0/0").is_err() && share("-1/3").is_err());
}
