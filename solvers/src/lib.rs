//! Emitted solvers of all problems in `templates/`, and the cylinder triangulation system that stands on them.

pub mod cylinder;

eliminant::include_solver!("circle_least_squares");
eliminant::include_solver!("circle_least_squares_dual");
eliminant::include_solver!("circle_minimal");
eliminant::include_solver!("fundamental_8pt_radial");
eliminant::include_solver!("fundamental_8pt_radial_one_side");
eliminant::include_solver!("fundamental_9pt_two_radials");
eliminant::include_solver!("katsura_5");
eliminant::include_solver!("platform_forward_kinematics");
eliminant::include_solver!("pose_35pt_focal");
eliminant::include_solver!("pose_4pt_focal_radial");
eliminant::include_solver!("pose_4pt_focal_radial_cut");
eliminant::include_solver!("pose_4pt_generalized_scale");
eliminant::include_solver!("pose_4pt_upright_error_bound");
eliminant::include_solver!("pose_5pt_refraction");
eliminant::include_solver!("pose_5tdoa_two_receivers");
eliminant::include_solver!("pose_6pt_rolling_shutter");
eliminant::include_solver!("pose_npt_direct_least_squares");
eliminant::include_solver!("pose_npt_least_squares_cayley");
eliminant::include_solver!("pose_npt_least_squares_quaternion");
eliminant::include_solver!("pose_npt_weak_perspective");
eliminant::include_solver!("relpose_3pt_angle_zero_screw");
eliminant::include_solver!("relpose_4pt_angle");
eliminant::include_solver!("relpose_5pt");
eliminant::include_solver!("relpose_5pt_generalized_angle");
eliminant::include_solver!("relpose_6pt_focal");
eliminant::include_solver!("relpose_6pt_focal_one_side");
eliminant::include_solver!("relpose_6pt_generalized");
eliminant::include_solver!("relpose_7pt_focal_radial_one_side");
eliminant::include_solver!("relpose_7pt_focal_radial_one_side_eliminated");
eliminant::include_solver!("stitching_3pt_radial_focal");
eliminant::include_solver!("triangulation_3view_relaxed");
eliminant::include_solver!("trilateration");
eliminant::include_solver!("two_conics");
