//! Arrays of kernels as vectors and matrices of other crates, which generated code converts.
//!
//! ```text
//! DVec3, SVector, [f64; 3] ─ IntoArray ─▶ kernel on [f64; 3] ─ FromArray ─▶ DMat3, SMatrix, …
//! ```
//! An array of arrays is a matrix by rows, whatever the order in memory of the other type: entry
//! (i, j) of the matrix is `array[i][j]`. glam and nalgebra store matrices by columns, so their own
//! conversions of arrays of arrays give the transposed matrix.
//!
//! With the feature `glam` the types are `DVec2` to `DVec4`, `DMat2` to `DMat4`, and in `f32` `Vec2`
//! to `Vec4`, `Vec3A`, `Mat2` to `Mat4`, `Mat3A`. With the feature `nalgebra` they are `SMatrix`, of
//! which `SVector` and `Vector3` are aliases, and `Point`, for any type of number. Both crates are
//! re-exported, so that a program can use the versions that are converted. Other types implement
//! the two traits.
//!
//! ```
//! use forms::arrays::{FromArray, IntoArray};
//! use forms::arrays::glam::DMat2;
//! let shear = DMat2::from_array([[1.0, 2.0], [0.0, 1.0]]);
//! assert_eq!(shear.row(0).to_array(), [1.0, 2.0]);
//! let rows: [[f64; 2]; 2] = shear.into_array();
//! assert_eq!(rows, [[1.0, 2.0], [0.0, 1.0]]);
//! ```

#[cfg(feature = "glam")]
pub use glam;
#[cfg(feature = "nalgebra")]
pub use nalgebra;

/// Conversion of a vector or matrix into the array that a kernel takes.
pub trait IntoArray<A> {
    /// Returns the array, of a matrix by rows.
    fn into_array(self) -> A;
}

/// Conversion of the array that a kernel returns into a vector or matrix.
pub trait FromArray<A> {
    /// Returns the vector or matrix with these entries; an array of arrays holds the rows.
    fn from_array(array: A) -> Self;
}

impl<A> IntoArray<A> for A {
    fn into_array(self) -> A {
        self
    }
}

impl<A> FromArray<A> for A {
    fn from_array(array: A) -> Self {
        array
    }
}

#[cfg(feature = "glam")]
mod of_glam {
    use super::{FromArray, IntoArray};
    use glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4, Mat2, Mat3, Mat3A, Mat4, Vec2, Vec3, Vec3A, Vec4};

    macro_rules! vectors {
        ($($vector:ty: $number:ty, $count:literal;)*) => {$(
            impl IntoArray<[$number; $count]> for $vector {
                fn into_array(self) -> [$number; $count] {
                    self.to_array()
                }
            }

            impl FromArray<[$number; $count]> for $vector {
                fn from_array(array: [$number; $count]) -> Self {
                    <$vector>::from(array)
                }
            }
        )*};
    }

    macro_rules! matrices {
        ($($matrix:ty: $number:ty, $count:literal;)*) => {$(
            impl IntoArray<[[$number; $count]; $count]> for $matrix {
                fn into_array(self) -> [[$number; $count]; $count] {
                    self.transpose().to_cols_array_2d()
                }
            }

            impl FromArray<[[$number; $count]; $count]> for $matrix {
                fn from_array(rows: [[$number; $count]; $count]) -> Self {
                    <$matrix>::from_cols_array_2d(&rows).transpose()
                }
            }
        )*};
    }

    vectors! {
        DVec2: f64, 2; DVec3: f64, 3; DVec4: f64, 4;
        Vec2: f32, 2; Vec3: f32, 3; Vec3A: f32, 3; Vec4: f32, 4;
    }
    matrices! {
        DMat2: f64, 2; DMat3: f64, 3; DMat4: f64, 4;
        Mat2: f32, 2; Mat3: f32, 3; Mat3A: f32, 3; Mat4: f32, 4;
    }
}

#[cfg(feature = "nalgebra")]
mod of_nalgebra {
    use super::{FromArray, IntoArray};
    use nalgebra::{Point, SMatrix, SVector, Scalar};
    use std::array::from_fn;

    impl<T: Scalar, const N: usize> IntoArray<[T; N]> for SVector<T, N> {
        fn into_array(self) -> [T; N] {
            self.into()
        }
    }

    impl<T: Scalar, const N: usize> FromArray<[T; N]> for SVector<T, N> {
        fn from_array(array: [T; N]) -> Self {
            array.into()
        }
    }

    impl<T: Scalar, const N: usize> IntoArray<[T; N]> for Point<T, N> {
        fn into_array(self) -> [T; N] {
            self.coords.into()
        }
    }

    impl<T: Scalar, const N: usize> FromArray<[T; N]> for Point<T, N> {
        fn from_array(array: [T; N]) -> Self {
            SVector::from(array).into()
        }
    }

    impl<T: Scalar, const R: usize, const C: usize> IntoArray<[[T; C]; R]> for SMatrix<T, R, C> {
        fn into_array(self) -> [[T; C]; R] {
            from_fn(|row| from_fn(|column| self[(row, column)].clone()))
        }
    }

    impl<T: Scalar, const R: usize, const C: usize> FromArray<[[T; C]; R]> for SMatrix<T, R, C> {
        fn from_array(rows: [[T; C]; R]) -> Self {
            SMatrix::from_fn(|row, column| rows[row][column].clone())
        }
    }
}
