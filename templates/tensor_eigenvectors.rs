/// Eigenvectors of a 3 x 3 x 3 tensor, scaled to eigenvalue 1: x_i = sum over j and k of a_ijk x_j
/// x_k, 8 solutions with x = 0.
///
/// Cartwright and Sturmfels, "The number of eigenvalues of a tensor", Linear Algebra and its
/// Applications 2013: 7 of them for general data. The method of moments reads the parts of a
/// mixture from them (Anandkumar, Ge, Hsu, Kakade, Telgarsky, "Tensor decompositions for learning
/// latent variable models", JMLR 2014, section 4).
fn tensor_eigenvectors(a: [[[f64; 3]; 3]; 3]) -> (x, y, z) {
    let v = [x, y, z];
    for i in 0..3 {
        dot(v, a[i] * v) == v[i];
    }
}
