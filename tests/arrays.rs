//! Kernels whose arguments and results are vectors and matrices of other crates.

use forms::arrays::glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4, Mat3, Mat3A, Vec3, Vec3A};
use forms::arrays::nalgebra::{Matrix2x3, Matrix3, Point3, SMatrix, SVector, Vector2, Vector3};
use forms::arrays::{FromArray, IntoArray};
use std::fmt::Debug;

forms::forms! {
    kernel affine(p[3], R[3, 3], s) = s*(R*p);
    kernel plane(x[3], s) = [x[0]*x[1]*s, x[2]**2 + 3*x[0]];
    kernel slopes = jacobian(plane; x);
    kernel both = value_and_jacobian(plane; x);
    kernel numbers(x[2]) = (x[0] + x[1], x[0] - x[1], 2);
    kernel length(x[3]) = norm(x) within 2;
    kernel place(x, y) = [x + y, x - y, x*y];
}

const POINT: [f64; 3] = [2.0, 3.0, 5.0];
const ROWS: [[f64; 3]; 3] = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 10.0]];

/// Asserts that a type of a crate holds an array and gives it back.
fn holds<T: FromArray<A> + IntoArray<A> + Clone, A: Copy + PartialEq + Debug>(array: A) -> T {
    let value = T::from_array(array);
    assert_eq!(value.clone().into_array(), array);
    value
}

/// The n by n matrix whose entry (i, j) is 10 i + j.
fn numbered<const N: usize>() -> [[f64; N]; N] {
    std::array::from_fn(|row| std::array::from_fn(|column| (10 * row + column) as f64))
}

#[test]
fn entry_i_j_of_a_matrix_is_entry_i_j_in_every_crate() {
    for [row, column] in [[0, 0], [0, 1], [1, 0], [1, 1]] {
        let entry = (10 * row + column) as f64;
        assert_eq!(holds::<DMat2, _>(numbered::<2>()).row(row)[column], entry);
        assert_eq!(holds::<DMat3, _>(numbered::<3>()).row(row)[column], entry);
        assert_eq!(holds::<DMat4, _>(numbered::<4>()).row(row)[column], entry);
        let single = numbered::<3>().map(|row| row.map(|entry| entry as f32));
        assert_eq!(holds::<Mat3, _>(single).row(row)[column], entry as f32);
        assert_eq!(holds::<Mat3A, _>(single).row(row)[column], entry as f32);
        assert_eq!(holds::<SMatrix<f64, 5, 5>, _>(numbered::<5>())[(row, column)], entry);
        let wide = [[0.0, 1.0, 2.0], [10.0, 11.0, 12.0]];
        assert_eq!(holds::<Matrix2x3<f64>, _>(wide)[(row, column)], entry);
    }
}

#[test]
fn entry_i_of_a_vector_is_entry_i_in_every_crate() {
    assert_eq!(holds::<DVec2, _>([1.0, 2.0]).y, 2.0);
    assert_eq!(holds::<DVec3, _>(POINT).z, 5.0);
    assert_eq!(holds::<DVec4, _>([1.0, 2.0, 3.0, 4.0]).w, 4.0);
    assert_eq!(holds::<Vec3, _>([1.0f32, 2.0, 3.0]).y, 2.0);
    assert_eq!(holds::<Vec3A, _>([1.0f32, 2.0, 3.0]).y, 2.0);
    assert_eq!(holds::<Vector3<f64>, _>(POINT)[2], 5.0);
    assert_eq!(holds::<Point3<f64>, _>(POINT).z, 5.0);
    assert_eq!(holds::<SVector<f64, 5>, _>([1.0, 2.0, 3.0, 4.0, 5.0])[4], 5.0);
}

#[test]
fn a_product_with_a_matrix_is_that_of_the_crate() {
    let expected = affine(POINT, ROWS, 2.0);
    let (p, matrix) = (DVec3::from(POINT), DMat3::from_array(ROWS));
    let by_glam: DVec3 = affine::at(p, matrix, 2.0);
    assert_eq!(by_glam, 2.0 * (matrix * p));
    assert_eq!(by_glam.to_array(), expected);
    let (p, matrix) = (Vector3::from(POINT), Matrix3::from_array(ROWS));
    let by_nalgebra: Vector3<f64> = affine::at(p, matrix, 2.0);
    assert_eq!(by_nalgebra, 2.0 * (matrix * p));
    let mixed: [f64; 3] = affine::at(DVec3::from(POINT), matrix, 2.0);
    assert_eq!(mixed, expected);
    let single: Vec3 = affine::at_f32(Vec3A::new(2.0, 3.0, 5.0), Mat3::IDENTITY, 2.0);
    assert_eq!(single, Vec3::new(4.0, 6.0, 10.0));
}

#[test]
fn a_row_of_a_jacobian_has_the_derivatives_of_one_result() {
    let expected = [[3.0, 2.0, 0.0], [3.0, 0.0, 10.0]];
    let slopes: Matrix2x3<f64> = slopes::at(DVec3::from(POINT), 1.0);
    assert_eq!(slopes, Matrix2x3::new(3.0, 2.0, 0.0, 3.0, 0.0, 10.0));
    let (value, rows): (DVec2, [[f64; 3]; 2]) = both::at(Point3::from(POINT), 1.0);
    assert_eq!((value, rows), (DVec2::new(6.0, 31.0), expected));
}

#[test]
fn numbers_among_arguments_and_results_stay_numbers() {
    let sums: Vector3<f64> = numbers::at(Vector2::new(5.0, 3.0));
    assert_eq!(sums, Vector3::new(8.0, 2.0, 2.0));
    let length: f64 = length::at(DVec3::new(1.0, 2.0, 2.0));
    assert_eq!(length, 3.0);
    let place: DVec3 = place::at(3.0, 2.0);
    assert_eq!(place, DVec3::new(5.0, 1.0, 6.0));
}

#[test]
fn a_promise_is_kept_by_the_types_of_other_crates_too() {
    let far = [1e200, 1e200, 0.0];
    assert!((length::at(DVec3::from(far)) / length(far) - 1.0).abs() < 1e-15, "no overflow in between");
}
