"""The solvers of the catalogue.

Each takes the data of one instance, or arrays of the data of n instances. Data of one instance in
a batch hold for all. Batches are solved on all cores, without the lock of the interpreter.
`progress` is called with the number of instances that are done and of all; by default a long batch
has a bar where tqdm is installed and standard error is a terminal or this is a notebook, and with
False it has none. `results` has the names of the results to return, all by default; each
array that is left out saves the time to fill it.

Written by `tools/write_solvers.py` from the problems in `templates/`.
"""

from __future__ import annotations

from typing import Iterable, Optional

import numpy.typing as npt

from ._arrays import Array
from ._progress import Progress
from ._solutions import Solutions
from ._solve import mean as _mean
from ._solve import solve as _solve

__all__ = [
    "calibration_6_receivers_4_senders",
    "circle_least_squares",
    "circle_least_squares_dual",
    "circle_least_squares_dual_mean_of_line",
    "circle_least_squares_mean_of_line",
    "circle_minimal",
    "fundamental_7pt",
    "fundamental_8pt",
    "fundamental_8pt_radial",
    "fundamental_8pt_radial_one_side",
    "fundamental_9pt_two_radials",
    "homography_4pt",
    "katsura_5",
    "orbit_5_lines_of_sight",
    "platform_forward_kinematics",
    "pose_1pt_2line",
    "pose_2pt_1line",
    "pose_2pt_upright",
    "pose_35pt_focal",
    "pose_3line",
    "pose_3pt",
    "pose_3pt_depths",
    "pose_3pt_upright_error_bound",
    "pose_4pt_focal",
    "pose_4pt_focal_radial",
    "pose_4pt_focal_radial_cut",
    "pose_4pt_generalized_scale",
    "pose_4pt_upright_error_bound",
    "pose_5pt_refraction",
    "pose_5tdoa_two_receivers",
    "pose_6pt_rolling_shutter",
    "pose_npt_direct_least_squares",
    "pose_npt_direct_least_squares_mean_of_point",
    "pose_npt_least_squares_cayley",
    "pose_npt_least_squares_cayley_mean_of_point",
    "pose_npt_least_squares_quaternion",
    "pose_npt_least_squares_quaternion_mean_of_point",
    "pose_npt_weak_perspective",
    "pose_npt_weak_perspective_mean_of_point",
    "relpose_3pt_angle_zero_screw",
    "relpose_3pt_depths",
    "relpose_3pt_upright",
    "relpose_4pt_angle",
    "relpose_5pt",
    "relpose_5pt_generalized_angle",
    "relpose_5pt_rays",
    "relpose_5pt_semi_generalized_focal",
    "relpose_6pt_focal",
    "relpose_6pt_focal_one_side",
    "relpose_6pt_focal_points",
    "relpose_6pt_generalized",
    "relpose_6pt_radial",
    "relpose_7pt_angle_focal_centre",
    "relpose_7pt_focal_radial",
    "relpose_7pt_focal_radial_one_side",
    "relpose_7pt_focal_radial_one_side_eliminated",
    "relpose_7pt_generalized_scale",
    "stitching_3pt_radial_focal",
    "tensor_eigenvectors",
    "three_quadrics",
    "triangulation_3view",
    "triangulation_3view_relaxed",
    "trilateration",
    "two_conics",
]


