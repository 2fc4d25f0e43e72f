//! Program without the standard library. Its exit code is the number of the first check that fails,
//! or 0.

#![no_std]
#![no_main]

extern crate alloc;

use alloc::format;
use core::alloc::{GlobalAlloc, Layout};
use core::f64::consts::{E, PI};
use core::panic::PanicInfo;

use forms_math::{
    DoubleDouble, Formula, NotWithin, Real, Tier, Wide, batch, batch_within, escalate, escalate_checked,
    escalate_with_tier, without_escalation,
};

#[link(name = "c")]
unsafe extern "C" {
    fn aligned_alloc(align: usize, size: usize) -> *mut u8;
    fn free(memory: *mut u8);
    fn abort() -> !;
}

/// Memory of the C library.
struct Memory;

unsafe impl GlobalAlloc for Memory {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let align = layout.align().max(16);
        // SAFETY: the size is a multiple of the alignment, which is a power of two.
        unsafe { aligned_alloc(align, layout.size().next_multiple_of(align)) }
    }
    unsafe fn dealloc(&self, memory: *mut u8, _: Layout) {
        // SAFETY: the memory was allocated by `alloc`.
        unsafe { free(memory) }
    }
}

#[global_allocator]
static MEMORY: Memory = Memory;

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: the function has no conditions.
    unsafe { abort() }
}

/// The compiled `core` and `alloc` unwind and name these functions; nothing calls them, since panics
/// abort.
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}
#[unsafe(no_mangle)]
extern "C" fn _Unwind_Resume() {}

/// √(1 + x) − 1
struct Excess;

impl Formula<1, 1> for Excess {
    fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
        let one = T::from_f64(1.0);
        [(one + x).sqrt() - one]
    }
}

/// (1 − cos x)/x², and the angle of the point (x, erf x).
struct Versine;

impl Formula<1, 2> for Versine {
    fn value<T: Real>([x]: [T; 1]) -> [T; 2] {
        [(T::from_f64(1.0) - x.cos()) / (x * x), x.erf().atan2(x)]
    }
}

/// ∫₀¹ eˣᵗ dt − (eˣ − 1)/x = 0
struct Integral;

impl Formula<1, 1> for Integral {
    fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
        let [zero, one] = [0.0, 1.0].map(T::from_f64);
        [T::quadrature(zero, one, |t| (x * t).exp()) - x.exp_m1() / x]
    }
}

/// 1 below √2 · √2, 2 from there on.
struct Step;

impl Formula<1, 1> for Step {
    fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
        let [one, two] = [1.0, 2.0].map(T::from_f64);
        [T::if_less(x, two.sqrt() * two.sqrt(), one, two)]
    }
}

fn is_near(value: f64, exact: f64) -> bool {
    (value - exact).abs() <= 4.0 * f64::EPSILON * exact.abs()
}

fn numbers() -> [bool; 6] {
    let wide = Wide::<4>::from_f64(1.0).atan2(Wide::from_f64(0.0)) * Wide::from_f64(2.0);
    let double_double = DoubleDouble::from_f64(1.0).exp();
    [
        is_near(1.0_f64.exp(), E),
        is_near(0.5_f64.asin(), PI / 6.0),
        (2.0_f32.power(1, 2) - 2.0_f32.sqrt()).abs() < 1e-6,
        is_near(1.0_f64.dilog(), PI * PI / 6.0),
        format!("{wide}").starts_with("3.14159265358979323846264338327950288"),
        (double_double.high(), double_double.low()) == (E, 1.445_646_891_729_250_2e-16),
    ]
}

fn promises() -> [bool; 6] {
    let tiers = escalate_with_tier::<Versine, 1, 2>([1e-300], 1.0);
    [
        escalate::<Excess, 1, 1>([1e-30], 1.0) == [5e-31],
        without_escalation::<Excess, 1, 1>([1e-9], 2.0)[0].is_nan(),
        tiers[0].0 == 0.5 && matches!(tiers[0].1, Tier::Words(words) if words > 16),
        is_near(tiers[1].0, 0.8456429810219763),
        escalate_checked::<Step, 1, 1>([2.0], 1.0) == Err(NotWithin { output: 0, within: 1.0 }),
        // The widest numbers of an integral decide nothing about a difference that vanishes.
        escalate_with_tier::<Integral, 1, 1>([0.75], 1.0)[0].1 == Tier::Undecided,
    ]
}

fn batches() -> [bool; 2] {
    let column = [1e-9, 0.25, 3.0, 1e300];
    let (mut plain, mut promised) = ([0.0; 4], [0.0; 4]);
    let lengths_agree = batch::<Excess, 1, 1>([&column], [&mut plain]).is_ok()
        && batch_within::<Excess, 1, 1>([&column], [&mut promised], 2.0).is_ok();
    [
        lengths_agree && plain[2] == 1.0 && !is_near(plain[0], 4.999_999_998_75e-10),
        promised[2] == 1.0 && is_near(promised[0], 4.999_999_998_75e-10) && is_near(promised[3], 1e150),
    ]
}

/// Entry point of the C library.
#[unsafe(no_mangle)]
extern "C" fn main() -> i32 {
    let checks = numbers().into_iter().chain(promises()).chain(batches());
    checks.zip(1..).find(|(holds, _)| !holds).map_or(0, |(_, number)| number)
}
