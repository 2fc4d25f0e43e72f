//! Radiosity: the diffuse faces of a scene are divided into elements, light transport between
//! elements becomes a matrix of form factors, and the solution of the linear system is the
//! irradiance everywhere, from which any receiver gathers.
//!
//! ```text
//! faces ─▶ elements, nodes ─▶ form factors node × element (weights) ─▶ E = D + G E ─▶ gathering
//!             ▲                                                             │
//!             └─ refinement: elements that change answers most are split ◀──┘
//! ```
//! E(x) = D(x) + ∫ ρ(y)/π E(y) cos cos'/r² V dA(y), with D the direct irradiance from lights. E is
//! a polynomial on each element, given at its Gauss points. Between these points the equation
//! itself interpolates (Nyström method), and visibility is exact. The solution is that of the
//! continuous equation, not one constant for each surface. The cost of a solution is that of pairs
//! of elements: the plan compares it with that of path tracing ([`expected_cost`]).

mod brightest;
mod checks;
mod closed_form;
mod coarsest_elements;
mod contact;
mod convergence;
mod cost;
mod direct;
mod directions;
mod doubts;
pub(crate) mod driver;
mod element;
mod emission;
mod first_faces;
mod gathered_light;
mod importance;
mod kept;
mod kernels;
mod measure;
mod operator;
mod partial;
mod patch_rule;
mod point_lights;
mod question;
mod received;
mod reference;
mod refinement;
mod reflectance;
mod residual;
mod round;
mod shadows;
mod shells;
mod solution;
mod system;
#[cfg(test)]
mod tests;
mod transmitted;
mod transport;
mod view;
mod weights;
mod whole_elements;

pub(crate) use brightest::{most_direct, most_reflected};
pub(crate) use closed_form::{Straight, is_precise};
pub(crate) use cost::expected_cost;
pub(crate) use direct::Lights;
pub(crate) use first_faces::FirstFaces;
pub(crate) use importance::{Goal, GoalKind};
pub(crate) use kernels::kernels;
pub(crate) use measure::Measure;
pub(crate) use question::{Question, ReceivingAreas};
pub(crate) use refinement::{Asking, Refined};
pub(crate) use reflectance::{is_reflecting, reflectance};
pub(crate) use round::bulges;
pub(crate) use shells::Shells;
pub(crate) use solution::orders;
pub(crate) use system::Radiosity;
pub(crate) use transmitted::{Reached, Transmitted, has_exact_pieces};
pub(crate) use transport::{Group, Scratch, Transport};
pub(crate) use view::{Reflected, SeenPiece};
