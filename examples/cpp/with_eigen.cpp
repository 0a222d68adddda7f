// Data as Eigen vectors, and a pose as Eigen matrices, without copies.
#include <eliminant.hpp>

#include <cstdio>

#ifndef ELIMINANT_HAS_EIGEN
int main() { std::printf("without Eigen\n"); }
#else
#include <Eigen/Geometry>

namespace p3p = eliminant::pose_3pt;

int main() {
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()))
            .toRotationMatrix();
    const Eigen::Vector3d translation(0.1, -0.2, 5.0);
    const std::array<Eigen::Vector3d, 3> points = {Eigen::Vector3d(1.0, 0.2, -0.3), Eigen::Vector3d(-0.7, 1.1, 0.4),
                                                   Eigen::Vector3d(0.3, -0.9, 0.8)};
    // Stored by columns, so that a copy by rows is the argument.
    Eigen::Matrix3d rays_in_columns;
    for (int k = 0; k < 3; ++k) rays_in_columns.col(k) = rotation * points[std::size_t(k)] + translation;

    double error = 1.0;
    for (const p3p::Pose &pose : p3p::solve_for_pose(eliminant::by_rows(rays_in_columns.transpose()), points)) {
        const auto found = eliminant::map(pose.rotation);
        const double distance =
            (found - rotation).norm() + (eliminant::map(pose.translation) - translation).norm();
        error = std::min(error, distance);
    }
    std::printf("pose from three points: error %.1e\n", error);
    return error < 1e-9 ? 0 : 1;
}
#endif