def calibration_6_receivers_4_senders(
    ranges: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Positions of six receivers and four senders from all ranges between them: 38 solutions, of which
    those that can be placed in space are returned.

    Kuang, Burgess, Torstensson, Åström, "A complete characterization and solution to the microphone
    position self-calibration problem", ICASSP 2013. Published as `toa_46`.

    `ranges[i][j]` is the distance between receiver i and sender j. Relative to one of the senders,
    which is called the first, let G be the Gram matrix of the other three and K its inverse, [k11 v
    w; v k22 x; w x y]. A receiver with the squares r of its range to the first sender and s of
    those to the others satisfies 4 r = c K c + 2 c g + a with c_j = r - s_j, g = K n, a = n K n and
    n = diag(G). Six receivers give k11, k22, g and a as combinations of v, w, x, y and 1. How well
    depends on which sender is the first and which the last: the best of 12 choices is taken. With C
    = adj(K) and z = det(K), n is diag(C) / z. M = [K g; g a] is K times [1 n] from both sides: its
    adjugate is z times the square of (n, -1).

    Positions are known up to a motion and a mirror: the first of the senders is returned as the
    origin, another one on the x axis, and the third in the plane of x and y.

    Data, for one instance, or with n in front for a batch:

    - `ranges`: (6, 4)

    Solutions, of which there are at most 38:

    - `v`: ()
    - `w`: ()
    - `x`: ()
    - `y`: ()
    - `z`: ()

    Results of each solution:

    - `senders`: (4, 3)
    - `receivers`: (6, 3)
    """
    return _solve("calibration_6_receivers_4_senders", ranges, results=results, progress=progress)


def circle_least_squares(
    gram: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Circle tangent to n lines in the least-squares sense: the stationary points of the constrained
    dual conic, 9 solutions.

    Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", eq. (23)-(26): the
    Lagrangian as printed.

    `gram` is the mean over all lines l = (a, b, c) of r r^T with r = (a^2, ab, ac, b^2, bc, c^2).
    The dual conic is [d1 d2 d3; d2 d4 d5; d3 d5 -1]: a circle with centre (-d3, -d5) and squared
    radius d1 + d3^2 = d4 + d5^2, which is negative at some stationary points. The cost is the mean
    of (l^T D l)^2.

    Data, for one instance, or with n in front for a batch:

    - `gram`: (6, 6)

    Solutions, of which there are at most 9:

    - `d1`: ()
    - `d2`: ()
    - `d3`: ()
    - `d4`: ()
    - `d5`: ()
    - `lambda1`: ()
    - `lambda2`: ()

    Results of each solution:

    - `centre`: (2,)
    - `squared_radius`: ()
    - `cost`: ()
    """
    return _solve("circle_least_squares", gram, results=results, progress=progress)


def circle_least_squares_dual(
    gram: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Circle tangent to n lines in the least-squares sense, in three unknowns of the dual conic, 9
    solutions.

    Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation": the two constraints give d1
    and d2, which leaves the cost as a polynomial in d3, d4, d5. Data and conic are those of
    `circle_least_squares`.

    Data, for one instance, or with n in front for a batch:

    - `gram`: (6, 6)

    Solutions, of which there are at most 9:

    - `d3`: ()
    - `d4`: ()
    - `d5`: ()

    Results of each solution:

    - `centre`: (2,)
    - `squared_radius`: ()
    - `cost`: ()
    """
    return _solve("circle_least_squares_dual", gram, results=results, progress=progress)


def circle_least_squares_dual_mean_of_line(line: npt.ArrayLike) -> Array:
    """What a line a x + b y + c = 0 gives.

    Data, for one measurement, or with n in front for a mean over n:

    - `line`: (3,)

    The mean has the shape (6, 6).
    """
    return _mean("circle_least_squares_dual_mean_of_line", line)


def circle_least_squares_mean_of_line(line: npt.ArrayLike) -> Array:
    """What a line a x + b y + c = 0 gives.

    Data, for one measurement, or with n in front for a mean over n:

    - `line`: (3,)

    The mean has the shape (6, 6).
    """
    return _mean("circle_least_squares_mean_of_line", line)


def circle_minimal(
    d_alpha: npt.ArrayLike,
    d_beta: npt.ArrayLike,
    d_gamma: npt.ArrayLike,
    *,
    progress: Progress = None,
) -> Solutions:
    """The circles tangent to three lines: 4 solutions (the incircle and the three excircles of the
    triangle).

    Gummeson & Oskarsson, "Robust and Accurate Cylinder Triangulation", the minimal three-line
    solver.

    A line l = (a, b, c) is tangent to the circle with dual conic D = [d1 d2 d3; d2 d4 d5; d3 d5 d6]
    if l^T D l = 0: one linear equation in d = (d1, .., d6), (a^2, 2ab, 2ac, b^2, 2bc, c^2) d = 0.
    Three lines leave a null space of dimension three, d = a d_alpha + b d_beta + d_gamma, in which
    the two constraints of a circle, d2 d6 = d3 d5 and (d1 - d4) d6 = d3^2 - d5^2, pick four points.

    Data, for one instance, or with n in front for a batch:

    - `d_alpha`: (6,)
    - `d_beta`: (6,)
    - `d_gamma`: (6,)

    Solutions, of which there are at most 4:

    - `a`: ()
    - `b`: ()
    """
    return _solve("circle_minimal", d_alpha, d_beta, d_gamma, progress=progress)


def fundamental_7pt(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Fundamental matrix of two cameras from seven points: 3 solutions.

    Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 11.1.2.

    `first[k]` and `second[k]` are the images of point k. A fundamental matrix F satisfies
    `(second[k], 1) . F (first[k], 1) = 0`; it is the sum of the two matrices that span the null
    space of these equations, each times its weight.

    Data, for one instance, or with n in front for a batch:

    - `first`: (7, 2)
    - `second`: (7, 2)

    Solutions, of which there are at most 3:

    - `weights`: (2,)

    Results of each solution:

    - `fundamental`: (3, 3)
    """
    return _solve("fundamental_7pt", first, second, results=results, progress=progress)


def fundamental_8pt(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Fundamental matrix of two cameras from eight points: 1 solution.

    Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 11.1.

    `first[k]` and `second[k]` are the images of point k. A fundamental matrix F satisfies
    `(second[k], 1) . F (first[k], 1) = 0`. It is the sum of the two matrices that span the null
    space of the first seven of these equations, each times its weight, which the last one gives. Of
    images with errors F has rank 3; that of seven points, `fundamental_7pt`, has rank 2.

    Data, for one instance, or with n in front for a batch:

    - `first`: (8, 2)
    - `second`: (8, 2)

    Solutions, of which there are at most 1:

    - `weights`: (2,)

    Results of each solution:

    - `fundamental`: (3, 3)
    """
    return _solve("fundamental_8pt", first, second, results=results, progress=progress)


def fundamental_8pt_radial(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Fundamental matrix and the radial distortion common to both cameras from eight points: 16
    solutions.

    Kukelova, Pajdla, "A minimal solution to the autocalibration of radial distortion", CVPR 2007.
    Published as `8ptF_radial`, with f33 = 1, which loses planar motions and those without a
    rotation: f33 is 0.

    `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
    distortion. An image x lies along (x, 1 + radial |x|^2), the division model. Then x2^T F x1 = 0
    is linear in f11, f21, f31, f12, f22, f32, radial f31, radial f32 and the monomials radial f13,
    radial f23, radial^2 f33, f13, f23, radial f33, f33: eight points give the former as
    combinations of these. `third` is the third column of F, which is given up to scale. It vanishes
    where the first camera moves along its optical axis; without a rotation such points tell nothing
    of the distortion.

    Data, for one instance, or with n in front for a batch:

    - `first`: (8, 2)
    - `second`: (8, 2)

    Solutions, of which there are at most 16:

    - `radial`: ()
    - `third`: (3,)

    Results of each solution:

    - `fundamental`: (3, 3)
    - `radial`: ()
    """
    return _solve("fundamental_8pt_radial", first, second, results=results, progress=progress)


def fundamental_8pt_radial_one_side(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Fundamental matrix and radial distortion of the second camera from eight points: 8 solutions.

    Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
    distortion", CVPR 2014. Published as `8ptF_radial_1s`, with f33 = 1, which loses planar motions
    and those without a rotation: f33 is 0.

    `first[k]` is the image of point k in a camera without distortion, `second[k]` the distorted one
    in the other, relative to the centre of distortion. There an image x lies along (x, 1 + radial
    |x|^2), the division model. Then x2^T F x1 = 0 is, with f32 = 1, linear in the first two rows of
    F, radial f31, radial f32 and in radial f33, f31, 1, f33: eight points give the former as
    combinations of these. The first image is turned, which turns (f31, f32): for usual motions one
    of these is 0 if it is not. Both vanish where the second camera moves along its optical axis:
    then the points tell nothing of the distortion.

    Data, for one instance, or with n in front for a batch:

    - `first`: (8, 2)
    - `second`: (8, 2)

    Solutions, of which there are at most 8:

    - `f_31`: ()
    - `f_33`: ()
    - `radial`: ()

    Results of each solution:

    - `fundamental`: (3, 3)
    - `radial`: ()
    """
    return _solve("fundamental_8pt_radial_one_side", first, second, results=results, progress=progress)


def fundamental_9pt_two_radials(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Fundamental matrix and the two different radial distortions of two cameras from nine points: 24
    solutions.

    Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
    problems for cameras with radial distortion", CVIU 114, 2010. Published as `rdist9p`, with f33 =
    1, which loses planar motions and those without a rotation: f33 is 0.

    `first[k]` and `second[k]` are the distorted images of point k, relative to the centres of
    distortion. An image x lies along (x, 1 + radial |x|^2), the division model: with s for `radial`
    in the second image and t in the first. Then x2^T F x1 = 0 is, with f23 = 1, linear in f11, f12,
    f21, f22, t f13, t, t f33, s t f33, f13 and in s f31, s f32, s f33, f31, f32, f33, 1: nine
    points give the former as combinations of these. The second image is turned, which turns (f13,
    f23): for usual motions one of these is 0 if it is not. Both vanish where the first camera moves
    along its optical axis; without a rotation such points tell nothing of the distortions.

    Data, for one instance, or with n in front for a batch:

    - `first`: (9, 2)
    - `second`: (9, 2)

    Solutions, of which there are at most 24:

    - `s`: ()
    - `f_31`: ()
    - `f_32`: ()
    - `f_33`: ()

    Results of each solution:

    - `fundamental`: (3, 3)
    - `radials`: (2,)
    """
    return _solve("fundamental_9pt_two_radials", first, second, results=results, progress=progress)


def homography_4pt(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Homography of two images of a plane, or of two cameras with one centre, from four points: 1
    solution.

    Hartley, Zisserman, "Multiple view geometry in computer vision", 2003, section 4.1; here by the
    projective bases of the four points, as Heckbert, "Fundamentals of texture mapping and image
    warping", 1989.

    `first[k]` and `second[k]` are the images of point k, in pixels or any other unit; no three of
    either may lie on a line. The homography H takes (`first[k]`, 1) to a multiple of (`second[k]`,
    1): that of point k < 3 is `multiples[k]`. The fourth point is the sum of these three with
    weights, which are known in both images and proportional when multiplied.

    Data, for one instance, or with n in front for a batch:

    - `first`: (4, 2)
    - `second`: (4, 2)

    Solutions, of which there are at most 1:

    - `multiples`: (3,)

    Results of each solution:

    - `homography`: (3, 3)
    """
    return _solve("homography_4pt", first, second, results=results, progress=progress)


def katsura_5(*, progress: Progress = None) -> Solutions:
    """Katsura's equations for the magnetic field of a spin glass with six unknowns: 32 solutions.
    There are no data.

    Katsura, "Spin glass problem by the method of integral equation of the effective field", in: New
    Trends in Magnetism, 1990; as in the data base of PHCpack (Verschelde, ACM TOMS 795, 1999).
    Published as `katsura5`.

    There are no data.

    Solutions, of which there are at most 32:

    - `t`: ()
    - `u`: ()
    - `v`: ()
    - `x`: ()
    - `y`: ()
    - `z`: ()
    """
    return _solve("katsura_5", progress=progress)


def orbit_5_lines_of_sight(
    sights: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Keplerian orbit from five lines of sight without times: 66 solutions.

    Mancini, Duff, Leykin, Christian, "Geometric solution to the angles-only initial orbit
    determination problem", 2023; Huang, Leykin, Mancini, "Projective plane subdivision method for
    initial orbit determination", arXiv 2509.14397, 2025. Published as `IOD`.

    `sights` holds for each line the position of the observer and the direction; the Sun is the
    origin. The plane of the orbit has the normal n = (a, b, 1). It meets the line with direction d
    and moment m in x = n x m / n.d. The orbit is |x| = h - e.x, where e points to the pericentre
    and has the eccentricity as its length. With w = n x e / h = (-q, p, r), where (p, q, 0) is e /
    h up to a multiple of n, this is (n.d + w.m)^2 = |n x m|^2 / h^2, and `square` is 1 / h^2. The
    published unknowns are the entries of the orbit's dual quadric.

    Returned are the normal of the plane, of length 1, e and h, which is the semi-latus rectum.

    With directions and moments exchanged these are the cylinders that touch five lines: n is the
    direction of the axis, w its moment, and `square` that of the radius.

    Data, for one instance, or with n in front for a batch:

    - `sights`: (5, 2, 3)

    Solutions, of which there are at most 66:

    - `a`: ()
    - `b`: ()
    - `p`: ()
    - `q`: ()
    - `r`: ()
    - `square`: ()

    Results of each solution:

    - `normal`: (3,)
    - `eccentricity`: (3,)
    - `semi_latus_rectum`: ()
    """
    return _solve("orbit_5_lines_of_sight", sights, results=results, progress=progress)


def platform_forward_kinematics(
    base: npt.ArrayLike,
    platform: npt.ArrayLike,
    lengths: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Forward kinematics of the general Stewart-Gough platform, all poses with given lengths of its
    six legs: 40 solutions.

    Husty, "An algorithm for solving the direct kinematics of general Stewart-Gough-type platforms",
    Mechanism and Machine Theory 31, 1996. Published as `parallel_robot_66`.

    Leg k joins `base[k]`, in the frame of the base, and `platform[k]`, in that of the platform, and
    has the length `lengths[k]`. Base or platform may be flat, but not both. Returned is the pose
    x -> rotation x + translation that takes the platform to the frame of the base.

    Joints are taken relative to those of the first leg. Let t be that leg in the base's
    coordinates, s = R^T t in the platform's. The length of the leg from X to x, less that of the
    first, gives x s - X t as a linear combination of the entries of R and 1: five equations for s
    and t. The null vector of these has a part p of s and a part q of t, and the longer one is p,
    else base and platform are exchanged. Both are turned so that p and q are along their third
    axes. R is that of the quaternion 1 + a i + b j + c k, so n s and n t, with n = 1 + a a + b b +
    c c, are quadratic polynomials: `sums` has the coefficients of n (s_i + t_i), `differences`
    those of n (s_i - t_i), for i = 1, 2, and s_3 + t_3 = `ratio` (s_3 - t_3) + `shift`.

    That t q = q s gives n (s_3 - t_3) times 1, a, b and c as cubic polynomials, and that |s| = |t|
    its square: with these |t|^2 = `square` and its product with n (s_3 - t_3) have degrees of four
    and six.

    Data, for one instance, or with n in front for a batch:

    - `base`: (6, 3)
    - `platform`: (6, 3)
    - `lengths`: (6,)

    Solutions, of which there are at most 40:

    - `a`: ()
    - `b`: ()
    - `c`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("platform_forward_kinematics", base, platform, lengths, results=results, progress=progress)


def pose_1pt_2line(
    ray: npt.ArrayLike,
    point: npt.ArrayLike,
    normals: npt.ArrayLike,
    lines: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera from a point and two lines: 8 solutions, of which those with the
    point in front of the camera are returned.

    Ramalingam, Bouaziz, Sturm, "Pose estimation using both points and lines for geo-localization",
    ICRA 2011; in this form Zhou, Ye, Kaess, "A stable algebraic camera pose estimation for minimal
    configurations of 2D/3D point and line correspondences", ACCV 2018.

    `ray` is the ray of the point in the camera, of any length, and `point` its position.
    `normals[k]` is the image of line k: the plane through it and the centre of the camera is
    perpendicular to that vector, of any length. It is the cross product of the rays of two points
    of the image. `lines[k]` are two points of the line in space, other ones than the rays are of,
    if need be. A point X has the coordinates `rotation` X + `translation` in the camera, and
    `quaternion` is that of the rotation. The depth of the point along its ray is eliminated.

    Data, for one instance, or with n in front for a batch:

    - `ray`: (3,), or image points, one coordinate less
    - `point`: (3,)
    - `normals`: (2, 3)
    - `lines`: (2, 2, 3)

    Solutions, of which there are at most 8:

    - `quaternion`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_1pt_2line", ray, point, normals, lines, results=results, progress=progress)


def pose_2pt_1line(
    rays: npt.ArrayLike,
    points: npt.ArrayLike,
    normal: npt.ArrayLike,
    line: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera from two points and a line: at most 2 solutions, those with the
    points in front of the camera.

    Ramalingam, Bouaziz, Sturm, "Pose estimation using both points and lines for geo-localization",
    ICRA 2011, who have 4 solutions, which are 2 with both signs of the depths.

    `rays[k]` is the ray of point k in the camera, of any length, and `points[k]` its position.
    `normal` is the image of the line: the plane through it and the centre of the camera is
    perpendicular to that vector, of any length. It is the cross product of the rays of two points
    of the image. `line` are two points of the line in space, other ones than the rays are of, if
    need be. A point X has the coordinates `rotation` X + `translation` in the camera. In the frame
    of the points the normal is perpendicular to the line: it is the sum of two vectors that are,
    each times its weight. The depths of the points along their rays are linear in it, since it is
    perpendicular to the plane, and the distance of the points gives a quadratic equation. The
    points must not lie on the line, nor their images on its image.

    Data, for one instance, or with n in front for a batch:

    - `rays`: (2, 3), or image points, one coordinate less
    - `points`: (2, 3)
    - `normal`: (3,)
    - `line`: (2, 3)

    Solutions, of which there are at most 2:

    - `weights`: (2,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_2pt_1line", rays, points, normal, line, results=results, progress=progress)


def pose_2pt_upright(
    rays: npt.ArrayLike,
    points: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a camera whose vertical is known, as by an inertial sensor, from two points: 2
    solutions.

    Kukelova, Bujnak, Pajdla, "Closed-form solutions to minimal absolute pose problems with known
    vertical direction", ACCV 2010; here by the depths, as Haralick, Lee, Ottenberg, Nölle, IJCV
    1994, state the pose from three points.

    `rays[k]` is the ray of point k in a frame of the camera whose y axis is vertical, of any
    length, and `points[k]` its position in a world with the same vertical. The unknowns are the
    depths along the rays. A pose X -> rotation X + translation takes the world to the camera; the
    rotation is about the y axis, and both points are in front. The points must not be above each
    other, nor both rays level.

    Data, for one instance, or with n in front for a batch:

    - `rays`: (2, 3), or image points, one coordinate less
    - `points`: (2, 3)

    Solutions, of which there are at most 2:

    - `a`: ()
    - `b`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_2pt_upright", rays, points, results=results, progress=progress)


def pose_35pt_focal(
    points: npt.ArrayLike,
    horizontal: npt.ArrayLike,
    vertical: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose and focal length of a camera from three points and one image coordinate of a fourth: 10
    solutions.

    Wu, "P3.5P: Pose estimation with unknown focal length", CVPR 2015. Published as `pose_35pt`.

    `points` holds the points, one a row; `horizontal` and `vertical` their image coordinates,
    centred at the principal point. The rotation is, up to scale, that about the optical axis times
    that of the quaternion (1, x, y, 0). Each row of the matrix eliminates the rotation about the
    optical axis, and what is unknown of the focal length, from three points: it annihilates (cos,
    sin, 1/f). Where the camera looks against the third axis x and y are infinite. Points are turned
    before, so that this is no direction in which one would look. A point X has the coordinates
    `rotation` X + `translation` in the camera.

    Data, for one instance, or with n in front for a batch:

    - `points`: (4, 3)
    - `horizontal`: (4,)
    - `vertical`: (3,)

    Solutions, of which there are at most 10:

    - `x`: ()
    - `y`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    - `focal`: ()
    """
    return _solve("pose_35pt_focal", points, horizontal, vertical, results=results, progress=progress)


def pose_3line(
    normals: npt.ArrayLike,
    lines: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera from three lines: 8 solutions.

    Dhome, Richetin, Lapresté, Rives, "Determination of the attitude of 3D objects from a single
    perspective view", PAMI 1989; in this form Zhou, Ye, Kaess, "A stable algebraic camera pose
    estimation for minimal configurations of 2D/3D point and line correspondences", ACCV 2018.

    `normals[k]` is the image of line k: the plane through it and the centre of the camera is
    perpendicular to that vector, of any length. It is the cross product of the rays of two points
    of the image. `lines[k]` are two points of the line in space, other ones than the rays are of,
    if need be. A point X has the coordinates `rotation` X + `translation` in the camera, and
    `quaternion` is that of the rotation: `normals[k]` is perpendicular to the turned direction of
    line k. Three planes give the translation. The lines must not be parallel, nor the planes meet
    in a line.

    Data, for one instance, or with n in front for a batch:

    - `normals`: (3, 3)
    - `lines`: (3, 2, 3)

    Solutions, of which there are at most 8:

    - `quaternion`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_3line", normals, lines, results=results, progress=progress)


def pose_3pt(
    rays: npt.ArrayLike,
    points: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera from three points: at most 4 of 8 solutions, in front of the camera.

    The problem `pose_3pt_depths` from measurements. `rays[k]` is the ray of point k in the camera,
    of any length, and `points[k]` its position. The unknowns are the distances of the points from
    the centre of the camera. A point x has the coordinates `rotation` x + `translation` in the
    camera: the rotation takes the differences of positions, and their cross product, to those in
    the camera.

    Data, for one instance, or with n in front for a batch:

    - `rays`: (3, 3), or image points, one coordinate less
    - `points`: (3, 3)

    Solutions, of which there are at most 8:

    - `distances`: (3,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_3pt", rays, points, results=results, progress=progress)


def pose_3pt_depths(
    cosines: npt.ArrayLike,
    squares: npt.ArrayLike,
    *,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera from three points: their distances from the centre of the camera, 8
    solutions, which are 4 with both signs.

    Grunert, "Das Pothenotische Problem in erweiterter Gestalt", 1841; in this form Haralick, Lee,
    Ottenberg, Nölle, "Review and analysis of solutions of the three point perspective pose
    estimation problem", IJCV 1994, equation (1).

    `cosines` are those of the angles between the viewing rays of the points b and c, a and c, a and
    b; `squares` the squared distances of these points. Those of the solutions are poses in which
    all depths are positive.

    Data, for one instance, or with n in front for a batch:

    - `cosines`: (3,)
    - `squares`: (3,)

    Solutions, of which there are at most 8:

    - `a`: ()
    - `b`: ()
    - `c`: ()
    """
    return _solve("pose_3pt_depths", cosines, squares, progress=progress)


def pose_3pt_upright_error_bound(
    points: npt.ArrayLike,
    images: npt.ArrayLike,
    bound: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Poses of a camera with known vertical direction in which the errors of three points equal their
    bounds and are stationary: 48 solutions.

    Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
    direction", PAMI 2017. Published as `optpose3pt_v2`. A pose with the largest number of points
    within the bound can be moved until four errors equal it, or three where it can be moved no
    further.

    `points[k]` is the position of point k, `images[k]` its image (p, q) for a focal length of 1 and
    `bound` the largest error, a length in the image. The camera's first axis is vertical: it is
    turned about it by the angle of the cosine y and the sine z, and shifted by (u, v, w). A point
    in the camera's coordinates (X, Y, Z) is on the cone (X - p Z)^2 + (Y - q Z)^2 = bound^2 Z^2.
    The derivatives of the three left sides by w, y and z are linearly dependent.

    Data, for one instance, or with n in front for a batch:

    - `points`: (3, 3)
    - `images`: (3, 2)
    - `bound`: ()

    Solutions, of which there are at most 48:

    - `u`: ()
    - `v`: ()
    - `w`: ()
    - `y`: ()
    - `z`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_3pt_upright_error_bound", points, images, bound, results=results, progress=progress)


def pose_4pt_focal(
    points: npt.ArrayLike,
    images: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    r"""Pose and focal lengths of a camera from four points: 8 solutions, of which those with the points
    in front of the camera are returned.

    Bujnak, Kukelova, Pajdla, "A general solution to the P4P problem for camera with unknown focal
    length", CVPR 2008, by three quadrics as Kukelova, Heller, Fitzgibbon, "Efficient intersection
    of three quadrics and applications in computer vision", CVPR 2016.

    `points[k]` is the position of point k, in a plane or not, and `images[k]` its image, relative
    to the principal point. Eight equations leave a null space of dimension four of the camera
    diag(f_x, f_y, 1) \[R t\], which is the sum of its vectors, each times its weight, up to scale.
    Its first three columns have perpendicular rows. One focal length would be one equation too
    many: it is left out, and of the results that one is wanted whose two `focal` lengths differ
    least. A point X has the coordinates `rotation` X + `translation` in the camera.

    Data, for one instance, or with n in front for a batch:

    - `points`: (4, 3)
    - `images`: (4, 2)

    Solutions, of which there are at most 8:

    - `weights`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    - `focal`: (2,)
    """
    return _solve("pose_4pt_focal", points, images, results=results, progress=progress)


def pose_4pt_focal_radial(
    points: npt.ArrayLike,
    images: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    r"""Pose, focal length and radial distortion of a camera from four points: 16 solutions.

    Josephson, Byröd, "Pose estimation with radial distortion and unknown focal length", CVPR 2009,
    in the form of Bujnak, Kukelova, Pajdla, "New efficient solution to the absolute pose problem
    for camera with unknown focal length and radial distortion", ACCV 2010. Published as `p4p_fr`.

    `points[k]` is the position of point k, `images[k]` its distorted image, relative to the
    principal point. The points must not lie in a plane, nor an image be at that point. An image (u,
    v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with P = diag(1, 1,
    1/f) \[R t\]. That v times the first row of P minus u times the second vanishes at X leaves a
    null space of dimension four: these rows are the sum of its vectors, each times its weight. The
    third row follows from the four points. `projection` is P up to scale.

    Data, for one instance, or with n in front for a batch:

    - `points`: (4, 3)
    - `images`: (4, 2)

    Solutions, of which there are at most 16:

    - `weights`: (4,)
    - `radial`: ()

    Results of each solution:

    - `projection`: (3, 4)
    - `focal`: ()
    - `radial`: ()
    """
    return _solve("pose_4pt_focal_radial", points, images, results=results, progress=progress)


def pose_4pt_focal_radial_cut(
    points: npt.ArrayLike,
    images: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    r"""Pose, focal length and radial distortion of a camera from four points, without the degenerate
    solutions: 12 solutions.

    Larsson, Kukelova, Zheng, "Making minimal solvers for absolute pose estimation compact and
    robust", ICCV 2017. Published as `p4p_fr_iccv17`; `pose_4pt_focal_radial` is the older
    formulation of the same problem, with 16.

    `points[k]` is the position of point k, `images[k]` its distorted image, relative to the
    principal point. The points must not lie in a plane, nor an image be at that point. An image (u,
    v) lies along (u, v, 1 + radial (u^2 + v^2)), the division model, of P X with P = diag(1, 1,
    1/f) \[R t\]. That v times the first row of P minus u times the second vanishes at X leaves a
    null space of dimension four: these rows are the sum of its vectors, each times its weight. The
    third row follows from the four points. `projection` is P up to scale.

    Data, for one instance, or with n in front for a batch:

    - `points`: (4, 3)
    - `images`: (4, 2)

    Solutions, of which there are at most 12:

    - `radial`: ()
    - `weights`: (4,)

    Results of each solution:

    - `projection`: (3, 4)
    - `focal`: ()
    - `radial`: ()
    """
    return _solve("pose_4pt_focal_radial_cut", points, images, results=results, progress=progress)


def pose_4pt_generalized_scale(
    centres: npt.ArrayLike,
    rays: npt.ArrayLike,
    points: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose and scale of a generalised camera from four points: 8 solutions, of which those with a
    positive scale are returned.

    Ventura, Arth, Reitmayr, Schmalstieg, "A minimal solution to the generalized pose-and-scale
    problem", CVPR 2014. Published as `gp4p_scale`. As three quadrics: Kukelova, Heller, Fitzgibbon,
    "Efficient intersection of three quadrics and applications in computer vision", CVPR 2016.

    `rays[k]` is the ray of point k, of any length, from `centres[k]`, and `points[k]` its position.
    With R = `rotation`, that of the quaternion, t = `translation` and s = `scale`,
    R `points[k]` + t - s `centres[k]` is along `rays[k]`: for each point two equations, linear in
    R, t and s. Seven of the eight are combined so that t and s vanish. `residual` is what the
    eighth, of the last point, leaves over: the solution that fits it best is wanted.

    Data, for one instance, or with n in front for a batch:

    - `centres`: (4, 3)
    - `rays`: (4, 3)
    - `points`: (4, 3)

    Solutions, of which there are at most 8:

    - `quaternion`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    - `scale`: ()
    - `residual`: ()
    """
    return _solve("pose_4pt_generalized_scale", centres, rays, points, results=results, progress=progress)


def pose_4pt_upright_error_bound(
    points: npt.ArrayLike,
    images: npt.ArrayLike,
    bound: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Poses of a camera with known vertical direction in which the errors of four points equal their
    bounds: 28 solutions.

    Svärm, Enqvist, Kahl, Oskarsson, "City-scale localization for cameras with known vertical
    direction", PAMI 2017. Published as `optpose4pt_v2`. A pose with the largest number of points
    within the bound can be moved until four errors equal it.

    `points[k]` is the position of point k, `images[k]` its image (p, q) for a focal length of 1 and
    `bound` the largest error, a length in the image. The camera's first axis is vertical: it is
    turned about it by the angle of the cosine y and the sine z, and shifted by (u, v, w). A point
    in the camera's coordinates (X, Y, Z) is on the cone (X - p Z)^2 + (Y - q Z)^2 = bound^2 Z^2.

    Data, for one instance, or with n in front for a batch:

    - `points`: (4, 3)
    - `images`: (4, 2)
    - `bound`: ()

    Solutions, of which there are at most 28:

    - `u`: ()
    - `v`: ()
    - `w`: ()
    - `y`: ()
    - `z`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_4pt_upright_error_bound", points, images, bound, results=results, progress=progress)


def pose_5pt_refraction(
    rays: npt.ArrayLike,
    points: npt.ArrayLike,
    index: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera that looks at five points through a plane at which light is
    refracted: 8 solutions.

    Haner, Åström, "Absolute pose for cameras under flat refractive interfaces", CVPR 2015.
    Published as `refract5p`.

    The plane is Z = 0, with the camera on one side of it and the points on the other. `rays[k]` is
    the ray of point k in the camera, of any length, and `points[k]` its position; `index` is the
    index of refraction on the side of the points, relative to that on the side of the camera.
    Refraction keeps a ray in its plane with the normal, so that R ray and the point X minus the
    centre (v, w, ..) of the camera are parallel in their first two coordinates:
    (r1 ray) (X2 - w) - (r2 ray) (X1 - v) = 0 with the rows r1, r2, r3 of R. This is linear in r1,
    r2 and u = v r2 - w r1, so these are a sum of four vectors, each times its weight. r1 and r2
    have one length and are orthogonal, and u is in their plane: the determinant is 0. Four complex
    solutions with r1 and r2 of length 0 satisfy that for any u. They are none of the other form, in
    which u is the sum of its parts along r1 and r2. The two together are all cubic equations.

    The published system is stated in a quaternion and has 16 solutions: with (r1, r2, r3) also
    (-r1, -r2, r3), the same turned by a half about the normal. Both have the same weights here, up
    to sign. Of the two, `rotation` is the one with the points ahead of the camera. It takes rays to
    the frame of the points, and `centre` is that of the camera. Its height follows from how much
    the rays are bent, by least squares.

    Data, for one instance, or with n in front for a batch:

    - `rays`: (5, 3), or image points, one coordinate less
    - `points`: (5, 3)
    - `index`: ()

    Solutions, of which there are at most 8:

    - `weights`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `centre`: (3,)
    """
    return _solve("pose_5pt_refraction", rays, points, index, results=results, progress=progress)


def pose_5tdoa_two_receivers(
    senders: npt.ArrayLike,
    differences: npt.ArrayLike,
    distance: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of two receivers close to each other from the time differences with which they hear five
    senders: 24 solutions.

    Burgess, Kuang, Åström, "Pose estimation from minimal dual-receiver configurations", ICPR 2012.
    Published as `tdoa_pose_5pt`.

    `senders` are positions, `differences` the differences of the ranges of each to the two
    receivers, and `distance` is that of the receivers. They are at C, one from the other in the
    direction n = (u, v, w). Divided by `distance`, the difference of the ranges of a sender U is
    the cosine c of an angle: (n U - t)^2 = c^2 |n|^2 |U - C|^2 with t = n C. Five such equations
    are linear in |n|^2 |C|^2 and |n|^2 C, and otherwise have the terms u u, u v, u w, v v, v w, w
    w, t u, t v, t w and t t. They are solved for the former, and a fifth linear combination has
    none of them. C follows from n and t, which are `plane`: n X = t passes through the receivers,
    across their line. t is in units of the length of all positions.

    Data, for one instance, or with n in front for a batch:

    - `senders`: (5, 3)
    - `differences`: (5,)
    - `distance`: ()

    Solutions, of which there are at most 24:

    - `plane`: (4,)

    Results of each solution:

    - `direction`: (3,)
    - `centre`: (3,)
    """
    return _solve("pose_5tdoa_two_receivers", senders, differences, distance, results=results, progress=progress)


def pose_6pt_rolling_shutter(
    points: npt.ArrayLike,
    images: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    r"""Pose and motion of a camera with rolling shutter from six points: 20 solutions.

    Albl, Kukelova, Pajdla, "R6P - rolling shutter absolute camera pose", CVPR 2015. Published as
    `r6p`.

    `points[k]` is the position of a point and `images[k]` its image, in units of the focal length.
    A point X is seen at q, in the row q\[0\], where (q, 1) and (I + q\[0\] \[(x, y, z)\]x) (I +
    \[(u, v, w)\]x) X + C + q\[0\] t are parallel: both rotations linearised, the first for an
    angular velocity. Three of the points, linear in the position C and the velocity t, give them as
    position m and velocity m, m being the products of x, y, z (slower) with u, v, w, and then u, v,
    w, x, y, z, 1.

    Data, for one instance, or with n in front for a batch:

    - `points`: (6, 3)
    - `images`: (6, 2)

    Solutions, of which there are at most 20:

    - `u`: ()
    - `v`: ()
    - `w`: ()
    - `x`: ()
    - `y`: ()
    - `z`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `position`: (3,)
    - `angular_velocity`: (3,)
    - `velocity`: (3,)
    """
    return _solve("pose_6pt_rolling_shutter", points, images, results=results, progress=progress)


def pose_npt_direct_least_squares(
    means: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera from n points, all stationary points of a least-squares cost in
    Cayley parameters: 27 solutions.

    Hesch, Roumeliotis, "A direct least-squares (DLS) method for PnP", ICCV 2011. Published as
    `opt_pnp_hesch`.

    The cost is the mean squared distance of the points from the rays along which the camera sees
    them, with the best translation, which is linear in the rotation. Without the common denominator
    1 + x^2 + y^2 + z^2 of the rotation of the quaternion (1, x, y, z) it is a polynomial of degree
    four. `means` are those of `of_point` over 3 points or more. Rounding errors are smallest if the
    origin is amid the points. Half turns would be at infinity. Points are turned before, so that
    none of the poses that are at infinity is one that scenes are made of.

    Data, for one instance, or with n in front for a batch:

    - `means`: (6, 10)

    Solutions, of which there are at most 27:

    - `x`: ()
    - `y`: ()
    - `z`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_npt_direct_least_squares", means, results=results, progress=progress)


def pose_npt_direct_least_squares_mean_of_point(ray: npt.ArrayLike, point: npt.ArrayLike) -> Array:
    """What a point gives: the products of its coordinates and 1, times the entries of the projection
    across its ray. `ray` is the ray of the point in the camera, of any length.

    Data, for one measurement, or with n in front for a mean over n:

    - `ray`: (3,), or image points, one coordinate less
    - `point`: (3,)

    The mean has the shape (6, 10).
    """
    return _mean("pose_npt_direct_least_squares_mean_of_point", ray, point)


def pose_npt_least_squares_cayley(
    means: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera from n points, all stationary points of a least-squares cost over
    the rotations, by Cayley parameters: 40 solutions.

    Nakano, "Globally optimal DLS method for PnP problem with Cayley parameterization", BMVC 2015.
    Published as `opt_pnp_nakanoC`.

    The cost is the mean squared distance of the points from the rays along which the camera sees
    them, with the best translation, which is linear in the rotation: r^T `cost` r, r being the
    entries of the rotation of the quaternion q, row by row. With r times |q|^2 in its place the
    cost grows with the fourth power of the length of q, so q is stationary up to its length where
    the gradient d is parallel to it. `means` are those of `of_point` over 3 points or more.
    Rounding errors are smallest if the origin is amid the points.

    Data, for one instance, or with n in front for a batch:

    - `means`: (6, 10)

    Solutions, of which there are at most 40:

    - `q`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_npt_least_squares_cayley", means, results=results, progress=progress)


def pose_npt_least_squares_cayley_mean_of_point(ray: npt.ArrayLike, point: npt.ArrayLike) -> Array:
    """What a point gives: the products of its coordinates and 1, times the entries of the projection
    across its ray. `ray` is the ray of the point in the camera, of any length.

    Data, for one measurement, or with n in front for a mean over n:

    - `ray`: (3,), or image points, one coordinate less
    - `point`: (3,)

    The mean has the shape (6, 10).
    """
    return _mean("pose_npt_least_squares_cayley_mean_of_point", ray, point)


def pose_npt_least_squares_quaternion(
    means: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a calibrated camera from n points, all stationary points of a least-squares cost in a
    quaternion that is not normalised: 40 solutions.

    Zheng, Kuang, Sugimoto, Åström, Okutomi, "Revisiting the PnP problem: a fast, general and
    optimal solution", ICCV 2013. Published as `opt_pnp_zheng`.

    With depths relative to their mean, and P the rotation over the mean depth, the image (u, v) of
    a point satisfies (u, v) (1 + P3 X) = (P1 X, P2 X) + constants, X relative to the mean of the
    points. With the best constants the mean square of the differences is a quadratic form in 1 and
    the entries of P, which are the products of two entries of a quaternion. The square of its
    length, the inverse of the mean depth, is free: it is an unknown scale s times the unknown
    direction q below. The derivatives, divided by s, are linear in the square of s, with the
    coefficients `cubic` and `linear`: it follows from any of them, and is eliminated here.

    `means` are those of `of_point` over 4 points or more. Rounding errors are smallest if the
    origin is amid the points.

    Data, for one instance, or with n in front for a batch:

    - `means`: (39,)

    Solutions, of which there are at most 40:

    - `q`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("pose_npt_least_squares_quaternion", means, results=results, progress=progress)


def pose_npt_least_squares_quaternion_mean_of_point(
    image: npt.ArrayLike,
    point: npt.ArrayLike,
) -> Array:
    """What a point and its image give: the products of two of the point's coordinates and 1, then
    those with 1 times the coordinates of the image and times the square of its distance from the
    principal point.

    Data, for one measurement, or with n in front for a mean over n:

    - `image`: (2,)
    - `point`: (3,)

    The mean has the shape (39,).
    """
    return _mean("pose_npt_least_squares_quaternion_mean_of_point", image, point)


def pose_npt_weak_perspective(
    means: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose of a weak-perspective camera from n points, all stationary points of the least-squares
    cost: 16 solutions.

    Larsson, Åström, "Uncovering symmetries in polynomial systems", ECCV 2016. Published as `wpnp`.

    The image of a point X is P X + t, with P the first two rows of a rotation times a scale, that
    is, of the rotation of a quaternion q that is not normalised. With the best t the mean square of
    the differences is a quadratic form in P, whose matrix is the covariance of the points. Since q
    and -q are the same rotation, the unknowns are the ratios in q = root (w, 1, y, z), and
    `square`, that of the root. Points are turned before, so that the entry of 1 is not 0 for poses
    that scenes are made of. Published templates take the principal axes of the points instead, in
    which the covariance is diagonal.

    `means` are those of `of_point` over 4 points or more. Rounding errors are smallest if the
    origin is amid the points.

    Data, for one instance, or with n in front for a batch:

    - `means`: (17,)

    Solutions, of which there are at most 16:

    - `w`: ()
    - `square`: ()
    - `y`: ()
    - `z`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `scale`: ()
    - `translation`: (2,)
    """
    return _solve("pose_npt_weak_perspective", means, results=results, progress=progress)


def pose_npt_weak_perspective_mean_of_point(image: npt.ArrayLike, point: npt.ArrayLike) -> Array:
    """What a point and its image give: the products of two of the point's coordinates and 1, then
    those of the coordinates and 1 with those of the image.

    Data, for one measurement, or with n in front for a mean over n:

    - `image`: (2,)
    - `point`: (3,)

    The mean has the shape (17,).
    """
    return _mean("pose_npt_weak_perspective_mean_of_point", image, point)


def relpose_3pt_angle_zero_screw(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    half_angle: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of two calibrated cameras from three point correspondences where the motion turns
    by a known angle about an axis without moving along it: 12 solutions.

    Martyushev, Li, "Efficient relative pose estimation for cameras and generalized cameras in case
    of known relative rotation angle", JMIV 62, 2020. Published as `3pra_st0`.

    `first` and `second` hold the rays of the points in either camera, one a row, and `half_angle`
    the cosine and the sine of half the angle: the rotation from the first camera to the second is
    that of the unit quaternion cosine + u i + v j + w k. The ratio of the two depths of a point
    follows from any other point, and from the translation being orthogonal to (u, v, w). All
    polynomials are written p + w q, with p and q in u and v only, and stated with their multiple by
    w.

    A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
    The length of the translation is open, and it is of length 1; where the motion is a rotation it
    is not known. Its sign is the one for which the first point is in front of the first camera.

    Data, for one instance, or with n in front for a batch:

    - `first`: (3, 3), or image points, one coordinate less
    - `second`: (3, 3), or image points, one coordinate less
    - `half_angle`: (2,)

    Solutions, of which there are at most 12:

    - `u`: ()
    - `v`: ()
    - `w`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("relpose_3pt_angle_zero_screw", first, second, half_angle, results=results, progress=progress)


def relpose_3pt_depths(
    first: npt.ArrayLike,
    first_depths: npt.ArrayLike,
    second: npt.ArrayLike,
    second_depths: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of two calibrated cameras from three points with depths that are known up to scale
    and shift, as a network estimates them from each image: at most 4 solutions.

    Ding, Kocur, Vávra, Berger Haladová, Yang, Sattler, Kukelova, "RePoseD: Efficient relative pose
    estimation with known depth information", ICCV 2025; Yu, Liu, Pautrat, Pollefeys, Larsson,
    "Relative pose estimation through affine corrections of monocular depth priors", CVPR 2025.

    `first[k]` and `second[k]` are the images of point k, (x, y) of the ray (x, y, 1), and
    `first_depths[k]` and `second_depths[k]` its depths, the third coordinates, as estimated. The
    point is at (`first_depths[k]` + u) (x, y, 1) in the first camera and at `scale`
    (`second_depths[k]` + v) (x, y, 1) in the second; `shifts` are u and v. Squared distances of the
    points are quadratic in the shifts, and those in the second camera are 1 / `scale`^2 of those in
    the first. Three of them, solved for 1, u and u^2, give these times 1 / `scale`^2 as `powers`,
    which are quadratic in v: the first times the third is the square of the second. A point X in
    the first camera is at `rotation` X + `translation` in the second.

    Data, for one instance, or with n in front for a batch:

    - `first`: (3, 2)
    - `first_depths`: (3,)
    - `second`: (3, 2)
    - `second_depths`: (3,)

    Solutions, of which there are at most 4:

    - `v`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    - `scale`: ()
    - `shifts`: (2,)
    """
    return _solve("relpose_3pt_depths", first, first_depths, second, second_depths, results=results, progress=progress)


def relpose_3pt_upright(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of two cameras whose vertical is known, as by an inertial sensor, from three
    points: 4 solutions.

    Fraundorfer, Tanskanen, Pollefeys, "A minimal case solution to the calibrated relative pose
    problem for the case of two known orientation angles", ECCV 2010.

    `first[k]` and `second[k]` are the rays of point k in frames of the cameras whose y axes are
    vertical, of any length. The unknowns are cosine and sine of the turn about the vertical.

    A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
    The length of the translation is open, and it is of length 1; where the motion is a rotation it
    is not known. Its sign is the one for which the first point is in front of the first camera.

    Data, for one instance, or with n in front for a batch:

    - `first`: (3, 3), or image points, one coordinate less
    - `second`: (3, 3), or image points, one coordinate less

    Solutions, of which there are at most 4:

    - `c`: ()
    - `s`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("relpose_3pt_upright", first, second, results=results, progress=progress)


def relpose_4pt_angle(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    half_angle: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of two calibrated cameras with a known angle of rotation from four point
    correspondences: 20 solutions.

    Li, Heng, Lee, Pollefeys, "A 4-point algorithm for relative pose estimation of a calibrated
    camera with a known relative rotation angle", IROS 2013. Published as `relpose_4pt`, with the
    translation among the unknowns; it is eliminated here as in Martyushev, Li, "Efficient relative
    pose estimation for cameras and generalized cameras in case of known relative rotation angle",
    JMIV 62, 2020.

    `first` and `second` hold the rays of the points in either camera, one a row, and `half_angle`
    the cosine and the sine of half the angle: the rotation from the first camera to the second is
    that of the unit quaternion cosine + u i + v j + w k. The ratio of the two depths of a point
    follows from any other point. All polynomials are written p + w q, with p and q in u and v only,
    and stated with their multiple by w.

    A pose X -> rotation X + translation takes the frame of the first camera to that of the second.
    The length of the translation is open, and it is of length 1; where the motion is a rotation it
    is not known. Its sign is the one for which the first point is in front of the first camera.

    Data, for one instance, or with n in front for a batch:

    - `first`: (4, 3), or image points, one coordinate less
    - `second`: (4, 3), or image points, one coordinate less
    - `half_angle`: (2,)

    Solutions, of which there are at most 20:

    - `u`: ()
    - `v`: ()
    - `w`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("relpose_4pt_angle", first, second, half_angle, results=results, progress=progress)


def relpose_5pt(basis: npt.ArrayLike, *, progress: Progress = None) -> Solutions:
    """Relative pose of two calibrated cameras from five point correspondences: 10 essential matrices.

    Nistér, "An efficient solution to the five-point relative pose problem", PAMI 2004; in this form
    Stewénius, Engels, Nistér, "Recent developments on direct relative orientation", ISPRS 2006.
    Published as `5p`.

    `basis` spans the null space of the five epipolar equations; the essential matrix is the sum
    of its matrices, each times its weight.

    Of rays or image points it is `relpose_5pt_rays`.

    Data, for one instance, or with n in front for a batch:

    - `basis`: (4, 3, 3)

    Solutions, of which there are at most 10:

    - `weights`: (4,)
    """
    return _solve("relpose_5pt", basis, progress=progress)


def relpose_5pt_generalized_angle(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    half_angle: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of two generalized cameras with a known angle of rotation from five point
    correspondences: 44 solutions.

    Martyushev, Li, "Efficient relative pose estimation for cameras and generalized cameras in case
    of known relative rotation angle", JMIV 62, 2020. Published as `gen5pra`.

    `first` and `second` hold the rays of the points in either system of cameras: a point of the
    ray, and its direction. `half_angle` holds the cosine and the sine of half the angle: the
    rotation from the first system to the second is that of the unit quaternion cosine + u i + v j +
    w k. That the rays of one point meet gives the translation up to the depths of that point along
    either ray; that the rays of any three others meet, too, are linear equations for these depths.
    All polynomials are written p + w q, with p and q in u and v only, and stated with their
    multiple by w.

    A pose X -> rotation X + translation takes the first system to the second, in the unit of the
    points of the rays.

    Data, for one instance, or with n in front for a batch:

    - `first`: (5, 2, 3)
    - `second`: (5, 2, 3)
    - `half_angle`: (2,)

    Solutions, of which there are at most 44:

    - `u`: ()
    - `v`: ()
    - `w`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("relpose_5pt_generalized_angle", first, second, half_angle, results=results, progress=progress)


def relpose_5pt_rays(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of two calibrated cameras from five points: 10 essential matrices.

    The problem `relpose_5pt` from measurements. `first[k]` and `second[k]` are the rays of point k
    in both cameras, of any length. An essential matrix E satisfies `second[k] . E first[k] = 0`; it
    is the sum of the matrices that span the null space of these equations, each times its weight.

    A pose X -> rotation X + translation takes the frame of the first camera to that of the second;
    the translation has the length 1. Of the four poses of an essential matrix it is the one with
    the first point in front of both cameras: Horn, "Recovering baseline and orientation from
    essential matrix", 1990. For a solution that belongs to the scene all points are in front.

    Data, for one instance, or with n in front for a batch:

    - `first`: (5, 3), or image points, one coordinate less
    - `second`: (5, 3), or image points, one coordinate less

    Solutions, of which there are at most 10:

    - `weights`: (4,)

    Results of each solution:

    - `essential`: (3, 3)
    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("relpose_5pt_rays", first, second, results=results, progress=progress)


def relpose_5pt_semi_generalized_focal(
    point: npt.ArrayLike,
    image: npt.ArrayLike,
    images: npt.ArrayLike,
    centres: npt.ArrayLike,
    directions: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Pose and focal length of a camera from five points that calibrated cameras of known poses see,
    too, and one point of known position: 56 solutions.

    Bhayani, Sattler, Larsson, Heikkilä, Kukelova, "Partially calibrated semi-generalized pose from
    hybrid point correspondences", WACV 2023. Published as `hyb51f`.

    `image` is that of the known `point`, relative to the principal point, and must not be there.
    `images[k]` is that of point k, which a calibrated camera sees along the ray from `centres[k]`
    in the direction `directions[k]`. Positions are relative to `point`; images are turned and
    scaled so that that of `point` is (1, 0), and its depth is the unknown `depth`. The rotation of
    the camera, which is turned with the images, is that of the quaternion 1 + x i + y j, and a turn
    about its axis after it, by the angle of which c and s are cosine and sine, times the focal
    length. An image lies on that of the ray: det(M) M^-T, the cofactors of M, maps moments of rays
    to lines of the image where M maps directions to points of it. The squared norm of the
    quaternion, which divides all cofactors, is left out.

    A pose X -> rotation X + translation takes the world to the camera; `focal` is in the unit of
    images. The known point is in front of the camera.

    Data, for one instance, or with n in front for a batch:

    - `point`: (3,)
    - `image`: (2,)
    - `images`: (5, 2)
    - `centres`: (5, 3)
    - `directions`: (5, 3)

    Solutions, of which there are at most 56:

    - `x`: ()
    - `y`: ()
    - `c`: ()
    - `s`: ()
    - `depth`: ()

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    - `focal`: ()
    """
    return _solve("relpose_5pt_semi_generalized_focal", point, image, images, centres, directions, results=results, progress=progress)


def relpose_6pt_focal(basis: npt.ArrayLike, *, progress: Progress = None) -> Solutions:
    """Relative pose of two cameras with one unknown shared focal length from six point
    correspondences: 15 solutions.

    Stewénius, Nistér, Kahl, Schaffalitzky, "A minimal solution for relative pose with unknown focal
    length", CVPR 2005; the form with w = 1/f^2 as in Kukelova, Bujnak, Pajdla, "Polynomial
    eigenvalue solutions to the 5-pt and 6-pt relative pose problems", BMVC 2008. Published as
    `focal6p`.

    `basis` spans the null space of the six epipolar equations; the fundamental matrix is the
    sum of its matrices, each times its weight.

    Data, for one instance, or with n in front for a batch:

    - `basis`: (3, 3, 3)

    Solutions, of which there are at most 15:

    - `weights`: (3,)
    - `w`: ()
    """
    return _solve("relpose_6pt_focal", basis, progress=progress)


def relpose_6pt_focal_one_side(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of a camera with unknown focal length and a calibrated one from six points: 9
    solutions, of which those with a real focal length are returned.

    Bujnak, Kukelova, Pajdla, "3D reconstruction from image collections with a single known focal
    length", ICCV 2009. Published as `focal6p_1s`.

    `first[k]` is the image of point k in the camera with unknown focal length, relative to the
    principal point, `second[k]` its ray in the calibrated one, of any length. A fundamental matrix
    F satisfies `second[k] . F (first[k], 1) = 0`; it is the sum of the matrices that span the null
    space of these equations, each times its weight. w is 1 / focal^2 in units of the length of all
    images.

    Data, for one instance, or with n in front for a batch:

    - `first`: (6, 2)
    - `second`: (6, 3)

    Solutions, of which there are at most 9:

    - `weights`: (3,)
    - `w`: ()

    Results of each solution:

    - `fundamental`: (3, 3)
    - `focal`: ()
    """
    return _solve("relpose_6pt_focal_one_side", first, second, results=results, progress=progress)


def relpose_6pt_focal_points(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of two cameras with one unknown shared focal length from six points: 15 solutions,
    of which those with a real focal length are returned.

    The problem `relpose_6pt_focal` from measurements. `first[k]` and `second[k]` are the images of
    point k, relative to the principal points. The fundamental matrix is the sum of the matrices
    that span the null space of the epipolar equations, each times its weight. w is 1 / focal^2 in
    units of the length of all images.

    A pose X -> rotation X + translation takes the frame of the first camera to that of the second;
    the translation has the length 1. Of the four poses of an essential matrix it is the one with
    the first point in front of both cameras, as in `relpose_5pt_rays`. For a solution that belongs
    to the scene all points are in front.

    Data, for one instance, or with n in front for a batch:

    - `first`: (6, 2)
    - `second`: (6, 2)

    Solutions, of which there are at most 15:

    - `weights`: (3,)
    - `w`: ()

    Results of each solution:

    - `fundamental`: (3, 3)
    - `focal`: ()
    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("relpose_6pt_focal_points", first, second, results=results, progress=progress)


def relpose_6pt_generalized(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose of two generalized cameras from six point correspondences: 64 solutions.

    Stewénius, Nistér, Oskarsson, Åström, "Solutions to minimal generalized relative pose problems",
    OMNIVIS 2005. Published as `gen6p`.

    `first` and `second` hold the rays of the points in either system of cameras: a point of the
    ray, and its direction. The rotation from the first system to the second is that of the
    quaternion q. That the rays of one point meet gives the translation up to the
    depths of that point along either ray; that the rays of any three others meet, too, are linear
    equations for these depths.

    A pose X -> rotation X + translation takes the first system to the second, in the unit of the
    points of the rays.

    Data, for one instance, or with n in front for a batch:

    - `first`: (6, 2, 3)
    - `second`: (6, 2, 3)

    Solutions, of which there are at most 64:

    - `q`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    """
    return _solve("relpose_6pt_generalized", first, second, results=results, progress=progress)


def relpose_6pt_radial(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """The essential matrix and the radial distortion common to two otherwise calibrated cameras from
    six points: 52 solutions.

    Kukelova, Byröd, Josephson, Pajdla, Åström, "Fast and robust numerical solutions to minimal
    problems for cameras with radial distortion", CVIU 114, 2010. Published as `relpose_6p_rad`,
    with e33 = 1, which loses planar motions and those without a rotation: e33 is 0.

    `first[k]` and `second[k]` are the distorted images of point k, relative to the centre of
    distortion and in units of the focal length. An image x lies along (x, 1 + radial |x|^2), the
    division model. Then x1^T E x2 = 0 is, with e23 = 1, linear in e11, e21, e12, e22, radial e31,
    e31 and the monomials e32, radial e32, e13, radial e13, 1, radial, radial^2 e33, radial e33,
    e33: six points give the former as combinations of these. How well depends on which image is the
    first, and on how the second one is turned about its centre: the best of eight choices is taken.
    The first image is turned, too, which turns (e13, e23): for usual motions one of these is 0 if
    it is not.

    Data, for one instance, or with n in front for a batch:

    - `first`: (6, 2)
    - `second`: (6, 2)

    Solutions, of which there are at most 52:

    - `e_13`: ()
    - `e_32`: ()
    - `e_33`: ()
    - `radial`: ()

    Results of each solution:

    - `essential`: (3, 3)
    - `radial`: ()
    """
    return _solve("relpose_6pt_radial", first, second, results=results, progress=progress)


def relpose_7pt_angle_focal_centre(
    fundamental: npt.ArrayLike,
    half_angle: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    r"""Focal length and principal point common to two cameras from their fundamental matrix and the
    angle of rotation between them: 6 solutions.

    Martyushev, "Self-calibration of cameras with Euclidean image plane in case of two views and
    known relative rotation angle", ECCV 2018. Published as `relpose_7p_fuv_angle`.

    `fundamental` comes from seven points or more, in pixels or any other unit; `half_angle` holds
    the cosine and the sine of half the angle. The principal point is (x, y), `z` the square of the
    focal length. With the matrix K of these K^T F K is an essential matrix. F is a multiple of
    `left`\[0\] `right`\[0\]^T + `left`\[1\] `right`\[1\]^T: with the products A of the left vectors
    in the quadratic form K K^T, and B of the right ones, B A is a multiple of the identity. With
    z = 0 all points of a conic are solutions; four combinations of the equations that are divisible
    by z are stated divided.

    Data, for one instance, or with n in front for a batch:

    - `fundamental`: (3, 3)
    - `half_angle`: (2,)

    Solutions, of which there are at most 6:

    - `x`: ()
    - `y`: ()
    - `z`: ()

    Results of each solution:

    - `focal`: ()
    - `centre`: (2,)
    """
    return _solve("relpose_7pt_angle_focal_centre", fundamental, half_angle, results=results, progress=progress)


def relpose_7pt_focal_radial(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose, focal length and radial distortion common to two cameras from seven point
    correspondences: 68 solutions, of which those with a real focal length are returned.

    Jiang, Kuang, Solem, Åström, "A minimal solution to relative pose with unknown focal length and
    radial distortion", ACCV 2014. Published as `relpose_7p_fr`.

    `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
    An image x lies along (x, 1 + radial |x|^2), the division model. Then x1^T F x2 = 0 is, with f33
    = 1, linear in f11, f21, f12, f22, radial f31, radial^2, f31 and the monomials f32, radial f32,
    f13, radial f13, f23, radial f23, radial, 1: seven points give the former as combinations of
    these. How well depends on which image is the first, and on how the second one is turned about
    its centre: the best of eight choices is taken. The first image may be turned, too, which turns
    (f13, f23), and `radial` may have any unit: they are such that in f31 radial f23 has the
    coefficient 0 and radial f13 the coefficient 1. With the focal length, diag(focal, focal, 1) F
    diag(focal, focal, 1) is an essential matrix; `w` is 1 / focal^2.

    Everything is p + radial q, two polynomials without `radial`, modulo the equation that gives
    radial^2, and most equations are stated times `radial`, too. There are points at infinity, near
    which residuals are small; there the factors that are stated not to vanish are small beside
    their terms.

    Data, for one instance, or with n in front for a batch:

    - `first`: (7, 2)
    - `second`: (7, 2)

    Solutions, of which there are at most 68:

    - `w`: ()
    - `f_32`: ()
    - `f_13`: ()
    - `f_23`: ()
    - `radial`: ()

    Results of each solution:

    - `fundamental`: (3, 3)
    - `focal`: ()
    - `radial`: ()
    """
    return _solve("relpose_7pt_focal_radial", first, second, results=results, progress=progress)


def relpose_7pt_focal_radial_one_side(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose, focal length and radial distortion of the first camera, the second calibrated,
    from seven points: 19 solutions, of which those with a real focal length are returned.

    Kuang, Solem, Kahl, Åström, "Minimal solvers for relative pose with a single unknown radial
    distortion", CVPR 2014. Published as `relpose_7p_fr_1s`;
    `relpose_7pt_focal_radial_one_side_eliminated` is a formulation without the focal length.

    `first[k]` is the distorted image of point k in the first camera, relative to the principal
    point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
    first image lies along (x1, 1 + radial |x1|^2), the division model. Then x1^T F x2 = 0 is linear
    in the first two rows of F, radial f33 and the monomials radial f31, radial f32, f31, f32, f33:
    seven points give the former as combinations of these. `third` is the third row of F, which is
    given up to scale. It vanishes where the first camera moves along its optical axis: then the
    points tell nothing of the distortion. With f33 = 1, as published, planar motions and those
    without a rotation are lost. With the focal length, diag(focal, focal, 1) F is an essential
    matrix; `w` is 1 / focal^2.

    Data, for one instance, or with n in front for a batch:

    - `first`: (7, 2)
    - `second`: (7, 2)

    Solutions, of which there are at most 19:

    - `w`: ()
    - `third`: (3,)
    - `radial`: ()

    Results of each solution:

    - `fundamental`: (3, 3)
    - `focal`: ()
    - `radial`: ()
    """
    return _solve("relpose_7pt_focal_radial_one_side", first, second, results=results, progress=progress)


def relpose_7pt_focal_radial_one_side_eliminated(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose and radial distortion of the first camera, whose focal length is unknown, too, and
    eliminated, the second calibrated, from seven points: 19 solutions.

    Kukelova, Kileel, Sturmfels, Pajdla, "A clever elimination strategy for efficient minimal
    solvers", CVPR 2017. Published as `relpose_7p_fr_1s_elr`.

    `first[k]` is the distorted image of point k in the first camera, relative to the principal
    point, `second[k]` that in the calibrated one, in units of its focal length. A point x1 of the
    first image lies along (x1, 1 + radial |x1|^2), the division model. Then x2^T F x1 = 0 is linear
    in radial f33, the first two columns of F and the monomials radial f13, radial f23, f13, f23,
    f33: seven points give the former as combinations of these. `third` is the third column of F,
    which is given up to scale. It vanishes where the first camera moves along its optical axis:
    then the points tell nothing of the distortion. With f33 = 1, as published, planar motions and
    those without a rotation are lost. F diag(focal, focal, 1) is an essential matrix for some focal
    length: with A the first two columns of F, the third is an eigenvector of A A^T, and where mu is
    its eigenvalue, |third column|^2 / focal^2 = trace(A A^T) - 2 mu.

    Data, for one instance, or with n in front for a batch:

    - `first`: (7, 2)
    - `second`: (7, 2)

    Solutions, of which there are at most 19:

    - `third`: (3,)
    - `radial`: ()

    Results of each solution:

    - `fundamental`: (3, 3)
    - `radial`: ()
    """
    return _solve("relpose_7pt_focal_radial_one_side_eliminated", first, second, results=results, progress=progress)


def relpose_7pt_generalized_scale(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Relative pose and relative scale of two generalized cameras from seven point correspondences:
    140 solutions.

    Kneip, Sweeney, Hartley, "The generalized relative pose and scale problem: View-graph fusion via
    2D-2D registration", WACV 2016. Published as `gen_relpose_scale`.

    `first` and `second` hold the rays of the points in either system of cameras: a point of the
    ray, and its direction. The rotation from the first system to the second is that of the
    quaternion q, and points of the second system are multiplied by its scale.
    That the rays of one point meet gives the translation up to the depths of that point along
    either ray and the scale; that the rays of any four others meet, too, are linear equations for
    these three. What is stated depends on these five points, not on which is the first.

    For a point of the rays, rotation p1 + translation = scale p2, with p1 in the first system and
    p2 in the second.

    Data, for one instance, or with n in front for a batch:

    - `first`: (7, 2, 3)
    - `second`: (7, 2, 3)

    Solutions, of which there are at most 140:

    - `q`: (4,)

    Results of each solution:

    - `rotation`: (3, 3)
    - `translation`: (3,)
    - `scale`: ()
    """
    return _solve("relpose_7pt_generalized_scale", first, second, results=results, progress=progress)


def stitching_3pt_radial_focal(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Rotation between two photographs with common unknown focal length and radial distortion, a
    panorama, from three points: 18 solutions, of which those with a real focal length are returned.

    Naroditsky, Daniilidis, "Optimizing polynomial solvers for minimal geometry problems", ICCV
    2011, after Byröd, Brown, Åström, "Minimal solutions for panoramic stitching with radial
    distortion", BMVC 2009. Published as `stitching`.

    `first[k]` and `second[k]` are the distorted images of point k, relative to the principal point.
    A point p lies along (p, focal (1 + radial |p|^2)), the division model. Two points with the
    inner product xy of their rays, in the first image, and x'y' in the second, satisfy xy^2 x'x'
    y'y' = x'y'^2 xx yy. With w = 1/focal^2 both sides divided by focal^8 are polynomials in w whose
    difference has no term without w; it is divided by w.

    Data, for one instance, or with n in front for a batch:

    - `first`: (3, 2)
    - `second`: (3, 2)

    Solutions, of which there are at most 18:

    - `radial`: ()
    - `w`: ()

    Results of each solution:

    - `focal`: ()
    - `radial`: ()
    """
    return _solve("stitching_3pt_radial_focal", first, second, results=results, progress=progress)


def tensor_eigenvectors(a: npt.ArrayLike, *, progress: Progress = None) -> Solutions:
    """Eigenvectors of a 3 x 3 x 3 tensor, scaled to eigenvalue 1: x_i = sum over j and k of a_ijk x_j
    x_k, 8 solutions with x = 0.

    Cartwright and Sturmfels, "The number of eigenvalues of a tensor", Linear Algebra and its
    Applications 2013: 7 of them for general data. The method of moments reads the parts of a
    mixture from them (Anandkumar, Ge, Hsu, Kakade, Telgarsky, "Tensor decompositions for learning
    latent variable models", JMLR 2014, section 4).

    Data, for one instance, or with n in front for a batch:

    - `a`: (3, 3, 3)

    Solutions, of which there are at most 8:

    - `x`: ()
    - `y`: ()
    - `z`: ()
    """
    return _solve("tensor_eigenvectors", a, progress=progress)


def three_quadrics(quadrics: npt.ArrayLike, *, progress: Progress = None) -> Solutions:
    """The intersection of three general quadrics: 8 solutions by Bézout's theorem.

    Kukelova, Heller, Fitzgibbon, "Efficient intersection of three quadrics and applications in
    computer vision", CVPR 2016.

    `quadrics` holds the coefficients of x^2, x y, x z, y^2, y z, z^2, x, y, z, 1, a quadric in each
    row.

    Data, for one instance, or with n in front for a batch:

    - `quadrics`: (3, 10)

    Solutions, of which there are at most 8:

    - `x`: ()
    - `y`: ()
    - `z`: ()
    """
    return _solve("three_quadrics", quadrics, progress=progress)


def triangulation_3view(
    cameras: npt.ArrayLike,
    images: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Triangulation from three views, all stationary points of the sum of squared reprojection errors:
    47 solutions.

    Stewénius, Schaffalitzky, Nistér, "How hard is 3-view triangulation really?", ICCV 2005.
    Published as `3v_triang_laurent`.

    `cameras` are the projection matrices of the views and `images` where they see the point. The
    unknowns are projective coordinates (x, y, z, 1) of the point: x and y its depths in the first
    and second view over that in the third, each times a constant, and z its first error in the
    third view. Every image is turned so that its second error does not depend on z, and scales are
    such that in the errors of the first two views over their depths, x and y, z has the
    coefficient 1. The planes of depth zero must meet in one point: the three images must not all be
    parallel, as rectified ones are.

    Stated are derivatives towards seven points. Where the depth of a view vanishes, so does a power
    of it in the denominators; where the errors of a view vanish, too, at its centre, they do not
    change at all.

    Data, for one instance, or with n in front for a batch:

    - `cameras`: (3, 3, 4)
    - `images`: (3, 2)

    Solutions, of which there are at most 47:

    - `x`: ()
    - `y`: ()
    - `z`: ()

    Results of each solution:

    - `position`: (3,)
    """
    return _solve("triangulation_3view", cameras, images, results=results, progress=progress)


def triangulation_3view_relaxed(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    image: npt.ArrayLike,
    *,
    results: Optional[Iterable[str]] = None,
    progress: Progress = None,
) -> Solutions:
    """Triangulation from three views with two of the three epipolar constraints, all stationary points
    of the least-squares cost: 27 solutions.

    Kukelova, Pajdla, Bujnak, "Fast and stable algebraic solution to L2 three-view triangulation",
    3DV 2013. Published as `l2_3view_triang`, for matrices of full rank, which give 31 solutions.
    Fundamental and essential matrices have rank 2, and with them four of the 31 are at infinity.

    `image` holds the measured image points, one a row. The corrected ones (x1, x2), (x3, x4) and
    (x5, x6) are the closest to these that satisfy p1^T `first` p2 = 0 and p2^T `second` p3 = 0,
    with the multipliers x7 and x8. The cost is the sum of the squared distances.

    Data, for one instance, or with n in front for a batch:

    - `first`: (3, 3)
    - `second`: (3, 3)
    - `image`: (3, 2)

    Solutions, of which there are at most 27:

    - `x1`: ()
    - `x2`: ()
    - `x3`: ()
    - `x4`: ()
    - `x5`: ()
    - `x6`: ()
    - `x7`: ()
    - `x8`: ()

    Results of each solution:

    - `images`: (3, 2)
    - `cost`: ()
    """
    return _solve("triangulation_3view_relaxed", first, second, image, results=results, progress=progress)


def trilateration(
    centres: npt.ArrayLike,
    distances: npt.ArrayLike,
    *,
    progress: Progress = None,
) -> Solutions:
    """A point at given distances from three known points: 2 solutions, mirror images in the plane of
    the three.

    Thomas & Ros, "Revisiting trilateration for robot localization", IEEE Transactions on Robotics
    21(1), 2005.

    `centres` holds the known points, one a row; `distances` the distances from them, in the same
    unit.

    Data, for one instance, or with n in front for a batch:

    - `centres`: (3, 3)
    - `distances`: (3,)

    Solutions, of which there are at most 2:

    - `x`: ()
    - `y`: ()
    - `z`: ()
    """
    return _solve("trilateration", centres, distances, progress=progress)


def two_conics(p: npt.ArrayLike, q: npt.ArrayLike, *, progress: Progress = None) -> Solutions:
    """The intersection of two general conics: 4 solutions by Bézout's theorem.

    Kukelova, Bujnak, Pajdla, "Automatic Generator of Minimal Problem Solvers", ECCV 2008, use two
    such quadrics as their running example.

    `p` and `q` hold the coefficients of x^2, x y, y^2, x, y, 1.

    Data, for one instance, or with n in front for a batch:

    - `p`: (6,)
    - `q`: (6,)

    Solutions, of which there are at most 4:

    - `x`: ()
    - `y`: ()
    """
    return _solve("two_conics", p, q, progress=progress)
