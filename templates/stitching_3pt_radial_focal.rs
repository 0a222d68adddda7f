/// Rotation between two photographs with common unknown focal length and radial distortion, a
/// panorama, from three points: 18 solutions.
///
/// Naroditsky, Daniilidis, "Optimizing polynomial solvers for minimal geometry problems", ICCV
/// 2011, after Byröd, Brown, Åström, "Minimal solutions for panoramic stitching with radial
/// distortion", BMVC 2009. Published as `stitching`.
///
/// A point p lies along (p, focal (1 + radial |p|^2)), the division model. Two points with the
/// inner product xy of their rays, in the first image, and x'y' in the second, satisfy xy^2 x'x'
/// y'y' = x'y'^2 xx yy. With w = 1/focal^2, and divided by focal^6, this is a polynomial whose
/// sixteen coefficients, in the order below, are `first` for the first and second point, and
/// `second` for the first and third.
fn stitching_3pt_radial_focal(first: [f64; 16], second: [f64; 16]) -> (radial, w) {
    let r = radial;
    let monomials = [
        r.pow(6), r.pow(5), r.pow(4), r.pow(4) * w, r.pow(3), r.pow(3) * w, r.pow(2), r.pow(2) * w,
        r.pow(2) * w.pow(2), r, r * w, r * w.pow(2), 1, w, w.pow(2), w.pow(3),
    ];
    dot(first, monomials) == 0;
    dot(second, monomials) == 0;
}
