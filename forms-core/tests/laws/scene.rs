//! Subject of a law: a patch with a few random forms, fields and maps on it.

use super::coefficients::{Recipe, gentle, linear, recipe};
use forms_core::calculus::{Blade, Coefficients, Coordinate, Field, Form, Structured};
use forms_core::expression::{Expr, FunctionId, Pool, Symbol, SymbolKind};
use proptest::prelude::*;

/// Pool with coordinates and two unknown functions of them.
pub(crate) struct World {
    pub(crate) pool: Pool,
    pub(crate) symbols: Vec<Symbol>,
    pub(crate) functions: [FunctionId; 2],
}

impl World {
    pub(crate) fn new(dimension: u8) -> Self {
        let mut pool = Pool::new();
        let symbols: Vec<Symbol> =
            (0..dimension).map(|i| pool.declare_symbol(format!("x{i}"), SymbolKind::Coordinate)).collect();
        let functions = ["f", "g"].map(|name| pool.declare_function(name, symbols.clone()));
        World { pool, symbols, functions }
    }

    pub(crate) fn coordinates(&self) -> Vec<Coordinate> {
        (0..self.symbols.len() as u8).map(Coordinate).collect()
    }

    /// Returns the coordinate with this number, modulo the number of coordinates.
    pub(crate) fn variable(&mut self, number: u8) -> Expr {
        let symbol = self.symbols[number as usize % self.symbols.len()];
        self.pool.symbol(symbol)
    }

    pub(crate) fn unknown(&mut self, first: bool) -> Expr {
        let arguments: Vec<Expr> = self.symbols.iter().map(|&symbol| self.pool.symbol(symbol)).collect();
        let orders = vec![0; arguments.len()];
        self.pool.jet(self.functions[usize::from(!first)], &orders, &arguments)
    }

    pub(crate) fn ring(&mut self) -> Structured<'_> {
        Structured { pool: &mut self.pool, coordinates: &self.symbols }
    }
}

/// Two forms of any degrees, a 1-form, a function and three fields.
#[derive(Clone, Debug)]
pub(crate) struct Scene<S> {
    pub(crate) coordinates: Vec<Coordinate>,
    pub(crate) a: Form<S>,
    pub(crate) b: Form<S>,
    pub(crate) c: Form<S>,
    pub(crate) fields: [Field<S>; 3],
}

/// Basis forms or directions, each with its coefficient.
type Parts = Vec<(u8, Recipe)>;

/// Scene as drawn, before its coefficients are built.
#[derive(Clone, Debug)]
pub(crate) struct Draft {
    pub(crate) dimension: u8,
    degrees: [u32; 2],
    forms: [Parts; 3],
    fields: [Parts; 3],
    /// Two maps of the patch to itself, the second linear.
    maps: [Vec<Recipe>; 2],
}

fn parts(most: usize) -> impl Strategy<Value = Parts> {
    prop::collection::vec((any::<u8>(), recipe()), 1..=most)
}

pub(crate) fn draft() -> impl Strategy<Value = Draft> {
    let maps = [prop::collection::vec(gentle().boxed(), 4), prop::collection::vec(linear().boxed(), 4)];
    let forms = [parts(2), parts(2), parts(2)];
    let fields = [parts(2), parts(2), parts(1)];
    (2..=4u8, [0..=2u32, 1..=2u32], forms, fields, maps).prop_map(
        |(dimension, degrees, forms, fields, maps)| Draft { dimension, degrees, forms, fields, maps },
    )
}

/// Returns all basis forms of a degree.
pub(crate) fn blades(coordinates: &[Coordinate], degree: u32) -> Vec<Blade> {
    let mut all = vec![Blade::SCALAR];
    for &coordinate in coordinates {
        let raised: Vec<Blade> = all
            .iter()
            .filter_map(|blade| blade.wedge(Blade::of(coordinate)))
            .map(|(blade, _)| blade)
            .collect();
        all.extend(raised);
    }
    all.retain(|blade| blade.degree() == degree);
    all
}

impl Draft {
    pub(crate) fn world(&self) -> World {
        World::new(self.dimension)
    }

    pub(crate) fn scene(&self, world: &mut World) -> Scene<Expr> {
        let coordinates = world.coordinates();
        let [a, b] = self.degrees;
        let form = |world: &mut World, parts: &Parts, degree: u32| {
            let blades = blades(&coordinates, degree);
            let mut terms: Vec<(Blade, Expr)> = Vec::new();
            for (number, recipe) in parts {
                let value = world.build(recipe);
                if !world.pool.is_zero(value) {
                    terms.push((blades[*number as usize % blades.len()], value));
                }
            }
            Form::from_terms(degree, terms)
        };
        let [for_a, for_b, for_c] = &self.forms;
        let (a, b, c) = (form(world, for_a, a), form(world, for_b, b), form(world, for_c, 1));
        let fields = [0, 1, 2].map(|place| self.field(world, &self.fields[place]));
        Scene { coordinates: world.coordinates(), a, b, c, fields }
    }

    fn field(&self, world: &mut World, parts: &Parts) -> Field<Expr> {
        let mut field = Field::zero();
        for (number, recipe) in parts {
            let value = world.build(recipe);
            let mut ring = world.ring();
            let part = Field::along(&ring, Coordinate(number % self.dimension), value);
            field = field.add(&mut ring, &part);
        }
        field
    }

    /// Returns the components of the two maps.
    pub(crate) fn maps(&self, world: &mut World) -> [Vec<Expr>; 2] {
        [0, 1].map(|place| {
            self.maps[place].iter().take(self.dimension as usize).map(|recipe| world.build(recipe)).collect()
        })
    }
}

impl<S: Clone> Scene<S> {
    /// Returns every coefficient of the scene.
    pub(crate) fn scalars(&self) -> Vec<S> {
        let of_forms =
            [&self.a, &self.b, &self.c].into_iter().flat_map(|form| form.terms().iter().map(|t| t.1.clone()));
        let of_fields = self.fields.iter().flat_map(|field| field.components().map(|c| c.1.clone()));
        of_forms.chain(of_fields).collect()
    }

    /// Returns the scene over another ring, with its coefficients in the order of
    /// [`Scene::scalars`].
    pub(crate) fn over<T: Clone>(
        &self,
        ring: &mut impl Coefficients<Scalar = T>,
        scalars: Vec<T>,
    ) -> Scene<T> {
        let mut next = scalars.into_iter();
        let mut form = |form: &Form<S>| {
            let terms: Vec<(Blade, T)> =
                form.terms().iter().map(|(blade, _)| (*blade, next.next().unwrap())).collect();
            Form::from_terms(form.degree(), terms)
        };
        let (a, b, c) = (form(&self.a), form(&self.b), form(&self.c));
        let fields = [0, 1, 2].map(|place| {
            let mut field = Field::zero();
            for (coordinate, _) in self.fields[place].components() {
                let part = Field::along(ring, coordinate, next.next().unwrap());
                field = field.add(ring, &part);
            }
            field
        });
        Scene { coordinates: self.coordinates.clone(), a, b, c, fields }
    }
}
