//! Names that mean something else in a language.

use super::target::Target;

/// Keywords of C and of C++, and what `math.h` and `stdlib.h` declare that could be the name of a quantity.
const C: &str = "alignas alignof and and_eq asm auto bitand bitor bool break case catch char class compl complex const \
    constexpr const_cast continue decltype default delete do double dynamic_cast else enum explicit export extern false \
    float for friend goto if imaginary inline int long main mutable namespace new noexcept not not_eq nullptr operator or \
    or_eq outputs private protected public register reinterpret_cast restrict return short signed sizeof static \
    static_assert static_cast struct switch template this thread_local throw true try typedef typeid typename union \
    unsigned using virtual void volatile wchar_t while xor xor_eq abs acos acosh asin asinh atan atan2 atanh cbrt ceil \
    copysign cos cosh erf erfc exp exp2 expm1 fabs fdim floor fma fmax fmin fmod frexp gamma hypot ilogb j0 j1 jn ldexp \
    lgamma log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter nexttoward pow remainder remquo rint round \
    scalb scalbln scalbn signgam sin sinh sqrt tan tanh tgamma trunc y0 y1 yn NAN INFINITY";

/// Keywords and reserved words of WGSL, and its predeclared types and functions.
const WGSL: &str = "abs acos acosh alias all any array asin asinh atan atan2 atanh atomic attribute auto await become \
    bitcast bool break case cast catch ceil clamp class common concept const const_assert continue continuing coord cos \
    cosh countOneBits cross default degrees delegate delete demote determinant diagnostic discard distance do dot else enable \
    enum exp exp2 export extends extern external f16 f32 faceForward false final floor fma fn for fract frexp friend from \
    fwidth get goto groupshared highp i32 if impl implements import inline instanceof interface inverseSqrt layout ldexp \
    length let log log2 loop lowp mat2x2 mat3x3 mat4x4 max mediump meta min mix mod module modf move mut mutable namespace \
    new nil noexcept noinline nointerpolation normalize null nullptr of operator override package packoffset partition pass \
    patch pixelfragment pow precise precision premerge priv private protected ptr pub public quantize radians readonly ref \
    reflect refract regardless register reinterpret requires resource restrict return round sampler saturate select self set \
    shared sign sin sinh smooth smoothstep snorm sqrt static std step struct subroutine super switch tan tanh target template \
    texture this throw trait transpose true trunc try type typedef typename u32 union unless unorm unsafe use using var vec2 \
    vec3 vec4 virtual volatile wgsl where while with writeonly yield";

fn taken(target: Target) -> &'static str {
    match target {
        Target::Rust => "",
        Target::C | Target::Cuda => C,
        Target::Wgsl => WGSL,
    }
}

/// Whether a name means something else in the target.
pub(super) fn is_taken(target: Target, name: &str) -> bool {
    let is_helper = target != Target::Rust && name.starts_with("forms_");
    is_helper || taken(target).split_whitespace().any(|word| word == name)
}

/// Names of arguments in the target: those that are taken get underscores behind them, and none occurs twice.
pub(super) fn arguments(target: Target, names: &[String]) -> Vec<String> {
    let mut chosen: Vec<String> = Vec::with_capacity(names.len());
    for name in names {
        let mut free = name.clone();
        while is_taken(target, &free) || (free != *name && names.contains(&free)) || chosen.contains(&free) {
            free.push('_');
        }
        chosen.push(free);
    }
    chosen
}
